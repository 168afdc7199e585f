// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/presence.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace {

using tern_host::absence_text;
using tern_host::Presence;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A plan from 5 s to 15 s: it begins when one thing leaves, and has ended when another one comes.
TEST(Presence, NamesWhatIsThereBeforeOrAfter) {
  EXPECT_EQ(absence_text({{"man", 0.0, 5.0}, {"bird", 14.9, kNever}}, 5.0, 15.0), "");
  EXPECT_EQ(absence_text({{"gone", 0.0, 4.9}, {"man", 0.0, kNever}, {"late", 15.0, kNever}}, 5.0, 15.0),
            "not there during the plan: gone, late");
  EXPECT_EQ(absence_text({}, 5.0, 15.0), "");
}

TEST(Presence, NamesEightAtMost) {
  const std::vector<Presence> many(10, {"a", 20.0, 30.0});
  EXPECT_EQ(absence_text(many, 5.0, 15.0), "not there during the plan: a, a, a, a, a, a, a, a and 2 more");
  EXPECT_EQ(absence_text({many.begin(), many.begin() + 8}, 5.0, 15.0),
            "not there during the plan: a, a, a, a, a, a, a, a");
}

/// Clock errors make a keep-out last longer and a keep-in shorter; keepouts are counted among themselves.
TEST(Presence, OfAScenario) {
  const tern_host::Scenario scenario = tern_host::parse_scenario(
      "boundary 0 0 0 12 8 3\nstart 1 4 1\ngoal 11 4 1\ntrack man ball 0.3 at 6 4 1 from 2\n"
      "keepout 5 0 0 6 1 1 zone Shed\nkeepout 5 0 0 6 1 1 during 3 9 1\n"
      "keepin 0 0 0 12 8 3 during 3 9 1\nkeepin 0 0 0 12 8 3\n"
      "keepout_halfspaces 1 0 0 6 -1 0 0 -5 during 3 9 1 zone Old town\n",
      "things.txt");
  const std::vector<Presence> all = tern_host::presences_of(scenario);
  const std::vector<Presence> expected = {
      {"man", 2.0, kNever}, {"keepout 2", 2.0, 10.0}, {"fence 1", 4.0, 8.0}, {"fence 3 (Old town)", 2.0, 10.0}};
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].name, expected[k].name);
    EXPECT_DOUBLE_EQ(all[k].from, expected[k].from);
    EXPECT_DOUBLE_EQ(all[k].until, expected[k].until);
  }
}

}  // namespace
