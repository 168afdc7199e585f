// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The files of this folder, and the settings that they are read with.
#ifndef TERN_TESTS_AIRSPACE_AIRSPACE_FILE_HPP
#define TERN_TESTS_AIRSPACE_AIRSPACE_FILE_HPP

#include <fstream>
#include <iterator>
#include <string>

#include "host/airspace/airspace.hpp"

namespace tern_test {

inline std::string content(const std::string& name) {
  std::ifstream file(std::string(TERN_SOURCE_DIR) + "/tests/airspace/files/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline tern_host::AirspaceSettings lake_settings() {
  tern_host::AirspaceSettings settings;
  settings.origin = tern_host::GeoPoint{47.366, 8.54};
  settings.height = 455.0;
  settings.heights.undulation = 47.3;
  settings.heights.ground = tern_host::HeightRange{400.0, 420.0};
  settings.fit.boundary = {{-2000.0, -2000.0, -30.0}, {2000.0, 2000.0, 120.0}};
  settings.epoch = tern_host::parse_instant("2026-03-02T08:00:00Z");
  settings.hours = 8.0;
  settings.clock_error = 2.0;
  settings.events = {{"SR", *tern_host::parse_day_time("06:03Z")}, {"SS", *tern_host::parse_day_time("17:11Z")}};
  return settings;
}

}  // namespace tern_test

#endif
