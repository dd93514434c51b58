// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/summary.h>
#include <whipple/output/version.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace whipple::summary
{
  namespace
  {
    constexpr int schema = 1;

    /// Keys in the order they are written: a summary is also read by people.
    using Json = nlohmann::ordered_json;

    Json
    number(double value)
    {
      return std::isfinite(value) ? Json(value) : Json(nullptr);
    }

    Json
    number(const Number &value)
    {
      return value ? number(*value) : Json(nullptr);
    }

    Json
    number(const std::optional<long> &value)
    {
      return value ? Json(*value) : Json(nullptr);
    }

    Json
    numbers(const std::map<std::string, double> &values)
    {
      Json json = Json::object();
      for (const auto &[name, value] : values)
        json[name] = number(value);
      return json;
    }

    Json
    json_of(const Stage &stage)
    {
      return {{"name", stage.name},
              {"mode", stage.mode},
              {"start_us", number(stage.start_us)},
              {"end_us", number(stage.end_us)},
              {"steps", stage.steps},
              {"active_cells_max", stage.active_cells_max},
              {"finest_equivalent_cells", number(stage.finest_equivalent_cells)},
              {"elements", number(stage.elements)},
              {"wall_s", number(stage.wall_s)},
              {"cell_steps", number(stage.cell_steps)},
              {"cell_steps_per_s_per_rank", number(stage.cell_steps_per_s_per_rank)},
              {"dt_limits", Json(stage.dt_limits)}};
    }

    Json
    json_of(const Balance &balance)
    {
      Json json = {{"initial", number(balance.initial)},
                   {"final", number(balance.final_value)},
                   {"left_domain", number(balance.left_domain)},
                   {"dropped", numbers(balance.dropped)},
                   {"closure_relative", number(balance.closure_relative)}};
      json.update(numbers(balance.extra));
      return json;
    }

    Json
    json_of(const Ledger &ledger)
    {
      Json bodies = Json::object();
      for (const auto &[body, quantities] : ledger.bodies)
        bodies[body] = numbers(quantities);
      return {{"mass_g", json_of(ledger.mass)},
              {"axial_momentum_g_cm_per_us", json_of(ledger.axial_momentum)},
              {"energy_Mbar_cm3", json_of(ledger.energy)},
              {"bodies", bodies}};
    }

    struct ResultToJson
    {
      Json
      operator()(std::monostate) const
      {
        return nullptr;
      }
      Json
      operator()(double value) const
      {
        return number(value);
      }
      Json
      operator()(bool value) const
      {
        return value;
      }
      Json
      operator()(const std::string &value) const
      {
        return value;
      }
    };

    Json
    json_of(const std::map<std::string, std::map<std::string, Result>> &results)
    {
      Json json = Json::object();
      for (const auto &[place, quantities] : results)
        {
          Json &entry = json[place] = Json::object();
          for (const auto &[name, value] : quantities)
            entry[name] = std::visit(ResultToJson{}, value);
        }
      return json;
    }

    Json
    json_of(const std::map<std::string, Error> &errors)
    {
      if (errors.empty())
        return nullptr;
      Json json = Json::object();
      for (const auto &[field, error] : errors)
        json[field] = {{"L1", number(error.l1)},
                       {"L2", number(error.l2)},
                       {"Linf", number(error.linf)},
                       {"scale", number(error.scale)}};
      return json;
    }

    Json
    json_of(const std::map<std::string, std::map<std::string, ErrorBar>> &error_bars)
    {
      if (error_bars.empty())
        return nullptr;
      Json json = Json::object();
      for (const auto &[place, quantities] : error_bars)
        for (const auto &[name, bar] : quantities)
          json[place][name] = {{"error", number(bar.error)},
                               {"order", number(bar.order)},
                               {"extrapolated", number(bar.extrapolated)},
                               {"verdict", bar.verdict}};
      return json;
    }

    Json
    program()
    {
      return {{"version", version::number()}, {"commit", version::git_hash()}, {"build_type", version::build_type()}};
    }

    Json
    json_of(const std::map<std::string, Effect> &effects)
    {
      Json json = Json::object();
      for (const auto &[name, effect] : effects)
        json[name] = {{"on", effect.on}, {"number", number(effect.number)}, {"reason", effect.reason}};
      return json;
    }
  } // namespace

  std::string
  to_json(const Summary &summary)
  {
    Json stages = Json::array();
    for (const Stage &stage : summary.stages)
      stages.push_back(json_of(stage));
    const Performance &performance = summary.performance;
    const Counts      &counts      = summary.counts;
    const Json         json        = {{"schema", schema},
                                      {"program", program()},
                                      {"scene", summary.scene},
                                      {"status", summary.status},
                                      {"reason", summary.reason ? Json(*summary.reason) : Json(nullptr)},
                                      {"stages", stages},
                                      {"ledger", json_of(summary.ledger)},
                                      {"results", json_of(summary.results)},
                                      {"error_bars", json_of(summary.error_bars)},
                                      {"errors", json_of(summary.errors)},
                                      {"performance",
                                       {{"wall_s", number(performance.wall_s)},
                                        {"cpu_s", number(performance.cpu_s)},
                                        {"peak_rss_bytes", number(performance.peak_rss_bytes)},
                                        {"ranks", performance.ranks},
                                        {"active_cell_steps", number(performance.active_cell_steps)}}},
                                      {"effects", json_of(summary.effects)},
                                      {"counts",
                                       {{"retries", counts.retries},
                                        {"releases", counts.releases},
                                        {"rezones", counts.rezones},
                                        {"floors", counts.floors},
                                        {"warnings", counts.warnings}}}};
    // names come from scene files: what is not UTF-8 in them must not cost a finished run its summary
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
  }

  void
  write(const Summary &summary, const std::string &directory)
  {
    const std::filesystem::path path      = std::filesystem::path(directory) / "summary.json",
                                temporary = path.string() + ".part";
    {
      std::ofstream file(temporary);
      if (!(file << to_json(summary) << std::flush))
        throw std::runtime_error(temporary.string() + ": cannot be written");
    }
    std::filesystem::rename(temporary, path);
  }
} // namespace whipple::summary
