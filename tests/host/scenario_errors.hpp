// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the reader of scenarios says of a text.
#ifndef TERN_TESTS_HOST_SCENARIO_ERRORS_HPP
#define TERN_TESTS_HOST_SCENARIO_ERRORS_HPP

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/grid_layout.hpp"
#include "host/scenario.hpp"

namespace tern_test {

inline const std::string kMinimal = "boundary 0 0 0 4 3 2\nstart 1 1 1\ngoal 3 2 1\n";

/// The message of the error that a text makes; empty where it is read.
inline std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    tern_host::lay_out_grid(tern_host::parse_scenario(text, "map.txt", overrides));
  } catch (const tern_host::ScenarioError& error) {
    return error.what();
  }
  return "";
}

}  // namespace tern_test

#endif
