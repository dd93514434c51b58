// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/release_line.h>

#include <cmath>
#include <vector>

namespace whipple::aluminium_phases
{
  namespace
  {
    constexpr int    steps          = 1000;
    constexpr double coldest_energy = -0.0027; // the solid at 6 K

    /// Density of a phase at (P = 0, e), by Newton's method from the density given.
    template <class Phase>
    double
    unstressed(double density, double energy)
    {
      for (int iteration = 0; iteration < 50; ++iteration)
        {
          const auto p = Phase::caloric(density, energy);
          density -= p.pressure / p.dp_ddensity;
        }
      return density;
    }

    /// Density of the liquid that boils at energy e: bisection along the boiling curve.
    double
    boiling_density(const Boiling &boiling, double energy)
    {
      double lower = boiling.first(), upper = boiling.last();
      for (double middle = 0.5 * (lower + upper); lower < middle && middle < upper; middle = 0.5 * (lower + upper))
        (boiling.tie_line(middle).dense_energy.value > energy ? lower : upper) = middle;
      return boiling.dense_density(upper);
    }

    template <class Phase>
    double
    stiffness_of(double density, double energy)
    {
      return density * Phase::caloric(density, energy).dp_ddensity;
    }
  } // namespace

  ReleaseLine::ReleaseLine(const Melting &melting, const Boiling &boiling)
    : melting_temperature_(melting.first())
  {
    const auto melt = melting.tie_line(melting.first());
    melt_onset      = melt.dense_energy.value;
    melt_complete   = melt.light_energy.value;
    solid_volume_   = melt.dense_volume.value;
    liquid_volume_  = melt.light_volume.value;
    vapour_onset    = boiling.tie_line(boiling.last()).dense_energy.value;
    critical_energy = boiling.tie_line(boiling.first()).dense_energy.value;

    const double        solid_step = (melt_onset - coldest_energy) / steps;
    double              density    = 2.75;
    std::vector<double> densities, stiffnesses;
    for (int i = 0; i <= steps; ++i)
      {
        const double energy = coldest_energy + i * solid_step;
        density             = unstressed<Solid>(density, energy);
        densities.push_back(density);
        stiffnesses.push_back(stiffness_of<Solid>(density, energy));
      }
    solid_density_   = HermiteTable(coldest_energy, solid_step, densities);
    solid_stiffness_ = HermiteTable(coldest_energy, solid_step, stiffnesses);

    const double fluid_step = (critical_energy - melt_complete) / steps;
    density                 = 1. / liquid_volume_;
    densities.clear();
    stiffnesses.clear();
    for (int i = 0; i <= steps; ++i)
      {
        const double energy = melt_complete + i * fluid_step;
        density = energy < vapour_onset ? unstressed<Fluid>(density, energy) : boiling_density(boiling, energy);
        densities.push_back(density);
        stiffnesses.push_back(stiffness_of<Fluid>(density, energy));
      }
    fluid_density_   = HermiteTable(melt_complete, fluid_step, densities);
    fluid_stiffness_ = HermiteTable(melt_complete, fluid_step, stiffnesses);
  }

  HermiteTable::Value
  ReleaseLine::density(double energy) const
  {
    if (energy <= melt_onset)
      return solid_density_(energy);
    if (energy >= melt_complete)
      return fluid_density_(energy);
    // Volumes and energies of the phases add.
    const double width  = melt_complete - melt_onset;
    const double rise   = (liquid_volume_ - solid_volume_) / width;
    const double volume = solid_volume_ + rise * (energy - melt_onset);
    return {1. / volume, -rise / (volume * volume)};
  }

  HermiteTable::Value
  ReleaseLine::stiffness(double energy) const
  {
    if (energy <= melt_onset)
      return solid_stiffness_(energy);
    if (energy >= melt_complete)
      return fluid_stiffness_(energy);
    // The mean of the phases: melting does not follow tension.
    const double solid = solid_stiffness_(melt_onset).value, liquid = fluid_stiffness_(melt_complete).value;
    const double rise = (liquid - solid) / (melt_complete - melt_onset);
    return {solid + rise * (energy - melt_onset), rise};
  }

  double
  ReleaseLine::temperature(double energy) const
  {
    if (energy <= melt_onset)
      return Solid::temperature(solid_density_(energy).value, energy);
    if (energy >= melt_complete)
      return Fluid::temperature(fluid_density_(energy).value, energy);
    return melting_temperature_;
  }

  double
  ReleaseLine::melt_fraction(double energy) const
  {
    return std::clamp((energy - melt_onset) / (melt_complete - melt_onset), 0., 1.);
  }
} // namespace whipple::aluminium_phases
