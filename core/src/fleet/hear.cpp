// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fleet::receive(): packets become messages, and messages what is known of a member.
#include "base/capacity.hpp"
#include "fleet/fleet_access.hpp"

namespace tern {
namespace {

bool differ(const Answer& a, const Answer& b) {
  return a.incarnation != b.incarnation || a.number != b.number || a.consent != b.consent ||
         a.lacks_flown != b.lacks_flown || a.link != b.link || a.its != b.its || a.promises != b.promises;
}

bool is_newer(const StateHead& state, const StateHead& than) {
  return state.incarnation != than.incarnation ? state.incarnation > than.incarnation : state.counter > than.counter;
}

/// The member began anew, or left. It may have been asked about the plan that is announced, and is asked no more, or
/// the other way round; what it was allowed before it began anew does not count any more.
void meet_again(FleetMemory& fleet, Peer& peer, bool has_begun, std::int64_t now) {
  if (is_pending(fleet) && peer.link.binds) drop(fleet, FleetBlock::kRestarted, peer.id, now);
  if (!has_begun) return;
  peer.flown = peer.held = kNoPlan;
  peer.judged = 0;
  peer.consent = Consent::kNone;
}

/// A promise that a member with the same lease can have made by now.
bool is_lease(const FleetMemory& fleet, std::int64_t until, std::int64_t now) {
  return until >= -kLatest && until <= now + fleet.spec.clock_error + fleet.spec.range.lease;
}

/// What the newest state says of the two records of each other.
void hear_link(const FleetMemory& fleet, const StateHead& state, const Answer& answer, bool has_begun, Link& link) {
  link.its = answer.link;
  link.is_mutual = answer.incarnation == fleet.spec.incarnation && answer.its == link.own && answer.link != 0;
  if (has_begun) link.trusted = 0;
  const std::int64_t until = state.until - fleet.spec.clock_error;
  if (link.is_mutual && answer.promises && until > link.trusted) link.trusted = until;
}

Heard hear_state(FleetMemory& fleet, Peer& peer, std::int64_t now) {
  StateHead state{};
  Answer answer{};
  bool by_range = false;
  const bool is_state = read_state(peer.arriving.bytes, peer.arriving.size, fleet.spec.id, state, by_range, answer);
  const std::uint32_t crc = peer.arriving.crc;
  const std::int32_t size = peer.arriving.size;
  peer.arriving.clear();
  if (!is_state || state.id != peer.id) return Heard::kDamaged;
  const auto ahead = static_cast<std::uint64_t>(state.stamp) - static_cast<std::uint64_t>(now);
  if (state.stamp > now && ahead > static_cast<std::uint64_t>(fleet.spec.clock_error)) return Heard::kClockAhead;
  if (!is_newer(state, peer.state)) return Heard::kOld;
  if (by_range != is_by_range(fleet)) return Heard::kStranger;
  if (by_range && !is_lease(fleet, state.until, now)) return Heard::kClockAhead;
  const bool has_begun = state.incarnation != peer.state.incarnation || (by_range && answer.link != peer.link.its);
  if (has_begun || state.has_left != peer.state.has_left) meet_again(fleet, peer, has_begun, now);
  if (by_range) hear_link(fleet, state, answer, has_begun, peer.link);
  // A member may have taken this over unasked, before it made the promise that this state brings. So what was proven of
  // it before counts no more, even if the proof about it is over.
  if (by_range && state.flown != peer.state.flown) prove_again(fleet, find_peer(fleet, peer.id));
  peer.state = state;
  peer.answer = answer;
  peer.state_crc = crc;
  peer.state_size = size;
  peer.heard = now;
  return Heard::kNews;
}

Heard take_state(FleetMemory& fleet, Peer& peer, const PacketHead& head, const std::uint8_t* packet, std::int32_t size,
                 std::int64_t now) {
  if (is_full(head.size > kMaxStateBytes)) return Heard::kTooLong;
  if (!peer.arriving.is_of(head)) peer.arriving.open(head);
  peer.arriving.take(head, packet, size);
  if (peer.arriving.is_complete()) return hear_state(fleet, peer, now);
  return peer.arriving.size > 0 ? Heard::kNews : Heard::kDamaged;
}

Heard take(FleetMemory& fleet, Peer& peer, const PacketHead& head, const std::uint8_t* packet, std::int32_t size,
           std::int64_t now) {
  if (head.form != form_of(MessageKind::kPlan)) return take_state(fleet, peer, head, packet, size, now);
  if (is_full(head.size > kMaxPlanBytes)) return Heard::kTooLong;
  return take_plan(peer, head, packet, size);
}

}  // namespace

Heard Fleet::receive(const std::uint8_t* packet, std::int32_t size, std::int64_t now) noexcept {
  FleetMemory* const fleet = memory_of(*this);
  PacketHead head{};
  if (fleet == nullptr || !read_packet(packet, size, head)) return Heard::kDamaged;
  if (head.form >> 4 != kMessageVersion) return Heard::kOtherVersion;
  if ((head.form & 15u) > static_cast<unsigned>(MessageKind::kRangeState)) return Heard::kDamaged;
  if (head.id == fleet->spec.id) return Heard::kSelf;
  if (head.form == form_of(MessageKind::kBeacon)) {
    return is_by_range(*fleet) ? hear_beacon(*fleet, head, packet, size, now) : Heard::kOld;
  }
  const std::int32_t p = find_peer(*fleet, head.id);
  if (p == fleet->peer_count) return Heard::kStranger;

  Peer& peer = fleet->peers[p];
  // A state is sent again until it changes.
  const bool is_state = head.form != form_of(MessageKind::kPlan);
  if (is_state && head.size == peer.state_size && head.crc == peer.state_crc) return Heard::kOld;
  const Answer before = answer_to(peer);
  const std::uint32_t open = peer.state.open;
  const std::int8_t flown = peer.flown;
  const std::int8_t held = peer.held;
  const Heard heard = take(*fleet, peer, head, packet, size, now);
  settle(peer);
  if (differ(before, answer_to(peer))) touch(*fleet, now);
  if (open != peer.state.open || flown != peer.flown || held != peer.held) restart_jobs_about(*fleet, p);
  return heard;
}

}  // namespace tern
