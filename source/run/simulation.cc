// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/exact_errors.h>
#include <whipple/diagnostics/result_table.h>
#include <whipple/diagnostics/shock_measure.h>
#include <whipple/output/process_use.h>
#include <whipple/run/simulation.h>
#include <whipple/run/stage_loop.h>

#include <filesystem>

namespace whipple
{
  namespace
  {
    /// Largest part of a conserved quantity a projection may lose.
    constexpr double projection_round_off = 1e-12;

    template <int dim>
    summary::Balance
    balance(const ConservedTotals<dim> &introduced, const ConservedTotals<dim> &present, const Ledger<dim> &ledger,
            double (*quantity)(const ConservedTotals<dim> &), double closure)
    {
      summary::Balance result;
      result.initial     = quantity(introduced);
      result.final_value = quantity(present);
      result.left_domain = quantity(ledger.left());
      for (const auto &[reason, amount] : ledger.dropped())
        result.dropped[reason] = quantity(amount);
      result.closure_relative = closure;
      return result;
    }

    template <int dim>
    summary::Ledger
    summarise(const Ledger<dim> &ledger, const ConservedTotals<dim> &present)
    {
      using Totals            = ConservedTotals<dim>;
      const auto      closure = ledger.closure(present);
      const Totals   &begin   = ledger.introduced();
      summary::Ledger result;
      result.mass = balance<dim>(
          begin, present, ledger, [](const Totals &t) { return t.mass; }, closure.mass);
      result.axial_momentum = balance<dim>(
          begin, present, ledger, [](const Totals &t) { return t.momentum[Ledger<dim>::axial]; },
          closure.axial_momentum);
      result.energy = balance<dim>(
          begin, present, ledger, [](const Totals &t) { return t.total_energy(); }, closure.energy);
      auto &extra               = result.energy.extra;
      extra["initial_kinetic"]  = begin.kinetic_energy;
      extra["initial_internal"] = begin.internal_energy;
      extra["kinetic"]          = present.kinetic_energy;
      extra["internal"]         = present.internal_energy;
      const auto converted      = [&](const char *cause) {
        const auto found = ledger.conversions().find(cause);
        return found == ledger.conversions().end() ? 0. : found->second;
      };
      extra["remap_loss"]              = converted("remap");
      extra["regrid_loss"]             = converted("regrid");
      extra["projection_loss"]         = converted("projection");
      extra["released_fragments_loss"] = converted("released fragments");
      extra["plastic_work"]            = converted("plastic work");
      extra["viscous_work"]            = converted("viscous work");
      extra["hourglass_work"]          = converted("hourglass work");
      return result;
    }
  } // namespace

  template <int dim>
  Simulation<dim>::Simulation(const Scene<dim> &scene, const std::string &directory, bool live, MPI_Comm communicator)
    : scene_(scene)
    , layout_(scene_)
    , directory_(directory)
    , regridding_(scene_, layout_)
    , handover_(scene_, layout_, regridding_)
    , reporter_(scene_, layout_, directory, live, communicator)
    , domain_{Forest<dim>(communicator, scene_.lattice), nullptr, {}}
    , wall_start_(MPI_Wtime())
    , cpu_start_(process_use(communicator).cpu_s)
  {
    summary_.scene = std::filesystem::path(scene_.file).filename().string();
    for (const EffectVerdict &verdict : scene_.effect_verdicts)
      summary_.effects[verdict.name] = {verdict.on, verdict.number, verdict.reason};
  }

  template <int dim>
  void
  Simulation<dim>::measure_plates(std::size_t stage)
  {
    for (const std::size_t plate : measured_plates(scene_, stage))
      {
        const std::string &name = scene_.bodies[plate].name;
        const auto         measure =
            measure_plate(scene_, layout_, plate, domain_.view->mesh, domain_.state, domain_.communicator());
        if (!measure)
          reporter_.log().warning("stage " + scene_.stages[stage].name + ": plate " + name +
                                  " cannot be measured: it is thinner than a cell, or nothing of it is left");
        for (const auto &[quantity, value] : plate_results(measure, domain_.state.time))
          summary_.results[name][quantity] = value;
      }
  }

  template <int dim>
  std::optional<double>
  Simulation<dim>::projectile_velocity() const
  {
    if (!layout_.bodies_separable)
      return std::nullopt;
    const auto bodies =
        body_totals(domain_.view->mesh, domain_.state, layout_.body_tag, layout_.body_material, domain_.communicator());
    double mass = 0, momentum = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (scene_.bodies[b].velocity[Ledger<dim>::axial] != 0.)
        {
          mass += bodies[b].mass;
          momentum += bodies[b].momentum[Ledger<dim>::axial];
        }
    return mass > 0 ? std::optional<double>(momentum / mass) : std::nullopt;
  }

  template <int dim>
  void
  Simulation<dim>::measure_cloud(const Stage &stage, const std::string &prefix)
  {
    const double        origin = stage.debris.behind ? extent(scene_.bodies[*stage.debris.behind].shape).upper[1] : 0.;
    const DebrisMeasure m      = measure_debris<dim>(
        domain_.view->mesh, domain_.state, [](Index) { return true; }, origin, domain_.communicator());
    summary_.results[stage.name].merge(debris_results(m, projectile_velocity(), domain_.state.time, prefix));
  }

  template <int dim>
  void
  Simulation<dim>::measure_material(const Stage &stage)
  {
    const FlatMesh<dim> &mesh = domain_.view->mesh;
    if (scene_.has_effect("melting"))
      summary_.results[stage.name].merge(
          phase_results(measure_phases(layout_, mesh, domain_.state, domain_.communicator())));
    if (scene_.has_effect("fragment size"))
      summary_.results[stage.name].merge(
          fragment_results(mean_fragment_size(layout_, mesh, domain_.state, domain_.communicator())));
  }

  template <int dim>
  void
  Simulation<dim>::run_stage(std::size_t number)
  {
    const Stage               &stage   = scene_.stages[number];
    const double               brought = ledger_.introduced().kinetic_energy;
    const ConservedTotals<dim> held =
        number > 0 ? totals(domain_.view->mesh, domain_.state, domain_.communicator()) : ConservedTotals<dim>{};
    summary_.ledger = summarise(ledger_, held);
    try
      {
        handover_.enter(stage, number > 0 ? &scene_.stages[number - 1] : nullptr, domain_, ledger_);
      }
    catch (const StateError &error)
      {
        // the state lies between two meshes: the summary keeps the books of before
        reporter_.log().warning(error.what());
        domain_.view.reset();
        throw;
      }
    const auto present = totals(domain_.view->mesh, domain_.state, domain_.communicator());
    ledger_.check(present, "the projection into stage '" + stage.name + "'", projection_round_off);
    const double made = present.kinetic_energy - held.kinetic_energy - (ledger_.introduced().kinetic_energy - brought);
    if (made > projection_round_off * ledger_.energy_scale())
      throw ConservationError("the projection into stage '" + stage.name + "' made " + std::to_string(made) +
                              " Mbar cm^3 of kinetic energy out of nothing");
    if (stage.mode == StageMode::lagrangian)
      measure_cloud(stage, handover_prefix);
    summary::Stage &record = summary_.stages.emplace_back();
    StageLoop<dim>  loop(scene_, layout_, regridding_, handover_, stage, static_cast<int>(number), reporter_, record);
    loop.run(domain_, ledger_, summary_.counts);
    if (stage.mode == StageMode::lagrangian)
      measure_cloud(stage, "");
    measure_material(stage);
    measure_plates(number);
  }

  template <int dim>
  void
  Simulation<dim>::measure_errors()
  {
    const FlatMesh<dim> &mesh = domain_.view->mesh;
    summary_.errors = exact_errors<dim>(*scene_.exact, mesh, domain_.state, domain_.derived, domain_.communicator());
    if (const auto shock = measure_shock<dim>(scene_, mesh, domain_.state, domain_.communicator()))
      summary_.results[exact_place] = shock_results(*shock);
  }

  template <int dim>
  void
  Simulation<dim>::write_summary()
  {
    const MPI_Comm communicator = domain_.communicator();
    if (domain_.view)
      {
        const FlatMesh<dim> &mesh = domain_.view->mesh;
        summary_.ledger           = summarise(ledger_, totals(mesh, domain_.state, communicator));
        if (layout_.bodies_separable)
          {
            const auto bodies = body_totals(mesh, domain_.state, layout_.body_tag, layout_.body_material, communicator);
            for (std::size_t b = 0; b < bodies.size(); ++b)
              summary_.ledger.bodies[scene_.bodies[b].name] = {
                  {"mass_g", bodies[b].mass},
                  {"axial_momentum_g_cm_per_us", bodies[b].momentum[Ledger<dim>::axial]},
                  {"internal_energy_Mbar_cm3", bodies[b].internal_energy},
                  {"kinetic_energy_Mbar_cm3", bodies[b].kinetic_energy}};
          }
      }
    const ProcessUse use                = process_use(communicator);
    summary_.performance.wall_s         = MPI_Wtime() - wall_start_;
    summary_.performance.cpu_s          = use.cpu_s - cpu_start_;
    summary_.performance.peak_rss_bytes = use.peak_rss_bytes;
    MPI_Comm_size(communicator, &summary_.performance.ranks);
    summary_.performance.active_cell_steps = 0;
    for (const summary::Stage &stage : summary_.stages)
      summary_.performance.active_cell_steps += stage.cell_steps;
    summary_.counts.warnings = reporter_.log().warnings();
    for (const auto &[what, event] : ledger_.events())
      summary_.counts.events[what] = {event.number, event.size, event.unit};
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    if (rank == 0)
      summary::write(summary_, directory_);
    reporter_.flush();
  }

  template <int dim>
  void
  Simulation<dim>::run()
  {
    std::size_t number = 0;
    try
      {
        for (; number < scene_.stages.size(); ++number)
          run_stage(number);
        if (scene_.exact)
          measure_errors();
      }
    catch (const StateError &error)
      {
        if (domain_.view)
          reporter_.failed(scene_.stages[number], domain_, ledger_, error.what());
        summary_.status = "stopped";
        summary_.reason = error.what();
        write_summary();
        throw;
      }
    write_summary();
  }

  template <int dim>
  void
  Simulation<dim>::report_error_bars(const std::map<std::string, std::map<std::string, summary::ErrorBar>> &error_bars)
  {
    summary_.error_bars = error_bars;
    for (const auto &[place, quantities] : error_bars)
      for (const auto &[quantity, bar] : quantities)
        reporter_.result(place, quantity, summary_.results.at(place).at(quantity), bar);
    int rank = 0;
    MPI_Comm_rank(domain_.communicator(), &rank);
    if (rank == 0)
      summary::write(summary_, directory_);
  }

  template class Simulation<2>;
} // namespace whipple
