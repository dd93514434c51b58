// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/stage/contact_search.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace whipple::contact
{
  namespace
  {
    /// Solid around a piece's middle from which three or more must be in one place.
    constexpr double deep_solid = 2.1;
    /// Middles closer than this part of the smaller piece are one place.
    constexpr double deep_distance = 0.3;
    /// Distance, in sizes, at which middles are in contact, and the least way a look waits for.
    constexpr double contact_distance = 0.5, least_way = 0.1;
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
      return {static_cast<std::int64_t>(std::floor(x[0] / edge)), static_cast<std::int64_t>(std::floor(x[1] / edge))};
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
      return static_cast<int>(hash({bin[0] >> block_bits, bin[1] >> block_bits}) % static_cast<std::uint64_t>(ranks));
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
              if (const int rank = owner({i, j}, ranks); !sent[rank])
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
                  Index &head = head_[hash({i, j}) & (slots - 1)];
                  entries_.push_back({{i, j}, static_cast<Index>(p), head});
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
      constexpr double part   = 1e-9;
      const auto       square = [](const Vector<2> &u) { return u[0] * u[0] + u[1] * u[1]; };
      return part * std::sqrt(std::max(square(a.velocity), square(b.velocity)));
    }

    bool
    is_in_box(const Box &b, const Vector<2> &x)
    {
      return x[0] > b.lower[0] && x[0] < b.upper[0] && x[1] > b.lower[1] && x[1] < b.upper[1];
    }

    /// Look around the middle of one piece.
    void
    look(const Piece &piece, const Bins &bins, const Bin &bin, Found &found)
    {
      // the pieces around the middle, few: in the order of keys, whatever the order of the list
      constexpr int                   most = 64;
      std::array<const Piece *, most> around;
      int                             n = 0;
      bins.for_each_in(bin, [&](const Piece &other, const Box &b) {
        if (other.key == piece.key)
          return;
        if (piece.solid + other.solid > contact_solid)
          {
            double       distance;
            const double rate = approach(piece, other, distance), size = std::min(piece.size, other.size);
            if (rate > 0)
              found.time_to_next =
                  std::min(found.time_to_next, std::max(least_way * size, distance - contact_distance * size) / rate);
          }
        if (n < most && is_in_box(b, piece.middle) && is_inside(other.x, piece.middle))
          around[n++] = &other;
      });
      if (n == 0)
        return;
      std::sort(around.begin(), around.begin() + n, [](auto *a, auto *b) { return a->key < b->key; });
      double solid = piece.solid;
      for (int i = 0; i < n; ++i)
        solid += around[i]->solid;
      if (!(solid > contact_solid))
        return;
      bool deep = solid > deep_solid;
      for (int i = 0; i < n; ++i)
        {
          double       distance;
          const double rate = approach(piece, *around[i], distance), none_below = still(piece, *around[i]);
          deep = deep || distance < deep_distance * std::min(piece.size, around[i]->size);
          if (rate >= -none_below)
            found.pairs.push_back({piece, *around[i], rate > none_below});
        }
      found.deep += deep;
    }
  } // namespace

  bool
  is_inside(const geometry::Quad &x, const Vector<2> &point)
  {
    bool inside = false;
    for (int i = 0; i < 4; ++i)
      {
        const int a = geometry::walk[i], b = geometry::walk[(i + 1) % 4];
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
    for (const Piece &piece : mine)
      if (const Bin bin = bin_of(piece.middle, edge); owner(bin, ranks) == me)
        look(piece, bins, bin, found);
    return found;
  }
} // namespace whipple::contact
