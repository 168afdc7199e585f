// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fleet::write(): what the vehicle says of itself, packet by packet.
#include "fleet/fleet_access.hpp"

namespace tern {
namespace {

void write_own_state(FleetMemory& fleet) {
  StateHead state{};
  state.id = fleet.spec.id;
  state.incarnation = fleet.spec.incarnation;
  state.counter = ++fleet.counter;
  state.stamp = fleet.stamp;
  state.flown = fleet.own[fleet.flown].name.number;
  state.open = is_open(fleet) ? next_plan(fleet).name.number : 0;
  state.radius = whole_millimetres(fleet.spec.radius);
  state.priority = fleet.spec.priority;
  state.has_left = fleet.has_left;
  const bool by_range = is_by_range(fleet);
  if (by_range) state.until = fleet.beacons.now + fleet.spec.range.lease;
  ByteWriter out(fleet.state);
  write_state(state, by_range, static_cast<std::uint16_t>(fleet.peer_count), out);
  for (std::int32_t p = 0; p < fleet.peer_count; ++p) {
    Peer& peer = fleet.peers[p];
    append_answer(answer_to(peer), by_range, out);
    if (by_range && is_offered(peer)) peer.link.promised = state.until;
  }
  fleet.state_size = out.size();
  fleet.state_crc = crc32(fleet.state, fleet.state_size);
  fleet.has_changed = false;
  fleet.cursor.state_part = 0;
}

/// A member that can still do something with the plan has not got it.
bool is_wanted(const FleetMemory& fleet, int which) {
  if (which == 0 && !is_open(fleet)) return false;
  const std::uint32_t number = (which == 0 ? next_plan(fleet) : fleet.own[fleet.flown]).name.number;
  for (std::int32_t p = 0; p < fleet.peer_count; ++p) {
    const Peer& peer = fleet.peers[p];
    if (peer.state.has_left) continue;
    if (peer.answer.incarnation != fleet.spec.incarnation || peer.answer.number < number) return true;
    if (which == 1 && peer.answer.lacks_flown) return true;
  }
  return false;
}

void next(Cursor& cursor) {
  ++cursor.plan;
  cursor.plan_part = 0;
}

}  // namespace

std::int32_t Fleet::write(std::uint8_t* packet, std::int32_t room) noexcept {
  FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr || packet == nullptr || room < kLeastPacketBytes) return 0;
  if (is_by_range(*fleet) && room < kFleetBeaconRoom) return 0;
  Cursor& cursor = fleet->cursor;
  if (fleet->has_changed) write_own_state(*fleet);
  const std::uint16_t id = fleet->spec.id;
  if (is_by_range(*fleet) && !cursor.has_beacon) {
    cursor.has_beacon = true;
    return write_beacon(*fleet, packet, room);
  }
  if (cursor.state_part < parts_of(fleet->state_size)) {
    return write_packet(fleet->state, fleet->state_size, fleet->state_crc, id, packet, room, cursor.state_part);
  }
  for (; cursor.plan < 2; next(cursor)) {
    const OwnPlan& own = cursor.plan == 0 ? next_plan(*fleet) : fleet->own[fleet->flown];
    if (!is_wanted(*fleet, cursor.plan) || cursor.plan_part >= parts_of(own.size)) continue;
    return write_packet(own.bytes, own.size, own.crc, id, packet, room, cursor.plan_part);
  }
  cursor = Cursor{};
  return 0;
}

}  // namespace tern
