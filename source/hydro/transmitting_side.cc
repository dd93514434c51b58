// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/hydro/deviator.h>
#include <whipple/hydro/transmitting_side.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace whipple
{
  template <int dim>
  BeyondSide
  beyond_side(const Boundary<dim> &boundary, std::size_t material, const EquationOfState &eos)
  {
    SideMedium medium;
    if (material < boundary.medium.size())
      medium = boundary.medium[material];
    const std::array<double, 1> density{medium.density > 0 ? medium.density : eos.reference_density()},
        energy{medium.energy};
    std::array<double, 1> pressure{}, square{};
    eos.evaluate(density, energy, pressure, square);
    return {boundary.keeps_ambient ? boundary.pressure : 0., density[0],
            density[0] * std::sqrt(std::max(square[0], 0.))};
  }

  double
  secant_impedance(const BeyondSide &ambient, double stress, double density, double sound_speed, double steepening)
  {
    const double own = density * sound_speed;
    // what is thinner than the ambient has been shocked and released, or holds voids: it goes on as it is
    if (!(ambient.impedance > 0 && density > ambient.density))
      return own;
    const double least = std::min(ambient.impedance, own), most = std::max(ambient.impedance, own) + steepening;
    // the difference of densities is exact where that of volumes rounds to zero, beside the ambient density
    const double square = (stress - ambient.pressure) * (ambient.density * density / (density - ambient.density));
    return std::clamp(std::sqrt(std::max(square, 0.)), least, most);
  }

  template <int dim>
  OutgoingWave
  outgoing_wave(const SideContact &at, const std::vector<BeyondSide> &beyond, const State<dim> &state,
                const Derived &derived, double dt, const StepWork<dim> &work)
  {
    const Index  cell      = at.cell;
    const double viscosity = work.half_step[cell / pack_size].viscosity[cell % pack_size];
    const double steepening =
        viscosity > 0 ? viscosity / std::max(std::abs(at.opening), std::numeric_limits<double>::min()) : 0.;
    OutgoingWave wave;
    for (std::size_t m = 0; m < state.material.size(); ++m)
      {
        const MaterialState   &material = state.material[m];
        const DerivedMaterial &from     = derived.material[m];
        if (!(material.volume[cell] > 0))
          continue;
        const double share = material.volume[cell] / state.volume[cell], density = material.density[cell];
        const double bulk = from.sound_speed[cell];
        wave.normal += share * secant_impedance(beyond[m], from.pressure[cell] + viscosity, density, bulk, steepening);
        if (from.shear_modulus.empty())
          continue;
        const double solid = material.has_voids() ? 1. - material.void_fraction[cell] : 1.;
        const double shear = solid * from.shear_modulus[cell];
        const double yield = solid * from.yield_stress[cell];
        const double along = std::sqrt(bulk * bulk + 4. / 3. * shear / density);
        if (!(along > 0))
          continue;
        // the deviator at the side in the middle of the step: half a cell further on the way of an elastic wave
        const double trial = solid * StoredDeviator<dim>(material, state.index).at(cell).normal(at.axis) +
                             4. / 3. * shear * at.opening * (0.5 * dt / at.depth - 0.5 / along);
        const double deviator = std::clamp(trial, -2. / 3. * yield, 2. / 3. * yield);
        wave.pressure -= share * deviator * along / (along + bulk);
        const double sliding = std::sqrt(density * shear), most = yield / std::sqrt(3.);
        wave.tangential += share * (sliding * at.sliding > most ? most / at.sliding : sliding);
      }
    return wave;
  }

  template BeyondSide
  beyond_side(const Boundary<2> &, std::size_t, const EquationOfState &);
  template OutgoingWave
  outgoing_wave(const SideContact &, const std::vector<BeyondSide> &, const State<2> &, const Derived &, double,
                const StepWork<2> &);
} // namespace whipple
