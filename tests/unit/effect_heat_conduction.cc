// SPDX-License-Identifier: LGPL-2.1-or-later
// The pass of the effect "heat conduction" alone, on material at rest, against eigenmodes of an insulated box.
#include "effect_case.h"
#include "fixed_thermal.h"
#include "hydro_case.h"

#include <whipple/material/constant_conductivity.h>
#include <whipple/material/mie_grueneisen.h>

#include <numbers>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;
  constexpr double diffusivity = 0.3; // cm^2/us; specific heat and density are 1
  constexpr double pi          = std::numbers::pi;

  Material
  conductor(double conductivity = diffusivity)
  {
    Material material;
    material.eos        = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{1., 0.5, 1.3, 2.});
    material.thermal    = std::make_shared<FixedThermal>();
    material.conduction = std::make_shared<ConstantConductivity>(conductivity);
    return material;
  }

  /// Decaying temperature of a unit box with insulated sides: J0(j r) cos(pi z) or cos(pi x) cos(pi y).
  struct Mode
  {
    Symmetry symmetry;

    double
    at(double x, double z, double time) const
    {
      const double root  = 3.8317059702075125; // first zero of J1: nothing flows through the rim
      const bool   plane = symmetry == Symmetry::planar;
      const double wave  = plane ? pi : root;
      const double shape = plane ? std::cos(pi * x) : std::cyl_bessel_j(0, root * x);
      return 300. + 100. * shape * std::cos(pi * z) * std::exp(-diffusivity * (wave * wave + pi * pi) * time);
    }
  };

  /// Errors of a run until most of the mode has gone.
  struct Errors
  {
    double l1 = 0, largest = 0, energy = 0;
  };

  Errors
  decay(Symmetry symmetry, int roots, bool hanging)
  {
    const Lattice<2>  grid{symmetry, {{0., 0.}}, (hanging ? 0.5 : 1.) / roots, {{roots, roots}}, hanging ? 1 : 0};
    const auto        keys = !hanging ? uniform_keys(grid)
                                      : two_level_keys(grid, [&](int i, int j) { return 2 * i < roots && 2 * j < roots; });
    const FlatMesh<2> mesh = build(grid, keys);
    const std::vector<Material> materials{conductor()};
    State<2>                    state = make_state(mesh, materials);
    const Mode                  mode{symmetry};
    const auto                  exact = [&](Index cell, double time) {
      return mode.at(mesh.lower[0][cell] + 0.5 * mesh.size[cell], mesh.lower[1][cell] + 0.5 * mesh.size[cell], time);
    };
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      fill(state, cell, 1., exact(cell, 0.));
    const double before = totals(state).internal;

    const std::vector<FieldDescription> fields;
    effect_case::LonePass               pass("heat conduction", mesh, materials, fields);
    const StepWork<2>                   unused;
    for (const double end = 0.1; end - state.time > 1e-12;)
      {
        const double dt = std::min(pass.pass().time_step(state).dt, end - state.time);
        pass.advance(state, Derived(), unused, dt);
        state.time += dt;
      }

    Errors errors;
    double volume = 0;
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        const double error = std::abs(state.material[0].energy[cell] - exact(cell, state.time));
        errors.l1 += error * state.volume[cell];
        volume += state.volume[cell];
        errors.largest = std::max(errors.largest, error);
      }
    errors.l1 /= volume;
    errors.energy = std::abs(totals(state).internal / before - 1.);
    return errors;
  }

  class EffectHeatConduction : public testing::TestWithParam<std::tuple<Symmetry, bool>>
  {
  };

  TEST_P(EffectHeatConduction, DecaysAsTheEigenmodeAtSecondOrderAndKeepsTheEnergy)
  {
    const auto [symmetry, hanging] = GetParam();
    const Errors coarse = decay(symmetry, 16, hanging), fine = decay(symmetry, 32, hanging);
    EXPECT_GE(std::log2(coarse.l1 / fine.l1), 1.9) << coarse.l1 << " to " << fine.l1;
    EXPECT_GE(std::log2(coarse.largest / fine.largest), hanging ? 1.7 : 1.9)
        << coarse.largest << " to " << fine.largest;
    EXPECT_LT(fine.l1, 0.01);
    EXPECT_LT(fine.energy, 1e-13);
  }
  INSTANTIATE_TEST_SUITE_P(Meshes, EffectHeatConduction,
                           testing::Combine(testing::Values(Symmetry::planar, Symmetry::axisymmetric), testing::Bool()),
                           [](const auto &info) {
                             return std::string(std::get<0>(info.param) == Symmetry::planar ? "planar"
                                                                                            : "axisymmetric") +
                                    (std::get<1>(info.param) ? "HangingNodes" : "Uniform");
                           });

  /// A row of two cells of 1 cm; heat flows from the left one.
  struct TwoCells
  {
    explicit TwoCells(const std::vector<Material> &models)
      : materials(models)
      , mesh(build(grid, uniform_keys(grid)))
      , state(make_state(mesh, materials))
    {
    }

    /// @returns the heat that the books have as moved
    double
    conduct(double dt)
    {
      const std::vector<FieldDescription> fields;
      effect_case::LonePass               pass("heat conduction", mesh, materials, fields);
      pass.advance(state, Derived(), StepWork<2>(), dt);
      return pass.books().bookings().of("conducted heat").converted.value();
    }

    Lattice<2>            grid{Symmetry::planar, {{0., 0.}}, 1., {{2, 1}}, 0};
    std::vector<Material> materials;
    FlatMesh<2>           mesh;
    State<2>              state;
  };

  TEST(EffectHeatConductionCells, FluxTakesTheHarmonicMeanOfTheConductivities)
  {
    TwoCells cells({conductor(3.), conductor(1.)});
    fill(cells.state, 0, 1., 500., 0);
    fill(cells.state, 1, 1., 300., 1);
    // 2 * 3 * 1 / (3 + 1) * 200 K over 1 cm through 1 cm^2
    EXPECT_NEAR(cells.conduct(0.01), 0.01 * 1.5 * 200., 1e-11);
    EXPECT_NEAR(cells.state.material[0].energy[0], 500. - 0.01 * 1.5 * 200., 1e-11);
    EXPECT_NEAR(cells.state.material[1].energy[1], 300. + 0.01 * 1.5 * 200., 1e-11);
  }

  TEST(EffectHeatConductionCells, NothingFlowsThroughOpenVoidOrMaterialThatDoesNotConduct)
  {
    Material insulator   = conductor();
    insulator.conduction = nullptr;
    for (const bool empty : {true, false})
      {
        TwoCells cells({conductor(), insulator});
        fill(cells.state, 0, 1., 500., 0);
        if (!empty)
          fill(cells.state, 1, 1., 300., 1);
        cells.conduct(0.1);
        EXPECT_EQ(cells.state.material[0].energy[0], 500.);
        EXPECT_EQ(cells.state.material[1].energy[1], empty ? 0. : 300.);
      }
  }

  TEST(EffectHeatConductionCells, MaterialsOfAMixedCellWarmAlike)
  {
    TwoCells cells({conductor(), conductor()});
    fill(cells.state, 0, 1., 500., 0);
    fill(cells.state, 1, 1., 300., 0, 0.25);
    fill(cells.state, 1, 2., 300., 1, 0.75);
    const double before = totals(cells.state).internal;
    cells.conduct(0.1);
    const double rise = 0.1 * diffusivity * 200. / (0.25 * 1. + 0.75 * 2.);
    EXPECT_NEAR(cells.state.material[0].energy[1], 300. + rise, 1e-11);
    EXPECT_NEAR(cells.state.material[1].energy[1], 300. + rise, 1e-11);
    EXPECT_NEAR(totals(cells.state).internal, before, 1e-12 * before);
  }

  TEST(EffectHeatConductionCells, StableAtTheTimeStepItAsksForAlsoInPartlyFilledCells)
  {
    // temperatures of a checkerboard, the shortest wave, in cells of alternating filling
    const Lattice<2>            grid{Symmetry::planar, {{0., 0.}}, 0.1, {{8, 8}}, 0};
    const FlatMesh<2>           mesh = build(grid, uniform_keys(grid));
    const std::vector<Material> materials{conductor()};
    State<2>                    state = make_state(mesh, materials);
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        const bool odd = (std::lround(mesh.lower[0][cell] / 0.1) + std::lround(mesh.lower[1][cell] / 0.1)) % 2 != 0;
        fill(state, cell, 1., odd ? 200. : 400., 0, odd ? 0.1 : 1.);
      }
    const std::vector<FieldDescription> fields;
    effect_case::LonePass               pass("heat conduction", mesh, materials, fields);
    const StepWork<2>                   unused;
    for (int i = 0; i < 200; ++i)
      {
        pass.advance(state, Derived(), unused, pass.pass().time_step(state).dt);
        for (Index cell = 0; cell < mesh.n_cells; ++cell)
          {
            EXPECT_GE(state.material[0].energy[cell], 200. - 1e-9);
            EXPECT_LE(state.material[0].energy[cell], 400. + 1e-9);
          }
      }
    const double mean = totals(state).internal / totals(state).mass;
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      EXPECT_NEAR(state.material[0].energy[cell], mean, 1.);
  }

  TEST(EffectHeatConductionCells, TimeStepIsTheShareOfTheStableOne)
  {
    const TwoCells                      cells({conductor()});
    State<2>                            state = cells.state;
    const std::vector<FieldDescription> fields;
    fill(state, 0, 1., 500., 0);
    const auto step = [&](double share) {
      return effect_case::LonePass("heat conduction", cells.mesh, cells.materials, fields,
                                   {{"Share of the stable step", share}})
          .pass()
          .time_step(state)
          .dt;
    };
    EXPECT_DOUBLE_EQ(step(1.), 1. / diffusivity); // h = 1 cm, one face of four
    EXPECT_DOUBLE_EQ(step(0.25), 0.25 / diffusivity);
  }

  TEST(EffectHeatConductionCells, CornersThatMeetSetNoTimeStepAndNothingGrows)
  {
    // pairs of columns of trapezoids: every second node of a row stands at `near` from its neighbour
    constexpr double            size = 0.1;
    const Lattice<2>            grid{Symmetry::planar, {{0., 0.}}, size, {{8, 8}}, 0};
    const FlatMesh<2>           mesh = build(grid, uniform_keys(grid));
    const std::vector<Material> materials{conductor()};
    for (const double near : {1e-2 * size, 1e-6 * size, 0.})
      {
        State<2> state = make_state(mesh, materials);
        for (Index cell = 0; cell < mesh.n_cells; ++cell)
          {
            const Index *n  = &mesh.cell_node[cell * 4];
            const int    ij = std::lround(mesh.lower[0][cell] / size) + std::lround(mesh.lower[1][cell] / size);
            if (ij % 2 == 0 && mesh.lower[0][cell] > 0.5 * size) // its lower edge shrinks to `near`
              state.position[0][n[0]] = mesh.lower[0][cell] + size - near;
          }
        double least = 1e300;
        for (Index cell = 0; cell < mesh.n_cells; ++cell)
          {
            const Index *n = &mesh.cell_node[cell * 4];
            const auto   x = [&](int k, int d) { return state.position[d][n[k]]; };
            state.volume[cell] =
                0.5 * std::abs((x(3, 0) - x(0, 0)) * (x(2, 1) - x(1, 1)) - (x(3, 1) - x(0, 1)) * (x(2, 0) - x(1, 0)));
            fill(state, cell, 1., cell % 2 == 0 ? 200. : 400.);
            least = std::min(least, state.volume[cell]);
          }
        ASSERT_GT(least, 0.4 * size * size);
        const std::vector<FieldDescription> fields;
        effect_case::LonePass               pass("heat conduction", mesh, materials, fields);
        const StepWork<2>                   unused;
        EXPECT_GT(pass.pass().time_step(state).dt, 0.5 * size * size / (8. * diffusivity)) << near;
        for (int i = 0; i < 300; ++i)
          {
            pass.advance(state, Derived(), unused, pass.pass().time_step(state).dt);
            for (Index cell = 0; cell < mesh.n_cells; ++cell)
              {
                EXPECT_GE(state.material[0].energy[cell], 200. - 1e-9);
                EXPECT_LE(state.material[0].energy[cell], 400. + 1e-9);
              }
          }
      }
  }
} // namespace
