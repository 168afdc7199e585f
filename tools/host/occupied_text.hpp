// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_OCCUPIED_TEXT_HPP
#define TERN_HOST_OCCUPIED_TEXT_HPP

#include <string>

#include "host/session.hpp"

namespace tern_host {

/// Why no voxel at the start, the goal or a via is free: what is in the way there, and what to do. Begins with a
/// semicolon; empty for other answers.
std::string describe_occupied(const PlanResult& result);

}  // namespace tern_host

#endif
