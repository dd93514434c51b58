// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/ledger/ledger.h>
#include <whipple/output/field_output.h>

#include <cstdint>
#include <map>
#include <string>

namespace whipple
{
  /// What a run has written so far, and when it writes next.
  struct ReportProgress
  {
    double                               next_fields     = 0; ///< us
    double                               next_statistics = 0; ///< us
    FieldSeries                          fields;
    std::uint64_t                        statistics_bytes = 0; ///< of statistics.csv, rows whose steps stand (rank 0)
    std::map<std::string, std::uint64_t> table_bytes;   ///< likewise of each table of a watch (diagnostics/measure.h)
    std::map<std::string, Event>         events_warned; ///< of the ledger, at the last warning
  };
} // namespace whipple
