// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What scenarios ask the planner has the same bits on every machine: random worlds as scenarios, their grids and ends.
#include "host/scenario.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host/flight/family_scenario.hpp"
#include "host/flight/world_family.hpp"
#include "host/map/scenario_grid.hpp"

namespace {

/// FNV-1a over the bytes of a value without padding.
template <typename T>
void hash(const T* values, std::size_t count, std::uint64_t& sum) {
  const auto* const bytes = reinterpret_cast<const unsigned char*>(values);
  for (std::size_t i = 0; i < count * sizeof(T); ++i) sum = (sum ^ bytes[i]) * 0x100000001B3u;
}

void hash_vec(const tern::Vec3& v, std::uint64_t& sum) {
  const double numbers[] = {v.x, v.y, v.z};
  hash(numbers, 3, sum);
}

void hash_scenario(const std::string& text, std::uint64_t& sum) {
  const tern_host::Scenario scenario = tern_host::parse_scenario(text, "world.txt");
  const tern_host::GridMap map(scenario);
  ASSERT_EQ(map.status, tern::Status::kOk);
  const tern::GridSpec& spec = map.grid.spec();
  for (const tern::Vec3& v : {spec.origin, spec.boundary.lower, spec.boundary.upper}) hash_vec(v, sum);
  hash_vec(scenario.start.position, sum);
  hash_vec(scenario.goal.position, sum);
  for (std::int32_t z = 0; z < spec.dims.z; ++z) {
    for (std::int32_t y = 0; y < spec.dims.y; ++y) {
      hash(map.grid.obstacle_row(y, z), static_cast<std::size_t>(map.grid.row_words()), sum);
      hash(map.grid.blocked_row(y, z), static_cast<std::size_t>(map.grid.row_words()), sum);
    }
  }
}

TEST(GoldenScenarios, TheSameQuestionsOnEveryMachine) {
  std::uint64_t sum = 0xCBF29CE484222325u;
  for (const char* const family : {"P25", "S20", "B", "M", "C"}) {
    for (const char* const seed : {":1", ":2", ":3"}) {
      hash_scenario(tern_host::scenario_text(tern_host::read_flight_world(std::string(family) + seed, {})), sum);
    }
  }
  EXPECT_EQ(sum, 0x1B73390E8DE5CB89u) << "0x" << std::hex << sum;
}

}  // namespace
