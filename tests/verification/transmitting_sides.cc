// SPDX-License-Identifier: LGPL-2.1-or-later
// What comes back from transmitting sides: the difference to a domain twice as long, whose side no wave has reached.
#include "../unit/hydro_case.h"

#include <whipple/material/ideal_gas.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>
#include <whipple/remap/directional_remap.h>

#include <cstdio>
#include <optional>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  constexpr double density = 2.785, sound = 0.5328, slope = 1.338, shear = 0.276, yield = 0.003;

  std::vector<Material>
  aluminium(bool strength)
  {
    Material material;
    material.eos = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{density, sound, slope, 2.});
    if (strength)
      material.strength = std::make_shared<PerfectlyPlastic>(shear, yield);
    return {material};
  }

  std::vector<Material>
  gas()
  {
    Material material;
    material.eos = std::make_shared<IdealGas>(1.4, 1.);
    return {material};
  }

  enum class Mode
  {
    lagrangian,
    eulerian
  };

  /// A box of square cells between smooth walls but for the sides it is given.
  struct Box
  {
    Box(Mode mode, std::array<int, 2> cells, double size, const std::vector<Material> &box_materials,
        const Boundaries<2> &box_sides)
      : materials(box_materials)
      , boundaries(box_sides)
      , grid{Symmetry::planar, {{0., 0.}}, size, cells, 0}
      , mesh(build(grid, uniform_keys(grid)))
      , state(make_state(mesh, materials))
      , step(mesh, materials, boundaries, {})
    {
      if (mode == Mode::eulerian)
        remap.emplace(mesh, boundaries, RemapParameters{});
    }

    /// Set density, energy and velocity everywhere.
    void
    fill_with(const std::function<std::array<double, 4>(double, double)> &values)
    {
      const double half = 0.5 * grid.spacing;
      for (Index c = 0; c < mesh.n_cells; ++c)
        {
          const auto v = values(mesh.lower[0][c] + half, mesh.lower[1][c] + half);
          fill(state, c, v[0], v[1]);
        }
      set_velocity(mesh, state, [&](double x, double y) {
        const auto v = values(x, y);
        return Vector<2>{{v[2], v[3]}};
      });
      step.update_node_mass(state);
      step.evaluate(state, derived);
    }

    double
    time_step()
    {
      const double motion = step.time_step(state, derived).dt;
      return remap ? std::min(motion, remap->time_step(state).dt) : motion;
    }

    void
    advance(double dt)
    {
      const auto report = step.advance(state, derived, dt);
      given += report.boundary_work;
      if (!remap)
        return step.evaluate(state, derived);
      remap->begin(state);
      for (int i = 0; i < 2; ++i)
        for (const auto &side : remap->sweep(state, (steps + i) % 2).side)
          given -= side.internal + side.kinetic;
      ++steps;
      remap->finish(state);
      step.evaluate(state, derived);
    }

    /// Normal stress along axis 0, as a pressure.
    double
    stress(Index cell) const
    {
      const MaterialState &m = state.material[0];
      return derived.material[0].pressure[cell] - (m.fields.empty() ? 0. : m.fields[0].value[cell]);
    }

    std::vector<Material>              materials;
    Boundaries<2>                      boundaries;
    Lattice<2>                         grid;
    FlatMesh<2>                        mesh;
    State<2>                           state;
    LagrangeStep<2>                    step;
    Derived                            derived;
    std::optional<DirectionalRemap<2>> remap;
    int                                steps = 0;
    double                             given = 0; ///< energy by the sides, Mbar cm^3
  };

  using Start = std::function<std::array<double, 4>(double, double)>;

  /// What a case is: a column along axis 0, or a square.
  struct Case
  {
    std::vector<Material> materials;
    Boundaries<2>         sides;
    Start                 start;
    std::array<int, 2>    cells;
    double                end;
  };

  /// Cells at the side that count as the side itself: a shock is half as wide.
  constexpr int margin = 8;

  /// Difference in stress to a domain twice as long, over the largest stress above the first one that was there.
  struct Reflection
  {
    double back    = 0; ///< largest at any time, `margin` cells from the side and further in
    double at_side = 0; ///< largest at any time, anywhere
    double last    = 0; ///< largest at the end, anywhere
    double leak    = 0; ///< energy lost, over what crossed the side
  };

  Reflection
  reflection(Mode mode, const Case &it)
  {
    constexpr double size   = 0.01;
    const bool       square = it.cells[1] > 1;
    Box              box(mode, it.cells, size, it.materials, it.sides);
    Box reference(mode, {{2 * it.cells[0], square ? 2 * it.cells[1] : it.cells[1]}}, size, it.materials, it.sides);
    for (Box *b : {&box, &reference})
      b->fill_with(it.start);
    const double energy = totals(box.state).energy;
    const double rest   = box.stress(it.cells[0] * it.cells[1] - 1);
    double       peak   = 0;
    Reflection   result;
    while (it.end - box.state.time > 1e-12)
      {
        const double dt = std::min({box.time_step(), reference.time_step(), it.end - box.state.time});
        box.advance(dt);
        reference.advance(dt);
        result.last = 0;
        for (int j = 0; j < it.cells[1]; ++j)
          for (int i = 0; i < it.cells[0]; ++i)
            {
              const double here = box.stress(j * it.cells[0] + i), there = reference.stress(j * 2 * it.cells[0] + i);
              peak                    = std::max(peak, std::abs(there - rest));
              const double difference = std::abs(here - there);
              result.last             = std::max(result.last, difference);
              if (i < it.cells[0] - margin && (!square || j < it.cells[1] - margin))
                result.back = std::max(result.back, difference);
            }
        result.at_side = std::max(result.at_side, result.last);
      }
    for (double *part : {&result.back, &result.at_side, &result.last})
      *part /= peak;
    result.leak = std::abs(totals(box.state).energy - box.given - energy) / (energy + std::abs(box.given));
    return result;
  }

  /// All sides smooth walls but the upper one of axis 0.
  Boundaries<2>
  open_end()
  {
    Boundaries<2> boundaries = sides(BoundaryKind::reflecting);
    boundaries[1].kind       = BoundaryKind::transmitting;
    return boundaries;
  }

  /// The upper side of axis 0 keeps an ambient state.
  Boundaries<2>
  ambient_end(double rho, double e, double pressure)
  {
    Boundaries<2> boundaries    = open_end();
    boundaries[1].keeps_ambient = true;
    boundaries[1].pressure      = pressure;
    boundaries[1].medium        = {{rho, e}};
    return boundaries;
  }

  /// A smooth hump of velocity that runs to the right as a simple wave of the bulk, 2 `half` cm wide.
  Start
  pulse(double peak_velocity, double half, double centre)
  {
    return [=](double x, double) -> std::array<double, 4> {
      const double s = (x - centre) / half,
                   u = std::abs(s) < 1. ? peak_velocity * std::pow(std::cos(1.570796 * s), 2) : 0.;
      // mass and energy behind a shock of this velocity: third order away from the isentrope
      return {density * (sound + slope * u) / (sound + slope * u - u), 0.5 * u * u, u, 0.};
    };
  }

  /// Shock in the first `length` cm, driven by the lower side of axis 0.
  Case
  metal_shock(double pressure, bool strength)
  {
    const double u = (std::sqrt(sound * sound + 4. * slope * pressure / density) - sound) / (2. * slope);
    Case         it{aluminium(strength), open_end(), pulse(u, 0., 0.), {{100, 1}}, 0.};
    it.sides[0] = {BoundaryKind::inflow, {{u, 0.}}};
    it.start    = [u](double x, double) -> std::array<double, 4> {
      const double speed = sound + slope * u;
      return x < 0.2 ? std::array<double, 4>{density * speed / (speed - u), 0.5 * u * u, u, 0.}
                        : std::array<double, 4>{density, 0., 0., 0.};
    };
    // the shock leaves; what comes back fills two thirds of what is left of the column
    it.end = 0.8 / (sound + slope * u) + 0.5 / (sound + 2. * slope * u);
    return it;
  }

  void
  expect_reflection(const std::string &what, const Case &it, double bound)
  {
    for (const Mode mode : {Mode::lagrangian, Mode::eulerian})
      {
        const Reflection r = reflection(mode, it);
        std::printf("  %-40s %-10s comes back %.2f %%; at the side %.2f %%, in the end %.2f %%; energy to %.0e\n",
                    what.c_str(), mode == Mode::eulerian ? "eulerian" : "lagrangian", 100. * r.back, 100. * r.at_side,
                    100. * r.last, r.leak);
        EXPECT_LT(r.back, bound) << what;
        EXPECT_LT(r.leak, 1e-12) << what;
      }
  }

  TEST(TransmittingSides, PulseInMetal)
  {
    // 14 kbar: u = 0.0094 cm/us; 10, 20, 40 cells wide at half height
    for (const bool strength : {false, true})
      for (const bool goes_on : {false, true})
        for (const double half : {0.1, 0.2, 0.4})
          expect_reflection("14 kbar, " + std::to_string(static_cast<int>(std::lround(100. * half))) + " cells wide" +
                                (strength ? ", strength" : "") + (goes_on ? ", medium goes on" : ""),
                            {aluminium(strength),
                             goes_on ? ambient_end(density, 0., 0.) : open_end(),
                             pulse(0.0094, half, 0.5),
                             {{100, 1}},
                             3.},
                            // short of the goal, 2 %, where the pulse yields and dies on its way (doc/limitations.md)
                            strength && half < 0.3 ? 0.026 : 0.02);
  }

  TEST(TransmittingSides, ShockInMetal)
  {
    for (const double pressure : {0.05, 0.2, 1.})
      for (const bool strength : {false, true})
        expect_reflection("shock, " + std::to_string(static_cast<int>(std::lround(100. * pressure))) + " GPa" +
                              (strength ? ", strength" : ""),
                          metal_shock(pressure, strength), 0.02);
  }

  TEST(TransmittingSides, GasAtRestStaysAtItsPressure)
  {
    const double rho = 2., e = 1.25, pressure = 0.4 * rho * e; // 1 Mbar
    for (const Mode mode : {Mode::lagrangian, Mode::eulerian})
      {
        Boundaries<2> boundaries = ambient_end(rho, e, pressure);
        boundaries[3]            = boundaries[1];
        Box box(mode, {{20, 20}}, 0.05, gas(), boundaries);
        box.fill_with([&](double, double) { return std::array<double, 4>{rho, e, 0., 0.}; });
        for (int i = 0; i < 200; ++i)
          box.advance(box.time_step());
        for (Index c = 0; c < box.mesh.n_cells; ++c)
          EXPECT_NEAR(box.stress(c), pressure, 1e-12);
      }
  }

  TEST(TransmittingSides, ShockInGas)
  {
    // gas of 1 Mbar, shocks that raise the pressure p-fold: Rankine-Hugoniot with exponent 1.4
    const double rho = 2., e = 1.25, pressure = 0.4 * rho * e;
    for (const double ratio : {1.2, 3., 30.})
      {
        const double u      = std::sqrt(pressure / rho) * (ratio - 1.) / std::sqrt(1.2 * ratio + 0.2);
        const double behind = rho * (6. * ratio + 1.) / (ratio + 6.), speed = u * behind / (behind - rho);
        Case         it{gas(), ambient_end(rho, e, pressure), {}, {{100, 1}}, 0.};
        it.sides[0] = {BoundaryKind::inflow, {{u, 0.}}};
        it.start    = [=](double x, double) {
          return x < 0.2 ? std::array<double, 4>{behind, ratio * pressure / (0.4 * behind), u, 0.}
                            : std::array<double, 4>{rho, e, 0., 0.};
        };
        it.end = 1.2 / speed;
        // a moving mesh keeps the cells at the side, which the shock has heated a little wrongly on its way out
        expect_reflection("gas, pressure x " + std::to_string(ratio).substr(0, 4), it, ratio > 10. ? 0.025 : 0.02);
      }
  }

  // What comes at an angle meets the impedance of what comes straight: the limit of a traction that sees one face.
  TEST(TransmittingSides, RingPulse)
  {
    for (const bool strength : {false, true})
      {
        Case it{aluminium(strength), sides(BoundaryKind::transmitting), {}, {{60, 60}}, 1.6};
        it.sides[0].kind = it.sides[2].kind = BoundaryKind::reflecting;
        it.start                            = [](double x, double y) -> std::array<double, 4> {
          const double r = std::hypot(x, y) / 0.12;
          return {density * (1. + 0.02 * std::exp(-r * r)), 0., 0., 0.};
        };
        expect_reflection(strength ? "ring, 0 to 45 degrees, strength" : "ring, 0 to 45 degrees", it, 0.02);
      }
  }

  // Debris: rows of cells filled in part, without stress, leave a fixed mesh as they came.
  TEST(TransmittingSides, DebrisLeavesUnhindered)
  {
    Box box(Mode::eulerian, {{40, 4}}, 0.01, aluminium(true), sides(BoundaryKind::transmitting));
    box.fill_with([](double, double) { return std::array<double, 4>{density, 0., 0.3, 0.05}; });
    for (Index c = 0; c < box.mesh.n_cells; ++c)
      fill(box.state, c, density, 0., 0, c % 3 == 0 ? 0.3 : c % 3 == 1 ? 1. : 0.7);
    box.step.update_node_mass(box.state);
    box.step.evaluate(box.state, box.derived);
    while (box.state.time < 0.8)
      {
        box.advance(box.time_step());
        for (Index n = 0; n < box.mesh.n_nodes; ++n)
          if (box.state.node_mass[n] > 0)
            {
              EXPECT_NEAR(box.state.velocity[0][n], 0.3, 1e-9);
              EXPECT_NEAR(box.state.velocity[1][n], 0.05, 1e-9);
            }
      }
  }
} // namespace
