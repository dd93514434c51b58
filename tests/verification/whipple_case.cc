// SPDX-License-Identifier: LGPL-2.1-or-later
// The published single-bumper case from first contact to the wall, on cells twice the published scene's size.
#include "../figure.h"
#include "scene_run.h"

#include <whipple/ledger/totals.h>

#include <cmath>

namespace
{
  using namespace whipple;

  constexpr double impact_velocity = 0.658; // cm/us
  constexpr double sphere_diameter = 0.32, bumper_thickness = 0.081;

  double
  result(const Simulation<2> &simulation, const std::string &object, const std::string &quantity)
  {
    return std::get<double>(simulation.summary().results.at(object).at(quantity));
  }

  void
  expect_between(const std::string &what, double value, double low, double high)
  {
    char text[64];
    std::snprintf(text, sizeof text, "%.4g ... %.4g", low, high);
    figure::record(what, value, text);
    EXPECT_GE(value, low) << what;
    EXPECT_LE(value, high) << what;
  }

  /// Everything that came in is there, has left, or was dropped under a name.
  void
  expect_books_to_balance(const Simulation<2> &simulation)
  {
    const Ledger<2>   &ledger = simulation.ledger();
    ConservedTotals<2> found  = totals(simulation.domain().view->mesh, simulation.domain().state, MPI_COMM_SELF);
    found += ledger.left();
    for (const auto &[cause, booking] : ledger.bookings().by_cause())
      if (booking.dropped)
        {
          EXPECT_GT(booking.dropped->mass, 0.) << cause;
          found += *booking.dropped;
        }
    EXPECT_TRUE(ledger.bookings().of("not debris").dropped.has_value()); // the plate and what it throws back

    const ConservedTotals<2> &introduced = ledger.introduced();
    figure::expect_at_most("mass over the whole chain, relative", found.mass / introduced.mass - 1., 1e-10);
    figure::expect_at_most("axial momentum over the whole chain, relative",
                           found.momentum[1] / introduced.momentum[1] - 1., 1e-10);
    figure::expect_at_most("total energy over the whole chain, of the initial kinetic energy",
                           (found.total_energy() - introduced.total_energy()) / introduced.kinetic_energy, 1e-10);
    // the energy of the sphere's flight; what it shares nodes with at the contact makes some of it heat from the start
    const double flight = 0.5 * introduced.momentum[1] * impact_velocity;
    EXPECT_NEAR(introduced.total_energy() / flight, 1., 1e-12);
  }
} // namespace

TEST(WhippleCase, FromFirstContactToTheWall)
{
  const auto simulation = verification::run(
      "whipple_shield.prm", {"Mesh/Finest cell = 0.008 cm", "Output/Fields interval = none"}, "whipple_case");
  const auto debris = [&](const std::string &quantity) { return result(*simulation, "debris", quantity); };

  EXPECT_TRUE(std::get<bool>(simulation->summary().results.at("bumper").at("perforated")));
  figure::expect_relative("bumper hole, cm", result(*simulation, "bumper", "hole_diameter_cm"), 0.68, 0.15);

  // the cloud at 1.5 us
  EXPECT_NEAR(debris("handover_time_us"), 1.5, 1e-9);
  figure::expect_at_most("radius of 95 % of the debris mass at 1.5 us, cm", debris("handover_radius_95_cm"), 0.5);
  expect_between("95 % of the debris mass at 1.5 us within, cm behind the bumper", debris("handover_depth_95_cm"), 0.5,
                 0.8);
  figure::expect_relative("velocity of the in-line debris, of impact",
                          debris("handover_inline_mass_velocity_cm_per_us") / impact_velocity,
                          1. / (1. + 1.5 * bumper_thickness / sphere_diameter), 0.05);

  // and when it reaches the wall
  expect_between("front velocity at arrival, of impact", debris("leading_edge_velocity_cm_per_us") / impact_velocity,
                 0.85, 1.03);
  EXPECT_NEAR(debris("leading_edge_cm"), 10.2, 0.3);

  expect_books_to_balance(*simulation);
}
