// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shocked_block.h"

#include <whipple/effect/effect.h>
#include <whipple/run/handover.h>

#include <algorithm>
#include <utility>

namespace whipple::bench
{
  namespace
  {
    /// One model for each effect that needs one.
    constexpr std::pair<const char *, const char *> models[] = {
        {"strength", "Strength = perfectly plastic"},
        {"voids", "Void law = rate"},
        {"voids", "Alpha = 1e5 us/cm^2"},
        {"voids", "Spall strength = 1.2 GPa"},
        {"melting", "Thermal model = constant specific heat"},
        {"failure", "Failure = spall"},
        {"fragment size", "Fragments = grady-kipp"},
        {"heat conduction", "Conduction = constant conductivity"},
    };

    Problem<2>
    read(const std::string &mode, const std::vector<std::string> &effects)
    {
      std::string list;
      for (const std::string &effect : effects)
        list += (list.empty() ? "" : ", ") + effect;
      std::vector<std::string> overrides{"Stages/block/Mode = " + mode, "Effects/List = " + list};
      for (const auto &[effect, model] : models)
        if (has_effects({effect}))
          overrides.push_back(std::string("Materials/aluminium/") + model);
      return read_problem<2>(WHIPPLE_BENCHMARK_SCENE, overrides);
    }
  } // namespace

  bool
  has_effects(const std::vector<std::string> &effects)
  {
    return std::all_of(effects.begin(), effects.end(), [](const std::string &effect) {
      return StepOptionRegistry::all().contains(effect) || EffectRegistry<2>::find(effect);
    });
  }

  CycleRun::CycleRun(const Problem<2> &problem, const FlatPartition<2> &view, State<2> state)
    : scene_(problem.scene)
    , state_(std::move(state))
    , cycle_(scene_, scene_.stages[0], problem.layout, view.mesh, view.halo, *phases_)
  {
    cycle_.refresh(state_, derived_);
  }

  void
  CycleRun::step()
  {
    double dt = cycle_.time_step(state_, derived_, {}).dt;
    if (last_dt_ > 0)
      dt = std::min(dt, scene_.numerics.growth_limit * last_dt_);
    cycle_.advance(state_, derived_, dt, steps_ % 2, {}, ledger_);
    last_dt_ = dt;
    ++steps_;
  }

  ShockedBlock::ShockedBlock(const std::string &mode, const std::vector<std::string> &effects)
    : problem_(read(mode, effects))
    , domain_{Forest<2>(MPI_COMM_SELF, problem_.scene.lattice), nullptr, {}}
  {
    const Stage        &stage = problem_.scene.stages[0];
    const Regridding<2> regridding(problem_.scene, problem_.layout);
    Ledger<2>           ledger;
    Handover<2>(problem_, regridding).enter(stage, nullptr, domain_, ledger);
    CycleRun     run(problem_, *domain_.view, std::move(domain_.state));
    const double end = stage.end->fixed_time().value();
    while (run.state().time < end)
      run.step();
    domain_.state = run.state();
  }

  CycleRun
  ShockedBlock::resume() const
  {
    return CycleRun(problem_, *domain_.view, domain_.state);
  }

  Index
  ShockedBlock::n_filled() const
  {
    const std::vector<double> &mass = domain_.state.material[0].mass;
    return static_cast<Index>(std::count_if(mass.begin(), mass.end(), [](double m) { return m > 0; }));
  }
} // namespace whipple::bench
