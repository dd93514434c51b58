// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of Lagrangian stages that run into one another, and meshes that fold: no energy from nowhere.
#include "../figure.h"
#include "scene_run.h"

#include <fstream>
#include <sstream>

namespace
{
  using namespace whipple;
  using figure::expect_at_most;

  std::unique_ptr<Simulation<2>>
  run_contact(const std::string &scene, const std::vector<std::string> &overrides, const std::string &folder)
  {
    return verification::run("../tests/verification/scenes/" + scene, overrides, folder);
  }

  /// A column of statistics.csv whose name begins so.
  std::vector<double>
  column(const std::string &folder, const std::string &name)
  {
    std::ifstream       file("verification_output/" + folder + "/statistics.csv");
    std::string         line, cell;
    std::vector<double> values;
    int                 wanted = -1;
    for (bool first = true; std::getline(file, line); first = false)
      {
        std::istringstream cells(line);
        for (int i = 0; std::getline(cells, cell, ','); ++i)
          if (first && cell.rfind(name, 0) == 0)
            wanted = i;
          else if (!first && i == wanted)
            values.push_back(std::stod(cell));
      }
    return values;
  }

  /// Largest kinetic energy over the first.
  double
  kinetic_growth(const std::string &folder)
  {
    const std::vector<double> kinetic = column(folder, "kinetic");
    return kinetic.empty() ? HUGE_VAL : *std::max_element(kinetic.begin(), kinetic.end()) / kinetic.front();
  }

  double
  event(const Simulation<2> &simulation, const std::string &what)
  {
    double number = 0;
    for (const auto &[cause, booking] : simulation.ledger().bookings().by_cause())
      if (booking.event && cause.find(what) != std::string::npos)
        number += booking.event->number;
    return number;
  }
} // namespace

// 0.5 km/s behind 0.3 km/s: they meet at 5 us. Together they have the mean velocity; kinetic energy goes down by
// m/2 (0.2 km/s)^2/2 per pair of equal masses: from 0.17 to 0.16 of m (km/s)^2.
TEST(SceneContact, FragmentsThatCatchUpMoveOnTogether)
{
  const std::string folder     = "contact_fragments";
  const auto        simulation = run_contact("overlapping_fragments.prm", {}, folder);
  expect_at_most("overlapping fragments: largest kinetic energy over the first", kinetic_growth(folder), 1. + 1e-9);
  EXPECT_GT(event(*simulation, "joined"), 0.);
  const auto sum = totals(simulation->domain().view->mesh, simulation->domain().state, MPI_COMM_SELF);
  const auto in  = simulation->ledger().introduced();
  EXPECT_NEAR(sum.momentum[1], in.momentum[1], 1e-12 * in.momentum[1]);
  // one piece that flies on, hardly warmer
  EXPECT_LT(sum.kinetic_energy, 0.97 * in.kinetic_energy);
  EXPECT_GT(sum.kinetic_energy, 0.16 / 0.17 * in.kinetic_energy * (1. - 1e-9));
}

// Halves of a full box at +- 3 km/s: bonded, graded and as fragments. Nodes that both halves share have lost their
// motion when they were painted; that heat drives fragments, which nothing holds, apart: 3 % before any contact.
TEST(SceneContact, AMeshThatFoldsMakesNoEnergy)
{
  for (const std::string cohesion : {"bonded", "graded", "fragments"})
    {
      const std::string folder     = "contact_tangling_" + cohesion;
      const auto        simulation = run_contact("bonded_tangling.prm", {"Stages/s/Cohesion = " + cohesion}, folder);
      const bool        free       = cohesion == "fragments";
      expect_at_most("sliding halves, " + cohesion + ": largest kinetic energy over the first", kinetic_growth(folder),
                     free ? 1.04 : 1. + 1e-9);
      const std::vector<double> internal = column(folder, "internal");
      ASSERT_FALSE(internal.empty());
      EXPECT_GT(*std::min_element(internal.begin(), internal.end()),
                free ? 0.85 * internal.front() : internal.front() - 1e-6);
      EXPECT_GE(simulation->domain().state.time, 6. - 1e-9);
      if (cohesion == "bonded") // graded cells break by their shape before
        {
          EXPECT_GT(event(*simulation, "freed"), 0.);
        }
    }
}
