// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that start from expressions, against exact solutions and integrals by hand; and turned and angular bodies in
// their cells.
#include "source_directory.h"

#include <whipple/error.h>
#include <whipple/ledger/totals.h>
#include <whipple/run/handover.h>
#include <whipple/scene/expression.h>
#include <whipple/scene/polygon_shape.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

namespace
{
  using namespace whipple;
  using std::numbers::pi;

  /// The state at the start of a scene's first stage.
  struct Start
  {
    explicit Start(Problem<2> read)
      : problem(std::move(read))
      , regridding(scene, problem.layout)
      , domain{Forest<2>(MPI_COMM_SELF, scene.lattice), nullptr, {}}
    {
      SharedDebris<2> waiting;
      Handover<2>(problem, regridding).enter(scene.stages[0], nullptr, domain, ledger, waiting);
    }

    Problem<2>      problem;
    const Scene<2> &scene = problem.scene;
    Regridding<2>   regridding;
    Domain<2>       domain;
    Ledger<2>       ledger;
  };

  /// One body of aluminium in a square of 2 cm, or in the half of it that turns about the axis.
  Problem<2>
  problem_of(const std::string &symmetry, const std::string &body, const std::vector<std::string> &overrides = {})
  {
    const bool        planar = symmetry == "planar";
    const std::string path   = testing::TempDir() + "whipple_expressions.prm";
    std::ofstream(path) << "subsection Geometry\n set Symmetry = " << symmetry
                        << "\n set Lower corner = " << (planar ? "-1 cm, -1 cm" : "0 cm, -1 cm")
                        << "\n set Upper corner = 1 cm, 1 cm\n set Left = " << (planar ? "transmitting" : "reflecting")
                        << "\nend\nsubsection Mesh\n set Finest cell = 0.03125 cm\n set Levels = 2\nend\n"
                           "subsection Materials\n set List = aluminium\n subsection aluminium\n"
                           "  set Library = aluminium 2024-T4\n end\nend\n"
                           "subsection Bodies\n set List = body\n subsection body\n set Material = aluminium\n"
                        << body
                        << " end\nend\nsubsection Stages\n set List = s\n subsection s\n set End = 1 us\n end\nend\n";
    const Problem<2> problem = read_problem<2>(path, overrides);
    std::remove(path.c_str());
    return problem;
  }

  const std::string square = " set Shape = box\n set Lower corner = 0 cm, 0 cm\n set Upper corner = 1 cm, 1 cm\n";

  // The vortex of the library and the same formulas as expressions: the same cells and nodes.
  TEST(InitialExpressions, AVortexInWordsIsTheVortexOfTheLibrary)
  {
    // density and pressure 1 far away, exponent 1.4, radius 1, speed 0.5 (doc/theory/exact_smooth.md)
    const std::string file = source_directory() + "/prm/verification/isentropic_vortex.prm";
    const std::string body = "Bodies/gas/", cold = "(1 - 0.25*exp(1 - x^2 - y^2)/7)",
                      turn = "0.5*exp(0.5*(1 - x^2 - y^2))";
    const std::vector<std::string> words{body + "Initial state = uniform",
                                         body + "Coordinate unit = cm",
                                         body + "Density expression = " + cold + "^2.5",
                                         body + "Density unit = g/cm^3",
                                         body + "Specific energy expression = 2.5*" + cold,
                                         body + "Specific energy unit = Mbar cm^3/g",
                                         body + "Velocity expression = -y*" + turn + "; x*" + turn,
                                         body + "Velocity unit = cm/us"};
    const Start                    exact(read_problem<2>(file)), spoken(read_problem<2>(file, words));
    const MaterialState           &a = exact.domain.state.material[0], &b = spoken.domain.state.material[0];
    ASSERT_EQ(exact.domain.view->mesh.key, spoken.domain.view->mesh.key);
    double largest = 0;
    for (Index c = 0; c < exact.domain.view->mesh.n_cells; ++c)
      largest = std::max({largest, std::abs(a.mass[c] / b.mass[c] - 1.), std::abs(a.energy[c] / b.energy[c] - 1.)});
    for (Index n = 0; n < exact.domain.view->mesh.n_nodes; ++n)
      for (int d = 0; d < 2; ++d)
        largest = std::max(largest, std::abs(exact.domain.state.velocity[d][n] - spoken.domain.state.velocity[d][n]));
    EXPECT_LT(largest, 1e-14);
  }

  // rho = 1 + z, v_z = z, e = r z: integrals by hand over a unit square, and over the cylinder it sweeps out.
  TEST(InitialExpressions, MassEnergyAndMomentumAreTheIntegrals)
  {
    for (const bool planar : {true, false})
      {
        const std::string        r = planar ? "x" : "r", z = planar ? "y" : "z";
        const Start              start(problem_of(planar ? "planar" : "axisymmetric",
                                                  square + " set Density expression = 2 + " + z +
                                                      "\n set Density unit = g/cm^3\n set Coordinate unit = cm\n" +
                                                      " set Specific energy expression = " + r + "*" + z +
                                                      "\n set Specific energy unit = MJ/kg\n" + " set Velocity expression = 0; 3*" +
                                                      z + "\n set Velocity unit = km/s\n"));
        const ConservedTotals<2> sum  = totals(start.domain.view->mesh, start.domain.state, MPI_COMM_SELF);
        const double             area = planar ? 1. : pi, first = planar ? 0.5 : 2. * pi / 3.; // int 1, int r
        EXPECT_NEAR(sum.mass, 2.5 * area, 1e-13);
        EXPECT_NEAR(sum.internal_energy, 0.01 * first * (1. + 1. / 3.), 1e-6 * 0.01 * first); // heat of shared nodes
        // nodes carry the velocity at their place: second order in the cell size
        EXPECT_NEAR(sum.momentum[1], 0.3 * (1. + 1. / 3.) * area, 3e-4 * area);
        EXPECT_NEAR(start.scene.bodies[0].density, 2.5, 1e-3);
        EXPECT_NEAR(start.scene.bodies[0].velocity[1], 0.3 * (4. / 3.) / 2.5, 1e-3);
      }
  }

  // A jump across cells, straight and oblique: 1 % of a cell's jump, wherever it lies in it.
  TEST(InitialExpressions, JumpsAreFoundInsideCells)
  {
    for (const double at : {0.5, 0.5 + 0.001, 0.5 + 0.01, 0.5 + 0.0155, 0.5 + 0.03})
      {
        const auto mass = [&](const std::string &condition) {
          const Start start(
              problem_of("planar", square + " set Density expression = if(" + condition +
                                       ", 3, 2)\n set Density unit = g/cm^3\n set Coordinate unit = cm\n"));
          return totals(start.domain.view->mesh, start.domain.state, MPI_COMM_SELF).mass;
        };
        const double cell = 0.03125;
        EXPECT_NEAR(mass("y < " + std::to_string(at)), 2. + at, 0.011 * cell) << at;
        EXPECT_NEAR(mass("x + y < " + std::to_string(at)), 2. + 0.5 * at * at, 0.011 * cell) << at;
      }
  }

  // In another unit the same state.
  TEST(InitialExpressions, UnitsOfCoordinatesAndValues)
  {
    const auto density = [](const std::string &keys) {
      const Start start(problem_of("planar", square + keys));
      return start.domain.state.material[0].density;
    };
    const auto cm =
        density(" set Density expression = 2.5 + y^2\n set Density unit = g/cm^3\n set Coordinate unit = cm\n");
    const auto mm =
        density(" set Density expression = 2500 + 10*y^2\n set Density unit = kg/m^3\n set Coordinate unit = mm\n");
    ASSERT_EQ(cm.size(), mm.size());
    for (std::size_t c = 0; c < cm.size(); ++c)
      EXPECT_NEAR(cm[c], mm[c], 1e-14);
  }

  // A formula that means nothing outside of the body does not spoil the cells that the body cuts.
  TEST(InitialExpressions, OnlyTheBodyCounts)
  {
    const Start start(problem_of("planar",
                                 " set Shape = sphere\n set Center = 0.1 cm, 0.05 cm\n set Diameter = 0.9 cm\n"
                                 " set Density expression = 2.7 + sqrt(0.2026 - (x-0.1)^2 - (y-0.05)^2)\n"
                                 " set Density unit = g/cm^3\n set Coordinate unit = cm\n"
                                 " set Velocity expression = 0.1/(x+0.40)*0 ; sqrt(0.2026-(x-0.1)^2-(y-0.05)^2)\n"
                                 " set Velocity unit = km/s\n"));
    // int sqrt(a^2 - r^2) over r < R
    const double a2 = 0.2026, R2 = 0.45 * 0.45, integral = 2. * pi / 3. * (std::pow(a2, 1.5) - std::pow(a2 - R2, 1.5));
    const ConservedTotals<2> sum = totals(start.domain.view->mesh, start.domain.state, MPI_COMM_SELF);
    EXPECT_NEAR(sum.mass, 2.7 * pi * R2 + integral, 2e-4);
    for (const double v : start.domain.state.velocity[1])
      EXPECT_TRUE(std::isfinite(v));
  }

  // Mass L d rho, momentum m v: an oblique plate on square cells.
  TEST(InitialShapes, ATurnedPlateBringsItsMassAndMomentum)
  {
    const Start  start(problem_of("planar", " set Shape = plate\n set Front face = -0.05 cm\n set Thickness = 0.1 cm\n"
                                             " set Half width = 0.6 cm\n set Rotation = 30 deg\n"
                                             " set Density = 2.7 g/cm^3\n set Velocity = 1 km/s, -2 km/s\n"));
    const double mass            = 2.7 * 0.1 * 1.2;
    const ConservedTotals<2> sum = totals(start.domain.view->mesh, start.domain.state, MPI_COMM_SELF);
    EXPECT_NEAR(sum.mass, mass, 1e-13);
    EXPECT_NEAR(sum.momentum[0], 0.1 * mass, 1e-13);
    EXPECT_NEAR(sum.momentum[1], -0.2 * mass, 1e-13);
    EXPECT_NEAR(sum.kinetic_energy, 0.5 * mass * 0.05, 1e-13);
  }

  TEST(InitialShapes, AConeAndAPolygonOfRevolutionBringTheirMass)
  {
    const Start cone(problem_of("axisymmetric", " set Shape = cone\n set Base center = 0 cm, -0.33 cm\n"
                                                " set Base diameter = 0.77 cm\n set Top diameter = 0.21 cm\n"
                                                " set Length = 0.55 cm\n set Density = 2.7 g/cm^3\n"));
    EXPECT_NEAR(cone.ledger.introduced().mass, 2.7 * pi / 3. * 0.55 * (0.385 * 0.385 + 0.385 * 0.105 + 0.105 * 0.105),
                1e-13);

    // a triangle off the axis: its area times the way of its centroid (Pappus)
    const Start  ring(problem_of("axisymmetric", " set Shape = polygon\n set Density = 2.7 g/cm^3\n"
                                                  " set Corners = 3 mm, -2 mm; 8.1 mm, 0 mm; 4 mm, 3.3 mm\n"));
    const double area = 0.5 * (0.51 * 0.53 - 0.1 * 0.2);
    EXPECT_NEAR(ring.ledger.introduced().mass, 2.7 * area * 2. * pi * (0.3 + 0.81 + 0.4) / 3., 1e-13);
  }

  TEST(InitialShapes, CornersOfAFileAreThoseOfTheScene)
  {
    const std::string name = testing::TempDir() + "whipple_corners.txt";
    std::ofstream(name) << "# r z\nmm\tmm\n3, -2 # first\n8.1 0\n\n4,3.3\n";
    const auto body = [](const std::string &corners) {
      return " set Shape = polygon\n set Density = 2.7 g/cm^3\n set " + corners + "\n";
    };
    const Scene<2> listed = problem_of("axisymmetric", body("Corners = 3 mm, -2 mm; 8.1 mm, 0 mm; 4 mm, 3.3 mm")).scene;
    const Scene<2> read   = problem_of("axisymmetric", body("Corners file = whipple_corners.txt")).scene;
    const auto    &corners = listed.bodies[0].shape.as<PolygonShape>()->corners();
    EXPECT_EQ(corners.size(), 3u);
    EXPECT_EQ(corners, read.bodies[0].shape.as<PolygonShape>()->corners());
    // the parameters in force list them: no file is needed to read them back
    EXPECT_NE(read.effective_parameters.find("= 0.3 cm, -0.2 cm; 0.81 cm, 0 cm; 0.4 cm, 0.33 cm"), std::string::npos);
    EXPECT_EQ(read.effective_parameters.find("whipple_corners"), std::string::npos);
    std::remove(name.c_str());
  }

  TEST(InitialExpressions, WhatCannotBeMeantIsRefused)
  {
    for (const char *text : {"", "1+", "0.1*sn(r)", "x", "rand()", "r = 1", "1, 2", "rand_seed(3)", "(r"})
      EXPECT_THROW(Expression(text, Symmetry::axisymmetric, 1., 1.), InputError) << text;
    for (const char *text : {"1", "if(r == 1, 2, 3)", "r <= 1", "max(r, z)", "r^2*exp(-z)*sin(pi*r)", "z != 1"})
      EXPECT_NO_THROW(Expression(text, Symmetry::axisymmetric, 1., 1.)) << text;
    EXPECT_EQ(Expression("3*r + z", Symmetry::axisymmetric, 0.5, 0.1)({{0.2, 0.1}}), 3.5);
  }
} // namespace
