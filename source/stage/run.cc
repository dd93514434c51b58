// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/output_directory.h>
#include <whipple/stage/run.h>
#include <whipple/stage/simulation.h>

namespace whipple
{
  void
  run_scene(const RunOptions &options, MPI_Comm communicator)
  {
    const Scene<2> scene = read_scene<2>(options.scene_file, options.overrides);
    if (options.validate_only)
      return;
    prepare_output_directory(options.output_directory, communicator);
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    if (rank == 0)
      write_effective_parameters(scene, options.output_directory + "/parameters.prm");
    Simulation<2>(scene, options.output_directory, options.live, communicator).run();
  }
} // namespace whipple
