// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a plan among things that move met, in words: why there is none, and what would help.
#ifndef TERN_HOST_MET_TEXT_HPP
#define TERN_HOST_MET_TEXT_HPP

#include <string>

#include "host/session.hpp"

namespace tern_host {

/// True if there is no plan because of a thing that moves or of a fence for a while, which the report names.
bool is_met(const PlanResult& result);

/// "; track: man, 4.7 s after the beginning; it covers via 1 then; ..." with whether it ever leaves, and what would
/// help. Empty unless is_met().
std::string describe_met(const PlanResult& result);

}  // namespace tern_host

#endif
