// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/hydro/cell_kernels.h>
#include <whipple/hydro/trace.h>
#include <whipple/hydro/viscosity.h>

namespace whipple::cell_kernels
{
  template <int dim>
  void
  stretch_rates(const FlatMesh<dim> &mesh, const State<dim> &state, StepWork<dim> &work)
  {
    for (Index first = 0; first < mesh.n_cells; first += pack_size)
      {
        const CornerVectors<dim, Pack> x      = gather_corners(mesh, work.half_position, first);
        const CornerVectors<dim, Pack> v      = gather_corners(mesh, state.velocity, first);
        const Pack                     volume = load(state.volume, first);
        Pack                           mass(0.);
        auto                           felt = mass > 0.; // something has a state
        for (std::size_t m = 0; m < state.material.size(); ++m)
          {
            mass += load(state.material[m].mass, first);
            felt = felt || trace::has_state(state.material[m], work.material[m], volume, first);
          }
        mass = select(felt, mass, Pack(0.));
        store(mass, work.mass, first);
        const Index end = std::min<Index>(mesh.n_cells, first + pack_size);
        for (int d = 0; d < dim; ++d)
          {
            const Pack rate = select(mass > 0., viscosity::stretch(d, x, v).rate, Pack(0.));
            // the entry past the last cell stands for "no neighbour" and must stay 0
            for (Index cell = first; cell < end; ++cell)
              work.stretch_rate[d][cell] = rate[cell - first];
          }
      }
  }

  template void
  stretch_rates<2>(const FlatMesh<2> &, const State<2> &, StepWork<2> &);
} // namespace whipple::cell_kernels
