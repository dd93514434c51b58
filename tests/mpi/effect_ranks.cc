// SPDX-License-Identifier: LGPL-2.1-or-later
// Effects that nothing but this file knows: they register themselves, a scene lists them, and they get what an effect
// needs: its parameters, its place in the order, the halo, the old state, the books.
#include "source_directory.h"

#include <whipple/effect/effect.h>
#include <whipple/error.h>
#include <whipple/ledger/totals.h>
#include <whipple/run/cycle.h>
#include <whipple/run/handover.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  /// The same for a cell on whatever rank it is.
  double
  mark_of(const FlatMesh<2> &mesh, Index cell)
  {
    return 1. + 3. * mesh.lower[0][cell] + 7. * mesh.lower[1][cell];
  }

  /// Comes first: marks the owned cells, lets the halo bring the marks of the others, and keeps what it is given.
  class MarkerPass : public EffectPass<2>
  {
  public:
    explicit MarkerPass(const EffectSetup<2> &setup)
      : mesh_(setup.mesh)
      , mark_(setup.field("mark"))
      , old_energy_(setup.field("old energy"))
      , unlit_energy_(setup.field("unlit energy"))
    {
    }

    void
    advance(const EffectStep<2> &step) override
    {
      MaterialState       &gas  = step.state.material[0];
      std::vector<double> &mark = gas.fields[mark_].value;
      for (Index c = 0; c < mesh_.n_cells; ++c)
        mark[c] = c < mesh_.n_owned ? mark_of(mesh_, c) : -1.;
      step.halo.exchange({&mark});
      for (Index c = 0; c < mesh_.n_cells; ++c)
        if (mark[c] != mark_of(mesh_, c))
          throw StateError("the halo has the mark " + std::to_string(mark[c]));
      int ranks = 1, rank = 0;
      MPI_Comm_size(MPI_COMM_WORLD, &ranks);
      MPI_Comm_rank(MPI_COMM_WORLD, &rank);
      if (step.halo.largest(rank) != ranks - 1)
        throw StateError("not the largest of all ranks");
      gas.fields[old_energy_].value   = step.before.material[0].energy;
      gas.fields[unlit_energy_].value = gas.energy;
    }

  private:
    const FlatMesh<2> &mesh_;
    int                mark_, old_energy_, unlit_energy_;
  };

  /// Comes second, though the alphabet would have it first: adds energy and enters it.
  class LampPass : public EffectPass<2>
  {
  public:
    explicit LampPass(const EffectSetup<2> &setup)
      : mesh_(setup.mesh)
      , heat_(setup.parameter("Heat"))
      , mark_(setup.field("mark"))
    {
    }

    void
    advance(const EffectStep<2> &step) override
    {
      MaterialState     &gas = step.state.material[0];
      ConservedTotals<2> came;
      double             cells = 0;
      for (Index c = 0; c < mesh_.n_cells; ++c)
        {
          if (gas.fields[mark_].value[c] != mark_of(mesh_, c))
            throw StateError("the lamp came before the marker");
          gas.energy[c] += heat_;
          if (c < mesh_.n_owned)
            {
              came.internal_energy -= heat_ * gas.mass[c]; // what comes in has left with a minus
              ++cells;
            }
        }
      step.books.leave("lamp", came);
      step.books.convert("light", -2. * came.internal_energy);
      step.books.note("lit cells", cells, -came.internal_energy);
    }

    bool
    changes_energy() const override
    {
      return true;
    }

  private:
    const FlatMesh<2> &mesh_;
    double             heat_; ///< Mbar cm^3/g in a step
    int                mark_;
  };

  /// Fails in its first step, on the last rank, while the others want to exchange.
  class StumblingPass : public EffectPass<2>
  {
  public:
    explicit StumblingPass(const EffectSetup<2> &setup)
      : mesh_(setup.mesh)
    {
    }

    void
    advance(const EffectStep<2> &step) override
    {
      int rank = 0, ranks = 1;
      MPI_Comm_rank(MPI_COMM_WORLD, &rank);
      MPI_Comm_size(MPI_COMM_WORLD, &ranks);
      if (first_ && rank == ranks - 1)
        {
          first_ = false;
          throw StateError("stumbled on rank " + std::to_string(rank));
        }
      first_ = false;
      std::vector<double> nothing(mesh_.n_cells);
      step.halo.exchange({&nothing});
    }

  private:
    const FlatMesh<2> &mesh_;
    bool               first_ = true;
  };

  const EffectRegistration<2> marker(910,
                                     {.name          = "test z marker",
                                      .summary       = "marks cells",
                                      .documentation = "Of the tests.",
                                      .fields        = {{"mark", "1", Carrier::mass},
                                                        {"old energy", "Mbar cm^3/g", Carrier::mass},
                                                        {"unlit energy", "Mbar cm^3/g", Carrier::mass}}},
                                     [](const EffectSetup<2> &setup) { return std::make_unique<MarkerPass>(setup); });

  const EffectRegistration<2>
      lamp(920,
           {.name          = "test a lamp",
            .summary       = "adds energy",
            .documentation = "Of the tests.",
            .requires_on   = {"test z marker"},
            .parameters    = {{"Heat", "specific energy", "added in each step", Range::positive(), 1e-3},
                              {"Colour", "length", "must be given", Range::any(), {}}},
            .bookings      = {{BookingKind::leaves, "lamp", "energy of the light"},
                              {BookingKind::converts, "light", "twice that"},
                              {BookingKind::notes, "lit cells", "energy of the light", "Mbar cm^3"}}},
           [](const EffectSetup<2> &setup) { return std::make_unique<LampPass>(setup); });

  const EffectRegistration<2>
      stumbling(930, {.name = "test stumbling", .summary = "fails once", .documentation = "Of the tests."},
                [](const EffectSetup<2> &setup) { return std::make_unique<StumblingPass>(setup); });

  /// Noh's gas on a moving mesh, where the fields stay in their cells.
  Problem<2>
  scene_with(const std::string &effects, std::vector<std::string> overrides = {})
  {
    overrides.insert(overrides.begin(),
                     {"Mesh/Finest cell = 0.05 cm", "Stages/infall/Mode = lagrangian", "Effects/List = " + effects});
    return read_problem<2>(source_directory() + "/prm/verification/noh_spherical.prm", overrides);
  }

  const std::vector<std::string> green{"Effects/test a lamp/Colour = 500 um"};

  /// One step of it.
  struct Step
  {
    explicit Step(const Problem<2> &given)
      : problem(given)
      , regridding(scene, layout)
      , domain{Forest<2>(MPI_COMM_WORLD, scene.lattice), nullptr, {}}
    {
      SharedDebris<2> waiting;
      Handover<2>(problem, regridding).enter(scene.stages[0], nullptr, domain, ledger, waiting);
      cycle.emplace(scene, scene.stages[0], layout, domain.view->mesh, domain.view->halo, phases);
      cycle->refresh(domain.state, domain.derived);
      ledger.check(present(), "start", 1.);
      start = domain.state;
      dt    = 0.1 * cycle->time_step(domain.state, domain.derived, {}).dt;
    }

    void
    advance()
    {
      cycle->advance(domain.state, domain.derived, dt, 0, {}, ledger);
    }

    ConservedTotals<2>
    present() const
    {
      return totals(domain.view->mesh, domain.state, MPI_COMM_WORLD);
    }

    const std::vector<double> &
    field(const std::string &name) const
    {
      return domain.state.material[0].fields[field_index(layout.fields, name)].value;
    }

    Problem<2>              problem;
    const Scene<2>         &scene  = problem.scene;
    const FieldLayout      &layout = problem.layout;
    Regridding<2>           regridding;
    Domain<2>               domain;
    Ledger<2>               ledger;
    PhaseClock              phases;
    std::optional<Cycle<2>> cycle;
    State<2>                start;
    double                  dt = 0;
  };

  TEST(EffectRanks, AnEffectOfThisFileRunsInItsPlaceAndSeesHaloOldStateAndParameters)
  {
    std::vector<std::string> overrides = green;
    overrides.push_back("Effects/test a lamp/Heat = 1 MJ/kg");
    Step step(scene_with("test a lamp, test z marker", overrides));
    step.advance(); // throws if the order or the halo is wrong
    const MaterialState &gas  = step.domain.state.material[0];
    const double         heat = 1e-2; // 1 MJ/kg
    for (Index c = 0; c < step.domain.view->mesh.n_owned; ++c)
      {
        EXPECT_EQ(step.field("old energy")[c], step.start.material[0].energy[c]);
        EXPECT_EQ(gas.energy[c], step.field("unlit energy")[c] + heat);
      }
    EXPECT_NE(step.field("old energy"), step.field("unlit energy")); // the step has done work
    // the pressure is that of the heated gas: (gamma - 1) rho e
    for (Index c = 0; c < step.domain.view->mesh.n_cells; ++c)
      EXPECT_NEAR(step.domain.derived.material[0].pressure[c], 2. / 3. * gas.density[c] * gas.energy[c],
                  1e-12 * gas.density[c] * gas.energy[c]);
  }

  TEST(EffectRanks, BookingsReachTheLedgerFromAllRanks)
  {
    Step step(scene_with("test a lamp, test z marker", green));
    step.advance();
    const ConservedTotals<2> present  = step.present();
    const double             expected = 1e-3 * present.mass; // Mbar cm^3/g, the default
    const Bookings<2>       &booked   = step.ledger.bookings();
    EXPECT_NEAR(booked.of("lamp").left->total_energy(), -expected, 1e-13 * expected);
    EXPECT_NEAR(booked.of("light").converted.value(), 2. * expected, 1e-13 * expected);
    const Event lit = booked.of("lit cells").event.value();
    EXPECT_EQ(lit.number, 400); // 20 x 20, each counted by its owner
    EXPECT_NEAR(lit.size, expected, 1e-13 * expected);
    EXPECT_EQ(lit.unit, "Mbar cm^3");
    EXPECT_NO_THROW(step.ledger.check(present, "a lit step", 1e-14)); // energy closes with what the lamp brought
  }

  TEST(EffectRanks, AStepThatFailsLeavesNothingInTheBooksAndNoRankWaiting)
  {
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    Step        step(scene_with("test a lamp, test z marker, test stumbling", green));
    std::string said;
    try
      {
        step.advance();
      }
    catch (const StateError &error)
      {
        said = error.what();
      }
    EXPECT_EQ(said, "stumbled on rank " + std::to_string(ranks - 1));
    EXPECT_FALSE(step.ledger.bookings().of("lit cells").event);
    step.domain.state = step.start;
    step.cycle->evaluate(step.domain.state, step.domain.derived);
    step.advance();
    EXPECT_EQ(step.ledger.bookings().of("lit cells").event->number, 400); // those of one step
  }

  TEST(EffectRanks, OffItLeavesNoTrace)
  {
    const Step off(scene_with(""));
    EXPECT_TRUE(off.layout.fields.empty());
    EXPECT_EQ(off.scene.effective_parameters.find("subsection test a lamp"), std::string::npos);
    const Scene<2> on = scene_with("test a lamp, test z marker", green).scene;
    EXPECT_NE(on.effective_parameters.find("subsection test a lamp"), std::string::npos);
  }

  /// What reading a scene complains of.
  std::string
  complaint(const std::string &effects, const std::vector<std::string> &overrides)
  {
    try
      {
        scene_with(effects, overrides);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  TEST(EffectRanks, ParametersAreCheckedWithUnitAndRange)
  {
    const std::string lit = "test a lamp, test z marker", key = "Effects/test a lamp/";
    EXPECT_EQ(complaint(lit, green), "");
    EXPECT_NE(complaint(lit, {}).find(key + "Colour = '': must be given"), std::string::npos);
    EXPECT_NE(complaint(lit, {green[0], key + "Heat = -1 J/g"}).find("must be > 0"), std::string::npos);
    EXPECT_NE(complaint(lit, {green[0], key + "Heat = 1 cm"}).find("specific energy"), std::string::npos);
    EXPECT_NE(complaint(lit, {green[0], key + "Heta = 1 J/g"}).find("no such key"), std::string::npos);
    EXPECT_NE(complaint("test a lamp", green).find("means nothing without 'test z marker'"), std::string::npos);
    EXPECT_NE(complaint("", {key + "Heat = 1 cm"}).find("specific energy"), std::string::npos) << "also when it is off";
  }

  TEST(EffectRanks, AnUndeclaredBookingIsAnErrorOfTheProgram)
  {
    EffectBooks<2> books({{BookingKind::converts, "light", "energy"}});
    books.convert("light", 1.);
    EXPECT_THROW(books.convert("darkness", 1.), std::logic_error);
    EXPECT_THROW(books.note("light", 1., 1.), std::logic_error);
  }
} // namespace
