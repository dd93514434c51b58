// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/run/checkpoint.h>

#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// The checkpoints of a run, DIR/checkpoints/000007 ...: numbered as they are written, the last two are kept.
  template <int dim>
  class CheckpointStore
  {
  public:
    /// @param directory of the run
    CheckpointStore(const std::string &directory, const FieldLayout &layout, const std::string &parameters,
                    MPI_Comm communicator);

    /// Write the next one. Collective. @returns its directory
    /// @throws checkpoint::Unusable on all ranks if the disk refuses; those there are stay
    std::string
    write(const LastGood<dim> &state);

    /// Wall time of the slowest write so far, s.
    double
    slowest_write() const
    {
      return slowest_;
    }

    /// A checkpoint that is sound, and what is wrong with newer ones.
    struct Found
    {
      std::string                            directory;
      std::optional<checkpoint::Header<dim>> header; ///< none: there is no sound one
      std::vector<std::string>               refused;
    };

    /// The newest sound one in a run's directory. Collective.
    static Found
    newest(const std::string &directory, MPI_Comm communicator);

  private:
    std::string        directory_; ///< of all checkpoints
    const FieldLayout &layout_;
    std::string        parameters_;
    MPI_Comm           communicator_;
    int                next_    = 0;
    double             slowest_ = 0; ///< s
  };
} // namespace whipple
