// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/first_rank.h>
#include <whipple/run/checkpoint_store.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <sstream>

namespace whipple
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr int kept = 2;

    std::string
    name_of(int number)
    {
      char text[16];
      std::snprintf(text, sizeof text, "%06d", number);
      return text;
    }

    /// Numbers of the checkpoints in a directory, newest first; what has another name is none.
    std::vector<int>
    numbers_in(const fs::path &directory)
    {
      std::vector<int> numbers;
      std::error_code  failure;
      for (const auto &entry : fs::directory_iterator(directory, failure))
        {
          const std::string name   = entry.path().filename().string();
          int               number = 0;
          const auto        end    = std::from_chars(name.data(), name.data() + name.size(), number).ptr;
          if (end == name.data() + name.size() && name == name_of(number))
            numbers.push_back(number);
        }
      std::sort(numbers.rbegin(), numbers.rend());
      return numbers;
    }

    fs::path
    all_of(const std::string &directory)
    {
      return fs::path(directory) / "checkpoints";
    }
  } // namespace

  template <int dim>
  CheckpointStore<dim>::CheckpointStore(const std::string &directory, const FieldLayout &layout,
                                        const std::string &parameters, MPI_Comm communicator)
    : directory_(all_of(directory).string())
    , layout_(layout)
    , parameters_(parameters)
    , communicator_(communicator)
  {
    const std::vector<int> numbers = numbers_in(directory_);
    next_                          = numbers.empty() ? 0 : numbers.front() + 1;
    MPI_Bcast(&next_, 1, MPI_INT, 0, communicator_);
  }

  template <int dim>
  std::string
  CheckpointStore<dim>::write(const LastGood<dim> &state)
  {
    const double      start     = MPI_Wtime();
    const std::string directory = (fs::path(directory_) / name_of(next_)).string();
    checkpoint::write(directory, layout_, parameters_, state, communicator_);
    ++next_;
    on_first_rank<checkpoint::Unusable>(communicator_, [&] {
      const std::vector<int> numbers = numbers_in(directory_);
      for (std::size_t i = kept; i < numbers.size(); ++i)
        fs::remove_all(fs::path(directory_) / name_of(numbers[i]));
    });
    slowest_ = std::max(slowest_, MPI_Wtime() - start);
    return directory;
  }

  template <int dim>
  typename CheckpointStore<dim>::Found
  CheckpointStore<dim>::newest(const std::string &directory, MPI_Comm communicator)
  {
    std::string names;
    for (const int number : numbers_in(all_of(directory)))
      names += name_of(number) + ' ';
    Found              found;
    std::istringstream list(from_first_rank(names, communicator));
    for (std::string name; !found.header && list >> name;)
      {
        found.directory = (all_of(directory) / name).string();
        try
          {
            found.header = checkpoint::read_header<dim>(found.directory, communicator);
          }
        catch (const checkpoint::Unusable &error)
          {
            found.refused.emplace_back(error.what());
          }
      }
    return found;
  }

  template class CheckpointStore<2>;
} // namespace whipple
