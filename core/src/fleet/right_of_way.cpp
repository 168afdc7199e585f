// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/work.hpp"
#include "fleet/fleet_memory.hpp"

namespace tern {

bool is_asked(const FleetMemory& fleet, const Peer& peer) noexcept {
  if (peer.state.has_left) return false;
  const FleetSpec& spec = fleet.spec;
  return peer.state.priority != spec.priority ? peer.state.priority > spec.priority : peer.id < spec.id;
}

bool is_ready(const FleetMemory& fleet, const Peer& peer) noexcept {
  if (peer.state.incarnation == 0) return false;
  // What has left decides nothing any more. Anyone else must know this incarnation: what an earlier one agreed to is
  // not known here, and ends then.
  if (!peer.state.has_left && peer.answer.incarnation != fleet.spec.incarnation) return false;
  return is_asked(fleet, peer) || is_resolved(peer);
}

bool has_agreed(const FleetMemory& fleet, const Peer& peer) noexcept {
  return peer.answer.incarnation == fleet.spec.incarnation && peer.answer.number == next_plan(fleet).name.number &&
         peer.answer.consent == Consent::kYes;
}

namespace {

bool has_refused(const FleetMemory& fleet, const Peer& peer) {
  return peer.answer.incarnation == fleet.spec.incarnation && peer.answer.number == next_plan(fleet).name.number &&
         peer.answer.consent == Consent::kNo;
}

void take_over(FleetMemory& fleet, std::int64_t now) {
  fleet.flown = 1 - fleet.flown;
  fleet.announcement = Announcement::kTaken;
  restart_jobs(fleet);
  touch(fleet, now);
}

}  // namespace

void decide(FleetMemory& fleet, std::int64_t now, Work& work) noexcept {
  if (!is_pending(fleet)) return;
  work.spend(2 * ops::kTurn * fleet.peer_count);
  for (std::int32_t p = 0; is_open(fleet) && p < fleet.peer_count; ++p) {
    const Peer& peer = fleet.peers[p];
    if (peer.link.binds && is_asked(fleet, peer) && has_refused(fleet, peer))
      return drop(fleet, FleetBlock::kRefused, peer.id, now);
  }
  const std::int64_t takeover = next_plan(fleet).name.takeover;
  if (now < takeover) return;
  if (!is_open(fleet) || now > takeover + fleet.spec.tick) return drop(fleet, FleetBlock::kLate, 0, now);
  for (std::int32_t p = 0; p < fleet.peer_count; ++p) {
    const Peer& peer = fleet.peers[p];
    if (peer.link.binds && is_asked(fleet, peer) && !has_agreed(fleet, peer))
      return drop(fleet, FleetBlock::kUnanswered, peer.id, now);
  }
  take_over(fleet, now);
}

}  // namespace tern
