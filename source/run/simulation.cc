// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/exact_errors.h>
#include <whipple/diagnostics/plate_measure.h>
#include <whipple/hydro/lagrange_step.h>
#include <whipple/output/first_rank.h>
#include <whipple/run/simulation.h>
#include <whipple/run/stage_loop.h>
#include <whipple/state/conversion.h>

#include <algorithm>
#include <filesystem>
#include <variant>

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
      for (const auto &[cause, booking] : ledger.bookings().by_cause())
        if (booking.dropped)
          result.dropped[cause] = quantity(*booking.dropped);
      result.closure_relative = closure;
      return result;
    }

    /// Key in summary.json.
    std::string
    key_of(std::string name)
    {
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
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
      for (const auto &[key, listed] : ConversionRegistry::all())
        extra[key_of(conversion_name(key.second))] = 0.;
      for (const auto &[cause, booking] : ledger.bookings().by_cause())
        if (booking.converted)
          extra[key_of(conversion_name(cause))] = *booking.converted;
      return result;
    }

    /// What follows from a state that has been read or gone back to, before a stage has a cycle for it.
    template <int dim>
    void
    evaluate(const Scene<dim> &scene, const FieldLayout &layout, Domain<dim> &domain)
    {
      if (domain.view)
        LagrangeStep<dim>(domain.view->mesh, layout.materials, scene.boundaries, scene.numerics.hydro)
            .evaluate(domain.state, domain.derived);
    }
  } // namespace

  template <int dim>
  Simulation<dim>::Simulation(const Problem<dim> &problem, const RunPlace &place, const RunBooks<dim> *books,
                              MPI_Comm communicator)
    : lock_(place.lock)
    , problem_(problem)
    , scene_(problem_.scene)
    , layout_(problem_.layout)
    , directory_(place.directory)
    , regridding_(scene_, layout_)
    , handover_(problem_, regridding_)
    , state_{{Forest<dim>(communicator, scene_.lattice), nullptr, {}}, books ? *books : RunBooks<dim>{}}
    , reporter_(problem_, directory_, place.live, communicator, books)
    , clock_(state_.books.summary.performance, communicator)
    , checkpointing_(scene_, layout_, directory_, place.wall_start, clock_, communicator)
  {
    summary::Summary &summary = state_.books.summary;
    if (!books)
      summary.scene = std::filesystem::path(scene_.file).filename().string();
    for (const EffectVerdict &verdict : scene_.effect_verdicts)
      summary.effects[verdict.name] = {verdict.on, verdict.number, verdict.reason};
  }

  template <int dim>
  Simulation<dim>::Simulation(const Problem<dim> &problem, const RunPlace &place, MPI_Comm communicator)
    : Simulation(problem, place, nullptr, communicator)
  {
    last_good_.keep_books(state_.books);
  }

  template <int dim>
  Simulation<dim>::Simulation(const Problem<dim> &problem, const RunPlace &place, const std::string &checkpoint,
                              const RunBooks<dim> &books, MPI_Comm communicator)
    : Simulation(problem, place, &books, communicator)
  {
    checkpoint::read_fields(checkpoint, layout_, state_);
    evaluate(scene_, layout_, state_.domain);
    last_good_.keep(state_);
    reporter_.log().info("going on at " + std::to_string(state_.domain.state.time) + " us from " + checkpoint);
  }

  template <int dim>
  void
  Simulation<dim>::measure(Look look)
  {
    const auto             phase  = clock_.phases().phase("results");
    const Domain<dim>     &domain = state_.domain;
    const MeasureView<dim> view{problem_,
                                std::min(state_.books.stage, scene_.stages.size() - 1),
                                domain.view->mesh,
                                domain.state,
                                domain.derived,
                                domain.communicator(),
                                state_.books.waiting.get(),
                                state_.books.watches};
    MeasureReport          report{state_.books.summary.results,
                         [this](const std::string &line) { reporter_.log().warning(line); },
                         [this](const std::string &line) { reporter_.log().info(line); }};
    for (const auto &[key, entry] : MeasureRegistry<dim>::all())
      if (entry.measure)
        ((*entry.measure).*look)(view, report);
  }

  template <int dim>
  void
  Simulation<dim>::enter()
  {
    const auto                 phase   = clock_.phases().phase("hand-over");
    const std::size_t          number  = state_.books.stage;
    const Stage               &stage   = scene_.stages[number];
    Ledger<dim>               &ledger  = state_.books.ledger;
    Domain<dim>               &domain  = state_.domain;
    const double               brought = ledger.introduced().kinetic_energy;
    const ConservedTotals<dim> held    = number > 0 ? state_.present() : ConservedTotals<dim>{};
    try
      {
        handover_.enter(stage, number > 0 ? &scene_.stages[number - 1] : nullptr, domain, ledger, state_.books.waiting);
        const auto present = state_.present();
        ledger.check(present, "the projection into stage '" + stage.name + "'", projection_round_off);
        const double made =
            present.kinetic_energy - held.kinetic_energy - (ledger.introduced().kinetic_energy - brought);
        if (made > projection_round_off * ledger.energy_scale())
          throw ConservationError("the projection into stage '" + stage.name + "' made " + std::to_string(made) +
                                  " Mbar cm^3 of kinetic energy out of nothing");
      }
    catch (const StateError &)
      {
        last_good_.restore(layout_, state_);
        if (number == 0)
          domain.view.reset(); // there is no state of before
        evaluate(scene_, layout_, domain);
        throw;
      }
    measure(&Measure<dim>::stage_begins);
  }

  template <int dim>
  void
  Simulation<dim>::run_stage()
  {
    const Stage &stage = scene_.stages[state_.books.stage];
    if (!state_.books.progress.begun)
      enter();
    const FieldLayout layout = layout_.of_stage(stage);
    StageLoop<dim>    loop(
           scene_, layout, regridding_, handover_, stage, reporter_,
           [this] { checkpointing_.after_step(last_good_, reporter_); }, state_, last_good_, clock_.phases());
    const std::optional<std::string> chain_over = loop.run();
    measure(&Measure<dim>::stage_ends);
    if (stage.plates_measured == PlatesMeasured::settled && plates_are_seen())
      follow_plates(stage, layout);
    if (chain_over && state_.books.stage + 1 < scene_.stages.size())
      {
        reporter_.log().warning(*chain_over + "; the stages after '" + stage.name +
                                "' have nothing to do, and the run " + "is complete without them");
        state_.books.summary.reason = chain_over;
        state_.books.stage          = scene_.stages.size() - 1;
      }
    finish_stage();
  }

  template <int dim>
  bool
  Simulation<dim>::plates_are_seen() const
  {
    const auto plates = measured_plates(scene_, state_.books.stage);
    return std::any_of(plates.begin(), plates.end(), [&](std::size_t plate) {
      const auto results = state_.books.summary.results.find(scene_.bodies[plate].name);
      return results != state_.books.summary.results.end() &&
             std::holds_alternative<bool>(results->second.at("perforated"));
    });
  }

  namespace
  {
    /// Nobody listens to what a copy of the state does; warnings are heard.
    template <int dim>
    class WarningsOnly : public StageNews<dim>
    {
    public:
      explicit WarningsOnly(RunLog &log)
        : log_(log)
      {
      }
      RunLog &
      log() override
      {
        return log_;
      }

    private:
      RunLog &log_;
    };
  } // namespace

  template <int dim>
  void
  Simulation<dim>::follow_plates(const Stage &stage, const FieldLayout &layout)
  {
    const auto       phase = clock_.phases().phase_with_all("plates followed");
    const double     start = state_.books.summary.stages.back().start_us, end = state_.domain.state.time;
    constexpr double longest = 5.; // times what the stage has taken
    Stage            longer  = stage;
    longer.end               = until_holes_have_settled(longest * (end - start));
    LastGood<dim> before, good;
    before.keep(state_);
    good.keep(state_);
    state_.books.progress.memory_of_end.clear();
    WarningsOnly<dim> news(reporter_.log());
    StageLoop<dim>    loop(
           scene_, layout, regridding_, handover_, longer, news,
           [this] { checkpointing_.after_step(last_good_, reporter_); }, state_, good, clock_.phases());
    std::map<std::string, ResultTable> results;
    try
      {
        loop.run();
        measure(&Measure<dim>::plates_have_settled);
        results = state_.books.summary.results;
        reporter_.log().info("plates of stage " + stage.name + " followed to " +
                             std::to_string(state_.domain.state.time) + " us in a copy of its state");
      }
    catch (const Interrupted &)
      {
        throw;
      }
    catch (const StateError &error)
      {
        reporter_.log().warning("plates of stage " + stage.name +
                                " cannot be followed beyond its end: " + error.what());
      }
    before.restore(layout_, state_);
    evaluate(scene_, layout_, state_.domain);
    if (!results.empty())
      state_.books.summary.results = results;
  }

  template <int dim>
  void
  Simulation<dim>::finish_stage()
  {
    ++state_.books.stage;
    state_.books.progress                = StageProgress{};
    state_.books.summary.counts.warnings = reporter_.log().warnings();
    reporter_.steps_stand(state_.books);
    last_good_.keep(state_);
    checkpointing_.write(last_good_, reporter_);
  }

  template <int dim>
  void
  Simulation<dim>::measure_errors()
  {
    const FlatMesh<dim> &mesh   = state_.domain.view->mesh;
    state_.books.summary.errors = exact_errors<dim>(*problem_.exact, mesh, state_.domain.state, state_.domain.derived,
                                                    state_.domain.communicator());
  }

  template <int dim>
  void
  Simulation<dim>::write_summary()
  {
    const MPI_Comm     communicator = state_.domain.communicator();
    const Ledger<dim> &ledger       = state_.books.ledger;
    summary::Summary  &summary      = state_.books.summary;
    if (state_.domain.view)
      {
        summary.ledger = summarise(ledger, state_.present());
        if (layout_.bodies_separable)
          {
            const auto bodies = present_bodies(layout_, state_);
            for (std::size_t b = 0; b < bodies.size(); ++b)
              summary.ledger.bodies[scene_.bodies[b].name] = {
                  {"mass_g", bodies[b].mass},
                  {"axial_momentum_g_cm_per_us", bodies[b].momentum[Ledger<dim>::axial]},
                  {"internal_energy_Mbar_cm3", bodies[b].internal_energy},
                  {"kinetic_energy_Mbar_cm3", bodies[b].kinetic_energy}};
          }
      }
    clock_.read(summary.performance);
    summary.performance.active_cell_steps = 0;
    for (const summary::Stage &stage : summary.stages)
      summary.performance.active_cell_steps += stage.cell_steps;
    summary.counts.warnings = reporter_.log().warnings();
    for (const auto &[cause, booking] : ledger.bookings().by_cause())
      if (booking.event)
        summary.counts.events[cause] = {booking.event->number, booking.event->size, booking.event->unit};
    reporter_.tell(summary); // whatever becomes of the files
    on_first_rank<Error>(communicator, [&] {
      summary::write(summary, directory_);
      reporter_.flush();
    });
  }

  template <int dim>
  void
  Simulation<dim>::stopped(const Stage &stage, const StateError &error)
  {
    if (dynamic_cast<const Interrupted *>(&error))
      {
        last_good_.restore(layout_, state_); // what the checkpoint holds
        state_.books.summary.resumable = true;
        reporter_.log().info(error.what());
      }
    else if (state_.domain.view)
      reporter_.failed(stage, state_, error.what());
    else
      reporter_.log().warning(error.what());
    state_.books.summary.status = "stopped";
    state_.books.summary.reason = error.what();
    write_summary();
  }

  template <int dim>
  void
  Simulation<dim>::run()
  {
    try
      {
        while (state_.books.stage < scene_.stages.size())
          run_stage();
        if (problem_.exact)
          measure_errors();
        measure(&Measure<dim>::run_ends);
      }
    catch (const StateError &error)
      {
        stopped(scene_.stages[std::min(state_.books.stage, scene_.stages.size() - 1)], error);
        throw;
      }
    write_summary();
  }

  template <int dim>
  void
  Simulation<dim>::report_error_bars(const std::map<std::string, std::map<std::string, summary::ErrorBar>> &error_bars)
  {
    summary::Summary &summary = state_.books.summary;
    summary.error_bars        = error_bars;
    for (const auto &[place, quantities] : error_bars)
      for (const auto &[quantity, bar] : quantities)
        reporter_.result(place, quantity, summary.results.at(place).at(quantity), bar);
    on_first_rank<Error>(state_.domain.communicator(), [&] { summary::write(summary, directory_); });
  }

  template class Simulation<2>;
} // namespace whipple
