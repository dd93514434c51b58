// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <whipple/command/command_line.h>
#include <whipple/command/mpirun.h>
#include <whipple/error.h>
#include <whipple/output/output_directory.h>
#include <whipple/output/version.h>
#include <whipple/study/run.h>
#include <whipple/study/study.h>

#include <chrono>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace
{
  using namespace whipple;

  /// Part of the interface to the outside: tools tell the cases apart by them.
  enum ExitStatus
  {
    done          = 0,
    other_failure = 1,
    input_wrong   = 2,
    stopped       = 3
  };

  struct Failure
  {
    ExitStatus  status = done;
    std::string message;
  };

  /// Run `work` and tell what went wrong with it.
  template <typename Work>
  Failure
  attempt(const Work &work)
  {
    try
      {
        work();
        return {};
      }
    catch (const InputError &error)
      {
        return {input_wrong, error.what()};
      }
    catch (const StateError &error)
      {
        return {stopped, std::string("stopped: ") + error.what()};
      }
    catch (const std::exception &error)
      {
        return {other_failure, error.what()};
      }
  }

  /// A study starts its runs as processes of their own: MPI stays down.
  ExitStatus
  run_study_alone(StudyOptions options)
  {
    options.live          = mpirun::prints_to_terminal();
    const Failure failure = attempt([&] {
      if (mpirun::is_rank())
        throw InputError("a study is no MPI program; it starts the ranks of its runs itself: -n RANKS");
      run_study(options, std::cout);
    });
    if (failure.status != done)
      std::cerr << "whipple: " << failure.message << std::endl;
    return failure.status;
  }

  /// An earlier run is kept: the new one goes beside it, unless it shall replace it. Ranks that mpirun has started go
  /// where they were told.
  void
  choose_directory(RunOptions &options, std::vector<std::string> &arguments)
  {
    if (options.overwrite || options.resume || options.validate_only || options.effects_report || mpirun::is_rank())
      return;
    const std::string free = free_output_directory(options.output_directory);
    if (free == options.output_directory)
      return;
    std::cout << "'" << options.output_directory << "' holds an earlier run, which stays; this one goes to '" << free
              << "' (--overwrite: replace it)" << std::endl;
    options.output_directory = free;
    arguments.insert(arguments.end(), {"--output", free});
  }

  /// A rank that a signal ends (out of memory, a person) takes the others with it, and none can say so.
  void
  tell_of_killed_ranks(int status, const RunOptions &options)
  {
    constexpr int killed = 128; // and the number of the signal, as shells have it
    if (status <= killed)
      return;
    const bool can_go_on = std::filesystem::exists(options.output_directory + "/checkpoints") &&
                           !std::filesystem::is_empty(options.output_directory + "/checkpoints");
    std::cerr << "whipple: a rank was ended by signal " << status - killed << " (" << strsignal(status - killed)
              << "), and with it the run; "
              << (can_go_on ? "go on from its last checkpoint with: whipple run --resume " : "no checkpoint yet in ")
              << options.output_directory << std::endl;
  }

  void
  execute(const command_line::Command &command)
  {
    const int rank  = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const int ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    if (const auto *run = std::get_if<command_line::Run>(&command))
      {
        if (run->ranks != 0 && run->ranks != ranks)
          throw InputError("command line", "-n", std::to_string(run->ranks),
                           "mpirun has already started " + std::to_string(ranks) + " ranks");
        run_scene(run->options, MPI_COMM_WORLD);
      }
    else if (rank == 0)
      {
        if (const auto *help = std::get_if<command_line::Help>(&command))
          std::cout << command_line::help(help->topic);
        else
          std::cout << "Whipple " << version::number() << " (" << version::git_hash() << ")\n";
      }
  }

  /// Errors are thrown on every rank alike, then rank 0 speaks for all. Should one rank fail alone, the others
  /// wait for it in some exchange: it then says so itself and ends them all. `communicator` is used for nothing else,
  /// so that this cannot be mixed up with what the other ranks wait in.
  void
  report(const Failure &failure, MPI_Comm communicator)
  {
    using namespace std::chrono_literals;
    const int   rank = dealii::Utilities::MPI::this_mpi_process(communicator);
    MPI_Request everybody;
    MPI_Ibarrier(communicator, &everybody);
    const auto deadline = std::chrono::steady_clock::now() + 5s;
    int        together = 0;
    MPI_Test(&everybody, &together, MPI_STATUS_IGNORE);
    while (!together && std::chrono::steady_clock::now() < deadline)
      {
        std::this_thread::sleep_for(1ms);
        MPI_Test(&everybody, &together, MPI_STATUS_IGNORE);
      }
    if (!together)
      {
        std::cerr << "whipple: rank " << rank << " alone: " << failure.message << std::endl;
        MPI_Abort(MPI_COMM_WORLD, failure.status);
      }
    if (rank == 0)
      std::cerr << "whipple: " << failure.message << std::endl;
  }
} // namespace

int
main(int argc, char **argv)
{
  std::vector<std::string> arguments(argv + 1, argv + argc);

  // what is wrong with the arguments is said once MPI is up, by one rank
  command_line::Command command;
  std::optional<int>    ended; // exit status of ranks that have done it
  Failure               failure = attempt([&] {
    command = command_line::parse(arguments);
    if (auto *run = std::get_if<command_line::Run>(&command))
      {
        choose_directory(run->options, arguments);
        if (run->ranks > 1 && !mpirun::is_rank())
          {
            ended = mpirun::run(run->ranks, arguments);
            tell_of_killed_ranks(*ended, run->options);
          }
        run->options.live = mpirun::prints_to_terminal();
      }
  });

  if (ended)
    return *ended;
  if (const auto *study = std::get_if<command_line::Study>(&command))
    return run_study_alone(study->options);

  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  MPI_Comm                                 failures;
  MPI_Comm_dup(MPI_COMM_WORLD, &failures);
  if (failure.status == done)
    failure = attempt([&] { execute(command); });
  if (failure.status != done)
    report(failure, failures);
  MPI_Comm_free(&failures);
  return failure.status;
}
