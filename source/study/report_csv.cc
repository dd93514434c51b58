// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/study/report.h>

#include <cmath>
#include <set>
#include <sstream>

namespace whipple::report
{
  namespace
  {
    /// Quoted where the text needs it (RFC 4180).
    std::string
    quoted(const std::string &text)
    {
      if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
      std::string result = "\"";
      for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
      return result + '"';
    }

    std::string
    cell(double value)
    {
      constexpr int      all_digits = 17;
      std::ostringstream text;
      text.precision(all_digits);
      if (std::isfinite(value))
        text << value;
      return text.str();
    }

    struct ResultCell
    {
      std::string
      operator()(std::monostate) const
      {
        return {};
      }
      std::string
      operator()(double value) const
      {
        return cell(value);
      }
      std::string
      operator()(bool value) const
      {
        return value ? "true" : "false";
      }
      std::string
      operator()(const std::string &value) const
      {
        return quoted(value);
      }
      /// Numbers with spaces between them.
      std::string
      operator()(const std::vector<double> &values) const
      {
        std::string text;
        for (const double value : values)
          text += (text.empty() ? "" : " ") + cell(value);
        return text;
      }
    };

    using Names = std::set<std::pair<std::string, std::string>>;

    /// All (place, name) that some point has in one of its tables.
    template <typename Table>
    Names
    columns(const StudyReport &report, Table PointRecord::*table)
    {
      Names names;
      for (const PointOutcome &outcome : report.outcomes)
        for (const auto &[place, entries] : outcome.record.*table)
          for (const auto &[name, value] : entries)
            names.insert({place, name});
      return names;
    }

    std::string
    row(const StudyReport &report, const PointOutcome &outcome, const Names &errors, const Names &results)
    {
      const PointRecord &record = outcome.record;
      std::ostringstream text;
      text << quoted(outcome.point.label);
      for (std::size_t a = 0; a < outcome.point.choice.size(); ++a)
        text << ',' << quoted(report.plan.section.axes[a].values[outcome.point.choice[a]].label);
      text << ',' << cell(outcome.point.cell) << ',' << outcome.point.ranks << ',' << record.status << ','
           << quoted(record.reason) << ',' << cell(record.cost.wall_s) << ',' << cell(record.cost.cpu_s) << ','
           << record.cost.repeats << ',' << record.cost.steps << ',' << cell(record.cost.active_cell_steps) << ','
           << cell(record.cost.peak_rss_bytes) << ',' << cell(record.losses.energy_lost) << ','
           << cell(record.losses.energy_dropped) << ',' << cell(record.losses.mass_dropped) << ','
           << cell(record.losses.energy_closure);
      for (const auto &[field, norm] : errors)
        {
          const auto entry = record.errors.find(field);
          const bool there = entry != record.errors.end() && entry->second.contains(norm);
          text << ',' << (there ? cell(entry->second.at(norm)) : "");
        }
      for (const auto &[place, name] : results)
        {
          const auto table = record.results.find(place);
          const bool there = table != record.results.end() && table->second.contains(name);
          text << ',' << (there ? std::visit(ResultCell{}, table->second.at(name)) : "");
        }
      return text.str();
    }
  } // namespace

  std::string
  csv(const StudyReport &report)
  {
    const Names errors = columns(report, &PointRecord::errors), results = columns(report, &PointRecord::results);
    std::string text = "point";
    for (const StudyAxis &axis : report.plan.section.axes)
      text += ',' + quoted(axis.name);
    text += ",cell_cm,ranks,status,reason,wall_s,cpu_s,repeats,steps,active_cell_steps,peak_rss_bytes,energy_lost_part,"
            "energy_dropped_part,mass_dropped_part,energy_closure";
    for (const auto &[field, norm] : errors)
      text += ',' + quoted("error " + field + ' ' + norm);
    for (const auto &[place, name] : results)
      text += ',' + quoted(place + '/' + name);
    text += '\n';
    for (const PointOutcome &outcome : report.outcomes)
      text += row(report, outcome, errors, results) + '\n';
    return text;
  }
} // namespace whipple::report
