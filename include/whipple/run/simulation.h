// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/summary.h>
#include <whipple/run/handover.h>
#include <whipple/run/reporter.h>

#include <map>
#include <optional>
#include <string>

namespace whipple
{
  /// A run: the chain of a scene's stages from first contact to the wall, with its output directory.
  template <int dim>
  class Simulation
  {
  public:
    /// @param directory output directory, prepared
    /// @param live      refresh the progress line on the terminal in place
    Simulation(const Scene<dim> &scene, const std::string &directory, bool live, MPI_Comm communicator);

    /// Run all stages. summary.json is written in any case.
    /// @throws StateError where physics or numerics stopped the run; the last good state is on disk.
    void
    run();

    /// Add error bars to the results of a finished run: lines at the end of the log, and summary.json anew.
    void
    report_error_bars(const std::map<std::string, std::map<std::string, summary::ErrorBar>> &error_bars);

    /// Where the run stands.
    const Domain<dim> &
    domain() const
    {
      return domain_;
    }
    const Ledger<dim> &
    ledger() const
    {
      return ledger_;
    }
    const summary::Summary &
    summary() const
    {
      return summary_;
    }

  private:
    void
    run_stage(std::size_t number);
    void
    measure_plates(std::size_t stage);
    /// Mean axial velocity of the material of the bodies that came flying, cm/us; none if it cannot be told apart.
    std::optional<double>
    projectile_velocity() const;
    void
    measure_cloud(const Stage &stage, const std::string &prefix);
    /// Temperature, phases and fragments at the end of a stage, of scenes with those effects.
    void
    measure_material(const Stage &stage);
    void
    measure_errors();
    void
    write_summary();

    Scene<dim>       scene_;
    FieldLayout      layout_;
    std::string      directory_;
    Regridding<dim>  regridding_;
    Handover<dim>    handover_;
    Reporter<dim>    reporter_;
    Domain<dim>      domain_;
    Ledger<dim>      ledger_;
    summary::Summary summary_;
    double           wall_start_;
    double           cpu_start_; ///< the process may have worked before
  };
} // namespace whipple
