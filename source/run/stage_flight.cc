// SPDX-License-Identifier: LGPL-2.1-or-later
// Fragments that carry no stress fly freely: doc/theory/stages.md, "Free flight".
#include <whipple/hydro/free_flight.h>
#include <whipple/mesh/collective.h>
#include <whipple/run/stage_loop.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    /// Looks at what flies in a stage, at least.
    constexpr double looks_in_a_stage = 20;
    /// Time steps that a look must be worth, and the part of the elements that must fly: else all are stepped together.
    constexpr double worthwhile_steps = 10, worthwhile_share = 0.2;
    /// Part of the time that is round-off.
    constexpr double round_off = 1e-12;
  } // namespace

  template <int dim>
  double
  StageLoop<dim>::flight_time(double left) const
  {
    const StageProgress  &progress = run_.books.progress;
    const double          time     = run_.domain.state.time;
    const summary::Stage &record   = run_.books.summary.stages.back();
    double                dt       = std::min(left, (record.end_us - record.start_us) / looks_in_a_stage);
    for (const std::optional<double> interval :
         {scene_.output.fields_interval, std::optional<double>(scene_.output.statistics_interval)})
      if (interval && *interval > 0)
        dt = std::min(dt, *interval);
    dt = std::min(dt, std::max(progress.contacts.clear_until() - time, worthwhile_steps * progress.last_time_step));
    return dt;
  }

  template <int dim>
  bool
  StageLoop<dim>::fly(double left)
  {
    Domain<dim>   &domain   = run_.domain;
    StageProgress &progress = run_.books.progress;
    if (!stage_.lagrangian || stage_.lagrangian->cohesion != Cohesion::fragments || !holds_pieces())
      return false;
    const double dt = flight_time(left);
    if (!(progress.last_time_step > 0) || (dt < worthwhile_steps * progress.last_time_step && dt < left))
      return false;
    const MPI_Comm                  communicator = domain.communicator();
    const std::vector<std::uint8_t> flies =
        flying_cells(domain.view->mesh, domain.state, domain.derived, walls_, scene_.boundaries, dt);
    const double flying = sum_over_ranks(static_cast<double>(std::count(flies.begin(), flies.end(), 1)), communicator);
    if (!(flying >= worthwhile_share * static_cast<double>(cells_)) || flying == 0)
      return false;

    const double until = domain.state.time + dt;
    if (flying == static_cast<double>(cells_))
      {
        whipple::fly(domain.view->mesh, until - domain.state.time, domain.state);
        domain.state.time = until;
        ++run_.record().steps;
        ++run_.record().dt_limits["free flight"];
      }
    else
      {
        Flight<dim> flight(layout_, flies, domain);
        use_mesh();
        cycle_->evaluate(domain.state, domain.derived);
        while (until - domain.state.time > round_off * until)
          step(until - domain.state.time, &flight);
        flight.land(domain);
        use_mesh();
      }
    cycle_->evaluate(domain.state, domain.derived);
    check("free flight");
    return true;
  }

  template double
  StageLoop<2>::flight_time(double) const;
  template bool
  StageLoop<2>::fly(double);
} // namespace whipple
