// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "remap_case.h"

#include <random>

/// Random states of mostly nothing, in which nodes give away more than they held.
namespace remap_case
{
  using whipple::BoundaryKind;

  constexpr double hottest = 0.01, fastest = 1.;

  /// 6 x 6 cells of the coarsest of three levels.
  inline Lattice
  unit_lattice(const Symmetry symmetry)
  {
    return {symmetry, {0., 0.}, 1. / 24., {6, 6}, 2};
  }

  /// Levels meet along a random line, which ends at sides of the domain.
  inline Mesh
  halved_mesh(const Symmetry symmetry, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> unit(0., 1.);
    const double                           angle = 6.28 * unit(random), offset = 0.3 * (unit(random) - 0.5);
    return graded_mesh(unit_lattice(symmetry), [&](const Point &x) {
      return std::max(0.3 * (std::cos(angle) * (x[0] - 0.5) + std::sin(angle) * (x[1] - 0.5) - offset), 0.);
    });
  }

  /// Mostly nothing, traces of all sizes, some full cells.
  inline void
  fill_sparsely(State<2> &state, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> unit(0., 1.);
    for (Index c = 0; c < state.n_cells(); ++c)
      {
        const double kind = unit(random), filled = kind < 0.4   ? 0.
                                                   : kind < 0.6 ? 1.
                                                                : std::pow(10., -9. * unit(random));
        const double share = unit(random) < 0.5 ? 1. : std::pow(10., -6. * unit(random));
        for (int m = 0; m < 2; ++m)
          {
            whipple::MaterialState &material = state.material[m];
            material.volume[c]               = state.volume[c] * filled * (m == 0 ? share : 1. - share);
            if (!(material.volume[c] > 0))
              continue;
            material.density[c] = 0.1 + 4. * unit(random);
            material.mass[c]    = material.density[c] * material.volume[c];
            material.energy[c]  = hottest * unit(random);
          }
      }
  }

  inline whipple::Boundaries<2>
  random_sides(const Symmetry symmetry, std::mt19937 &random)
  {
    const std::array<BoundaryKind, 4> kinds{BoundaryKind::transmitting, BoundaryKind::transmitting,
                                            BoundaryKind::pressure, BoundaryKind::reflecting};
    whipple::Boundaries<2>            sides = boundaries(BoundaryKind::transmitting);
    for (auto &side : sides)
      side.kind = kinds[random() % 4];
    if (symmetry == Symmetry::axisymmetric)
      sides[0].kind = BoundaryKind::reflecting;
    return sides;
  }

  /// A sample: two materials, random velocities and a drift outwards or inwards, which have moved the nodes.
  inline State<2>
  sparse_state(const Mesh &mesh, const whipple::Boundaries<2> &sides, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> unit(-fastest, fastest);
    State<2>                               state = empty_state(mesh, 2);
    const double                           drift = unit(random);
    for (Index n = 0; n < mesh.n_nodes; ++n)
      for (int d = 0; d < 2; ++d)
        state.velocity[d][n] = whipple::ruling_side<2>(sides, mesh.node_side[n], d) != whipple::none
                                   ? 0.
                                   : 0.5 * unit(random) + drift * (mesh.node_point[d][n] - 0.5);
    lump(mesh, state); // hanging velocities
    move_nodes(mesh, state, 0.44 / 24.);
    fill_sparsely(state, random);
    lump(mesh, state);
    return state;
  }
} // namespace remap_case
