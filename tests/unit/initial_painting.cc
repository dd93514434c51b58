// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies into cells: what round-off leaves of a cut stays out, and the cells receive what the bodies are.
#include "source_directory.h"

#include <whipple/error.h>
#include <whipple/initial/painted_bodies.h>
#include <whipple/ledger/totals.h>
#include <whipple/run/handover.h>
#include <whipple/scene/body_volume.h>
#include <whipple/scene/plate_shape.h>
#include <whipple/state/round_off_share.h>

#include <gtest/gtest.h>

#include <numbers>

namespace
{
  using namespace whipple;

  /// A scene at the start of its first stage.
  struct Painted
  {
    explicit Painted(const std::vector<std::string> &overrides)
      : Painted(read_problem<2>(source_directory() + "/prm/whipple_shield.prm", overrides))
    {
    }

    explicit Painted(Problem<2> read)
      : problem(std::move(read))
      , regridding(problem.scene, problem.layout)
      , domain{Forest<2>(MPI_COMM_SELF, problem.scene.lattice), nullptr, {}}
    {
      SharedDebris<2> waiting;
      Handover<2>(problem, regridding).enter(problem.scene.stages[0], nullptr, domain, ledger, waiting);
    }

    /// Least share of a cell that is filled at all.
    double
    least_share() const
    {
      double least = 1.;
      for (Index c = 0; c < domain.view->mesh.n_cells; ++c)
        if (const double volume = domain.state.material[0].volume[c]; volume > 0)
          least = std::min(least, volume / domain.state.volume[c]);
      return least;
    }

    Problem<2>    problem;
    Regridding<2> regridding;
    Domain<2>     domain;
    Ledger<2>     ledger;
  };

  const std::vector<std::string> coarse{"Mesh/Finest cell = 0.016 cm",
                                        "Mesh/Levels = 0",
                                        "Mesh/Refinement = uniform",
                                        "Geometry/Lower corner = 0 cm, -0.512 cm",
                                        "Geometry/Upper corner = 0.256 cm, 0.256 cm",
                                        "Effects/List = strength, voids"};

  std::vector<std::string>
  with_stage(std::vector<std::string> overrides, const std::string &bodies)
  {
    overrides.push_back("Stages/perforation/Introduces = " + bodies);
    return overrides;
  }

  std::vector<std::string>
  with(std::vector<std::string> more)
  {
    more.insert(more.begin(), coarse.begin(), coarse.end());
    more.push_back("Stages/List = perforation");
    for (const std::string &entry : more)
      if (entry.starts_with("Bodies/List = "))
        return with_stage(more, entry.substr(14));
    return more;
  }

  // The poles and the equator of the sphere touch mesh lines: cuts leave 3e-31 of a cell. The whole is pi D^3/6.
  TEST(Painting, ASphereThatTouchesMeshLinesHasNoSlivers)
  {
    const Painted painted(with({"Bodies/List = sphere"}));
    EXPECT_GT(painted.least_share(), round_off_share);
    EXPECT_NEAR(painted.ledger.introduced().mass, 2.785 * std::numbers::pi * 0.32 * 0.32 * 0.32 / 6., 1e-12);
  }

  // Faces on mesh lines that are no doubles, in cells far from the origin.
  TEST(Painting, FacesOnMeshLinesFillCells)
  {
    for (const char *front : {"-0.336 cm", "-0.016 cm", "0.144 cm"})
      {
        const Painted painted(with({"Bodies/List = bumper", std::string("Bodies/bumper/Front face = ") + front,
                                    "Bodies/bumper/Thickness = 0.08 cm"}));
        EXPECT_EQ(painted.least_share(), 1.) << front;
      }
  }

  /// A scene with a bumper thinner than a scene file may say.
  Problem<2>
  film(double thickness)
  {
    Problem<2> problem = read_problem<2>(
        source_directory() + "/prm/whipple_shield.prm",
        with({"Bodies/List = bumper", "Bodies/bumper/Front face = 0.001 cm", "Bodies/bumper/Thickness = 0.01 cm"}));
    Plate<2> plate                = *problem.scene.bodies[0].shape.as<Plate<2>>();
    plate.thickness               = thickness;
    problem.scene.bodies[0].shape = plate;
    return problem;
  }

  // A gap, a film or a bubble that is real stays what it is.
  TEST(Painting, AThinFilmIsNoSliver)
  {
    const Painted painted(film(1e-9));
    EXPECT_NEAR(painted.least_share(), 1e-9 / 0.016, 1e-12);
  }

  TEST(Painting, ABodyTooSmallForItsCellIsAnError)
  {
    try
      {
        const Painted painted(film(1e-13));
        FAIL() << "a film of 1e-11 of a cell is painted, or lost without a word";
      }
    catch (const ConservationError &error)
      {
        EXPECT_NE(std::string(error.what()).find("body 'bumper' has a volume of"), std::string::npos) << error.what();
      }
  }

  // The check must see what it is there for: a cell that a body did not reach, a body that came in with another state.
  TEST(Painting, WhatCellsDoNotReceiveIsNoticed)
  {
    const Scene<2> scene =
        read_problem<2>(source_directory() + "/prm/whipple_shield.prm", with({"Bodies/List = sphere, bumper"})).scene;
    const std::vector<std::size_t> bodies{0};
    const double                   volume = std::numbers::pi * 0.32 * 0.32 * 0.32 / 6.;
    const auto                     check  = [&](double received, double rounded) {
      PaintedBodies<2> books(scene, bodies);
      books.add(0, 0.25 * received, 0.);
      books.add(0, 0.75 * received, rounded);
      books.check(MPI_COMM_SELF);
    };
    EXPECT_NO_THROW(check(volume, 0.));
    EXPECT_NO_THROW(check(volume * (1. - 1e-7), 1e-7 * volume));
    EXPECT_THROW(check(volume * (1. - 1e-7), 0.), ConservationError);
    EXPECT_THROW(check(volume * (1. + 1e-7), 0.), ConservationError);
    EXPECT_THROW(check(0.5 * volume, 0.5 * volume), ConservationError);
    EXPECT_THROW(check(std::numeric_limits<double>::quiet_NaN(), 0.), ConservationError);

    ConservedTotals<2> entered;
    entered.mass           = 2.785 * volume;
    entered.momentum[1]    = entered.mass * 0.658;
    entered.kinetic_energy = 0.5 * entered.momentum[1] * 0.658;
    EXPECT_NO_THROW(check_entered<2>(scene, bodies, entered));
    for (double ConservedTotals<2>::*part :
         {&ConservedTotals<2>::mass, &ConservedTotals<2>::internal_energy, &ConservedTotals<2>::kinetic_energy})
      {
        ConservedTotals<2> wrong = entered;
        wrong.*part += 1e-5 * (part == &ConservedTotals<2>::mass ? entered.mass : entered.kinetic_energy);
        EXPECT_THROW(check_entered<2>(scene, bodies, wrong), ConservationError);
      }
    ConservedTotals<2> slow = entered;
    slow.momentum[1] *= 1. - 1e-5;
    EXPECT_THROW(check_entered<2>(scene, bodies, slow), ConservationError);
  }

  // Two bodies of different velocity share nodes, and one is held by a wall: momentum goes to the wall, energy to heat,
  // and the books know.
  TEST(Painting, WallsAndSharedNodesAreInTheBooks)
  {
    EXPECT_NO_THROW(Painted(
        with({"Bodies/List = sphere, bumper", "Geometry/Bottom = reflecting", "Geometry/Lower corner = 0 cm, -0.32 cm",
              "Bodies/sphere/Velocity = 0 km/s, -6 km/s", "Bodies/bumper/Velocity = 0 km/s, 1 km/s"})));
  }
} // namespace
