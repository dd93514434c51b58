// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// What DIR/summary.json says, as plain structs; each key is documented in doc/summary.md. Numbers that are not
/// finite, and optionals without a value, become null.
namespace whipple::summary
{
  using Number = std::optional<double>;

  /// One stage of the chain.
  struct Stage
  {
    std::string                 name;
    std::string                 mode; ///< "eulerian" or "lagrangian"
    double                      start_us         = 0;
    double                      end_us           = 0;
    long                        steps            = 0;
    long                        active_cells_max = 0;
    std::optional<long>         finest_equivalent_cells; ///< cells of a uniform mesh of the finest size
    std::optional<long>         elements;                ///< Lagrangian stages only
    double                      dropped_mass_g = 0;      ///< at its hand-over and in it
    double                      wall_s         = 0;
    double                      cpu_s          = 0; ///< of all ranks
    double                      cell_steps     = 0;
    Number                      cell_steps_per_s_per_rank;
    std::map<std::string, long> dt_limits; ///< reason -> number of steps
  };

  /// Balance of one conserved quantity over the whole run.
  struct Balance
  {
    double                        initial     = 0;
    double                        final_value = 0; ///< written as "final"
    double                        left_domain = 0;
    std::map<std::string, double> dropped;          ///< by what
    Number                        closure_relative; ///< |final + left + dropped - initial| / scale
    std::map<std::string, double> extra;            ///< energy: kinetic, internal, remap_loss, plastic_work ...
  };

  struct Ledger
  {
    Balance                                              mass;           ///< mass_g
    Balance                                              axial_momentum; ///< axial_momentum_g_cm_per_us
    Balance                                              energy;         ///< energy_Mbar_cm3
    std::map<std::string, std::map<std::string, double>> bodies;         ///< body -> quantity with unit -> value
  };

  /// One measured result: a number, a verdict, a list of numbers (edges and contents of bins); null where it does not
  /// apply.
  using Result = std::variant<std::monostate, double, bool, std::string, std::vector<double>>;

  struct Error
  {
    Number l1{}, l2{}, linf{};
    Number scale{}; ///< mean size of the exact solution
  };

  /// How far a result may be from its limit on ever finer cells.
  struct ErrorBar
  {
    Number      error;        ///< in the unit of the result
    Number      order;        ///< observed
    Number      extrapolated; ///< estimate of the limit
    std::string verdict;      ///< "monotone", "oscillating" ...
  };

  struct Effect
  {
    bool        on = false;
    Number      number;
    std::string reason;
  };

  struct Performance
  {
    double wall_s            = 0;
    double cpu_s             = 0; ///< of all ranks
    double peak_rss_bytes    = 0; ///< of all ranks
    int    ranks             = 1;
    double active_cell_steps = 0;

    std::map<std::string, double> phases; ///< wall seconds of the first rank by what it did
  };

  /// Something the scheme had to do to go on: how often, and how much in all.
  struct Event
  {
    double      number = 0;
    double      size   = 0;
    std::string unit; ///< of size
  };

  struct Counts
  {
    long retries  = 0;
    long releases = 0;
    long breaks   = 0;
    long rezones  = 0;
    long warnings = 0;

    std::map<std::string, Event> events; ///< by what: nothing that is counted is invisible
  };

  struct Summary
  {
    std::string                                            scene;
    std::string                                            status = "completed"; ///< or "stopped"
    std::optional<std::string>                             reason; ///< why it stopped, or ended before its last stage
    bool                                                   resumable = false; ///< it was asked to, and can go on
    std::vector<Stage>                                     stages;
    Ledger                                                 ledger;
    std::map<std::string, std::map<std::string, Result>>   results;    ///< plate, gap or wall -> quantity -> value
    std::map<std::string, std::map<std::string, ErrorBar>> error_bars; ///< as results; empty if none were asked for
    std::map<std::string, Error>                           errors;     ///< field -> norms; empty without exact solution
    Performance                                            performance;
    std::map<std::string, Effect>                          effects;
    Counts                                                 counts;
  };

  /// The summary as JSON text.
  std::string
  to_json(const Summary &summary);

  /// Write directory/summary.json in one piece (temporary file, then rename). Call on one rank.
  /// @throws std::runtime_error if the disk refuses.
  void
  write(const Summary &summary, const std::string &directory);
} // namespace whipple::summary
