// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/effect/effect_pass.h>
#include <whipple/effect/scene_outlook.h>
#include <whipple/material/model_description.h>
#include <whipple/registry.h>
#include <whipple/state/fields.h>

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// What a scene can switch on under `Effects/List`. Each registers itself, in a file of its own (doc/extending.md).
///
/// There are two kinds. An **effect** does its work in a pass of its own after the Lagrange step, at a place in the
/// order of all effects that it names. An **option of the step** has no pass: models or fields that the Lagrange step
/// and the material models take up where they are there (strength, voids, melting, body tags).
namespace whipple
{
  /// What effects and options say of themselves: for selection, `whipple help effects`, messages and the manual.
  struct EffectDescription
  {
    std::string                   name;             ///< in scene files, "heat conduction"
    std::string                   summary;          ///< one line
    std::string                   documentation;    ///< a paragraph: what it does, when it matters, what it costs
    std::vector<FieldDescription> fields      = {}; ///< that the state carries for it, in every material
    std::string                   family      = {}; ///< of models of which at least one material must have one
    std::vector<std::string>      requires_on = {}; ///< others without which this one has no meaning

    /// Entries of the scene's section Effects/NAME. Numbers with a unit and a range; without a default one must be
    /// given where the effect is on.
    std::vector<ModelConstant> parameters = {};

    /// Causes under which it enters what it changes.
    std::vector<BookingDescription> bookings = {};

    /// The verdict of `auto` (its name is filled in). Empty: it is off unless it is listed.
    std::function<EffectVerdict(const SceneOutlook &)> judge = {};

    /// What a material is without it: the model that only it would use is taken out. Then, what it is with it.
    std::function<void(Material &)> leave_out = {}, take_up = {};

    /// Throws InputError (one line: what is wrong, what is allowed) if the scene's materials and what is on do not fit,
    /// asked whether this one is on or not.
    std::function<void(const std::vector<NamedMaterial> &, const std::function<bool(const std::string &)> &is_on)>
        check = {};
  };

  /// All options of the step, by name.
  class StepOptionRegistry : public Registry<StepOptionRegistry, EffectDescription>
  {
  };

  /// Makes an option of the step known: one line at the end of its file,
  ///
  ///     const StepOptionRegistration registration({.name = "strength", ...});
  class StepOptionRegistration
  {
  public:
    explicit StepOptionRegistration(const EffectDescription &description)
      : registered_(description.name, description)
    {
    }

  private:
    StepOptionRegistry::Registered registered_;
  };

  /// An effect: what it says of itself, and how its pass is made.
  template <int dim>
  struct EffectKind
  {
    EffectDescription                                                         description;
    std::function<std::unique_ptr<EffectPass<dim>>(const EffectSetup<dim> &)> make;
  };

  /// All effects, in the order in which they work: by place, then name.
  template <int dim>
  class EffectRegistry : public Registry<EffectRegistry<dim>, EffectKind<dim>, std::pair<int, std::string>>
  {
  public:
    /// The effect of that name, null if there is none.
    static const EffectKind<dim> *
    find(const std::string &name)
    {
      for (const auto &[key, entry] : EffectRegistry::all())
        if (key.second == name)
          return &entry;
      return nullptr;
    }
  };

  /// Makes an effect known: one line at the end of its file,
  ///
  ///     const EffectRegistration<2> registration(40, {.name = "failure", ...}, [](const EffectSetup<2> &setup) {
  ///       return std::make_unique<FailurePass>(setup);
  ///     });
  template <int dim>
  class EffectRegistration
  {
  public:
    /// @param place in the order of all effects: smaller ones work first
    /// @throws std::logic_error, and so ends the program before main(), if there is one of that name
    EffectRegistration(int place, const EffectDescription &description, decltype(EffectKind<dim>::make) make)
      : registered_({place, only(description.name)}, {description, std::move(make)})
    {
    }

  private:
    /// The name, if no effect has it, at another place.
    static const std::string &
    only(const std::string &name)
    {
      if (EffectRegistry<dim>::find(name))
        throw std::logic_error("two effects are called '" + name + "'");
      return name;
    }

    typename EffectRegistry<dim>::Registered registered_;
  };

  /// Passes of a run and the books that they enter into.
  template <int dim>
  struct EffectPasses
  {
    std::vector<std::unique_ptr<EffectPass<dim>>> pass; ///< in the order of their places
    EffectBooks<dim>                              books;
  };

  /// The passes of the effects that are on.
  /// @param parameters of each, by its name
  template <int dim>
  EffectPasses<dim>
  make_passes(const std::vector<std::string> &on, const FlatMesh<dim> &mesh, const std::vector<Material> &materials,
              const std::vector<FieldDescription> &fields, const std::map<std::string, EffectParameters> &parameters);

  /// Descriptions of all effects and options there are, by name.
  std::vector<EffectDescription>
  effect_descriptions();
} // namespace whipple
