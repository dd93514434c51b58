// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/projection/cell_motion.h>
#include <whipple/state/fields.h>

#include <vector>

namespace whipple::projection
{
  /// What was laid down, kept apart from what the cells hold already: materials and motion, one entry a cell.
  struct Laid
  {
    std::vector<MaterialState> material; ///< as in a State, but for pressure and sound speed, which are empty
    std::vector<Motion>        motion;
  };

  /// What a piece brings of one material.
  struct MaterialShare
  {
    double volume = 0, mass = 0;
    double density = 0, energy = 0, void_fraction = 0;
  };

  /// Add a share to a cell. Specific values mix by increments: those that agree keep their bits.
  /// @param field_value  value of carried field f in the share
  template <typename FieldValue>
  void
  add_share(const MaterialShare &share, FieldValue field_value, MaterialState &material, Index cell)
  {
    if (share.mass == 0 || share.volume == 0)
      return;
    material.volume[cell] += share.volume;
    material.mass[cell] += share.mass;
    const double by_volume = share.volume / material.volume[cell], by_mass = share.mass / material.mass[cell];
    const auto   approach = [](double &value, double weight, double target) { value += weight * (target - value); };
    approach(material.density[cell], by_volume, share.density);
    approach(material.energy[cell], by_mass, share.energy);
    if (material.has_voids())
      approach(material.void_fraction[cell], by_volume, share.void_fraction);
    for (std::size_t f = 0; f < material.fields.size(); ++f)
      {
        Field &field = material.fields[f];
        approach(field.value[cell], field.description.carrier == Carrier::mass ? by_mass : by_volume, field_value(f));
      }
  }

  /// Add part of what one cell holds of a material to another cell.
  inline void
  add_part(const MaterialState &source, Index from, double part, MaterialState &target, Index to)
  {
    add_share(
        {part * source.volume[from], part * source.mass[from], source.density[from], source.energy[from],
         source.has_voids() ? source.void_fraction[from] : 0.},
        [&](std::size_t f) { return source.fields[f].value[from]; }, target, to);
  }
} // namespace whipple::projection
