// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/run/checkpointing.h>

namespace whipple
{
  template <int dim>
  Checkpointing<dim>::Checkpointing(const Scene<dim> &scene, const FieldLayout &layout, const std::string &directory,
                                    double wall_start, const RunClock &clock, MPI_Comm communicator)
    : directory_(directory)
    , store_(directory, layout, scene.effective_parameters, communicator)
    , interruption_(scene.output.checkpoint_interval, scene.output.wall_time_limit, wall_start, communicator)
    , clock_(clock)
  {
  }

  template <int dim>
  std::string
  Checkpointing<dim>::write(LastGood<dim> &last_good, Reporter<dim> &reporter)
  {
    reporter.flush();
    last_good.read_clock(clock_);
    std::string directory;
    try
      {
        directory = store_.write(last_good);
      }
    catch (const checkpoint::Unusable &error)
      {
        reporter.log().warning(std::string("no checkpoint: ") + error.what());
      }
    interruption_.written();
    return directory;
  }

  template <int dim>
  void
  Checkpointing<dim>::after_step(LastGood<dim> &last_good, Reporter<dim> &reporter)
  {
    const Interruption::Wish wish = interruption_.poll(2. * store_.slowest_write());
    if (!wish.checkpoint)
      return;
    const std::string directory = write(last_good, reporter);
    if (wish.stop)
      throw Interrupted(wish.reason + (directory.empty() ? "; no checkpoint could be written"
                                                         : "; to go on: whipple run --resume '" + directory_ + "'"));
    reporter.log().info("checkpoint at " + std::to_string(last_good.state().time) + " us: " + directory);
  }

  template class Checkpointing<2>;
} // namespace whipple
