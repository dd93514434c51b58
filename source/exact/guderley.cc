// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/guderley.h>
#include <whipple/exact/profile_request.h>

#include <algorithm>
#include <cmath>

namespace whipple::exact
{
  namespace
  {
    using Row = std::array<double, 3>;

    Row
    moved(const Row &row, double step, const Row &rate)
    {
      return {row[0] + step * rate[0], row[1] + step * rate[1], row[2] + step * rate[2]};
    }

    template <class Rate>
    Row
    runge_kutta(double x, const Row &row, double h, const Rate &rate)
    {
      const Row a = rate(x, row), b = rate(x + h / 2, moved(row, h / 2, a)), c = rate(x + h / 2, moved(row, h / 2, b)),
                d = rate(x + h, moved(row, h, c));
      return moved(moved(moved(moved(row, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }

    /// d(v, w, ln G)/dx: the equations of SelfSimilarFlow with the factors x divided out.
    Row
    outflow_rate(const SelfSimilarFlow &flow, double x, const Row &row)
    {
      const double v = row[0], w = row[1], a = flow.alpha, n = flow.dimensions, k = flow.exponent;
      const double d      = (x * v - 1.) * (x * v - 1.) - x * x * w;
      const double rise   = ((1. - a) * v * v * (1. - x * v) + a * flow.sigma() * w + (1. - a * n) * x * v * w) / d;
      const double spread = a * n * v - v - x * rise;
      return {rise, w * ((k - 1.) * spread + 2. * (a - 1.) * v) / (x * v - 1.), spread / (x * v - 1.)};
    }

    /// d(U, ln Z, ln G)/dy.
    Row
    centre_rate(const SelfSimilarFlow &flow, const Row &row)
    {
      const double u = row[0], z = std::exp(row[1]), n = flow.dimensions, lambda = 1. / flow.alpha;
      const double d    = (u - 1.) * (u - 1.) - z;
      const double rise = (-u * (u - 1.) * (u - lambda) + z * (n * u - flow.sigma())) / d;
      return {rise, -((flow.exponent - 1.) * (rise + n * u) + 2. * (u - lambda)) / (u - 1.),
              -(rise + n * u) / (u - 1.)};
    }
  } // namespace

  Row
  Guderley::Table::at(double x) const
  {
    const auto size  = static_cast<std::ptrdiff_t>(place.size());
    const auto above = std::lower_bound(place.begin(), place.end(), x) - place.begin();
    const auto first = std::clamp<std::ptrdiff_t>(above - 2, 0, size - 4);
    Row        result{};
    for (std::ptrdiff_t i = first; i < first + 4; ++i)
      {
        double weight = 1;
        for (std::ptrdiff_t j = first; j < first + 4; ++j)
          if (j != i)
            weight *= (x - place[j]) / (place[i] - place[j]);
        result = moved(result, weight, row[i]);
      }
    return result;
  }

  Guderley::Guderley(const Constants &given_constants)
    : constants(given_constants)
  {
    const ConvergingShock shock = find_converging_shock(constants.dimensions, constants.exponent);
    flow                        = shock.flow;
    tabulate_convergence(shock);
    tabulate_outflow();
    tabulate_centre();
    reflect();
    const auto inward = [this](double r, double t) {
      const ProfileState s = at(r, t);
      return s.velocity - std::sqrt(flow.exponent * s.pressure / s.density);
    };
    rim.emplace(inward, constants.extent, constants.start, 1e-3 * std::abs(constants.start),
                [this](double t) { return *shock_position(t); });
  }

  /// From the shock at x = -1 through the sonic passage.
  void
  Guderley::tabulate_convergence(const ConvergingShock &shock)
  {
    const SelfSimilarState behind = behind_strong_shock(flow);
    const double           middle = shock.passage.velocity(), reach = 0.02 * (behind.velocity - middle);
    auto                   states = follow_velocity(flow, shock.passage.at(middle + reach), behind.velocity, 4000);
    std::reverse(states.begin(), states.end());
    const SelfSimilarState origin = states.front();
    for (int i = 99; i >= -100; --i)
      states.push_back(shock.passage.at(middle + reach * i / 100.));
    for (const SelfSimilarState &s : states)
      {
        const double x = -std::exp(-(s.y - origin.y) / flow.alpha);
        gas.place.push_back(x);
        gas.row.push_back(
            {s.velocity / x, s.sound_square / (x * x), s.log_density - origin.log_density + behind.log_density});
      }
  }

  /// On through the collapse, as far as no reflected shock can lie.
  void
  Guderley::tabulate_outflow()
  {
    constexpr double step = 1e-3, farthest = 20.;
    while (gas.place.back() < farthest)
      {
        const double x    = gas.place.back();
        const Row    next = runge_kutta(x, gas.row.back(), step,
                                        [&](double at, const Row &row) { return outflow_rate(flow, at, row); });
        if (!(std::isfinite(next[0]) && next[1] > 0))
          break;
        gas.place.push_back(x + step);
        gas.row.push_back(next);
      }
  }

  /// The one solution that is regular at r = 0, where Z is infinite, from there outwards; y and ln G are shifted later.
  void
  Guderley::tabulate_centre()
  {
    const double n = flow.dimensions, lambda = 1. / flow.alpha, small = 1e-10, u = flow.sigma() / n;
    const double growth   = ((flow.exponent - 1.) * flow.sigma() + 2. * (u - lambda)) / (u - 1.); // of 1 / Z
    centre.place          = {0.};
    centre.row            = {{u + u * (u - 1.) * (u - lambda) / (n + growth) * small, -std::log(small), 0.}};
    constexpr double step = 2e-3;
    for (int i = 1; i < 40000; ++i)
      {
        const Row next =
            runge_kutta(0., centre.row.back(), step, [&](double, const Row &row) { return centre_rate(flow, row); });
        if (!((next[0] - 1.) * (next[0] - 1.) < 0.999 * std::exp(next[1])))
          break; // about to turn supersonic: no place behind a shock
        centre.place.push_back(i * step);
        centre.row.push_back(next);
      }
  }

  SelfSimilarState
  Guderley::behind_reflection(double x) const
  {
    // Rankine-Hugoniot in the frame of the shock, where the gas moves with U - 1
    const Row    ahead = gas.at(x);
    const double k = flow.exponent, in = x * ahead[0] - 1., z = x * x * ahead[1];
    const double out = in * (k - 1.) / (k + 1.) + 2. * z / ((k + 1.) * in);
    return {-flow.alpha * std::log(x), 1. + out, z + 0.5 * (k - 1.) * (in * in - out * out),
            ahead[2] + std::log(in / out)};
  }

  /// Where the state behind a shock lies on the solution about the centre.
  void
  Guderley::reflect()
  {
    const auto place_of = [&](double log_z) {
      double low = centre.place.front(), high = centre.place.back();
      for (int i = 0; i < 60; ++i)
        {
          const double middle                         = 0.5 * (low + high);
          (centre.at(middle)[1] > log_z ? low : high) = middle;
        }
      return high;
    };
    const auto miss = [&](double x) {
      const SelfSimilarState behind = behind_reflection(x);
      return behind.velocity - centre.at(place_of(std::log(behind.sound_square)))[0];
    };
    const auto inside = [&](double x) {
      const double z = behind_reflection(x).sound_square;
      return z > std::exp(centre.row.back()[1]);
    };
    constexpr double step = 0.01;
    for (double x = 0.1; x + step < gas.place.back(); x += step)
      if (inside(x) && inside(x + step) && miss(x) * miss(x + step) <= 0)
        {
          double       low = x, high = x + step;
          const double sign = miss(low);
          for (int i = 0; i < 50; ++i)
            {
              const double middle                    = 0.5 * (low + high);
              (miss(middle) * sign > 0 ? low : high) = middle;
            }
          reflection                    = high;
          const SelfSimilarState behind = behind_reflection(reflection);
          const double           place  = place_of(std::log(behind.sound_square));
          const double           gained = behind.log_density - centre.at(place)[2];
          for (double &y : centre.place)
            y += behind.y - place;
          for (Row &row : centre.row)
            row[2] += gained;
          return;
        }
    throw InputError("guderley: adiabatic exponent = " + std::to_string(flow.exponent) + ": no reflected shock found");
  }

  SelfSimilarState
  Guderley::similarity_state(double x) const
  {
    const double y = -flow.alpha * std::log(x);
    Row          row;
    if (y > centre.place.front())
      row = centre.at(y);
    else // deep in the centre everything is a power of r
      row = moved(centre.row.front(), y - centre.place.front(), centre_rate(flow, centre.row.front()));
    return {y, row[0], std::exp(row[1]), row[2]};
  }

  ProfileState
  Guderley::at(double coordinate, double time) const
  {
    const double r = std::max(coordinate, 1e-12 * constants.amplitude), k = flow.exponent;
    const double stretch = std::pow(constants.amplitude / r, 1. / flow.alpha), x = time * stretch;
    if (x < -1.)
      return {constants.density, 0., 0., 0.};
    const double scale = flow.alpha * r * stretch;
    double       velocity, square, log_density;
    if (x < reflection)
      {
        const Row row = gas.at(x);
        velocity      = scale * row[0];
        square        = scale * scale * row[1];
        log_density   = row[2];
      }
    else
      {
        const SelfSimilarState s = similarity_state(x);
        velocity                 = scale * s.velocity / x;
        square                   = scale * scale * s.sound_square / (x * x);
        log_density              = s.log_density;
      }
    const double density = constants.density * std::exp(log_density);
    return {density, velocity, density * square / k, square / (k * (k - 1.))};
  }

  bool
  Guderley::counts(double coordinate, double time) const
  {
    return rim->not_yet_at(coordinate, time);
  }

  std::vector<double>
  Guderley::breaks(double time) const
  {
    return {*shock_position(time)};
  }

  std::optional<double>
  Guderley::shock_position(double time) const
  {
    return constants.amplitude * std::pow(time < 0 ? -time : time / reflection, flow.alpha);
  }

  ExactKind
  guderley_kind()
  {
    return {"guderley",
            "strong shock that converges onto a line or point of cold ideal gas, at time 0, and is reflected; density "
            "and exponent of the one body (R. B. Lazarus, SIAM J. Numer. Anal. 18 (1981) 316)",
            {{"Shock radius", "length", 1., "of the converging shock 1 us before its collapse"}}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_guderley(const ExactRequest<2> &request)
  {
    const IdealGasState gas        = only_gas(request);
    const int           dimensions = space_dimensions(request);
    if (dimensions == 1)
      throw InputError("exact solution '" + request.name + "': Geometry: must be cylindrical | spherical");
    if (!(request.start < 0))
      throw InputError("exact solution '" + request.name + "': start = " + std::to_string(request.start) +
                       " us: must be < 0, the shock arrives at 0");
    return in_plane(request, std::make_unique<Guderley>(Guderley::Constants{dimensions, gas.exponent, gas.density,
                                                                            positive_constant(request, "Shock radius"),
                                                                            extent(request), request.start}));
  }
} // namespace whipple::exact
