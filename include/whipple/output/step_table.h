// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <cstdint>
#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace whipple
{
  /// One entry of a row of a table, a number or a word; the name carries the unit, "time [us]".
  struct TableEntry
  {
    std::string_view                       name;
    std::variant<double, std::string_view> value;
  };

  /// A table that grows with the steps of a run (DIR/statistics.csv and others): comma separated, the names in the
  /// first line. The first row fixes the columns. Only rank 0 writes; values are printed with all their digits, what is
  /// not finite as nan or inf. Rows wait until keep() says that their steps stand; forget() drops those whose steps
  /// were undone.
  class StepTable
  {
  public:
    /// @param kept bytes of a table begun before that stand (as kept_bytes() said); what follows them is cut off. 0: a
    ///             new table
    /// Collective.
    /// @throws InputError on all ranks if the file cannot be written, or is shorter than that.
    StepTable(const std::string &path, MPI_Comm communicator, std::uint64_t kept = 0);

    /// Append a row.
    /// @throws Error if names differ from those of the first row.
    void
    write(std::span<const TableEntry> row);

    /// The steps of all rows so far stand.
    /// @throws Error on the first rank if the disk refuses what was written; the same for flush().
    void
    keep();

    /// The steps of the rows since the last keep() were undone.
    void
    forget();

    /// Bring the rows that are kept to disk.
    void
    flush();

    /// Bytes of the table so far, rows that wait not among them (0 on ranks other than 0).
    std::uint64_t
    kept_bytes() const
    {
      return kept_;
    }

  private:
    void
    check() const;

    std::string              path_;
    bool                     active_; ///< this is rank 0
    std::ofstream            file_;
    std::ostringstream       waiting_;
    std::vector<std::string> columns_;
    std::uint64_t            kept_ = 0;
  };
} // namespace whipple
