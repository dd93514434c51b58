// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/effect/effect_books.h>
#include <whipple/effect/effect_parameters.h>
#include <whipple/hydro/step_work.h>
#include <whipple/hydro/time_step.h>
#include <whipple/material/material.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/mesh/meeting_halo.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <limits>
#include <string>
#include <vector>

namespace whipple
{
  /// Position of a field of that name, -1 if nothing registered it.
  int
  field_index(const std::vector<FieldDescription> &fields, const std::string &name);

  /// What a pass is made for; mesh, materials and fields outlive the pass.
  template <int dim>
  struct EffectSetup
  {
    const FlatMesh<dim>                 &mesh;
    const std::vector<Material>         &materials;
    const std::vector<FieldDescription> &fields; ///< of the state, in their order
    EffectParameters                     parameters = {};

    /// Index of a field of the state.
    /// @throws std::logic_error if nothing registered it.
    int
    field(const std::string &name) const;

    /// Value of a parameter, internal units.
    /// @throws std::logic_error if the effect does not declare it.
    double
    parameter(const std::string &key) const;
  };

  /// What a pass works on in one step.
  template <int dim>
  struct EffectStep
  {
    /// At the end of the Lagrange step and of the passes before this one; changed in place. Owned cells are right, and
    /// one layer of halo around them at least.
    State<dim> &state;

    /// Pressures and sound speeds of the state.
    const Derived &derived;

    /// The state that the step started from, as far as the Lagrange step changes it: `position`, `velocity`, `volume`;
    /// of each material `volume`, `density`, `energy`, `void_fraction`, `stress`, `plastic_strain`.
    const StepWork<dim> &before;

    double dt; ///< us

    /// For what reaches further than one layer, or depends on what this pass has changed.
    const MeetingHalo<dim> &halo;

    /// What is changed of mass, momentum or energy is entered here, under the causes that the effect declares.
    EffectBooks<dim> &books;
  };

  /// The work of an effect in every cycle, after the Lagrange step: one pass over flat arrays, owned and halo cells.
  /// One object belongs to one mesh; what it must know from step to step is a field of the state.
  template <int dim>
  class EffectPass
  {
  public:
    virtual ~EffectPass() = default;

    /// @throws StateError where it cannot go on; one rank is enough
    virtual void
    advance(const EffectStep<dim> &step) = 0;

    /// True if it changes energies: pressures are evaluated anew then.
    virtual bool
    changes_energy() const
    {
      return false;
    }

    /// True if it leaves the halo as it was: the halo is refreshed then before another pass.
    virtual bool
    leaves_out_halo() const
    {
      return false;
    }

    /// The largest time step that the owned cells allow this effect. Must not communicate.
    virtual TimeStepLimit
    time_step(const State<dim> &) const
    {
      return {std::numeric_limits<double>::infinity(), "", none};
    }
  };
} // namespace whipple
