// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

#include <functional>

namespace whipple::exact
{
  /// Where a body is: all of a box, the ball in it, or what a function says.
  struct Outline
  {
    Vector<2>                              lower{}, upper{}; ///< cm
    bool                                   round = false;
    std::function<bool(const Vector<2> &)> inside; ///< of another shape; else empty

    bool
    contains(const Vector<2> &x) const;

    /// cm
    Vector<2>
    centre() const;

    /// Half the height along axis 1, cm.
    double
    radius() const;
  };

  Outline
  outline(const BodyState<2> &body);
} // namespace whipple::exact
