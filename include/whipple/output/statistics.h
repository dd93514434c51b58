// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace whipple
{
  /// One entry of a row of the statistics table, a number or a word; the name carries the unit, "time [us]".
  struct StatisticsEntry
  {
    std::string_view                       name;
    std::variant<double, std::string_view> value;
  };

  /// DIR/statistics.csv: one row a written step, comma separated, the names in the first line. The first row
  /// fixes the columns. Only rank 0 writes; values are printed with all their digits, what is not finite as nan
  /// or inf. Rows wait until keep() says that their steps stand; forget() drops those whose steps were undone.
  class Statistics
  {
  public:
    /// @throws InputError if the file cannot be written.
    Statistics(const std::string &directory, MPI_Comm communicator);

    /// Append a row.
    /// @throws Error if names differ from those of the first row.
    void
    write(std::span<const StatisticsEntry> row);

    /// The steps of all rows so far stand.
    void
    keep();

    /// The steps of the rows since the last keep() were undone.
    void
    forget();

    /// Bring all rows to disk.
    void
    flush();

  private:
    bool                     active_; ///< this is rank 0
    std::ofstream            file_;
    std::ostringstream       waiting_;
    std::vector<std::string> columns_;
  };
} // namespace whipple
