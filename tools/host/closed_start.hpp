// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_CLOSED_START_HPP
#define TERN_HOST_CLOSED_START_HPP

#include <string>

#include "host/session.hpp"

namespace tern_host {

/// Where there is no plan because of a fence or a keep-out box for a while: until when it is closed and, if the start
/// is in it, when a plan may begin. Begins with a semicolon; empty for other answers.
std::string describe_closed_start(const PlanResult& result);

/// "12.500 s of the clock", and when that is, if the scenario says when the clock is 0. To the next millisecond.
std::string clock_text(const Scenario& scenario, double time);

}  // namespace tern_host

#endif
