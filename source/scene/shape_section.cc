// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/shape_section.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace whipple::sections
{
  namespace
  {
    /// Names of the kinds that have a parameter, for messages.
    std::string
    kinds_with(const std::string &key)
    {
      std::string text;
      for (const auto &[name, entry] : ShapeRegistry<2>::all())
        for (const ShapeParameter &parameter : entry.description.parameters)
          if (parameter.key == key)
            text += (text.empty() ? "" : ", ") + name;
      return text;
    }

    std::vector<std::string>
    kind_names()
    {
      std::vector<std::string> names;
      for (const auto &[name, entry] : ShapeRegistry<2>::all())
        names.push_back(name);
      return names;
    }

    const ShapeRegistry<2>::Entry &
    chosen_kind(const SceneSection &section)
    {
      const std::vector<std::string> names = kind_names();
      return ShapeRegistry<2>::all().at(names[section.name_index("Shape", section.text("Shape"), names)]);
    }

    /// What a scene's section says of a shape.
    template <int dim>
    class SectionInput : public ShapeInput<dim>
    {
    public:
      SectionInput(const SceneSection &section, const Scene<dim> &scene)
        : section_(section)
        , scene_(scene)
      {
      }

      Symmetry
      symmetry() const override
      {
        return scene_.lattice.symmetry;
      }
      std::string
      text(const std::string &key) const override
      {
        return section_.text(key);
      }
      double
      positive_length(const std::string &key) const override
      {
        return section_.positive(key, units::length);
      }
      double
      length(const std::string &key) const override
      {
        return section_.quantity(key, units::length);
      }
      Vector<dim>
      point(const std::string &key) const override
      {
        return section_.vector<dim>(key, units::length);
      }
      Vector<dim>
      point(const std::string &key, const std::string &part) const override
      {
        return section_.parse_vector<dim>(key, part, units::length);
      }
      [[noreturn]] void
      reject(const std::string &key, const std::string &allowed) const override
      {
        section_.reject(key, allowed);
      }
      void
      replace(const std::string &key, const std::string &value) const override
      {
        section_.replace(key, value);
      }
      std::string
      file(const std::string &key) const override
      {
        return (std::filesystem::path(scene_.file).parent_path() / section_.text(key)).string();
      }

    private:
      const SceneSection &section_;
      const Scene<dim>   &scene_;
    };

    /// Middle of a shape, 0 along axes on which it is infinite.
    template <int dim>
    Vector<dim>
    middle(const Shape<dim> &shape)
    {
      const Box<dim> box = extent(shape);
      Vector<dim>    x;
      for (int d = 0; d < dim; ++d)
        x[d] = std::isfinite(box.lower[d]) ? 0.5 * (box.lower[d] + box.upper[d]) : 0.;
      return x;
    }

    template <int dim>
    Shape<dim>
    turn(const SceneSection &section, const Scene<dim> &scene, const Shape<dim> &shape)
    {
      const double   angle = section.between("Rotation", units::angle, -360., 360.);
      const Box<dim> domain{scene.lattice.origin, scene.upper_corner()};
      Vector<dim>    center = middle(shape);
      if (section.given("Rotation center"))
        center = section.vector<dim>("Rotation center", units::length);
      if (angle == 0 || std::abs(angle) == 360.)
        return shape;
      if (scene.lattice.symmetry == Symmetry::planar)
        return shape->turned(Turn<dim>::in_plane(angle, center), domain);
      if (std::abs(angle) != 180.)
        section.reject("Rotation", "in axisymmetry a body that is turned is not axisymmetric any more; allowed are 0 "
                                   "deg and 180 deg (end for end), other angles with Symmetry = planar");
      if (section.given("Rotation center") && center[0] != 0)
        section.reject("Rotation center", "in axisymmetry a body is turned about a point on the axis; the first "
                                          "component must be 0 cm");
      return shape->turned(Turn<dim>::end_for_end(center), domain);
    }
  } // namespace

  void
  declare_shape(SceneSection &section)
  {
    std::string choices;
    for (const std::string &name : kind_names())
      choices += (choices.empty() ? "" : " | ") + name;
    section.declare("Shape", "", choices);
    std::vector<std::string> declared;
    for (const auto &[name, entry] : ShapeRegistry<2>::all())
      for (const ShapeParameter &parameter : entry.description.parameters)
        if (std::find(declared.begin(), declared.end(), parameter.key) == declared.end())
          {
            declared.push_back(parameter.key);
            section.declare(parameter.key, "", kinds_with(parameter.key) + ": " + parameter.value);
          }
    section.declare("Rotation", "0 deg", "from axis 0 towards axis 1; axisymmetric: 0 deg or 180 deg, end for end");
    section.declare("Rotation center", "", "not given: the middle of the body");
  }

  const ShapeDescription &
  shape_description(const SceneSection &section)
  {
    return chosen_kind(section).description;
  }

  template <int dim>
  Shape<dim>
  read_shape(const SceneSection &section, const Scene<dim> &scene)
  {
    const auto                        &kind  = chosen_kind(section);
    const std::vector<ShapeParameter> &known = kind.description.parameters;
    for (const auto &[name, entry] : ShapeRegistry<dim>::all())
      for (const ShapeParameter &other : entry.description.parameters)
        if (section.given(other.key) &&
            std::none_of(known.begin(), known.end(), [&](const ShapeParameter &p) { return p.key == other.key; }))
          section.reject(other.key,
                         "belongs to the shape " + kinds_with(other.key) + ", not to a " + kind.description.name);
    return turn(section, scene, kind.make(SectionInput<dim>(section, scene)));
  }

  template Shape<2>
  read_shape(const SceneSection &, const Scene<2> &);
} // namespace whipple::sections
