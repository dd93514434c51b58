// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/registry.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  class Tools : public Registry<Tools, int>
  {
  };
  class Stations : public Registry<Stations, int, std::pair<int, std::string>>
  {
  };

  TEST(Registry, KeepsOrderAndRefusesASecondOfOneName)
  {
    const Tools::Registered saw("saw", 2), file("file", 1);
    EXPECT_EQ(Tools::all(), (std::map<std::string, int>{{"file", 1}, {"saw", 2}}));
    EXPECT_THROW(Tools::Registered("saw", 3), std::logic_error);
    EXPECT_EQ(Tools::all().at("saw"), 2);

    // another kind with entries of the same type is another registry
    const Stations::Registered last({20, "a"}, 7), first({10, "b"}, 8);
    ASSERT_EQ(Stations::all().size(), 2u);
    EXPECT_EQ(Stations::all().begin()->first.second, "b");
  }
} // namespace
