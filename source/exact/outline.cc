// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/exact/outline.h>

#include <cmath>

namespace whipple::exact
{
  bool
  Outline::contains(const Vector<2> &x) const
  {
    if (inside)
      return inside(x);
    if (round)
      return std::hypot(x[0] - centre()[0], x[1] - centre()[1]) <= radius();
    return x[0] >= lower[0] && x[0] <= upper[0] && x[1] >= lower[1] && x[1] <= upper[1];
  }

  Vector<2>
  Outline::centre() const
  {
    return {{0.5 * (lower[0] + upper[0]), 0.5 * (lower[1] + upper[1])}};
  }

  double
  Outline::radius() const
  {
    return 0.5 * (upper[1] - lower[1]);
  }

  Outline
  outline(const BodyState<2> &body)
  {
    return {body.lower, body.upper, body.round, body.inside};
  }
} // namespace whipple::exact
