// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Values whose bytes can be compared.
#ifndef TERN_TESTS_FLEET_MODEL_PADDING_HPP
#define TERN_TESTS_FLEET_MODEL_PADDING_HPP

#include <cstring>

#include "fleet/fleet_memory.hpp"

namespace tern_model {

/// Makes all bytes 0, and returns what they held: bytes between members may have any value.
template <class Value>
Value take_out(Value& value) {
  const Value copy = value;
  std::memset(static_cast<void*>(&value), 0, sizeof value);
  return copy;
}

inline void without_padding(tern::PlanName& name) {
  const tern::PlanName copy = take_out(name);
  name.id = copy.id;
  name.incarnation = copy.incarnation;
  name.number = copy.number;
  name.takeover = copy.takeover;
}

inline void without_padding(tern::Beacon& beacon, bool counts) {
  const tern::Beacon copy = take_out(beacon);
  if (!counts) return;
  beacon.id = copy.id;
  beacon.radius = copy.radius;
  beacon.is_member = copy.is_member;
  beacon.stamp = copy.stamp;
  beacon.place = copy.place;
}

inline void without_padding(tern::Link& link) {
  const tern::Link copy = take_out(link);
  link.own = copy.own;
  link.its = copy.its;
  link.is_near = copy.is_near;
  link.is_mutual = copy.is_mutual;
  link.binds = copy.binds;
  link.promised = copy.promised;
  link.trusted = copy.trusted;
}

inline void without_padding(tern::StateHead& state) {
  const tern::StateHead copy = take_out(state);
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
  const tern::ProofJob copy = take_out(job);
  job.kind = copy.kind;
  job.peer = copy.peer;
  job.heard = copy.heard;
  job.turn = copy.turn;
}

}  // namespace tern_model

#endif
