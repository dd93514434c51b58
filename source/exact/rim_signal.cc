// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/exact/rim_signal.h>

#include <cmath>

namespace whipple::exact
{
  RimSignal::RimSignal(const std::function<double(double, double)> &inward, double rim, double given_start,
                       double given_step, const std::function<double(double)> &innermost)
    : start(given_start)
    , step(given_step)
  {
    if (!std::isfinite(rim))
      return;
    radius.push_back(rim);
    for (int i = 0; i < 10000 && radius.back() > innermost(start + i * step); ++i)
      {
        const double r = radius.back(), t = start + i * step;
        radius.push_back(r + step * inward(r + 0.5 * step * inward(r, t), t + 0.5 * step));
      }
  }

  bool
  RimSignal::not_yet_at(double at, double time) const
  {
    if (radius.empty())
      return true;
    const double place = std::fmax((time - start) / step, 0.);
    const auto   below = static_cast<std::size_t>(place);
    if (below + 1 >= radius.size())
      return below + 1 == radius.size() && place == below && at < radius.back();
    const double part = place - below;
    return at < (1. - part) * radius[below] + part * radius[below + 1];
  }
} // namespace whipple::exact
