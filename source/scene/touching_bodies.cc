// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/sections.h>
#include <whipple/scene/shape_section.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace whipple::sections
{
  namespace
  {
    SceneSection
    section_of(SceneParameters &parameters, const std::string &body)
    {
      return {parameters, "Bodies/" + body};
    }

    /// A body that is moved along axis 1 by the parameter that places it.
    template <int dim>
    class Placed
    {
    public:
      Placed(const SceneSection &section, const Scene<dim> &scene)
        : section_(section)
        , scene_(scene)
        , key_(shape_description(section).position_key)
        , is_point_(key_ != "Front face")
      {
        if (!shape_description(section).placed_by_one_key)
          section.reject("Touching", "a " + shape_description(section).name +
                                         " is not placed by one parameter; allowed are other shapes, or no Touching");
        if (is_point_ && section.given(key_))
          across_ = section.vector<dim>(key_, units::length)[0];
      }

      /// The body at a place along axis 1, cm.
      Shape<dim>
      at(double place) const
      {
        const std::string along = units::format(place, units::length);
        section_.replace(key_, is_point_ ? units::format(across_, units::length) + ", " + along : along);
        return read_shape(section_, scene_);
      }

    private:
      const SceneSection &section_;
      const Scene<dim>   &scene_;
      std::string         key_;
      bool                is_point_;
      double              across_ = 0;
    };

    /// Where a body that comes along axis 1 in a sense (1 or -1) meets another, cm. Boxes around them touch first; the
    /// bodies themselves there, or further on.
    template <int dim>
    double
    contact(const SceneSection &section, const Placed<dim> &placed, const Shape<dim> &other, int sense)
    {
      constexpr int    axis = dim - 1;
      const Box<dim>   box = extent(placed.at(0.)), target = extent(other);
      const double     first = sense > 0 ? target.lower[axis] - box.upper[axis] : target.upper[axis] - box.lower[axis];
      const double     way   = target.upper[axis] - target.lower[axis] + box.upper[axis] - box.lower[axis];
      const auto       meets = [&](double path) { return overlap(placed.at(first + sense * path), other); };
      constexpr int    looks = 64;
      constexpr double least = 1e-9; // of the way: what meets within it has met where the boxes touch
      if (meets(least * way))
        return first;
      int look = 1;
      while (look < looks && !meets(way * look / looks))
        ++look;
      if (look == looks)
        section.reject("Touching", "the body passes it; allowed is a body that lies in its way along axis 1");
      double apart = way * (look - 1) / looks, together = way * look / looks;
      for (int half = 0; half < 60; ++half)
        (meets(0.5 * (apart + together)) ? together : apart) = 0.5 * (apart + together);
      return first + sense * apart;
    }

    /// Places bodies, and those that they touch before them.
    template <int dim>
    class Placing
    {
    public:
      Placing(SceneParameters &parameters, const Scene<dim> &scene, std::vector<std::string> names)
        : parameters_(parameters)
        , scene_(scene)
        , names_(std::move(names))
      {
      }

      void
      place(const std::string &body)
      {
        const SceneSection section = section_of(parameters_, body);
        if (!section.given("Touching") || done_.contains(body))
          return;
        const std::string touched = names_[section.name_index("Touching", section.text("Touching"), names_)];
        if (!under_way_.insert(body).second || touched == body)
          section.reject("Touching", "the body would touch itself");
        place(touched);
        const Placed<dim> placed(section, scene_);
        const auto        other    = read_shape(section_of(parameters_, touched), scene_);
        const double      velocity = section.vector<dim>("Velocity", units::velocity)[dim - 1];
        placed.at(contact(section, placed, other, velocity < 0 ? -1 : 1));
        done_.insert(body);
      }

    private:
      SceneParameters         &parameters_;
      const Scene<dim>        &scene_;
      std::vector<std::string> names_;
      std::set<std::string>    under_way_, done_;
    };
  } // namespace

  template <int dim>
  void
  place_touching_bodies(SceneParameters &parameters, const Scene<dim> &scene)
  {
    const std::vector<std::string> names = SceneSection(parameters, "Bodies").list("List");
    Placing<dim>                   placing(parameters, scene, names);
    for (const std::string &name : names)
      placing.place(name);
  }

  template void
  place_touching_bodies(SceneParameters &, const Scene<2> &);
} // namespace whipple::sections
