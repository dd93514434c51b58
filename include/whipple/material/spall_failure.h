// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/failure_model.h>

namespace whipple
{
  /// Material whose voids have opened has failed: D = 1 once phi exceeds a small threshold, and stays 1 when the voids
  /// have closed again. The void law's own threshold would be back then. doc/theory/failure.md.
  class SpallFailure : public FailureModel
  {
  public:
    /// @param void_fraction  phi beyond which the material counts as broken, 0 <= phi < 1
    /// @throws InputError for phi out of its range.
    explicit SpallFailure(double void_fraction);

    void
    advance(const FailureInput &state, std::span<double> damage) const override;
    bool
    needs_voids() const override;
    std::string
    name() const override;

  private:
    double void_fraction_;
  };
} // namespace whipple
