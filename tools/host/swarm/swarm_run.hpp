// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A swarm for the page: the first vehicle's flight, and all others as things that move.
#ifndef TERN_HOST_SWARM_SWARM_RUN_HPP
#define TERN_HOST_SWARM_SWARM_RUN_HPP

#include <string>

#include "host/swarm/swarm.hpp"

namespace tern_host {

/// The swarm as a run of page.hpp.
std::string swarm_run(const SwarmWorld& world, const SwarmSettings& settings, const SwarmResult& result);

}  // namespace tern_host

#endif
