// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Obstacles of one case as a file, a line `run BEGIN END Y Z` each, so that fewer of them can be tried.
#ifndef TERN_TESTS_ATTACK_OBSTACLE_FILE_HPP
#define TERN_TESTS_ATTACK_OBSTACLE_FILE_HPP

#include <string>
#include <vector>

#include "attack/world.hpp"

namespace tern_attack {

/// Lines that begin otherwise are left out. Throws std::runtime_error.
std::vector<SolidRun> read_runs(const std::string& path);
void write_runs(const std::string& path, const std::vector<SolidRun>& runs);

}  // namespace tern_attack

#endif
