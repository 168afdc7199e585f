// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/fleet_memory.hpp"

namespace tern {
namespace {

std::int32_t place_in(const Beacons& beacons, std::int32_t id) {
  std::int32_t low = 0;
  std::int32_t high = beacons.count;
  while (low < high) {
    const std::int32_t middle = (low + high) / 2;
    if (beacons.of[middle].id < id) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/// Between the bodies' middle and surface, at least, m.
double gap_to(const FleetMemory& fleet, const Beacon& beacon, std::int64_t now) {
  return axis_distance(beacon.place, fleet.beacons.place) - strayed(fleet, seconds(now - beacon.stamp)) -
         1e-3 * beacon.radius;
}

/// The vehicle's own place is as old as its last tick.
void leave_out(FleetMemory& fleet, double gap, std::int64_t now) {
  gap -= fleet.spec.range.speed * seconds(fleet.spec.tick);
  NearestUnkept(&beyond)[2] = fleet.beacons.beyond;
  if (now - beyond[0].begun > fleet.spec.range.within) {
    beyond[1] = beyond[0];
    beyond[0] = {kNowhere, now};
  }
  beyond[0].gap = smaller(beyond[0].gap, gap);
}

void take_out(Beacons& beacons, std::int32_t at) {
  for (std::int32_t k = at + 1; k < beacons.count; ++k) beacons.of[k - 1] = beacons.of[k];
  --beacons.count;
}

/// True if there is room for a new one: a stale one or the farthest one goes, unless the new one is the farthest.
bool make_room(FleetMemory& fleet, const Beacon& next, std::int64_t now) {
  Beacons& beacons = fleet.beacons;
  if (beacons.count < kMaxBeacons) return true;
  std::int32_t worst = -1;
  double farthest = gap_to(fleet, next, now);
  for (std::int32_t k = 0; k < beacons.count; ++k) {
    const double gap = is_stale(fleet, beacons.of[k], now) ? kNowhere : gap_to(fleet, beacons.of[k], now);
    if (gap <= farthest) continue;
    farthest = gap;
    worst = k;
  }
  if (farthest < kNowhere) leave_out(fleet, farthest, now);
  if (worst >= 0) take_out(beacons, worst);
  return worst >= 0;
}

}  // namespace

double seconds(std::int64_t time) noexcept {
  return 1e-9 * static_cast<double>(time);
}

Beacon* find_beacon(Beacons& beacons, std::uint16_t id) noexcept {
  const std::int32_t at = place_in(beacons, id);
  return at < beacons.count && beacons.of[at].id == id ? &beacons.of[at] : nullptr;
}

const Beacon* beacon_from(const Beacons& beacons, std::int32_t id) noexcept {
  const std::int32_t at = place_in(beacons, id);
  return at < beacons.count ? &beacons.of[at] : nullptr;
}

std::int32_t find_peer(const FleetMemory& fleet, std::uint16_t id) noexcept {
  std::int32_t p = 0;
  while (p < fleet.peer_count && fleet.peers[p].id != id) ++p;
  return p;
}

bool is_stale(const FleetMemory& fleet, const Beacon& beacon, std::int64_t now) noexcept {
  return now - beacon.stamp > fleet.spec.range.within + fleet.spec.clock_error;
}

// What was left out less than `within` ago counts; older gaps, of vehicles that were heard again since, may count as
// well.
double gap_to_unkept(const FleetMemory& fleet, std::int64_t now) noexcept {
  double gap = kNowhere;
  for (const NearestUnkept& beyond : fleet.beacons.beyond) {
    if (now - beyond.begun <= 2 * fleet.spec.range.within) gap = smaller(gap, beyond.gap);
  }
  return gap;
}

double strayed(const FleetMemory& fleet, double since) noexcept {
  // A plan that is taken over late by a tick begins that far along, and the one before it went on as long.
  return fleet.spec.range.speed * (larger(since, 0.0) + seconds(fleet.spec.clock_error + 2 * fleet.spec.tick));
}

std::uint16_t whole_millimetres(double metres) noexcept {
  auto whole = static_cast<std::uint16_t>(1000.0 * metres);
  if (1e-3 * whole < metres) ++whole;
  return whole;
}

std::int32_t write_beacon(const FleetMemory& fleet, std::uint8_t* packet, std::int32_t room) noexcept {
  const Trajectory& flown = fleet.own[fleet.flown].plan;
  const std::int64_t now = fleet.beacons.now;
  const Vec3 place = evaluate(flown, time_on(flown, now)).position;
  std::uint8_t bytes[kBeaconBytes];
  ByteWriter out(bytes);
  out.put(form_of(MessageKind::kBeacon));
  out(fleet.spec.id, now, place.x, place.y, place.z, whole_millimetres(fleet.spec.radius));
  std::int32_t first = 0;
  return write_packet(bytes, kBeaconBytes, crc32(bytes, kBeaconBytes), fleet.spec.id, packet, room, first);
}

Heard hear_beacon(FleetMemory& fleet, const PacketHead& head, const std::uint8_t* packet, std::int32_t size,
                  std::int64_t now) noexcept {
  const std::uint8_t* const bytes = packet + kPacketHeadBytes;
  const bool is_whole = head.size == kBeaconBytes && head.first == 0 && size == kPacketHeadBytes + kBeaconBytes;
  if (!is_whole || bytes[0] != head.form || crc32(bytes, kBeaconBytes) != head.crc) return Heard::kDamaged;
  Beacon beacon{};
  ByteReader in(bytes, kBeaconBytes);
  in.skip(1);
  in(beacon.id, beacon.stamp, beacon.place.x, beacon.place.y, beacon.place.z, beacon.radius);
  if (beacon.id != head.id || !is_place(beacon.place)) return Heard::kDamaged;
  if (beacon.stamp < -kLatest || beacon.stamp > now + fleet.spec.clock_error) return Heard::kClockAhead;
  Beacons& beacons = fleet.beacons;
  if (Beacon* const known = find_beacon(beacons, beacon.id); known != nullptr) {
    if (beacon.stamp <= known->stamp) return Heard::kOld;
    if (is_stale(fleet, *known, now)) prove_from(fleet.job, beacon.id);
    beacon.is_member = known->is_member;
    *known = beacon;
    return Heard::kNews;
  }
  if (is_stale(fleet, beacon, now) || !make_room(fleet, beacon, now)) return Heard::kOld;
  const std::int32_t at = place_in(beacons, beacon.id);
  for (std::int32_t k = beacons.count++; k > at; --k) beacons.of[k] = beacons.of[k - 1];
  beacon.is_member = find_peer(fleet, beacon.id) < fleet.peer_count;
  beacons.of[at] = beacon;
  prove_from(fleet.job, beacon.id);
  return Heard::kNews;
}

}  // namespace tern
