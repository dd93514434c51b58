// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/run/run_state.h>
#include <whipple/scene/stage_end.h>

namespace whipple
{
  /// A running stage as its end sees it, with the debris that waits for it.
  template <int dim>
  class RunView : public StageView
  {
  public:
    /// All are kept by reference.
    RunView(const Scene<dim> &scene, const FieldLayout &layout, const RunState<dim> &run)
      : scene_(scene)
      , layout_(layout)
      , run_(run)
    {
    }

    double
    time() const override;
    double
    start() const override;
    double
    finest_cell() const override;
    double
    foremost() const override;
    double
    fastest() const override;
    double
    coming(double velocity) const override;
    Debris
    beyond(double plane, double velocity) const override;
    /// Kinetic energy of each body (of all together where they cannot be told apart), hole diameter and crater depth of
    /// each plate.
    std::map<std::string, double>
    watched() const override;

  private:
    /// Call visit(part, corners, their velocities) for all that waits, on all ranks.
    template <typename Visit>
    void
    for_each_waiting(const Visit &visit) const;

    const Scene<dim>    &scene_;
    const FieldLayout   &layout_;
    const RunState<dim> &run_;
  };
} // namespace whipple
