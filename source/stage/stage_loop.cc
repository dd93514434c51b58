// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/folding.h>
#include <whipple/stage/bond_breaking.h>
#include <whipple/stage/collective.h>
#include <whipple/stage/debris_measure.h>
#include <whipple/stage/stage_loop.h>

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

    /// Stable steps ahead for which elements may not fold.
    constexpr double steps_ahead = 1.5;

    /// Part of a stage's typical step below which no sliver may push it.
    constexpr double sliver_share = 0.05;

    /// Whether elements can be pieces: without a void law in every material (gases) they can not be laid anew, and a
    /// mesh that folds is left to itself.
    template <int dim>
    bool
    holds_pieces(const State<dim> &state)
    {
      return std::all_of(state.material.begin(), state.material.end(),
                         [](const MaterialState &material) { return material.has_voids(); });
    }

    /// The reflecting sides, where they are planes of the lattice.
    template <int dim>
    RigidWalls<dim>
    rigid_walls(const Scene<dim> &scene)
    {
      RigidWalls<dim> walls;
      for (int side = 0; side < 2 * dim && scene.mesh_map == MeshMap::none; ++side)
        {
          walls.there[side]    = scene.boundaries[side].kind == BoundaryKind::reflecting;
          walls.position[side] = side % 2 ? scene.upper_corner()[side / 2] : scene.lattice.origin[side / 2];
        }
      return walls;
    }
  } // namespace

  template <int dim>
  StageLoop<dim>::StageLoop(const Scene<dim> &scene, const FieldLayout &layout, const Regridding<dim> &regridding,
                            const Handover<dim> &handover, const Stage &stage, int number, Reporter<dim> &reporter,
                            summary::Stage &record)
    : scene_(scene)
    , layout_(layout)
    , regridding_(regridding)
    , handover_(handover)
    , stage_(stage)
    , number_(number)
    , reporter_(reporter)
    , record_(record)
    , walls_(rigid_walls(scene))
    , state_guard_(scene, layout)
    , wall_start_(MPI_Wtime())
  {
  }

  template <int dim>
  void
  StageLoop<dim>::new_mesh(Domain<dim> &domain)
  {
    const FlatMesh<dim> &mesh = domain.view->mesh;
    cycle_                    = std::make_unique<Cycle<dim>>(scene_, stage_, layout_, mesh, domain.view->halo);
    cycle_->refresh(domain.state);
    guard_                   = Regridding<dim>::guard_cells(mesh);
    cells_                   = static_cast<long>(sum_over_ranks(mesh.n_owned, domain.communicator()));
    record_.active_cells_max = std::max(record_.active_cells_max, cells_);
    since_regrid_            = 0;
    spare_after_regrid_      = -1;
  }

  template <int dim>
  void
  StageLoop<dim>::regrid(Domain<dim> &domain, Ledger<dim> &ledger)
  {
    const KineticLoss loss = stage_.lost_kinetic_energy;
    ledger.gathered("regrid", regridding_.regrid(domain, loss), loss);
    new_mesh(domain);
    ledger.check(totals(domain.view->mesh, domain.state, domain.communicator()), "a regrid", round_off);
  }

  template <int dim>
  bool
  StageLoop<dim>::bonds_break(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts)
  {
    if (stage_.cohesion != Cohesion::graded || since_regrid_ < scene_.mesh.regrid_steps)
      return false;
    since_regrid_                 = 0;
    const KineticLoss      loss   = stage_.lost_kinetic_energy;
    const BreakReport<dim> report = break_bonds(stage_.breaking, scene_.boundaries, loss, domain);
    if (report.broken == 0)
      return false;
    counts.breaks += report.broken;
    ledger.gathered("broken bonds", report.gathered, loss);
    new_mesh(domain);
    ledger.check(totals(domain.view->mesh, domain.state, domain.communicator()), "breaking of bonds", round_off);
    return true;
  }

  template <int dim>
  bool
  StageLoop<dim>::guard_touched(const Domain<dim> &domain) const
  {
    int touched = 0;
    for (const MaterialState &m : domain.state.material)
      for (const Index c : guard_)
        touched = touched || m.mass[c] > 0;
    MPI_Allreduce(MPI_IN_PLACE, &touched, 1, MPI_INT, MPI_MAX, domain.communicator());
    return touched;
  }

  template <int dim>
  bool
  StageLoop<dim>::regrid_is_due(const Domain<dim> &domain)
  {
    if (since_regrid_ < scene_.mesh.regrid_steps)
      return false;
    since_regrid_                           = 0; // or ask again after as many steps
    const typename Regridding<dim>::Fit fit = regridding_.fit(domain);
    // balance between neighbours keeps some cells finer than needed: only what is more than after the last regrid
    // counts
    if (spare_after_regrid_ < 0)
      spare_after_regrid_ = fit.spare;
    return !fit.serves || fit.spare > spare_after_regrid_ + worthwhile_spare;
  }

  template <int dim>
  double
  StageLoop<dim>::time_left(const Domain<dim> &domain)
  {
    if (stage_.end.kind != StageEnd::Kind::leading_edge)
      return end_time_ - domain.state.time > 1e-9 * record_.end_us ? end_time_ - domain.state.time : 0.;

    // time until the fastest corner could bridge the gap; a hundredth of a cell short of the plate is there
    const double front    = extent(scene_.bodies[stage_.end.body].shape).lower[1];
    const double foremost = foremost_point(domain.view->mesh, domain.state, domain.communicator());
    const double gap      = front - foremost;
    double       fastest  = 0;
    for (Index n = 0; n < domain.state.n_nodes(); ++n)
      if (domain.state.node_mass[n] > 0)
        fastest = std::max(fastest, domain.state.velocity[1][n]);
    fastest = max_over_ranks(fastest, domain.communicator());
    if (gap <= 0.01 * scene_.lattice.spacing)
      return 0.;
    if (fastest <= 0)
      throw StateError("stage '" + stage_.name + "' waits for a leading edge, but nothing moves towards body '" +
                       scene_.bodies[stage_.end.body].name + "', " + std::to_string(gap) + " cm away");
    record_.end_us = domain.state.time + gap / fastest;
    return std::max(gap, 0.1 * scene_.lattice.spacing) / fastest;
  }

  template <int dim>
  double
  StageLoop<dim>::choose_time_step(const Domain<dim> &domain, double left)
  {
    limit_ = cycle_->time_step(domain.state, locked_);
    if (!(limit_.dt > 0))
      throw StateError("stage '" + stage_.name + "' has no positive time step: " + std::to_string(limit_.dt) + " us (" +
                       limit_.reason + ")");
    double     dt    = limit_.dt;
    const auto lower = [&](double bound, const char *reason) {
      if (bound < dt)
        {
          dt            = bound;
          limit_.reason = reason;
        }
    };
    // the first step is a full one: a short one delays the waves from a discontinuity (doc/theory/lagrange_step.md)
    if (last_dt_ > 0)
      lower(scene_.numerics.growth_limit * last_dt_, "growth");
    lower(stage_.max_time_step, "scene");
    lower(ceiling_, "retry");
    last_dt_ = dt;
    // two equal steps rather than a full one and a splinter
    if (left < 2. * dt)
      lower(left <= dt ? left : 0.5 * left, "end of stage");
    tried_dt_ = dt;
    return dt;
  }

  template <int dim>
  std::vector<RigidFragment<dim>>
  StageLoop<dim>::release(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts)
  {
    ReleaseReport<dim> report =
        release_fragments<dim>(domain.view->mesh, walls_, domain.state, steps_ahead * limit_.dt, locked_);
    const GatherReport<dim> all =
        sum_over_ranks(GatherReport<dim>{report.kinetic_loss, report.wall_impulse}, domain.communicator());
    ledger.gathered("released fragments", all, KineticLoss::heat);
    counts.releases += static_cast<long>(sum_over_ranks(report.released, domain.communicator()));
    return std::move(report.rigid);
  }

  template <int dim>
  void
  StageLoop<dim>::free_folding(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts)
  {
    if (stage_.cohesion == Cohesion::fragments || !holds_pieces(domain.state))
      return;
    std::vector<Index> cells = folding_cells(domain.view->mesh, domain.state, steps_ahead * limit_.dt);
    cells.insert(cells.end(), locked_.begin(), locked_.end());
    if (max_over_ranks(static_cast<double>(cells.size()), domain.communicator()) == 0)
      return;
    double mass = 0;
    for (const Index c : cells)
      mass += domain.view->mesh.intact[c] ? cell_mass<dim>(domain.state, c) : 0.;
    const KineticLoss      loss   = stage_.lost_kinetic_energy;
    const BreakReport<dim> report = free_cells<dim>(cells, scene_.boundaries, loss, domain);
    if (report.broken == 0)
      return;
    counts.breaks += report.broken;
    ledger.note("elements about to fold freed from the mesh", static_cast<double>(report.broken),
                sum_over_ranks(mass, domain.communicator()), "g");
    ledger.gathered("broken bonds", report.gathered, loss);
    new_mesh(domain);
    ledger.check(totals(domain.view->mesh, domain.state, domain.communicator()), "freeing of elements", round_off);
    take_snapshot(domain, ledger); // of the new nodes
  }

  template <int dim>
  void
  StageLoop<dim>::lock(const std::vector<Index> &cells)
  {
    for (std::vector<Index> *list : {&locked_, &new_locked_})
      {
        list->insert(list->end(), cells.begin(), cells.end());
        std::sort(list->begin(), list->end());
      }
  }

  template <int dim>
  bool
  StageLoop<dim>::lock_slivers(const Domain<dim> &domain)
  {
    const double bound = sliver_share * history_.typical();
    if (!(limit_.dt < bound) || !holds_pieces(domain.state))
      return false;
    std::vector<Index> cells = cycle_->slivers(domain.state, bound);
    std::erase_if(cells, [&](Index c) { return std::binary_search(locked_.begin(), locked_.end(), c); });
    if (sum_over_ranks(static_cast<double>(cells.size()), domain.communicator()) == 0)
      return false;
    lock(cells);
    return true;
  }

  template <int dim>
  void
  StageLoop<dim>::refuse_folded(const Domain<dim> &domain)
  {
    // what is locked has the shape that it had before it folded, whatever round-off makes of it
    std::vector<Index> cells = folded_cells(domain.view->mesh, domain.state);
    std::erase_if(cells, [&](Index c) { return std::binary_search(locked_.begin(), locked_.end(), c); });
    const double number = sum_over_ranks(static_cast<double>(cells.size()), domain.communicator());
    if (number == 0)
      return;
    retries_ = 0; // what has folded now will be free and locked in the next try: not the same again
    lock(cells);
    agree(domain.communicator(), [&] {
      if (cells.empty())
        return;
      const FlatMesh<dim> &mesh = domain.view->mesh;
      const Index          n    = mesh.cell_node[cells[0] * FlatMesh<dim>::corners];
      throw StateError("the step folded " + std::to_string(static_cast<long>(number)) + " elements, one of them at (" +
                       std::to_string(domain.state.position[0][n]) + ", " +
                       std::to_string(domain.state.position[1][n]) + ") cm");
    });
  }

  template <int dim>
  bool
  StageLoop<dim>::meet(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts)
  {
    if (!contacts_.due(record_.steps) || !holds_pieces(domain.state))
      return false;
    const KineticLoss        loss   = stage_.lost_kinetic_energy;
    const ContactReport<dim> report = join_contacts(scene_.boundaries, loss, domain);
    contacts_.looked(record_.steps, last_dt_, report);
    if (report.joined > 0)
      {
        ledger.note("overlapping elements that approach each other joined", static_cast<double>(report.joined),
                    report.gathered.kinetic_loss, "Mbar cm^3");
        ledger.gathered("contact", report.gathered, loss);
        cycle_->refresh(domain.state);
      }
    bool anew = false;
    if (overlap_is_deep(report))
      {
        anew = handover_.lay_anew(stage_, domain, ledger);
        ledger.note(anew ? "elements deep in one another, all laid anew"
                         : "elements deep in one another that find no room in the domain",
                    static_cast<double>(report.deep), 1., "times");
      }
    if (anew)
      {
        ++counts.rezones;
        new_mesh(domain);
        locked_.clear();
        new_locked_.clear();
      }
    if (report.joined > 0 || anew)
      ledger.check(totals(domain.view->mesh, domain.state, domain.communicator()), "contact of elements", round_off);
    return anew;
  }

  template <int dim>
  void
  StageLoop<dim>::step(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts, double left)
  {
    const double before = last_dt_;
    double       dt     = choose_time_step(domain, left);
    if (stage_.mode == StageMode::lagrangian && lock_slivers(domain))
      {
        last_dt_ = before;
        dt       = choose_time_step(domain, left);
      }
    std::vector<RigidFragment<dim>> rigid;
    if (stage_.mode == StageMode::lagrangian)
      {
        free_folding(domain, ledger, counts);
        rigid = release(domain, ledger, counts);
      }
    if (scene_.numerics.inject_failure_at_step == record_.steps + 1)
      for (MaterialState &m : domain.state.material)
        std::fill(m.energy.begin(), m.energy.end(), std::numeric_limits<double>::quiet_NaN());
    cycle_->advance(domain.state, dt, static_cast<int>(record_.steps % dim), rigid, ledger);
    if (stage_.mode == StageMode::lagrangian && holds_pieces(domain.state))
      refuse_folded(domain);
    const auto present = totals(domain.view->mesh, domain.state, domain.communicator());
    ledger.check(present, "a step", round_off);
    if ((record_.steps + 1) % snapshot_steps == 0)
      state_guard_.check(domain, ledger.energy_scale(), ledger);

    ++record_.steps;
    history_.add(last_dt_);
    ++since_regrid_;
    ++record_.dt_limits[limit_.reason];
    record_.cell_steps += cells_;
    const double fraction = (domain.state.time - record_.start_us) / (record_.end_us - record_.start_us);
    reporter_.step_done({&stage_, number_, record_.steps, dt, &limit_, cells_, fraction}, domain, ledger, present);
  }

  template <int dim>
  void
  StageLoop<dim>::go_back(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts, const StateError &error)
  {
    // every retry is really smaller than what failed, until the time has passed at which it did
    ceiling_      = retry_factor * tried_dt_;
    failed_until_ = domain.state.time + tried_dt_;
    domain.state  = snapshot_.state;
    ledger        = snapshot_.ledger;
    cycle_->forget_last_state(); // the step failed on one rank before, on others after it had changed the state
    record_.cell_steps -= static_cast<double>(cells_) * (record_.steps - snapshot_.step);
    history_.forget(record_.steps - snapshot_.step);
    record_.steps     = snapshot_.step;
    record_.dt_limits = snapshot_.dt_limits;
    reporter_.steps_undone(domain.state.time);
    if (retries_ == most_retries)
      {
        close_record(domain);
        throw; // the error that go_back was called for, with its type
      }
    ++retries_;
    ++counts.retries;
    reporter_.log().warning("gone back to step " + std::to_string(snapshot_.step) +
                            " for a smaller time step: " + error.what());
  }

  template <int dim>
  void
  StageLoop<dim>::note_locked(const Domain<dim> &domain, Ledger<dim> &ledger)
  {
    double number = 0, mass = 0;
    for (const Index c : new_locked_)
      {
        ++number;
        mass += cell_mass<dim>(domain.state, c);
      }
    number = sum_over_ranks(number, domain.communicator());
    if (number > 0)
      ledger.note("slivers and elements at the point of folding locked in their shape", number,
                  sum_over_ranks(mass, domain.communicator()), "g");
    new_locked_.clear();
  }

  template <int dim>
  void
  StageLoop<dim>::take_snapshot(const Domain<dim> &domain, Ledger<dim> &ledger)
  {
    note_locked(domain, ledger);
    if (domain.state.time >= failed_until_)
      {
        retries_ = 0;
        ceiling_ = std::numeric_limits<double>::infinity();
      }
    snapshot_ = {domain.state, ledger, record_.steps, record_.dt_limits};
    reporter_.steps_stand();
  }

  template <int dim>
  void
  StageLoop<dim>::close_record(const Domain<dim> &domain)
  {
    record_.end_us = domain.state.time;
    record_.wall_s = MPI_Wtime() - wall_start_;
    int ranks      = 1;
    MPI_Comm_size(domain.communicator(), &ranks);
    if (record_.wall_s > 0)
      record_.cell_steps_per_s_per_rank = record_.cell_steps / record_.wall_s / ranks;
  }

  template <int dim>
  void
  StageLoop<dim>::stop_if_collapsed(const Domain<dim> &domain)
  {
    const auto collapse = history_.collapse();
    if (!collapse)
      return;
    close_record(domain);
    throw StateError("stage '" + stage_.name + "' at " + std::to_string(domain.state.time) + " us: " + *collapse +
                     ", set by " + limit_.reason +
                     (std::isnan(limit_.place[0]) ? ""
                                                  : " at (" + std::to_string(limit_.place[0]) + ", " +
                                                        std::to_string(limit_.place[1]) + ") cm") +
                     ". Look at the fields there; a void law, coarser cells, or an earlier end of the stage may help");
  }

  template <int dim>
  void
  StageLoop<dim>::run(Domain<dim> &domain, Ledger<dim> &ledger, summary::Counts &counts)
  {
    const bool eulerian = stage_.mode == StageMode::eulerian;
    record_             = summary::Stage{};
    record_.name        = stage_.name;
    record_.mode        = eulerian ? "eulerian" : "lagrangian";
    record_.start_us    = domain.state.time;
    end_time_           = stage_.end.time + (stage_.end.kind == StageEnd::Kind::after ? domain.state.time : 0.);
    record_.end_us      = end_time_;
    new_mesh(domain);
    if (eulerian)
      record_.finest_equivalent_cells = static_cast<long>(scene_.lattice.finest(0)) * scene_.lattice.finest(1);
    else
      record_.elements = cells_;
    reporter_.stage_begins(stage_, number_, domain);
    take_snapshot(domain, ledger);

    for (double left; (left = time_left(domain)) > 0; stop_if_collapsed(domain))
      {
        try
          {
            step(domain, ledger, counts, left);
          }
        catch (const StateError &error)
          {
            go_back(domain, ledger, counts, error);
            continue;
          }
        if (eulerian && (regrid_is_due(domain) || guard_touched(domain)))
          {
            regrid(domain, ledger);
            take_snapshot(domain, ledger);
          }
        else if (!eulerian && (meet(domain, ledger, counts) || bonds_break(domain, ledger, counts)))
          take_snapshot(domain, ledger);
        else if (record_.steps - snapshot_.step >= snapshot_steps)
          take_snapshot(domain, ledger);
      }

    close_record(domain);
    reporter_.stage_ends(stage_, domain, ledger);
  }

  template class StageLoop<2>;
} // namespace whipple
