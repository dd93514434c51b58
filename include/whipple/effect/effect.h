// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/step_work.h>
#include <whipple/hydro/time_step.h>
#include <whipple/material/material.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace whipple
{
  /// What a scene can switch on: for selection, `whipple help effects`, messages and the manual.
  struct EffectDescription
  {
    std::string                   name;          ///< in scene files, "heat conduction"
    std::string                   summary;       ///< one line
    std::string                   documentation; ///< a paragraph: what it does, when it matters, what it costs
    std::vector<FieldDescription> fields;        ///< that the state carries for it, in every material
    std::string                   family;      ///< of models of which at least one material must have one; may be empty
    std::vector<std::string>      requires_on; ///< effects without which this one has no meaning
  };

  /// Position of a field of that name, -1 if nothing registered it.
  int
  field_index(const std::vector<FieldDescription> &fields, const std::string &name);

  /// What a pass is made for; all of it outlives the pass.
  template <int dim>
  struct EffectSetup
  {
    const FlatMesh<dim>                 &mesh;
    const std::vector<Material>         &materials;
    const std::vector<FieldDescription> &fields; ///< of the state, in their order

    /// Index of a field of the state.
    /// @throws std::logic_error if nothing registered it.
    int
    field(const std::string &name) const;
  };

  /// The work of an effect in every cycle, after the Lagrange step: one pass over flat arrays, owned and halo cells.
  template <int dim>
  class EffectPass
  {
  public:
    virtual ~EffectPass() = default;

    /// @param state  at the end of the Lagrange step; the pass changes it in place
    /// @param derived pressures and sound speeds of this state
    /// @param before what the step started from: volumes, densities, energies, stresses, plastic strains
    /// @param dt     us
    virtual void
    advance(State<dim> &state, const Derived &derived, const StepWork<dim> &before, double dt) = 0;

    /// True if it changes energies: pressures are evaluated anew then.
    virtual bool
    changes_energy() const
    {
      return false;
    }

    /// The largest time step that the owned cells allow this effect.
    virtual TimeStepLimit
    time_step(const State<dim> &) const
    {
      return {std::numeric_limits<double>::infinity(), "", none};
    }
  };

  /// All effects, by name. Filled before main() by one line at the end of each effect's own file,
  ///
  ///     const EffectRegistration<2> registration(description, [](const EffectSetup<2> &s) { return ...; });
  ///
  /// An effect whose work is part of the Lagrange step itself (strength, voids) makes no pass.
  template <int dim>
  class EffectRegistry
  {
  public:
    using Make = std::function<std::unique_ptr<EffectPass<dim>>(const EffectSetup<dim> &)>;
    struct Entry
    {
      EffectDescription description;
      Make              make; ///< empty: no pass
    };

    /// All effects there are, in alphabetical order.
    static const std::map<std::string, Entry> &
    all()
    {
      return entries();
    }

  private:
    template <int>
    friend class EffectRegistration;

    static std::map<std::string, Entry> &
    entries()
    {
      static std::map<std::string, Entry> registry;
      return registry;
    }
  };

  /// Makes an effect known under its name.
  template <int dim>
  class EffectRegistration
  {
  public:
    explicit EffectRegistration(EffectDescription description, typename EffectRegistry<dim>::Make make = {})
    {
      const std::string name = description.name;
      EffectRegistry<dim>::entries().emplace(
          name, typename EffectRegistry<dim>::Entry{std::move(description), std::move(make)});
    }
  };

  /// The passes of the effects that are on, in the order of their names.
  template <int dim>
  std::vector<std::unique_ptr<EffectPass<dim>>>
  make_passes(const std::vector<std::string> &effects, const EffectSetup<dim> &setup);

  /// Descriptions of all effects, in the order of their names.
  std::vector<EffectDescription>
  effect_descriptions();
} // namespace whipple
