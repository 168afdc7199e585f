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

/// Vehicles in range that are no members.
struct Strangers {
  std::int32_t count = 0;
  Beacon* nearest = nullptr;
  double apart;  ///< how far away the nearest one is, m; the range if there is none
};

Strangers find_strangers(FleetMemory& fleet, std::int64_t now) {
  Strangers strangers;
  strangers.apart = fleet.spec.range.join;
  for (std::int32_t k = 0; k < fleet.beacons.count; ++k) {
    Beacon& beacon = fleet.beacons.of[k];
    if (beacon.is_member || is_stale(fleet, beacon, now)) continue;
    const double apart = axis_distance(beacon.place, fleet.beacons.place);
    if (apart > fleet.spec.range.join) continue;
    ++strangers.count;
    if (apart > strangers.apart) continue;
    strangers.apart = apart;
    strangers.nearest = &beacon;
  }
  return strangers;
}

/// How far a member is away, m; kNowhere if it was not heard of late.
double distance_to(FleetMemory& fleet, const Peer& peer, std::int64_t now) {
  const Beacon* const beacon = find_beacon(fleet.beacons, peer.id);
  if (beacon == nullptr || is_stale(fleet, *beacon, now)) return kNowhere;
  return axis_distance(beacon->place, fleet.beacons.place);
}

/// Who binds this vehicle changes only while the others are not told of a plan: that was proven for those who did. A
/// member that parts is near again if it is within `again`.
void update_link(FleetMemory& fleet, Peer& peer, double again, std::int64_t now) {
  Link& link = peer.link;
  const bool was_offered = is_offered(peer);
  const double most = link.is_near ? kStay * fleet.spec.range.join : again;
  link.is_near = distance_to(fleet, peer, now) <= most && !(link.parts && now <= link.trusted);
  const bool binds = (link.is_near && link.is_mutual) || now <= link.promised;
  if (binds != link.binds && !is_open(fleet)) {
    link.binds = binds;
    prove_again(fleet, static_cast<std::int32_t>(&peer - fleet.peers));
    prove_from(fleet.job, peer.id);
  }
  if (is_offered(peer) != was_offered) touch(fleet, now);
}

/// Of a full table, the farthest member parts if a stranger is much nearer: as many as there are strangers.
void make_room(FleetMemory& fleet, const Strangers& strangers, std::int64_t now, Work& work) {
  work.spend(ops::kRow * fleet.peer_count);
  std::int32_t parting = 0;
  Peer* farthest = nullptr;
  double most = kFarther * strangers.apart;
  for (std::int32_t p = 0; p < fleet.peer_count; ++p) {
    Peer& peer = fleet.peers[p];
    const double apart = distance_to(fleet, peer, now);
    if (!peer.link.is_near) ++parting;
    if (!peer.link.is_near || apart <= most) continue;
    most = apart;
    farthest = &peer;
  }
  if (farthest == nullptr || parting >= strangers.count) return;
  farthest->link.is_near = false;
  touch(fleet, now);
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
  const Strangers strangers = find_strangers(fleet, now);
  if (strangers.count > 0 && fleet.peer_count < kMaxNeighbours) add_member(fleet, *strangers.nearest, now);
  for (std::int32_t p = 0; p < fleet.peer_count; ++p) update_link(fleet, fleet.peers[p], strangers.apart, now);
  if (strangers.count > 0 && fleet.peer_count == kMaxNeighbours) make_room(fleet, strangers, now, work);
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
