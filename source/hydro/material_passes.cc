// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/error.h>
#include <whipple/hydro/material_passes.h>
#include <whipple/hydro/solid_state.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace whipple::material_passes
{
  namespace
  {
    /// Share of its strengths that material of damage D has left: 1 - D, the sound part of a cell in which some has
    /// failed. Where damage counts plastic strain, D < 1 is mostly ductility that has been used up, which costs no
    /// strength (doc/theory/failure.md): 1 - D^8.
    double
    strength_left(bool counts_strain, double damage)
    {
      const double damage_2 = damage * damage, damage_4 = damage_2 * damage_2;
      return 1. - (counts_strain ? damage_4 * damage_4 : damage);
    }

    /// The share of its spall strength that each cell of a material has left; empty: all of it everywhere.
    template <int dim>
    std::span<const double>
    soundness(const Material &material, const MaterialState &state, const FieldIndex<dim> &index,
              const MaterialWork<dim> &next, Scratch &scratch)
    {
      const bool damaged = material.failure && index.damage >= 0;
      if (!damaged && !material.melts)
        return {};
      std::fill(scratch.soundness.begin(), scratch.soundness.end(), 1.);
      if (damaged)
        {
          const std::vector<double> &damage        = state.fields[index.damage].value;
          const bool                 counts_strain = material.failure->needs_strength();
          for (std::size_t c = 0; c < damage.size(); ++c)
            scratch.soundness[c] = strength_left(counts_strain, damage[c]);
        }
      if (material.melts)
        {
          solid_state::true_density(next.density, next.void_fraction, material.eos->reference_density(),
                                    scratch.true_density);
          ThermalOutput output;
          output.melt_fraction = scratch.melt_fraction;
          material.thermal->evaluate(scratch.true_density, next.energy, output);
          for (std::size_t c = 0; c < scratch.soundness.size(); ++c)
            scratch.soundness[c] *= 1. - scratch.melt_fraction[c];
        }
      return scratch.soundness;
    }
  } // namespace

  namespace
  {
    /// Void fractions before the law acts: those of the start, but none in a trace that now lies at its normal density.
    template <int dim>
    void
    carry_voids(const MaterialState &material, const std::vector<double> &volume, MaterialWork<dim> &next)
    {
      constexpr double squeezed = 1.5; // true density over the normal one that pores would have to explain
      for (std::size_t c = 0; c < volume.size(); ++c)
        {
          const double phi       = material.void_fraction[c];
          const bool   collapsed = material.mass[c] <= next.trace_density * volume[c] &&
                                 next.density[c] > squeezed * next.reference_density * (1. - phi);
          next.void_fraction[c] = collapsed ? 0. : phi;
        }
    }

    /// Complain about the first owned cell whose true density lies at or beyond what the law can reach.
    template <int dim>
    void
    check_density(const FlatMesh<dim> &mesh, const State<dim> &state, const Material &material, std::size_t m,
                  const MaterialWork<dim> &next)
    {
      const double limit = material.eos->max_density();
      if (!(limit < std::numeric_limits<double>::infinity()))
        return;
      const bool voids = !next.void_fraction.empty();
      for (Index c = 0; c < mesh.n_owned; ++c)
        {
          const double density = voids ? next.density[c] / (1. - next.void_fraction[c]) : next.density[c];
          if (density < limit || state.material[m].mass[c] <= next.trace_density * state.volume[c])
            continue;
          std::ostringstream text;
          text << "Lagrange step compresses '" << material.name << "' from " << state.material[m].density[c] << " to "
               << density << " g/cm^3 in the cell at (" << state.position[0][mesh.cell_node[4 * c]] << ", "
               << state.position[1][mesh.cell_node[4 * c]] << ") cm; the " << material.eos->name() << " law ends at "
               << limit << " g/cm^3";
          throw StateError(text.str());
        }
    }
  } // namespace

  template <int dim>
  void
  check_densities(const FlatMesh<dim> &mesh, const std::vector<Material> &materials, const State<dim> &state,
                  const StepWork<dim> &work)
  {
    for (std::size_t m = 0; m < materials.size(); ++m)
      check_density(mesh, state, materials[m], m, work.material[m]);
  }

  Scratch
  make_scratch(const std::vector<Material> &materials, Index n_cells)
  {
    Scratch scratch;
    scratch.true_density.resize(n_cells);
    for (const Material &material : materials)
      {
        if (material.void_law && (material.melts || material.failure))
          scratch.soundness.resize(n_cells);
        if (material.void_law && material.melts)
          scratch.melt_fraction.resize(n_cells);
        if (material.strength && material.strength->needs_pressure())
          scratch.solid_pressure.resize(n_cells);
      }
    return scratch;
  }

  template <int dim>
  void
  evaluate_pressure(const std::vector<Material> &materials, const State<dim> &state, Scratch &scratch, Derived &derived)
  {
    const Index n_cells = state.n_cells();
    derived.material.resize(materials.size());
    for (std::size_t m = 0; m < materials.size(); ++m)
      {
        const MaterialState &material    = state.material[m];
        std::vector<double> &pressure    = derived.material[m].pressure;
        std::vector<double> &sound_speed = derived.material[m].sound_speed;
        pressure.resize(n_cells);
        sound_speed.resize(n_cells);
        solid_state::true_density(material.density, material.void_fraction, materials[m].eos->reference_density(),
                                  scratch.true_density);
        materials[m].eos->evaluate(scratch.true_density, material.energy, pressure, sound_speed);
        if (material.has_voids())
          for (Index cell = 0; cell < n_cells; ++cell)
            pressure[cell] *= 1. - material.void_fraction[cell];
        solid_state::part_in_tension(scratch.true_density, materials[m].eos->reference_density(), pressure);
        for (Index cell = 0; cell < n_cells; ++cell)
          {
            const bool there  = material.mass[cell] > materials[m].trace_density * state.volume[cell];
            pressure[cell]    = there ? pressure[cell] : 0.;
            sound_speed[cell] = there ? std::sqrt(std::max(sound_speed[cell], 0.)) : 0.;
          }
      }
  }

  template <int dim>
  void
  evaluate_strength(const std::vector<Material> &materials, const State<dim> &state, Scratch &scratch, Derived &derived)
  {
    const FieldIndex<dim> &index = state.index;
    if (!index.has_stress() || index.plastic_strain < 0)
      throw StateError("a material has strength but the state carries no deviatoric stress or plastic strain");
    for (std::size_t m = 0; m < materials.size(); ++m)
      {
        if (!materials[m].strength)
          continue;
        const MaterialState &material = state.material[m];
        DerivedMaterial     &result   = derived.material[m];
        result.shear_modulus.resize(state.n_cells());
        result.yield_stress.resize(state.n_cells());
        solid_state::true_density(material.density, material.void_fraction, materials[m].eos->reference_density(),
                                  scratch.true_density);
        std::span<const double> solid_pressure;
        if (materials[m].strength->needs_pressure())
          {
            solid_state::pressure(result.pressure, material.void_fraction, scratch.solid_pressure);
            solid_pressure = scratch.solid_pressure;
          }
        materials[m].strength->evaluate({scratch.true_density, material.energy, solid_pressure,
                                         material.fields[index.plastic_strain].value, derived.strain_rate},
                                        result.shear_modulus, result.yield_stress);
        if (!materials[m].failure || index.damage < 0)
          continue;
        const std::vector<double> &damage        = material.fields[index.damage].value;
        const bool                 counts_strain = materials[m].failure->needs_strength();
        for (std::size_t c = 0; c < damage.size(); ++c)
          result.yield_stress[c] *= strength_left(counts_strain, damage[c]);
      }
  }

  template <int dim>
  void
  advance_voids(const std::vector<Material> &materials, const State<dim> &state, double dt, Scratch &scratch,
                StepWork<dim> &work)
  {
    for (std::size_t m = 0; m < materials.size(); ++m)
      {
        if (!materials[m].void_law)
          continue;
        MaterialWork<dim> &next = work.material[m];
        carry_voids(state.material[m], state.volume, next);
        const auto sound = soundness(materials[m], state.material[m], state.index, next, scratch);
        materials[m].void_law->advance(*materials[m].eos, dt, {next.density, next.energy, sound}, next.void_fraction);
      }
  }

  template void
  evaluate_pressure(const std::vector<Material> &, const State<2> &, Scratch &, Derived &);
  template void
  evaluate_strength(const std::vector<Material> &, const State<2> &, Scratch &, Derived &);
  template void
  check_densities(const FlatMesh<2> &, const std::vector<Material> &, const State<2> &, const StepWork<2> &);
  template void
  advance_voids(const std::vector<Material> &, const State<2> &, double, Scratch &, StepWork<2> &);
} // namespace whipple::material_passes
