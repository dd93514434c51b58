// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/fragment_release.h>
#include <whipple/run/contact.h>
#include <whipple/run/cycle.h>
#include <whipple/run/flight.h>
#include <whipple/run/handover.h>
#include <whipple/run/last_good.h>
#include <whipple/run/phase_clock.h>
#include <whipple/run/regridding.h>
#include <whipple/run/run_state.h>
#include <whipple/run/stage_news.h>
#include <whipple/run/state_guard.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace whipple
{
  /// Steps one stage from its first to its last instant: time steps, regrids, retries, news.
  template <int dim>
  class StageLoop
  {
  public:
    /// All are kept by reference.
    /// @param run       with the mesh and state that the stage begins with, or is in the middle of
    /// @param before_step called before each: writes checkpoints, looks whether the run shall stop
    /// @param last_good what failures go back to, kept up to date
    StageLoop(const Scene<dim> &scene, const FieldLayout &layout, const Regridding<dim> &regridding,
              const Handover<dim> &handover, const Stage &stage, StageNews<dim> &news,
              std::function<void()> before_step, RunState<dim> &run, LastGood<dim> &last_good, PhaseClock &phases);

    /// From where the run state is to the end of the stage.
    /// @returns why the later stages would have nothing to do, if so
    /// @throws StateError on all ranks, after the last good state has been restored
    /// @throws Interrupted on all ranks; the last good state is in a checkpoint
    std::optional<std::string>
    run();

  private:
    void
    begin();
    /// Build what belongs to the mesh and its bonds.
    void
    use_mesh();
    /// The same of a mesh that the run has just got, with node masses and what follows from the state.
    void
    new_mesh();
    void
    regrid();
    /// Step, and what follows it: regrid, contact, breaking of bonds.
    void
    advance(double left);
    /// @param flight what is not in the domain because it flies freely meanwhile; null: nothing
    void
    step(double left, const Flight<dim> *flight);
    /// Let fragments without stress fly while the others are stepped. @returns false, and nothing has been done, if
    /// there are too few of them
    bool
    fly(double left);
    /// How long fragments may fly before the stage looks again, us.
    double
    flight_time(double left) const;
    /// Stop fragments that are about to fold from deforming. @returns whether any rank has changed the state
    /// @param rigid out: those that keep their shape in the step ahead
    bool
    release(std::vector<RigidFragment<dim>> &rigid);
    /// Every so many steps: break the bonds of elements that are intact no longer. @returns whether any broke
    bool
    bonds_break();
    /// Take elements that are about to fold, or did in the step that was undone, out of the mesh. @returns whether
    /// there were any; the mesh is new then
    bool
    free_folding();
    /// Whether elements can be pieces: without a void law in every material (gases) they can not be laid anew, and a
    /// mesh that folds is left to itself.
    bool
    holds_pieces() const;
    /// locked_ of the present mesh
    void
    find_locked();
    /// Lock slivers that would make the step much shorter than it is in this stage. @returns whether there were new
    /// ones
    bool
    lock_slivers();
    /// @param cells owned elements that keep their shape from now on, if they do not yet
    /// @returns the number of new ones of all ranks
    std::size_t
    lock(const std::vector<Index> &cells);
    /// Enter into the ledger what has been locked since the last time.
    void
    note_locked();
    /// @throws StateError if a step has folded an element; the elements are freed and locked in the next try
    void
    refuse_folded();
    /// Join elements that have run into one another; lay all anew if that does not do. @returns whether the mesh is new
    bool
    meet();
    /// Whether debris waits for an Eulerian stage.
    bool
    debris_comes() const;
    /// Lay down the debris that has come, if it is time to look. The mesh is new then.
    void
    land_arrivals();
    bool
    regrid_is_due();
    bool
    edge_touched() const;
    /// The largest stable time step of the state as it is, into limit_.
    void
    find_limit();
    /// The time step to make, from limit_.
    double
    choose_time_step(double left);
    StageEnd::Left
    time_left();
    /// @throws StateError, after the record has been closed, if the time step has collapsed.
    void
    stop_if_collapsed();
    void
    close_record();
    /// By all causes since the stages before ended, g.
    double
    dropped_mass() const;
    /// Compare the books with what is present. @throws ConservationError
    void
    check(const std::string &event);
    /// All so far is good.
    void
    stand();
    void
    go_back(const StateError &error);

    const Scene<dim>      &scene_;
    const FieldLayout     &layout_;
    const Regridding<dim> &regridding_;
    const Handover<dim>   &handover_;
    const Stage           &stage_;
    StageNews<dim>        &news_;
    std::function<void()>  before_step_;
    RunState<dim>         &run_;
    LastGood<dim>         &last_good_;
    PhaseClock            &phases_;
    RigidWalls<dim>        walls_;
    StateGuard<dim>        state_guard_;

    // what belongs to the present mesh
    std::unique_ptr<Cycle<dim>> cycle_;
    std::vector<Index>          edge_cells_;
    std::vector<Index>          locked_;    ///< owned elements that keep their shape, ascending
    long                        cells_ = 0; ///< active cells of all ranks

    AgreedTimeStep limit_{};         ///< of the present step
    double         tried_dt_    = 0; ///< us; the present step
    double         tried_until_ = 0; ///< us; its end
    double         wall_start_  = 0; ///< s
    double         cpu_start_   = 0; ///< s, of all ranks
  };
} // namespace whipple
