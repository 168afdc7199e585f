// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a vehicle knows of all others that it hears: who was where, and when.
#ifndef TERN_FLEET_BEACONS_HPP
#define TERN_FLEET_BEACONS_HPP

#include <cstdint>

#include "base/math.hpp"
#include "fleet/packets.hpp"
#include "tern/fleet.hpp"

namespace tern {

struct FleetMemory;

/// Where a vehicle was.
struct Beacon {
  std::uint16_t id;
  std::uint16_t radius;  ///< mm
  bool is_member;        ///< it has a Peer
  std::int64_t stamp;    ///< when, on its clock, ns
  Vec3 place;            ///< m, world frame
};
/// More than any distance, m.
constexpr double kNowhere = 1e300;
constexpr std::int32_t kBeaconBytes = 37;
static_assert(kPacketHeadBytes + in_whole_parts(kBeaconBytes) == kFleetBeaconRoom, "tern/fleet.hpp says so");

/// Besides the vehicles in the table, there may be others: of those left out since `begun`, for as long as
/// FleetRange::within, none was nearer.
struct NearestUnkept {
  double gap;          ///< m, on the axis on which it is largest
  std::int64_t begun;  ///< ns
};

/// All that is heard of vehicles near and far, in the order of their ids.
struct Beacons {
  std::int32_t count;
  std::uint32_t links;      ///< members that were added, counted
  std::int64_t begun;       ///< when listening began, ns
  std::int64_t now;         ///< of the last Fleet::advance(), ns
  Vec3 place;               ///< of the vehicle at `now`
  NearestUnkept beyond[2];  ///< those that the table had no room for, of late and before
  Beacon of[kMaxBeacons];
};

/// A radius in millimetres, rounded up.
std::uint16_t whole_millimetres(double metres) noexcept;
/// The largest part of the way from one place to another along an axis, m.
inline double axis_distance(const Vec3& a, const Vec3& b) {
  return larger(larger(absolute(a.x - b.x), absolute(a.y - b.y)), absolute(a.z - b.z));
}

/// Of nanoseconds.
double seconds(std::int64_t time) noexcept;
/// Null if the table has none.
Beacon* find_beacon(Beacons& beacons, std::uint16_t id) noexcept;
/// The one with the least id from `id` on; null if there is none.
const Beacon* beacon_from(const Beacons& beacons, std::int32_t id) noexcept;
/// Its place in FleetMemory::peers; peer_count if it is no member.
std::int32_t find_peer(const FleetMemory& fleet, std::uint16_t id) noexcept;
/// How near a vehicle that the table had no room for was of late, at least, m.
double gap_to_unkept(const FleetMemory& fleet, std::int64_t now) noexcept;
/// It is not true any more that the vehicle would be heard if it were near.
bool is_stale(const FleetMemory& fleet, const Beacon& beacon, std::int64_t now) noexcept;
/// How far a vehicle may be from its place `since` s later, by this vehicle's clock: on each axis, m.
double strayed(const FleetMemory& fleet, double since) noexcept;

/// Writes the vehicle's own beacon as a packet, `room` at least kFleetBeaconRoom. Its size.
std::int32_t write_beacon(const FleetMemory& fleet, std::uint8_t* packet, std::int32_t room) noexcept;
/// Takes the packet of a beacon.
Heard hear_beacon(FleetMemory& fleet, const PacketHead& head, const std::uint8_t* packet, std::int32_t size,
                  std::int64_t now) noexcept;

}  // namespace tern

#endif
