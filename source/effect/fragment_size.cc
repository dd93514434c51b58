// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/hydro/solid_state.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    /// Size of fragments, set once, when material breaks. Mixing in a remap is by mass, so the share of the mass that
    /// has broken is carried beside share * size.
    class FragmentPass : public EffectPass<2>
    {
    public:
      explicit FragmentPass(const EffectSetup<2> &setup)
        : materials_(setup.materials)
        , share_(setup.field("fragmented share"))
        , moment_(setup.field("fragment size moment"))
        , broken_(setup.parameter("Void fraction"))
        , density_(setup.mesh.n_cells)
        , rate_(setup.mesh.n_cells)
        , size_(setup.mesh.n_cells)
      {
      }

      void
      advance(const EffectStep<2> &step) override
      {
        for (std::size_t m = 0; m < materials_.size(); ++m)
          if (materials_[m].fragments)
            advance_material(step.state.material[m], step.derived.material[m].sound_speed, step.before.material[m],
                             step.dt, m);
      }

    private:
      void
      advance_material(MaterialState &material, const std::vector<double> &sound_speed, const MaterialWork &before,
                       double dt, std::size_t m)
      {
        const Index n = static_cast<Index>(density_.size());
        solid_state::true_density(material.density, material.void_fraction, materials_[m].eos->reference_density(),
                                  density_);
        for (Index c = 0; c < n; ++c)
          {
            const bool there = material.density[c] > 0;
            rate_[c]         = there ? std::max(before.density[c] / material.density[c] - 1., 0.) / dt : 0.;
          }
        materials_[m].fragments->evaluate(density_, sound_speed, rate_, size_);
        std::vector<double> &share = material.fields[share_].value, &moment = material.fields[moment_].value;
        for (Index c = 0; c < n; ++c)
          {
            const bool breaks = material.void_fraction[c] > broken_ && rate_[c] > 0. && share[c] < 1.;
            moment[c]         = breaks ? moment[c] + (1. - share[c]) * size_[c] : moment[c];
            share[c]          = breaks ? 1. : share[c];
          }
      }

      const std::vector<Material> &materials_;
      int                          share_, moment_;
      double                       broken_; ///< void fraction above which material counts as broken
      std::vector<double>          density_, rate_, size_;
    };

    EffectVerdict
    judge(const SceneOutlook &outlook)
    {
      if (!outlook.any_has(&Material::fragments))
        return off_without_model("Fragments");
      return {"", true, {}, "a material names a model; a diagnostic, nothing feeds back"};
    }

    const EffectRegistration<2> registration(
        20,
        {
            .name    = "fragment size",
            .summary = "size of the fragments, from the rate of expansion at which the material breaks",
            .documentation =
                "A diagnostic, nothing feeds back: when the void fraction first exceeds a bound, the "
                "material's fragment model is asked for the size. Carried are the share of the mass that has "
                "broken and that share times the size; their ratio is the mean size.",
            .fields      = {{"fragmented share", "1", Carrier::mass}, {"fragment size moment", "cm", Carrier::mass}},
            .family      = "Fragments",
            .requires_on = {"voids"},
            .parameters  = {{"Void fraction",
                             "pure number",
                             "above which material counts as broken: small beside debris, large beside what the "
                              "round-off of a remap leaves",
                             {.lower = 0., .upper = 1., .lower_excluded = true},
                             0.01}},
            .judge       = judge,
            .leave_out   = [](Material &material) { material.fragments = nullptr; },
        },
        [](const EffectSetup<2> &setup) { return std::make_unique<FragmentPass>(setup); });
  } // namespace
} // namespace whipple
