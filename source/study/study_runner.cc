// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/duration.h>
#include <whipple/study/child_run.h>
#include <whipple/study/study_directory.h>
#include <whipple/study/study_runner.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace whipple
{
  namespace
  {
    using namespace std::chrono_literals;

    std::string
    about(std::optional<double> seconds)
    {
      return seconds ? "about " + duration(*seconds) : "time not known yet";
    }

    /// Go on with a run that was ended.
    std::vector<std::string>
    words_to_go_on(const StudyPoint &point, const std::string &directory)
    {
      return {"run", "--resume", directory, "-n", std::to_string(point.ranks)};
    }

    std::vector<std::string>
    words_of(const StudyPlan &plan, const StudyPoint &point, const std::string &directory)
    {
      std::vector<std::string> words{
          "run", plan.section.scene_file, "-n", std::to_string(point.ranks), "--output", directory, "--overwrite"};
      for (const PrmStatement &statement : point.overrides)
        {
          words.push_back("--set");
          words.push_back(statement.name() + " = " + statement.value);
        }
      return words;
    }

    bool
    is_complete(const std::vector<std::optional<PointRecord>> &repeats)
    {
      return std::all_of(repeats.begin(), repeats.end(), [](const auto &record) { return record.has_value(); });
    }

    /// Last line that is not empty: what the program said when it ended.
    std::string
    last_words(const std::string &log)
    {
      std::ifstream file(log);
      std::string   line, last;
      while (std::getline(file, line))
        if (!line.empty())
          last = line;
      return last;
    }
  } // namespace

  StudyRunner::StudyRunner(const StudyOptions &options, std::ostream &output)
    : options_(options)
    , output_(output)
  {
  }

  void
  StudyRunner::refresh(const std::string &line)
  {
    if (!options_.live)
      return;
    output_ << '\r' << line << std::string(live_width_ - std::min(live_width_, line.size()), ' ') << std::flush;
    live_width_ = line.size();
  }

  void
  StudyRunner::say(const std::string &line)
  {
    refresh("");
    output_ << (options_.live ? "\r" : "") << line << '\n' << std::flush;
    live_width_ = 0;
  }

  void
  StudyRunner::learn(const StudyPlan &plan, const StudyPoint &point, const PointRecord &record)
  {
    if (record.completed() && record.cost.active_cell_steps > 0 && record.cost.wall_s > 0)
      forecast_.add(method_name(plan.section, point.choice),
                    {point.cell, record.cost.active_cell_steps, record.cost.wall_s});
  }

  std::optional<double>
  StudyRunner::forecast(const StudyPlan &plan, const StudyPoint &point) const
  {
    return forecast_.seconds(method_name(plan.section, point.choice), point.cell);
  }

  std::string
  StudyRunner::whole(const StudyPlan &plan, const std::vector<StudyPoint> &todo) const
  {
    double sum = 0;
    for (const StudyPoint &point : todo)
      {
        const auto seconds = forecast(plan, point);
        if (!seconds)
          return {};
        sum += plan.section.repeats * *seconds;
      }
    return "; all that is left: about " + duration(sum);
  }

  PointRecord
  StudyRunner::compute(const StudyPlan &plan, const StudyPoint &point, int repeat, const std::string &title)
  {
    const std::string directory = point_directory(options_.output_directory, point.label, repeat);
    const std::string log       = point_log(options_.output_directory, point.label, repeat);
    std::filesystem::create_directories(std::filesystem::path(directory).parent_path());
    const auto     expected    = forecast(plan, point);
    constexpr bool any_version = true; // it is this very program's
    std::string    ended;
    if (can_go_on(directory, point))
      {
        say("  goes on where it was ended");
        ended = wait_for(ChildRun(words_to_go_on(point, directory), log), title, expected);
        if (const auto record = find_record(directory, point, any_version))
          return *record;
        say("  could not go on (" + last_words(log) + "): begins anew");
      }
    ended = wait_for(ChildRun(words_of(plan, point, directory), log), title, expected);
    if (const auto record = find_record(directory, point, any_version))
      return *record;
    PointRecord record;
    record.program = this_program();
    record.reason  = ended + ": " + last_words(log);
    return record;
  }

  std::string
  StudyRunner::wait_for(ChildRun &&child, const std::string &title, std::optional<double> expected)
  {
    const auto start = std::chrono::steady_clock::now();
    auto       ended = child.ended();
    while (!ended)
      {
        std::this_thread::sleep_for(20ms);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        refresh(title + ": " + duration(seconds) + " of " + about(expected));
        ended = child.ended();
      }
    return *ended;
  }

  std::vector<StudyRunner::Repeats>
  StudyRunner::find(const StudyPlan &plan, const std::vector<StudyPoint> &points)
  {
    std::vector<Repeats> records;
    std::size_t          complete = 0;
    for (const StudyPoint &point : points)
      {
        Repeats &found = records.emplace_back(plan.section.repeats);
        for (int r = 0; r < plan.section.repeats; ++r)
          {
            found[r] =
                find_record(point_directory(options_.output_directory, point.label, r), point, options_.any_version);
            if (found[r])
              found[r]->reused = true;
          }
        if (!is_complete(found))
          continue;
        ++complete;
        learn(plan, point, median_record(found));
      }
    if (complete > 0)
      say(std::to_string(complete) + " of " + std::to_string(points.size()) + " points are there already");
    return records;
  }

  std::vector<PointOutcome>
  StudyRunner::run(const StudyPlan &plan, const std::vector<StudyPoint> &points)
  {
    std::vector<Repeats>    records = find(plan, points);
    std::vector<StudyPoint> todo;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!is_complete(records[i]))
        todo.push_back(points[i]);

    std::vector<PointOutcome> outcomes;
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        if (!is_complete(records[i]))
          {
            const std::string title =
                "point " + std::to_string(i + 1) + " of " + std::to_string(points.size()) + ", " + points[i].label;
            say(title + ": " + about(forecast(plan, points[i])) + whole(plan, todo));
            for (int r = 0; r < plan.section.repeats; ++r)
              if (!records[i][r])
                records[i][r] = compute(plan, points[i], r, title);
            const PointRecord record = median_record(records[i]);
            say("  " + (record.completed() ? "done in " + duration(record.cost.wall_s)
                                           : record.status + ": " + record.reason));
            learn(plan, points[i], record);
            todo.erase(todo.begin());
          }
        outcomes.push_back({points[i], median_record(records[i])});
      }
    return outcomes;
  }
} // namespace whipple
