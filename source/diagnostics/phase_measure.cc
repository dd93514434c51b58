// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/phase_measure.h>
#include <whipple/mesh/gather.h>

#include <algorithm>
#include <tuple>

namespace whipple
{
  namespace
  {
    /// Temperature and phase of one material in some cells.
    struct Phases
    {
      std::vector<double> temperature, melt_fraction, vapour_fraction;
    };

    Phases
    phases_of(const Material &material, const MaterialState &state, const std::vector<Index> &cells)
    {
      std::vector<double> density, energy;
      for (const Index c : cells)
        {
          const bool there = state.density[c] > 0;
          density.push_back(!there ? material.eos->reference_density()
                                   : state.density[c] / (state.has_voids() ? 1. - state.void_fraction[c] : 1.));
          energy.push_back(there ? state.energy[c] : 0.);
        }
      Phases phases;
      for (auto *array : {&phases.temperature, &phases.melt_fraction, &phases.vapour_fraction})
        array->resize(cells.size());
      ThermalOutput output;
      output.temperature     = phases.temperature;
      output.melt_fraction   = phases.melt_fraction;
      output.vapour_fraction = phases.vapour_fraction;
      material.thermal->evaluate(density, energy, output);
      return phases;
    }

    struct Parcel
    {
      double temperature, mass, melt, vapour; // K, g
    };
  } // namespace

  template <int dim>
  PhaseMeasure
  measure_phases(const FieldLayout &layout, const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator)
  {
    PhaseMeasure        measure;
    std::vector<Parcel> mine;
    for (std::size_t m = 0; m < layout.materials.size(); ++m)
      {
        if (!layout.materials[m].melts)
          continue;
        std::vector<Index> cells;
        for (Index c = 0; c < mesh.n_owned; ++c)
          if (state.material[m].mass[c] > 0)
            cells.push_back(c);
        const Phases phases = phases_of(layout.materials[m], state.material[m], cells);
        for (std::size_t i = 0; i < cells.size(); ++i)
          {
            const double mass = state.material[m].mass[cells[i]];
            mine.push_back(
                {phases.temperature[i], mass, mass * phases.melt_fraction[i], mass * phases.vapour_fraction[i]});
          }
      }
    std::vector<Parcel> all = gather_all(communicator, std::span<const Parcel>(mine)).entry;
    std::sort(all.begin(), all.end(), [](const Parcel &a, const Parcel &b) {
      return std::tie(a.temperature, a.mass, a.melt) < std::tie(b.temperature, b.mass, b.melt);
    });
    for (const Parcel &p : all)
      {
        measure.mass += p.mass;
        measure.mean_temperature += p.mass * p.temperature;
        measure.melt_share += p.melt;
        measure.vapour_share += p.vapour;
      }
    if (!(measure.mass > 0))
      return measure;
    measure.mean_temperature /= measure.mass;
    measure.melt_share /= measure.mass;
    measure.vapour_share /= measure.mass;
    double below = 0;
    for (const Parcel &p : all)
      {
        measure.temperature_99 = p.temperature;
        if ((below += p.mass) >= 0.99 * measure.mass)
          break;
      }
    return measure;
  }

  template <int dim>
  std::vector<CellField>
  phase_fields(const FieldLayout &layout, const State<dim> &state, const std::vector<Index> &cells)
  {
    std::vector<CellField> fields;
    for (std::size_t m = 0; m < layout.materials.size(); ++m)
      {
        if (!layout.materials[m].melts)
          continue;
        Phases             phases = phases_of(layout.materials[m], state.material[m], cells);
        const std::string &name   = layout.material_names[m];
        // where there is nothing there is no temperature either
        for (std::size_t i = 0; i < cells.size(); ++i)
          if (!(state.material[m].mass[cells[i]] > 0))
            phases.temperature[i] = phases.melt_fraction[i] = phases.vapour_fraction[i] = 0.;
        fields.push_back({name + " temperature", "K", std::move(phases.temperature)});
        fields.push_back({name + " melt fraction", "1", std::move(phases.melt_fraction)});
        fields.push_back({name + " vapour fraction", "1", std::move(phases.vapour_fraction)});
      }
    return fields;
  }

  template PhaseMeasure
  measure_phases(const FieldLayout &, const FlatMesh<2> &, const State<2> &, MPI_Comm);
  template std::vector<CellField>
  phase_fields(const FieldLayout &, const State<2> &, const std::vector<Index> &);
} // namespace whipple
