// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/expression.h>

#include <deal.II/base/function_parser.h>

#include <cctype>
#include <iostream>
#include <numbers>
#include <sstream>

namespace whipple
{
  class Expression::Parser : public dealii::FunctionParser<2>
  {
  };

  namespace
  {
    const char *
    coordinates(Symmetry symmetry)
    {
      return symmetry == Symmetry::planar ? "x,y" : "r,z";
    }

    std::string
    allowed(Symmetry symmetry)
    {
      return symmetry == Symmetry::planar ? "allowed is an expression in x, y and pi such as 0.1*sin(pi*y)"
                                          : "allowed is an expression in r, z and pi such as 0.1*sin(pi*z)";
    }

    /// Keeps from standard error what the parser prints there besides throwing.
    class QuietErrors
    {
    public:
      QuietErrors()
        : before_(std::cerr.rdbuf(sink_.rdbuf()))
      {
      }
      ~QuietErrors()
      {
        std::cerr.rdbuf(before_);
      }
      QuietErrors(const QuietErrors &) = delete;
      QuietErrors &
      operator=(const QuietErrors &) = delete;

    private:
      std::ostringstream sink_;
      std::streambuf    *before_;
    };

    /// What the parser has to say, out of deal.II's report of several lines.
    std::string
    parser_message(const std::string &report)
    {
      const std::string introduction = "The parser said:";
      const std::size_t begin        = report.find(introduction);
      if (begin == std::string::npos)
        return "cannot be read";
      std::istringstream words(
          report.substr(begin + introduction.size(), report.find("\n\n", begin) - begin - introduction.size()));
      std::string message;
      for (std::string word; words >> word;)
        message += (message.empty() ? "" : " ") + word;
      return message;
    }

    bool
    is_letter(char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    }

    /// What the parser would accept and nobody means.
    std::string
    slip(const std::string &text)
    {
      if (text.find_first_not_of(" \t") == std::string::npos)
        return "nothing stands there";
      int open = 0;
      for (std::size_t i = 0; i < text.size(); ++i)
        {
          const char before = i > 0 ? text[i - 1] : ' ', after = i + 1 < text.size() ? text[i + 1] : ' ';
          open += text[i] == '(' ? 1 : (text[i] == ')' ? -1 : 0);
          if (text[i] == ',' && open == 0)
            return "a ',' outside of brackets (components are separated by ';', decimals by '.')";
          if (text[i] == '=' && after != '=' && std::string("=<>!").find(before) == std::string::npos)
            return "'=' assigns; a comparison is '=='";
          if (text.compare(i, 4, "rand") == 0 && !is_letter(before))
            return "a random number is another one on every rank";
        }
      return "";
    }
  } // namespace

  Expression::Expression(const std::string &text, Symmetry symmetry, double unit, double coordinate_unit)
    : unit_(unit)
    , coordinate_unit_(coordinate_unit)
  {
    if (const std::string problem = slip(text); !problem.empty())
      throw InputError(problem + "; " + allowed(symmetry));
    const QuietErrors quiet;
    try
      {
        const auto parser = std::make_shared<Parser>();
        parser->initialize(coordinates(symmetry), text, {{"pi", std::numbers::pi}}, false);
        parser->value(dealii::Point<2>()); // reads the text
        parser_ = parser;
      }
    catch (const dealii::ExceptionBase &error)
      {
        throw InputError(parser_message(error.what()) + "; " + allowed(symmetry));
      }
  }

  double
  Expression::operator()(const Vector<2> &x) const
  {
    return unit_ * parser_->value(dealii::Point<2>(x[0] / coordinate_unit_, x[1] / coordinate_unit_));
  }
} // namespace whipple
