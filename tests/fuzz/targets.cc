// SPDX-License-Identifier: LGPL-2.1-or-later
#include "targets.h"

#include "../unit/table_writer.h"

#include <whipple/error.h>
#include <whipple/material/tabulated.h>
#include <whipple/problem/problem.h>
#include <whipple/scene/units.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace whipple::fuzz
{
  namespace
  {
    template <typename Work>
    std::string
    message_of(const Work &work)
    {
      try
        {
          work();
          return "";
        }
      catch (const InputError &error)
        {
          const std::string message = error.what();
          if (message.empty() || message.find('\n') != std::string::npos)
            throw std::logic_error("not one line: " + message);
          return message;
        }
    }

    void
    write(const std::string &path, std::string_view bytes)
    {
      std::ofstream(path, std::ios::binary) << bytes;
    }

    /// What every accepted law promises the solver: numbers, at any density and energy it may ask for.
    void
    check_law(const Tabulated &law)
    {
      for (const double compression : {1e-12, 1e-3, 0.5, 0.999, 1., 1.001, 1.5, 4., 100.})
        for (const double energy : {-1., -1e-3, 0., 1e-6, 1e-2, 1., 100.})
          {
            const double true_density = compression * law.reference_density();
            double       p, c2, dp_ddensity, dp_de, temperature = 0;
            law.evaluate({&true_density, 1}, {&energy, 1}, {&p, 1}, {&c2, 1});
            law.derivatives({&true_density, 1}, {&energy, 1}, {&dp_ddensity, 1}, {&dp_de, 1});
            if (law.has_temperature())
              law.evaluate({&true_density, 1}, {&energy, 1}, ThermalOutput{{&temperature, 1}, {}, {}, {}});
            for (const double value : {p, c2, dp_ddensity, dp_de, temperature})
              if (!std::isfinite(value))
                throw std::logic_error("the law is not finite at density " + std::to_string(true_density) +
                                       ", energy " + std::to_string(energy));
          }
      if (law.has_temperature() && !(law.specific_heat() > 0.))
        throw std::logic_error("the specific heat is not positive");
    }

    const char *const small_scene = R"(set Title = small
subsection Geometry
  set Lower corner = 0 cm, -1 cm
  set Upper corner = 1 cm, 1 cm
end
subsection Mesh
  set Finest cell = 0.1 cm
  set Levels = 1
end
subsection Materials
  set List = aluminium
  subsection aluminium
    set Library = aluminium 6061-T6
  end
end
subsection Bodies
  set List = ball
  subsection ball
    set Shape = sphere
    set Diameter = 0.8 cm
    set Center = 0 cm, 0 cm
    set Velocity = 0 km/s, 1 km/s
    set Material = aluminium
  end
end
subsection Stages
  set List = flight
  subsection flight
    set End = 1 us
  end
end
)";

    /// A stiffened gas, 4 densities and 5 energies or temperatures.
    table_writer::Table
    good_table(bool over_energy)
    {
      table_writer::Table table;
      table.over_energy = over_energy;
      table.density     = {1., 2., 3., 4.};
      for (int j = 0; j < 5; ++j)
        table.second.push_back(over_energy ? 0.5 * j : 100. * (1 + 2 * j));
      for (const double rho : table.density)
        for (const double y : table.second)
          {
            const double e = over_energy ? y : 1e-3 * (y - 300.);
            table.energy.push_back(e);
            table.temperature.push_back(1e3 * e + 300.);
            table.pressure.push_back(80. * (rho - 2.7) + 2. * rho * e);
            table.melt_fraction.push_back(e > 1. ? 1. : 0.);
          }
      table.melt_temperature.assign(4, 1300.);
      return table;
    }
  } // namespace

  std::string
  scene(std::string_view bytes)
  {
    const table_writer::File file("fuzzed.prm");
    write(file.path(), bytes);
    return message_of([&] { read_problem<2>(file.path(), {}); });
  }

  std::string
  override(std::string_view bytes)
  {
    const table_writer::File file("small.prm");
    write(file.path(), small_scene);
    std::vector<std::string> statements;
    while (!bytes.empty())
      {
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        statements.emplace_back(bytes.substr(0, end));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
      }
    return message_of([&] { read_problem<2>(file.path(), statements); });
  }

  std::string
  units(std::string_view bytes)
  {
    static const units::Quantity *const quantities[] = {&units::number, &units::length, &units::velocity,
                                                        &units::specific_heat};
    if (bytes.empty())
      return "";
    const units::Quantity &quantity = *quantities[static_cast<unsigned char>(bytes[0]) % 4];
    return message_of([&] {
      for (const double value : units::parse_list(bytes.substr(1), quantity, 1))
        if (!std::isfinite(value) ||
            std::bit_cast<std::uint64_t>(units::parse(units::format(value, quantity), quantity)) !=
                std::bit_cast<std::uint64_t>(value))
          throw std::logic_error("does not read back: " + units::format(value, quantity));
    });
  }

  std::string
  table_file(std::string_view bytes)
  {
    const table_writer::File file("fuzzed.h5");
    write(file.path(), bytes);
    return message_of([&] { check_law(Tabulated(file.path())); });
  }

  std::string
  table_fields(std::string_view bytes)
  {
    table_writer::Table     table         = good_table(!bytes.empty() && bytes[0] % 2 == 1);
    double                  references[2] = {table.reference_density, table.reference_energy};
    const std::span<double> fields[]      = {
             table.density,     table.second,        table.pressure,         table.energy,
             table.temperature, table.melt_fraction, table.melt_temperature, std::span<double>(references)};
    for (bytes.remove_prefix(bytes.empty() ? 0 : 1); bytes.size() >= 10; bytes.remove_prefix(10))
      {
        const std::span<double> field = fields[static_cast<unsigned char>(bytes[0]) % std::size(fields)];
        std::memcpy(&field[static_cast<unsigned char>(bytes[1]) % field.size()], bytes.data() + 2, sizeof(double));
      }
    table.reference_density = references[0];
    table.reference_energy  = references[1];
    const table_writer::File file("fields.h5");
    table_writer::write(file.path(), table);
    return message_of([&] { check_law(Tabulated(file.path())); });
  }
} // namespace whipple::fuzz
