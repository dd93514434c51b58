// SPDX-License-Identifier: LGPL-2.1-or-later
// What the ledger measures an imbalance by.
#include <whipple/error.h>
#include <whipple/ledger/ledger.h>
#include <whipple/run/simulation.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace
{
  using namespace whipple;

  ConservedTotals<2>
  amounts(double mass, double internal, double kinetic)
  {
    ConservedTotals<2> totals;
    totals.mass            = mass;
    totals.internal_energy = internal;
    totals.kinetic_energy  = kinetic;
    return totals;
  }

  TEST(LedgerScale, MatterThatEntersWithoutEnergyIsMeasuredByWhatItMakes)
  {
    Ledger<2> ledger;
    ledger.introduce(amounts(1., 0., 0.));
    EXPECT_DOUBLE_EQ(ledger.energy_scale(), 1e-12); // the mass at 1 cm/s
    ledger.check(amounts(1., 0., 0.), "start", 1e-12);
    // a part in 1e15 of the energies is lost: round-off
    EXPECT_NO_THROW(ledger.check(amounts(1., -0.01, 0.01 - 1e-17), "a step", 1e-12));
    EXPECT_DOUBLE_EQ(ledger.energy_scale(), 0.01);
    // and what they were remains the scale when all is at rest again
    EXPECT_NO_THROW(ledger.check(amounts(1., 1e-17, 0.), "a later step", 1e-12));
    EXPECT_DOUBLE_EQ(ledger.energy_scale(), 0.01);
    EXPECT_NEAR(ledger.closure(amounts(1., 1e-17, 0.)).energy, 1e-15, 1e-18);
  }

  TEST(LedgerScale, EnergyOutOfNothingIsSeenHoweverLittleThereWas)
  {
    Ledger<2> ledger;
    ledger.introduce(amounts(1., 0., 0.));
    ledger.check(amounts(1., 0., 0.), "start", 1e-12);
    EXPECT_THROW(ledger.check(amounts(1., -0.01, 0.01 + 2e-14), "a step", 1e-12), ConservationError);
    EXPECT_THROW(ledger.check(amounts(1., 0., 1e9), "a step", 1e-12), ConservationError);
    EXPECT_THROW(ledger.check(amounts(1., NAN, 0.), "a step", 1e-12), ConservationError);
  }

  TEST(LedgerScale, AScaleThatGrowsMakesNoImbalanceOutOfOldRoundOff)
  {
    Ledger<2> ledger;
    ledger.introduce(amounts(1., 1e-6, 0.));
    for (int i = 1; i <= 100; ++i) // 5e-11 of the scale in all
      ledger.check(amounts(1., 1e-6 + 5e-19 * i, 0.), "a step", 1e-12);
    ledger.introduce(amounts(1., 1., 0.));
    EXPECT_NO_THROW(ledger.check(amounts(2., 1. + 1e-6 + 5e-17, 0.), "a body enters", 1e-12));
  }

  /// A square of aluminium in empty space, compressed by 7 %, at rest and without energy.
  Problem<2>
  compressed(const std::string &directory, const std::string &mode)
  {
    const std::string path = directory + "/scene.prm";
    std::ofstream(path)
        << "subsection Geometry\n set Symmetry = planar\n set Lower corner = 0 cm, 0 cm\n"
           " set Upper corner = 1 cm, 1 cm\nend\n"
           "subsection Mesh\n set Finest cell = 0.05 cm\n set Levels = 0\n set Refinement = uniform\nend\n"
           "subsection Materials\n set List = al\n subsection al\n"
           " set Library = aluminium 2024-T4\n end\nend\n"
           "subsection Bodies\n set List = piece\n subsection piece\n set Shape = box\n"
           " set Lower corner = 0.3 cm, 0.3 cm\n set Upper corner = 0.7 cm, 0.7 cm\n"
           " set Material = al\n set Density = 3 g/cm^3\n end\nend\n"
           "subsection Stages\n set List = s\n subsection s\n set Mode = "
        << mode
        << "\n set End = 0.3 us\n end\nend\n"
           "subsection Output\n set Fields interval = none\nend\n";
    return read_problem<2>(path);
  }

  TEST(LedgerScale, ABodyThatIsOnlyDenserRunsAndCloses)
  {
    const std::string directory = testing::TempDir() + "whipple_ledger_scale";
    for (const char *mode : {"eulerian", "lagrangian"})
      {
        std::filesystem::create_directories(directory);
        const Problem<2> scene = compressed(directory, mode);
        Simulation<2>    run(scene, {directory, false, MPI_Wtime()}, MPI_COMM_SELF);
        ASSERT_NO_THROW(run.run()) << mode;
        const summary::Balance energy = run.summary().ledger.energy;
        EXPECT_LT(energy.closure_relative, 1e-13) << mode;
        std::filesystem::remove_all(directory);
      }
  }
} // namespace
