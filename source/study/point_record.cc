// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/version.h>
#include <whipple/study/point_record.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace whipple
{
  namespace
  {
    namespace fs = std::filesystem;
    using Json   = nlohmann::json;

    std::string
    program_name(const std::string &number, const std::string &commit, const std::string &build_type)
    {
      return number + " (" + commit + "), " + build_type;
    }

    /// Null counts as 0.
    double
    value(const Json &json)
    {
      return json.is_number() ? json.get<double>() : 0.;
    }

    double
    sum(const Json &object)
    {
      double total = 0;
      for (const auto &[name, amount] : object.items())
        total += value(amount);
      return total;
    }

    double
    part(double amount, double whole)
    {
      return whole != 0 ? amount / whole : 0.;
    }

    PointLosses
    losses(const Json &ledger)
    {
      const Json  &energy = ledger.at("energy_Mbar_cm3"), &mass = ledger.at("mass_g");
      const double initial = value(energy.at("initial"));
      double       lost    = 0;
      for (const char *cause : {"remap_loss", "regrid_loss", "projection_loss", "released_fragments_loss"})
        lost += value(energy.value(cause, Json(nullptr)));
      PointLosses result;
      result.energy_lost    = part(lost, initial);
      result.energy_dropped = part(sum(energy.at("dropped")), initial);
      result.mass_dropped   = part(sum(mass.at("dropped")), value(mass.at("initial")));
      result.energy_closure = value(energy.at("closure_relative"));
      return result;
    }

    PointCost
    cost(const Json &json)
    {
      const Json &performance = json.at("performance");
      PointCost   result;
      result.wall_s            = value(performance.at("wall_s"));
      result.cpu_s             = value(performance.at("cpu_s"));
      result.peak_rss_bytes    = value(performance.at("peak_rss_bytes"));
      result.active_cell_steps = value(performance.at("active_cell_steps"));
      for (const Json &stage : json.at("stages"))
        result.steps += stage.at("steps").get<long>();
      return result;
    }

    summary::Result
    result_of(const Json &json)
    {
      if (json.is_boolean())
        return json.get<bool>();
      if (json.is_number())
        return json.get<double>();
      if (json.is_string())
        return json.get<std::string>();
      if (json.is_array())
        {
          std::vector<double> numbers;
          for (const Json &number : json)
            numbers.push_back(value(number));
          return numbers;
        }
      return std::monostate{};
    }

    PointRecord
    record_of(const Json &json)
    {
      PointRecord record;
      const Json &program = json.at("program");
      record.program      = program_name(program.at("version"), program.at("commit"), program.at("build_type"));
      record.status       = json.at("status");
      if (json.at("reason").is_string())
        record.reason = json.at("reason");
      record.cost   = cost(json);
      record.losses = losses(json.at("ledger"));
      for (const auto &[place, quantities] : json.at("results").items())
        for (const auto &[quantity, entry] : quantities.items())
          record.results[place][quantity] = result_of(entry);
      if (json.at("errors").is_object())
        for (const auto &[field, norms] : json.at("errors").items())
          for (const auto &[norm, entry] : norms.items())
            if (entry.is_number())
              record.errors[field][norm] = entry.get<double>();
      return record;
    }

    std::string
    text_of(const fs::path &file)
    {
      std::ifstream      input(file);
      std::ostringstream text;
      text << input.rdbuf();
      return text.str();
    }

    bool
    same_version(const std::string &program, const fs::path &file)
    {
      return program == this_program() && (version::git_hash().find("-dirty") == std::string_view::npos ||
                                           fs::last_write_time(file) > fs::last_write_time("/proc/self/exe"));
    }

    double
    median(std::vector<double> values)
    {
      std::sort(values.begin(), values.end());
      const std::size_t half = values.size() / 2;
      return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
    }
  } // namespace

  std::optional<double>
  PointRecord::number(const std::string &place, const std::string &quantity) const
  {
    const auto table = results.find(place);
    if (table == results.end())
      return std::nullopt;
    const auto entry = table->second.find(quantity);
    if (entry == table->second.end() || !std::holds_alternative<double>(entry->second))
      return std::nullopt;
    return std::get<double>(entry->second);
  }

  std::string
  this_program()
  {
    return program_name(std::string(version::number()), std::string(version::git_hash()),
                        std::string(version::build_type()));
  }

  std::optional<PointRecord>
  find_record(const std::string &directory, const StudyPoint &point, bool any_version)
  {
    const fs::path file = fs::path(directory) / "summary.json";
    std::ifstream  input(file);
    if (!input || text_of(fs::path(directory) / "parameters.prm") != point.effective_parameters)
      return std::nullopt;
    try
      {
        const Json        json   = Json::parse(input);
        const PointRecord record = record_of(json);
        if (json.at("performance").at("ranks").get<int>() != point.ranks ||
            !(any_version || same_version(record.program, file)) || json.value("resumable", false))
          return std::nullopt;
        return record;
      }
    catch (const Json::exception &)
      {
        return std::nullopt; // written by a version that knew other keys
      }
  }

  bool
  can_go_on(const std::string &directory, const StudyPoint &point)
  {
    std::error_code failure;
    return text_of(fs::path(directory) / "parameters.prm") == point.effective_parameters &&
           !fs::is_empty(fs::path(directory) / "checkpoints", failure) && !failure;
  }

  PointRecord
  median_record(const std::vector<std::optional<PointRecord>> &repeats)
  {
    const auto failed =
        std::find_if(repeats.begin(), repeats.end(), [](const auto &repeat) { return !repeat->completed(); });
    PointRecord         record = failed == repeats.end() ? *repeats.front() : **failed;
    std::vector<double> wall, cpu;
    for (const auto &repeat : repeats)
      {
        wall.push_back(repeat->cost.wall_s);
        cpu.push_back(repeat->cost.cpu_s);
        record.reused = record.reused && repeat->reused;
      }
    record.cost.wall_s  = median(wall);
    record.cost.cpu_s   = median(cpu);
    record.cost.repeats = static_cast<int>(repeats.size());
    return record;
  }
} // namespace whipple
