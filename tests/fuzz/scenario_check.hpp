// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_FUZZ_SCENARIO_CHECK_HPP
#define TERN_TESTS_FUZZ_SCENARIO_CHECK_HPP

#include <cmath>
#include <string>

#include "host/grid_layout.hpp"

namespace tern_fuzz {

inline bool finite(const tern::Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool ordered(const tern::Box& b) {
  return finite(b.lower) && finite(b.upper) && b.lower.x <= b.upper.x && b.lower.y <= b.upper.y &&
         b.lower.z <= b.upper.z;
}

/// What must hold of any text: it is a scenario with finite numbers, ordered boxes and a grid within the capacities, or
/// an error with a file and a printable reason. Returns what is wrong, empty where nothing is.
inline std::string check_scenario_text(const std::string& text, bool& accepted) {
  accepted = false;
  try {
    const tern_host::Scenario s = tern_host::parse_scenario(text, "fuzz.txt");
    const tern::GridSpec spec = tern_host::lay_out_grid(s);
    accepted = true;
    if (!ordered(s.boundary) || !finite(s.start.position) || !finite(s.goal.position))
      return "a bad number came through";
    for (const tern_host::Block& block : s.blocks) {
      if (!ordered(block.box)) return "a bad block came through";
    }
    if (tern::grid_words(spec.dims) == 0) return "a grid beyond the capacities came through";
  } catch (const tern_host::ScenarioError& error) {
    if (error.place().file != "fuzz.txt" || error.reason().empty()) return "an error without file or reason";
    for (const char c : error.reason()) {
      if (c < 0x20 || c > 0x7E) return "an unprintable reason";
    }
  }
  return "";
}

}  // namespace tern_fuzz

#endif
