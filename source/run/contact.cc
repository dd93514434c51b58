// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/collective.h>
#include <whipple/mesh/disjoint_sets.h>
#include <whipple/mesh/gather.h>
#include <whipple/run/contact.h>
#include <whipple/run/contact_search.h>
#include <whipple/state/momentum_restore.h>
#include <whipple/state/velocity_gather.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace whipple
{
  namespace
  {
    using contact::Pair;
    using contact::Piece;

    Piece
    piece_of(const FlatMesh<2> &mesh, const State<2> &state, const Boundaries<2> &boundaries, Index c)
    {
      Piece piece;
      piece.key = mesh.key[c];
      for (int k = 0; k < 4; ++k)
        {
          const Index n = mesh.cell_node[4 * c + k];
          for (int d = 0; d < 2; ++d)
            {
              piece.x[d][k] = state.position[d][n];
              piece.middle[d] += 0.25 * state.position[d][n];
              const int side = ruling_side<2>(boundaries, mesh.node_side[n], d);
              if (side != none && boundaries[side].kind == BoundaryKind::reflecting)
                piece.held |= std::uint64_t{1} << d;
            }
        }
      piece.size = std::sqrt(std::abs(CellShape<2>::area(piece.x)));
      for (const MaterialState &m : state.material)
        {
          piece.mass += m.mass[c];
          piece.solid += m.volume[c] * (m.has_voids() ? 1. - m.void_fraction[c] : 1.) / state.volume[c];
        }
      return piece;
    }

    /// Velocity of the centre of mass, and the kinetic energy about it.
    void
    set_motion(const FlatMesh<2> &mesh, const State<2> &state, Index c, Piece &piece)
    {
      std::array<Vector<2>, 4> u;
      std::array<double, 4>    mass;
      for (int k = 0; k < 4; ++k)
        {
          mass[k] = state.corner_weight[4 * c + k] * piece.mass;
          for (int d = 0; d < 2; ++d)
            u[k][d] = state.velocity[d][mesh.cell_node[4 * c + k]];
        }
      piece.velocity = mean_velocity<2>(mass, u);
      piece.relative = relative_kinetic_energy<2>(mass, u, piece.velocity);
    }

    /// The owned elements that hold mass.
    std::vector<Piece>
    pieces_of(const FlatMesh<2> &mesh, const State<2> &state, const Boundaries<2> &boundaries)
    {
      std::vector<double> unshown; // kinetic energy of corners that hang
      if (!mesh.hanging.empty())
        unshown = corner_velocities(mesh, state).kinetic_remainder;
      std::vector<Piece> pieces;
      pieces.reserve(mesh.n_owned);
      for (Index c = 0; c < mesh.n_owned; ++c)
        if (cell_mass<2>(state, c) > 0)
          {
            pieces.push_back(piece_of(mesh, state, boundaries, c));
            set_motion(mesh, state, c, pieces.back());
            if (!unshown.empty())
              pieces.back().relative += unshown[c];
          }
      return pieces;
    }

    /// Elements connected by contacts.
    class Clusters
    {
    public:
      /// @param pairs of all ranks, in any order
      explicit Clusters(std::vector<Pair> pairs)
      {
        std::sort(pairs.begin(), pairs.end(), [](const Pair &p, const Pair &q) {
          return std::pair(p.a.key, p.b.key) < std::pair(q.a.key, q.b.key);
        });
        for (const Pair &pair : pairs)
          for (const Piece *piece : {&pair.a, &pair.b})
            pieces_.push_back(*piece);
        std::sort(pieces_.begin(), pieces_.end(), [](const Piece &p, const Piece &q) { return p.key < q.key; });
        const auto end = std::unique(pieces_.begin(), pieces_.end(), [](auto &p, auto &q) { return p.key == q.key; });
        pieces_.erase(end, pieces_.end());
        for (std::size_t i = 0; i < pieces_.size(); ++i)
          number_[pieces_[i].key] = i;
        cluster_ = DisjointSets(pieces_.size());
        for (const Pair &pair : pairs)
          cluster_.unite(number_[pair.a.key], number_[pair.b.key]);
        meets_.assign(pieces_.size(), false);
        for (const Pair &pair : pairs)
          if (pair.approaching)
            meets_[cluster_.root(number_[pair.a.key])] = true;
        add_up();
      }

      /// What happens to one element, null if it is in no cluster whose elements approach.
      struct Motion
      {
        Vector<2> velocity{};
        double    heat = 0; ///< kinetic energy lost, Mbar cm^3
      };
      const Motion *
      of(CellKey key, double mass, Motion &result) const
      {
        const auto found = number_.find(key);
        if (found == number_.end() || !meets_[cluster_.root(found->second)])
          return nullptr;
        const Sum &sum  = sum_[cluster_.root(found->second)];
        result.velocity = sum.velocity;
        result.heat     = mass / sum.mass * sum.lost;
        return &result;
      }

      long
      count() const
      {
        long n = 0;
        for (std::size_t i = 0; i < pieces_.size(); ++i)
          n += cluster_.is_root(i) && meets_[i];
        return n;
      }

      long
      joined() const
      {
        long n = 0;
        for (std::size_t i = 0; i < pieces_.size(); ++i)
          n += meets_[cluster_.root(i)];
        return n;
      }

      /// What walls and the axis took.
      Vector<2>
      impulse() const
      {
        Vector<2> sum{};
        for (std::size_t i = 0; i < pieces_.size(); ++i)
          if (cluster_.is_root(i) && meets_[i])
            for (int d = 0; d < 2; ++d)
              sum[d] += sum_[i].impulse[d];
        return sum;
      }

    private:
      struct Sum
      {
        double        mass = 0;
        Vector<2>     velocity{}, impulse{};
        double        lost = 0;
        std::uint64_t held = 0;
      };

      /// Sums in the order of keys; differences to the first velocity, so that equal ones keep their bits.
      void
      add_up()
      {
        sum_.resize(pieces_.size());
        for (std::size_t i = 0; i < pieces_.size(); ++i)
          {
            Sum &sum = sum_[cluster_.root(i)];
            sum.mass += pieces_[i].mass;
            sum.held |= pieces_[i].held;
          }
        for (std::size_t i = 0; i < pieces_.size(); ++i)
          {
            Sum         &sum   = sum_[cluster_.root(i)];
            const Piece &first = pieces_[cluster_.root(i)];
            for (int d = 0; d < 2; ++d)
              sum.velocity[d] += pieces_[i].mass / sum.mass * (pieces_[i].velocity[d] - first.velocity[d]);
          }
        for (std::size_t i = 0; i < pieces_.size(); ++i)
          if (cluster_.is_root(i))
            for (int d = 0; d < 2; ++d)
              {
                sum_[i].velocity[d] += pieces_[i].velocity[d];
                if (sum_[i].held >> d & 1)
                  {
                    sum_[i].impulse[d]  = sum_[i].mass * sum_[i].velocity[d];
                    sum_[i].velocity[d] = 0;
                  }
              }
        for (std::size_t i = 0; i < pieces_.size(); ++i)
          {
            Sum &sum = sum_[cluster_.root(i)];
            sum.lost += pieces_[i].relative;
            for (int d = 0; d < 2; ++d)
              {
                const double slip = pieces_[i].velocity[d] - sum.velocity[d];
                sum.lost += 0.5 * pieces_[i].mass * slip * slip;
              }
          }
      }

      std::vector<Piece>                       pieces_;     ///< ordered by key
      std::unordered_map<CellKey, std::size_t> number_;     ///< of a piece by its key
      DisjointSets                             cluster_{0}; ///< of pieces; its root is the first of them
      std::vector<bool>                        meets_;      ///< of the first of a cluster: some of its pieces approach
      std::vector<Sum>                         sum_;        ///< of the first of a cluster
    };

    /// Let the elements of clusters move as one.
    Booking<2>
    apply(const Clusters &clusters, const Boundaries<2> &boundaries, KineticLoss loss, Domain<2> &domain)
    {
      const FlatMesh<2>  &mesh    = domain.view->mesh;
      State<2>           &state   = domain.state;
      CornerVelocities<2> corners = corner_velocities(mesh, state);
      for (Index c = 0; c < mesh.n_owned; ++c)
        {
          Clusters::Motion motion;
          if (!clusters.of(mesh.key[c], cell_mass<2>(state, c), motion))
            continue;
          for (int k = 0; k < 4; ++k)
            for (int d = 0; d < 2; ++d)
              corners.velocity[d][4 * c + k] = motion.velocity[d];
          corners.kinetic_remainder[c] = motion.heat;
        }
      exchange_corners(domain.view->halo, corners);
      Booking<2> booking =
          sum_over_ranks(gather_velocities(mesh, boundaries, corners, loss, state), domain.communicator());
      for (int d = 0; d < 2; ++d)
        booking.left->momentum[d] += clusters.impulse()[d];
      domain.view->halo.exchange({}, std::vector<std::vector<double> *>{&state.velocity[0], &state.velocity[1]});
      std::vector<std::vector<double> *> energies;
      for (MaterialState &m : state.material)
        energies.push_back(&m.energy);
      domain.view->halo.exchange(energies, {});
      return booking;
    }
  } // namespace

  template <int dim>
  ContactLook<dim>
  join_contacts(const Boundaries<dim> &boundaries, KineticLoss loss, Domain<dim> &domain)
  {
    const MPI_Comm           communicator = domain.communicator();
    const std::vector<Piece> pieces       = pieces_of(domain.view->mesh, domain.state, boundaries);
    const contact::Found     found        = contact::search(communicator, pieces);
    std::array<long, 3> counts{static_cast<long>(pieces.size()), found.deep, static_cast<long>(found.pairs.size())};
    MPI_Allreduce(MPI_IN_PLACE, counts.data(), 3, MPI_LONG, MPI_SUM, communicator);
    ContactLook<dim> look;
    look.elements     = counts[0];
    look.deep         = counts[1];
    look.time_to_next = -max_over_ranks(-found.time_to_next, communicator);
    if (counts[2] == 0)
      return look;

    const Clusters clusters(gather_all<Pair>(communicator, found.pairs).entry);
    look.joined   = clusters.joined();
    look.clusters = clusters.count();
    if (look.joined > 0)
      {
        const Booking<dim> joining = apply(clusters, boundaries, loss, domain);
        look.bookings.enter("contact", joining);
        look.bookings.note("overlapping elements that approach each other joined", static_cast<double>(look.joined),
                           *joining.converted, "Mbar cm^3");
      }
    return look;
  }

  template ContactLook<2>
  join_contacts(const Boundaries<2> &, KineticLoss, Domain<2> &);
} // namespace whipple
