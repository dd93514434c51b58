// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies that fly through vacuum over the adaptive, regridded mesh in Eulerian mode: nothing may happen to them.
#include "../connected_pieces.h"
#include "../figure.h"
#include "scene_run.h"

#include <whipple/material/material_library.h>
#include <whipple/scene/body_volume.h>
#include <whipple/scene/plate_shape.h>
#include <whipple/scene/sphere_shape.h>

#include <algorithm>

namespace
{
  using namespace whipple;
  using figure::expect_at_most;

  /// A run and where its only body would be had nothing happened to it.
  struct Flight
  {
    std::unique_ptr<Simulation<2>> simulation;
    Shape<2>                       shape; ///< at the end

    const FlatMesh<2> &
    mesh() const
    {
      return simulation->domain().view->mesh;
    }
    const State<2> &
    state() const
    {
      return simulation->domain().state;
    }

    /// sum |V - V_exact| over all cells, the body's volume.
    std::pair<double, double>
    shape_difference() const
    {
      double difference = 0, inside = 0;
      for (Index c = 0; c < mesh().n_cells; ++c)
        {
          const Vector<2> lower{{mesh().lower[0][c], mesh().lower[1][c]}};
          const Vector<2> upper{{lower[0] + mesh().size[c], lower[1] + mesh().size[c]}};
          const double    exact = body_volume<2>(mesh().symmetry, shape, lower, upper);
          difference += std::abs(state().material[0].volume[c] - exact);
          inside += exact;
        }
      const Box<2> all    = extent(shape);
      const double volume = body_volume<2>(mesh().symmetry, shape, {{0., all.lower[1]}}, all.upper);
      return {difference + volume - inside, volume};
    }
  };

  /// What holds for any body in flight.
  void
  expect_undisturbed(const std::string &body, const Flight &flight, double allowed_shape_error)
  {
    const ConservedTotals<2> before = flight.simulation->ledger().introduced();
    const ConservedTotals<2> after  = totals(flight.mesh(), flight.state(), MPI_COMM_SELF);
    expect_at_most(body + " in flight: mass, relative change", after.mass / before.mass - 1., 1e-13);
    expect_at_most(body + " in flight: axial momentum, relative change", after.momentum[1] / before.momentum[1] - 1.,
                   1e-12);
    expect_at_most(body + " in flight: internal energy gained / kinetic energy",
                   (after.internal_energy - before.internal_energy) / before.kinetic_energy, 1e-8);
    EXPECT_EQ(flight.simulation->ledger().left().mass, 0.);
    EXPECT_EQ(connected_pieces(flight.mesh(), flight.state(), 1e-6), 1);
    expect_at_most(body + " in flight: connected pieces", connected_pieces(flight.mesh(), flight.state(), 0.), 1);
    const auto [difference, volume] = flight.shape_difference();
    expect_at_most(body + " in flight: shape error, sum of abs(V - V exact) / V", difference / volume,
                   allowed_shape_error);
  }

  TEST(SceneTranslation, SphereOverTenDiameters)
  {
    const Flight flight{verification::run("verification/sphere_translation.prm", {}, "sphere_translation"),
                        Sphere<2>{{{0., 3.2}}, 0.32}};
    expect_undisturbed("sphere", flight, 0.02);
  }

  TEST(SceneTranslation, ThinPlateIsNeitherSpalledNorStrainedNorHeated)
  {
    const Flight flight{verification::run("verification/plate_translation.prm", {}, "plate_translation"),
                        Plate<2>{3.183, 0.04, 0.32}};
    expect_undisturbed("plate", flight, 0.02);
    const MaterialState &m   = flight.state().material[0];
    const auto           top = [](const std::vector<double> &v) { return *std::max_element(v.begin(), v.end()); };
    expect_at_most("plate in flight: void fraction, largest", top(m.void_fraction), 0.);
    expect_at_most("plate in flight: plastic strain, largest", top(m.fields[flight.state().index.plastic_strain].value),
                   0.);
    expect_at_most("plate in flight: heating, largest, K",
                   temperature_rise(find_material("aluminium 2024-T4"), top(m.energy)), 1.);
  }
} // namespace
