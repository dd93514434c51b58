// SPDX-License-Identifier: LGPL-2.1-or-later
// Planar compaction by the P-alpha law against the exact jump conditions, on the moving mesh.
#include "../figure.h"
#include "../unit/hydro_case.h"

#include <whipple/exact/compaction_loading.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/p_alpha_void_law.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;
  using figure::expect_relative;

  constexpr PAlphaVoidLaw::Constants law{0.3, 0.002, 0.02};

  /// A strip of porous aluminium along axis 0, with a piston at its lower end.
  struct PorousStrip
  {
    PorousStrip(int cells, double length, double piston)
      : materials(porous_aluminium())
      , grid{Symmetry::planar, {{0., 0.}}, length / cells, {{cells, 1}}, 0}
      , mesh(build(grid, uniform_keys(grid)))
      , state(make_state(mesh, materials))
      , step(mesh, materials, with_piston(piston), {})
    {
      fill_all(state, 0.7 * 2.785, 0.);
      state.material[0].void_fraction.assign(mesh.n_cells, 0.3);
    }

    static std::vector<Material>
    porous_aluminium()
    {
      Material material;
      material.name     = "porous aluminium";
      material.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.785, 0.5328, 1.338, 2.});
      material.void_law = std::make_shared<PAlphaVoidLaw>(law);
      return {material};
    }

    static Boundaries<2>
    with_piston(double velocity)
    {
      Boundaries<2> boundaries = sides(BoundaryKind::reflecting);
      boundaries[0]            = {BoundaryKind::inflow, {{velocity, 0.}}};
      return boundaries;
    }

    double
    centre(Index cell) const
    {
      return 0.5 * (state.position[0][mesh.cell_node[4 * cell]] + state.position[0][mesh.cell_node[4 * cell + 1]]);
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

    /// Rightmost place where the velocity of the material falls through a level.
    double
    front(double level) const
    {
      const auto speed = [&](Index cell) {
        return 0.5 * (state.velocity[0][mesh.cell_node[4 * cell]] + state.velocity[0][mesh.cell_node[4 * cell + 1]]);
      };
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

  class HydroPorous : public testing::TestWithParam<double>
  {
  };

  TEST_P(HydroPorous, CompactionWaveAndPrecursor)
  {
    const double                        u = GetParam(), length = 4.;
    const exact::CompactionLoading      loading(PorousStrip::porous_aluminium()[0].eos, law, 0.7 * 2.785, 0.);
    const std::vector<exact::WaveFront> fronts = loading.fronts(u);
    const exact::WaveFront             &first = fronts.front(), &last = fronts.back();
    const std::string                   at = ", P-alpha piston at " + std::to_string(u).substr(0, 4) + " cm/us";
    const double                        t  = 0.9 * length / first.speed;
    PorousStrip                         strip(800, length, u);
    const double                        before = fronts.size() > 1 ? first.behind.velocity : 0.;

    run(strip.step, strip.state, 0.5 * t);
    const double halfway = strip.front(0.5 * (before + u)), precursor = strip.front(0.5 * first.behind.velocity);
    run(strip.step, strip.state, t);
    expect_relative("speed of compaction, cm/us" + at, (strip.front(0.5 * (before + u)) - halfway) / (0.5 * t),
                    last.speed, 0.01);

    // clear of the piston, whose sudden start heats the cells next to it
    const MaterialState &m        = strip.state.material[0];
    const auto           pressure = evaluate(strip.step, strip.state).material[0].pressure;
    const double         near = u * t + 0.4 * (last.speed - u) * t, far = u * t + 0.8 * (last.speed - u) * t;
    expect_relative("bulk density, g/cm^3" + at, strip.mean(m.density, near, far), last.behind.density, 0.01);
    expect_relative("pressure, Mbar" + at, strip.mean(pressure, near, far), last.behind.pressure, 0.01);
    expect_relative("specific energy, Mbar cm^3/g" + at, strip.mean(m.energy, near, far), last.behind.energy, 0.01);
    const double void_fraction = strip.mean(m.void_fraction, near, far);
    expect_relative("distension" + at, 1. / (1. - void_fraction), loading.distension(last.behind.pressure), 0.01);
    if (fronts.size() > 1)
      {
        expect_relative("speed of the precursor, cm/us" + at,
                        (strip.front(0.5 * first.behind.velocity) - precursor) / (0.5 * t), first.speed, 0.01);
        const double from = last.speed * t + 0.3 * (first.speed - last.speed) * t,
                     to   = last.speed * t + 0.8 * (first.speed - last.speed) * t;
        expect_relative("pressure of the precursor, Mbar" + at, strip.mean(pressure, from, to), 0.002, 0.01);
        EXPECT_NEAR(strip.mean(m.void_fraction, from, to), 0.3, 0.003);
      }
  }
  INSTANTIATE_TEST_SUITE_P(Speeds, HydroPorous, testing::Values(0.03, 0.05, 0.1, 0.2), [](const auto &info) {
    return "piston_" + std::to_string(int(1000 * info.param)) + "_um_per_us";
  });
} // namespace
