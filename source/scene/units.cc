// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/units.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace whipple::units
{
  namespace
  {
    /// multiple * 10^exponent in internal units.
    struct Unit
    {
      const char *symbol;
      int         multiple;
      int         exponent;
      Dimension   dimension;
    };

    constexpr Dimension force{1, 1, -2, 0};

    constexpr std::array unit_table{
        Unit{"km", 1, 5, length.dimension},
        Unit{"m", 1, 2, length.dimension},
        Unit{"cm", 1, 0, length.dimension},
        Unit{"mm", 1, -1, length.dimension},
        Unit{"um", 1, -4, length.dimension},
        Unit{"in", 254, -2, length.dimension},
        Unit{"kg", 1, 3, {0, 1, 0, 0}},
        Unit{"g", 1, 0, {0, 1, 0, 0}},
        Unit{"mg", 1, -3, {0, 1, 0, 0}},
        Unit{"h", 36, 8, time.dimension},
        Unit{"min", 6, 7, time.dimension},
        Unit{"s", 1, 6, time.dimension},
        Unit{"ms", 1, 3, time.dimension},
        Unit{"us", 1, 0, time.dimension},
        Unit{"ns", 1, -3, time.dimension},
        Unit{"K", 1, 0, temperature.dimension},
        Unit{"N", 1, -7, force},
        Unit{"dyn", 1, -12, force},
        Unit{"Pa", 1, -11, pressure.dimension},
        Unit{"kPa", 1, -8, pressure.dimension},
        Unit{"MPa", 1, -5, pressure.dimension},
        Unit{"GPa", 1, -2, pressure.dimension},
        Unit{"TPa", 1, 1, pressure.dimension},
        Unit{"bar", 1, -6, pressure.dimension},
        Unit{"kbar", 1, -3, pressure.dimension},
        Unit{"Mbar", 1, 0, pressure.dimension},
        Unit{"J", 1, -5, energy.dimension},
        Unit{"kJ", 1, -2, energy.dimension},
        Unit{"MJ", 1, 1, energy.dimension},
        Unit{"erg", 1, -12, energy.dimension},
        Unit{"W", 1, -11, {2, 1, -3, 0}},
        Unit{"deg", 1, 0, angle.dimension},
        Unit{"%", 1, -2, number.dimension},
    };

    bool
    same_letters(std::string_view a, std::string_view b)
    {
      if (a.size() != b.size())
        return false;
      for (std::size_t i = 0; i < a.size(); ++i)
        if (std::tolower(static_cast<unsigned char>(a[i])) != std::tolower(static_cast<unsigned char>(b[i])))
          return false;
      return true;
    }

    /// A text as a message of one line can hold it: control characters (a table's attribute may have any) as blanks.
    std::string
    quoted(std::string_view text)
    {
      std::string result = "'" + std::string(text) + "'";
      for (char &c : result)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
          c = ' ';
      return result;
    }

    const Unit &
    find_unit(std::string_view symbol)
    {
      for (const std::string_view micro : {"\u00b5", "\u03bc"}) // the sign and the Greek letter
        if (symbol.starts_with(micro))
          return find_unit("u" + std::string(symbol.substr(micro.size())));
      for (const Unit &unit : unit_table)
        if (symbol == unit.symbol)
          return unit;
      std::string near, all;
      for (const Unit &unit : unit_table)
        {
          all += (all.empty() ? "" : " ") + std::string(unit.symbol);
          if (same_letters(symbol, unit.symbol))
            near += (near.empty() ? " (did you mean '" : "' or '") + std::string(unit.symbol);
        }
      throw InputError("unknown unit " + quoted(symbol) + (near.empty() ? "" : near + "'?)") + "; units are " + all);
    }

    /// Product of powers of units: (numerator / denominator) * 10^exponent.
    struct Scale
    {
      double    numerator = 1, denominator = 1;
      int       exponent = 0;
      Dimension dimension;

      void
      multiply(const Scale &factor, int power)
      {
        for (int i = 0; i < std::abs(power); ++i)
          {
            numerator *= power > 0 ? factor.numerator : factor.denominator;
            denominator *= power > 0 ? factor.denominator : factor.numerator;
          }
        exponent += power * factor.exponent;
        dimension.length += power * factor.dimension.length;
        dimension.mass += power * factor.dimension.mass;
        dimension.time += power * factor.dimension.time;
        dimension.temperature += power * factor.dimension.temperature;
        dimension.angle += power * factor.dimension.angle;
      }
    };

    /// Reads a unit by recursive descent.
    class UnitReader
    {
    public:
      explicit UnitReader(std::string_view text)
        : text_(text)
      {
      }

      Scale
      read()
      {
        const Scale scale = product();
        if (at_ < text_.size())
          fail();
        return scale;
      }

    private:
      [[noreturn]] void
      fail() const
      {
        throw InputError("unit " + quoted(text_) + " cannot be read; write units like cm, km/s, g/cm^3, J/(kg K)");
      }

      /// Powers of powers stay small enough that the next one does not overflow.
      void
      check(const Scale &scale) const
      {
        constexpr int    largest = 1000;
        const Dimension &d       = scale.dimension;
        for (const int power : {scale.exponent, d.length, d.mass, d.time, d.temperature, d.angle})
          if (std::abs(power) > largest)
            fail();
      }

      void
      skip_blanks()
      {
        while (at_ < text_.size() && text_[at_] == ' ')
          ++at_;
      }

      bool
      accept(char c)
      {
        skip_blanks();
        if (at_ == text_.size() || text_[at_] != c)
          return false;
        ++at_;
        return true;
      }

      Scale
      product()
      {
        Scale scale = factor();
        for (skip_blanks(); at_ < text_.size() && text_[at_] != ')'; skip_blanks())
          {
            const int sign = accept('/') ? -1 : 1;
            if (sign > 0)
              accept('*');
            scale.multiply(factor(), sign);
            check(scale);
          }
        return scale;
      }

      Scale
      factor()
      {
        constexpr int deepest = 8;
        Scale         base;
        if (accept('('))
          {
            if (++depth_ > deepest)
              fail();
            base = product();
            if (!accept(')'))
              fail();
            --depth_;
          }
        else
          base = symbol();
        Scale scale;
        scale.multiply(base, accept('^') ? power() : 1);
        check(scale);
        return scale;
      }

      Scale
      symbol()
      {
        skip_blanks();
        const std::size_t begin = at_;
        while (at_ < text_.size() && std::string_view(" */^()").find(text_[at_]) == std::string_view::npos)
          ++at_;
        if (at_ == begin)
          fail();
        const Unit &unit = find_unit(text_.substr(begin, at_ - begin));
        return {static_cast<double>(unit.multiple), 1, unit.exponent, unit.dimension};
      }

      int
      power()
      {
        int         value     = 0;
        const char *end       = text_.data() + text_.size();
        const auto [rest, ec] = std::from_chars(text_.data() + at_, end, value);
        if (ec != std::errc{} || value == 0 || std::abs(value) > 9)
          fail();
        at_ = rest - text_.data();
        return value;
      }

      std::string_view text_;
      std::size_t      at_    = 0;
      int              depth_ = 0; ///< open brackets
    };

    std::string_view
    trim(std::string_view text)
    {
      while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.remove_prefix(1);
      while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
        text.remove_suffix(1);
      return text;
    }

    /// "a length such as 0.081 cm"
    std::string
    wanted(const Quantity &quantity)
    {
      return std::string("a ") + quantity.name + " such as " + quantity.example;
    }

    /// digits * 10^exponent, correctly rounded: the shift goes into the decimal exponent before conversion.
    double
    shifted(const std::string &digits, int exponent)
    {
      const std::size_t e        = digits.find_first_of("eE");
      const std::string mantissa = digits.substr(0, e);
      int               written  = 0;
      if (e != std::string::npos)
        {
          constexpr int largest = 1'000'000; // no double reaches it; sums of exponents stay far from overflow
          const char   *begin   = digits.c_str() + e + 1;
          const auto read = std::from_chars(*begin == '+' ? begin + 1 : begin, digits.c_str() + digits.size(), written);
          if (read.ec != std::errc{} || std::abs(written) > largest)
            return std::nan("");
        }
      const std::string decimal = mantissa + "e" + std::to_string(written + exponent);
      double            value   = 0;
      const char       *begin   = decimal.c_str();
      const auto [rest, ec]     = std::from_chars(*begin == '+' ? begin + 1 : begin, begin + decimal.size(), value);
      return ec == std::errc{} ? value : std::nan("");
    }
  } // namespace

  const Quantity *
  find_quantity(std::string_view name)
  {
    static constexpr const Quantity *all[] = {
        &number, &length,         &time,        &velocity,      &density,      &pressure,         &specific_energy,
        &energy, &void_rate,      &temperature, &specific_heat, &conductivity, &inverse_pressure, &inverse_temperature,
        &rate,   &surface_energy, &angle};
    for (const Quantity *quantity : all)
      if (name == quantity->name)
        return quantity;
    return nullptr;
  }

  double
  parse(std::string_view text, const Quantity &quantity)
  {
    text = trim(text);
    // the number is the longest prefix that reads as one
    const std::string_view unsigned_text = text.substr(!text.empty() && text.front() == '+' ? 1 : 0);
    double                 unused        = 0;
    const auto [rest, ec] = std::from_chars(unsigned_text.data(), unsigned_text.data() + unsigned_text.size(), unused);
    if (ec == std::errc::invalid_argument || (ec == std::errc{} && !std::isfinite(unused)))
      throw InputError("not a number with its unit; allowed is " + wanted(quantity));
    const std::string      digits(unsigned_text.data(), rest);
    const std::string_view unit = trim(unsigned_text.substr(digits.size()));

    const Scale scale = unit.empty() ? Scale{} : UnitReader(unit).read();
    if (unit.empty() && quantity.dimension != Dimension{})
      throw InputError("the unit is missing; allowed is " + wanted(quantity));
    if (scale.dimension != quantity.dimension)
      throw InputError(quoted(unit) + " is not a unit of " + quantity.name + "; allowed is " + wanted(quantity));
    const double value = shifted(digits, scale.exponent) * scale.numerator / scale.denominator;
    if (!std::isfinite(value))
      throw InputError("the number is too large or too small; allowed is " + wanted(quantity));
    return value;
  }

  std::vector<double>
  parse_list(std::string_view text, const Quantity &quantity, std::size_t components)
  {
    std::vector<double> values;
    for (std::size_t begin = 0; begin <= text.size();)
      {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        values.push_back(parse(text.substr(begin, comma - begin), quantity));
        begin = comma + 1;
      }
    if (values.size() != components)
      throw InputError("allowed are " + std::to_string(components) + " components separated by commas, each " +
                       wanted(quantity));
    return values;
  }

  std::string
  format(double value, const Quantity &quantity)
  {
    std::array<char, 32> buffer;
    const auto [end, ec] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    std::string text(buffer.data(), end);
    if (*quantity.unit)
      text += std::string(" ") + quantity.unit;
    return text;
  }

  std::vector<std::string>
  symbols()
  {
    std::vector<std::string> all;
    for (const Unit &unit : unit_table)
      all.emplace_back(unit.symbol);
    return all;
  }
} // namespace whipple::units
