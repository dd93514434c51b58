// SPDX-License-Identifier: LGPL-2.1-or-later
// How elements are gathered into fragments: doc/theory/fragments.md.
#include <whipple/projection/group_parcels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
  using namespace whipple;
  using namespace whipple::projection;

  /// Square parcels of a width that fill a box; `fill` of each is solid, fragments are `size` wide.
  std::vector<Parcel>
  block(const Vector<2> &lower, int across, int along, double width, double fill, double size)
  {
    std::vector<Parcel> parcels;
    for (int j = 0; j < along; ++j)
      for (int i = 0; i < across; ++i)
        {
          Parcel parcel;
          parcel.lower = {{lower[0] + i * width, lower[1] + j * width}};
          parcel.upper = {{lower[0] + (i + 1) * width, lower[1] + (j + 1) * width}};
          parcel.solid = fill * width * width;
          parcel.size  = size;
          parcels.push_back(parcel);
        }
    return parcels;
  }

  std::vector<ParcelGroup>
  fragments_of(const std::vector<Parcel> &parcels)
  {
    std::vector<ParcelGroup> all;
    for (const ParcelGroup &set : touching_sets(parcels))
      for (const ParcelGroup &group : cut_into_fragments(Symmetry::planar, parcels, set))
        all.push_back(group);
    return all;
  }

  /// Weight and length (as if solid) of a group.
  std::array<double, 2>
  weight_and_length(const std::vector<Parcel> &parcels, const ParcelGroup &group)
  {
    double    weight = 0, solid = 0, area = 0;
    Vector<2> low{{1e9, 1e9}}, high{{-1e9, -1e9}};
    for (const Index i : group)
      {
        weight += parcels[i].solid / (parcels[i].size * parcels[i].size);
        solid += parcels[i].solid;
        area += parcels[i].area();
        for (int d = 0; d < 2; ++d)
          {
            low[d]  = std::min(low[d], parcels[i].lower[d]);
            high[d] = std::max(high[d], parcels[i].upper[d]);
          }
      }
    return {weight, std::sqrt(solid / area) * std::max(high[0] - low[0], high[1] - low[1])};
  }

  void
  expect_partition(const std::vector<Parcel> &parcels, const std::vector<ParcelGroup> &groups)
  {
    std::multiset<Index> seen;
    for (const ParcelGroup &group : groups)
      seen.insert(group.begin(), group.end());
    ASSERT_EQ(seen.size(), parcels.size());
    for (Index i = 0; i < static_cast<Index>(parcels.size()); ++i)
      EXPECT_EQ(seen.count(i), 1u);
  }

  TEST(GroupParcels, ABlockBreaksIntoPiecesOfTheSizeAskedFor)
  {
    for (const double fill : {1., 0.3})
      {
        // 40 x 40 cells of 0.01 cm hold 1600 fill (0.01)^2 of solid: so many pieces of 0.05 cm
        const auto parcels = block({{0., 0.}}, 40, 40, 0.01, fill, 0.05);
        const auto groups  = fragments_of(parcels);
        expect_partition(parcels, groups);
        EXPECT_NEAR(static_cast<double>(groups.size()), 0.16 * fill / 0.0025, 0.1 * 0.16 * fill / 0.0025);
        for (const ParcelGroup &group : groups)
          {
            const auto [weight, length] = weight_and_length(parcels, group);
            EXPECT_GT(weight, 0.5);
            EXPECT_LT(weight, 1.5);
            EXPECT_LT(length, 2. * 0.05);
          }
      }
  }

  TEST(GroupParcels, ThinSheetBreaksIntoBitsAsLongAsAFragment)
  {
    // 0.01 cm thick: by area alone the bits would be 0.25 cm long
    const auto parcels = block({{0.3, 0.}}, 200, 2, 0.005, 1., 0.05);
    const auto groups  = fragments_of(parcels);
    expect_partition(parcels, groups);
    EXPECT_NEAR(static_cast<double>(groups.size()), 20., 1.);
    for (const ParcelGroup &group : groups)
      EXPECT_LT(weight_and_length(parcels, group)[1], 0.075);
  }

  TEST(GroupParcels, WhatDoesNotTouchIsNotJoined)
  {
    // two chunks, each one fragment, less than a fragment apart; and one in a cloud of thin material
    auto       parcels = block({{0.2, 0.}}, 5, 5, 0.01, 1., 0.05);
    const auto other   = block({{0.27, 0.}}, 5, 5, 0.01, 1., 0.05);
    parcels.insert(parcels.end(), other.begin(), other.end());
    EXPECT_EQ(fragments_of(parcels).size(), 2u);

    auto cloud = block({{0., 0.}}, 30, 30, 0.01, 0.1, 0.05);
    for (int j = 10; j < 15; ++j)
      for (int i = 10; i < 15; ++i)
        cloud[j * 30 + i].solid = 1e-4;
    bool found = false;
    for (const ParcelGroup &group : fragments_of(cloud))
      if (std::any_of(group.begin(), group.end(), [&](Index i) { return cloud[i].solid == 1e-4; }))
        {
          found = true;
          EXPECT_EQ(group.size(), 25u);
        }
    EXPECT_TRUE(found);
  }

  TEST(GroupParcels, FinerCellsMoveTheCutsByACellOrTwo)
  {
    // a wedge of solid: centres of the pieces of a coarse and of a mesh twice as fine
    const auto wedge = [](int n) {
      std::vector<Parcel> parcels;
      for (const Parcel &p : block({{0., 0.}}, n, n, 0.4 / n, 1., 0.1))
        if (0.5 * (p.lower[0] + p.upper[0]) < 0.5 * (p.lower[1] + p.upper[1]))
          parcels.push_back(p);
      return parcels;
    };
    std::array<std::vector<Vector<2>>, 2> centres;
    for (int level = 0; level < 2; ++level)
      {
        const auto parcels = wedge(level ? 80 : 40);
        for (const ParcelGroup &group : fragments_of(parcels))
          {
            Vector<2> sum{};
            for (const Index i : group)
              for (int d = 0; d < 2; ++d)
                sum[d] += 0.5 * (parcels[i].lower[d] + parcels[i].upper[d]) / static_cast<double>(group.size());
            centres[level].push_back(sum);
          }
      }
    ASSERT_EQ(centres[0].size(), centres[1].size());
    for (const Vector<2> &a : centres[0])
      {
        double nearest = 1e9;
        for (const Vector<2> &b : centres[1])
          nearest = std::min(nearest, std::hypot(a[0] - b[0], a[1] - b[1]));
        EXPECT_LT(nearest, 0.015); // coarse cells: 0.01
      }
  }
} // namespace
