// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/child_volumes.h>

#include <whipple/remap/interface_plane.h>

#include <algorithm>
#include <numbers>
#include <numeric>

namespace whipple
{
  namespace
  {
    template <int dim>
    using Shares = std::array<double, 1 << dim>;

    template <int dim>
    struct Cut
    {
      Symmetry    symmetry;
      Vector<dim> lower;
      double      size;

      Vector<dim>
      child_lower(int child) const
      {
        Vector<dim> x = lower;
        for (int d = 0; d < dim; ++d)
          if (child >> d & 1)
            x[d] += 0.5 * size;
        return x;
      }

      static Vector<dim>
      upper(Vector<dim> x, double edge)
      {
        for (int d = 0; d < dim; ++d)
          x[d] += edge;
        return x;
      }

      /// Volumes in the children below the plane that holds `fraction` of the cell.
      Shares<dim>
      below(const Vector<dim> &normal, double fraction) const
      {
        const double offset = interface_plane::offset_of_fraction<dim>(symmetry, lower, upper(lower, size), normal,
                                                                       std::clamp(fraction, 0., 1.));
        Shares<dim>  volume;
        for (int c = 0; c < (1 << dim); ++c)
          {
            const Vector<dim> x = child_lower(c);
            volume[c] = interface_plane::volume_below<dim>(symmetry, x, upper(x, 0.5 * size), lower, normal, offset);
          }
        return volume;
      }
    };

    template <int dim>
    bool
    is_zero(const Vector<dim> &normal)
    {
      return std::all_of(normal.begin(), normal.end(), [](double n) { return n == 0; });
    }

    /// Make volumes shares of their sum, without slivers. The differences of stacked planes may be negative by
    /// round-off; those are slivers too. An amount too small for its plane to be told from the cell's corner is
    /// shared like the room.
    template <int dim>
    void
    normalise(Shares<dim> &share, const Shares<dim> &room)
    {
      constexpr double sliver = 1e-13;
      if (!(std::accumulate(share.begin(), share.end(), 0.) > 0))
        share = room;
      const double total = std::accumulate(share.begin(), share.end(), 0.);
      double       sum   = 0;
      for (double &s : share)
        {
          s = s > sliver * total ? s : 0.;
          sum += s;
        }
      for (double &s : share)
        s /= sum;
    }

    template <int dim>
    bool
    fits(const std::vector<Shares<dim>> &share, const std::vector<MaterialInCell<dim>> &materials,
         const Shares<dim> &room, double cell)
    {
      constexpr double round_off = 1e-12;
      for (int c = 0; c < (1 << dim); ++c)
        {
          double filled = 0;
          for (std::size_t m = 0; m < materials.size(); ++m)
            filled += share[m][c] * materials[m].volume;
          if (filled > room[c] + round_off * cell)
            return false;
        }
      return true;
    }

    /// All materials between planes with one normal, in their order.
    template <int dim>
    void
    stack(const Cut<dim> &cut, const Vector<dim> &normal, const Shares<dim> &room, double cell,
          const std::vector<MaterialInCell<dim>> &materials, std::vector<Shares<dim>> &share)
    {
      Shares<dim> filled{};
      double      volume = 0;
      for (std::size_t m = 0; m < materials.size(); ++m)
        {
          if (!(materials[m].volume > 0))
            continue;
          volume += materials[m].volume;
          const Shares<dim> now = cut.below(normal, volume / cell);
          for (int c = 0; c < (1 << dim); ++c)
            share[m][c] = now[c] - filled[c];
          filled = now;
          normalise<dim>(share[m], room);
        }
    }
  } // namespace

  template <int dim>
  std::array<double, 1 << dim>
  child_volumes(Symmetry symmetry, const Vector<dim> &lower, double size)
  {
    const Cut<dim> cut{symmetry, lower, size};
    Shares<dim>    volume;
    for (int c = 0; c < (1 << dim); ++c)
      {
        volume[c] = 1;
        for (int d = 0; d < dim; ++d)
          volume[c] *= 0.5 * size;
        if (symmetry == Symmetry::axisymmetric)
          volume[c] *= 2. * std::numbers::pi * (cut.child_lower(c)[0] + 0.25 * size);
      }
    return volume;
  }

  template <int dim>
  std::vector<std::array<double, 1 << dim>>
  child_shares(Symmetry symmetry, const Vector<dim> &lower, double size,
               const std::vector<MaterialInCell<dim>> &materials)
  {
    const Cut<dim>    cut{symmetry, lower, size};
    const Shares<dim> room = child_volumes<dim>(symmetry, lower, size);
    const double      cell = std::accumulate(room.begin(), room.end(), 0.);

    double             filled = 0;
    const Vector<dim> *first  = nullptr;
    for (const MaterialInCell<dim> &material : materials)
      {
        filled += material.volume;
        if (!first && material.volume > 0 && !is_zero<dim>(material.normal))
          first = &material.normal;
      }
    constexpr double round_off = 1e-12;
    const bool       even      = filled > cell * (1. + round_off) || !first;

    std::vector<Shares<dim>> share(materials.size(), Shares<dim>{});
    for (std::size_t m = 0; m < materials.size(); ++m)
      if (materials[m].volume > 0)
        {
          share[m] = even || is_zero<dim>(materials[m].normal)
                         ? room
                         : cut.below(materials[m].normal, materials[m].volume / cell);
          normalise<dim>(share[m], room);
        }
    if (!even && !fits<dim>(share, materials, room, cell))
      stack<dim>(cut, *first, room, cell, materials, share);
    return share;
  }

  template std::array<double, 4>
  child_volumes<2>(Symmetry, const Vector<2> &, double);
  template std::vector<std::array<double, 4>>
  child_shares<2>(Symmetry, const Vector<2> &, double, const std::vector<MaterialInCell<2>> &);
} // namespace whipple
