// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/disjoint_sets.h>
#include <whipple/projection/group_parcels.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace whipple::projection
{
  namespace
  {
    /// Share of a parcel that is solid from which on it is dense.
    constexpr double dense = 0.5;

    Vector<2>
    middle(const Parcel &parcel)
    {
      return {{0.5 * (parcel.lower[0] + parcel.upper[0]), 0.5 * (parcel.lower[1] + parcel.upper[1])}};
    }

    /// Whether two boxes share a point, but for round-off.
    bool
    touch(const Parcel &a, const Parcel &b)
    {
      for (int d = 0; d < 2; ++d)
        {
          const double slack = 1e-6 * std::min(a.upper[d] - a.lower[d], b.upper[d] - b.lower[d]);
          if (a.lower[d] > b.upper[d] + slack || b.lower[d] > a.upper[d] + slack)
            return false;
        }
      return true;
    }

    /// Square bins as large as the largest parcel: those that touch lie in the same bin or in one beside it.
    class Bins
    {
    public:
      explicit Bins(std::span<const Parcel> parcels)
        : parcels_(parcels)
      {
        for (const Parcel &parcel : parcels)
          for (int d = 0; d < 2; ++d)
            size_ = std::max(size_, parcel.upper[d] - parcel.lower[d]);
        for (std::size_t i = 0; i < parcels.size(); ++i)
          bin_[bin_of(parcels[i])].push_back(static_cast<Index>(i));
      }

      /// Call visit(j) for every parcel that may touch this one.
      template <typename Visit>
      void
      for_each_near(Index i, Visit visit) const
      {
        const auto [x, y] = bin_of(parcels_[i]);
        for (long a = x - 1; a <= x + 1; ++a)
          for (long b = y - 1; b <= y + 1; ++b)
            if (const auto found = bin_.find({a, b}); found != bin_.end())
              for (const Index j : found->second)
                visit(j);
      }

    private:
      std::pair<long, long>
      bin_of(const Parcel &parcel) const
      {
        const Vector<2> x = middle(parcel);
        return {std::lround(std::floor(x[0] / size_)), std::lround(std::floor(x[1] / size_))};
      }

      std::span<const Parcel>                             parcels_;
      double                                              size_ = 0;
      std::map<std::pair<long, long>, std::vector<Index>> bin_;
    };

    /// What decides how a set is cut.
    struct Shape
    {
      double    weight = 0;
      double    pieces = 1; ///< that it should be
      Vector<2> axis{};     ///< unit vector, the principal axis of its solid
    };

    /// Principal axis of a symmetric matrix; along axis 1 where it has none.
    Vector<2>
    principal_axis(double xx, double xy, double yy)
    {
      const double     angle = 0.5 * std::atan2(2. * xy, xx - yy);
      Vector<2>        axis{{std::cos(angle), std::sin(angle)}};
      constexpr double tiny = 1e-9;
      if (std::hypot(xx - yy, 2. * xy) <= tiny * (xx + yy))
        axis = {{0., 1.}};
      if (axis[1] < 0)
        axis = {{-axis[0], -axis[1]}};
      return axis;
    }

    /// Whether a parcel lies beside the axis, where a fragment shows half of its section.
    bool
    beside_axis(Symmetry symmetry, const Parcel &parcel)
    {
      return symmetry == Symmetry::axisymmetric && middle(parcel)[0] < 0.5 * parcel.size;
    }

    /// How much of a fragment a parcel is.
    double
    weight(Symmetry symmetry, const Parcel &parcel)
    {
      return (beside_axis(symmetry, parcel) ? 2. : 1.) * parcel.solid / (parcel.size * parcel.size);
    }

    Shape
    shape_of(Symmetry symmetry, std::span<const Parcel> parcels, const ParcelGroup &set)
    {
      const bool mirrored = symmetry == Symmetry::axisymmetric &&
                            std::any_of(set.begin(), set.end(), [&](Index i) { return parcels[i].lower[0] <= 0.; });
      Shape     shape;
      double    solid = 0, area = 0, number = 0;
      Vector<2> mean{}, along{}; // second moments along the axes
      double    across = 0;
      for (const Index i : set)
        {
          const Parcel   &p = parcels[i];
          const Vector<2> x = middle(p);
          shape.weight += weight(symmetry, p);
          area += p.area();
          number += p.solid / (p.size * p.size);
          // about the running mean: no difference of squares
          const double before = solid;
          solid += p.solid;
          Vector<2> step;
          for (int d = 0; d < 2; ++d)
            {
              const bool still = mirrored && d == 0; // with its mirror image the mean stays on the axis
              step[d]          = x[d] - mean[d];
              along[d] += (still ? p.solid : before * p.solid / solid) * step[d] * step[d] +
                          p.solid * std::pow(p.upper[d] - p.lower[d], 2) / 12.;
              mean[d] += still ? 0. : step[d] * (p.solid / solid);
            }
          across += mirrored ? 0. : before * p.solid / solid * step[0] * step[1];
        }
      shape.axis              = principal_axis(along[0], across, along[1]);
      const double half_trace = 0.5 * (along[0] + along[1]);
      const double largest    = half_trace + std::hypot(0.5 * (along[0] - along[1]), across);
      // length of the bar with this second moment, as long as it would be if it were solid
      const double length = std::sqrt(12. * largest / solid) * std::sqrt(solid / area);
      const double size   = std::sqrt(solid / number);
      shape.pieces        = std::max({1., std::round(shape.weight), std::round(length / size)});
      return shape;
    }

    /// The two parts of a set: the first has about `share` of its weight.
    std::array<ParcelGroup, 2>
    cut(Symmetry symmetry, std::span<const Parcel> parcels, const ParcelGroup &set, const Shape &shape, double share)
    {
      const auto place = [&](Index i) {
        const Vector<2> x = middle(parcels[i]);
        return x[0] * shape.axis[0] + x[1] * shape.axis[1];
      };
      ParcelGroup along = set;
      std::stable_sort(along.begin(), along.end(), [&](Index i, Index j) { return place(i) < place(j); });
      double      sum = 0, best = std::numeric_limits<double>::infinity();
      std::size_t at = 1;
      for (std::size_t n = 1; n < along.size(); ++n)
        {
          sum += weight(symmetry, parcels[along[n - 1]]);
          if (const double miss = std::abs(sum - share * shape.weight); miss < best)
            {
              best = miss;
              at   = n;
            }
        }
      const auto                 middle_of_set = along.begin() + static_cast<std::ptrdiff_t>(at);
      std::array<ParcelGroup, 2> parts{ParcelGroup(along.begin(), middle_of_set),
                                       ParcelGroup(middle_of_set, along.end())};
      for (ParcelGroup &part : parts)
        std::sort(part.begin(), part.end());
      return parts;
    }
  } // namespace

  std::vector<ParcelGroup>
  touching_sets(std::span<const Parcel> parcels)
  {
    if (parcels.empty())
      return {};
    const Bins   bins(parcels);
    DisjointSets sets(parcels.size());
    const auto   is_dense = [&](Index i) { return parcels[i].solid > dense * parcels[i].area(); };
    for (Index i = 0; i < static_cast<Index>(parcels.size()); ++i)
      bins.for_each_near(i, [&](Index j) {
        if (j < i && is_dense(i) == is_dense(j) && touch(parcels[i], parcels[j]))
          sets.unite(i, j);
      });
    std::map<std::size_t, ParcelGroup> groups;
    for (Index i = 0; i < static_cast<Index>(parcels.size()); ++i)
      groups[sets.root(i)].push_back(i);
    std::vector<ParcelGroup> result;
    for (auto &[root, group] : groups)
      result.push_back(std::move(group));
    return result;
  }

  std::vector<ParcelGroup>
  cut_into_fragments(Symmetry symmetry, std::span<const Parcel> parcels, const ParcelGroup &set)
  {
    std::vector<ParcelGroup> whole, fragments;
    if (!set.empty())
      whole.push_back(set);
    while (!whole.empty())
      {
        const ParcelGroup group = std::move(whole.back());
        whole.pop_back();
        const Shape shape = shape_of(symmetry, parcels, group);
        if (group.size() == 1 || shape.pieces < 2)
          {
            fragments.push_back(group);
            continue;
          }
        for (ParcelGroup &part : cut(symmetry, parcels, group, shape, std::floor(shape.pieces / 2) / shape.pieces))
          whole.push_back(std::move(part));
      }
    return fragments;
  }
} // namespace whipple::projection
