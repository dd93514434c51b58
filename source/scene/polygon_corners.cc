// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/polygon_shape.h>
#include <whipple/scene/shape_registry.h>
#include <whipple/scene/units.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace whipple
{
  namespace
  {
    /// More corners than any outline needs; what is done once for each pair of edges stays quick.
    constexpr std::size_t most_corners = 1000;

    const std::string allowed_file = "allowed are two columns separated by a comma or blanks: first the unit of each, "
                                     "'mm, mm', then a corner a line";

    /// The two words of a line of a file; separators are commas, blanks and tabs. A '#' begins a comment.
    std::vector<std::string>
    words_of(std::string line)
    {
      std::vector<std::string> words;
      line.resize(std::min(line.find('#'), line.size()));
      const std::string separators = ", \t\r";
      for (std::size_t end = 0, begin; (begin = line.find_first_not_of(separators, end)) != std::string::npos;)
        {
          end = std::min(line.find_first_of(separators, begin), line.size());
          words.push_back(line.substr(begin, end - begin));
        }
      return words;
    }

    /// Corners of a file with two columns.
    std::vector<Vector<2>>
    read_file(const ShapeInput<2> &input, const std::string &key)
    {
      const std::string name = input.file(key);
      std::ifstream     file(name);
      if (!std::filesystem::is_regular_file(name) || !file)
        input.reject(key, "'" + name + "' cannot be read; " + allowed_file);
      std::vector<std::string> unit;
      std::vector<Vector<2>>   corners;
      std::string              line;
      for (int number = 1; std::getline(file, line); ++number)
        {
          const std::vector<std::string> words = words_of(line);
          const std::string              where = "line " + std::to_string(number) + " of '" + name + "': ";
          if (words.empty())
            continue;
          if (words.size() != 2)
            input.reject(key, where + std::to_string(words.size()) + " columns; " + allowed_file);
          try
            {
              Vector<2> corner;
              for (int d = 0; d < 2; ++d)
                corner[d] = units::parse((unit.empty() ? "1" : words[d]) + ' ' + (unit.empty() ? words : unit)[d],
                                         units::length);
              if (unit.empty())
                unit = words;
              else
                corners.push_back(corner);
            }
          catch (const InputError &error)
            {
              input.reject(key, where + error.what() + "; " + allowed_file);
            }
          if (corners.size() > most_corners)
            input.reject(key, where + "allowed are up to " + std::to_string(most_corners) + " corners");
        }
      return corners;
    }

    /// Corners listed in the scene.
    std::vector<Vector<2>>
    read_list(const ShapeInput<2> &input, const std::string &key)
    {
      const std::string      text = input.text(key);
      std::vector<Vector<2>> corners;
      for (std::size_t begin = 0; begin <= text.size();)
        {
          const std::size_t end = std::min(text.find(';', begin), text.size());
          if (text.find_first_not_of(' ', begin) < end) // a ';' may stand at the end
            corners.push_back(input.point(key, text.substr(begin, end - begin)));
          begin = end + 1;
        }
      if (corners.size() > most_corners)
        input.reject(key, "allowed are up to " + std::to_string(most_corners) + " corners");
      return corners;
    }

    /// The corners as a scene lists them.
    std::string
    listed(const std::vector<Vector<2>> &corners)
    {
      std::string text;
      for (const Vector<2> &x : corners)
        text +=
            (text.empty() ? "" : "; ") + units::format(x[0], units::length) + ", " + units::format(x[1], units::length);
      return text;
    }

    Shape<2>
    make(const ShapeInput<2> &input)
    {
      const bool from_file = input.given("Corners file");
      if (from_file == input.given("Corners"))
        input.reject(from_file ? "Corners file" : "Corners",
                     "allowed are corners in the scene, '0 cm, 0 cm; 1 cm, 0 cm; 0 cm, 1 cm', or a file of them, "
                     "not both and not neither");
      const std::string            key     = from_file ? "Corners file" : "Corners";
      const std::vector<Vector<2>> corners = from_file ? read_file(input, key) : read_list(input, key);
      if (const std::string problem = outline_problem(corners); !problem.empty())
        input.reject(key, problem + "; allowed is an outline whose edges meet at the corners only");
      if (input.symmetry() == Symmetry::axisymmetric)
        for (const Vector<2> &x : corners)
          if (x[0] < 0)
            input.reject(key, "in axisymmetry a polygon is the half of the cross-section at r >= 0; a corner has r = " +
                                  units::format(x[0], units::length));
      if (from_file) // the parameters in force read back to the same scene wherever they are
        {
          input.replace("Corners", listed(corners));
          input.replace("Corners file", "");
        }
      return PolygonShape(corners);
    }

    const ShapeRegistration<2> registration(
        {.name    = "polygon",
         .summary = "what an outline of straight edges encloses, convex or not; axisymmetric: what it sweeps out",
         .documentation =
             "Corners in either sense of rotation, the last joined to the first; up to 1000. Edges meet at the corners "
             "only. In axisymmetry all corners have r >= 0. A file has two columns separated by a comma or blanks: "
             "first the units, `mm, mm`, then a corner a line; `#` begins a comment, and a relative name starts at the "
             "scene's folder. The parameters in force list what was read.",
         .parameters        = {{"Corners", "points separated by `;`", "a file", "`0 cm, 0 cm; 1 cm, 0 cm; 0 cm, 1 cm`"},
                               {"Corners file", "a file", "corners", "two columns with units"}},
         .position_key      = "Corners",
         .size_key          = "Corners",
         .placed_by_one_key = false},
        make);
  } // namespace
} // namespace whipple
