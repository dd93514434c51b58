// SPDX-License-Identifier: LGPL-2.1-or-later
// The passes of the effects "failure" and "fragment size" on states set up by hand.
#include "effect_case.h"
#include "hydro_case.h"

#include <whipple/material/failure_model.h>
#include <whipple/material/fragment_model.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>
#include <whipple/material/rate_void_law.h>
#include <whipple/material/spall_failure.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  /// Keeps what the pass hands to it.
  class RecordingFailure : public FailureModel
  {
  public:
    void
    advance(const FailureInput &state, std::span<double> damage) const override
    {
      const auto copy = [](std::span<const double> values) {
        return std::vector<double>(values.begin(), values.end());
      };
      density           = copy(state.density);
      pressure          = copy(state.pressure);
      equivalent_stress = copy(state.equivalent_stress);
      plastic_increment = copy(state.plastic_increment);
      dt                = state.dt;
      for (double &d : damage)
        d = std::max(d, 0.25);
    }
    std::string
    name() const override
    {
      return "recording";
    }

    mutable std::vector<double> density, pressure, equivalent_stress, plastic_increment;
    mutable double              dt = 0;
  };

  /// Size = density / rate: both can be read off it.
  class RatioFragments : public FragmentModel
  {
  public:
    void
    evaluate(std::span<const double> density, std::span<const double>, std::span<const double> rate,
             std::span<const double>, std::span<double> size) const override
    {
      for (std::size_t i = 0; i < size.size(); ++i)
        size[i] = rate[i] > 0 ? density[i] / rate[i] : 1e9;
    }
    std::string
    name() const override
    {
      return "ratio";
    }
  };

  /// Three cells of aluminium with voids: the last one is empty.
  struct Row
  {
    explicit Row(std::vector<Material> models, const std::vector<FieldDescription> &effect_fields)
      : materials(std::move(models))
      , mesh(build(grid, uniform_keys(grid)))
      , state(make_state(mesh, materials))
    {
      for (MaterialState &material : state.material)
        for (const FieldDescription &field : effect_fields)
          material.fields.push_back({field, std::vector<double>(mesh.n_cells, 0.)});
      for (const Field &field : state.material[0].fields)
        fields.push_back(field.description);
      for (std::size_t m = 0; m < materials.size(); ++m)
        for (const Index cell : {0, 1})
          fill(state, cell, 2.5, 0.001, m, 1. / static_cast<double>(materials.size()));
      for (MaterialState &material : state.material)
        {
          DerivedMaterial &from = derived.material.emplace_back();
          from.pressure.assign(mesh.n_cells, 0.);
          from.sound_speed.assign(mesh.n_cells, 0.);
          MaterialWork<2> &work = before.material.emplace_back();
          for (auto *array : {&work.density, &work.plastic_strain})
            array->assign(mesh.n_cells, 0.);
          work.density = material.density;
        }
    }

    std::unique_ptr<effect_case::LonePass>
    pass(const std::string &effect) const
    {
      return std::make_unique<effect_case::LonePass>(effect, mesh, materials, fields);
    }

    std::vector<double> &
    field(const std::string &name, std::size_t material = 0)
    {
      for (Field &f : state.material[material].fields)
        if (f.description.name == name)
          return f.value;
      throw std::logic_error("no field " + name);
    }

    Lattice<2>                    grid{Symmetry::planar, {{0., 0.}}, 0.1, {{3, 1}}, 0};
    std::vector<Material>         materials;
    FlatMesh<2>                   mesh;
    State<2>                      state;
    std::vector<FieldDescription> fields;
    StepWork<2>                   before;
    Derived                       derived;
  };

  Material
  aluminium()
  {
    Material material;
    material.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.785, 0.5328, 1.338, 2.});
    material.void_law = std::make_shared<RateVoidLaw>(1000., std::numeric_limits<double>::infinity());
    return material;
  }

  const std::vector<FieldDescription> damage_field{{"damage", "1", Carrier::mass}};
  const std::vector<FieldDescription> fragment_fields{{"fragmented share", "1", Carrier::mass},
                                                      {"fragment size moment", "cm", Carrier::mass}};

  TEST(EffectFailure, ModelSeesTheSolidAndItsPlasticFlow)
  {
    const auto recorder = std::make_shared<RecordingFailure>();
    Material   material = aluminium();
    material.strength   = std::make_shared<PerfectlyPlastic>(0.286, 0.0026);
    material.failure    = recorder;
    Row            row({material}, damage_field);
    MaterialState &aluminium              = row.state.material[0];
    aluminium.void_fraction               = {0., 0.2, 0.};
    row.derived.material[0].pressure      = {0.01, -0.008, 0.};
    aluminium.fields[0].value[1]          = 0.001;   // s_00
    aluminium.fields[1].value[1]          = -0.0005; // s_11
    aluminium.fields[2].value[1]          = 0.0002;  // s_01
    aluminium.fields[3].value[1]          = 0.07;
    row.before.material[0].plastic_strain = {0., 0.05, 0.};
    row.pass("failure")->advance(row.state, row.derived, row.before, 0.125);

    EXPECT_DOUBLE_EQ(recorder->density[0], 2.5);
    EXPECT_DOUBLE_EQ(recorder->density[1], 3.125);
    EXPECT_DOUBLE_EQ(recorder->density[2], 2.785);
    EXPECT_DOUBLE_EQ(recorder->pressure[0], 0.01);
    EXPECT_DOUBLE_EQ(recorder->pressure[1], -0.01);
    // sqrt(3/2 (1e-6 + 0.25e-6 + 0.25e-6 + 2 * 0.04e-6))
    EXPECT_NEAR(recorder->equivalent_stress[1], std::sqrt(2.37e-6), 1e-15);
    EXPECT_NEAR(recorder->plastic_increment[1], 0.02, 1e-16);
    EXPECT_EQ(recorder->equivalent_stress[0], 0.);
    EXPECT_EQ(recorder->dt, 0.125);
    EXPECT_EQ(row.field("damage"), (std::vector<double>{0.25, 0.25, 0.})); // none where nothing is
    EXPECT_FALSE(row.pass("failure")->pass().changes_energy());
  }

  TEST(EffectFailure, MaterialWithoutModelStaysSoundAndOneWithoutStrengthHasNoStress)
  {
    const auto recorder = std::make_shared<RecordingFailure>();
    Material   breaks   = aluminium();
    breaks.failure      = recorder;
    Row row({breaks, aluminium()}, damage_field);
    row.pass("failure")->advance(row.state, row.derived, row.before, 0.125);
    EXPECT_TRUE(recorder->equivalent_stress.empty());
    EXPECT_TRUE(recorder->plastic_increment.empty());
    EXPECT_EQ(row.field("damage", 0)[0], 0.25);
    EXPECT_EQ(row.field("damage", 1)[0], 0.);
  }

  TEST(EffectFailure, SpallStaysWhenTheVoidsCloseAgain)
  {
    Material material = aluminium();
    material.failure  = std::make_shared<SpallFailure>(1e-3);
    Row        row({material}, damage_field);
    const auto pass                     = row.pass("failure");
    row.state.material[0].void_fraction = {5e-4, 0.02, 0.};
    pass->advance(row.state, row.derived, row.before, 0.01);
    row.state.material[0].void_fraction = {0., 0., 0.};
    pass->advance(row.state, row.derived, row.before, 0.01);
    EXPECT_EQ(row.field("damage"), (std::vector<double>{0., 1., 0.}));
  }

  TEST(EffectFailure, NeedsItsField)
  {
    Material material = aluminium();
    material.failure  = std::make_shared<SpallFailure>(1e-3);
    const Row row({material}, {});
    EXPECT_THROW(row.pass("failure"), std::logic_error);
  }

  TEST(EffectFragmentSize, SetOnceWhenTheMaterialBreaks)
  {
    Material material  = aluminium();
    material.fragments = std::make_shared<RatioFragments>();
    Row        row({material}, fragment_fields);
    const auto pass = row.pass("fragment size");

    // expands by a hundredth in 0.01 us: 1/us; one cell below the threshold of voids
    row.state.material[0].void_fraction = {0.29, 0.4, 0.};
    row.before.material[0].density      = {2.525, 2.525, 0.};
    pass->advance(row.state, row.derived, row.before, 0.01);
    EXPECT_EQ(row.field("fragmented share"), (std::vector<double>{0., 1., 0.}));
    EXPECT_NEAR(row.field("fragment size moment")[1], 2.5 / 0.6, 1e-12); // true density over rate
    EXPECT_EQ(row.field("fragment size moment")[0], 0.);

    // faster expansion later makes no smaller fragments
    row.before.material[0].density = {2.525, 2.75, 0.};
    pass->advance(row.state, row.derived, row.before, 0.01);
    EXPECT_NEAR(row.field("fragment size moment")[1], 2.5 / 0.6, 1e-12);
  }

  TEST(EffectFragmentSize, SoundPartOfAMixedCellBreaksLaterAndCompressionBreaksNothing)
  {
    Material material  = aluminium();
    material.fragments = std::make_shared<RatioFragments>();
    Row        row({material}, fragment_fields);
    const auto pass = row.pass("fragment size");

    row.state.material[0].void_fraction = {0.4, 0.4, 0.};
    row.field("fragmented share")       = {0.4, 0., 0.};
    row.field("fragment size moment")   = {0.4 * 0.5, 0., 0.};
    row.before.material[0].density      = {2.525, 2.4, 0.}; // the second one is compressed
    pass->advance(row.state, row.derived, row.before, 0.01);
    EXPECT_EQ(row.field("fragmented share"), (std::vector<double>{1., 0., 0.}));
    EXPECT_NEAR(row.field("fragment size moment")[0], 0.4 * 0.5 + 0.6 * 2.5 / 0.6, 1e-12);
    EXPECT_EQ(row.field("fragment size moment")[1], 0.);
  }
} // namespace
