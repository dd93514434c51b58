// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/free_flight.h>
#include <whipple/run/arrivals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace whipple
{
  namespace
  {
    /// Finest cells that the fastest flies between two looks, and how far ahead of a look is seen, in such times.
    constexpr double cells_between_looks = 16, looks_ahead = 1.5;
    /// Finest cells around material on the mesh within which it is met.
    constexpr double reach = 4;
    /// Solid fraction of a cell below which there is nothing to meet.
    constexpr double least_solid = 1e-3;
    /// Part of the larger speed with which two must come nearer to each other to meet.
    constexpr double least_approach = 0.05;

    double
    speed(const Vector<2> &u)
    {
      return std::sqrt(u[0] * u[0] + u[1] * u[1]);
    }

    /// A box whose sides move.
    struct Box
    {
      Vector<2> lower{}, upper{};     ///< cm, at the look
      Vector<2> slowest{}, fastest{}; ///< cm/us, of its lower and of its upper sides
      Vector<2> velocity{};           ///< cm/us, its mean

      double
      middle(int d) const
      {
        return 0.5 * (lower[d] + upper[d]);
      }
      double
      size() const
      {
        return std::min(upper[0] - lower[0], upper[1] - lower[1]);
      }
      /// What it sweeps over in a time, widened by a margin.
      Box
      swept(double time, double margin) const
      {
        Box hull = *this;
        for (int d = 0; d < 2; ++d)
          {
            hull.lower[d] += std::min(0., slowest[d] * time) - margin;
            hull.upper[d] += std::max(0., fastest[d] * time) + margin;
          }
        return hull;
      }
    };

    /// Bounds of corners that move straight: they stay within bounds that do.
    Box
    box_of(const CornerVectors<2> &now, const CornerVectors<2> &later, const CornerVectors<2> &velocity, double time)
    {
      Box box;
      for (int d = 0; d < 2; ++d)
        {
          const auto [low, high]   = std::minmax_element(now[d].begin(), now[d].end());
          const auto [low1, high1] = std::minmax_element(later[d].begin(), later[d].end());
          box.lower[d]             = *low;
          box.upper[d]             = *high;
          box.slowest[d]           = (*low1 - *low) / time;
          box.fastest[d]           = (*high1 - *high) / time;
        }
      box.velocity = CellShape<2>::middle(velocity);
      return box;
    }

    /// Whether a and b come within `margin` of each other within a time.
    bool
    touch(const Box &a, const Box &b, double margin, double time)
    {
      double first = 0, last = time;
      // gap + t rate <= 0 for the two pairs of sides of each axis
      const auto closed = [&](double gap, double rate) {
        if (rate > 0)
          last = std::min(last, -gap / rate);
        else if (rate < 0)
          first = std::max(first, -gap / rate);
        else if (gap > 0)
          last = -1;
      };
      for (int d = 0; d < 2; ++d)
        {
          closed(a.lower[d] - b.upper[d] - margin, a.slowest[d] - b.fastest[d]);
          closed(b.lower[d] - a.upper[d] - margin, b.slowest[d] - a.fastest[d]);
        }
      return first <= last;
    }

    bool
    approach(const Box &a, const Box &b)
    {
      const Vector<2> du{{b.velocity[0] - a.velocity[0], b.velocity[1] - a.velocity[1]}};
      const double    threshold = least_approach * std::max(speed(a.velocity), speed(b.velocity));
      if (speed(du) <= threshold)
        return false;
      const Vector<2> dx{{b.middle(0) - a.middle(0), b.middle(1) - a.middle(1)}};
      const double    distance = speed(dx);
      return distance < 0.5 * std::min(a.size(), b.size()) || -(dx[0] * du[0] + dx[1] * du[1]) > threshold * distance;
    }

    /// Boxes by the square bins that they sweep over.
    class Bins
    {
    public:
      Bins(const std::vector<Box> &swept, double least_edge)
        : swept_(swept)
      {
        double    sum   = 0;
        Vector<2> upper = swept[0].upper;
        origin_         = swept[0].lower;
        for (const Box &box : swept)
          for (int d = 0; d < 2; ++d)
            {
              origin_[d] = std::min(origin_[d], box.lower[d]);
              upper[d]   = std::max(upper[d], box.upper[d]);
              sum += box.upper[d] - box.lower[d];
            }
        constexpr double most = 1024; // bins along an axis
        edge_                 = std::max(least_edge, sum / (2. * static_cast<double>(swept.size())));
        for (int d = 0; d < 2; ++d)
          edge_ = std::max(edge_, (upper[d] - origin_[d]) / most);
        for (int d = 0; d < 2; ++d)
          number_[d] = 1 + static_cast<int>((upper[d] - origin_[d]) / edge_);
        bins_.resize(static_cast<std::size_t>(number_[0]) * number_[1]);
        for (std::size_t i = 0; i < swept.size(); ++i)
          for_each_bin(swept[i], [&](std::vector<Index> &bin) { bin.push_back(static_cast<Index>(i)); });
      }

      /// Call visit(i) for every box that sweeps over a point that `box` does, or is near to it; more than once, maybe.
      template <typename Visit>
      void
      for_each_near(const Box &box, Visit visit)
      {
        for_each_bin(box, [&](const std::vector<Index> &bin) {
          for (const Index i : bin)
            if (swept_[i].lower[0] <= box.upper[0] && swept_[i].upper[0] >= box.lower[0] &&
                swept_[i].lower[1] <= box.upper[1] && swept_[i].upper[1] >= box.lower[1])
              visit(i);
        });
      }

    private:
      template <typename Visit>
      void
      for_each_bin(const Box &box, Visit visit)
      {
        std::array<int, 2> first, last;
        for (int d = 0; d < 2; ++d)
          {
            const double low = (box.lower[d] - origin_[d]) / edge_, high = (box.upper[d] - origin_[d]) / edge_;
            if (high < 0 || low >= number_[d])
              return;
            first[d] = static_cast<int>(std::max(low, 0.));
            last[d]  = static_cast<int>(std::min(high, number_[d] - 1.));
          }
        for (int j = first[1]; j <= last[1]; ++j)
          for (int i = first[0]; i <= last[0]; ++i)
            visit(bins_[static_cast<std::size_t>(j) * number_[0] + i]);
      }

      const std::vector<Box>         &swept_;
      Vector<2>                       origin_{};
      double                          edge_ = 0;
      std::array<int, 2>              number_{};
      std::vector<std::vector<Index>> bins_;
    };

    /// One look at all that waits.
    class Look
    {
    public:
      /// @param ahead us, how far it looks ahead of each part
      Look(const Scene<2> &scene, const CellPacketLayout<2> &layout, const WaitingDebris<2> &waiting, double time,
           std::vector<double> ahead)
        : scene_(scene)
        , layout_(layout)
        , waiting_(waiting)
        , time_(time)
        , ahead_(std::move(ahead))
        , farthest_(*std::max_element(ahead_.begin(), ahead_.end()))
        , arrives_(waiting.parts.size(), 0)
      {
        for (std::size_t i = 0; i < ahead_.size(); ++i)
          {
            const Waiting<2> &part = waiting.parts[i];
            const auto [x, u]      = motion_at(scene.lattice.symmetry, layout, part, time);
            box_.push_back(box_of(x, corners_at(scene.lattice.symmetry, layout, part, time + ahead_[i]), u, ahead_[i]));
            swept_.push_back(box_.back().swept(ahead_[i], 0.));
          }
      }

      /// Those that do not fly freely on, or have left the domain.
      void
      by_themselves(const RigidWalls<2> &walls)
      {
        const Vector<2> upper = scene_.upper_corner();
        for (std::size_t i = 0; i < arrives_.size(); ++i)
          {
            bool        ends = false;
            const Box  &box = box_[i], later = swept_[i];
            const auto &lower = scene_.lattice.origin;
            for (int d = 0; d < 2; ++d)
              ends = ends || box.lower[d] >= upper[d] || box.upper[d] <= lower[d];
            // what flies along a wall, its side on it, is free
            for (int side = 0; side < 4; ++side)
              {
                const int    d = side / 2;
                const double outside =
                    side % 2 ? later.upper[d] - walls.position[side] : walls.position[side] - later.lower[d];
                ends = ends || (walls.there[side] && outside > round_off * scene_.lattice.spacing);
              }
            if (scene_.lattice.symmetry == Symmetry::axisymmetric)
              ends = ends || later.lower[0] < -round_off * scene_.lattice.spacing;
            arrives_[i] = ends || !flies_on(waiting_.parts[i], ahead_[i]);
          }
      }

      /// Those that come within `margin` of what this rank's cells hold.
      void
      with_cells(const FlatMesh<2> &mesh, const State<2> &state, double margin)
      {
        Bins bins(swept_, margin);
        for (Index c = 0; c < mesh.n_owned; ++c)
          {
            double solid = 0;
            for (const MaterialState &m : state.material)
              solid += m.volume[c] * (m.has_voids() ? 1. - m.void_fraction[c] : 1.);
            if (solid < least_solid * state.volume[c])
              continue;
            Box cell;
            for (int d = 0; d < 2; ++d)
              {
                cell.lower[d] = mesh.lower[d][c];
                cell.upper[d] = mesh.lower[d][c] + mesh.size[c];
                for (int k = 0; k < 4; ++k)
                  cell.velocity[d] += state.corner_weight[4 * c + k] * state.velocity[d][mesh.cell_node[4 * c + k]];
              }
            cell.slowest = cell.fastest = cell.velocity;
            bins.for_each_near(cell.swept(farthest_, margin), [&](Index i) {
              if (!arrives_[i] && approach(box_[i], cell) && touch(box_[i], cell, margin, ahead_[i]))
                arrives_[i] = 1;
            });
          }
      }

      /// Those that meet each other: every so-many-th of them.
      void
      among_themselves(int rank, int ranks)
      {
        Bins bins(swept_, reach * scene_.lattice.spacing);
        for (std::size_t i = rank; i < box_.size(); i += ranks)
          bins.for_each_near(swept_[i], [&](Index j) {
            if (j > static_cast<Index>(i) && !(arrives_[i] && arrives_[j]) && !one_piece(i, j) &&
                approach(box_[i], box_[j]) && touch(box_[i], box_[j], 0., std::min(ahead_[i], ahead_[j])))
              arrives_[i] = arrives_[j] = 1;
          });
      }

      /// Pieces land whole. @returns what arrives, of all ranks
      std::vector<std::uint8_t>
      found(MPI_Comm communicator)
      {
        MPI_Allreduce(MPI_IN_PLACE, arrives_.data(), static_cast<int>(arrives_.size()), MPI_BYTE, MPI_BOR,
                      communicator);
        std::set<long> pieces;
        for (std::size_t i = 0; i < arrives_.size(); ++i)
          if (arrives_[i] && piece(i) >= 0)
            pieces.insert(piece(i));
        for (std::size_t i = 0; i < arrives_.size(); ++i)
          arrives_[i] = arrives_[i] || (piece(i) >= 0 && pieces.contains(piece(i)));
        return std::move(arrives_);
      }

    private:
      static constexpr double round_off = 1e-6;

      long
      piece(std::size_t i) const
      {
        return waiting_.parts[i].element.piece;
      }
      bool
      one_piece(std::size_t i, std::size_t j) const
      {
        return piece(i) >= 0 && piece(i) == piece(j);
      }

      /// Whether an element for itself neither folds nor closes its voids.
      bool
      flies_on(const Waiting<2> &part, double ahead) const
      {
        if (part.element.piece >= 0)
          return true;
        const auto [x, u]  = motion_at(scene_.lattice.symmetry, layout_, part, time_);
        const double least = least_volume(scene_.lattice.symmetry, x, u, ahead);
        if (!(least > 0) || !keeps_shape(x, u, ahead))
          return false;
        const double growth = least / cell_volume<2>(scene_.lattice.symmetry, part.element.position);
        for (int m = 0; m < layout_.n_materials(); ++m)
          if (part.element.packet[layout_.volume(m)] > 0 &&
              !(1. - (1. - part.element.packet[layout_.void_fraction(m)]) / growth > free_void_fraction))
            return false;
        return true;
      }

      const Scene<2>            &scene_;
      const CellPacketLayout<2> &layout_;
      const WaitingDebris<2>    &waiting_;
      double                     time_;     ///< us
      std::vector<double>        ahead_;    ///< us, of each part
      double                     farthest_; ///< us, the longest
      std::vector<Box>           box_, swept_;
      std::vector<std::uint8_t>  arrives_;
    };
  } // namespace

  double
  time_between_looks(const Scene<2> &scene, const WaitingDebris<2> &waiting)
  {
    // what is slower than 10 m/s is looked at as often as that would be
    constexpr double least_speed = 1e-3;
    return cells_between_looks * scene.lattice.spacing / std::max(waiting.fastest, least_speed);
  }

  std::vector<std::uint8_t>
  find_arrivals(const Scene<2> &scene, const CellPacketLayout<2> &layout, const WaitingDebris<2> &waiting,
                const RigidWalls<2> &walls, const FlatMesh<2> &mesh, const State<2> &state, MPI_Comm communicator)
  {
    if (waiting.parts.empty())
      return {};
    int rank = 0, ranks = 1;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &ranks);
    Look look(scene, layout, waiting, state.time,
              std::vector<double>(waiting.parts.size(), looks_ahead * time_between_looks(scene, waiting)));
    look.by_themselves(walls);
    look.with_cells(mesh, state, reach * scene.lattice.spacing);
    look.among_themselves(rank, ranks);
    return look.found(communicator);
  }

  std::vector<std::uint8_t>
  find_passing(const Scene<2> &scene, const CellPacketLayout<2> &layout, const WaitingDebris<2> &waiting,
               const FlatMesh<2> &mesh, const State<2> &state, double plane, MPI_Comm communicator)
  {
    if (waiting.parts.empty())
      return {};
    const double              cell = scene.lattice.spacing;
    std::vector<double>       time; // until it is through
    std::vector<std::uint8_t> moves;
    for (const Waiting<2> &part : waiting.parts)
      {
        const auto [x, u]    = motion_at(scene.lattice.symmetry, layout, part, state.time);
        const double rear    = *std::min_element(x[flight_axis<2>].begin(), x[flight_axis<2>].end());
        const double slowest = *std::min_element(u[flight_axis<2>].begin(), u[flight_axis<2>].end());
        moves.push_back(slowest > 0);
        time.push_back(slowest > 0 ? std::max(plane + cell - rear, cell) / slowest : cell / waiting.fastest);
      }
    Look look(scene, layout, waiting, state.time, std::move(time));
    look.with_cells(mesh, state, cell);
    std::vector<std::uint8_t> passes = look.found(communicator);
    for (std::size_t i = 0; i < passes.size(); ++i)
      passes[i] = moves[i] && !passes[i];
    return passes;
  }

  double
  momentum_that_comes(const Scene<2> &scene, const CellPacketLayout<2> &layout, const WaitingDebris<2> &waiting,
                      double time, double face, double velocity)
  {
    const double outer = scene.upper_corner()[0], inner = scene.lattice.origin[0];
    double       sum = 0;
    for (const Waiting<2> &part : waiting.parts)
      {
        const ConservedTotals<2> totals = totals_of<2>(layout, part.element);
        const double             w = totals.momentum[1] / totals.mass, u = totals.momentum[0] / totals.mass;
        if (!(w > std::max(velocity, 0.)))
          continue;
        const auto [r, z] = CellShape<2>::middle(corners_at(scene.lattice.symmetry, layout, part, time));
        const double then = r + u * (face - z) / w;
        if (z < face && then > inner && then < outer)
          sum += totals.momentum[flight_axis<2>];
      }
    return sum;
  }
} // namespace whipple
