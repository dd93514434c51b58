// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/automatic_stages.h>
#include <whipple/scene/section.h>
#include <whipple/scene/units.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace whipple
{
  namespace
  {
    using Statements = std::vector<PrmStatement>;

    /// The statement that counts: the last one.
    const PrmStatement *
    find(const Statements &statements, const std::string &section, const std::string &key)
    {
      for (auto statement = statements.rbegin(); statement != statements.rend(); ++statement)
        if (statement->section == section && statement->key == key)
          return &*statement;
      return nullptr;
    }

    std::vector<std::string>
    listed(const Statements &statements, const std::string &section)
    {
      const PrmStatement *list = find(statements, section, "List");
      return list ? split_names(list->value) : std::vector<std::string>{};
    }

    struct PlateOfList
    {
      std::string name;
      double      front, rear; ///< cm along axis 1
    };

    double
    length(const Statements &statements, const std::string &section, const std::string &key)
    {
      const PrmStatement *statement = find(statements, section, key);
      if (!statement)
        throw InputError("", section + "/" + key, "",
                         "must be given; the automatic list of stages goes by the places of the plates");
      try
        {
          return units::parse(statement->value, units::length);
        }
      catch (const InputError &error)
        {
          throw InputError(statement->origin, statement->name(), statement->value, error.what());
        }
    }

    /// The plates along axis 1. @throws InputError if two overlap
    std::vector<PlateOfList>
    plates_in_order(const Statements &statements, const std::vector<std::string> &bodies)
    {
      std::vector<PlateOfList> plates;
      for (const std::string &name : bodies)
        {
          const std::string   section = "Bodies/" + name;
          const PrmStatement *shape   = find(statements, section, "Shape");
          if (!shape || shape->value != "plate")
            continue;
          const double front = length(statements, section, "Front face");
          plates.push_back({name, front, front + length(statements, section, "Thickness")});
        }
      std::sort(plates.begin(), plates.end(), [](const auto &a, const auto &b) { return a.front < b.front; });
      for (std::size_t k = 1; k < plates.size(); ++k)
        if (plates[k].front < plates[k - 1].rear)
          {
            const PrmStatement *face = find(statements, "Bodies/" + plates[k].name, "Front face");
            throw InputError(face->origin, face->name(), face->value,
                             "the plate overlaps '" + plates[k - 1].name +
                                 "'; allowed for the automatic list of stages is " +
                                 units::format(plates[k - 1].rear, units::length) + " or more");
          }
      return plates;
    }

    /// Statements of one stage.
    class Entries
    {
    public:
      Entries(Statements &to, const std::string &stage)
        : to_(to)
        , section_("Stages/" + stage)
      {
      }
      void
      set(const std::string &key, const std::string &value)
      {
        to_.push_back({"Stages/List = automatic", section_, key, value});
      }

    private:
      Statements &to_;
      std::string section_;
    };

    /// What an automatic list takes for all stages in which debris lands.
    constexpr std::array landing_keys{"Representation", "Hand-over", "Fragment size", "Fragment rings"};

    bool
    is_landing(const PrmStatement &statement)
    {
      return statement.section == "Stages" &&
             std::find(landing_keys.begin(), landing_keys.end(), statement.key) != landing_keys.end();
    }

    void
    append(std::string &list, const std::string &name)
    {
      list += (list.empty() ? "" : ", ") + name;
    }
  } // namespace

  void
  expand_automatic_stages(Statements &statements)
  {
    const PrmStatement *list = find(statements, "Stages", "List");
    if (!list || list->value != "automatic")
      return;
    const PrmStatement             asked  = *list;
    const std::vector<std::string> bodies = listed(statements, "Bodies");
    const auto                     plates = plates_in_order(statements, bodies);
    if (plates.empty())
      throw InputError(asked.origin, asked.name(), asked.value,
                       "no body of the scene has the shape 'plate'; allowed then is a list of stages");
    std::string first;
    for (const std::string &name : bodies)
      if (std::none_of(plates.begin(), plates.end(), [&](const auto &plate) { return plate.name == name; }))
        append(first, name);
    const std::vector<std::string> effects = listed(statements, "Effects");
    const bool has_sizes = std::find(effects.begin(), effects.end(), "fragment size") != effects.end();

    Statements landing, chain;
    std::copy_if(statements.begin(), statements.end(), std::back_inserter(landing), is_landing);
    std::erase_if(statements, is_landing);
    std::string names;
    for (std::size_t k = 0; k < plates.size(); ++k)
      {
        const bool        last   = k + 1 == plates.size();
        const std::string number = std::to_string(k + 1), stage = last ? "impact" : "perforation " + number;
        append(names, stage);
        Entries eulerian(chain, stage);
        eulerian.set("Mode", "eulerian");
        eulerian.set("Introduces", k == 0 && !first.empty() ? first + ", " + plates[k].name : plates[k].name);
        eulerian.set("End", last ? "until holes have settled and debris has reached " + plates[k].name
                                 : "until debris is free of " + plates[k].name);
        if (!last)
          eulerian.set("Plates measured", "settled");
        if (k > 0)
          {
            eulerian.set("Representation", has_sizes ? "fragments" : "distended");
            for (const PrmStatement &statement : landing)
              chain.push_back({statement.origin, "Stages/" + stage, statement.key, statement.value});
          }
        if (last)
          break;
        append(names, "debris " + number);
        Entries lagrangian(chain, "debris " + number);
        lagrangian.set("Mode", "lagrangian");
        lagrangian.set("Cohesion", "fragments");
        lagrangian.set("Debris behind", plates[k].name);
        lagrangian.set("End", "until leading edge reaches " + plates[k + 1].name);
      }
    for (PrmStatement &statement : statements)
      if (statement.section == "Stages" && statement.key == "List" && statement.value == "automatic")
        statement.value = names;
    statements.insert(statements.begin(), chain.begin(), chain.end());
  }
} // namespace whipple
