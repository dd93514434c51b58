// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/directory_lock.h>
#include <whipple/output/manifest.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace whipple::manifest
{
  namespace
  {
    namespace fs = std::filesystem;

    /// The names listed, each once.
    std::set<std::string>
    listed(const fs::path &directory)
    {
      std::ifstream file(directory / file_name);
      if (!file)
        throw InputError("output directory '" + directory.string() + "' has no " + file_name +
                         ", so what the earlier run wrote is not known; nothing overwritten, remove it yourself");
      std::set<std::string> names;
      for (std::string line; std::getline(file, line);)
        names.insert(line);
      return names;
    }

    bool
    lies_within(const fs::path &name)
    {
      return !name.empty() && name.is_relative() && *name.lexically_normal().begin() != "..";
    }

    /// Remove a folder, if it is still there, and those around it in the directory, as far as they are empty.
    void
    remove_empty(fs::path folder, const fs::path &directory)
    {
      for (; folder != directory && (!fs::exists(folder) || fs::is_empty(folder)); folder = folder.parent_path())
        fs::remove(folder);
    }
  } // namespace

  void
  note(const std::string &directory, std::string_view name)
  {
    std::ofstream file(fs::path(directory) / file_name, std::ios::app);
    if (!(file << name << '\n' << std::flush))
      throw Error(directory + '/' + file_name + ": cannot be written");
  }

  void
  remove_listed(const std::string &given)
  {
    const fs::path directory(given);
    for (const std::string &name : listed(directory))
      {
        if (!lies_within(name))
          continue;
        const bool     folder = name.ends_with('/');
        const fs::path path   = directory / (folder ? name.substr(0, name.size() - 1) : name);
        if (fs::is_directory(path) && fs::exists(path / file_name))
          {
            remove_listed(path.string());
            fs::remove(path / DirectoryLock::file_name); // who holds the outer directory holds this one
          }
        else if (folder)
          fs::remove_all(path);
        else if (!fs::is_directory(path))
          fs::remove(path);
        remove_empty(folder ? path : path.parent_path(), directory);
      }
    fs::remove(directory / file_name);
  }
} // namespace whipple::manifest
