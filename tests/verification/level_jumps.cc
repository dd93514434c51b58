// SPDX-License-Identifier: LGPL-2.1-or-later
// Pulses through places where the mesh changes its level: what comes back, against a mesh of one level.
#include "../unit/hydro_case.h"

#include <whipple/material/mie_grueneisen.h>
#include <whipple/remap/directional_remap.h>

#include <cstdio>
#include <map>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  constexpr double density = 2.785, sound = 0.5328, slope = 1.338, coarse = 0.08;
  constexpr int    roots = 40;

  std::vector<Material>
  aluminium()
  {
    Material material;
    material.eos = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{density, sound, slope, 2.});
    return {material};
  }

  /// One row of root cells. Those below `place` have level `below`, those from there on `above`; in between the levels
  /// fall as fast as neighbours allow, as the forest balances them.
  std::vector<CellKey>
  row(int levels, int place, int below, int above)
  {
    std::vector<CellKey>                                    keys;
    const std::function<void(int, const LatticePoint<2> &)> visit = [&](int level, const LatticePoint<2> &point) {
      const int  extent = 1 << (levels - level), jump = place << levels;
      const bool upper = point[0] >= jump;
      const int  own = upper ? above : below, other = upper ? below : above;
      const int  distance = upper ? point[0] - jump : jump - point[0] - extent;
      if (level >= own && (level >= other - 1 || distance >= extent))
        return keys.push_back(make_key<2>(level, point));
      for (int k = 0; k < 4; ++k)
        visit(level + 1, {point[0] + (k & 1) * extent / 2, point[1] + (k >> 1) * extent / 2});
    };
    for (int i = 0; i < roots; ++i)
      visit(0, {i << levels, 0});
    return keys;
  }

  struct Row
  {
    Row(int levels, int place, int below, int above, double peak, double half)
      : materials(aluminium())
      , grid{Symmetry::planar, {{0., 0.}}, coarse / (1 << levels), {{roots, 1}}, levels}
      , mesh(build(grid, row(levels, place, below, above)))
      , boundaries(sides(BoundaryKind::reflecting))
      , state(make_state(mesh, materials))
      , step(mesh, materials, boundaries, {})
      , remap(mesh, boundaries, {})
    {
      const double centre = 0.25 * roots * coarse;
      const auto   hump   = [=](double x) {
        const double s = (x - centre) / half;
        return std::abs(s) < 1. ? peak * std::pow(std::cos(1.570796326794897 * s), 2) : 0.;
      };
      for (Index c = 0; c < mesh.n_cells; ++c)
        {
          double u = 0; // mean over the cell
          for (int i = 0; i < 16; ++i)
            u += hump(mesh.lower[0][c] + (i + 0.5) / 16. * mesh.size[c]) / 16.;
          const double speed = sound + slope * u;
          fill(state, c, density * speed / (speed - u), 0.5 * u * u);
        }
      set_velocity(mesh, state, [&](double x, double) { return Vector<2>{{hump(x), 0.}}; });
      step.update_node_mass(state);
      step.evaluate(state, derived);
    }

    void
    advance(double dt)
    {
      step.advance(state, derived, dt);
      remap.begin(state);
      for (int i = 0; i < 2; ++i)
        remap.sweep(state, (steps + i) % 2);
      ++steps;
      remap.finish(state);
      step.evaluate(state, derived);
    }

    double
    largest_below(double place) const
    {
      double largest = 0;
      for (Index c = 0; c < mesh.n_cells; ++c)
        if (mesh.lower[0][c] < place)
          largest = std::max(largest, std::abs(derived.material[0].pressure[c]));
      return largest;
    }

    std::vector<Material> materials;
    Lattice<2>            grid;
    FlatMesh<2>           mesh;
    Boundaries<2>         boundaries;
    State<2>              state;
    LagrangeStep<2>       step;
    Derived               derived;
    DirectionalRemap<2>   remap;
    int                   steps = 0;
  };

  /// Largest pressure that runs back before the place where the levels change, over that of the pulse.
  double
  reflection(int levels, int below, int above, double peak, double cells)
  {
    constexpr int place = roots / 2;
    Row           pulse(levels, place, below, above, peak, cells * coarse),
        reference(levels, place, below, below, peak, cells * coarse);
    const double start = reference.largest_below(1e9);
    // until the middle of what comes back is where the pulse started
    const double end = 0.5 * roots * coarse / sound;
    while (end - pulse.state.time > 1e-12)
      {
        const double dt =
            std::min({pulse.step.time_step(pulse.state, pulse.derived).dt,
                      reference.step.time_step(reference.state, reference.derived).dt, end - pulse.state.time});
        pulse.advance(dt);
        reference.advance(dt);
      }
    double largest = 0;
    // cells below the place are the same in both
    std::map<CellKey, double> there;
    for (Index c = 0; c < reference.mesh.n_cells; ++c)
      there[reference.mesh.key[c]] = reference.derived.material[0].pressure[c];
    for (Index c = 0; c < pulse.mesh.n_cells; ++c)
      if (pulse.mesh.lower[0][c] < (place - 2) * coarse && there.count(pulse.mesh.key[c]))
        largest = std::max(largest, std::abs(pulse.derived.material[0].pressure[c] - there.at(pulse.mesh.key[c])));
    return largest / start;
  }

  // What comes back is the scheme's dispersion on the coarse side, R = (Z_fine - Z_coarse) / (Z_fine + Z_coarse) with
  // Z = rho c cos(k h / 2), whatever the number of levels (doc/theory/refinement.md): below 1 % needs eight cells.
  TEST(LevelJumps, PulsesComeBackLittle)
  {
    // of 1, 2, 3, 4, 6, 8 cells of the coarse side at half height
    constexpr std::array<double, 6> widths{1., 2., 3., 4., 6., 8.}, bounds{0.25, 0.12, 0.06, 0.025, 0.014, 0.009};
    for (const double peak : {1e-5, 0.0094})
      for (int levels = 1; levels <= 3; ++levels)
        for (const bool outwards : {true, false})
          {
            std::printf("  u %.0e cm/us, %d level%s, %s, %%:", peak, levels, levels > 1 ? "s" : " ",
                        outwards ? "fine to coarse" : "coarse to fine");
            for (std::size_t i = 0; i < widths.size(); ++i)
              {
                const double r = outwards ? reflection(levels, levels, 0, peak, widths[i])
                                          : reflection(levels, 0, levels, peak, widths[i]);
                std::printf("  %g cells %.2f", widths[i], 100. * r);
                EXPECT_LT(r, bounds[i]);
              }
            std::printf("\n");
          }
  }
} // namespace
