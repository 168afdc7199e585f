// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/peer.hpp"

namespace tern {
namespace {

bool is_needed(const Peer& peer, int slot) {
  if (!peer.plans[slot].is_complete()) return false;
  if (slot == peer.flown || slot == peer.held) return true;
  const PlanName& name = peer.names[slot];
  if (name.incarnation != peer.state.incarnation) return false;
  return name.number == peer.state.flown || name.number == peer.state.open;
}

/// The plan of the packet, or the one that is needed least: at least two never are, unless they are complete and
/// nothing is missing.
int slot_for(const Peer& peer, const PacketHead& head) {
  int worst = 0;
  bool found = false;
  for (int slot = 0; slot < kPeerPlans; ++slot) {
    if (peer.plans[slot].is_of(head)) return slot;
    if (is_needed(peer, slot)) continue;
    const std::uint32_t age = peer.packets - peer.last_packet[slot];
    if (!found || age > peer.packets - peer.last_packet[worst]) worst = slot;
    found = true;
  }
  return found ? worst : kPeerPlans;
}

/// True for a plan that is neither flown nor announced any more.
bool is_over(const StateHead& state, const PlanName& name) {
  if (name.incarnation != state.incarnation) return name.incarnation < state.incarnation;
  return name.number != state.flown && (name.number < state.flown || name.number < state.open);
}

}  // namespace

void forget_peer(Peer& peer, std::uint16_t id) noexcept {
  peer.id = id;
  peer.link = Link{0, 0, true, true, true, INT64_MAX, INT64_MAX};
  peer.heard = 0;
  peer.state = StateHead{};
  peer.answer = Answer{};
  peer.flown = peer.held = kNoPlan;
  peer.proven = 0;
  peer.judged = 0;
  peer.consent = Consent::kNone;
  peer.packets = 0;
  peer.state_crc = 0;
  peer.state_size = 0;
  peer.arriving.clear();
  for (int slot = 0; slot < kPeerPlans; ++slot) {
    peer.plans[slot].clear();
    peer.names[slot] = PlanName{};
    peer.last_packet[slot] = 0;
  }
}

std::int8_t find_plan(const Peer& peer, std::uint32_t number) noexcept {
  for (std::int8_t slot = 0; slot < kPeerPlans; ++slot) {
    const PlanName& name = peer.names[slot];
    const bool is_it = name.incarnation == peer.state.incarnation && name.number == number;
    if (is_it && peer.plans[slot].is_complete()) return slot;
  }
  return kNoPlan;
}

bool is_resolved(const Peer& peer) noexcept {
  return peer.flown != kNoPlan && peer.names[peer.flown].number == peer.state.flown;
}

Answer answer_to(const Peer& peer) noexcept {
  Answer answer{peer.id,       peer.state.incarnation, 0, Consent::kNone, false, peer.link.own,
                peer.link.its, is_offered(peer)};
  if (answer.incarnation == 0) return answer;
  answer.lacks_flown = !is_resolved(peer);
  for (int slot = 0; slot < kPeerPlans; ++slot) {
    const PlanName& name = peer.names[slot];
    const bool counts = peer.plans[slot].is_complete() && name.incarnation == answer.incarnation;
    if (counts && name.number > answer.number) answer.number = name.number;
  }
  if (answer.number == peer.judged) answer.consent = peer.consent;
  return answer;
}

Heard take_plan(Peer& peer, const PacketHead& head, const std::uint8_t* packet, std::int32_t size) noexcept {
  const int slot = slot_for(peer, head);
  if (slot == kPeerPlans) return Heard::kOld;
  Assembly<kMaxPlanBytes>& plan = peer.plans[slot];
  if (!plan.is_of(head)) {
    plan.open(head);
    peer.names[slot] = PlanName{};
  }
  if (plan.is_complete()) return Heard::kOld;
  peer.last_packet[slot] = ++peer.packets;
  plan.take(head, packet, size);
  if (!plan.is_complete()) return plan.size > 0 ? Heard::kNews : Heard::kDamaged;
  const bool is_sound = is_plan(plan.bytes, plan.size) && read_name(plan.bytes, plan.size).id == peer.id;
  if (is_sound) peer.names[slot] = read_name(plan.bytes, plan.size);
  if (is_sound && !is_over(peer.state, peer.names[slot])) return Heard::kNews;
  plan.clear();
  peer.names[slot] = PlanName{};
  return is_sound ? Heard::kOld : Heard::kDamaged;
}

void settle(Peer& peer) noexcept {
  const std::int8_t flown = find_plan(peer, peer.state.flown);
  if (flown == kNoPlan) return;
  peer.flown = flown;
  if (peer.held != kNoPlan && peer.names[peer.held].number != peer.state.open) peer.held = kNoPlan;
}

}  // namespace tern
