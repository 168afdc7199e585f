// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Values whose bytes can be compared.
#ifndef TERN_TESTS_FLEET_MODEL_PADDING_HPP
#define TERN_TESTS_FLEET_MODEL_PADDING_HPP

#include <cstring>

#include "fleet/fleet_memory.hpp"

namespace tern_model {

/// Bytes between members may have any value.
inline void without_padding(tern::PlanName& name) {
  const tern::PlanName copy = name;
  std::memset(static_cast<void*>(&name), 0, sizeof name);
  name.id = copy.id;
  name.incarnation = copy.incarnation;
  name.number = copy.number;
  name.takeover = copy.takeover;
}

inline void without_padding(tern::Beacon& beacon, bool counts) {
  const tern::Beacon copy = beacon;
  std::memset(static_cast<void*>(&beacon), 0, sizeof beacon);
  if (!counts) return;
  beacon.id = copy.id;
  beacon.radius = copy.radius;
  beacon.is_member = copy.is_member;
  beacon.stamp = copy.stamp;
  beacon.place = copy.place;
}

inline void without_padding(tern::Link& link) {
  const tern::Link copy = link;
  std::memset(static_cast<void*>(&link), 0, sizeof link);
  link.own = copy.own;
  link.its = copy.its;
  link.is_near = copy.is_near;
  link.is_mutual = copy.is_mutual;
  link.binds = copy.binds;
  link.promised = copy.promised;
  link.trusted = copy.trusted;
}

inline void without_padding(tern::StateHead& state) {
  const tern::StateHead copy = state;
  std::memset(static_cast<void*>(&state), 0, sizeof state);
  state.id = copy.id;
  state.incarnation = copy.incarnation;
  state.counter = copy.counter;
  state.stamp = copy.stamp;
  state.flown = copy.flown;
  state.open = copy.open;
  state.radius = copy.radius;
  state.priority = copy.priority;
  state.has_left = copy.has_left;
  state.until = copy.until;
}

/// Without a proof that is over. One that runs points into its fleet, which lies in the same place when it goes on.
inline void without_proof(tern::ProofJob& job) {
  if (job.runs) return;
  const tern::ProofJob copy = job;
  std::memset(static_cast<void*>(&job), 0, sizeof job);
  job.kind = copy.kind;
  job.peer = copy.peer;
  job.heard = copy.heard;
  job.turn = copy.turn;
}

}  // namespace tern_model

#endif
