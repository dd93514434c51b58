// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/units.h>
#include <whipple/study/quantity_name.h>
#include <whipple/study/tolerance.h>

#include <algorithm>
#include <set>

namespace whipple
{
  namespace
  {
    struct Candidate
    {
      std::string           name; ///< as listed in messages
      std::set<std::string> words;
      Quantity              quantity;
    };

    std::set<std::string>
    word_set(const std::string &name)
    {
      const std::vector<std::string> words = words_of_name(name);
      return {words.begin(), words.end()};
    }

    std::vector<Candidate>
    candidates(const StudyPlan &plan)
    {
      std::vector<Candidate> all;
      if (plan.has_exact_solution)
        {
          for (const char *field : {"density", "velocity", "pressure", "energy"})
            for (const char *norm : {"L1", "L2", "Linf"})
              all.push_back(
                  {std::string(field) + ' ' + norm, word_set(std::string(field) + ' ' + norm), {true, field, norm}});
          all.push_back({"shock position", word_set("shock position"), {true, "shock position", "distance"}});
        }
      for (const auto &[place, table] : plan.results)
        for (const auto &[quantity, value] : table)
          {
            if (std::holds_alternative<bool>(value))
              continue; // a verdict has no error
            const std::string name = place + ' ' + split_quantity(quantity).words;
            all.push_back({name, word_set(name), {false, place, quantity}});
          }
      return all;
    }

    std::string
    names(const std::vector<const Candidate *> &all)
    {
      std::string text;
      for (const Candidate *candidate : all)
        text += (text.empty() ? "" : ", ") + candidate->name;
      return text;
    }

    /// The one that has exactly these words; else the only one that has them among others; else, of errors, L1.
    const Candidate &
    find(const std::vector<Candidate> &all, const std::string &name, const std::string &text)
    {
      const std::set<std::string>    words = word_set(name);
      std::vector<const Candidate *> fitting, everything;
      for (const Candidate &candidate : all)
        {
          everything.push_back(&candidate);
          if (!words.empty() &&
              std::includes(candidate.words.begin(), candidate.words.end(), words.begin(), words.end()))
            fitting.push_back(&candidate);
        }
      for (const Candidate *candidate : fitting)
        if (candidate->words == words || (candidate->quantity.exact && candidate->quantity.name == "L1"))
          return *candidate;
      if (fitting.size() == 1)
        return *fitting.front();
      if (fitting.empty())
        throw InputError("command line", "--tolerance", text,
                         all.empty() ? "the scene has no results" : "no such result; allowed are " + names(everything));
      throw InputError("command line", "--tolerance", text, "may mean any of " + names(fitting) + "; say which");
    }

    std::string
    trim(const std::string &text)
    {
      const std::size_t first = text.find_first_not_of(" \t");
      return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
    }
  } // namespace

  Tolerance
  read_tolerance(const std::string &text, const StudyPlan &plan)
  {
    const std::size_t equals = text.find('=');
    const std::string name   = trim(text.substr(0, equals));
    const std::string amount = equals == std::string::npos ? "" : trim(text.substr(equals + 1));
    if (name.empty() || amount.empty())
      throw InputError("command line", "--tolerance", text, "write 'RESULT = 2 %' or 'RESULT = 0.02 cm'");
    const std::vector<Candidate> all = candidates(plan);
    Tolerance                    tolerance;
    tolerance.text         = text;
    tolerance.quantity     = find(all, name, text).quantity;
    tolerance.relative     = amount.back() == '%';
    const std::string unit = tolerance.quantity.unit();
    try
      {
        tolerance.amount = tolerance.relative ? units::parse(amount, units::number) : parse_in_unit(amount, unit);
      }
    catch (const InputError &error)
      {
        throw InputError("command line", "--tolerance", text, error.what());
      }
    if (!(tolerance.amount > 0))
      throw InputError("command line", "--tolerance", text,
                       "must be > 0; allowed is a part such as 2 %" +
                           (unit.empty() ? std::string() : ", or an amount in units such as " + unit));
    return tolerance;
  }

  double
  read_budget(const std::string &text)
  {
    const auto fail = [&]() -> double {
      throw InputError("command line", "--budget", text, "allowed is a time > 0 such as '90 s', '20 min' or '1.5 h'");
    };
    std::size_t  end    = 0;
    const double number = [&] {
      try
        {
          return std::stod(text, &end);
        }
      catch (const std::exception &)
        {
          return fail();
        }
    }();
    const std::string unit = trim(text.substr(end));
    for (const auto &[name, seconds] : {std::pair{"s", 1.}, {"min", 60.}, {"h", 3600.}})
      if (unit == name && number > 0 && number * seconds < 1e9)
        return number * seconds;
    return fail();
  }
} // namespace whipple
