// SPDX-License-Identifier: LGPL-2.1-or-later
#include "corner_forces_kernel.h"

namespace whipple::cell_kernels
{
  template <int dim>
  void
  corner_forces_scalar(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                       const HydroParameters &parameters, double dt, StepWork<dim> &work)
  {
    corner_forces_with<ViscosityKind::scalar>(mesh, state, derived, parameters, dt, work);
  }

  template void
  corner_forces_scalar(const FlatMesh<2> &, const State<2> &, const Derived &, const HydroParameters &, double,
                       StepWork<2> &);
} // namespace whipple::cell_kernels
