// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/shock_measure.h>
#include <whipple/mesh/cell_corners.h>
#include <whipple/mesh/gather.h>
#include <whipple/state/corner_velocity.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace whipple
{
  namespace
  {
    struct Ray
    {
      Vector<2> origin, direction;
    };

    /// Part of the domain by which rays near its sides keep off them: they must not run along cell edges.
    constexpr double aside = 1e-4;

    /// Rays for a profile with that coordinate, found by trying where it changes.
    std::array<Ray, 3>
    make_rays(const exact::ExactSolution<2> &solution, const Vector<2> &lower, const Vector<2> &upper)
    {
      std::array<Ray, 3> rays;
      const Vector<2>    size{{upper[0] - lower[0], upper[1] - lower[1]}};
      const auto         at = [&](double a, double b) {
        return *solution.profile_coordinate({{lower[0] + a * size[0], lower[1] + b * size[1]}});
      };
      const bool changes[2] = {at(0.25, 0.5) != at(0.75, 0.5), at(0.5, 0.25) != at(0.5, 0.75)};
      for (int i = 0; i < 3; ++i)
        {
          const double part = i == 0 ? aside : 0.5 * i - aside;
          if (changes[0] && changes[1])
            {
              const double angle = 0.5 * std::numbers::pi * part;
              rays[i]            = {{{0., 0.}}, {{std::sin(angle), std::cos(angle)}}};
              continue;
            }
          const int along              = changes[1] ? 1 : 0;
          rays[i].origin[along]        = lower[along];
          rays[i].origin[1 - along]    = lower[1 - along] + part * size[1 - along];
          rays[i].direction[along]     = 1.;
          rays[i].direction[1 - along] = 0.;
        }
      return rays;
    }

    /// Whether the ray meets the cell: corners on both sides of its line, in front of its origin.
    bool
    meets(const Ray &ray, const CornerVectors<2> &x)
    {
      bool left = false, right = false, ahead = false;
      for (int k = 0; k < 4; ++k)
        {
          const double dx = x[0][k] - ray.origin[0], dy = x[1][k] - ray.origin[1];
          const double side = dx * ray.direction[1] - dy * ray.direction[0];
          left              = left || side < 0;
          right             = right || side >= 0;
          ahead             = ahead || dx * ray.direction[0] + dy * ray.direction[1] > 0;
        }
      return left && right && ahead;
    }

    /// Profile coordinate and density of a cell.
    using Sample = std::array<double, 2>;

    std::vector<Sample>
    samples_of_all_ranks(const std::vector<Sample> &own, MPI_Comm communicator)
    {
      std::vector<Sample> all = gather_all<Sample>(communicator, own).entry;
      std::sort(all.begin(), all.end());
      return all;
    }

    /// Crossing of a level nearest to where it should be.
    std::optional<double>
    nearest_crossing(const std::vector<Sample> &samples, double level, double expected)
    {
      std::optional<double> nearest;
      for (std::size_t i = 1; i < samples.size(); ++i)
        {
          const auto [x0, a] = samples[i - 1];
          const auto [x1, b] = samples[i];
          if ((a - level) * (b - level) > 0 || a == b)
            continue;
          const double x = x0 + (level - a) / (b - a) * (x1 - x0);
          if (!nearest || std::abs(x - expected) < std::abs(*nearest - expected))
            nearest = x;
        }
      return nearest;
    }

    /// Mean of the exact densities on both sides of the shock, on a ray.
    double
    half_way_density(const exact::ExactSolution<2> &solution, const Ray &ray, double shock, double beside, double time)
    {
      const double start = *solution.profile_coordinate(ray.origin);
      double       sum   = 0;
      for (const double coordinate : {shock - beside, shock + beside})
        {
          Vector<2> x;
          for (int d = 0; d < 2; ++d)
            x[d] = ray.origin[d] + (coordinate - start) * ray.direction[d];
          sum += 0.5 * solution.at(x, time).density;
        }
      return sum;
    }
  } // namespace

  template <>
  std::optional<ShockMeasure>
  measure_shock(const Problem<2> &problem, const FlatMesh<2> &mesh, const State<2> &state, MPI_Comm communicator)
  {
    const Scene<2>                &scene    = problem.scene;
    const exact::ExactSolution<2> &solution = *problem.exact;
    const auto                     shock    = solution.shock_position(state.time);
    if (!shock || !solution.profile_coordinate(scene.lattice.origin))
      return std::nullopt;
    const double        beside = 1e-6 * scene.lattice.spacing;
    ShockMeasure        measure{*shock, {}, {}};
    std::vector<double> found;
    const Box<2>        domain = scene.mapped_box({scene.lattice.origin, scene.upper_corner()});
    for (const Ray &ray : make_rays(solution, domain.lower, domain.upper))
      {
        const double level = half_way_density(solution, ray, *shock, beside, state.time);
        if (std::isnan(level))
          return std::nullopt;
        std::vector<Sample> own;
        for (Index c = 0; c < mesh.n_owned; ++c)
          if (const CornerVectors<2> x = cell_corners(mesh, state.position, c); meets(ray, x))
            own.push_back(
                {*solution.profile_coordinate(CellShape<2>::middle(x)), cell_mass(state, c) / state.volume[c]});
        if (const auto x = nearest_crossing(samples_of_all_ranks(own, communicator), level, *shock))
          found.push_back(*x);
      }
    if (!found.empty())
      {
        double sum = 0;
        for (const double x : found)
          sum += x;
        measure.mean             = sum / static_cast<double>(found.size());
        const auto [least, most] = std::minmax_element(found.begin(), found.end());
        measure.spread           = *most - *least;
      }
    return measure;
  }
} // namespace whipple
