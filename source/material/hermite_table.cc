// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/hermite_table.h>

#include <algorithm>

namespace whipple
{
  HermiteTable::HermiteTable(double first, double step, std::vector<double> values)
    : first_(first)
    , step_(step)
  {
    const std::size_t n = values.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        // Five nodes about i, all on one side near the ends: derivative of the polynomial through them.
        const std::size_t       from    = std::clamp<std::size_t>(i, 2, n - 3) - 2;
        static constexpr double w[5][5] = {{-25., 48., -36., 16., -3.},
                                           {-3., -10., 18., -6., 1.},
                                           {1., -8., 0., 8., -1.},
                                           {-1., 6., -18., 10., 3.},
                                           {3., -16., 36., -48., 25.}};
        double                  slope   = 0.;
        for (std::size_t k = 0; k < 5; ++k)
          slope += w[i - from][k] * values[from + k];
        nodes_.push_back({values[i], slope / (12. * step)});
      }
  }
} // namespace whipple
