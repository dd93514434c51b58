// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/cell_kernels.h>

namespace whipple::cell_kernels
{
  template <int dim>
  void
  corner_forces(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                const HydroParameters &parameters, double dt, StepWork<dim> &work)
  {
    switch (parameters.viscosity)
      {
      case ViscosityKind::scalar:
        return corner_forces_scalar(mesh, state, derived, parameters, dt, work);
      case ViscosityKind::tensor:
        return corner_forces_tensor(mesh, state, derived, parameters, dt, work);
      }
  }

  template void
  corner_forces<2>(const FlatMesh<2> &, const State<2> &, const Derived &, const HydroParameters &, double,
                   StepWork<2> &);
} // namespace whipple::cell_kernels
