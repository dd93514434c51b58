// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/effect/effect.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/ledger/ledger.h>
#include <whipple/mesh/halo.h>
#include <whipple/problem/field_layout.h>
#include <whipple/remap/directional_remap.h>
#include <whipple/run/phase_clock.h>
#include <whipple/scene/scene.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace whipple
{
  /// The time step of all ranks and what set it.
  struct AgreedTimeStep
  {
    double      dt; ///< us
    std::string reason;
    Vector<2>   place; ///< cm, lower corner of the cell that set it; not numbers if no cell did
  };

  /// One ALE cycle on one flat mesh: Lagrange step with its effects, then, if the target mesh is the fixed
  /// one, the remap. Kernels run over owned and halo cells; the halo is refreshed between them.
  template <int dim>
  class Cycle
  {
  public:
    Cycle(const Scene<dim> &scene, const Stage &stage, const FieldLayout &layout, const FlatMesh<dim> &mesh,
          const Halo<dim> &halo, PhaseClock &phases);

    /// Node masses of a state whose cells or nodes are new (after a regrid or projection), and all that follows from
    /// it.
    void
    refresh(State<dim> &state, Derived &derived);

    /// All that follows from a state. Node masses are carried: the remap moves them together with the momenta, and the
    /// sum over the cells is another in the last bits.
    void
    evaluate(const State<dim> &state, Derived &derived);

    /// @param derived of this state
    /// @param exempt  owned elements, ascending, that keep their shape
    /// @throws StateError on all ranks
    AgreedTimeStep
    time_step(const State<dim> &state, const Derived &derived, std::span<const Index> exempt);

    /// Owned elements that would limit the step to less than `bound` [us] because they are slivers.
    std::vector<Index>
    slivers(const State<dim> &state, const Derived &derived, double bound) const;

    /// Advance by dt and enter into the ledger what left and what was converted.
    /// @param derived of the state; afterwards of the new one
    /// @param sweep_first axis of the first sweep of the remap; alternate it.
    /// @param rigid owned elements that keep their shape
    /// @throws StateError on all ranks, also what a pass of an effect throws on one of them; state and derived are then
    /// of no further use.
    void
    advance(State<dim> &state, Derived &derived, double dt, int sweep_first, std::span<const RigidFragment<dim>> rigid,
            Ledger<dim> &ledger);

  private:
    /// The passes of the effects, each with pressures of the state it gets; they are those of the state afterwards.
    /// @param meet collective; throws on all ranks if one has failed
    void
    run_passes(State<dim> &state, Derived &derived, double dt, const std::function<void()> &meet);
    void
    exchange(State<dim> &state) const;
    void
    evaluate_strength(const State<dim> &state, Derived &derived);
    /// Pressures and sound speeds in the halo: where those of the owned cells need no second evaluation.
    void
    exchange_pressures(Derived &derived) const;

    const FieldLayout                   &layout_;
    const FlatMesh<dim>                 &mesh_;
    const Halo<dim>                     &halo_;
    PhaseClock                          &phases_;
    KineticLoss                          lost_kinetic_energy_;
    std::optional<double>                rubble_void_; ///< Lagrangian stages: elements of their own are rubble above it
    LagrangeStep<dim>                    lagrange_;
    EffectPasses<dim>                    effects_; ///< that are on
    std::optional<DirectionalRemap<dim>> remap_;
  };
} // namespace whipple
