// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/registry.h>
#include <whipple/scene/shape.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace whipple
{
  /// A parameter of a shape, set by its key in a scene's section Bodies/NAME. Shapes that mean the same thing share the
  /// key.
  struct ShapeParameter
  {
    std::string key;           ///< "Diameter"
    std::string value;         ///< what is to be written: "a length", "two lengths" ...
    std::string otherwise;     ///< what holds unless it is given; empty: it is needed
    std::string documentation; ///< what it is
  };

  /// All that is to know about a kind of shape: for scenes, `whipple help shapes`, messages and the manual.
  struct ShapeDescription
  {
    std::string                 name;          ///< in scene files, "sphere"
    std::string                 summary;       ///< one line
    std::string                 documentation; ///< a paragraph
    std::vector<ShapeParameter> parameters;
    std::string                 position_key;             ///< of the parameter to look at if a body is in a wrong place
    std::string                 size_key;                 ///< ... or is too small
    bool                        placed_by_one_key = true; ///< the position key moves it and changes nothing else
  };

  /// What a scene says of one body's shape. Every function throws InputError naming file, key, value and what is
  /// allowed.
  template <int dim>
  class ShapeInput
  {
  public:
    virtual ~ShapeInput() = default;

    virtual Symmetry
    symmetry() const = 0;
    /// Text of a parameter; empty if not given.
    virtual std::string
    text(const std::string &key) const = 0;
    /// A length > 0, cm.
    virtual double
    positive_length(const std::string &key) const = 0;
    /// A length of any sign, cm.
    virtual double
    length(const std::string &key) const = 0;
    /// A point, cm.
    virtual Vector<dim>
    point(const std::string &key) const = 0;
    /// A point in `part` of what a parameter holds, cm.
    virtual Vector<dim>
    point(const std::string &key, const std::string &part) const = 0;
    [[noreturn]] virtual void
    reject(const std::string &key, const std::string &allowed) const = 0;
    /// Write another value into the parameters in force.
    virtual void
    replace(const std::string &key, const std::string &value) const = 0;
    /// Name of a file that a scene names, as seen from here: relative names start at the scene's folder.
    virtual std::string
    file(const std::string &key) const = 0;

    bool
    given(const std::string &key) const
    {
      return !text(key).empty();
    }
  };

  /// A kind of shape as scenes know it.
  template <int dim>
  struct ShapeKind
  {
    ShapeDescription                                   description;
    std::function<Shape<dim>(const ShapeInput<dim> &)> make;
  };

  /// All kinds of shapes, by name.
  template <int dim>
  class ShapeRegistry : public Registry<ShapeRegistry<dim>, ShapeKind<dim>>
  {
  };

  /// Makes a kind of shape known under its name:
  ///
  ///     const ShapeRegistration<2> registration(description, [](const ShapeInput<2> &input) -> Shape<2> { ... });
  template <int dim>
  class ShapeRegistration
  {
  public:
    ShapeRegistration(const ShapeDescription &description, std::function<Shape<dim>(const ShapeInput<dim> &)> make)
      : registered_(description.name, {description, std::move(make)})
    {
    }

  private:
    typename ShapeRegistry<dim>::Registered registered_;
  };
} // namespace whipple
