// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The scenario parser under seeded mutations of the six maps (F23): truncated, spliced, binary and hostile files.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

#include "fuzz/scenario_check.hpp"
#include "support/random.hpp"

namespace {

using tern_test::Random;

std::vector<std::string> read_maps() {
  std::vector<std::string> maps;
  for (int i = 1; i <= 6; ++i) {
    std::ifstream file(std::string(TERN_SOURCE_DIR) + "/bench/maps/map" + std::to_string(i) + ".txt");
    std::ostringstream text;
    text << file.rdbuf();
    maps.push_back(text.str());
  }
  return maps;
}

std::size_t position(Random& random, const std::string& text) {
  return static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size())));
}

/// A run of the text, up to 40 bytes.
std::string piece(Random& random, const std::string& text) {
  return text.substr(position(random, text), static_cast<std::size_t>(random.integer(0, 40)));
}

/// Words that parsers tend to trip over.
std::string hostile_word(Random& random) {
  static const std::vector<std::string> words = {"nan",
                                                 "-inf",
                                                 "1e999",
                                                 "-1e-999",
                                                 "0x1p3",
                                                 "1e308",
                                                 "-1e308",
                                                 "1e-300",
                                                 "2147483648",
                                                 "boundary",
                                                 "block",
                                                 "goal",
                                                 "v_max 0",
                                                 "radius 1e9",
                                                 "\n",
                                                 "\r",
                                                 "\t",
                                                 "#",
                                                 "%s%n",
                                                 "../..",
                                                 "+",
                                                 ".",
                                                 "e5",
                                                 "1,5",
                                                 "1e+",
                                                 "--1",
                                                 "keepout 0 0 0 0 0 0\n",
                                                 "keepin 0 0 0 4 4 4\n",
                                                 "keepout_halfspaces 1 2 3 4 -1 0 0 5\n",
                                                 "resolution 1e-12\n",
                                                 "start\n",
                                                 std::string(5000, '9'),
                                                 std::string("\0", 1),
                                                 std::string(70, 'a')};
  return words[static_cast<std::size_t>(random.integer(0, static_cast<int>(words.size()) - 1))];
}

void mutate(Random& random, std::string& text) {
  const std::size_t at = position(random, text);
  switch (random.integer(0, 6)) {
    case 0:
      text.resize(at);
      break;
    case 1:
      if (at < text.size()) text[at] = static_cast<char>(random.integer(0, 255));
      break;
    case 2:
      text.erase(at, static_cast<std::size_t>(random.integer(1, 30)));
      break;
    case 3:
      text.insert(at, hostile_word(random));
      break;
    case 4:
      text.insert(at, piece(random, text));
      break;
    case 5:
      text.replace(at, std::min<std::size_t>(text.size() - at, 4), hostile_word(random));
      break;
    default:
      if (at < text.size() && text[at] >= '0' && text[at] <= '9') text[at] = "0123456789.-e"[random.integer(0, 12)];
  }
}

TEST(ScenarioMutation, EveryMutantIsAScenarioOrANamedError) {
  const std::vector<std::string> maps = read_maps();
  int accepted_count = 0;
  const int cases = tern_test::scaled(60000);
  for (int i = 0; i < cases; ++i) {
    Random random(0x5CE4A810u + static_cast<std::uint64_t>(i));
    std::string text = maps[static_cast<std::size_t>(i) % maps.size()];
    for (int rounds = random.integer(1, 6); rounds > 0; --rounds) mutate(random, text);
    bool accepted = false;
    ASSERT_EQ(tern_fuzz::check_scenario_text(text, accepted), "") << "case " << i << ":\n" << text;
    accepted_count += accepted ? 1 : 0;
  }
  // Neither side of the parser may be all that the mutants reach.
  EXPECT_GT(accepted_count, cases / 50);
  EXPECT_LT(accepted_count, cases / 2);
}

TEST(ScenarioMutation, EveryTruncationIsAScenarioOrANamedError) {
  for (const std::string& map : read_maps()) {
    for (std::size_t n = 0; n < map.size(); ++n) {
      bool accepted = false;
      ASSERT_EQ(tern_fuzz::check_scenario_text(map.substr(0, n), accepted), "") << "first " << n << " bytes";
    }
  }
}

TEST(ScenarioMutation, NoiseIsANamedError) {
  for (int i = 0; i < tern_test::scaled(2000); ++i) {
    Random random(0x401C3u + static_cast<std::uint64_t>(i));
    std::string noise(static_cast<std::size_t>(random.integer(0, 2000)), ' ');
    for (char& c : noise) c = static_cast<char>(random.integer(0, 255));
    bool accepted = false;
    ASSERT_EQ(tern_fuzz::check_scenario_text(noise, accepted), "") << "case " << i;
    EXPECT_FALSE(accepted);
  }
}

}  // namespace
