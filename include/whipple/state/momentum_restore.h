// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace whipple
{
  /// Mass-weighted mean of point velocities, u_ref + sum m (u - u_ref) / M with the first point that has mass as
  /// reference, so that equal velocities give that velocity to the last bit. Zero without mass.
  template <int dim, std::size_t n>
  Vector<dim>
  mean_velocity(const std::array<double, n> &mass, const std::array<Vector<dim>, n> &velocity)
  {
    Vector<dim> mean{}, reference{};
    double      total = 0;
    for (std::size_t i = 0; i < n; ++i)
      {
        if (mass[i] == 0)
          continue;
        if (total == 0)
          reference = velocity[i];
        total += mass[i];
        for (int d = 0; d < dim; ++d)
          mean[d] += mass[i] * (velocity[i][d] - reference[d]);
      }
    for (int d = 0; d < dim; ++d)
      mean[d] = total == 0 ? 0. : reference[d] + mean[d] / total;
    return mean;
  }

  /// Kinetic energy sum m |u - mean|^2 / 2 of the motion about a mean velocity.
  template <int dim, std::size_t n>
  double
  relative_kinetic_energy(const std::array<double, n> &mass, const std::array<Vector<dim>, n> &velocity,
                          const Vector<dim> &mean)
  {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (int d = 0; d < dim; ++d)
        sum += 0.5 * mass[i] * (velocity[i][d] - mean[d]) * (velocity[i][d] - mean[d]);
    return sum;
  }

  /// Shift point velocities so that their mean becomes `target` (momentum exact). If their relative kinetic energy
  /// then exceeds `available`, scale the deviations from the mean by sqrt(available / energy): no
  /// kinetic energy is made. Returns what is left of `available`, >= 0.
  template <int dim, std::size_t n>
  double
  restore_momentum(const std::array<double, n> &mass, std::array<Vector<dim>, n> &velocity, const Vector<dim> &target,
                   double available)
  {
    const Vector<dim> mean   = mean_velocity<dim>(mass, velocity);
    const double      energy = relative_kinetic_energy<dim>(mass, velocity, mean);
    if (energy <= available)
      {
        for (auto &u : velocity)
          for (int d = 0; d < dim; ++d)
            u[d] += target[d] - mean[d];
        return available - energy;
      }
    const double scale = std::sqrt(available / energy);
    for (auto &u : velocity)
      for (int d = 0; d < dim; ++d)
        u[d] = target[d] + scale * (u[d] - mean[d]);
    return 0;
  }
} // namespace whipple
