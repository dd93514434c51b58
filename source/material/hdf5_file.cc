// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/hdf5_file.h>

#include <hdf5.h>

#include <filesystem>
#include <system_error>

namespace whipple
{
  namespace
  {
    /// Failures are reported as exceptions; HDF5 keeps its own stack of messages to itself while one of these lives.
    class QuietHdf5
    {
    public:
      QuietHdf5()
      {
        H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
      }
      ~QuietHdf5()
      {
        H5Eset_auto2(H5E_DEFAULT, print_, data_);
      }
      QuietHdf5(const QuietHdf5 &) = delete;
      QuietHdf5 &
      operator=(const QuietHdf5 &) = delete;

    private:
      H5E_auto2_t print_ = nullptr;
      void       *data_  = nullptr;
    };

    /// An identifier that is closed when it goes out of scope.
    class Handle
    {
    public:
      Handle(hid_t id, herr_t (*close)(hid_t))
        : id_(id)
        , close_(close)
      {
      }
      ~Handle()
      {
        if (id_ >= 0)
          close_(id_);
      }
      Handle(const Handle &) = delete;
      Handle &
      operator=(const Handle &) = delete;

      operator hid_t() const
      {
        return id_;
      }
      bool
      valid() const
      {
        return id_ >= 0;
      }

    private:
      hid_t id_;
      herr_t (*close_)(hid_t);
    };

    // A table of equations of state is smaller by far; what asks for more is broken.
    constexpr hsize_t     most_along_an_index = 100'000, most_numbers = 10'000'000;
    constexpr std::size_t longest_units = 64;

    /// Whether a type is one that holds numbers.
    bool
    is_number(hid_t type)
    {
      const H5T_class_t kind = H5Tget_class(type);
      return kind == H5T_INTEGER || kind == H5T_FLOAT;
    }

    /// Whether a dataset lies in this file: not in others that it names, which may be anything.
    bool
    is_stored_here(hid_t dataset)
    {
      const Handle       creation(H5Dget_create_plist(dataset), H5Pclose);
      const H5D_layout_t layout = H5Pget_layout(creation);
      return creation.valid() && layout != H5D_VIRTUAL && layout != H5D_LAYOUT_ERROR &&
             H5Pget_external_count(creation) == 0;
    }

    /// Without what would break the line of a message.
    std::string
    printable(std::string text)
    {
      for (char &c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
          c = '?';
      return text;
    }

    /// The attribute "units", a string of fixed or variable length; empty if there is none.
    std::string
    units_of(hid_t dataset)
    {
      const Handle attribute(H5Aopen(dataset, "units", H5P_DEFAULT), H5Aclose);
      if (!attribute.valid())
        return "";
      const Handle type(H5Aget_type(attribute), H5Tclose);
      const Handle space(H5Aget_space(attribute), H5Sclose);
      if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1)
        return "";
      if (H5Tis_variable_str(type) > 0)
        {
          char *text = nullptr;
          if (H5Aread(attribute, type, &text) < 0 || !text)
            return "";
          const std::string units = std::string(text).substr(0, longest_units);
          H5free_memory(text);
          return printable(units);
        }
      if (H5Tget_size(type) > longest_units)
        return "";
      std::string units(H5Tget_size(type), '\0');
      if (H5Aread(attribute, type, units.data()) < 0)
        return "";
      return printable(units.substr(0, units.find('\0')));
    }
  } // namespace

  Hdf5File::Hdf5File(const std::string &path)
    : path_(path)
  {
    std::error_code error;
    const auto      kind = std::filesystem::status(path, error).type();
    if (kind == std::filesystem::file_type::not_found)
      throw InputError(path + ": there is no such file; allowed is an HDF5 file");
    if (kind != std::filesystem::file_type::regular) // HDF5 would wait for what a pipe or a device never says
      throw InputError(path + ": is no regular file; allowed is an HDF5 file");
    const QuietHdf5 quiet;
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file_ < 0)
      throw InputError(path + ": cannot be read as HDF5 (another format, damaged, or cut short); allowed is an HDF5 "
                              "file");
  }

  Hdf5File::~Hdf5File()
  {
    H5Fclose(file_);
  }

  bool
  Hdf5File::has(const std::string &dataset) const
  {
    const QuietHdf5 quiet;
    return H5Lexists(file_, dataset.c_str(), H5P_DEFAULT) > 0;
  }

  Hdf5File::Dataset
  Hdf5File::read(const std::string &dataset) const
  {
    const QuietHdf5 quiet;
    const Handle    source(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
    const auto      reject = [&](const std::string &what) {
      throw InputError(path_ + ": dataset '" + dataset + "' " + what);
    };
    if (!source.valid())
      reject("is missing");
    const Handle type(H5Dget_type(source), H5Tclose);
    if (!is_number(type))
      reject("must hold numbers");
    const Handle space(H5Dget_space(source), H5Sclose);
    const int    rank = H5Sget_simple_extent_ndims(space);
    if (rank != 1 && rank != 2)
      reject("must be an array of one or two indices");
    hsize_t extent[2] = {1, 1};
    H5Sget_simple_extent_dims(space, extent, nullptr);
    for (const hsize_t e : extent)
      if (e < 1 || e > most_along_an_index)
        reject("has an extent of " + std::to_string(e) + "; allowed is 1 to " + std::to_string(most_along_an_index));
    if (extent[0] * extent[1] > most_numbers)
      reject("has " + std::to_string(extent[0] * extent[1]) + " numbers; allowed are at most " +
             std::to_string(most_numbers));
    if (!is_stored_here(source))
      reject("must be stored in the file itself");
    Dataset result{{extent, extent + rank}, std::vector<double>(extent[0] * extent[1]), units_of(source)};
    if (H5Dread(source, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.values.data()) < 0)
      reject("cannot be read; the file is damaged or cut short");
    if (result.units.empty())
      reject("has no attribute 'units' (a text of 1 to " + std::to_string(longest_units) + " characters)");
    return result;
  }

  double
  Hdf5File::attribute(const std::string &name) const
  {
    const QuietHdf5 quiet;
    const Handle    attribute(H5Aopen(file_, name.c_str(), H5P_DEFAULT), H5Aclose);
    if (!attribute.valid())
      throw InputError(path_ + ": attribute '" + name + "' is missing");
    const Handle space(H5Aget_space(attribute), H5Sclose);
    const Handle type(H5Aget_type(attribute), H5Tclose);
    double       value = 0;
    if (H5Sget_simple_extent_npoints(space) != 1 || !is_number(type) ||
        H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
      throw InputError(path_ + ": attribute '" + name + "' must be one number");
    return value;
  }
} // namespace whipple
