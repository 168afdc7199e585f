// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/work.hpp"
#include "fleet/fleet_memory.hpp"

namespace tern {
namespace {

/// Members stay members until they are farther away than this part of the range.
constexpr double kStay = 1.25;
/// A member gives way to a vehicle that is not in the table, if it is farther away by this part.
constexpr double kFarther = 1.1;

void add_member(FleetMemory& fleet, Beacon& beacon, std::int64_t now) {
  Peer& peer = fleet.peers[fleet.peer_count++];
  forget_peer(peer, beacon.id);
  peer.link = Link{};
  peer.link.own = ++fleet.beacons.links;
  beacon.is_member = true;
  touch(fleet, now);
}

void remove_member(FleetMemory& fleet, std::int32_t p, std::int64_t now, Work& work) {
  work.spend(ops::kElement * static_cast<Operations>(sizeof(Peer) / sizeof(double)) + ops::kTurn * fleet.peer_count);
  Beacon* const beacon = find_beacon(fleet.beacons, fleet.peers[p].id);
  if (beacon != nullptr) beacon->is_member = false;
  take_out_peer(fleet, p);
  touch(fleet, now);
}

/// The nearest vehicle in range that is no member; null if there is none.
Beacon* nearest_stranger(FleetMemory& fleet, std::int64_t now) {
  Beacon* nearest = nullptr;
  double least = fleet.spec.range.join;
  for (std::int32_t k = 0; k < fleet.beacons.count; ++k) {
    Beacon& beacon = fleet.beacons.of[k];
    if (beacon.is_member || is_stale(fleet, beacon, now)) continue;
    const double apart = axis_distance(beacon.place, fleet.beacons.place);
    if (apart > least) continue;
    least = apart;
    nearest = &beacon;
  }
  return nearest;
}

/// Who binds this vehicle changes only while the others are not told of a plan: that was proven for those who did.
void update_link(FleetMemory& fleet, Peer& peer, double stay, std::int64_t now) {
  const Beacon* const beacon = find_beacon(fleet.beacons, peer.id);
  const bool is_near =
      beacon != nullptr && !is_stale(fleet, *beacon, now) && axis_distance(beacon->place, fleet.beacons.place) <= stay;
  Link& link = peer.link;
  const bool was_offered = is_offered(peer);
  link.is_near = is_near;
  const bool binds = (is_near && link.is_mutual) || now <= link.promised;
  if (binds != link.binds && !is_open(fleet)) {
    link.binds = binds;
    prove_again(fleet, static_cast<std::int32_t>(&peer - fleet.peers));
    prove_from(fleet.job, peer.id);
  }
  if (is_offered(peer) != was_offered) touch(fleet, now);
}

bool is_over(const Peer& peer, std::int64_t now) {
  return !peer.link.is_near && !peer.link.binds && now > peer.link.trusted;
}

}  // namespace

bool is_by_range(const FleetMemory& fleet) noexcept {
  return fleet.spec.range.join > 0.0;
}

void update_members(FleetMemory& fleet, std::int64_t now, Work& work) noexcept {
  work.spend(ops::kCurve + (ops::kDot + ops::kTurn) * fleet.beacons.count + ops::kPiece * fleet.peer_count);
  const Trajectory& flown = fleet.own[fleet.flown].plan;
  fleet.beacons.now = now;
  fleet.beacons.place = evaluate(flown, time_on(flown, now)).position;
  Beacon* const stranger = nearest_stranger(fleet, now);
  double stay = kStay * fleet.spec.range.join;
  if (stranger != nullptr && fleet.peer_count < kMaxNeighbours) {
    add_member(fleet, *stranger, now);
  } else if (stranger != nullptr) {
    stay = smaller(stay, kFarther * axis_distance(stranger->place, fleet.beacons.place));
  }
  for (std::int32_t p = 0; p < fleet.peer_count; ++p) update_link(fleet, fleet.peers[p], stay, now);
  for (std::int32_t p = fleet.peer_count - 1; p >= 0; --p) {
    if (is_over(fleet.peers[p], now)) remove_member(fleet, p, now, work);
  }
  // What is promised is promised anew in time.
  if (now - fleet.stamp > fleet.spec.range.lease / 8) touch(fleet, now);
}

Promises promises_of(const FleetMemory& fleet, std::int64_t now) noexcept {
  Promises promises;
  if (!is_by_range(fleet)) return promises;
  for (std::int32_t p = 0; p < fleet.peer_count; ++p) {
    if (fleet.peers[p].link.promised < now) continue;
    promises.ids[promises.count] = fleet.peers[p].id;
    promises.until[promises.count++] = fleet.peers[p].link.promised;
  }
  return promises;
}

void begin_range(FleetMemory& fleet, const Promises& promises, std::int64_t now) noexcept {
  if (!is_by_range(fleet)) return;
  const Trajectory& flown = fleet.own[fleet.flown].plan;
  fleet.beacons.begun = fleet.beacons.now = now;
  fleet.beacons.place = evaluate(flown, time_on(flown, now)).position;
  for (NearestUnkept& beyond : fleet.beacons.beyond) beyond = {kNowhere, now};
  for (std::int32_t k = 0; k < promises.count; ++k) {
    Peer& peer = fleet.peers[fleet.peer_count++];
    forget_peer(peer, promises.ids[k]);
    peer.link = Link{};
    peer.link.own = ++fleet.beacons.links;
    peer.link.promised = promises.until[k];
    peer.link.binds = true;
  }
}

}  // namespace tern
