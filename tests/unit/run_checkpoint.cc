// SPDX-License-Identifier: LGPL-2.1-or-later
// Checkpoints: books keep all their bits, a damaged directory is told from a sound one, the older one is taken then.
#include "source_directory.h"

#include <whipple/output/checksum.h>
#include <whipple/run/books_cbor.h>
#include <whipple/run/resume.h>

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>

namespace
{
  using namespace whipple;
  namespace fs = std::filesystem;

  TEST(Checksum, IsThatOfZlibAndIndependentOfParts)
  {
    const std::string text = "123456789";
    EXPECT_EQ(checksum::text(checksum::of(std::as_bytes(std::span<const char>(text)))), "cbf43926"); // the check value
    EXPECT_EQ(checksum::of_all_ranks(std::as_bytes(std::span<const char>(text)), MPI_COMM_SELF),
              checksum::of(std::as_bytes(std::span<const char>(text))));
  }

  /// Numbers that a text of few digits would lose.
  TEST(RunBooks, KeepAllTheirBits)
  {
    RunBooks<2> books;
    books.stage                       = 3;
    books.progress.begun              = true;
    books.progress.memory_of_end      = {1. / 3., 0x1p-1060};
    books.progress.last_time_step     = 0x1.fffffffffffffp-7;
    books.progress.ceiling            = HUGE_VAL;
    books.progress.failed_until       = -HUGE_VAL;
    books.progress.retries            = 4;
    books.progress.since_regrid       = 7;
    books.progress.spare_after_regrid = 0.1;
    books.progress.locked             = {0xfedcba9876543210u, 1};
    books.progress.locked_noted       = 1;
    books.progress.history            = TimeStepHistory({0.1, 0x1p-1074, 3.});
    books.progress.contacts           = ContactSchedule(123456789012345, 0.1);
    ConservedTotals<2> amount;
    amount.mass            = 0.1;
    amount.momentum        = {{-0.3, 1e-310}};
    amount.internal_energy = 1e300;
    amount.kinetic_energy  = 2. / 7.;
    books.ledger.introduce(amount);
    books.ledger.enter("not debris", {.dropped = amount});
    books.ledger.enter("remap", {.converted = 1. / 49.});
    books.ledger.note("squeezed", 3., 1e-17, "cm^3");
    books.summary.scene = "x.prm";
    summary::Stage stage;
    stage.name                        = "wall";
    stage.start_us                    = 0.3;
    stage.finest_equivalent_cells     = 12;
    stage.dt_limits["sound"]          = 9;
    books.summary.stages              = {stage};
    books.summary.results["wall"]     = {{"hole", 0.1},
                                         {"perforated", true},
                                         {"word", std::string("w")},
                                         {"list", std::vector<double>{1. / 3., 0x1p-1060}},
                                         {"none", {}}};
    books.summary.counts.breaks       = 11;
    books.summary.counts.events["e"]  = {1., 0.7, "g"};
    books.summary.performance.cpu_s   = 0.7;
    books.report.next_fields          = 0.3;
    books.report.fields               = {{"<Grid/>", "<Grid>\n</Grid>"}, {0.1, 1. / 3.}, "wall", 1. / 3.};
    books.report.statistics_bytes     = 1u << 31;
    books.report.events_warned["e"]   = {1., 0.7, "g"};
    books.report.table_bytes["a.csv"] = 77;
    books.watches["gauges"]           = {1. / 3., NAN, -1.};

    books.progress.next_arrivals = 1. / 3.;
    Waiting<2> part;
    part.element.key            = 0xfedcba9876543210u;
    part.element.piece          = 5;
    part.element.solid_within   = 0.02;
    part.element.position[1][2] = 1. / 7.;
    part.element.corner_mass[3] = 0x1p-1060;
    part.element.packet         = {0.1, 1e300};
    part.since                  = 0.7;
    part.centre                 = {{0.1, -0.3}};
    part.reach                  = 0.03;
    books.waiting               = std::make_shared<const WaitingDebris<2>>(WaitingDebris<2>{{part}, amount, 0.6});

    const auto bytes = to_cbor(books);
    const auto again = books_from_cbor(bytes);
    EXPECT_EQ(to_cbor(again), bytes);
    EXPECT_EQ(again.waiting->parts[0].element.solid_within, 0.02);
    EXPECT_EQ(again.waiting->parts[0].reach, 0.03);
    EXPECT_EQ(again.progress.locked, books.progress.locked);
    EXPECT_EQ(again.progress.locked_noted, 1u);
    EXPECT_EQ(again.progress.memory_of_end, books.progress.memory_of_end);
    EXPECT_EQ(again.progress.ceiling, HUGE_VAL);
    EXPECT_EQ(again.progress.history.steps(), books.progress.history.steps());
    EXPECT_EQ(again.ledger.introduced().momentum[1], 1e-310);
    EXPECT_EQ(again.ledger.bookings().of("not debris").dropped.value().kinetic_energy, 2. / 7.);
    EXPECT_EQ(again.summary.results, books.summary.results);
    EXPECT_EQ(again.summary.stages[0].finest_equivalent_cells, std::optional<long>(12));
    EXPECT_FALSE(again.summary.stages[0].elements);
    EXPECT_EQ(again.report.table_bytes, books.report.table_bytes);
    ASSERT_TRUE(again.waiting);
    EXPECT_EQ(again.progress.next_arrivals, 1. / 3.);
    EXPECT_EQ(again.waiting->parts[0].element.key, part.element.key);
    EXPECT_EQ(again.waiting->parts[0].element.position, part.element.position);
    EXPECT_EQ(again.waiting->parts[0].element.corner_mass, part.element.corner_mass);
    EXPECT_EQ(again.waiting->parts[0].element.packet, part.element.packet);
    EXPECT_EQ(again.waiting->parts[0].centre, part.centre);
    EXPECT_EQ(again.waiting->totals.momentum, amount.momentum);
    EXPECT_EQ(again.watches.at("gauges")[0], 1. / 3.);
    EXPECT_TRUE(std::isnan(again.watches.at("gauges")[1]));
    EXPECT_THROW(books_from_cbor({bytes.begin(), bytes.end() - 9}), StateError);
  }

  Problem<2>
  scene()
  {
    return read_problem<2>(source_directory() + "/prm/whipple_shield.prm",
                           {"Mesh/Finest cell = 0.064 cm", "Output/Fields interval = none",
                            "Stages/List = perforation, debris", "Stages/perforation/End = 0.2 us",
                            "Stages/debris/End = for 0.2 us"});
  }

  /// A run of two stages with its two checkpoints, in a folder of its own.
  std::string
  finished(const std::string &name)
  {
    const std::string directory = "checkpoint_output/" + name;
    fs::create_directories("checkpoint_output");
    start(scene(), {directory}, EarlierRun::replaced, MPI_COMM_SELF)->run();
    return directory;
  }

  std::string
  last_lines(const std::string &directory)
  {
    std::ifstream file(directory + "/log.txt");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TEST(Checkpoint, TheLastTwoAreKept)
  {
    const std::string directory = finished("kept");
    EXPECT_TRUE(fs::exists(directory + "/checkpoints/000000/contents.json"));
    EXPECT_TRUE(fs::exists(directory + "/checkpoints/000001/state.h5"));
    go_on(scene(), {directory}, MPI_COMM_SELF)->run(); // nothing is left to do
    EXPECT_EQ(CheckpointStore<2>::newest(directory, MPI_COMM_SELF).directory, directory + "/checkpoints/000001");
  }

  TEST(Checkpoint, DamagedOnesAreNamedAndTheOlderIsTaken)
  {
    const std::string newest = "/checkpoints/000001/";
    int               number = 0;
    for (const std::string file : {"state.h5", "books.cbor", "parameters.prm", "contents.json"})
      for (const bool cut : {true, false})
        {
          const std::string directory = finished("damaged_" + std::to_string(number++));
          const fs::path    path      = directory + newest + file;
          if (cut)
            fs::resize_file(path, fs::file_size(path) / 2);
          else
            {
              std::fstream bytes(path, std::ios::in | std::ios::out | std::ios::binary);
              bytes.seekg(static_cast<std::streamoff>(fs::file_size(path) / 2));
              const char byte = static_cast<char>(bytes.peek() ^ 4);
              bytes.seekp(bytes.tellg());
              bytes.put(byte);
            }
          const auto resumed = go_on(scene(), {directory}, MPI_COMM_SELF);
          EXPECT_LT(resumed->domain().state.time, 0.3) << file; // the end of the first stage
          resumed->run();
          EXPECT_EQ(resumed->summary().status, "completed");
          EXPECT_NE(last_lines(directory).find("000001 is damaged"), std::string::npos) << file;
        }
    const std::string directory = finished("gone");
    for (const char *name : {"000000", "000001"})
      fs::remove(directory + "/checkpoints/" + name + "/books.cbor");
    EXPECT_THROW(go_on(scene(), {directory}, MPI_COMM_SELF), InputError);
  }

  TEST(Checkpoint, ThoseOfOtherVersionsAreRefusedByName)
  {
    const std::string directory = finished("version");
    for (const char *name : {"000000", "000001"})
      {
        const fs::path path = directory + "/checkpoints/" + name + "/contents.json";
        std::string    text;
        {
          std::ifstream file(path);
          text.assign(std::istreambuf_iterator<char>(file), {});
        }
        const auto at = text.find("\"program\": \"0.1.0\"");
        ASSERT_NE(at, std::string::npos);
        text.replace(at, 18, "\"program\": \"0.0.7\"");
        std::ofstream(path) << text;
      }
    try
      {
        go_on(scene(), {directory}, MPI_COMM_SELF);
        FAIL();
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("0.0.7"), std::string::npos) << error.what();
      }
  }
} // namespace
