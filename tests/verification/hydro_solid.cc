// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../unit/hydro_case.h"

#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>

#include <cstdio>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  /// A strip of cells along axis 0, one cell wide between smooth walls.
  struct Strip
  {
    Strip(int cells, double length, const std::vector<Material> &strip_materials, const Boundaries<2> &boundaries,
          double density)
      : materials(strip_materials)
      , grid{Symmetry::planar, {{0., 0.}}, length / cells, {{cells + 1, 1}}, 0}
      , mesh(build(grid, keys(cells)))
      , state(make_state(mesh, materials))
      , step(mesh, materials, boundaries, {})
    {
      fill_all(state, density, 0.);
    }

    /// All cells of the domain but the last: the upper end is free.
    static std::vector<CellKey>
    keys(int cells)
    {
      std::vector<CellKey> result;
      for (int i = 0; i < cells; ++i)
        result.push_back(make_key<2>(0, {{i, 0}}));
      return result;
    }

    double
    centre(Index cell) const
    {
      return 0.5 * (state.position[0][mesh.cell_node[4 * cell]] + state.position[0][mesh.cell_node[4 * cell + 1]]);
    }
    double
    speed(Index cell) const
    {
      return 0.5 * (state.velocity[0][mesh.cell_node[4 * cell]] + state.velocity[0][mesh.cell_node[4 * cell + 1]]);
    }

    /// Mean of a cell array between two positions.
    double
    mean(const std::vector<double> &value, double from, double to) const
    {
      double sum = 0, n = 0;
      for (Index cell = 0; cell < mesh.n_cells; ++cell)
        if (centre(cell) > from && centre(cell) < to)
          {
            sum += value[cell];
            n += 1;
          }
      return sum / n;
    }

    /// Rightmost place where the velocity of the material falls through `level`.
    double
    front(double level) const
    {
      for (Index cell = mesh.n_cells - 2; cell >= 0; --cell)
        if (speed(cell) >= level)
          {
            const double a = speed(cell), b = speed(cell + 1);
            return centre(cell) + (centre(cell + 1) - centre(cell)) * (a - level) / (a - b);
          }
      return grid.origin[0];
    }

    std::vector<Material> materials;
    Lattice<2>            grid;
    FlatMesh<2>           mesh;
    State<2>              state;
    LagrangeStep<2>       step;
  };

  std::vector<Material>
  aluminium(bool strength, double density, double sound, double slope)
  {
    Material material;
    material.name = "aluminium";
    material.eos  = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{density, sound, slope, 2.});
    if (strength)
      material.strength = std::make_shared<PerfectlyPlastic>(0.286, 0.0026);
    return {material};
  }

  void
  expect_within(const char *what, double value, double exact, double tolerance)
  {
    std::printf("  %-28s %.6g (exact %.6g, %+.3f %%)\n", what, value, exact, 100. * (value / exact - 1.));
    EXPECT_NEAR(value, exact, tolerance * std::abs(exact)) << what;
  }

  TEST(HydroSolid, ElasticPlasticPiston)
  {
    // hypoelastic solution of ep_piston [ExactPack]
    const double  piston     = 0.01;
    Boundaries<2> boundaries = sides(BoundaryKind::reflecting);
    boundaries[0]            = {BoundaryKind::inflow, {{piston, 0.}}};
    Strip strip(400, 1., aluminium(true, 2.79, 0.533, 1.34), boundaries, 2.79);
    run(strip.step, strip.state, 0.6);
    const double elastic = strip.front(0.5 * 0.002957), plastic = strip.front(0.5 * (0.002957 + 0.01));
    run(strip.step, strip.state, 1.3);
    const double         t        = 1.3;
    const MaterialState &m        = strip.state.material[0];
    const auto           pressure = evaluate(strip.step, strip.state).material[0].pressure;
    expect_within("elastic wave speed", (strip.front(0.5 * 0.002957) - elastic) / 0.7, 0.6520659744, 0.01);
    expect_within("plastic wave speed", (strip.front(0.5 * (0.002957 + 0.01)) - plastic) / 0.7, 0.5505528459, 0.01);
    const double from = 0.58 * t, to = 0.63 * t;
    expect_within("compression, elastic", strip.mean(m.density, from, to) - 2.79, 2.802710684 - 2.79, 0.01);
    expect_within("pressure, elastic plateau", strip.mean(pressure, from, to), 0.003646612969, 0.01);
    expect_within("stress, elastic plateau", strip.mean(m.fields[0].value, from, to), -2. / 3. * 0.0026, 0.01);
    expect_within("compression, plastic", strip.mean(m.density, 0.1, 0.5 * t) - 2.79, 2.839226822 - 2.79, 0.01);
    expect_within("pressure, plastic plateau", strip.mean(pressure, 0.1, 0.5 * t), 0.01445554964, 0.01);
  }

  TEST(HydroSolid, SymmetricImpactAndRelease)
  {
    // aluminium 2024: Us = c0 + s u, P = rho0 Us u
    const double  density = 2.785, sound = 0.5328, slope = 1.338, impact = 0.658, u = 0.5 * impact;
    const double  shock      = sound + slope * u;
    Boundaries<2> boundaries = sides(BoundaryKind::reflecting);
    boundaries[0].kind       = BoundaryKind::transmitting;
    Strip strip(800, 2., aluminium(false, density, sound, slope), boundaries, density);
    // flyer 1 cm, target 1 cm, the target's rear side is free
    for (Index node = 0; node < strip.mesh.n_nodes; ++node)
      {
        const double x                = strip.state.position[0][node];
        strip.state.velocity[0][node] = x < 1. - 1e-9 ? impact : x > 1. + 1e-9 ? 0. : u;
      }
    run(strip.step, strip.state, 0.4);
    const double first = strip.front(0.5 * u);
    run(strip.step, strip.state, 0.8);
    const MaterialState &m        = strip.state.material[0];
    const auto           pressure = evaluate(strip.step, strip.state).material[0].pressure;
    const double         contact  = 1. + u * 0.8;
    expect_within("shock speed", (strip.front(0.5 * u) - first) / 0.4, shock, 0.01);
    expect_within("pressure", strip.mean(pressure, contact - 0.2, contact + 0.2), density * shock * u, 0.01);
    expect_within("density", strip.mean(m.density, contact - 0.2, contact + 0.2), density * shock / (shock - u), 0.01);
    // free-surface velocity after the shock has left the target at t = 1 / shock; 1.029 V along the exact isentrope
    run(strip.step, strip.state, 1.2);
    const Index last = strip.mesh.n_cells - 1;
    expect_within("free-surface velocity / V", strip.state.velocity[0][strip.mesh.cell_node[4 * last + 1]] / impact,
                  1.029, 0.01);
  }
} // namespace
