// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/collective.h>
#include <whipple/run/state_guard.h>

#include <array>
#include <cmath>
#include <sstream>

namespace whipple
{
  namespace
  {
    /// Energy below the coldest state a material enters with that mixing and round-off may bring, in squares of its
    /// sound speed there: for aluminium as much as it holds at room temperature.
    constexpr double margin = 0.02;

    /// Part of the energy of the problem that may be missing before the run stops.
    constexpr double allowed = 1e-3;

    /// Part of the density at which a law ends that no state may exceed: there the sound speed grows without bound.
    constexpr double short_of_pole = 0.99;

    /// In expansion no matter is stiffer: c^2 <= (Gamma + 1) Gamma e of a gas is below 12 e for every Gamma here, and
    /// cold solids soften. A hundred times that is left to the continuation of tables.
    constexpr double stiff_expansion = 1e3;

    double
    sound_speed_squared(const EquationOfState &eos, double density, double energy)
    {
      const std::array<double, 1> g{{density}}, e{{energy}};
      std::array<double, 1>       p, c2;
      eos.evaluate(g, e, p, c2);
      return std::max(0., c2[0]);
    }

    template <int dim>
    ColdCurve
    cold_curve(const Scene<dim> &scene, const FieldLayout &layout, std::size_t material)
    {
      const EquationOfState &eos     = *layout.materials[material].eos;
      const double           density = eos.reference_density();
      double                 energy  = 0;
      for (const Body<dim> &body : scene.bodies)
        if (body.material == material)
          energy = std::min(energy, body.energy);
      double below = energy - margin * sound_speed_squared(eos, density, 0.);
      // bodies may enter compressed, and colder than the isentrope says
      const ColdCurve trial(eos, density, below);
      double          lacking = 0;
      for (const Body<dim> &body : scene.bodies)
        if (body.material == material && body.density > 0)
          lacking = std::max(lacking, trial.energy(body.density) - body.energy);
      return ColdCurve(eos, density, below - lacking);
    }

    template <int dim>
    std::string
    place(const Domain<dim> &domain, Index cell)
    {
      std::ostringstream text;
      const Index        node = domain.view->mesh.cell_node[cell * FlatMesh<dim>::corners];
      text << "in the cell at (" << domain.state.position[0][node] << ", " << domain.state.position[1][node] << ") cm";
      return text.str();
    }
  } // namespace

  template <int dim>
  StateGuard<dim>::StateGuard(const Scene<dim> &scene, const FieldLayout &layout)
    : layout_(layout)
  {
    for (std::size_t m = 0; m < layout.materials.size(); ++m)
      {
        curve_.push_back(cold_curve(scene, layout, m));
        const EquationOfState &eos = *layout.materials[m].eos;
        cold_sound_speed_squared_.push_back(sound_speed_squared(eos, eos.reference_density(), 0.));
      }
  }

  template <int dim>
  typename StateGuard<dim>::Deficit
  StateGuard<dim>::deficit(const Domain<dim> &domain, std::size_t material) const
  {
    const MaterialState &m     = domain.state.material[material];
    const Material      &model = layout_.materials[material];
    const double         pole  = model.eos->max_density();
    Deficit              sum;
    for (Index c = 0; c < domain.view->mesh.n_owned; ++c)
      {
        if (!(m.mass[c] > model.trace_density * domain.state.volume[c]))
          continue;
        const double true_density = m.has_voids() ? m.density[c] / (1. - m.void_fraction[c]) : m.density[c];
        const double lacking      = m.mass[c] * (curve_[material].energy(true_density) - m.energy[c]);
        if (!(true_density <= short_of_pole * pole) || !std::isfinite(lacking))
          {
            std::ostringstream text;
            text << layout_.material_names[material] << " has true density " << true_density << " g/cm^3 and energy "
                 << m.energy[c] << " Mbar cm^3/g " << place(domain, c) << "; its law '" << model.eos->name()
                 << "' ends at " << pole << " g/cm^3";
            throw StateError(text.str());
          }
        check_expansion(domain, material, c, true_density);
        if (!(lacking > 0))
          continue;
        sum.energy += lacking;
        ++sum.cells;
        if (lacking > sum.worst)
          {
            sum.worst = lacking;
            sum.cell  = c;
          }
      }
    return sum;
  }

  template <int dim>
  void
  StateGuard<dim>::check_expansion(const Domain<dim> &domain, std::size_t material, Index c, double true_density) const
  {
    const EquationOfState &eos     = *layout_.materials[material].eos;
    const DerivedMaterial &derived = domain.derived.material[material];
    const double           c2      = derived.sound_speed[c] * derived.sound_speed[c];
    const double           energy  = domain.state.material[material].energy[c];
    if (!(true_density < 0.5 * eos.reference_density()) || !(derived.pressure[c] > 0) ||
        !(c2 > stiff_expansion * std::max(cold_sound_speed_squared_[material], energy)))
      return;
    std::ostringstream text;
    text << layout_.material_names[material] << " has sound speed " << std::sqrt(c2) << " cm/us at true density "
         << true_density << " g/cm^3 and energy " << energy << " Mbar cm^3/g " << place(domain, c) << "; its law '"
         << eos.name()
         << "' keeps a pressure there that no expansion relieves. Take an equation of state that is meant for hot "
            "expanded matter";
    throw StateError(text.str());
  }

  template <int dim>
  void
  StateGuard<dim>::check(const Domain<dim> &domain, double energy_scale, Ledger<dim> &ledger) const
  {
    const MPI_Comm       communicator = domain.communicator();
    std::vector<Deficit> of_material(curve_.size());
    agree(communicator, [&] {
      for (std::size_t m = 0; m < curve_.size(); ++m)
        of_material[m] = deficit(domain, m);
    });
    for (std::size_t m = 0; m < curve_.size(); ++m)
      {
        const Deficit &own = of_material[m];
        const double cells = sum_over_ranks(own.cells, communicator), energy = sum_over_ranks(own.energy, communicator);
        ledger.note("energy below the cold curve (" + layout_.material_names[m] + ")", cells, energy, "Mbar cm^3");
        if (!(energy > allowed * energy_scale))
          continue;
        const double worst = max_over_ranks(own.worst, communicator);
        agree(communicator, [&] {
          if (own.cell == none || own.worst < worst)
            return;
          const MaterialState &state = domain.state.material[m];
          std::ostringstream   text;
          text << layout_.material_names[m] << " lacks " << energy << " Mbar cm^3 below its cold curve in " << cells
               << " cells, the energy of the problem is " << energy_scale << "; the most " << place(domain, own.cell)
               << ": density " << state.density[own.cell] << " g/cm^3, energy " << state.energy[own.cell]
               << " Mbar cm^3/g. Kinetic energy has come from nowhere: look for folded or overlapping elements there, "
                  "or "
                  "matter without a void law in tension";
          throw StateError(text.str());
        });
      }
  }

  template class StateGuard<2>;
} // namespace whipple
