// SPDX-License-Identifier: LGPL-2.1-or-later
// What each effect costs a cycle, alone and together, on both kinds of mesh.
#include "memory_use.h"
#include "shocked_block.h"

#include <whipple/effect/effect.h>

#include <benchmark/benchmark.h>
#include <deal.II/base/mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace
{
  using namespace whipple;
  using bench::ShockedBlock;

  using EffectList = std::vector<std::string>;

  /// "failure" and "fragment size" mean nothing without "voids"; melting shows where there is strength to soften.
  const std::vector<EffectList> effect_lists{
      {},
      {"strength"},
      {"voids"},
      {"body tags"},
      {"melting"},
      {"heat conduction"},
      {"strength", "melting"},
      {"voids", "failure"},
      {"voids", "fragment size"},
      {"strength", "voids", "body tags"},
      {"strength", "voids", "body tags", "melting", "failure", "fragment size", "heat conduction"},
  };

  std::string
  joined(const EffectList &effects)
  {
    std::string text;
    for (const std::string &effect : effects)
      text += (text.empty() ? "" : ", ") + effect;
    return text.empty() ? "none" : text;
  }

  /// Effects that this program has.
  EffectList
  there()
  {
    EffectList names;
    for (const EffectDescription &effect : effect_descriptions())
      names.push_back(effect.name);
    return names;
  }

  void
  step_block(benchmark::State &timer, const ShockedBlock &block)
  {
    const std::size_t before = bench::bytes_in_use();
    bench::CycleRun   run    = block.resume();
    for ([[maybe_unused]] auto step : timer)
      run.step();
    const double cells = block.n_cells(), bytes = static_cast<double>(bench::bytes_in_use() - before);

    timer.counters["time_per_cell_step_s"] = {cells, benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert};
    timer.counters["bytes_per_cell"]       = bytes / cells;
    timer.counters["fields"]               = static_cast<double>(block.n_fields());
    timer.counters["cells"]                = cells;
    timer.counters["filled_cells"]         = block.n_filled();
  }

  /// Repetitions share one block, which is brought to its state by the first.
  void
  register_benchmark(const std::string &mode, int steps, const EffectList &effects)
  {
    const auto block = std::make_shared<std::unique_ptr<ShockedBlock>>();
    benchmark::RegisterBenchmark((mode + "/" + joined(effects)).c_str(),
                                 [mode, effects, block](benchmark::State &timer) {
                                   if (!*block)
                                     *block = std::make_unique<ShockedBlock>(mode, effects);
                                   step_block(timer, **block);
                                 })
        ->Iterations(steps)
        ->Unit(benchmark::kMillisecond);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::AddCustomContext("effects", joined(there()));
  for (const EffectList &effects : effect_lists)
    if (bench::has_effects(effects))
      {
        // about the same time for both modes; short, so that many repetitions find quiet moments of the machine
        register_benchmark("eulerian", 4, effects);
        register_benchmark("lagrangian", 20, effects);
      }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::ClearRegisteredBenchmarks(); // the blocks' forests must go before MPI
  return 0;
}
