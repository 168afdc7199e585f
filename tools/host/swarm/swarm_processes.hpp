// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A swarm in real time: each vehicle in a process of its own, which hears of the others by UDP alone.
#ifndef TERN_HOST_SWARM_SWARM_PROCESSES_HPP
#define TERN_HOST_SWARM_SWARM_PROCESSES_HPP

#include "host/swarm/swarm.hpp"

namespace tern_host {

/// As fly_swarm(). Ticks come when the processes get to run, so no two swarms are the same: the hash is the record's.
/// Of the links' settings, each vehicle's own draw of lots decides about what it sends. Throws std::runtime_error if
/// sockets or processes cannot be had, or one ends early.
SwarmResult fly_swarm_in_processes(const SwarmWorld& world, const SwarmSettings& settings, SwarmRecord& record);

}  // namespace tern_host

#endif
