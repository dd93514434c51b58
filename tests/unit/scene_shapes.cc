// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes made of straight edges: their volumes against formulas, how they are cut, turned and kept apart, and that what
// is registered can be asked for.
#include <whipple/mesh/cell_geometry.h>
#include <whipple/scene/body_volume.h>
#include <whipple/scene/box_shape.h>
#include <whipple/scene/plate_shape.h>
#include <whipple/scene/polygon_shape.h>
#include <whipple/scene/shape_registry.h>
#include <whipple/scene/sphere_shape.h>
#include <whipple/scene/triangulation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace
{
  using namespace whipple;
  using std::numbers::pi;
  using Corners = std::vector<Vector<2>>;

  /// Sum over the cells of a mesh that covers a shape.
  double
  cell_sum(Symmetry symmetry, const Shape<2> &shape, double h)
  {
    const Box<2> box   = extent(shape);
    long double  sum   = 0;
    const bool   plane = symmetry == Symmetry::planar;
    for (double y = box.lower[1] - 0.3 * h; y < box.upper[1]; y += h)
      for (double x = plane ? box.lower[0] - 0.3 * h : 0.; x < box.upper[0]; x += h)
        sum += body_volume<2>(symmetry, shape, {{x, y}}, {{x + h, y + h}});
    return static_cast<double>(sum);
  }

  /// Area or volume of revolution that an outline encloses, by Green's theorem along its edges.
  double
  green(Symmetry symmetry, const Corners &x)
  {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        const Vector<2> &a = x[i], &b = x[(i + 1) % x.size()];
        sum += symmetry == Symmetry::planar
                   ? CellGeometry<2, Symmetry::planar>::edge_volume(a[0], a[1], b[0], b[1])
                   : CellGeometry<2, Symmetry::axisymmetric>::edge_volume(a[0], a[1], b[0], b[1]);
      }
    return std::abs(sum);
  }

  /// Input of a shape as a scene would give it, lengths in cm.
  class Given : public ShapeInput<2>
  {
  public:
    Given(Symmetry symmetry, std::map<std::string, std::vector<double>> values)
      : symmetry_(symmetry)
      , values_(std::move(values))
    {
    }
    Symmetry
    symmetry() const override
    {
      return symmetry_;
    }
    std::string
    text(const std::string &key) const override
    {
      return values_.count(key) ? "given" : "";
    }
    double
    positive_length(const std::string &key) const override
    {
      return values_.at(key).at(0);
    }
    double
    length(const std::string &key) const override
    {
      return values_.at(key).at(0);
    }
    Vector<2>
    point(const std::string &key) const override
    {
      return {{values_.at(key).at(0), values_.at(key).at(1)}};
    }
    Vector<2>
    point(const std::string &key, const std::string &) const override
    {
      return point(key);
    }
    [[noreturn]] void
    reject(const std::string &key, const std::string &allowed) const override
    {
      throw std::runtime_error(key + ": " + allowed);
    }
    void
    replace(const std::string &, const std::string &) const override
    {
    }
    std::string
    file(const std::string &key) const override
    {
      return key;
    }

  private:
    Symmetry                                   symmetry_;
    std::map<std::string, std::vector<double>> values_;
  };

  Shape<2>
  made(const std::string &kind, Symmetry symmetry, std::map<std::string, std::vector<double>> values)
  {
    return ShapeRegistry<2>::all().at(kind).make(Given(symmetry, std::move(values)));
  }

  /// A star of 2 n corners around a point.
  Corners
  star(int n, double inner, double outer, const Vector<2> &center)
  {
    Corners corners;
    for (int i = 0; i < 2 * n; ++i)
      {
        const double radius = i % 2 ? inner : outer, angle = pi * (i + 0.3) / n;
        corners.push_back({{center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle)}});
      }
    return corners;
  }

  TEST(SceneShapes, ConesAndCylindersHaveTheVolumesOfTheFormulas)
  {
    const double   R = 0.237, r = 0.081, h = 0.3131;
    const Shape<2> sharp =
        made("cone", Symmetry::axisymmetric, {{"Base center", {0, -0.1}}, {"Base diameter", {2 * R}}, {"Length", {h}}});
    const Shape<2> blunt =
        made("cone", Symmetry::axisymmetric,
             {{"Base center", {0, -0.1}}, {"Base diameter", {2 * R}}, {"Top diameter", {2 * r}}, {"Length", {h}}});
    const Shape<2> rod =
        made("cylinder", Symmetry::axisymmetric, {{"Center", {0, 0.3}}, {"Diameter", {2 * r}}, {"Length", {h}}});
    for (const double cell : {0.013, 0.05, 1.})
      {
        EXPECT_NEAR(cell_sum(Symmetry::axisymmetric, sharp, cell) / (pi / 3. * R * R * h), 1., 1e-13);
        EXPECT_NEAR(cell_sum(Symmetry::axisymmetric, blunt, cell) / (pi / 3. * h * (R * R + R * r + r * r)), 1., 1e-13);
        EXPECT_NEAR(cell_sum(Symmetry::axisymmetric, rod, cell) / (pi * r * r * h), 1., 1e-13);
        EXPECT_NEAR(cell_sum(Symmetry::planar, sharp, cell) / (R * h), 1., 1e-13);
        EXPECT_NEAR(cell_sum(Symmetry::planar, blunt, cell) / ((R + r) * h), 1., 1e-13);
      }
    EXPECT_TRUE(sharp->is_mirrored());
    EXPECT_TRUE(blunt->is_mirrored());
    EXPECT_TRUE(rod->is_mirrored());
    EXPECT_THROW(made("cylinder", Symmetry::axisymmetric, {{"Center", {1, 0}}, {"Diameter", {1}}, {"Length", {1}}}),
                 std::runtime_error);
  }

  TEST(SceneShapes, CellsOfPolygonsSumToTheWhole)
  {
    const std::vector<Corners> outlines{star(5, 0.05, 0.17, {{0.2, 0.1}}),
                                        star(100, 0.15, 0.17, {{0.2, -3.}}),
                                        // a spiral, and a square with a slit
                                        {{{0, 0}},
                                         {{1, 0}},
                                         {{1, 1}},
                                         {{0.2, 1}},
                                         {{0.2, 0.4}},
                                         {{0.6, 0.4}},
                                         {{0.6, 0.6}},
                                         {{0.4, 0.6}},
                                         {{0.4, 0.8}},
                                         {{0.8, 0.8}},
                                         {{0.8, 0.2}},
                                         {{0, 0.2}}},
                                        {{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0.5, 0.1}}, {{0.499, 1}}, {{0, 1}}}};
    for (Corners corners : outlines)
      for (const bool clockwise : {false, true})
        {
          if (clockwise)
            std::reverse(corners.begin(), corners.end());
          ASSERT_EQ(outline_problem(corners), "");
          const PolygonShape polygon(corners);
          for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
            for (const double cell : {0.0137, 0.1})
              EXPECT_NEAR(cell_sum(symmetry, polygon, cell) / green(symmetry, corners), 1., 2e-12)
                  << corners.size() << " corners, cells of " << cell;
        }
  }

  // Monte Carlo would be blunt: a point is in the polygon if a box around it that is small enough is full.
  TEST(SceneShapes, ContainsAgreesWithVolumes)
  {
    const PolygonShape                     polygon(star(5, 0.05, 0.17, {{0.2, 0.1}}));
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> place(-0.1, 0.4);
    int                                    inside = 0;
    for (int i = 0; i < 3000; ++i)
      {
        const Vector<2> x{{place(random), place(random)}}, half{{1e-7, 1e-7}};
        const double    share =
            polygon.volume(Symmetry::planar, {{x[0] - half[0], x[1] - half[1]}}, {{x[0] + half[0], x[1] + half[1]}}) /
            (4. * half[0] * half[1]);
        if (share < 1e-6 || share > 1. - 1e-6)
          {
            EXPECT_EQ(polygon.contains(x), share > 0.5);
          }
        inside += share > 0.5;
      }
    EXPECT_NEAR(inside / 3000. * 0.25, green(Symmetry::planar, polygon.corners()), 0.005);
  }

  TEST(SceneShapes, TurnedBodiesKeepTheirVolume)
  {
    const Box<2>   domain{{{-2, -2}}, {{2, 2}}};
    const Plate<2> plate(-0.04, 0.08, 0.5);
    for (const double angle : {30., 45., -17.3, 90., 180., 270.})
      {
        const Shape<2> turned = plate.turned(Turn<2>::in_plane(angle, {{0.1, 0.2}}), domain);
        EXPECT_NEAR(cell_sum(Symmetry::planar, turned, 0.0137) / 0.08, 1., 1e-13) << angle;
        EXPECT_NEAR(turned->least_thickness({}), 0.08, 1e-15) << angle;
      }
    const Shape<2> upright = plate.turned(Turn<2>::in_plane(90., {{0., 0.}}), domain);
    EXPECT_EQ(extent(upright).lower, (Vector<2>{{-0.04, -0.5}}));
    EXPECT_EQ(extent(upright).upper, (Vector<2>{{0.04, 0.5}}));
    EXPECT_TRUE(upright->is_box());
    // upside down a plate is a plate, whose hole can be measured
    const Shape<2> over_head = plate.turned(Turn<2>::in_plane(180., {{0., 0.1}}), domain);
    ASSERT_TRUE(over_head.as<Plate<2>>());
    EXPECT_DOUBLE_EQ(over_head.as<Plate<2>>()->front, 0.16);
    EXPECT_TRUE(Plate<2>(0., 1.).turned(Turn<2>::end_for_end({{0., 0.}}), domain).as<Plate<2>>());

    // what reaches over the whole domain does so afterwards: a strip of this thickness through a square of edge 4
    const Shape<2> oblique = Plate<2>(-0.04, 0.08).turned(Turn<2>::in_plane(30., {{0., 0.}}), domain);
    EXPECT_NEAR(oblique->volume(Symmetry::planar, domain.lower, domain.upper), 0.08 * 4. / std::cos(pi / 6.), 1e-13);
    EXPECT_EQ(extent(oblique).lower[0], -2.);
    EXPECT_EQ(extent(oblique).upper[0], 2.);
    EXPECT_NEAR(extent(oblique).upper[1], 2. * std::tan(pi / 6.) + 0.04 / std::cos(pi / 6.), 1e-13);
    EXPECT_NEAR(oblique->least_thickness({}), 0.08, 1e-13);

    const Shape<2> cone =
        made("cone", Symmetry::axisymmetric, {{"Base center", {0, -0.1}}, {"Base diameter", {0.4}}, {"Length", {0.3}}});
    const Shape<2> over = cone->turned(Turn<2>::end_for_end({{0, 0.05}}), domain);
    EXPECT_NEAR(cell_sum(Symmetry::axisymmetric, over, 0.0137) / (pi / 3. * 0.04 * 0.3), 1., 1e-13);
    EXPECT_TRUE(over->contains({{0.19, 0.195}}));
    EXPECT_FALSE(over->contains({{0.01, -0.095}}));
    EXPECT_TRUE(over->is_mirrored());
  }

  TEST(SceneShapes, TurnedBodiesTouchWithoutOverlap)
  {
    const Box<2> domain{{{-2, -2}}, {{2, 2}}};
    const auto   turned = [&](double front, double angle) {
      return Plate<2>(front, 0.1, 0.5).turned(Turn<2>::in_plane(angle, {{0.2, 0.1}}), domain);
    };
    for (const double angle : {0., 30., 61.7, -45.})
      {
        EXPECT_FALSE(overlap<2>(turned(0., angle), turned(0.1, angle))) << angle;
        EXPECT_TRUE(overlap<2>(turned(0., angle), turned(0.1 - 1e-9, angle))) << angle;
        EXPECT_FALSE(overlap<2>(turned(0., angle), turned(0.1 + 1e-9, angle))) << angle;
        // a disk that rests on the plate
        const Vector<2> center = Turn<2>::in_plane(angle, {{0.2, 0.1}})({{0.13, -0.25}});
        EXPECT_FALSE(overlap<2>(Sphere<2>(center, 0.5), turned(0., angle))) << angle;
        EXPECT_TRUE(overlap<2>(Sphere<2>(center, 0.5 + 1e-9), turned(0., angle))) << angle;
      }
    // bounding boxes share volume, bodies do not
    EXPECT_FALSE(overlap<2>(turned(0., 45.), Sphere<2>({{-0.2, 0.45}}, 0.2)));
    // a body in the mouth of another
    const Shape<2> mouth =
        PolygonShape({{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}, {{0, 0.8}}, {{0.8, 0.8}}, {{0.8, 0.2}}, {{0, 0.2}}});
    EXPECT_FALSE(overlap<2>(mouth, Box<2>{{{0.1, 0.2}}, {{0.8, 0.8}}}));
    EXPECT_TRUE(overlap<2>(mouth, Box<2>{{{0.1, 0.1999}}, {{0.8, 0.8}}}));
    EXPECT_TRUE(overlap<2>(Plate<2>(0.9, 1), mouth));
    EXPECT_FALSE(overlap<2>(Plate<2>(1., 1), mouth));
  }

  TEST(SceneShapes, ThicknessIsWhatTheMeshMustResolve)
  {
    EXPECT_DOUBLE_EQ(PolygonShape({{{0, 0}}, {{3, 0}}, {{3, 1}}, {{1, 1}}, {{1, 3}}, {{0, 3}}}).least_thickness({}),
                     1.);
    const PolygonShape ring({{{0, 0}}, {{0.5, 0}}, {{0.5, 1}}, {{0, 1}}});
    EXPECT_DOUBLE_EQ(ring.least_thickness({}), 0.5);
    const std::vector<MirrorPlane> axis{{0, 0.}};
    EXPECT_DOUBLE_EQ(ring.least_thickness(axis), 1.);
    EXPECT_DOUBLE_EQ(BoxShape<2>({{{0, 0}}, {{0.5, 1}}}).least_thickness(axis), 1.);
  }

  TEST(SceneShapes, OutlinesThatAreNoneAreNamed)
  {
    EXPECT_EQ(outline_problem({{{0, 0}}, {{1, 0}}}), "a polygon has at least 3 corners");
    EXPECT_EQ(outline_problem({{{0, 0}}, {{1, 1}}, {{1, 0}}, {{0, 1}}}), "edges 1 and 3 cross or touch");
    EXPECT_EQ(outline_problem({{{0, 0}}, {{1, 0}}, {{1, 0}}, {{0, 1}}}), "corners 2 and 3 are the same");
    EXPECT_EQ(outline_problem({{{0, 0}}, {{2, 0}}, {{1, 0}}, {{1, 1}}}), "edge 2 comes back over edge 1");
    EXPECT_EQ(outline_problem({{{0, 0}}, {{2, 0}}, {{2, 1}}, {{1, 0}}, {{0, 1}}}), "edges 1 and 3 cross or touch");
    EXPECT_EQ(outline_problem({{{0, 0}}, {{1, 1e-14}}, {{2, 0}}}), "the corners enclose no area");
    EXPECT_EQ(outline_problem({{{0, 0}}, {{1, 0}}, {{2, 0}}, {{2, 1}}}), "");
  }

  TEST(SceneShapes, WhatIsRegisteredIsDescribed)
  {
    for (const char *kind : {"box", "cone", "cylinder", "plate", "polygon", "sphere"})
      EXPECT_EQ(ShapeRegistry<2>::all().count(kind), 1u) << kind;
    for (const auto &[name, entry] : ShapeRegistry<2>::all())
      {
        const ShapeDescription &text = entry.description;
        EXPECT_EQ(text.name, name);
        EXPECT_FALSE(text.summary.empty()) << name;
        const auto has = [&](const std::string &key) {
          return std::any_of(text.parameters.begin(), text.parameters.end(),
                             [&](const auto &p) { return p.key == key; });
        };
        EXPECT_TRUE(has(text.position_key) && has(text.size_key)) << name;
      }
  }
} // namespace
