// SPDX-License-Identifier: LGPL-2.1-or-later
// Impulse and energy that the last plate receives, by distance from the line of flight: added up step by step, in
// results at the end of each stage on a fixed mesh that has the plate.
#include <whipple/diagnostics/measure.h>
#include <whipple/diagnostics/plate_load.h>
#include <whipple/diagnostics/plate_measure.h>

#include <algorithm>
#include <numeric>

namespace whipple
{
  namespace
  {
    constexpr const char *name_of_watch = "load on the last plate";

    /// Whether the load on a plate is taken in a stage.
    template <int dim>
    bool
    takes_load(const Scene<dim> &scene, std::size_t stage, std::size_t plate)
    {
      const auto plates = measured_plates(scene, stage);
      return std::find(plates.begin(), plates.end(), plate) != plates.end();
    }

    ResultTable
    load_results(const LoadSite &site, const PlateLoad &load)
    {
      const auto sum = [](const std::vector<double> &list) { return std::accumulate(list.begin(), list.end(), 0.); };
      const auto per_area = [&](std::vector<double> list) {
        for (std::size_t b = 0; b < list.size(); ++b)
          list[b] /= site.area(site.edges[b], site.edges[b + 1]);
        return list;
      };
      const std::string by = site.symmetry == Symmetry::axisymmetric ? "by_radius" : "by_place";
      return {{"load_plane_cm", site.plane},
              {"landed_mass_g", sum(load.mass)},
              {"impulse_g_cm_per_us", sum(load.momentum)},
              {"delivered_energy_Mbar_cm3", sum(load.energy)},
              {"load_" + by + "_edges_cm", site.edges},
              {"landed_mass_" + by + "_g_per_cm2", per_area(load.mass)},
              {"impulse_" + by + "_Mbar_us", per_area(load.momentum)},
              {"delivered_energy_" + by + "_Mbar_cm", per_area(load.energy)}};
    }

    template <int dim>
    class LoadWatch : public Watch<dim>
    {
    public:
      LoadWatch(const Scene<dim> &scene, std::size_t plate)
        : plate_(plate)
        , site_(load_site(scene, plate))
      {
      }

      std::vector<WatchTable>
      tables() const override
      {
        return {};
      }

      void
      mesh_is_new(const MeasureView<dim> &view, std::vector<double> &memory, const WriteRow &) const override
      {
        if (memory.empty() && takes_load(view.scene, view.stage, plate_))
          memory = load_past_plane(site_, view.mesh, view.state, view.communicator).numbers();
      }

      void
      step_done(const MeasureView<dim> &view, double dt, std::vector<double> &memory, const WriteRow &) const override
      {
        if (!takes_load(view.scene, view.stage, plate_))
          return;
        PlateLoad load(memory);
        load += load_of_step(site_, view.mesh, view.state, view.derived, dt, view.communicator);
        if (view.waiting)
          load += load_of_waiting(site_, CellPacketLayout<dim>::of(view.state), *view.waiting, view.state.time - dt,
                                  view.state.time);
        memory = load.numbers();
      }

    private:
      std::size_t plate_;
      LoadSite    site_;
    };

    template <int dim>
    class Loads : public Measure<dim>
    {
    public:
      void
      stage_ends(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        const auto plate = loaded_plate(view.scene);
        if (!plate || !takes_load(view.scene, view.stage, *plate))
          return;
        enter(view.scene, *plate, PlateLoad(view.memories.at(name_of_watch)), report);
      }

      /// A run may be over before anything flies on to the plate.
      void
      run_ends(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        const auto plate = loaded_plate(view.scene);
        if (plate && !report.results[view.scene.bodies[*plate].name].contains("impulse_g_cm_per_us"))
          enter(view.scene, *plate, PlateLoad(load_site(view.scene, *plate).n_bins()), report);
      }

      void
      expect(const Problem<dim> &problem, std::map<std::string, ResultTable> &results) const override
      {
        if (const auto plate = loaded_plate(problem.scene))
          {
            const LoadSite site = load_site(problem.scene, *plate);
            results[problem.scene.bodies[*plate].name].merge(load_results(site, PlateLoad(site.n_bins())));
          }
      }

    private:
      static void
      enter(const Scene<dim> &scene, std::size_t plate, const PlateLoad &load, MeasureReport &report)
      {
        ResultTable &results = report.results[scene.bodies[plate].name];
        for (const auto &[quantity, value] : load_results(load_site(scene, plate), load))
          results[quantity] = value;
      }
    };

    std::unique_ptr<const Watch<2>>
    watch(const Problem<2> &problem)
    {
      const auto plate = loaded_plate(problem.scene);
      return plate ? std::make_unique<LoadWatch<2>>(problem.scene, *plate) : nullptr;
    }

    const MeasureRegistration<2> registration(45, name_of_watch, std::make_shared<Loads<2>>(), watch);
  } // namespace
} // namespace whipple
