// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/hdf5_file.h>

#include <hdf5.h>

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

    /// The attribute "units", a string of fixed or variable length; empty if there is none.
    std::string
    units_of(hid_t dataset)
    {
      const Handle attribute(H5Aopen(dataset, "units", H5P_DEFAULT), H5Aclose);
      if (!attribute.valid())
        return "";
      const Handle type(H5Aget_type(attribute), H5Tclose);
      if (H5Tget_class(type) != H5T_STRING)
        return "";
      if (H5Tis_variable_str(type) > 0)
        {
          char *text = nullptr;
          if (H5Aread(attribute, type, &text) < 0 || !text)
            return "";
          const std::string units = text;
          H5free_memory(text);
          return units;
        }
      std::string units(H5Tget_size(type), '\0');
      if (H5Aread(attribute, type, units.data()) < 0)
        return "";
      return units.substr(0, units.find('\0'));
    }
  } // namespace

  Hdf5File::Hdf5File(const std::string &path)
    : path_(path)
  {
    const QuietHdf5 quiet;
    file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file_ < 0)
      throw InputError(path + ": there is no such file, or it is not HDF5");
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
    if (!source.valid())
      throw InputError(path_ + ": dataset '" + dataset + "' is missing");
    const Handle space(H5Dget_space(source), H5Sclose);
    const int    rank = H5Sget_simple_extent_ndims(space);
    if (rank < 1)
      throw InputError(path_ + ": dataset '" + dataset + "' must be an array");
    std::vector<hsize_t> extent(rank);
    H5Sget_simple_extent_dims(space, extent.data(), nullptr);
    Dataset     result{{extent.begin(), extent.end()}, {}, units_of(source)};
    std::size_t size = 1;
    for (const std::size_t e : result.extent)
      size *= e;
    result.values.resize(size);
    if (H5Dread(source, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.values.data()) < 0)
      throw InputError(path_ + ": dataset '" + dataset + "' must hold numbers");
    if (result.units.empty())
      throw InputError(path_ + ": dataset '" + dataset + "' has no attribute 'units'");
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
    double       value = 0;
    if (H5Sget_simple_extent_npoints(space) != 1 || H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
      throw InputError(path_ + ": attribute '" + name + "' must be one number");
    return value;
  }
} // namespace whipple
