// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TARGET_EMBEDDED_HPP
#define TERN_BENCH_TARGET_EMBEDDED_HPP

#include <vector>

#include "host/scenario.hpp"

namespace tern_target {

/// The scenarios that the program carries: the paper's six maps and forests of growing density, so that one file is all
/// that has to be copied to a board.
std::vector<tern_host::Scenario> embedded_scenarios();

}  // namespace tern_target

#endif
