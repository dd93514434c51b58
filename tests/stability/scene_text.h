// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace whipple::stability
{
  /// A scene built in code: entries by path, "Bodies/sphere/Diameter", kept in the order they are first given.
  class SceneText
  {
  public:
    /// Give or replace an entry.
    SceneText &
    set(const std::string &path, const std::string &value)
    {
      root.set(path, value);
      return *this;
    }

    /// Add a subsection with its entries to a section that lists its members (Materials, Bodies, Stages).
    SceneText &
    add(const std::string &section, const std::string &name,
        const std::vector<std::pair<std::string, std::string>> &entries)
    {
      std::string &list = root.value(section + "/List");
      list += (list.empty() ? "" : ", ") + name;
      for (const auto &[key, value] : entries)
        set(section + "/" + name + "/" + key, value);
      return *this;
    }

    /// The scene as a .prm file.
    std::string
    text() const
    {
      std::string result;
      root.write(result, "");
      return result;
    }

    void
    write(const std::string &file) const
    {
      std::ofstream(file) << text();
    }

  private:
    struct Section
    {
      std::vector<std::pair<std::string, std::string>> entries;
      std::vector<std::pair<std::string, Section>>     sections;

      std::string &
      value(const std::string &path)
      {
        if (const std::size_t slash = path.find('/'); slash != std::string::npos)
          return found(sections, path.substr(0, slash)).value(path.substr(slash + 1));
        return found(entries, path);
      }
      void
      set(const std::string &path, const std::string &text)
      {
        value(path) = text;
      }
      void
      write(std::string &text, const std::string &indent) const
      {
        for (const auto &[key, value] : entries)
          text += indent + "set " + key + " = " + value + "\n";
        for (const auto &[name, section] : sections)
          {
            text += indent + "subsection " + name + "\n";
            section.write(text, indent + "  ");
            text += indent + "end\n";
          }
      }

      template <typename T>
      static T &
      found(std::vector<std::pair<std::string, T>> &all, const std::string &name)
      {
        for (auto &[key, value] : all)
          if (key == name)
            return value;
        return all.emplace_back(name, T()).second;
      }
    };

    Section root;
  };

  /// A length in cm as a scene takes it.
  inline std::string
  cm(double value)
  {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g cm", value);
    return text;
  }

  /// Two lengths in cm.
  inline std::string
  cm(double first, double second)
  {
    return cm(first) + ", " + cm(second);
  }

  /// A velocity in cm/us.
  inline std::string
  velocity(double first, double second)
  {
    char text[80];
    std::snprintf(text, sizeof text, "%.15g cm/us, %.15g cm/us", first, second);
    return text;
  }

  /// A number with a unit.
  inline std::string
  with_unit(double value, const std::string &unit)
  {
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text + (" " + unit);
  }

  /// An empty scene: box, uniform mesh, walls or open sides all around, no field output.
  /// @param symmetry "planar" or "axisymmetric"
  /// @param sides    "reflecting" or "transmitting"; the lower side of axis 0 reflects in any case
  inline SceneText
  box(const std::string &symmetry, double x0, double y0, double x1, double y1, double cell, const std::string &sides)
  {
    SceneText scene;
    scene.set("Geometry/Symmetry", symmetry)
        .set("Geometry/Lower corner", cm(x0, y0))
        .set("Geometry/Upper corner", cm(x1, y1))
        .set("Geometry/Left", "reflecting");
    for (const char *side : {"Right", "Bottom", "Top"})
      scene.set(std::string("Geometry/") + side, sides);
    scene.set("Mesh/Finest cell", cm(cell)).set("Mesh/Levels", "0").set("Mesh/Refinement", "uniform");
    return scene.set("Output/Fields interval", "none");
  }
} // namespace whipple::stability
