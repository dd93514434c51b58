// SPDX-License-Identifier: LGPL-2.1-or-later
// An effect that a scene leaves out leaves nothing behind: no field, no array, no pass, though the material has a model
// for it. What it costs when it is on: doc/effects_cost.md.
#include "hydro_case.h"

#include <whipple/effect/effect.h>
#include <whipple/problem/problem.h>

#include <cstdio>
#include <fstream>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  /// Two bodies of one aluminium with a model of every family.
  Problem<2>
  problem_with(const std::string &effects)
  {
    const std::string path = testing::TempDir() + "whipple_effect_cost.prm";
    std::ofstream(path) << "subsection Geometry\n set Symmetry = planar\n set Lower corner = 0 cm, 0 cm\n"
                           " set Upper corner = 0.4 cm, 0.2 cm\nend\n"
                           "subsection Mesh\n set Finest cell = 0.1 cm\n set Levels = 0\nend\n"
                           "subsection Materials\n set List = aluminium\n subsection aluminium\n"
                           " set Library = aluminium 2024-T4\n set Strength = johnson-cook\n set Void law = rate\n"
                           " set Alpha = 1e5 us/cm^2\n set Spall strength = 1.2 GPa\n"
                           " set Thermal model = constant specific heat\n set Failure = spall\n"
                           " set Fragments = grady-kipp\n set Conduction = constant conductivity\n end\nend\n"
                           "subsection Bodies\n set List = left, right\n"
                           " subsection left\n set Shape = box\n set Lower corner = 0 cm, 0 cm\n"
                           " set Upper corner = 0.2 cm, 0.2 cm\n set Material = aluminium\n end\n"
                           " subsection right\n set Shape = box\n set Lower corner = 0.2 cm, 0 cm\n"
                           " set Upper corner = 0.4 cm, 0.2 cm\n set Material = aluminium\n end\nend\n"
                           "subsection Stages\n set List = s\n subsection s\n set Mode = eulerian\n"
                           " set End = 1 us\n end\nend\n"
                           "subsection Effects\n set List = "
                        << effects << "\nend\n";
    const Problem<2> problem = read_problem<2>(path);
    std::remove(path.c_str());
    return problem;
  }

  /// What runs on a mesh of eight cells.
  struct Case
  {
    explicit Case(const std::string &effects)
      : problem(problem_with(effects))
      , mesh(build(scene.lattice, uniform_keys(scene.lattice)))
      , state(layout.allocate(mesh))
      , lagrange(mesh, layout.materials, scene.boundaries, scene.numerics.hydro)
      , passes(make_passes<2>(scene.effects, mesh, layout.materials, layout.fields, scene.effect_parameters))
      , scratch(material_passes::make_scratch(layout.materials, mesh.n_cells))
    {
      lagrange.evaluate(state, derived);
    }

    Problem<2>               problem;
    const Scene<2>          &scene  = problem.scene;
    const FieldLayout       &layout = problem.layout;
    FlatMesh<2>              mesh;
    State<2>                 state;
    Derived                  derived;
    LagrangeStep<2>          lagrange;
    EffectPasses<2>          passes;
    material_passes::Scratch scratch;
  };

  std::vector<std::string>
  field_names(const Case &run)
  {
    std::vector<std::string> names;
    for (const FieldDescription &field : run.layout.fields)
      names.push_back(field.name);
    return names;
  }

  /// Bytes of the work arrays of one material that only some effect needs.
  std::size_t
  optional_work(const MaterialWork<2> &work)
  {
    std::size_t values = 0;
    for (const auto *array : {&work.half_pressure, &work.void_fraction, &work.stress[0], &work.stress[1],
                              &work.stress[2], &work.plastic_strain})
      values += array->capacity();
    return values * sizeof(double);
  }

  TEST(EffectCost, EmptyListCarriesAndAllocatesNothing)
  {
    const Case run("");
    EXPECT_TRUE(run.layout.fields.empty());
    EXPECT_TRUE(run.passes.pass.empty());
    EXPECT_TRUE(run.passes.books.bookings().by_cause().empty());
    const Material &model = run.layout.materials[0];
    EXPECT_FALSE(model.strength || model.void_law || model.failure || model.fragments || model.conduction);
    EXPECT_FALSE(model.melts);

    const MaterialState &material = run.state.material[0];
    EXPECT_EQ(material.volume.size(), 8);
    EXPECT_EQ(material.void_fraction.capacity(), 0);
    EXPECT_EQ(material.fields.capacity(), 0);

    const StepWork<2> &work = run.lagrange.before();
    EXPECT_FALSE(work.has_strength); // the kernels without stress run
    EXPECT_EQ(run.derived.strain_rate.capacity(), 0);
    EXPECT_EQ(run.derived.material[0].shear_modulus.capacity(), 0);
    EXPECT_EQ(run.derived.material[0].yield_stress.capacity(), 0);
    EXPECT_EQ(optional_work(work.material[0]), 0);
    EXPECT_EQ(run.scratch.solid_pressure.capacity(), 0);
    EXPECT_EQ(run.scratch.soundness.capacity(), 0);
    EXPECT_EQ(run.scratch.melt_fraction.capacity(), 0);
  }

  // The same arrays when their effects are on: the test above does not look past them.
  TEST(EffectCost, FullListAllocatesThem)
  {
    const Case run("strength, voids, body tags, melting, failure, fragment size, heat conduction");
    EXPECT_EQ(run.passes.pass.size(), 3); // failure, fragment size, heat conduction
    EXPECT_EQ(run.state.material[0].void_fraction.size(), 8);
    EXPECT_EQ(run.state.material[0].fields.size(), 8);
    const StepWork<2>     &work = run.lagrange.before();
    const MaterialWork<2> &next = work.material[0];
    EXPECT_TRUE(work.has_strength);
    EXPECT_EQ(run.derived.strain_rate.size(), 8); // Johnson and Cook ask for it
    const DerivedMaterial &derived = run.derived.material[0];
    for (const auto *array :
         {&derived.shear_modulus, &derived.yield_stress, &next.void_fraction, &next.stress[2], &next.plastic_strain})
      EXPECT_EQ(array->size(), 8);
    EXPECT_EQ(run.scratch.soundness.size(), 8);
    EXPECT_EQ(run.scratch.melt_fraction.size(), 8);
  }

  TEST(EffectCost, EachEffectBringsItsOwnFieldsOnly)
  {
    using Names = std::vector<std::string>;
    const Names stress{"deviatoric stress 00", "deviatoric stress 11", "deviatoric stress 01", "plastic strain"};
    EXPECT_EQ(field_names(Case("strength")), stress);
    EXPECT_EQ(field_names(Case("voids")), Names{}); // phi is no field
    EXPECT_EQ(field_names(Case("body tags")), Names{"body left"});
    EXPECT_EQ(field_names(Case("melting")), Names{});
    EXPECT_EQ(field_names(Case("heat conduction")), Names{});
    EXPECT_EQ(field_names(Case("voids, failure")), Names{"damage"});
    EXPECT_EQ(field_names(Case("voids, fragment size")), (Names{"fragmented share", "fragment size moment"}));
  }

  TEST(EffectCost, VoidsAloneBringNoArraysOfStrengthAndStrengthNoneOfVoids)
  {
    const Case voids("voids"), strength("strength");
    EXPECT_FALSE(voids.lagrange.before().has_strength);
    EXPECT_EQ(optional_work(voids.lagrange.before().material[0]), 8 * sizeof(double)); // next void fractions
    EXPECT_EQ(voids.scratch.soundness.capacity(), 0);
    EXPECT_EQ(strength.state.material[0].void_fraction.capacity(), 0);
    EXPECT_EQ(strength.lagrange.before().material[0].void_fraction.capacity(), 0);
  }
} // namespace
