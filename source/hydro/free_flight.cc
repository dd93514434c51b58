// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/cell_shape.h>
#include <whipple/hydro/free_flight.h>
#include <whipple/mesh/cell_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Pressure, as a part of rho c^2, that is next to nothing: it can give a velocity of 1e-4 c.
    constexpr double little_stress = 1e-4;

    /// Times in (0, dt) at which a polynomial a + b t + c t^2 + d t^3, given by its values at 0, dt/3, 2 dt/3 and dt,
    /// has an extremum, and dt.
    std::array<double, 3>
    times_to_look(const std::array<double, 4> &value, double dt)
    {
      // Newton's forward differences in s = 3 t/dt
      const double d1 = value[1] - value[0], d2 = value[2] - 2. * value[1] + value[0];
      const double d3 = value[3] - 3. * value[2] + 3. * value[1] - value[0];
      // p(s) = v0 + s d1 + s(s-1)/2 d2 + s(s-1)(s-2)/6 d3;  p' = A s^2 + B s + C
      const double          a = 0.5 * d3, b = d2 - d3, c = d1 - 0.5 * d2 + d3 / 3.;
      std::array<double, 3> times{dt, dt, dt};
      const double          root = b * b - 4. * a * c;
      if (!(root >= 0))
        return times;
      const double q    = -0.5 * (b + std::copysign(std::sqrt(root), b));
      const auto   keep = [&](double s, double &time) {
        if (s > 0 && s < 3)
          time = s * dt / 3.;
      };
      if (a != 0)
        keep(q / a, times[0]);
      if (q != 0)
        keep(c / q, times[1]);
      return times;
    }

    CornerVectors<2>
    corners_after(const CornerVectors<2> &x, const CornerVectors<2> &u, double t)
    {
      CornerVectors<2> after;
      for (int d = 0; d < 2; ++d)
        for (int k = 0; k < 4; ++k)
          after[d][k] = x[d][k] + t * u[d][k];
      return after;
    }

    /// Corners of a cell and their velocities.
    std::array<CornerVectors<2>, 2>
    motion_of(const FlatMesh<2> &mesh, const State<2> &state, Index cell)
    {
      std::array<CornerVectors<2>, 2> result;
      for (int k = 0; k < 4; ++k)
        {
          const Index n = mesh.cell_node[4 * cell + k];
          for (int d = 0; d < 2; ++d)
            {
              result[0][d][k] = state.position[d][n];
              result[1][d][k] = state.velocity[d][n];
            }
        }
      return result;
    }

    /// Whether no material of a cell is pressed to less void than free flight needs.
    bool
    stays_open(const FlatMesh<2> &mesh, const State<2> &state, Index cell, double dt)
    {
      const auto [x, u]  = motion_of(mesh, state, cell);
      const double least = std::min(state.volume[cell], least_volume(mesh.symmetry, x, u, dt));
      if (!(least > 0))
        return false;
      for (const MaterialState &m : state.material)
        if (m.volume[cell] > 0 &&
            !(1. - (1. - m.void_fraction[cell]) * (state.volume[cell] / least) > free_void_fraction))
          return false;
      return true;
    }

    /// No material with stress or without voids; something at all.
    bool
    is_free(const State<2> &state, const Derived &derived, Index cell)
    {
      bool any = false;
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState &material = state.material[m];
          if (!(material.mass[cell] > 0))
            continue;
          any = true;
          if (!material.has_voids() || !(material.void_fraction[cell] > free_void_fraction))
            return false;
          const double c = derived.material[m].sound_speed[cell];
          if (!(std::abs(derived.material[m].pressure[cell]) <= little_stress * material.density[cell] * c * c))
            return false;
        }
      return any;
    }

    /// Whether nothing at the sides of the domain acts on a cell until dt.
    bool
    stays_inside(const FlatMesh<2> &mesh, const State<2> &state, const RigidWalls<2> &walls,
                 const Boundaries<2> &boundaries, Index cell, double dt)
    {
      for (int k = 0; k < 4; ++k)
        {
          const Index n = mesh.cell_node[4 * cell + k];
          for (int side = 0; side < 4; ++side)
            {
              const bool on_side = mesh.node_side[n] >> side & 1;
              if (on_side && boundaries[side].kind != BoundaryKind::reflecting)
                return false;
              const int    d = side / 2;
              const double x = state.position[d][n] + dt * state.velocity[d][n];
              if (walls.there[side] && !on_side && (side % 2 ? x >= walls.position[side] : x <= walls.position[side]))
                return false;
              if (on_side && state.velocity[d][n] != 0)
                return false;
            }
          if (mesh.symmetry == Symmetry::axisymmetric && state.position[0][n] + dt * state.velocity[0][n] < 0)
            return false;
        }
      return true;
    }
  } // namespace

  double
  least_volume(Symmetry symmetry, const CornerVectors<2> &x, const CornerVectors<2> &u, double dt)
  {
    const auto at    = [&](double t) { return cell_volume<2>(symmetry, corners_after(x, u, t)); };
    double     least = at(0.);
    for (const double t : times_to_look({least, at(dt / 3.), at(2. * dt / 3.), at(dt)}, dt))
      least = std::min(least, at(t));
    return least;
  }

  bool
  keeps_shape(const CornerVectors<2> &x, const CornerVectors<2> &u, double dt)
  {
    std::array<std::array<double, 4>, 4> jacobian; // at four times
    for (int i = 0; i < 4; ++i)
      jacobian[i] = CellShape<2>::corner_jacobian(corners_after(x, u, dt * i / 3.));
    for (int k = 0; k < 4; ++k)
      for (const double t : times_to_look({jacobian[0][k], jacobian[1][k], jacobian[2][k], jacobian[3][k]}, dt))
        if (CellShape<2>::folds(corners_after(x, u, t), least_jacobian_share))
          return false;
    return !CellShape<2>::folds(x, least_jacobian_share);
  }

  void
  soften_rubble(const FlatMesh<2> &mesh, const State<2> &state, double void_fraction, Derived &derived)
  {
    for (std::size_t m = 0; m < state.material.size(); ++m)
      {
        DerivedMaterial     &of       = derived.material[m];
        const MaterialState &material = state.material[m];
        if (of.shear_modulus.empty() || !material.has_voids())
          continue;
        for (Index c = 0; c < mesh.n_cells; ++c)
          {
            const bool rubble   = !mesh.intact[c] && material.void_fraction[c] > void_fraction;
            of.shear_modulus[c] = rubble ? 0. : of.shear_modulus[c];
            of.yield_stress[c]  = rubble ? 0. : of.yield_stress[c];
          }
      }
  }

  std::vector<std::uint8_t>
  flying_cells(const FlatMesh<2> &mesh, const State<2> &state, const Derived &derived, const RigidWalls<2> &walls,
               const Boundaries<2> &boundaries, double dt)
  {
    std::vector<std::uint8_t> flies(mesh.n_owned, 0);
    for (Index c = 0; c < mesh.n_owned; ++c)
      if (!mesh.intact[c] && !cell_shape::shares_nodes(mesh, c) && is_free(state, derived, c) &&
          stays_inside(mesh, state, walls, boundaries, c, dt) && stays_open(mesh, state, c, dt))
        {
          const auto [x, u] = motion_of(mesh, state, c);
          flies[c]          = keeps_shape(x, u, dt);
        }
    return flies;
  }

  void
  fly(const FlatMesh<2> &mesh, double dt, State<2> &state)
  {
    for (int d = 0; d < 2; ++d)
      for (Index n = 0; n < mesh.n_nodes; ++n)
        state.position[d][n] += dt * state.velocity[d][n];
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        const double volume = cell_volume(mesh.symmetry, cell_shape::corners_after(mesh, state, c, 0.));
        const double growth = volume / state.volume[c];
        for (MaterialState &m : state.material)
          if (m.volume[c] > 0)
            {
              m.volume[c] *= growth;
              m.density[c] /= growth;
              m.void_fraction[c] = 1. - (1. - m.void_fraction[c]) / growth;
              for (const int stress : state.index.stress)
                if (stress >= 0)
                  m.fields[stress].value[c] = 0.;
            }
        state.volume[c] = volume;
      }
  }
} // namespace whipple
