// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every capacity and every budget, up to its limit and beyond: up to it, there is an answer; beyond it, the status that
// names it, while there is room in all others. A capacity of config.hpp without a case fails.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

#include "capacity/cases.hpp"

namespace tern_capacity {
namespace {

std::set<std::string> macros_of_config() {
  std::ifstream file(std::string(TERN_SOURCE_DIR) + "/core/include/tern/config.hpp");
  const std::regex pattern("#ifndef (TERN_MAX_[A-Z_]+)");
  std::set<std::string> found;
  std::smatch match;
  for (std::string line; std::getline(file, line);) {
    if (std::regex_match(line, match, pattern)) found.insert(match[1]);
  }
  return found;
}

TEST(Capacities, EachOfTheConfigurationHasACase) {
  std::set<std::string> left = macros_of_config();
  EXPECT_GT(left.size(), 10u);
  for (const Exceeded& exceeded : exceeded_capacities()) left.erase(exceeded.name);
  EXPECT_EQ(left, std::set<std::string>());
}

class EveryCapacity : public testing::TestWithParam<Exceeded> {};

TEST_P(EveryCapacity, IsExceeded) {
  EXPECT_TRUE(GetParam().enough());
  EXPECT_STREQ(tern::status_name(GetParam().beyond()), tern::status_name(GetParam().status));
}

std::string capacity_name(const testing::TestParamInfo<Exceeded>& test) {
  return std::regex_replace(test.param.name, std::regex("[^A-Za-z0-9_]"), "_");
}

INSTANTIATE_TEST_SUITE_P(Capacities, EveryCapacity, testing::ValuesIn(exceeded_capacities()), capacity_name);

}  // namespace
}  // namespace tern_capacity
