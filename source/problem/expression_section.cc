// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/problem/expression_section.h>
#include <whipple/problem/expression_state.h>
#include <whipple/scene/plausible.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace whipple::sections
{
  namespace
  {
    const std::string density_key = "Density expression", energy_key = "Specific energy expression",
                      velocity_key = "Velocity expression", coordinate_unit = "Coordinate unit";

    /// One key with an expression, the key that names the unit of its value, and the one that gives a uniform value.
    struct ExpressionKey
    {
      const std::string     &key;
      std::string            unit_key;
      const units::Quantity &quantity;
    };
    const std::vector<ExpressionKey> expression_keys{{density_key, "Density unit", units::density},
                                                     {energy_key, "Specific energy unit", units::specific_energy},
                                                     {velocity_key, "Velocity unit", units::velocity}};

    /// The unit that a key names, in internal units.
    double
    unit_of(const SceneSection &section, const std::string &key, const units::Quantity &quantity)
    {
      const std::string allowed =
          std::string("allowed is a unit of ") + quantity.name + " such as " + (quantity.unit[0] ? quantity.unit : "1");
      if (!section.given(key))
        section.reject(key, "must be given beside an expression; " + allowed);
      try
        {
          return units::parse("1 " + section.text(key), quantity);
        }
      catch (const InputError &error)
        {
          section.reject(key, std::string(error.what()) + "; " + allowed);
        }
    }

    /// The expressions of a key, one for each component.
    std::vector<Expression>
    read_components(const SceneSection &section, Symmetry symmetry, const ExpressionKey &key, std::size_t components)
    {
      const double             unit = unit_of(section, key.unit_key, key.quantity);
      const double             cm   = unit_of(section, coordinate_unit, units::length);
      std::vector<std::string> parts;
      std::istringstream       text(section.text(key.key));
      for (std::string part; std::getline(text, part, ';');)
        parts.push_back(part);
      if (parts.size() != components)
        section.reject(key.key, std::to_string(parts.size()) + " expressions; allowed " +
                                    (components == 1 ? "is one"
                                                     : "are " + std::to_string(components) +
                                                           " separated by ';', along axis 0 and axis 1"));
      std::vector<Expression> all;
      for (const std::string &part : parts)
        try
          {
            all.emplace_back(part, symmetry, unit, cm);
          }
        catch (const InputError &error)
          {
            section.reject(key.key, error.what());
          }
      return all;
    }

    template <int dim>
    typename ExpressionState<dim>::Parts
    read_parts(const SceneSection &section, Symmetry symmetry)
    {
      typename ExpressionState<dim>::Parts parts;
      if (section.given(density_key))
        parts.density = read_components(section, symmetry, expression_keys[0], 1)[0];
      if (section.given(energy_key))
        parts.energy = read_components(section, symmetry, expression_keys[1], 1)[0];
      if (section.given(velocity_key))
        {
          const std::vector<Expression> v = read_components(section, symmetry, expression_keys[2], dim);
          parts.velocity                  = {{v[0], v[1]}};
        }
      return parts;
    }

    /// Points of a grid over a body's part of the domain, at most this many along an axis.
    constexpr int most_points = 200;

    template <int dim>
    class BodyGrid
    {
    public:
      BodyGrid(const Scene<dim> &scene, const Shape<dim> &shape)
      {
        const Box<dim>    box = extent(shape);
        const Vector<dim> low = scene.lattice.origin, high = scene.upper_corner();
        for (int d = 0; d < dim; ++d)
          {
            from_[d]            = std::max(box.lower[d], low[d]);
            const double length = std::min(box.upper[d], high[d]) - from_[d];
            n_[d]    = static_cast<int>(std::clamp(std::ceil(length / scene.lattice.spacing), 1., 1. * most_points));
            size_[d] = length / n_[d];
          }
      }

      /// Every panel: its lower and upper corner.
      template <typename Visit>
      void
      for_each_panel(const Visit &visit) const
      {
        for (int j = 0; j < n_[1]; ++j)
          for (int i = 0; i < n_[0]; ++i)
            visit(corner(i, j), corner(i + 1, j + 1));
      }

      /// Corners and middles of all panels.
      template <typename Visit>
      void
      for_each_point(const Visit &visit) const
      {
        for (int j = 0; j <= n_[1]; ++j)
          for (int i = 0; i <= n_[0]; ++i)
            {
              visit(corner(i, j));
              if (i < n_[0] && j < n_[1])
                visit(middle(corner(i, j), corner(i + 1, j + 1)));
            }
      }

      static Vector<dim>
      middle(const Vector<dim> &a, const Vector<dim> &b)
      {
        return {{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}};
      }

    private:
      Vector<dim>
      corner(int i, int j) const
      {
        return {{from_[0] + i * size_[0], from_[1] + j * size_[1]}};
      }

      Vector<dim>          from_, size_;
      std::array<int, dim> n_;
    };

    /// The key to blame for a state that cannot be.
    template <int dim>
    const ExpressionKey &
    key_of_problem(const exact::PointState<dim> &state)
    {
      if (!(state.density > 0) || !(state.density <= plausible::largest(units::density)))
        return expression_keys[0];
      return std::abs(state.energy) <= plausible::largest(units::specific_energy) ? expression_keys[2]
                                                                                  : expression_keys[1];
    }

    /// What is wrong with the state at a point of the body; empty if nothing is.
    template <int dim>
    std::string
    problem_at(const Vector<dim> &x, const exact::PointState<dim> &state, Symmetry symmetry)
    {
      std::string wrong = ExpressionState<dim>::problem(state);
      double      speed = 0;
      for (const double v : state.velocity)
        speed = std::max(speed, std::abs(v));
      if (wrong.empty() && (state.density > plausible::largest(units::density) ||
                            std::abs(state.energy) > plausible::largest(units::specific_energy) ||
                            speed > plausible::largest(units::velocity)))
        wrong = "a value is too large";
      if (wrong.empty() && symmetry == Symmetry::axisymmetric && x[0] == 0 && state.velocity[0] != 0)
        wrong = "the body leaves the axis with " + units::format(state.velocity[0], units::velocity);
      return wrong;
    }

    template <int dim>
    void
    check_values(const SceneSection &section, const Scene<dim> &scene, const Body<dim> &body,
                 const ExpressionState<dim> &field)
    {
      const Symmetry symmetry = scene.lattice.symmetry;
      BodyGrid<dim>(scene, body.shape).for_each_point([&](const Vector<dim> &x) {
        if (!body.shape->contains(x))
          return;
        const exact::PointState<dim> state = field.value(x);
        const std::string            wrong = problem_at<dim>(x, state, symmetry);
        if (wrong.empty())
          return;
        std::ostringstream text;
        text << wrong << " at " << (symmetry == Symmetry::planar ? "x = " : "r = ") << x[0] << " cm, "
             << (symmetry == Symmetry::planar ? "y = " : "z = ") << x[1]
             << " cm; allowed are numbers, in the whole body a density > 0, and on the axis of r, z no velocity "
                "across it";
        section.reject(key_of_problem(state).key, text.str());
      });
    }

    /// Means over the body, for whoever asks for one density, energy or velocity.
    template <int dim>
    void
    take_means(const Scene<dim> &scene, const ExpressionState<dim> &field, Body<dim> &body)
    {
      double      volume = 0, mass = 0, energy = 0;
      Vector<dim> momentum{};
      BodyGrid<dim>(scene, body.shape).for_each_panel([&](const Vector<dim> &lower, const Vector<dim> &upper) {
        const Vector<dim> x = BodyGrid<dim>::middle(lower, upper);
        if (!body.shape->contains(x))
          return;
        const exact::PointState<dim> state = field.value(x);
        const double                 part  = body.shape->volume(scene.lattice.symmetry, lower, upper);
        volume += part;
        mass += part * state.density;
        energy += part * state.density * state.energy;
        for (int d = 0; d < dim; ++d)
          momentum[d] += part * state.density * state.velocity[d];
      });
      if (!(mass > 0)) // thinner than the grid: the middle stands for all
        return;
      body.density = mass / volume;
      body.energy  = energy / mass;
      for (int d = 0; d < dim; ++d)
        body.velocity[d] = momentum[d] / mass;
    }
  } // namespace

  void
  declare_expressions(SceneSection &section)
  {
    section.declare(density_key, "", "of r, z (planar: x, y) and pi; instead of a density");
    section.declare(energy_key, "", "instead of a specific energy and a pressure");
    section.declare(velocity_key, "", "instead of a velocity: two expressions separated by ';'");
    for (const ExpressionKey &key : expression_keys)
      section.declare(key.unit_key, "", std::string("of the value of that expression, such as ") + key.quantity.unit);
    section.declare(coordinate_unit, "", "of the coordinates in expressions, such as cm");
  }

  std::vector<std::string>
  given_expressions(const SceneSection &section)
  {
    std::vector<std::string> given;
    for (const ExpressionKey &key : expression_keys)
      if (section.given(key.key))
        given.push_back(key.key);
    return given;
  }

  template <int dim>
  void
  reject_doubles(const SceneSection &section, const Body<dim> &body)
  {
    const std::string alone = "; allowed is one of the two";
    if (section.given(density_key))
      for (const char *key : {"Density", "Pressure"})
        if (section.given(key))
          section.reject(key, "the body has a density expression" + alone);
    if (section.given(energy_key))
      for (const char *key : {"Specific energy", "Pressure"})
        if (section.given(key))
          section.reject(key, "the body has a specific energy expression" + alone);
    if (section.given(velocity_key) && body.velocity != Vector<dim>{})
      section.reject("Velocity", "the body has a velocity expression" + alone);
    for (const ExpressionKey &key : expression_keys)
      if (section.given(key.unit_key) && !section.given(key.key))
        section.reject(key.unit_key, "needs a " + key.key);
  }

  template <int dim>
  std::shared_ptr<const exact::ExactSolution<dim>>
  read_expressions(const SceneSection &section, const Scene<dim> &scene, Body<dim> &body)
  {
    const std::vector<std::string> given = given_expressions(section);
    if (given.empty())
      {
        if (section.given(coordinate_unit))
          section.reject(coordinate_unit, "needs an expression");
        return nullptr;
      }
    if (scene.mesh_map != MeshMap::identity)
      section.reject(given[0], "on a mapped mesh bodies are given on the lattice; allowed is an exact solution, or "
                               "Geometry/Mesh map = none");
    exact::PointState<dim> uniform;
    uniform.density  = body.density;
    uniform.energy   = body.energy;
    uniform.velocity = body.velocity;
    const auto field = std::make_shared<const ExpressionState<dim>>(body.name, body.shape, uniform,
                                                                    read_parts<dim>(section, scene.lattice.symmetry));
    check_values(section, scene, body, *field);
    take_means(scene, *field, body);
    body.initial_state = InitialState::expressions;
    return field;
  }

  template void
  reject_doubles(const SceneSection &, const Body<2> &);
  template std::shared_ptr<const exact::ExactSolution<2>>
  read_expressions(const SceneSection &, const Scene<2> &, Body<2> &);
} // namespace whipple::sections
