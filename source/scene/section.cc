// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/nearest_name.h>
#include <whipple/scene/plausible.h>
#include <whipple/scene/section.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace whipple
{
  SceneSection::SceneSection(SceneParameters &parameters, std::string path)
    : parameters_(&parameters)
    , path_(std::move(path))
  {
  }

  void
  SceneSection::declare(const std::string &key, const std::string &default_value, const std::string &documentation)
  {
    parameters_->declare(path_, key, default_value, documentation);
  }

  std::string
  SceneSection::text(const std::string &key) const
  {
    return parameters_->get(path_, key);
  }

  void
  SceneSection::reject(const std::string &key, const std::string &allowed) const
  {
    parameters_->reject(path_, key, allowed);
  }

  void
  SceneSection::replace(const std::string &key, const std::string &value) const
  {
    parameters_->replace(path_, key, value);
  }

  double
  SceneSection::quantity(const std::string &key, const units::Quantity &quantity) const
  {
    return parse(key, text(key), quantity);
  }

  double
  SceneSection::positive(const std::string &key, const units::Quantity &what) const
  {
    const double value = quantity(key, what);
    if (!(value > 0))
      reject(key, std::string("must be > 0; allowed is a ") + what.name + " such as " + what.example);
    return value;
  }

  double
  SceneSection::non_negative(const std::string &key, const units::Quantity &what) const
  {
    const double value = quantity(key, what);
    if (!(value >= 0))
      reject(key, std::string("must be >= 0; allowed is a ") + what.name + " such as " + what.example);
    return value;
  }

  double
  SceneSection::between(const std::string &key, const units::Quantity &what, double lower, double upper) const
  {
    const double value = quantity(key, what);
    if (!(value >= lower && value <= upper))
      reject(key, "out of range; allowed is " + units::format(lower, what) + " to " + units::format(upper, what));
    return value;
  }

  std::optional<double>
  SceneSection::optional_positive(const std::string &key, const units::Quantity &what) const
  {
    if (text(key) == "none")
      return std::nullopt;
    return positive(key, what);
  }

  SectionInput
  SceneSection::input() const
  {
    SectionInput input;
    input.text    = [this](const std::string &key) { return text(key); };
    input.integer = [this](const std::string &key, int low, int high) { return integer(key, low, high); };
    input.number  = [this](const std::string &key, double low, double high) {
      return between(key, units::number, low, high);
    };
    input.length = [this](const std::string &key) { return positive(key, units::length); };
    input.choice = [this](const std::string &key, const std::vector<std::string> &allowed) {
      return name_index(key, text(key), allowed);
    };
    return input;
  }

  int
  SceneSection::integer(const std::string &key, int lower, int upper) const
  {
    const std::string value  = text(key);
    int               number = 0;
    const char       *end    = value.data() + value.size();
    const auto [rest, ec]    = std::from_chars(value.data(), end, number);
    if (ec != std::errc{} || rest != end || number < lower || number > upper)
      reject(key, "allowed is a whole number from " + std::to_string(lower) + " to " + std::to_string(upper));
    return number;
  }

  std::vector<std::string>
  SceneSection::list(const std::string &key) const
  {
    return split_names(text(key));
  }

  std::size_t
  SceneSection::name_index(const std::string &key, const std::string &name,
                           const std::vector<std::string> &allowed) const
  {
    const auto found = std::find(allowed.begin(), allowed.end(), name);
    if (found == allowed.end())
      reject(key, (name.empty() ? "must be given; " : "unknown '" + name + "'; ") + name_choices(name, allowed));
    return found - allowed.begin();
  }

  std::vector<double>
  SceneSection::components(const std::string &key, const std::string &part, const units::Quantity &what,
                           std::size_t n) const
  {
    if (part.empty())
      reject(key, std::string("must be given; allowed is ") + (n > 1 ? std::to_string(n) + " times " : "") + "a " +
                      what.name + " such as " + what.example);
    std::vector<double> values;
    try
      {
        values = units::parse_list(part, what, n);
      }
    catch (const InputError &error)
      {
        reject(key, error.what());
      }
    const double largest = plausible::largest(what);
    for (const double value : values)
      if (!(std::abs(value) <= largest))
        reject(key, std::string("too large; allowed is a ") + what.name + " such as " + what.example + ", at most " +
                        units::format(largest, what));
    return values;
  }

  std::optional<std::string>
  text_after(const std::string &words, const std::string &text)
  {
    if (text.compare(0, words.size(), words) != 0 || (text.size() > words.size() && text[words.size()] != ' '))
      return std::nullopt;
    const std::size_t first = text.find_first_not_of(' ', words.size());
    return first == std::string::npos ? "" : text.substr(first);
  }

  std::vector<std::string>
  split_names(const std::string &text)
  {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin < text.size();)
      {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        const std::size_t first = text.find_first_not_of(' ', begin);
        if (first < comma)
          names.push_back(text.substr(first, text.find_last_not_of(' ', comma - 1) - first + 1));
        begin = comma + 1;
      }
    return names;
  }
} // namespace whipple
