// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_WATCHED_ROOM_HPP
#define TERN_TESTS_SUPPORT_WATCHED_ROOM_HPP

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/full_knowledge.hpp"
#include "tern/map.hpp"

namespace tern_test {

/// A room and a map that knows all of it, for watches that may be told something else.
struct WatchedRoom {
  WatchedRoom() {
    world.boundary = {{-2.0, -5.0, 0.0}, {12.0, 5.0, 4.0}};
    world.start = {0.0, 0.0, 1.5};
    world.goal = {8.0, 0.0, 1.5};
    map_spec = tern::map_spec({-4.0, -7.0, -1.0}, 0.2, {128, 70, 30}, radius_of(world.settings));
    map_words.resize(tern::map_words(map_spec));
    EXPECT_EQ(map.bind(map_spec, map_words.data(), map_words.size()), tern::Status::kOk);
    know_all();
  }

  void know_all() { map.assume_free({4.0, 0.0, 2.0}, 30.0); }

  tern_host::FlightWorld world;
  tern::MapSpec map_spec{};
  std::vector<std::uint64_t> map_words;
  tern::RollingMap map;
};

inline testing::AssertionResult says(const std::string& broken, const std::string& wanted) {
  if (broken.find(wanted) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << broken << "\" does not say \"" << wanted << '"';
}

}  // namespace tern_test

#endif
