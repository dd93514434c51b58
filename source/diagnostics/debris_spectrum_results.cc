// SPDX-License-Identifier: LGPL-2.1-or-later
// What every Lagrangian stage hands on, in all and by angle and velocity: in results, and as a table in the log.
#include <whipple/diagnostics/debris_spectrum.h>
#include <whipple/diagnostics/measure.h>
#include <whipple/ledger/totals.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace whipple
{
  namespace
  {
    constexpr int    angle_bins  = 36; ///< of 5 degrees
    constexpr double speed_share = 0.05;

    /// A list of one part of every bin.
    template <int dim, typename Part>
    std::vector<double>
    list(const Spectrum<dim> &spectrum, const Part &part)
    {
      std::vector<double> values;
      for (const ConservedTotals<dim> &bin : spectrum.bin)
        values.push_back(part(bin));
      return values;
    }

    template <int dim>
    void
    enter(const Spectrum<dim> &spectrum, const std::string &by, const std::string &edges, ResultTable &results)
    {
      results[edges]                  = spectrum.edges;
      results["mass_by_" + by + "_g"] = list(spectrum, [](const auto &b) { return b.mass; });
      results["axial_momentum_by_" + by + "_g_cm_per_us"] =
          list(spectrum, [](const auto &b) { return b.momentum[flight_axis<dim>]; });
      results["kinetic_energy_by_" + by + "_Mbar_cm3"] = list(spectrum, [](const auto &b) { return b.kinetic_energy; });
      results["internal_energy_by_" + by + "_Mbar_cm3"] =
          list(spectrum, [](const auto &b) { return b.internal_energy; });
    }

    template <int dim>
    ResultTable
    results_of(const ConservedTotals<dim> &all, const Spectrum<dim> &by_angle, const Spectrum<dim> &by_velocity)
    {
      ResultTable results{{"kinetic_energy_Mbar_cm3", all.kinetic_energy},
                          {"internal_energy_Mbar_cm3", all.internal_energy}};
      enter(by_angle, "angle", "angle_edges_deg", results);
      enter(by_velocity, "velocity", "velocity_edges_cm_per_us", results);
      return results;
    }

    /// What a stage's results say of debris that only an effect knows: null where it is off.
    template <int dim>
    void
    enter_unknown(const Scene<dim> &scene, ResultTable &results)
    {
      if (!scene.has_effect("melting"))
        results["melt_share"] = std::monostate{};
      if (!scene.has_effect("fragment size"))
        results["fragment_number"] = results["mean_fragment_size_cm"] = std::monostate{};
    }

    template <typename... Numbers>
    std::string
    line(const char *pattern, Numbers... numbers)
    {
      char text[200];
      std::snprintf(text, sizeof text, pattern, numbers...);
      return text;
    }

    template <int dim>
    void
    log_spectrum(const Spectrum<dim> &spectrum, const std::string &head, MeasureReport &report)
    {
      report.log(line("  %-20s %13s %15s %15s %15s", head.c_str(), "mass", "axial momentum", "kinetic", "internal"));
      for (std::size_t b = 0; b < spectrum.bin.size(); ++b)
        if (const ConservedTotals<dim> &bin = spectrum.bin[b]; bin.mass > 0)
          report.log(line("  %8.4g to %-8.4g %13.6e %15.6e %15.6e %15.6e", spectrum.edges[b], spectrum.edges[b + 1],
                          bin.mass, bin.momentum[flight_axis<dim>], bin.kinetic_energy, bin.internal_energy));
    }

    template <int dim>
    class DebrisSpectra : public Measure<dim>
    {
    public:
      void
      stage_ends(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        const Stage &stage = view.scene.stages[view.stage];
        if (stage.mode() != StageMode::lagrangian)
          return;
        auto all = totals(view.mesh, view.state, view.communicator);
        if (view.waiting)
          all += view.waiting->totals;
        const auto by_angle = spectrum<dim>(view.mesh, view.state, equal_edges(0., 180., angle_bins), flight_angle<dim>,
                                            view.communicator, view.waiting);
        const auto by_velocity =
            spectrum<dim>(view.mesh, view.state,
                          velocity_edges(view.mesh, view.state, bin_width(view.scene), view.communicator, view.waiting),
                          axial_velocity<dim>, view.communicator, view.waiting);
        ResultTable &results = report.results[stage.name];
        results.merge(results_of(all, by_angle, by_velocity));
        enter_unknown(view.scene, results);

        report.log(line("debris of %s: %.6e g, %.6e g cm/us, kinetic %.6e, internal %.6e Mbar cm^3", stage.name.c_str(),
                        all.mass, all.momentum[flight_axis<dim>], all.kinetic_energy, all.internal_energy));
        log_spectrum(by_angle, "by angle, deg", report);
        log_spectrum(by_velocity, "by velocity, cm/us", report);
      }

      void
      expect(const Problem<dim> &problem, std::map<std::string, ResultTable> &results) const override
      {
        const Spectrum<dim> none{{0., 1.}, {{}}};
        for (const Stage &stage : problem.scene.stages)
          if (stage.mode() == StageMode::lagrangian)
            {
              results[stage.name].merge(results_of({}, none, none));
              enter_unknown(problem.scene, results[stage.name]);
            }
      }

    private:
      /// A twentieth of the fastest body's axial velocity, so that clouds of runs can be compared; 0.01 cm/us if none
      /// moves.
      static double
      bin_width(const Scene<dim> &scene)
      {
        double fastest = 0;
        for (const Body<dim> &body : scene.bodies)
          fastest = std::max(fastest, std::abs(body.velocity[flight_axis<dim>]));
        return fastest > 0 ? speed_share * fastest : 0.01;
      }
    };

    const MeasureRegistration<2> registration(35, "debris by angle and velocity", std::make_shared<DebrisSpectra<2>>());
  } // namespace
} // namespace whipple
