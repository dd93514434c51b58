// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/phase_measure.h>
#include <whipple/output/duration.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/manifest.h>
#include <whipple/problem/effect_forecast.h>
#include <whipple/problem/scene_warnings.h>
#include <whipple/run/reporter.h>
#include <whipple/state/conversion.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <limits>

namespace whipple
{
  namespace
  {
    std::string
    format(const char *pattern, ...)
    {
      char    text[256];
      va_list arguments;
      va_start(arguments, pattern);
      std::vsnprintf(text, sizeof text, pattern, arguments);
      va_end(arguments);
      return text;
    }

    /// The value with as many decimals as its error bar has: one digit of that, two if it starts with 1.
    std::string
    with_error_bar(double value, double error)
    {
      constexpr int most_decimals = 12;
      int           decimals      = 3;
      if (error > 0)
        {
          const int    exponent = static_cast<int>(std::floor(std::log10(error)));
          const double leading  = error / std::pow(10., exponent);
          decimals              = std::clamp((leading < 2 ? 1 : 0) - exponent, 0, most_decimals);
        }
      return format("%.*f +- %.*f", decimals, value, decimals, error);
    }

    template <int dim>
    std::string
    ledger_line(const std::string &what, const ConservedTotals<dim> &amount)
    {
      return format("  %-24s %13.6e %15.6e %15.6e %15.6e", what.c_str(), amount.mass,
                    amount.momentum[Ledger<dim>::axial], amount.internal_energy, amount.kinetic_energy);
    }
  } // namespace

  template <int dim>
  Reporter<dim>::Reporter(const Problem<dim> &problem, const std::string &directory, bool live, MPI_Comm communicator,
                          const RunBooks<dim> *resumed)
    : problem_(problem)
    , scene_(problem.scene)
    , layout_(problem.layout)
    , directory_(directory)
    , log_(directory, communicator, live, resumed ? RunLog::Earlier::kept : RunLog::Earlier::replaced)
    , statistics_(directory + "/statistics.csv", communicator, resumed ? resumed->report.statistics_bytes : 0)
    , fields_(directory, layout_.material_names,
              FieldOutputOptions{.hdf5 = scene_.output.hdf5, .vtu = scene_.output.vtu}, communicator,
              [&layout = layout_](const State<dim> &state, const std::vector<Index> &cells) {
                return phase_fields(layout, state, cells);
              })
    , time_left_(estimate_cost(problem).stage_seconds)
  {
    begin_watches(communicator, resumed);
    log_.banner();
    if (!scene_.title.empty())
      log_.info(scene_.title);
    if (resumed)
      {
        log_.count_from(resumed->summary.counts.warnings);
        fields_.go_on(resumed->report.fields);
        if (resumed->progress.begun) // the stage has taken that long already
          time_left_.begin(resumed->stage, log_.wall_seconds() - resumed->summary.stages.back().wall_s);
        return;
      }
    log_.info("effects (what, whether, number, why):");
    for (const EffectVerdict &verdict : scene_.effect_verdicts)
      log_.info(effect_line(verdict));
    for (const std::string &line : scene_warnings(problem_))
      log_.warning(line);
  }

  template <int dim>
  void
  Reporter<dim>::begin_watches(MPI_Comm communicator, const RunBooks<dim> *resumed)
  {
    for (const auto &[key, entry] : MeasureRegistry<dim>::all())
      {
        auto watch = entry.watch ? entry.watch(problem_) : nullptr;
        if (!watch)
          continue;
        Watching watching{key.second, std::move(watch), {}, {}};
        watching.tables = watching.watch->tables();
        for (const WatchTable &table : watching.tables)
          {
            const std::string path = directory_ + '/' + table.file;
            on_first_rank<Error>(communicator, [&] {
              std::filesystem::create_directories(std::filesystem::path(path).parent_path());
              manifest::note(directory_, table.file);
            });
            std::uint64_t kept = 0;
            if (resumed)
              if (const auto found = resumed->report.table_bytes.find(table.file);
                  found != resumed->report.table_bytes.end())
                kept = found->second;
            watching.files.push_back(std::make_unique<StepTable>(path, communicator, kept));
          }
        watching_.push_back(std::move(watching));
      }
  }

  template <int dim>
  template <typename Call>
  void
  Reporter<dim>::let_watch(RunState<dim> &run, const Call &call)
  {
    const Domain<dim> &domain = run.domain;
    for (const Watching &w : watching_)
      {
        const MeasureView<dim> view{problem_,       run.books.stage,       domain.view->mesh,       domain.state,
                                    domain.derived, domain.communicator(), run.books.waiting.get(), run.books.watches};
        call(*w.watch, view, run.books.watches[w.name], [&w](std::size_t table, const std::vector<double> &row) {
          std::vector<TableEntry> entries;
          for (std::size_t i = 0; i < row.size(); ++i)
            entries.push_back({w.tables[table].columns.at(i), row[i]});
          w.files[table]->write(entries);
        });
      }
  }

  template <int dim>
  void
  Reporter<dim>::mesh_is_new(RunState<dim> &run)
  {
    let_watch(run, [](const Watch<dim> &watch, const MeasureView<dim> &view, std::vector<double> &memory,
                      const WriteRow &write) { watch.mesh_is_new(view, memory, write); });
  }

  template <int dim>
  void
  Reporter<dim>::flush()
  {
    statistics_.flush();
    for (const Watching &w : watching_)
      for (const auto &file : w.files)
        file->flush();
  }

  template <int dim>
  void
  Reporter<dim>::write_fields(const Stage &stage, RunState<dim> &run)
  {
    if (!scene_.output.fields_interval)
      return;
    fields_.write(run.domain.view->mesh, run.domain.state, run.domain.derived, stage.name);
    run.books.report.fields = fields_.series();
  }

  template <int dim>
  void
  Reporter<dim>::stage_begins(const Stage &stage, RunState<dim> &run)
  {
    const double time = run.domain.state.time;
    time_left_.begin(run.books.stage, log_.wall_seconds());
    log_.info(format("stage %zu: %s (%s) from %.6g us", run.books.stage + 1, stage.name.c_str(),
                     stage.mode() == StageMode::eulerian ? "eulerian" : "lagrangian", time));
    write_fields(stage, run);
    if (scene_.output.fields_interval)
      run.books.report.next_fields = time + *scene_.output.fields_interval;
  }

  template <int dim>
  void
  Reporter<dim>::write_statistics(const StepNews &news, const ConservedTotals<dim> &present, const RunState<dim> &run)
  {
    const Ledger<dim>       &ledger  = run.books.ledger;
    const auto               closure = ledger.closure(present);
    std::vector<std::string> names; // of the conversions, kept while the row refers to them
    std::vector<double>      converted;
    for (const auto &[key, listed] : ConversionRegistry::all())
      if (listed == ConversionListed::each_step)
        {
          names.push_back(conversion_name(key.second) + " [Mbar cm^3]");
          converted.push_back(ledger.bookings().of(key.second).converted.value_or(0.));
        }
    std::vector<TableEntry> row{{"time [us]", run.domain.state.time},
                                {"stage", static_cast<double>(run.books.stage + 1)},
                                {"step", static_cast<double>(news.step)},
                                {"time step [us]", news.dt},
                                {"active cells", static_cast<double>(news.cells)},
                                {"mass [g]", present.mass},
                                {"axial momentum [g cm/us]", present.momentum[Ledger<dim>::axial]},
                                {"internal energy [Mbar cm^3]", present.internal_energy},
                                {"kinetic energy [Mbar cm^3]", present.kinetic_energy},
                                {"mass left domain [g]", ledger.left().mass}};
    for (std::size_t i = 0; i < names.size(); ++i)
      row.push_back({names[i], converted[i]});
    for (const TableEntry &entry :
         std::initializer_list<TableEntry>{{"mass closure", closure.mass},
                                           {"axial momentum closure", closure.axial_momentum},
                                           {"energy closure", closure.energy},
                                           {"time step set by", std::string_view(news.limit->reason)},
                                           {"set at axis 0 [cm]", news.limit->place[0]},
                                           {"set at axis 1 [cm]", news.limit->place[1]}})
      row.push_back(entry);
    statistics_.write(row);
  }

  template <int dim>
  void
  Reporter<dim>::step_done(const StepNews &news, const ConservedTotals<dim> &present, RunState<dim> &run)
  {
    const double    time   = run.domain.state.time;
    ReportProgress &report = run.books.report;
    Progress        progress;
    progress.stage      = news.stage->name;
    progress.step       = news.step;
    progress.time       = time;
    progress.time_step  = news.dt;
    progress.limiter    = news.limit->reason;
    progress.cells      = news.cells;
    progress.fraction   = news.fraction;
    const auto left     = time_left_.at(news.fraction, log_.wall_seconds());
    progress.stage_left = left.of_stage;
    progress.run_left   = left.of_run;
    log_.progress(progress);

    if (time >= report.next_statistics)
      {
        write_statistics(news, present, run);
        report.next_statistics = time + scene_.output.statistics_interval;
      }
  }

  template <int dim>
  void
  Reporter<dim>::look(const Stage &stage, double dt, RunState<dim> &run)
  {
    ReportProgress &report = run.books.report;
    let_watch(run, [dt](const Watch<dim> &watch, const MeasureView<dim> &view, std::vector<double> &memory,
                        const WriteRow &write) { watch.step_done(view, dt, memory, write); });
    if (scene_.output.fields_interval && run.domain.state.time >= report.next_fields)
      {
        write_fields(stage, run);
        report.next_fields += *scene_.output.fields_interval;
      }
  }

  template <int dim>
  void
  Reporter<dim>::steps_stand(RunBooks<dim> &books)
  {
    statistics_.keep();
    books.report.statistics_bytes = statistics_.kept_bytes();
    for (const Watching &w : watching_)
      for (std::size_t t = 0; t < w.files.size(); ++t)
        {
          w.files[t]->keep();
          books.report.table_bytes[w.tables[t].file] = w.files[t]->kept_bytes();
        }
  }

  template <int dim>
  void
  Reporter<dim>::steps_undone(const RunBooks<dim> &books)
  {
    statistics_.forget();
    for (const Watching &w : watching_)
      for (const auto &file : w.files)
        file->forget();
    fields_.go_on(books.report.fields);
  }

  template <int dim>
  void
  Reporter<dim>::warn_of_events(const Stage &stage, RunBooks<dim> &books)
  {
    for (const auto &[what, booking] : books.ledger.bookings().by_cause())
      {
        if (!booking.event)
          continue;
        const Event &event  = *booking.event;
        Event       &warned = books.report.events_warned[what];
        if (event.number > warned.number)
          log_.warning(format("stage %s: %s, %.0f times, %.3g %s in all", stage.name.c_str(), what.c_str(),
                              event.number - warned.number, event.size - warned.size, event.unit.c_str()));
        warned = event;
      }
  }

  template <int dim>
  void
  Reporter<dim>::stage_ends(const Stage &stage, RunState<dim> &run)
  {
    const Domain<dim> &domain = run.domain;
    const Ledger<dim> &ledger = run.books.ledger;
    write_fields(stage, run);
    const ConservedTotals<dim> present = run.present();
    log_.info(format("ledger at %.6g us, end of %s", domain.state.time, stage.name.c_str()));
    log_.info(format("  %-24s %13s %15s %15s %15s", "", "mass", "axial momentum", "internal", "kinetic"));
    log_.info(format("  %-24s %13s %15s %15s %15s", "", "g", "g cm/us", "Mbar cm^3", "Mbar cm^3"));
    log_.info(ledger_line("introduced", ledger.introduced()));
    log_.info(ledger_line("left the domain", ledger.left()));
    for (const auto &[cause, booking] : ledger.bookings().by_cause())
      if (booking.dropped)
        log_.info(ledger_line("dropped: " + cause, *booking.dropped));
    log_.info(ledger_line("present", present));
    if (run.books.waiting)
      log_.info(ledger_line("  on its way", run.books.waiting->totals));
    if (layout_.bodies_separable && scene_.bodies.size() > 1)
      {
        const auto bodies = present_bodies(layout_, run);
        for (std::size_t b = 0; b < bodies.size(); ++b)
          if (bodies[b].mass > 0)
            log_.info(ledger_line("  of " + scene_.bodies[b].name, bodies[b]));
      }
    for (const auto &[cause, booking] : ledger.bookings().by_cause())
      if (booking.converted)
        log_.info(format("  converted by %-22s %15.6e Mbar cm^3", cause.c_str(), *booking.converted));
    const auto closure = ledger.closure(present);
    log_.info(format("  closes to %.1e (mass), %.1e (axial momentum), %.1e (total energy)", closure.mass,
                     closure.axial_momentum, closure.energy));
    warn_of_events(stage, run.books);
  }

  template <int dim>
  void
  Reporter<dim>::result(const std::string &place, const std::string &quantity, const summary::Result &value,
                        const summary::ErrorBar &bar)
  {
    std::string text = place + ' ' + quantity;
    if (const double *number = std::get_if<double>(&value))
      text += ' ' + (bar.error ? with_error_bar(*number, *bar.error) : format("%.4g", *number));
    else if (const bool *verdict = std::get_if<bool>(&value))
      text += *verdict ? " yes" : " no";
    log_.info(text + " (" + bar.verdict + ')');
  }

  template <int dim>
  void
  Reporter<dim>::tell(const summary::Summary &summary)
  {
    const std::vector<std::string> found = result_lines(scene_, summary.results);
    if (!found.empty())
      log_.info("results:");
    for (const std::string &line : found)
      log_.info("  " + line);
    const summary::Performance &cost = summary.performance;
    log_.info(summary.status + " in " + duration(cost.wall_s) + " on " + std::to_string(cost.ranks) +
              (cost.ranks == 1 ? " rank, " : " ranks, ") +
              format("%.3g million cell steps, %.0f MB", 1e-6 * cost.active_cell_steps, 1e-6 * cost.peak_rss_bytes));
    log_.info("output in " + directory_ + "; pictures: ./whipple plot " + directory_);
  }

  template <int dim>
  void
  Reporter<dim>::failed(const Stage &stage, RunState<dim> &run, const std::string &reason)
  {
    const Domain<dim> &domain = run.domain;
    warn_of_events(stage, run.books);
    log_.warning(reason);
    write_last_good_state(directory_, domain.view->mesh, domain.state, domain.derived, layout_.material_names,
                          stage.name, reason, domain.communicator());
    log_.info(format("the last good state, at %.6f us, is in the output directory", domain.state.time));
  }

  template class Reporter<2>;
} // namespace whipple
