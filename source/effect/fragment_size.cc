// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>

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
      advance_material(MaterialState &material, const std::vector<double> &sound_speed, const MaterialWork<2> &before,
                       double dt, std::size_t m)
      {
        std::vector<double> &share = material.fields[share_].value, &moment = material.fields[moment_].value;
        breaking_.clear();
        const Index n = static_cast<Index>(share.size());
        for (Index c = 0; c < n; ++c)
          if (material.void_fraction[c] > broken_ && share[c] < 1. && before.density[c] > material.density[c])
            breaking_.push_back(c);
        if (breaking_.empty())
          return;
        look_at(material, sound_speed, before, dt, m);
        materials_[m].fragments->evaluate(density_, sound_speed_, rate_, melt_, size_);
        for (std::size_t i = 0; i < breaking_.size(); ++i)
          {
            const Index c = breaking_[i];
            moment[c] += (1. - share[c]) * size_[i];
            share[c] = 1.;
          }
      }

      /// What the cells are like that break in this step.
      void
      look_at(const MaterialState &material, const std::vector<double> &sound_speed, const MaterialWork<2> &before,
              double dt, std::size_t m)
      {
        for (auto *array : {&density_, &energy_, &sound_speed_, &rate_, &size_})
          array->resize(breaking_.size());
        for (std::size_t i = 0; i < breaking_.size(); ++i)
          {
            const Index c   = breaking_[i];
            density_[i]     = material.density[c] / (1. - material.void_fraction[c]);
            energy_[i]      = material.energy[c];
            sound_speed_[i] = sound_speed[c];
            rate_[i]        = (before.density[c] / material.density[c] - 1.) / dt;
          }
        melt_.assign(materials_[m].melts ? breaking_.size() : 0, 0.);
        if (!melt_.empty())
          materials_[m].thermal->evaluate(density_, energy_, {{}, {}, melt_, {}});
      }

      const std::vector<Material> &materials_;
      int                          share_, moment_;
      double                       broken_; ///< void fraction above which material counts as broken

      std::vector<Index>  breaking_; ///< cells that break in this step; of each:
      std::vector<double> density_, energy_, sound_speed_, rate_, melt_, size_;
    };

    EffectVerdict
    judge(const SceneOutlook &outlook)
    {
      if (!outlook.any_has(&Material::fragments))
        return off_without_model("Fragments");
      return {"", true, {}, "a material names a model"};
    }

    const EffectRegistration<2> registration(
        20,
        {
            .name    = "fragment size",
            .summary = "size of the fragments, from the rate of expansion at which the material breaks",
            .documentation =
                "When the void fraction first exceeds a bound, about where growing voids join up, the material's "
                "fragment "
                "model is asked for the size. Carried are the share of the mass that has broken and that share times "
                "the size; their ratio is the mean size. Debris can be laid down in pieces of it (Representation = "
                "fragments); else it is a diagnostic.",
            .fields      = {{"fragmented share", "1", Carrier::mass}, {"fragment size moment", "cm", Carrier::mass}},
            .family      = "Fragments",
            .requires_on = {"voids"},
            .parameters  = {{"Void fraction",
                             "pure number",
                             "above which material counts as broken: about where growing voids join up",
                             {.lower = 0., .upper = 1., .lower_excluded = true},
                             0.3}},
            .judge       = judge,
            .leave_out   = [](Material &material) { material.fragments = nullptr; },
        },
        [](const EffectSetup<2> &setup) { return std::make_unique<FragmentPass>(setup); });
  } // namespace
} // namespace whipple
