// SPDX-License-Identifier: LGPL-2.1-or-later
// A SESAME text made of an analytic law, converted by scripts/convert_eos_table.py, read, and compared with the law.
#include "../figure.h"
#include "analytic_solid.h"
#include "source_directory.h"
#include "table_writer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace
{
  using namespace whipple;
  using analytic_solid::Solid;

  /// Numbers of a record, five of 15 columns a line and the flags that follow them.
  class Record
  {
  public:
    Record(std::ofstream &file, int flag, int type, std::size_t count)
      : file_(file)
    {
      char head[81];
      std::snprintf(head, sizeof head, "%2d%6d%6d%6zu   r%9d%9d%4d", flag, 9999, type, count, 101070, 101070, 1);
      file_ << head << "\n";
    }
    ~Record()
    {
      file_ << (written_ % 5 == 0 ? "" : "\n");
    }
    void
    operator()(double value)
    {
      char text[16];
      std::snprintf(text, sizeof text, "%15.8E", value);
      file_ << text << (++written_ % 5 == 0 ? "11111\n" : "");
    }

  private:
    std::ofstream &file_;
    int            written_ = 0;
  };

  /// n + 1 densities 1.5 ... 6 g/cm^3, one of 0 before them, and n + 1 temperatures 100 ... 20000 K.
  void
  write_sesame(const std::string &path, int n)
  {
    std::vector<double> density{0.}, temperature;
    for (int i = 0; i <= n; ++i)
      {
        density.push_back(1.5 * std::pow(4., static_cast<double>(i) / n));
        temperature.push_back(100. * std::pow(200., static_cast<double>(i) / n));
      }
    std::ofstream file(path);
    file << " 0  9999   101   160   r   101070   101070   1\n"
         << "an analytic solid, two lines of comment\n"
         << "1 as a line of text may start\n";
    {
      Record normal(file, 1, 201, 5);
      for (const double value : {13., 26.98, 2.7, 76., 0.})
        normal(value);
    }
    Record total(file, 1, 301, 2 + density.size() + temperature.size() + 2 * density.size() * temperature.size());
    total(static_cast<double>(density.size()));
    total(static_cast<double>(temperature.size()));
    for (const double rho : density)
      total(rho);
    for (const double t : temperature)
      total(t);
    for (const double t : temperature)
      for (const double rho : density)
        total(rho > 0. ? 100. * Solid::pressure(rho, t) : 0.);
    for (const double t : temperature)
      for (const double rho : density)
        total(rho > 0. ? 100. * Solid::energy(rho, t) : 0.);
  }

  TEST(TableConverter, ASesameTextOfAnAnalyticLawConverges)
  {
    const auto errors = [](int n) {
      const table_writer::File text("sesame.txt"), table("sesame.h5");
      write_sesame(text.path(), n);
      const std::string command =
          std::string("/usr/bin/python3 '" + source_directory() + "/scripts/convert_eos_table.py' '") + text.path() +
          "' '" + table.path() + "' --temperature 300 > /dev/null";
      if (std::system(command.c_str()) != 0)
        throw std::runtime_error("not converted: " + command);
      const Tabulated law(table.path());
      // at rest without pressure, as near as the table can say
      EXPECT_NEAR(eos_check::pressure(law, law.reference_density(), 0.), 0., 1e-4);
      EXPECT_NEAR(Solid::pressure(law.reference_density(), 300.), 0., 1e-4);
      return analytic_solid::errors(law, Solid::energy(law.reference_density(), 300.));
    };
    const analytic_solid::Errors coarse = errors(32), fine = errors(64);
    figure::expect_at_most("error of P of a converted 65 x 65 SESAME table, relative to K + |P|", fine.p, 1e-6);
    figure::expect_at_most("error of c^2 of the same table", fine.c2, 5e-5);
    figure::record("order of P of a converted SESAME table", std::log2(coarse.p / fine.p), ">= 3.5");
    figure::record("order of c^2 of a converted SESAME table", std::log2(coarse.c2 / fine.c2), ">= 2.5");
    EXPECT_GE(std::log2(coarse.p / fine.p), 3.5);
    EXPECT_GE(std::log2(coarse.c2 / fine.c2), 2.5);
  }
} // namespace
