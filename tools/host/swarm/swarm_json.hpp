// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_SWARM_SWARM_JSON_HPP
#define TERN_HOST_SWARM_SWARM_JSON_HPP

#include <string>

#include "host/swarm/swarm.hpp"

namespace tern_host {

/// A swarm's result as one line of JSON: what was asked for, what came of it, and where each vehicle was every tenth of
/// a second.
std::string swarm_json(const SwarmWorld& world, const SwarmSettings& settings, const SwarmResult& result);

}  // namespace tern_host

#endif
