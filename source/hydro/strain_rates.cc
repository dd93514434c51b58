// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/hydro/cell_kernels.h>
#include <whipple/hydro/deviator.h>
#include <whipple/hydro/velocity_gradient.h>

namespace whipple::cell_kernels
{
  namespace
  {
    template <Symmetry symmetry, int dim>
    void
    strain_rates_of(const FlatMesh<dim> &mesh, const State<dim> &state, std::vector<double> &result)
    {
      for (Index first = 0; first < mesh.n_cells; first += pack_size)
        {
          const CornerVectors<dim, Pack> x = gather_corners(mesh, state.position, first);
          const CornerVectors<dim, Pack> v = gather_corners(mesh, state.velocity, first);
          using Cell                       = CellGeometry<dim, symmetry>;
          const DeformationRate<dim, Pack> rate(
              velocity_gradient<dim>(Cell::volume_gradient(x), Cell::hoop_weight(x), Cell::volume(x), v));
          // the equivalent of a rate is 2/3 of what that of a stress with its components would be
          store(Pack(2. / 3. * rate.deviator.equivalent()), result, first);
        }
    }
  } // namespace

  template <int dim>
  void
  strain_rates(const FlatMesh<dim> &mesh, const State<dim> &state, std::vector<double> &result)
  {
    if (mesh.symmetry == Symmetry::planar)
      strain_rates_of<Symmetry::planar>(mesh, state, result);
    else
      strain_rates_of<Symmetry::axisymmetric>(mesh, state, result);
  }

  template void
  strain_rates<2>(const FlatMesh<2> &, const State<2> &, std::vector<double> &);
} // namespace whipple::cell_kernels
