// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/hydro/cell_kernels.h>
#include <whipple/hydro/plasticity.h>
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
          const geometry::QuadOf<Pack> x        = gather_corners(mesh, state.position, first);
          const geometry::QuadOf<Pack> v        = gather_corners(mesh, state.velocity, first);
          const auto                   gradient = velocity_gradient(geometry::volume_gradient<symmetry>(x),
                                                                    geometry::hoop_weight<symmetry>(x), geometry::volume<symmetry>(x), v);
          const auto                   rate =
              plasticity::rates(gradient.l[0][0], gradient.l[0][1], gradient.l[1][0], gradient.l[1][1], gradient.hoop);
          // the equivalent of a rate is 2/3 of what that of a stress with its components would be
          const plasticity::Deviator<Pack> as_stress{rate.d00, rate.d11, rate.d01};
          store(Pack(2. / 3. * plasticity::equivalent_stress(as_stress)), result, first);
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
