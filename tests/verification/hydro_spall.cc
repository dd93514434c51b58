// SPDX-License-Identifier: LGPL-2.1-or-later
// Mechanics of spall by a triangular wave, on the moving mesh: doc/theory/exact_solid.md, "Spall".
#include "../figure.h"
#include "../unit/hydro_case.h"

#include <whipple/material/equilibrium_void_law.h>
#include <whipple/material/mie_grueneisen.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;
  constexpr double density = 2.785, sound = 0.5328; // aluminium 2024, without strength

  /// Velocity in a right-going compression pulse ahead of whose front at x = 0 nothing moves.
  struct Pulse
  {
    double peak = 5e-4; ///< cm/us
    double rise = 0.1;  ///< length, cm
    double fall = 0.6;  ///< length, cm

    double
    operator()(double x) const
    {
      return peak * std::max(0., std::min(-x / rise, 1. + (x + rise) / fall));
    }
  };

  struct Pulled
  {
    double fastest = 0; ///< free face, cm/us
    double slowest = 0; ///< free face after that, cm/us
    double depth   = 0; ///< of the first voids below the free face, cm
  };

  /// The pulse runs from the middle of a strip to its free face, 0.2 cm ahead, where it turns into tension.
  Pulled
  pull_back(const Pulse &pulse, double spall_strength, double cell)
  {
    constexpr double ahead = 0.2, end = 1.6;
    Material         aluminium;
    aluminium.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{density, sound, 1.338, 2.});
    aluminium.void_law = std::make_shared<EquilibriumVoidLaw>(spall_strength);
    const std::vector<Material> materials{aluminium};

    const double         lower = -pulse.rise - pulse.fall;
    const int            cells = static_cast<int>(std::lround((ahead - lower) / cell));
    const Lattice<2>     grid{Symmetry::planar, {{lower, 0.}}, cell, {{cells + 1, 1}}, 0};
    std::vector<CellKey> keys = uniform_keys(grid);
    keys.pop_back(); // so that the upper end is free
    const FlatMesh<2> mesh       = build(grid, keys);
    Boundaries<2>     boundaries = sides(BoundaryKind::reflecting);
    boundaries[0].kind           = BoundaryKind::transmitting;
    State<2> state               = make_state(mesh, materials);
    for (Index c = 0; c < mesh.n_cells; ++c) // P = rho c v
      fill(state, c, density * (1. + pulse(mesh.lower[0][c] + 0.5 * cell) / sound), 0.);
    set_velocity(mesh, state, [&](double x, double) { return Vector<2>{{pulse(x), 0.}}; });

    LagrangeStep<2> step(mesh, materials, boundaries, {});
    step.update_node_mass(state);
    Derived     derived = evaluate(step, state);
    const Index face    = mesh.cell_node[4 * (mesh.n_cells - 1) + 1];
    Pulled      pulled{0., 2. * pulse.peak, 0.};
    while (state.time < end)
      {
        step.advance(state, derived, step.time_step(state, derived).dt);
        step.evaluate(state, derived);
        const double velocity = state.velocity[0][face];
        pulled.fastest        = std::max(pulled.fastest, velocity);
        if (state.time > (ahead + pulse.rise) / sound)
          pulled.slowest = std::min(pulled.slowest, velocity);
        for (Index c = 0; c < mesh.n_cells && pulled.depth == 0; ++c)
          if (state.material[0].void_fraction[c] > 0)
            pulled.depth = ahead - (mesh.lower[0][c] + 0.5 * cell);
      }
    return pulled;
  }

  TEST(HydroSpall, PullBackAndPlaneOfATriangularWave)
  {
    const Pulse pulse;
    // the jump back up after the pull-back spreads over six cells and takes as much off its lowest point
    const double cell = 0.0003125;
    for (const double share : {0.5, 0.8})
      {
        // The tension at the depth x reaches 2 rho c u x / fall; when the face hears of it, it has slowed down by
        // 4 u x / fall.
        const double      strength = share * density * sound * pulse.peak;
        const Pulled      pulled   = pull_back(pulse, strength, cell);
        const std::string which = "spall at " + std::to_string(static_cast<int>(100. * share)) + " % of the stress: ";
        figure::expect_relative(which + "velocity of the free face, cm/us", pulled.fastest, 2. * pulse.peak, 0.02);
        figure::expect_relative(which + "pull-back, cm/us", pulled.fastest - pulled.slowest,
                                2. * strength / (density * sound), 0.02);
        figure::expect_relative(which + "depth of the first voids, cm", pulled.depth, 0.5 * share * pulse.fall, 0.02);
      }
  }
} // namespace
