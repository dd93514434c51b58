// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>
#include <whipple/state/deviator_storage.h>

#include <string>
#include <vector>

namespace whipple
{
  /// What a specific quantity rides on when material moves between cells.
  enum class Carrier
  {
    mass,  ///< value per gram (plastic strain, damage, body fractions ...)
    volume ///< value per cm^3 of material, pores included (stress ...)
  };

  /// What an effect asks the state to carry for it, in every material that uses the effect.
  struct FieldDescription
  {
    std::string name; ///< "deviatoric stress rr", "plastic strain", "body wall" ...
    std::string unit; ///< internal unit, "Mbar", "1" ...
    Carrier     carrier = Carrier::mass;
  };

  /// One carried quantity of one material, one value a cell.
  struct Field
  {
    FieldDescription    description;
    std::vector<double> value;
  };

  /// Everything one material holds in the cells of one rank (halo included); one value a cell.
  ///
  /// mass and volume are extensive, the rest specific. density is kept beside mass / volume because it is
  /// updated by increments that leave a uniform field uniform to the last bit, however little of it a cell
  /// holds. Where volume is 0 the other values are 0.
  struct MaterialState
  {
    std::vector<double> volume;                ///< cm^3, pores included, open void not
    std::vector<double> mass;                  ///< g
    std::vector<double> density;               ///< bulk density rho = mass / volume, g/cm^3
    std::vector<double> energy;                ///< specific internal energy e, Mbar cm^3/g
    std::vector<double> void_fraction;         ///< phi; EMPTY vector when the material has no void law (phi = 0)
    std::vector<Field>  fields;                ///< what effects registered; the same list in every material
    bool                carries_voids = false; ///< has a void law: a rank without cells cannot tell by the vector

    bool
    has_voids() const
    {
      return carries_voids || !void_fraction.empty();
    }
  };

  /// Indices into MaterialState::fields of the fields that hydro itself reads; -1 where not registered.
  template <int dim>
  struct FieldIndex
  {
    std::array<int, DeviatorStorage<dim>::size> stress         = not_registered(); ///< deviator of the solid's stress
    int                                         plastic_strain = -1;
    int                                         damage         = -1;

    bool
    has_stress() const
    {
      for (const int field : stress)
        if (field < 0)
          return false;
      return true;
    }

    /// The fields of stress that change sign in the mirror image at a plane normal to an axis.
    auto
    odd_at(int axis) const
    {
      auto fields = DeviatorStorage<dim>::odd_at(axis);
      for (int &component : fields)
        component = stress[component];
      return fields;
    }

  private:
    static constexpr std::array<int, DeviatorStorage<dim>::size>
    not_registered()
    {
      std::array<int, DeviatorStorage<dim>::size> fields{};
      fields.fill(-1);
      return fields;
    }
  };

  /// The whole moving state of one rank on a FlatMesh. What can be computed from it is Derived. Node masses are not:
  /// a Lagrangian step leaves them alone, a remap moves them with the momentum, and in neither case are they to the
  /// last bit what the masses of the cells add up to.
  template <int dim>
  struct State
  {
    static constexpr int corners = 1 << dim;

    double time = 0; ///< us

    std::array<std::vector<double>, dim> position;  ///< [n_nodes] cm
    std::array<std::vector<double>, dim> velocity;  ///< [n_nodes] cm/us; hanging nodes: mean of their masters
    std::vector<double>                  node_mass; ///< [n_nodes] g; hanging nodes: 0 (given to the masters)

    std::vector<double> volume; ///< [n_cells] true volume of the cell, cm^3

    /// [n_cells * corners] share (dimensionless, the corners of a cell sum to 1) of the cell's mass at each
    /// corner: integral of N_k over the cell's true volume, divided by that volume, at the time of the last
    /// remap. Lagrangian steps leave it alone: corner masses are constant.
    std::vector<double> corner_weight;

    std::vector<MaterialState> material;
    FieldIndex<dim>            index;

    Index
    n_cells() const
    {
      return static_cast<Index>(volume.size());
    }
    Index
    n_nodes() const
    {
      return static_cast<Index>(node_mass.size());
    }
  };
} // namespace whipple
