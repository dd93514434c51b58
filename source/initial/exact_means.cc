// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/initial/exact_means.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace whipple
{
  namespace
  {
    /// Gauss-Legendre rule with four points on [0, 1] ([Abramowitz1964], table 25.4).
    constexpr int    gauss = 4;
    constexpr double outer = 0.861136311594052575224, inner = 0.339981043584856264803;
    constexpr double gauss_point[gauss] = {0.5 - 0.5 * outer, 0.5 - 0.5 * inner, 0.5 + 0.5 * inner, 0.5 + 0.5 * outer};
    constexpr double outer_weight = 0.347854845137453857373, inner_weight = 0.652145154862546142627;
    constexpr double gauss_weight[gauss] = {0.5 * outer_weight, 0.5 * inner_weight, 0.5 * inner_weight,
                                            0.5 * outer_weight};

    constexpr int panels = 4, midpoints = 16;

    /// The bilinear map of the unit square onto a cell.
    class Cell
    {
    public:
      Cell(Symmetry symmetry, const CornerVectors<2> &corner)
        : symmetry_(symmetry)
        , corner_(corner)
      {
      }

      Vector<2>
      at(double xi, double eta) const
      {
        Vector<2> x;
        for (int d = 0; d < 2; ++d)
          x[d] = (1. - eta) * ((1. - xi) * corner_[d][0] + xi * corner_[d][1]) +
                 eta * ((1. - xi) * corner_[d][2] + xi * corner_[d][3]);
        return x;
      }

      /// @param weight of the point in the unit square
      VolumePoint<2>
      point(double xi, double eta, double weight) const
      {
        std::array<Vector<2>, 2> tangent;
        for (int d = 0; d < 2; ++d)
          {
            tangent[0][d] = (1. - eta) * (corner_[d][1] - corner_[d][0]) + eta * (corner_[d][3] - corner_[d][2]);
            tangent[1][d] = (1. - xi) * (corner_[d][2] - corner_[d][0]) + xi * (corner_[d][3] - corner_[d][1]);
          }
        const Vector<2> x      = at(xi, eta);
        const double    volume = weight * (tangent[0][0] * tangent[1][1] - tangent[0][1] * tangent[1][0]);
        return {x, symmetry_ == Symmetry::planar ? volume : 2. * std::numbers::pi * x[0] * volume};
      }

    private:
      Symmetry                symmetry_;
      const CornerVectors<2> &corner_;
    };

    /// The tensor product of a rule with itself.
    template <typename Points, typename Weights>
    std::vector<VolumePoint<2>>
    tensor_points(const Cell &cell, int n, const Points &point, const Weights &weight)
    {
      std::vector<VolumePoint<2>> points;
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          points.push_back(cell.point(point(i), point(j), weight(i) * weight(j)));
      return points;
    }

    /// Breaks that may pass through a cell; edges of a cell bulge a little beyond the range of its corners.
    std::vector<double>
    breaks_in(const exact::ExactSolution<2> &solution, const CornerVectors<2> &corner, double time)
    {
      std::array<double, 4> coordinate;
      for (int k = 0; k < 4; ++k)
        {
          const auto profile = solution.profile_coordinate({{corner[0][k], corner[1][k]}});
          if (!profile)
            return {};
          coordinate[k] = *profile;
        }
      const auto [low, high]    = std::minmax_element(coordinate.begin(), coordinate.end());
      const double        slack = 0.25 * (*high - *low);
      std::vector<double> inside;
      for (const double b : solution.breaks(time))
        if (b > *low - slack && b < *high + slack)
          inside.push_back(b);
      return inside;
    }

    /// Points on lines that run along the profile, cut where they cross its breaks.
    class CutLines
    {
    public:
      CutLines(const exact::ExactSolution<2> &solution, const Cell &cell, const std::vector<double> &breaks)
        : solution_(solution)
        , cell_(cell)
        , breaks_(breaks)
        , along_(std::abs(coordinate(cell.at(1, 0.5)) - coordinate(cell.at(0, 0.5))) <
                 std::abs(coordinate(cell.at(0.5, 1)) - coordinate(cell.at(0.5, 0))))
      {
      }

      std::vector<VolumePoint<2>>
      points() const
      {
        std::vector<VolumePoint<2>> result;
        for (int p = 0; p < panels; ++p)
          for (int g = 0; g < gauss; ++g)
            {
              const double              across = (p + gauss_point[g]) / panels, weight = gauss_weight[g] / panels;
              const std::vector<double> cut = cuts(across);
              for (std::size_t i = 0; i + 1 < cut.size(); ++i)
                for (int k = 0; k < gauss; ++k)
                  {
                    const double length = cut[i + 1] - cut[i], s = cut[i] + length * gauss_point[k];
                    const double w = weight * gauss_weight[k] * length;
                    result.push_back(along_ ? cell_.point(across, s, w) : cell_.point(s, across, w));
                  }
            }
        return result;
      }

    private:
      double
      coordinate(const Vector<2> &x) const
      {
        return *solution_.profile_coordinate(x);
      }
      double
      coordinate(double across, double s) const
      {
        return coordinate(along_ ? cell_.at(across, s) : cell_.at(s, across));
      }

      /// 0, crossings of the line with the breaks, 1.
      std::vector<double>
      cuts(double across) const
      {
        std::vector<double> cut{0., 1.};
        const double        begin = coordinate(across, 0.), end = coordinate(across, 1.);
        for (const double b : breaks_)
          if ((b - begin) * (b - end) < 0)
            {
              double low = 0, high = 1;
              for (int i = 0; i < 50; ++i)
                {
                  const double middle                                               = 0.5 * (low + high);
                  ((coordinate(across, middle) - b) * (begin - b) > 0 ? low : high) = middle;
                }
              cut.push_back(0.5 * (low + high));
            }
        std::sort(cut.begin(), cut.end());
        return cut;
      }

      const exact::ExactSolution<2> &solution_;
      const Cell                    &cell_;
      const std::vector<double>     &breaks_;
      bool                           along_; ///< the lines run along the second direction of the unit square
    };

    /// Whether a solution that is no profile has material at some corners of a cell and none at others.
    bool
    edge_passes(const exact::ExactSolution<2> &solution, const CornerVectors<2> &corner, double time)
    {
      int filled = 0;
      for (int k = 0; k < 4; ++k)
        {
          const Vector<2> x{{corner[0][k], corner[1][k]}};
          if (solution.profile_coordinate(x))
            return false;
          filled += solution.at(x, time).density > 0;
        }
      return filled > 0 && filled < 4;
    }
    /// Points for a solution that is no profile and may jump anywhere: Gauss' rule, on quarters of quarters where the
    /// values at its points look like a jump.
    class JumpRefined
    {
    public:
      JumpRefined(const exact::ExactSolution<2> &solution, const Cell &cell, double time)
        : solution_(solution)
        , cell_(cell)
        , time_(time)
      {
      }

      std::vector<VolumePoint<2>>
      points() const
      {
        std::vector<VolumePoint<2>> result;
        add(0., 0., 1., deepest, result);
        return result;
      }

    private:
      static constexpr int deepest = 4;

      /// Values of one quantity on the square [xi, xi + size] x [eta, eta + size]: at Gauss' points, at its corners.
      struct Values
      {
        std::array<double, gauss * gauss> inner;
        std::array<double, 4>             corner;
      };

      /// Smooth values have a small share of the third Legendre polynomial along each line, and corners that go on
      /// from them: a jump between two points has a share of 0.37 or more of its height, one beyond the points shows at
      /// a corner.
      static bool
      looks_like_jump(const Values &values)
      {
        constexpr double part = 0.05, round_off = 1e-12;
        // (7/2) w P_3 at the points, weights w of [-1, 1]
        const auto   legendre = [](double x) { return 0.5 * x * (5. * x * x - 3.); };
        const double a = 3.5 * outer_weight * legendre(outer), b = 3.5 * inner_weight * legendre(inner);
        const auto [low, high]   = std::minmax_element(values.inner.begin(), values.inner.end());
        const auto [least, most] = std::minmax_element(values.corner.begin(), values.corner.end());
        const double range = *high - *low, noise = round_off * std::max(std::abs(*high), std::abs(*low));
        if (*low - *least > range + noise || *most - *high > range + noise)
          return true;
        for (int i = 0; i < gauss; ++i)
          for (const auto &[first, step] : {std::pair{i * gauss, 1}, std::pair{i, gauss}})
            {
              const auto value = [&, first = first, step = step](int k) { return values.inner[first + k * step]; };
              if (std::abs(a * (value(3) - value(0)) + b * (value(2) - value(1))) > part * range + noise)
                return true;
            }
        return false;
      }

      bool
      is_rough(double xi, double eta, double size) const
      {
        std::array<Values, 4> all; // density, energy, velocity
        const auto            enter = [&](const Vector<2> &x, auto place) {
          const exact::PointState<2> state = solution_.at(x, time_);
          place(all[0])                    = state.density;
          place(all[1])                    = state.energy;
          place(all[2])                    = state.velocity[0];
          place(all[3])                    = state.velocity[1];
        };
        for (int j = 0; j < gauss; ++j)
          for (int i = 0; i < gauss; ++i)
            enter(cell_.at(xi + size * gauss_point[i], eta + size * gauss_point[j]),
                  [k = j * gauss + i](Values &v) -> double & { return v.inner[k]; });
        for (int k = 0; k < 4; ++k)
          enter(cell_.at(xi + size * (k & 1), eta + size * (k >> 1)),
                [k](Values &v) -> double & { return v.corner[k]; });
        return std::any_of(all.begin(), all.end(), looks_like_jump);
      }

      void
      add(double xi, double eta, double size, int depth, std::vector<VolumePoint<2>> &result) const
      {
        if (depth > 0 && is_rough(xi, eta, size))
          {
            for (int k = 0; k < 4; ++k)
              add(xi + 0.5 * size * (k & 1), eta + 0.5 * size * (k >> 1), 0.5 * size, depth - 1, result);
            return;
          }
        for (int j = 0; j < gauss; ++j)
          for (int i = 0; i < gauss; ++i)
            result.push_back(cell_.point(xi + size * gauss_point[i], eta + size * gauss_point[j],
                                         size * gauss_weight[i] * (size * gauss_weight[j])));
      }

      const exact::ExactSolution<2> &solution_;
      const Cell                    &cell_;
      double                         time_;
    };
  } // namespace

  template <>
  std::vector<VolumePoint<2>>
  volume_points(const exact::ExactSolution<2> &solution, Symmetry symmetry, const CornerVectors<2> &corner, double time)
  {
    const Cell                cell(symmetry, corner);
    const std::vector<double> breaks = breaks_in(solution, corner, time);
    if (!breaks.empty())
      return CutLines(solution, cell, breaks).points();
    if (edge_passes(solution, corner, time))
      return tensor_points(
          cell, midpoints, [](int i) { return (i + 0.5) / midpoints; }, [](int) { return 1. / midpoints; });
    if (!solution.profile_coordinate(cell.at(0.5, 0.5)))
      return JumpRefined(solution, cell, time).points();
    return tensor_points(
        cell, gauss, [](int i) { return gauss_point[i]; }, [](int i) { return gauss_weight[i]; });
  }

  template <>
  ExactMeans<2>
  exact_means(const exact::ExactSolution<2> &solution, const std::vector<VolumePoint<2>> &points, double time)
  {
    ExactMeans<2> sum{0., 0., 0., {}};
    double        volume = 0, weight = 0;
    for (const VolumePoint<2> &point : points)
      {
        const exact::PointState<2> state = solution.at(point.x, time);
        volume += point.volume;
        if (state.density == 0)
          continue;
        // a solution may give energies without a density
        const double w = point.volume * (std::isnan(state.density) ? 1. : state.density);
        weight += w;
        sum.density += point.volume * state.density;
        sum.pressure += point.volume * state.pressure;
        sum.energy += w * state.energy;
        for (int d = 0; d < 2; ++d)
          sum.velocity[d] += w * state.velocity[d];
      }
    sum.density /= volume;
    sum.pressure /= volume;
    sum.energy /= weight;
    for (double &v : sum.velocity)
      v /= weight;
    return sum;
  }
} // namespace whipple
