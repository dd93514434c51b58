// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/deposit.h>

#include <whipple/error.h>
#include <whipple/state/momentum_restore.h>

#include <algorithm>
#include <string>

namespace whipple::projection
{
  namespace
  {
    /// No material, of the same kinds.
    std::vector<MaterialState>
    empty_like(const std::vector<MaterialState> &materials)
    {
      std::vector<MaterialState> result;
      for (const MaterialState &like : materials)
        {
          MaterialState material;
          for (auto *array : {&material.volume, &material.mass, &material.density, &material.energy})
            array->assign(like.volume.size(), 0.);
          material.carries_voids = like.has_voids();
          if (material.carries_voids)
            material.void_fraction.assign(like.volume.size(), 0.);
          for (const Field &field : like.fields)
            material.fields.push_back({field.description, std::vector<double>(like.volume.size(), 0.)});
          result.push_back(std::move(material));
        }
      return result;
    }

    ConservedTotals<2>
    totals(const Motion &motion)
    {
      ConservedTotals<2> result;
      result.mass           = motion.mass;
      result.kinetic_energy = motion.kinetic;
      for (int d = 0; d < 2; ++d)
        {
          result.momentum[d] = motion.mass * motion.mean_u[d];
          result.kinetic_energy += 0.5 * motion.mass * motion.mean_u[d] * motion.mean_u[d];
        }
      return result;
    }
  } // namespace

  Deposit::Deposit(const Lattice<2> &lattice, const CellPacketLayout<2> &layout, const FlatMesh<2> &mesh,
                   State<2> &state)
    : layout_(layout)
    , symmetry_(lattice.symmetry)
    , mesh_(mesh)
    , state_(state)
    , tree_(lattice, mesh.key)
    , existing_(corner_velocities<2>(mesh, state))
    , existing_mass_(mesh.n_cells)
    , laid_{empty_like(state.material), std::vector<Motion>(mesh.n_cells)}
  {
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      existing_mass_[cell] = cell_mass<2>(state, cell);
  }

  void
  Deposit::lay_down(const Element<2> &element, const ElementPieces &pieces)
  {
    for (int m = 0; m < layout_.n_materials(); ++m)
      if (pieces.void_fraction[m] > 0 && !layout_.has_voids[m])
        throw StateError("projection onto cells: material " + std::to_string(m) + " comes with void fraction " +
                         std::to_string(pieces.void_fraction[m]) + " but has no void law");
    for (const Triangle &triangle : pieces.triangle)
      {
        Vector<2> lower, upper;
        bounds({&triangle, 1}, lower, upper);
        tree_.for_each_overlap(lower, upper, [&](Index cell, const Vector<2> &a, const Vector<2> &b) {
          const Moments part = moments(symmetry_, clip(triangle, a, b));
          if (!(part.volume > 0))
            return;
          laid_.motion[cell].add(pieces.motion(part));
          add_materials(element, pieces, part.volume / pieces.volume, cell);
        });
      }
  }

  void
  Deposit::add_materials(const Element<2> &element, const ElementPieces &pieces, double share, Index cell)
  {
    const CellPacket &packet = element.packet;
    for (int m = 0; m < layout_.n_materials(); ++m)
      {
        const MaterialShare part{share * pieces.material_volume[m], share * packet[layout_.mass(m)],
                                 packet[layout_.mass(m)] / pieces.material_volume[m], packet[layout_.energy(m)],
                                 pieces.void_fraction[m]};
        add_share(
            part, [&](std::size_t f) { return packet[layout_.field(m, static_cast<int>(f))]; }, laid_.material[m],
            cell);
      }
  }

  double
  Deposit::owned_mass() const
  {
    double sum = 0;
    for (Index cell = 0; cell < mesh_.n_owned; ++cell)
      sum += laid_.motion[cell].mass;
    return sum;
  }

  std::array<Vector<2>, 4>
  Deposit::debris_corners(Index cell, const std::array<double, 4> &shares, double &remainder) const
  {
    const Motion            &motion   = laid_.motion[cell];
    const auto               gradient = motion.gradient(mesh_.size[cell]);
    std::array<Vector<2>, 4> u;
    std::array<double, 4>    mass;
    for (int k = 0; k < 4; ++k)
      {
        mass[k] = shares[k] * motion.mass;
        u[k]    = motion.mean_u;
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b)
            u[k][a] += gradient[a][b] * (k >> b & 1 ? 1. : 0.) * mesh_.size[cell];
      }
    remainder = restore_momentum<2>(mass, u, motion.mean_u, motion.kinetic);
    return u;
  }

  CornerVelocities<2>
  Deposit::finish()
  {
    for (std::size_t m = 0; m < state_.material.size(); ++m)
      for (Index cell = 0; cell < mesh_.n_cells; ++cell)
        add_part(laid_.material[m], cell, 1., state_.material[m], cell);
    CornerVelocities<2> result = existing_;
    for (Index cell = 0; cell < mesh_.n_cells; ++cell)
      {
        if (laid_.motion[cell].mass == 0)
          continue;
        const double total  = existing_mass_[cell] + laid_.motion[cell].mass;
        const auto   shares = corner_shares<2>(state_, cell);
        double       remainder;
        const auto   u = debris_corners(cell, shares, remainder);
        // what was there and what came meet inelastically, corner by corner
        const double reduced = existing_mass_[cell] * (laid_.motion[cell].mass / total);
        for (int k = 0; k < 4; ++k)
          for (int d = 0; d < 2; ++d)
            {
              double      &v    = result.velocity[d][cell * 4 + k];
              const double slip = u[k][d] - v;
              remainder += 0.5 * shares[k] * reduced * slip * slip;
              v = existing_mass_[cell] == 0 ? u[k][d] : v + laid_.motion[cell].mass / total * slip;
            }
        result.kinetic_remainder[cell] += remainder;
      }
    return result;
  }

  ConservedTotals<2>
  beyond_domain(const Lattice<2> &lattice, const CellPacketLayout<2> &layout, const Element<2> &element,
                const ElementPieces &pieces)
  {
    Vector<2> lower, upper, first, last;
    bounds(pieces.triangle, lower, upper);
    bool inside = true;
    for (int d = 0; d < 2; ++d)
      {
        first[d] = lattice.origin[d];
        last[d]  = lattice.origin[d] + lattice.finest(d) * lattice.spacing;
        inside   = inside && lower[d] >= first[d] && upper[d] <= last[d];
      }
    if (inside)
      return {};

    Motion all, within;
    for (const Triangle &triangle : pieces.triangle)
      {
        all.add(pieces.motion(moments(lattice.symmetry, as_polygon(triangle))));
        const Moments part = moments(lattice.symmetry, clip(triangle, first, last));
        if (part.volume > 0)
          within.add(pieces.motion(part));
      }
    ConservedTotals<2>       left   = totals(all);
    const ConservedTotals<2> stayed = totals(within);
    left.mass -= stayed.mass;
    left.kinetic_energy -= stayed.kinetic_energy;
    for (int d = 0; d < 2; ++d)
      left.momentum[d] -= stayed.momentum[d];
    for (int m = 0; m < layout.n_materials(); ++m)
      left.internal_energy +=
          element.packet[layout.mass(m)] * element.packet[layout.energy(m)] * (left.mass / all.mass);
    return left;
  }
} // namespace whipple::projection
