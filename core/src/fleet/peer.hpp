// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a vehicle knows of another member: its newest state, and those of its plans that it may be flying.
#ifndef TERN_FLEET_PEER_HPP
#define TERN_FLEET_PEER_HPP

#include <cstdint>

#include "fleet/plan_bytes.hpp"
#include "fleet/state_bytes.hpp"
#include "tern/config.hpp"
#include "tern/fleet.hpp"

namespace tern {

constexpr std::int32_t kMaxStateBytes = in_whole_parts(state_bytes(kMaxNeighbours, true));
/// The plan that it flies, one that it may take over, and two that are arriving: what it flies and announces now.
constexpr int kPeerPlans = 4;
constexpr std::int8_t kNoPlan = -1;

/// What this vehicle and a member owe each other. While `binds`, each plan of this vehicle follows the rules of the
/// right of way towards the member: for ever if add() made it one, else while both are near and until this vehicle's
/// promise ends.
struct Link {
  std::uint32_t own;      ///< number of this vehicle's record of the member; 0: by add()
  std::uint32_t its;      ///< number of its record of this vehicle; 0: it has none
  bool is_near;           ///< it is in range
  bool is_mutual;         ///< its newest state answers this vehicle's record
  bool binds;             ///< this vehicle follows the rules
  std::int64_t promised;  ///< until when at least, as the member was told, ns
  std::int64_t trusted;   ///< until when the member promised to, on this vehicle's clock, ns
};

struct Peer {
  std::uint16_t id;
  Link link;
  std::int64_t heard;    ///< when the newest state came
  StateHead state;       ///< the newest; of incarnation 0 if none came
  Answer answer;         ///< in that state, to this vehicle
  std::int8_t flown;     ///< the plan that it was heard to fly; kNoPlan: not known
  std::int8_t held;      ///< a plan that this vehicle agreed to, and of which it is not known that it was dropped
  std::uint32_t proven;  ///< number of the own plan that is clear of what it may be flying, as far as the rules ask for
  std::uint32_t judged;  ///< number of the last plan that was judged; 0: none
  Consent consent;       ///< on that plan
  std::uint32_t packets;    ///< of plans that came
  std::uint32_t state_crc;  ///< of the newest state's bytes
  std::int32_t state_size;  ///< 0: none came
  Assembly<kMaxStateBytes> arriving;
  Assembly<kMaxPlanBytes> plans[kPeerPlans];
  PlanName names[kPeerPlans];             ///< of those that are complete
  std::uint32_t last_packet[kPeerPlans];  ///< when the last packet came, counted in `packets`
};

/// Makes this the record of a member of which nothing is known.
void forget_peer(Peer& peer, std::uint16_t id) noexcept;

/// The complete plan with this number, of the incarnation of the newest state; kNoPlan if it is not here.
std::int8_t find_plan(const Peer& peer, std::uint32_t number) noexcept;
/// The plan that it flies by its newest state is here.
bool is_resolved(const Peer& peer) noexcept;
/// What to tell it.
Answer answer_to(const Peer& peer) noexcept;

/// It is promised that this vehicle follows the rules, for another lease.
inline bool is_offered(const Peer& peer) {
  return peer.link.binds && peer.link.is_near && peer.link.is_mutual;
}

/// Takes a packet of a plan.
Heard take_plan(Peer& peer, const PacketHead& head, const std::uint8_t* packet, std::int32_t size) noexcept;
/// Learns from the newest state and the plans that are here what it may be flying. A newer state settles what became of
/// a plan that it was allowed: it flies it, or it dropped it, unless it still announces it.
void settle(Peer& peer) noexcept;

}  // namespace tern

#endif
