// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/checksum.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/version.h>
#include <whipple/run/books_cbor.h>
#include <whipple/run/checkpoint.h>

#include "checkpoint_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace whipple::checkpoint
{
  namespace
  {
    namespace fs = std::filesystem;
    using Json   = nlohmann::ordered_json;

    /// Of the files below; to be raised with every change of what they mean.
    constexpr int format = 8;

    constexpr std::array<const char *, 3> files{"parameters.prm", "books.cbor", "state.h5"};
    constexpr const char                 *contents = "contents.json";

    void
    put(const fs::path &path, const void *data, std::size_t size)
    {
      std::ofstream file(path, std::ios::binary);
      file.write(static_cast<const char *>(data), static_cast<std::streamsize>(size));
      if (!file.flush())
        throw Unusable(path.string() + ": cannot be written: " + std::strerror(errno));
    }

    std::string
    get(const fs::path &path)
    {
      std::ifstream file(path, std::ios::binary);
      if (!file)
        throw Unusable(path.string() + ": cannot be read");
      return {std::istreambuf_iterator<char>(file), {}};
    }

    /// Wait until a file or directory is on the disk.
    void
    flush_to_disk(const fs::path &path)
    {
      const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
      if (file < 0 || fsync(file) != 0)
        {
          const std::string why = std::strerror(errno);
          if (file >= 0)
            close(file);
          throw Unusable(path.string() + ": cannot be flushed to disk: " + why);
        }
      close(file);
    }

    /// Checksum of a table of contents itself.
    std::string
    sum_of(Json table)
    {
      table.erase("crc32");
      const std::string text = table.dump();
      return checksum::text(checksum::of(std::as_bytes(std::span<const char>(text))));
    }

    void
    write_contents(const fs::path &directory, const summary::Summary &summary, double time,
                   const checkpoint_file::Checksums &datasets)
    {
      const summary::Stage stage = summary.stages.empty() ? summary::Stage{} : summary.stages.back();
      Json                 table = {{"format", format},
                                    {"program", std::string(version::number())},
                                    {"commit", std::string(version::git_hash())},
                                    {"stage", stage.name},
                                    {"step", stage.steps},
                                    {"time_us", time},
                                    {"files", Json::object()}};
      for (const char *name : files)
        table["files"][name] = {{"bytes", fs::file_size(directory / name)},
                                {"crc32", checksum::text(checksum::of_file((directory / name).string()))}};
      table["datasets"]      = datasets; // of state.h5
      table["crc32"]         = sum_of(table);
      const std::string text = table.dump(2) + '\n';
      put(directory / contents, text.data(), text.size());
    }

    /// @throws Unusable unless every file is what was written.
    void
    check_contents(const fs::path &directory)
    {
      const auto damaged = [&](const std::string &why) {
        return Unusable("checkpoint " + directory.string() + " is damaged: " + why);
      };
      try
        {
          const Json        table   = Json::parse(get(directory / contents));
          const std::string program = table.at("program");
          if (table.at("format") != format || program != version::number())
            throw Unusable("checkpoint " + directory.string() + " was written by Whipple " + program + " (format " +
                           table.at("format").dump() + "), this is " + std::string(version::number()) + " (format " +
                           std::to_string(format) + ")");
          if (table.at("crc32") != sum_of(table))
            throw damaged(std::string(contents) + " was altered");
          for (const char *name : files)
            {
              const Json &file = table.at("files").at(name);
              const auto  size = fs::file_size(directory / name);
              if (size != file.at("bytes").get<std::uintmax_t>())
                throw damaged(std::string(name) + " has " + std::to_string(size) + " bytes, written were " +
                              std::to_string(file.at("bytes").get<std::uintmax_t>()));
              if (checksum::text(checksum::of_file((directory / name).string())) != file.at("crc32"))
                throw damaged(std::string(name) + " was altered");
            }
        }
      catch (const Json::exception &)
        {
          throw damaged(std::string(contents) + " cannot be understood");
        }
      catch (const fs::filesystem_error &error)
        {
          throw damaged(error.path1().filename().string() + ": " + error.code().message());
        }
    }

    /// Write the state, and read it back: a full disk is not always told.
    template <int dim>
    checkpoint_file::Checksums
    write_state(const std::string &path, const FieldLayout &layout, const LastGood<dim> &state, MPI_Comm communicator)
    {
      const auto      columns = row_columns<dim>(layout);
      const StateRows rows    = to_rows(layout, state.view()->mesh, state.state());
      auto sums = checkpoint_file::write(path, *state.mesh(), columns, rows, state.state().time, communicator);
      checkpoint_file::read_mesh(path, communicator);
      checkpoint_file::read_rows(path, columns, rows.size(), communicator);
      return sums;
    }
  } // namespace

  template <int dim>
  void
  write(const std::string &directory, const FieldLayout &layout, const std::string &parameters,
        const LastGood<dim> &state, MPI_Comm communicator)
  {
    const fs::path aside = directory + ".part";
    on_first_rank<Unusable>(communicator, [&] {
      fs::remove_all(aside);
      fs::create_directories(aside);
      put(aside / "parameters.prm", parameters.data(), parameters.size());
      const auto books = to_cbor(state.books());
      put(aside / "books.cbor", books.data(), books.size());
    });
    checkpoint_file::Checksums datasets;
    try
      {
        datasets = write_state((aside / "state.h5").string(), layout, state, communicator);
      }
    catch (const std::exception &error)
      {
        throw Unusable(directory + ": cannot be written: " + error.what());
      }
    on_first_rank<Unusable>(communicator, [&] {
      write_contents(aside, state.books().summary, state.state().time, datasets);
      for (const char *name : files)
        flush_to_disk(aside / name);
      flush_to_disk(aside / contents);
      flush_to_disk(aside);
      fs::remove_all(directory);
      fs::rename(aside, directory);
      flush_to_disk(fs::path(directory).parent_path());
    });
  }

  template <int dim>
  Header<dim>
  read_header(const std::string &directory, MPI_Comm communicator)
  {
    Header<dim> header;
    std::string text, books;
    on_first_rank<Unusable>(communicator, [&] {
      check_contents(directory);
      text  = get(fs::path(directory) / "parameters.prm");
      books = get(fs::path(directory) / "books.cbor");
    });
    header.parameters       = from_first_rank(text, communicator);
    const std::string bytes = from_first_rank(books, communicator);
    header.books            = books_from_cbor({bytes.begin(), bytes.end()});
    return header;
  }

  template <int dim>
  void
  read_fields(const std::string &directory, const FieldLayout &layout, RunState<dim> &run)
  {
    const std::string path         = directory + "/state.h5";
    const MPI_Comm    communicator = run.domain.communicator();
    try
      {
        run.domain.view = rebuild(checkpoint_file::read_mesh(path, communicator), run.domain.forest);
        const auto fields =
            checkpoint_file::read_rows(path, row_columns<dim>(layout), run.domain.view->mesh.n_owned, communicator);
        from_rows(layout, fields.rows, fields.time, run.domain);
      }
    catch (const std::exception &error)
      {
        throw Unusable("checkpoint " + directory + ": " + error.what());
      }
  }

  template void
  write(const std::string &, const FieldLayout &, const std::string &, const LastGood<2> &, MPI_Comm);
  template Header<2>
  read_header(const std::string &, MPI_Comm);
  template void
  read_fields(const std::string &, const FieldLayout &, RunState<2> &);
} // namespace whipple::checkpoint
