// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/config.h>
#include <deal.II/base/vectorization.h>

#include <whipple/error.h>
#include <whipple/output/duration.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/run_log.h>
#include <whipple/output/version.h>

#include <Trilinos_version.h>
#include <p4est_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace whipple
{
  namespace
  {
    constexpr double terminal_interval_live  = 0.2; // seconds; faster than the eye reads
    constexpr double terminal_interval_plain = 5.;
    constexpr double file_interval           = 10.;

    std::string
    mpi_version()
    {
      std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
      int                                              length = 0;
      MPI_Get_library_version(text.data(), &length);
      // "Open MPI v4.1.4, package: ..." and the like: what follows the first comma or line end is packaging
      const std::string version(text.data());
      return version.substr(0, version.find_first_of(",\n"));
    }

    std::string
    progress_line(const Progress &p)
    {
      std::array<char, 160> numbers;
      std::snprintf(numbers.data(), numbers.size(), ": step %ld, t = %.6g us, dt = %.3e us (", p.step, p.time,
                    p.time_step);
      std::string text(p.stage);
      text += numbers.data();
      text += p.limiter;
      text += "), " + std::to_string(p.cells) + " cells";
      if (std::isfinite(p.fraction))
        {
          std::snprintf(numbers.data(), numbers.size(), ", %.1f %%", 100. * p.fraction);
          text += numbers.data();
          if (std::isfinite(p.run_left))
            text += ", " + duration(p.run_left) + " left";
          else if (std::isfinite(p.stage_left))
            text += ", " + duration(p.stage_left) + " left of this stage";
        }
      return text;
    }

    /// "[########------------] " as far as the stage is done
    std::string
    progress_bar(double fraction)
    {
      constexpr int width = 20;
      if (!std::isfinite(fraction))
        return "";
      const int done = static_cast<int>(std::lround(width * std::clamp(fraction, 0., 1.)));
      return '[' + std::string(done, '#') + std::string(width - done, '-') + "] ";
    }

    /// Whether the user has said that he wants no colour on his terminal (https://no-color.org).
    bool
    wants_colour()
    {
      const char *refused = std::getenv("NO_COLOR");
      return !refused || !*refused;
    }
  } // namespace

  RunLog::RunLog(const std::string &directory, MPI_Comm communicator, bool live, Earlier earlier)
    : RunLog(directory, communicator, std::cout, live, live ? terminal_interval_live : terminal_interval_plain, earlier)
  {
  }

  RunLog::RunLog(const std::string &directory, MPI_Comm communicator, std::ostream &terminal, bool live,
                 double interval_seconds, Earlier earlier)
    : active_(is_first_rank(communicator))
    , communicator_(communicator)
    , terminal_(terminal)
    , live_(live)
    , interval_(interval_seconds)
    , start_(Clock::now())
  {
    on_first_rank<InputError>(communicator, [&] {
      const std::string path = directory + "/log.txt";
      file_.open(path, earlier == Earlier::kept ? std::ios::app : std::ios::trunc);
      if (!file_)
        throw InputError(path + ": cannot be written");
    });
  }

  RunLog::~RunLog()
  {
    if (live_width_ > 0)
      terminal_ << '\n' << std::flush;
  }

  double
  RunLog::wall_seconds() const
  {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

  void
  RunLog::line(std::string_view text)
  {
    line(text, text);
  }

  void
  RunLog::line(std::string_view text, std::string_view on_terminal)
  {
    file_ << text << '\n' << std::flush;
    if (live_width_ > 0)
      {
        // the line being refreshed makes room
        terminal_ << '\r' << std::string(live_width_, ' ') << '\r';
        live_width_ = 0;
      }
    terminal_ << on_terminal << '\n' << std::flush;
  }

  void
  RunLog::banner()
  {
    if (!active_)
      return;
    int ranks = 1;
    MPI_Comm_size(communicator_, &ranks);
    std::ostringstream text;
    text << "Whipple " << version::number() << " (" << version::git_hash() << "), " << version::build_type()
         << " build\n"
         << "deal.II " << DEAL_II_PACKAGE_VERSION << ", p4est " << P4EST_PACKAGE_VERSION << ", Trilinos "
         << TRILINOS_VERSION_STRING << ", " << mpi_version() << '\n'
         << ranks << (ranks == 1 ? " rank" : " ranks") << ", deal.II vectorises "
         << dealii::VectorizedArray<double>::size() << " double at a time";
    line(text.str());
  }

  void
  RunLog::info(std::string_view text)
  {
    if (active_)
      line(text);
  }

  void
  RunLog::warning(std::string_view text)
  {
    if (!active_)
      return;
    ++warnings_;
    const char *shown = live_ && wants_colour() ? "\033[33mwarning:\033[0m " : "warning: ";
    line("warning: " + std::string(text), shown + std::string(text));
  }

  void
  RunLog::progress(const Progress &progress)
  {
    if (!active_)
      return;
    const double now = wall_seconds();
    if (now < std::min(next_terminal_, next_file_))
      return;
    const std::string text = progress_line(progress);
    if (now >= next_file_)
      {
        file_ << text << '\n' << std::flush;
        next_file_ = now + file_interval;
      }
    if (now < next_terminal_)
      return;
    next_terminal_ = now + interval_;
    if (live_)
      {
        // spaces cover what a longer line left behind
        const std::string shown = progress_bar(progress.fraction) + text;
        terminal_ << '\r' << shown << std::string(live_width_ - std::min(live_width_, shown.size()), ' ') << std::flush;
        live_width_ = shown.size();
      }
    else
      terminal_ << text << '\n' << std::flush;
  }
} // namespace whipple
