// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/json_value.h>
#include <whipple/output/version.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace whipple::summary
{
  namespace
  {
    constexpr int schema = 1;

    json::Json
    numbers(const std::map<std::string, double> &values)
    {
      json::Json json = json::Json::object();
      for (const auto &[name, value] : values)
        json[name] = json::value(value);
      return json;
    }

    /// Phases and what is left of the time.
    json::Json
    phases_of(const Performance &performance)
    {
      std::map<std::string, double> all  = performance.phases;
      double                        rest = performance.wall_s;
      for (const auto &[phase, seconds] : performance.phases)
        rest -= seconds;
      all["everything else"] = rest;
      return numbers(all);
    }

    json::Json
    json_of(const Stage &stage)
    {
      return {{"name", stage.name},
              {"mode", stage.mode},
              {"start_us", json::value(stage.start_us)},
              {"end_us", json::value(stage.end_us)},
              {"steps", stage.steps},
              {"active_cells_max", stage.active_cells_max},
              {"finest_equivalent_cells", json::value(stage.finest_equivalent_cells)},
              {"elements", json::value(stage.elements)},
              {"dropped_mass_g", json::value(stage.dropped_mass_g)},
              {"wall_s", json::value(stage.wall_s)},
              {"cpu_s", json::value(stage.cpu_s)},
              {"cell_steps", json::value(stage.cell_steps)},
              {"cell_steps_per_s_per_rank", json::value(stage.cell_steps_per_s_per_rank)},
              {"dt_limits", json::Json(stage.dt_limits)}};
    }

    json::Json
    json_of(const Balance &balance)
    {
      json::Json json = {{"initial", json::value(balance.initial)},
                         {"final", json::value(balance.final_value)},
                         {"left_domain", json::value(balance.left_domain)},
                         {"dropped", numbers(balance.dropped)},
                         {"closure_relative", json::value(balance.closure_relative)}};
      json.update(numbers(balance.extra));
      return json;
    }

    json::Json
    json_of(const Ledger &ledger)
    {
      json::Json bodies = json::Json::object();
      for (const auto &[body, quantities] : ledger.bodies)
        bodies[body] = numbers(quantities);
      return {{"mass_g", json_of(ledger.mass)},
              {"axial_momentum_g_cm_per_us", json_of(ledger.axial_momentum)},
              {"energy_Mbar_cm3", json_of(ledger.energy)},
              {"bodies", bodies}};
    }

    json::Json
    json_of(const std::map<std::string, std::map<std::string, Result>> &results)
    {
      json::Json json = json::Json::object();
      for (const auto &[place, quantities] : results)
        {
          json::Json &entry = json[place] = json::Json::object();
          for (const auto &[name, value] : quantities)
            entry[name] = json::value(value);
        }
      return json;
    }

    json::Json
    json_of(const std::map<std::string, Error> &errors)
    {
      if (errors.empty())
        return nullptr;
      json::Json json = json::Json::object();
      for (const auto &[field, error] : errors)
        json[field] = {{"L1", json::value(error.l1)},
                       {"L2", json::value(error.l2)},
                       {"Linf", json::value(error.linf)},
                       {"scale", json::value(error.scale)}};
      return json;
    }

    json::Json
    json_of(const std::map<std::string, std::map<std::string, ErrorBar>> &error_bars)
    {
      if (error_bars.empty())
        return nullptr;
      json::Json json = json::Json::object();
      for (const auto &[place, quantities] : error_bars)
        for (const auto &[name, bar] : quantities)
          json[place][name] = {{"error", json::value(bar.error)},
                               {"order", json::value(bar.order)},
                               {"extrapolated", json::value(bar.extrapolated)},
                               {"verdict", bar.verdict}};
      return json;
    }

    json::Json
    program()
    {
      return {{"version", version::number()}, {"commit", version::git_hash()}, {"build_type", version::build_type()}};
    }

    json::Json
    json_of(const std::map<std::string, Event> &events)
    {
      json::Json json = json::Json::object();
      for (const auto &[what, event] : events)
        json[what] = {{"number", json::value(event.number)}, {"size", json::value(event.size)}, {"unit", event.unit}};
      return json;
    }

    json::Json
    json_of(const std::map<std::string, Effect> &effects)
    {
      json::Json json = json::Json::object();
      for (const auto &[name, effect] : effects)
        json[name] = {{"on", effect.on}, {"number", json::value(effect.number)}, {"reason", effect.reason}};
      return json;
    }

    /// JSON text with each list of numbers on one line.
    std::string
    with_short_lists(const std::string &text)
    {
      std::string result;
      bool        quoted = false;
      for (std::size_t i = 0; i < text.size(); ++i)
        {
          const char  c   = text[i];
          std::size_t end = i; // of what is taken over as it is
          if (c == '"')
            quoted = !quoted;
          else if (quoted && c == '\\')
            ++end;
          else if (!quoted && c == '[')
            if (const std::size_t next = text.find_first_of("]{[\"", i + 1); text[next] == ']')
              {
                for (; i < next; ++i)
                  if (text[i] != '\n' && text[i] != ' ')
                    result += text[i] == ',' ? std::string(", ") : std::string(1, text[i]);
                end = i;
              }
          result.append(text, i, end - i + 1);
          i = end;
        }
      return result;
    }
  } // namespace

  std::string
  to_json(const Summary &summary)
  {
    json::Json stages = json::Json::array();
    for (const Stage &stage : summary.stages)
      stages.push_back(json_of(stage));
    const Performance &performance = summary.performance;
    const Counts      &counts      = summary.counts;
    const json::Json   json        = {{"schema", schema},
                                      {"program", program()},
                                      {"scene", summary.scene},
                                      {"status", summary.status},
                                      {"reason", summary.reason ? json::Json(*summary.reason) : json::Json(nullptr)},
                                      {"resumable", summary.resumable},
                                      {"stages", stages},
                                      {"ledger", json_of(summary.ledger)},
                                      {"results", json_of(summary.results)},
                                      {"error_bars", json_of(summary.error_bars)},
                                      {"errors", json_of(summary.errors)},
                                      {"performance",
                                       {{"wall_s", json::value(performance.wall_s)},
                                        {"cpu_s", json::value(performance.cpu_s)},
                                        {"peak_rss_bytes", json::value(performance.peak_rss_bytes)},
                                        {"ranks", performance.ranks},
                                        {"active_cell_steps", json::value(performance.active_cell_steps)},
                                        {"phases", phases_of(performance)}}},
                                      {"effects", json_of(summary.effects)},
                                      {"counts",
                                       {{"retries", counts.retries},
                                        {"releases", counts.releases},
                                        {"breaks", counts.breaks},
                                        {"rezones", counts.rezones},
                                        {"warnings", counts.warnings},
                                        {"events", json_of(counts.events)}}}};
    // names come from scene files: what is not UTF-8 in them must not cost a finished run its summary
    return with_short_lists(json.dump(2, ' ', false, json::Json::error_handler_t::replace)) + '\n';
  }

  void
  write(const Summary &summary, const std::string &directory)
  {
    const std::filesystem::path path      = std::filesystem::path(directory) / "summary.json",
                                temporary = path.string() + ".part";
    {
      std::ofstream file(temporary);
      if (!(file << to_json(summary) << std::flush))
        throw std::runtime_error(temporary.string() + ": cannot be written: " + std::strerror(errno));
    }
    std::filesystem::rename(temporary, path);
  }
} // namespace whipple::summary
