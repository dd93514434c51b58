// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>
#include <whipple/scene/parameters.h>
#include <whipple/scene/units.h>
#include <whipple/section_entry.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace whipple
{
  /// One subsection of the scene parameters, read with types, units and ranges. Every function throws InputError
  /// naming file, line, key, value and what is allowed.
  class SceneSection
  {
  public:
    SceneSection(SceneParameters &parameters, std::string path);

    void
    declare(const std::string &key, const std::string &default_value, const std::string &documentation);

    /// The text of an entry, blanks trimmed; empty if not given.
    std::string
    text(const std::string &key) const;

    bool
    given(const std::string &key) const
    {
      return !text(key).empty();
    }

    [[noreturn]] void
    reject(const std::string &key, const std::string &allowed) const;

    /// Effective value of an entry the user left open.
    void
    replace(const std::string &key, const std::string &value) const;

    /// A value in internal units, in [lower, upper].
    double
    quantity(const std::string &key, const units::Quantity &quantity) const;
    double
    positive(const std::string &key, const units::Quantity &quantity) const;
    double
    non_negative(const std::string &key, const units::Quantity &quantity) const;
    double
    between(const std::string &key, const units::Quantity &quantity, double lower, double upper) const;

    /// `none` or a value > 0.
    std::optional<double>
    optional_positive(const std::string &key, const units::Quantity &quantity) const;

    int
    integer(const std::string &key, int lower, int upper) const;

    /// The same for those who know nothing of scenes. Valid as long as the section is.
    SectionInput
    input() const;

    template <int dim>
    Vector<dim>
    vector(const std::string &key, const units::Quantity &quantity) const
    {
      return parse_vector<dim>(key, text(key), quantity);
    }

    /// The value in `part` of what an entry holds ("for 2 us").
    double
    parse(const std::string &key, const std::string &part, const units::Quantity &quantity) const
    {
      return components(key, part, quantity, 1)[0];
    }
    template <int dim>
    Vector<dim>
    parse_vector(const std::string &key, const std::string &part, const units::Quantity &quantity) const
    {
      const std::vector<double> values = components(key, part, quantity, dim);
      Vector<dim>               point;
      for (int d = 0; d < dim; ++d)
        point[d] = values[d];
      return point;
    }

    /// The value that belongs to the name the entry holds.
    template <typename T>
    T
    choice(const std::string &key, const std::vector<std::pair<std::string, T>> &choices) const
    {
      std::vector<std::string> names;
      for (const auto &[name, value] : choices)
        names.push_back(name);
      return choices[name_index(key, text(key), names)].second;
    }

    /// Names separated by commas; empty if not given.
    std::vector<std::string>
    list(const std::string &key) const;

    /// Position of `name` (all or part of what `key` holds) among the names allowed there.
    std::size_t
    name_index(const std::string &key, const std::string &name, const std::vector<std::string> &allowed) const;

  private:
    std::vector<double>
    components(const std::string &key, const std::string &part, const units::Quantity &quantity, std::size_t n) const;

    SceneParameters *parameters_;
    std::string      path_;
  };

  /// What follows `words` if the text starts with them.
  std::optional<std::string>
  text_after(const std::string &words, const std::string &text);

  /// Parts of a text between commas, blanks trimmed, empty ones dropped.
  std::vector<std::string>
  split_names(const std::string &text);
} // namespace whipple
