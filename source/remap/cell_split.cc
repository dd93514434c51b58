// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/cell_split.h>

#include <whipple/mesh/cell_geometry.h>
#include <whipple/remap/child_volumes.h>
#include <whipple/state/momentum_restore.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace whipple
{
  namespace
  {
    /// Lower corner and edge of a cell.
    template <int dim>
    struct Box
    {
      Vector<dim> lower;
      double      size;

      Box(const Lattice<dim> &lattice, CellKey key)
        : size(lattice.extent(key_level(key)) * lattice.spacing)
      {
        const LatticePoint<dim> point = key_point<dim>(key);
        for (int d = 0; d < dim; ++d)
          lower[d] = lattice.origin[d] + point[d] * lattice.spacing;
      }

      /// The box of a child; the cell may be at the finest level.
      Box
      child(int c) const
      {
        Box box = *this;
        box.size *= 0.5;
        for (int d = 0; d < dim; ++d)
          if (c >> d & 1)
            box.lower[d] += box.size;
        return box;
      }

      /// Mass of each corner: integral of N_k over the true volume, scaled to the cell's mass.
      CornerValues<dim>
      corner_mass(Symmetry symmetry, double mass) const
      {
        CornerVectors<dim> x;
        for (int d = 0; d < dim; ++d)
          for (int k = 0; k < (1 << dim); ++k)
            x[d][k] = lower[d] + (k >> d & 1 ? size : 0.);
        CornerValues<dim> weight = corner_volume<dim>(symmetry, x);
        const double      sum    = std::accumulate(weight.begin(), weight.end(), 0.);
        for (double &w : weight)
          w *= mass / sum;
        return weight;
      }
    };

    template <int dim>
    double
    packet_mass(const CellPacketLayout<dim> &layout, const CellPacket &packet)
    {
      double sum = 0;
      if (!packet.empty())
        for (int m = 0; m < layout.n_materials(); ++m)
          sum += packet[layout.mass(m)];
      return sum;
    }

    template <int dim>
    Vector<dim>
    packet_velocity(const CellPacket &packet, int corner)
    {
      Vector<dim> u;
      for (int d = 0; d < dim; ++d)
        u[d] = packet[CellPacketLayout<dim>::velocity(d, corner)];
      return u;
    }

    /// Bilinear velocity at corner k of child c, written as increments on corner 0 so that a uniform one keeps
    /// its bits.
    template <int dim>
    Vector<dim>
    child_corner_velocity(const std::array<Vector<dim>, 1 << dim> &parent, int c, int k)
    {
      Vector<dim> u = parent[0];
      for (int j = 1; j < (1 << dim); ++j)
        {
          double shape = 1;
          for (int d = 0; d < dim; ++d)
            {
              const double xi = 0.5 * ((c >> d & 1) + (k >> d & 1));
              shape *= j >> d & 1 ? xi : 1. - xi;
            }
          for (int d = 0; d < dim; ++d)
            u[d] += shape * (parent[j][d] - parent[0][d]);
        }
      return u;
    }

    /// Corners of all children as points with mass and velocity.
    template <int dim>
    struct Points
    {
      static constexpr std::size_t n = 1 << (2 * dim);
      std::array<double, n>        mass{};
      std::array<Vector<dim>, n>   velocity{};
    };

    /// Weighted mean of children's values by increments on the first that counts.
    template <int dim, typename Value>
    double
    weighted_mean(const CornerValues<dim> &weight, Value value)
    {
      double sum = 0, total = 0, reference = 0;
      for (int c = 0; c < (1 << dim); ++c)
        {
          if (weight[c] == 0)
            continue;
          if (total == 0)
            reference = value(c);
          total += weight[c];
          sum += weight[c] * (value(c) - reference);
        }
      return total == 0 ? 0. : reference + sum / total;
    }

    /// Materials of the children, and which children got any; velocities are still zero.
    template <int dim>
    std::array<CellPacket, 1 << dim>
    split_materials(const CellPacketLayout<dim> &layout, Symmetry symmetry, const Box<dim> &box,
                    const CellPacket &packet)
    {
      std::vector<MaterialInCell<dim>> materials(layout.n_materials());
      for (int m = 0; m < layout.n_materials(); ++m)
        {
          materials[m].volume = packet[layout.volume(m)];
          for (int d = 0; d < dim; ++d)
            materials[m].normal[d] = packet[layout.normal(m, d)];
        }
      const auto share = child_shares<dim>(symmetry, box.lower, box.size, materials);

      std::array<CellPacket, 1 << dim> children;
      for (int c = 0; c < (1 << dim); ++c)
        for (int m = 0; m < layout.n_materials(); ++m)
          {
            if (share[m][c] == 0)
              continue;
            CellPacket &child = children[c];
            child.resize(layout.size(), 0.);
            for (int slot = layout.volume(m); slot < layout.volume(m + 1); ++slot)
              child[slot] = packet[slot];
            child[layout.volume(m)] *= share[m][c];
            child[layout.mass(m)] *= share[m][c];
          }
      return children;
    }

    /// Sums and means of one material over the children, into the parent's packet.
    template <int dim>
    void
    merge_material(const CellPacketLayout<dim> &layout, const std::array<CellPacket, 1 << dim> &children,
                   const CornerValues<dim> &room, int m, CellPacket &packet)
    {
      CornerValues<dim> volume{}, mass{};
      for (int c = 0; c < (1 << dim); ++c)
        if (!children[c].empty())
          {
            volume[c] = children[c][layout.volume(m)];
            mass[c]   = children[c][layout.mass(m)];
            packet[layout.volume(m)] += volume[c];
            packet[layout.mass(m)] += mass[c];
          }
      const auto mean = [&](const CornerValues<dim> &weight, int slot) {
        packet[slot] = weighted_mean<dim>(weight, [&](int c) { return children[c][slot]; });
      };
      mean(volume, layout.density(m));
      mean(mass, layout.energy(m));
      mean(volume, layout.void_fraction(m));
      for (int f = 0; f < layout.n_fields(); ++f)
        mean(layout.carrier[f] == Carrier::mass ? mass : volume, layout.field(m, f));

      // minus the gradient of the volume fraction over the children; zero where they are all alike
      Vector<dim> normal{};
      double      length_2 = 0;
      for (int d = 0; d < dim; ++d)
        {
          for (int c = 0; c < (1 << dim); ++c)
            normal[d] += (c >> d & 1 ? -1. : 1.) * volume[c] / room[c];
          length_2 += normal[d] * normal[d];
        }
      constexpr double round_off_2 = 1e-24;
      if (length_2 > round_off_2)
        for (int d = 0; d < dim; ++d)
          packet[layout.normal(m, d)] = normal[d] / std::sqrt(length_2);
    }
  } // namespace

  template <int dim>
  CellSplit<dim>::CellSplit(const Lattice<dim> &lattice, CellPacketLayout<dim> layout)
    : lattice_(lattice)
    , layout_(std::move(layout))
  {
  }

  template <int dim>
  typename CellSplit<dim>::Children
  CellSplit<dim>::split(CellKey parent, const CellPacket &packet) const
  {
    constexpr int corners = 1 << dim;
    if (packet.empty())
      return {};
    const Box<dim> box(lattice_, parent);
    Children       children = split_materials<dim>(layout_, lattice_.symmetry, box, packet);

    std::array<Vector<dim>, corners> velocity;
    for (int k = 0; k < corners; ++k)
      velocity[k] = packet_velocity<dim>(packet, k);
    const double            mass        = packet_mass(layout_, packet);
    const CornerValues<dim> corner_mass = box.corner_mass(lattice_.symmetry, mass);
    const Vector<dim>       mean        = mean_velocity<dim>(corner_mass, velocity);
    const double            available =
        relative_kinetic_energy<dim>(corner_mass, velocity, mean) + packet[layout_.kinetic_remainder()];

    Points<dim>       points;
    CornerValues<dim> child_mass{};
    for (int c = 0; c < corners; ++c)
      {
        child_mass[c]   = packet_mass(layout_, children[c]);
        const auto part = box.child(c).corner_mass(lattice_.symmetry, child_mass[c]);
        for (int k = 0; k < corners; ++k)
          {
            points.mass[c * corners + k]     = part[k];
            points.velocity[c * corners + k] = child_corner_velocity<dim>(velocity, c, k);
          }
      }
    const double remainder = restore_momentum<dim>(points.mass, points.velocity, mean, available);

    for (int c = 0; c < corners; ++c)
      if (!children[c].empty())
        {
          children[c][layout_.kinetic_remainder()] = remainder * (child_mass[c] / mass);
          for (int k = 0; k < corners; ++k)
            for (int d = 0; d < dim; ++d)
              children[c][layout_.velocity(d, k)] = points.velocity[c * corners + k][d];
        }
    return children;
  }

  template <int dim>
  CellPacket
  CellSplit<dim>::merge(CellKey parent, const Children &children) const
  {
    constexpr int     corners = 1 << dim;
    const Box<dim>    box(lattice_, parent);
    Points<dim>       points;
    CornerValues<dim> child_mass{};
    double            mass = 0, available = 0;
    for (int c = 0; c < corners; ++c)
      {
        child_mass[c] = packet_mass(layout_, children[c]);
        if (children[c].empty())
          continue;
        mass += child_mass[c];
        available += children[c][layout_.kinetic_remainder()];
        const auto part = box.child(c).corner_mass(lattice_.symmetry, child_mass[c]);
        for (int k = 0; k < corners; ++k)
          {
            points.mass[c * corners + k]     = part[k];
            points.velocity[c * corners + k] = packet_velocity<dim>(children[c], k);
          }
      }
    if (mass == 0)
      return {};

    CellPacket              packet(layout_.size(), 0.);
    const CornerValues<dim> room = child_volumes<dim>(lattice_.symmetry, box.lower, box.size);
    for (int m = 0; m < layout_.n_materials(); ++m)
      merge_material<dim>(layout_, children, room, m, packet);

    const Vector<dim> mean = mean_velocity<dim>(points.mass, points.velocity);
    available += relative_kinetic_energy<dim>(points.mass, points.velocity, mean);

    // the outer corner of child k; an empty child has none, so the same corner of the others stands in
    std::array<Vector<dim>, corners> velocity;
    for (int k = 0; k < corners; ++k)
      for (int d = 0; d < dim; ++d)
        velocity[k][d] =
            !children[k].empty()
                ? children[k][layout_.velocity(d, k)]
                : weighted_mean<dim>(child_mass, [&](int c) { return children[c][layout_.velocity(d, k)]; });
    packet[layout_.kinetic_remainder()] =
        restore_momentum<dim>(box.corner_mass(lattice_.symmetry, mass), velocity, mean, available);
    for (int k = 0; k < corners; ++k)
      for (int d = 0; d < dim; ++d)
        packet[layout_.velocity(d, k)] = velocity[k][d];
    return packet;
  }

  template <int dim>
  PacketRemap<dim>
  CellSplit<dim>::packet_remap() const
  {
    return {[copy = *this](CellKey parent, const CellPacket &packet) { return copy.split(parent, packet); },
            [copy = *this](CellKey parent, const Children &children) { return copy.merge(parent, children); }};
  }

  template class CellSplit<2>;
} // namespace whipple
