// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/effect/effect.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/ledger/ledger.h>
#include <whipple/mesh/halo.h>
#include <whipple/problem/field_layout.h>
#include <whipple/remap/directional_remap.h>
#include <whipple/scene/scene.h>

#include <memory>
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
          const Halo<dim> &halo);

    /// Fill what is derived from the carried state (after a regrid or projection): node masses, pressures.
    void
    refresh(State<dim> &state) const;

    /// What it was made for.
    const FlatMesh<dim> *
    mesh() const
    {
      return &mesh_;
    }

    /// @param exempt owned elements, ascending, that keep their shape
    AgreedTimeStep
    time_step(const State<dim> &state, std::span<const Index> exempt) const;

    /// Owned elements that would limit the step to less than `bound` [us] because they are slivers.
    std::vector<Index>
    slivers(const State<dim> &state, double bound) const;

    /// Advance by dt and enter into the ledger what left and what was converted.
    /// @param sweep_first axis of the first sweep of the remap; alternate it.
    /// @param rigid owned elements that keep their shape
    /// @throws StateError on all ranks; the state is then of no further use.
    void
    advance(State<dim> &state, double dt, int sweep_first, std::span<const RigidFragment<dim>> rigid,
            Ledger<dim> &ledger);

  private:
    void
    exchange(State<dim> &state) const;
    void
    book(const LagrangeReport<dim> &motion, const RemapReport<dim> &remap, Ledger<dim> &ledger) const;

    const FieldLayout                            &layout_;
    const FlatMesh<dim>                          &mesh_;
    const Halo<dim>                              &halo_;
    KineticLoss                                   lost_kinetic_energy_;
    LagrangeStep<dim>                             lagrange_;
    std::vector<std::unique_ptr<EffectPass<dim>>> passes_; ///< of the effects that are on and have one
    std::optional<DirectionalRemap<dim>>          remap_;
  };
} // namespace whipple
