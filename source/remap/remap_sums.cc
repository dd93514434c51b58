// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/remap_sums.h>
#include <whipple/state/conversion.h>

namespace whipple
{
  namespace
  {
    const char *const            remap = "remap";
    const ConversionRegistration registration({40, remap}, ConversionListed::each_step);
  } // namespace

  template <int dim>
  void
  RemapSums<dim>::collect(MPI_Comm communicator)
  {
    std::array<ExactSum, 2> sums{remnant_mass, compressed};
    ExactSum::reduce(sums, communicator);
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    remnant_mass = rank == 0 ? sums[0] : ExactSum{};
    compressed   = rank == 0 ? sums[1] : ExactSum{};
  }

  template <int dim>
  Bookings<dim>
  RemapSums<dim>::bookings(KineticLoss loss) const
  {
    ConservedTotals<dim> left;
    for (const SideFlux<dim> &flux : side)
      {
        left.mass += flux.mass;
        left.internal_energy += flux.internal;
        left.kinetic_energy += flux.kinetic;
        for (int d = 0; d < dim; ++d)
          left.momentum[d] += flux.momentum[d];
      }
    Bookings<dim> result;
    result.leave("sides of the domain", left);
    result.enter(remap, lost_kinetic_energy<dim>(kinetic_lost, loss));
    result.enter("overfull cells compressed",
                 {.event = Event{static_cast<double>(cells_compressed), compressed.value(), "cm^3"}});
    result.enter("remnants given away by cells left almost empty",
                 {.event = Event{static_cast<double>(remnant_cells), remnant_mass.value(), "g"}});
    return result;
  }

  template struct RemapSums<2>;
} // namespace whipple
