// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/collective.h>
#include <whipple/output/process_use.h>
#include <whipple/run/arrivals.h>
#include <whipple/run/rigid_walls.h>
#include <whipple/run/run_view.h>
#include <whipple/run/stage_loop.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    /// Largest part of any conserved quantity that a step, regrid or projection may lose: the round-off of some
    /// 1e5 cells.
    constexpr double round_off = 1e-12;

    /// Steps between snapshots, times a failed step is tried again, and the largest part of the time step that failed
    /// that is tried then.
    constexpr int    snapshot_steps = 10;
    constexpr int    most_retries   = 5;
    constexpr double retry_factor   = 0.5;

    /// Part of the active cells that coarsening must save to be worth a regrid of its own.
    constexpr double worthwhile_spare = 0.2;
  } // namespace

  template <int dim>
  StageLoop<dim>::StageLoop(const Scene<dim> &scene, const FieldLayout &layout, const Regridding<dim> &regridding,
                            const Handover<dim> &handover, const Stage &stage, StageNews<dim> &news,
                            std::function<void()> before_step, RunState<dim> &run, LastGood<dim> &last_good,
                            PhaseClock &phases)
    : scene_(scene)
    , layout_(layout)
    , regridding_(regridding)
    , handover_(handover)
    , stage_(stage)
    , news_(news)
    , before_step_(std::move(before_step))
    , run_(run)
    , last_good_(last_good)
    , phases_(phases)
    , walls_(rigid_walls(scene))
    , state_guard_(scene, layout)
  {
  }

  template <int dim>
  void
  StageLoop<dim>::use_mesh()
  {
    const Domain<dim>   &domain = run_.domain;
    const FlatMesh<dim> &mesh   = domain.view->mesh;
    cycle_      = std::make_unique<Cycle<dim>>(scene_, stage_, layout_, mesh, domain.view->halo, phases_);
    edge_cells_ = Regridding<dim>::edge_cells(mesh);
    cells_      = static_cast<long>(sum_over_ranks(mesh.n_owned, domain.communicator()));
    find_locked();
  }

  template <int dim>
  void
  StageLoop<dim>::new_mesh()
  {
    const auto phase = phases_.phase("regrid");
    use_mesh();
    cycle_->refresh(run_.domain.state, run_.domain.derived);
    run_.record().active_cells_max         = std::max(run_.record().active_cells_max, cells_);
    run_.books.progress.since_regrid       = 0;
    run_.books.progress.spare_after_regrid = -1;
    news_.mesh_is_new(run_);
  }

  template <int dim>
  void
  StageLoop<dim>::check(const std::string &event)
  {
    const auto phase = phases_.phase("ledger");
    run_.books.ledger.check(run_.present(), event, round_off);
  }

  template <int dim>
  void
  StageLoop<dim>::regrid()
  {
    const auto phase = phases_.phase("regrid");
    run_.books.ledger.enter(Regridding<dim>::cause, regridding_.regrid(run_.domain, stage_.lost_kinetic_energy));
    new_mesh();
    check("a regrid");
  }

  template <int dim>
  bool
  StageLoop<dim>::debris_comes() const
  {
    return run_.books.waiting && stage_.mode() == StageMode::eulerian;
  }

  template <int dim>
  void
  StageLoop<dim>::land_arrivals()
  {
    const auto     phase = phases_.phase("arrival of debris");
    RunBooks<dim> &books = run_.books;
    const double   time  = run_.domain.state.time;
    if (!debris_comes() || time < books.progress.next_arrivals)
      return;
    books.progress.next_arrivals = time + time_between_looks(scene_, *books.waiting);
    if (!handover_.land_arrivals(stage_, run_.domain, books.ledger, books.waiting))
      return;
    new_mesh();
    check("the arrival of debris");
  }

  template <int dim>
  bool
  StageLoop<dim>::edge_touched() const
  {
    int touched = 0;
    for (const MaterialState &m : run_.domain.state.material)
      for (const Index c : edge_cells_)
        touched = touched || m.mass[c] > 0;
    MPI_Allreduce(MPI_IN_PLACE, &touched, 1, MPI_INT, MPI_MAX, run_.domain.communicator());
    return touched;
  }

  template <int dim>
  bool
  StageLoop<dim>::regrid_is_due()
  {
    const auto     phase    = phases_.phase("regrid");
    StageProgress &progress = run_.books.progress;
    if (progress.since_regrid < scene_.mesh.regrid_steps)
      return false;
    progress.since_regrid                   = 0; // or ask again after as many steps
    const typename Regridding<dim>::Fit fit = regridding_.fit(run_.domain);
    // balance between neighbours keeps some cells finer than needed: only what is more than after the last regrid
    // counts
    if (progress.spare_after_regrid < 0)
      progress.spare_after_regrid = fit.spare;
    return !fit.suffices || fit.spare > progress.spare_after_regrid + worthwhile_spare;
  }

  template <int dim>
  StageEnd::Left
  StageLoop<dim>::time_left()
  {
    const auto           phase = phases_.phase("end of the stage");
    const StageEnd::Left left =
        stage_.end->time_left(RunView<dim>(scene_, layout_, run_), run_.books.progress.memory_of_end);
    run_.record().end_us = left.end;
    return left;
  }

  template <int dim>
  void
  StageLoop<dim>::find_limit()
  {
    const auto phase = phases_.phase("time step");
    limit_           = cycle_->time_step(run_.domain.state, run_.domain.derived, locked_);
    if (!(limit_.dt > 0))
      throw StateError("stage '" + stage_.name + "' has no positive time step: " + std::to_string(limit_.dt) + " us (" +
                       limit_.reason + ")");
  }

  template <int dim>
  double
  StageLoop<dim>::choose_time_step(double left)
  {
    StageProgress &progress = run_.books.progress;
    double         dt       = limit_.dt;
    const auto     lower    = [&](double bound, const char *reason) {
      if (bound < dt)
        {
          dt            = bound;
          limit_.reason = reason;
        }
    };
    // the first step is a full one: a short one delays the waves from a discontinuity (doc/theory/lagrange_step.md)
    if (progress.last_time_step > 0)
      lower(scene_.numerics.growth_limit * progress.last_time_step, "growth");
    lower(stage_.max_time_step, "scene");
    lower(progress.ceiling, "retry");
    if (debris_comes())
      lower(0.5 * time_between_looks(scene_, *run_.books.waiting), "arrival of debris");
    progress.last_time_step = dt;
    // two equal steps rather than a full one and a very short one
    if (left < 2. * dt)
      lower(left <= dt ? left : 0.5 * left, "end of stage");
    tried_dt_    = dt;
    tried_until_ = run_.domain.state.time + dt;
    return dt;
  }

  template <int dim>
  void
  StageLoop<dim>::step(double left, const Flight<dim> *flight)
  {
    Domain<dim> &domain = run_.domain;
    Ledger<dim> &ledger = run_.books.ledger;
    find_limit();
    std::vector<RigidFragment<dim>> rigid;
    if (stage_.mode() == StageMode::lagrangian)
      {
        if (lock_slivers())
          find_limit();
        const bool freed = free_folding(), released = release(rigid);
        if (released)
          cycle_->evaluate(domain.state, domain.derived); // heated: other pressures and strengths
        if (freed || released)
          {
            // no longer than what folding was looked for in, no longer than what the heated pieces allow
            const AgreedTimeStep before = limit_;
            find_limit();
            if (before.dt < limit_.dt)
              limit_ = before;
          }
      }
    const double    dt       = choose_time_step(left);
    const Numerics &numerics = scene_.numerics;
    if (numerics.inject_failure_at_step == run_.record().steps + 1 &&
        run_.books.progress.retries < numerics.injected_failures)
      for (MaterialState &m : domain.state.material)
        std::fill(m.energy.begin(), m.energy.end(), std::numeric_limits<double>::quiet_NaN());
    cycle_->advance(domain.state, domain.derived, dt, static_cast<int>(run_.record().steps % dim), rigid, ledger);
    if (stage_.mode() == StageMode::lagrangian && holds_pieces())
      refuse_folded();
    const auto phase   = phases_.phase("ledger");
    auto       present = run_.present();
    if (flight)
      present += flight->totals();
    ledger.check(present, "a step", round_off);
    summary::Stage &record = run_.record();
    if ((record.steps + 1) % snapshot_steps == 0)
      state_guard_.check(domain, ledger.energy_scale(), ledger);

    ++record.steps;
    run_.books.progress.history.add(run_.books.progress.last_time_step);
    ++run_.books.progress.since_regrid;
    ++record.dt_limits[limit_.reason];
    record.cell_steps += static_cast<double>(cells_);
    const double fraction = (domain.state.time - record.start_us) / (record.end_us - record.start_us);
    news_.step_done({&stage_, record.steps, dt, &limit_, cells_, fraction}, present, run_);
  }

  template <int dim>
  void
  StageLoop<dim>::advance(double left)
  {
    const double before = run_.domain.state.time;
    land_arrivals();
    if (!fly(left))
      step(left, nullptr);
    {
      const auto phase = phases_.phase("output");
      news_.look(stage_, run_.domain.state.time - before, run_);
    }
    if (stage_.mode() == StageMode::eulerian)
      {
        if (regrid_is_due() || edge_touched())
          regrid();
      }
    else
      {
        const auto phase = phases_.phase("contact and breaking");
        if (!meet())
          bonds_break();
      }
  }

  template <int dim>
  void
  StageLoop<dim>::go_back(const StateError &error)
  {
    const auto phase = phases_.phase("going back");
    // of what failed, only that it did is kept: every retry is really smaller than that, until its time has passed
    const StageProgress failed   = run_.books.progress;
    const long          retries  = run_.books.summary.counts.retries;
    const bool          new_view = last_good_.restore(layout_, run_);
    StageProgress      &progress = run_.books.progress;
    news_.steps_undone(run_.books);
    progress.ceiling = retry_factor * tried_dt_;
    // not by the clock of the state: ranks may have failed before and after it moved
    progress.failed_until = tried_until_;
    progress.retries      = failed.retries;
    progress.locked       = failed.locked;
    if (new_view)
      use_mesh();
    else
      find_locked();
    cycle_->evaluate(run_.domain.state, run_.domain.derived);
    run_.books.summary.counts.retries = retries;
    if (progress.retries >= most_retries)
      {
        close_record();
        throw; // the error that go_back was called for, with its type
      }
    ++progress.retries;
    ++run_.books.summary.counts.retries;
    news_.log().warning("gone back to step " + std::to_string(run_.record().steps) +
                        " for a smaller time step: " + error.what());
  }

  template <int dim>
  void
  StageLoop<dim>::stand()
  {
    const auto     phase    = phases_.phase("snapshots");
    StageProgress &progress = run_.books.progress;
    note_locked();
    if (run_.domain.state.time >= progress.failed_until)
      {
        progress.retries = 0;
        progress.ceiling = std::numeric_limits<double>::infinity();
      }
    run_.record().wall_s               = MPI_Wtime() - wall_start_;
    run_.record().cpu_s                = process_use(run_.domain.communicator()).cpu_s - cpu_start_;
    run_.books.summary.counts.warnings = news_.log().warnings();
    news_.steps_stand(run_.books);
    last_good_.keep(run_);
  }

  template <int dim>
  double
  StageLoop<dim>::dropped_mass() const
  {
    double mass = 0;
    for (const auto &[cause, booking] : run_.books.ledger.bookings().by_cause())
      if (booking.dropped)
        mass += booking.dropped->mass;
    const auto &stages = run_.books.summary.stages;
    for (auto stage = stages.begin(); stage + 1 != stages.end(); ++stage)
      mass -= stage->dropped_mass_g;
    return std::max(mass, 0.); // where nothing was, not the round-off of the sum
  }

  template <int dim>
  void
  StageLoop<dim>::close_record()
  {
    summary::Stage &record = run_.record();
    record.end_us          = run_.domain.state.time;
    record.wall_s          = MPI_Wtime() - wall_start_;
    record.cpu_s           = process_use(run_.domain.communicator()).cpu_s - cpu_start_;
    record.dropped_mass_g  = dropped_mass();
    int ranks              = 1;
    MPI_Comm_size(run_.domain.communicator(), &ranks);
    if (record.wall_s > 0)
      record.cell_steps_per_s_per_rank = record.cell_steps / record.wall_s / ranks;
  }

  template <int dim>
  void
  StageLoop<dim>::stop_if_collapsed()
  {
    const auto collapse = run_.books.progress.history.collapse();
    if (!collapse)
      return;
    close_record();
    throw StateError("stage '" + stage_.name + "' at " + std::to_string(run_.domain.state.time) + " us: " + *collapse +
                     ", set by " + limit_.reason +
                     (std::isnan(limit_.place[0]) ? ""
                                                  : " at (" + std::to_string(limit_.place[0]) + ", " +
                                                        std::to_string(limit_.place[1]) + ") cm") +
                     ". Look at the fields there; a void law, coarser cells, or an earlier end of the stage may help");
  }

  template <int dim>
  void
  StageLoop<dim>::begin()
  {
    const double   now      = run_.domain.state.time;
    const bool     eulerian = stage_.mode() == StageMode::eulerian;
    StageProgress &progress = run_.books.progress;
    progress                = StageProgress{};
    progress.begun          = true;
    summary::Stage &record  = run_.books.summary.stages.emplace_back();
    record.name             = stage_.name;
    record.mode             = eulerian ? "eulerian" : "lagrangian";
    record.start_us         = now;
    new_mesh();
    if (eulerian)
      record.finest_equivalent_cells = static_cast<long>(scene_.lattice.finest(0)) * scene_.lattice.finest(1);
    else
      record.elements = cells_;
    {
      const auto phase = phases_.phase("output");
      news_.stage_begins(stage_, run_);
    }
    stand();
  }

  template <int dim>
  std::optional<std::string>
  StageLoop<dim>::run()
  {
    if (run_.books.progress.begun)
      {
        wall_start_ = MPI_Wtime() - run_.record().wall_s;
        cpu_start_  = process_use(run_.domain.communicator()).cpu_s - run_.record().cpu_s;
        use_mesh();
        cycle_->evaluate(run_.domain.state, run_.domain.derived);
      }
    else
      {
        wall_start_ = MPI_Wtime();
        cpu_start_  = process_use(run_.domain.communicator()).cpu_s;
        begin();
      }
    StageEnd::Left left{};
    for (; (left = time_left()).time > 0; stop_if_collapsed())
      {
        {
          const auto phase = phases_.phase("checkpoints");
          before_step_();
        }
        try
          {
            advance(left.time);
          }
        catch (const StateError &error)
          {
            go_back(error);
            continue;
          }
        const bool new_view = last_good_.view() != run_.domain.view;
        if (new_view || run_.record().steps - last_good_.steps() >= snapshot_steps)
          stand();
      }
    close_record();
    if (run_.books.waiting && (left.chain_over || run_.books.stage + 1 == scene_.stages.size()))
      run_.books.ledger.note("parts of debris still on its way at the end",
                             static_cast<double>(run_.books.waiting->parts.size()), run_.books.waiting->totals.mass,
                             "g");
    const auto phase = phases_.phase("output");
    news_.stage_ends(stage_, run_);
    return left.chain_over;
  }

  template class StageLoop<2>;
} // namespace whipple
