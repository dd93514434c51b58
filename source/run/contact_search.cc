// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/run/contact_search.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace whipple::contact
{
  namespace
  {
    /// Points of a piece that are looked at: its middle, and these parts of the way to corners and middles of sides.
    constexpr double reach = 0.8;
    /// Solid around a piece's middle, as a part of what fits, that shows that it lies deep in others.
    constexpr double deep_solid = 1.3;
    /// Distance of the middles, in sizes, at which two pieces can be in contact, and the least way a look waits for.
    constexpr double contact_distance = 0.9, least_way = 0.1;
    /// Bins along the largest piece: pieces of very different size must not fill the list.
    constexpr double most_bins = 32;
    /// Bins that go to one rank together, along each axis.
    constexpr int block_bits = 4;

    using Bin = std::array<std::int64_t, 2>;

    std::uint64_t
    hash(const Bin &bin)
    {
      std::uint64_t h = static_cast<std::uint64_t>(bin[0]) * 0x9e3779b97f4a7c15u;
      h               = (h ^ (h >> 32)) + static_cast<std::uint64_t>(bin[1]) * 0xbf58476d1ce4e5b9u;
      h               = (h ^ (h >> 29)) * 0x94d049bb133111ebu;
      return h ^ (h >> 32);
    }

    struct Box
    {
      Vector<2> lower, upper;
    };

    Box
    box(const Piece &piece)
    {
      Box result;
      for (int d = 0; d < 2; ++d)
        {
          const auto &x   = piece.x[d];
          result.lower[d] = std::min(std::min(x[0], x[1]), std::min(x[2], x[3]));
          result.upper[d] = std::max(std::max(x[0], x[1]), std::max(x[2], x[3]));
        }
      return result;
    }

    Bin
    bin_of(const Vector<2> &x, double edge)
    {
      return {{static_cast<std::int64_t>(std::floor(x[0] / edge)), static_cast<std::int64_t>(std::floor(x[1] / edge))}};
    }

    /// Edge of the bins: a power of two near twice the typical size of the pieces, the same on all ranks.
    double
    bin_edge(MPI_Comm communicator, std::span<const Piece> mine)
    {
      std::array<std::int64_t, 2> sums{};
      double                      largest = 0;
      for (const Piece &piece : mine)
        {
          if (piece.size > 0)
            {
              sums[0] += std::ilogb(piece.size);
              sums[1] += 1;
            }
          const Box b = box(piece);
          largest     = std::max({largest, b.upper[0] - b.lower[0], b.upper[1] - b.lower[1]});
        }
      MPI_Allreduce(MPI_IN_PLACE, sums.data(), 2, MPI_INT64_T, MPI_SUM, communicator);
      MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, communicator);
      if (sums[1] == 0)
        return 1.;
      const double mean = std::floor(static_cast<double>(sums[0]) / static_cast<double>(sums[1]));
      return std::max(std::ldexp(1., static_cast<int>(mean) + 2), largest / most_bins);
    }

    int
    owner(const Bin &bin, int ranks)
    {
      return static_cast<int>(hash({{bin[0] >> block_bits, bin[1] >> block_bits}}) % static_cast<std::uint64_t>(ranks));
    }

    /// Send every piece to the ranks that own a bin it touches.
    std::vector<Piece>
    distribute(MPI_Comm communicator, std::span<const Piece> mine, double edge, int ranks)
    {
      std::vector<std::vector<Piece>> to(ranks);
      for (const Piece &piece : mine)
        {
          const Box              b     = box(piece);
          const Bin              first = bin_of(b.lower, edge), last = bin_of(b.upper, edge);
          std::vector<bool>      sent(ranks, false);
          constexpr std::int64_t block = std::int64_t{1} << block_bits;
          for (std::int64_t j = first[1] & -block; j <= last[1]; j += block)
            for (std::int64_t i = first[0] & -block; i <= last[0]; i += block)
              if (const int rank = owner({{i, j}}, ranks); !sent[rank])
                {
                  sent[rank] = true;
                  to[rank].push_back(piece);
                }
        }
      std::vector<int>   count(ranks), expected(ranks), begin(ranks, 0), from(ranks, 0);
      std::vector<Piece> send;
      for (int rank = 0; rank < ranks; ++rank)
        {
          count[rank] = static_cast<int>(to[rank].size());
          begin[rank] = static_cast<int>(send.size());
          send.insert(send.end(), to[rank].begin(), to[rank].end());
        }
      MPI_Alltoall(count.data(), 1, MPI_INT, expected.data(), 1, MPI_INT, communicator);
      for (int rank = 1; rank < ranks; ++rank)
        from[rank] = from[rank - 1] + expected[rank - 1];
      std::vector<Piece> pieces(from.back() + expected.back());
      MPI_Datatype       type;
      MPI_Type_contiguous(sizeof(Piece), MPI_BYTE, &type);
      MPI_Type_commit(&type);
      MPI_Alltoallv(send.data(), count.data(), begin.data(), type, pieces.data(), expected.data(), from.data(), type,
                    communicator);
      MPI_Type_free(&type);
      return pieces;
    }

    /// Pieces by bin, in lists that start from a table of hashes.
    class Bins
    {
    public:
      Bins(std::span<const Piece> pieces, double edge)
        : pieces_(pieces)
        , edge_(edge)
      {
        std::size_t slots = 16;
        while (slots < 4 * pieces.size())
          slots *= 2;
        head_.assign(slots, none);
        for (std::size_t p = 0; p < pieces.size(); ++p)
          {
            boxes_.push_back(box(pieces[p]));
            const Bin first = bin_of(boxes_[p].lower, edge), last = bin_of(boxes_[p].upper, edge);
            for (std::int64_t j = first[1]; j <= last[1]; ++j)
              for (std::int64_t i = first[0]; i <= last[0]; ++i)
                {
                  Index &head = head_[hash({{i, j}}) & (slots - 1)];
                  entries_.push_back({{{i, j}}, static_cast<Index>(p), head});
                  head = static_cast<Index>(entries_.size() - 1);
                }
          }
      }

      template <typename Visit>
      void
      for_each_in(const Bin &bin, Visit visit) const
      {
        for (Index e = head_[hash(bin) & (head_.size() - 1)]; e != none; e = entries_[e].next)
          if (entries_[e].bin == bin)
            visit(pieces_[entries_[e].piece], boxes_[entries_[e].piece]);
      }

    private:
      struct Entry
      {
        Bin   bin;
        Index piece, next;
      };

      std::span<const Piece> pieces_;
      double                 edge_;
      std::vector<Box>       boxes_;
      std::vector<Index>     head_;
      std::vector<Entry>     entries_;
    };

    /// Velocity with which b comes closer to a; along what they differ by if they are in one place.
    double
    approach(const Piece &a, const Piece &b, double &distance)
    {
      const Vector<2> dx{{b.middle[0] - a.middle[0], b.middle[1] - a.middle[1]}};
      const Vector<2> du{{b.velocity[0] - a.velocity[0], b.velocity[1] - a.velocity[1]}};
      distance = std::sqrt(dx[0] * dx[0] + dx[1] * dx[1]);
      if (distance < 0.1 * std::min(a.size, b.size))
        return std::sqrt(du[0] * du[0] + du[1] * du[1]);
      return -(dx[0] * du[0] + dx[1] * du[1]) / distance;
    }

    /// Velocities of opening below this part of the pieces' own are none.
    double
    still(const Piece &a, const Piece &b)
    {
      constexpr double part   = 1e-4;
      const auto       square = [](const Vector<2> &u) { return u[0] * u[0] + u[1] * u[1]; };
      return part * std::sqrt(std::max(square(a.velocity), square(b.velocity)));
    }

    bool
    overlap(const Box &a, const Box &b)
    {
      return a.upper[0] > b.lower[0] && b.upper[0] > a.lower[0] && a.upper[1] > b.lower[1] && b.upper[1] > a.lower[1];
    }

    /// Whether two pieces have a corner in common: bonded neighbours, which cannot run into one another.
    bool
    share_a_corner(const Piece &a, const Piece &b)
    {
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
          if (a.x[0][i] == b.x[0][j] && a.x[1][i] == b.x[1][j])
            return true;
      return false;
    }

    /// The points of a piece that are looked at, its middle first.
    std::array<Vector<2>, 9>
    points_of(const Piece &piece)
    {
      std::array<Vector<2>, 9> point;
      for (int d = 0; d < 2; ++d)
        {
          const double middle = piece.middle[d];
          point[0][d]         = middle;
          for (int i = 0; i < 4; ++i)
            {
              const double a  = piece.x[d][CellShape<2>::walk[i]] - middle,
                           b  = piece.x[d][CellShape<2>::walk[(i + 1) % 4]] - middle;
              point[1 + i][d] = middle + reach * a;
              point[5 + i][d] = middle + reach * 0.5 * (a + b);
            }
        }
      return point;
    }

    /// Looks around the pieces, one after the other.
    class Look
    {
    public:
      Look(const Bins &bins, double edge, int me, int ranks, Found &found)
        : bins_(bins)
        , edge_(edge)
        , me_(me)
        , ranks_(ranks)
        , found_(found)
      {
      }

      /// At those points of a piece that lie in this rank's bins.
      void
      around(const Piece &piece)
      {
        const std::array<Vector<2>, 9> points = points_of(piece);
        Box                            hull{points[0], points[0]};
        for (const Vector<2> &x : points)
          for (int d = 0; d < 2; ++d)
            {
              hull.lower[d] = std::min(hull.lower[d], x[d]);
              hull.upper[d] = std::max(hull.upper[d], x[d]);
            }
        bool known = false;
        Bin  bin{};
        for (std::size_t i = 0; i < points.size(); ++i)
          {
            const Bin here = bin_of(points[i], edge_);
            if (owner(here, ranks_) != me_)
              continue;
            if (!known || here != bin)
              {
                bin   = here;
                known = true;
                collect(piece, hull, bin, i == 0);
              }
            if (!near_.empty())
              at(piece, points[i], i == 0);
          }
      }

    private:
      /// The pieces of a bin that may hold points of this one, in the order of keys.
      void
      collect(const Piece &piece, const Box &hull, const Bin &bin, bool is_middle)
      {
        near_.clear();
        double solid = piece.solid;
        bins_.for_each_in(bin, [&](const Piece &other, const Box &b) {
          if (other.key == piece.key)
            return;
          if (is_middle && piece.solid + other.solid > contact_solid)
            wait_for(piece, other);
          if (overlap(hull, b))
            {
              near_.push_back(&other);
              solid += other.solid;
            }
        });
        if (!(solid > contact_solid))
          near_.clear();
        std::sort(near_.begin(), near_.end(), [](auto *a, auto *b) { return a->key < b->key; });
      }

      void
      wait_for(const Piece &piece, const Piece &other)
      {
        double       distance;
        const double rate = approach(piece, other, distance);
        if (!(rate > 0))
          return;
        const double size = 0.5 * (piece.size + other.size);
        const double time = std::max(least_way * size, distance - contact_distance * size) / rate;
        if (time < found_.time_to_next && !share_a_corner(piece, other))
          found_.time_to_next = time;
      }

      void
      at(const Piece &piece, const Vector<2> &point, bool is_middle)
      {
        inside_.clear();
        double solid = piece.solid;
        for (const Piece *other : near_)
          if (is_inside(other->x, point))
            {
              inside_.push_back(other);
              solid += other->solid;
            }
        if (inside_.empty() || !(solid > contact_solid))
          return;
        found_.deep += is_middle && solid > deep_solid;
        for (const Piece *other : inside_)
          {
            double       distance;
            const double rate = approach(piece, *other, distance), rest = still(piece, *other);
            if (rate >= -rest)
              found_.pairs.push_back({piece, *other, rate > rest});
          }
      }

      const Bins                &bins_;
      double                     edge_;
      int                        me_, ranks_;
      Found                     &found_;
      std::vector<const Piece *> near_, inside_;
    };
  } // namespace

  bool
  is_inside(const CornerVectors<2> &x, const Vector<2> &point)
  {
    bool inside = false;
    for (int i = 0; i < 4; ++i)
      {
        const int a = CellShape<2>::walk[i], b = CellShape<2>::walk[(i + 1) % 4];
        if ((x[1][a] > point[1]) == (x[1][b] > point[1]))
          continue;
        const double crossing = x[0][a] + (x[0][b] - x[0][a]) * ((point[1] - x[1][a]) / (x[1][b] - x[1][a]));
        inside                = inside != (point[0] < crossing);
      }
    return inside;
  }

  Found
  search(MPI_Comm communicator, std::span<const Piece> mine)
  {
    int me, ranks;
    MPI_Comm_rank(communicator, &me);
    MPI_Comm_size(communicator, &ranks);
    const double       edge = bin_edge(communicator, mine);
    std::vector<Piece> received;
    if (ranks > 1)
      {
        received = distribute(communicator, mine, edge, ranks);
        mine     = received;
      }
    const Bins bins(mine, edge);
    Found      found;
    found.time_to_next = std::numeric_limits<double>::infinity();
    Look look(bins, edge, me, ranks, found);
    for (const Piece &piece : mine)
      look.around(piece);
    return found;
  }
} // namespace whipple::contact
