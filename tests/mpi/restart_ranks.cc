// SPDX-License-Identifier: LGPL-2.1-or-later
// A chain that is stopped at any moment, by a signal to one rank, and goes on on another number of ranks ends with the
// bits of the chain that was not.
#include "source_directory.h"

#include <whipple/output/checksum.h>
#include <whipple/run/books_cbor.h>
#include <whipple/run/resume.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace
{
  using namespace whipple;

  const std::vector<std::string> small{"Mesh/Finest cell = 0.064 cm", "Output/Fields interval = none"};

  /// In the way of sphere and cloud, riding in the sphere, and on the rear face of the wall.
  const std::vector<std::string> gauges{"Gauges/List = way, rider, wall",
                                        "Gauges/way/Point = 0.03 cm, 2 cm",
                                        "Gauges/rider/Kind = material",
                                        "Gauges/rider/Point = 0.03 cm, -0.2 cm",
                                        "Gauges/rider/Fields = aluminium energy, velocity, pressure",
                                        "Gauges/rider/Interval = 0.1 us",
                                        "Gauges/wall/Kind = surface velocity",
                                        "Gauges/wall/Body = wall"};

  Problem<2>
  shield(const std::string &cohesion)
  {
    std::vector<std::string> overrides = small;
    const bool               streams   = cohesion == "streaming";
    overrides.push_back("Stages/debris/Cohesion = " + (streams ? "fragments" : cohesion));
    if (streams) // some of the debris in pieces, all of it on its way when the wall enters
      overrides.insert(overrides.end(),
                       {"Stages/wall/Hand-over = as it arrives", "Stages/wall/Representation = fragments",
                        "Stages/wall/Fragment size = 0.2 cm", "Stages/wall/End = for 4 us"});
    overrides.insert(overrides.end(), gauges.begin(), gauges.end());
    if (cohesion == "graded")
      overrides.insert(overrides.end(),
                       {"Effects/List = strength, voids, failure, body tags", "Materials/aluminium/Failure = spall"});
    return read_problem<2>(source_directory() + "/prm/whipple_shield.prm", overrides);
  }

  /// What a finished run is, in bits: checksums of mesh and fields, and the books but for times of the clock.
  struct Ended
  {
    std::string                                                   datasets;
    std::map<std::string, std::map<std::string, summary::Result>> results;
    std::vector<long>                                             counts;
    std::string                                                   statistics; ///< up to the masses and energies
    std::string                                                   gauges;
  };

  bool
  operator==(const Ended &a, const Ended &b)
  {
    return a.datasets == b.datasets && a.results == b.results && a.counts == b.counts && a.statistics == b.statistics &&
           a.gauges == b.gauges;
  }

  std::string
  read(const std::filesystem::path &path)
  {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  Ended
  ended(const Simulation<2> &simulation, const std::string &directory)
  {
    Ended             result;
    const std::string newest   = CheckpointStore<2>::newest(directory, MPI_COMM_SELF).directory + "/contents.json";
    const std::string contents = read(newest);
    result.datasets            = contents.substr(contents.find("\"datasets\""), 80);
    result.results             = simulation.summary().results;
    for (const summary::Stage &stage : simulation.summary().stages)
      result.counts.push_back(stage.steps);
    const summary::Counts &counts = simulation.summary().counts;
    for (const long count : {counts.retries, counts.releases, counts.breaks, counts.rezones})
      result.counts.push_back(count);
    std::istringstream table(read(directory + "/statistics.csv"));
    for (std::string line; std::getline(table, line);)
      {
        constexpr int      columns = 9; // those that are the same on any number of ranks
        std::istringstream cells(line);
        std::string        cell;
        for (int i = 0; i < columns && std::getline(cells, cell, ','); ++i)
          result.statistics += cell + ',';
        result.statistics += '\n';
      }
    for (const std::string name : {"way", "rider", "wall"})
      result.gauges += read(directory + "/gauges/" + name + ".csv");
    EXPECT_GT(result.gauges.size(), 1000u);
    return result;
  }

  int
  rank_of(MPI_Comm communicator)
  {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    return rank;
  }

  /// The first `ranks` ranks of the program; null on the others.
  MPI_Comm
  some(int ranks)
  {
    MPI_Comm part;
    MPI_Comm_split(MPI_COMM_WORLD, rank_of(MPI_COMM_WORLD) < ranks ? 0 : MPI_UNDEFINED, 0, &part);
    return part;
  }

  /// Run a chain, and have it stopped by a signal to the first rank after that many seconds.
  void
  run_until(const Problem<2> &scene, const std::string &directory, double seconds, MPI_Comm communicator)
  {
    const auto  simulation = start(scene, {directory}, EarlierRun::replaced, communicator);
    std::thread alarm;
    if (rank_of(communicator) == 0)
      alarm = std::thread([&] {
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        raise(SIGUSR2);
      });
    try
      {
        simulation->run(); // or it was faster
      }
    catch (const Interrupted &)
      {
        EXPECT_EQ(simulation->summary().status, "stopped");
        EXPECT_TRUE(simulation->summary().resumable);
      }
    if (alarm.joinable())
      alarm.join();
  }

  void
  expect_same_bits(const std::string &cohesion)
  {
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const Problem<2>  scene  = shield(cohesion);
    const std::string folder = "restart_output_" + std::to_string(ranks) + "/" + cohesion;
    if (rank_of(MPI_COMM_WORLD) == 0)
      std::filesystem::create_directories(folder);
    MPI_Barrier(MPI_COMM_WORLD);

    const double begin = MPI_Wtime();
    const auto   whole = start(scene, {folder + "/whole"}, EarlierRun::replaced, MPI_COMM_WORLD);
    whole->run();
    double duration = MPI_Wtime() - begin;
    MPI_Bcast(&duration, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);

    // before and after: 1 -> 1; on two ranks 1 -> 2; on three 3 -> 2 and 1 -> 3
    std::vector<std::pair<int, int>> partitions{{1, ranks}};
    if (ranks > 2)
      partitions.emplace_back(ranks, ranks - 1);
    for (const auto &[before, after] : partitions)
      for (const double share : {0.15, 0.5, 0.85})
        {
          const std::string directory = folder + "/from_" + std::to_string(before);
          MPI_Comm          first = some(before), second = some(after);
          if (first != MPI_COMM_NULL)
            run_until(scene, directory, share * duration, first);
          MPI_Barrier(MPI_COMM_WORLD);
          if (second != MPI_COMM_NULL)
            {
              const auto resumed = go_on(scene, {directory}, second);
              resumed->run();
              EXPECT_EQ(resumed->summary().status, "completed");
              if (rank_of(second) == 0)
                {
                  EXPECT_TRUE(ended(*resumed, directory) == ended(*whole, folder + "/whole"))
                      << cohesion << ", " << before << " -> " << after << " ranks, stopped after " << share * duration
                      << " s";
                }
            }
          MPI_Barrier(MPI_COMM_WORLD);
          for (MPI_Comm *part : {&first, &second})
            if (*part != MPI_COMM_NULL)
              MPI_Comm_free(part);
        }
  }

  TEST(Restart, ChainOfFragmentsHasTheSameBits)
  {
    expect_same_bits("fragments");
  }
  TEST(Restart, ChainWithDebrisOnItsWayHasTheSameBits)
  {
    expect_same_bits("streaming");
  }
  TEST(Restart, ChainOfBondedElementsHasTheSameBits)
  {
    expect_same_bits("bonded");
  }
  TEST(Restart, ChainOfGradedElementsHasTheSameBits)
  {
    expect_same_bits("graded");
  }

  /// A failed step goes back and is made again in smaller ones; going back leaves nothing of what failed.
  TEST(Restart, RetriesSucceedAndAreCounted)
  {
    for (const std::string stage : {"perforation", "debris"})
      {
        std::vector<std::string> overrides = small;
        overrides.insert(overrides.end(), {"Numerics/Inject failure at step = 17", "Numerics/Injected failures = 2"});
        const Problem<2> scene = read_problem<2>(source_directory() + "/prm/whipple_shield.prm", overrides);
        int              ranks = 1;
        MPI_Comm_size(MPI_COMM_WORLD, &ranks);
        const auto simulation = start(scene, {"restart_output_" + std::to_string(ranks) + "_retries"},
                                      EarlierRun::replaced, MPI_COMM_WORLD);
        simulation->run();
        EXPECT_EQ(simulation->summary().status, "completed");
        EXPECT_EQ(simulation->summary().counts.retries, 2 * 3); // in each stage
      }
  }

  /// A parameter that a run must keep is named; what may change is taken.
  TEST(Restart, ChangedScenesAreRefused)
  {
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const std::string directory = "restart_output_" + std::to_string(ranks) + "_changed";
    const auto        read      = [](std::vector<std::string> more) {
      more.insert(more.begin(), small.begin(), small.end());
      return read_problem<2>(source_directory() + "/prm/whipple_shield.prm", more);
    };
    run_until(read({}), directory, 0., MPI_COMM_WORLD);
    for (const char *change : {"Numerics/Courant number = 0.3", "Bodies/sphere/Velocity = 0 km/s, 6 km/s",
                               "Stages/perforation/End = 1.4 us", "Mesh/Finest cell = 0.032 cm"})
      EXPECT_THROW(go_on(read({change}), {directory}, MPI_COMM_WORLD), InputError) << change;
    const auto resumed =
        go_on(read({"Output/Statistics interval = 1 us", "Stages/wall/End = for 0.1 us"}), {directory}, MPI_COMM_WORLD);
    resumed->run();
    EXPECT_EQ(resumed->summary().status, "completed");
  }
} // namespace
