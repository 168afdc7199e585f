// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <new>

#include "tern/tern_fleet.h"

namespace {

using tern::Fleet;
using tern::Status;

/// A tern_fleet's first word once a fleet was begun there; the fleet follows it.
constexpr std::uint64_t kFleetTag = 0x7465726E2D666C74u;
constexpr std::uint8_t kInvalid = static_cast<std::uint8_t>(Status::kInvalidArgument);

static_assert(sizeof(std::uint64_t) + sizeof(Fleet) <= sizeof(tern_fleet) && alignof(Fleet) <= alignof(tern_fleet),
              "raise TERN_FLEET_WORDS");

std::uint8_t code(Status status) {
  return static_cast<std::uint8_t>(status);
}

/// Null if no fleet was begun. The memory may never have been written; reading its first word as volatile makes sure
/// that the word has one value.
Fleet* object(tern_fleet* fleet) {
  if (fleet == nullptr || *static_cast<const volatile std::uint64_t*>(fleet->opaque) != kFleetTag) return nullptr;
  return std::launder(reinterpret_cast<Fleet*>(fleet->opaque + 1));
}
const Fleet* object(const tern_fleet* fleet) {
  if (fleet == nullptr || *static_cast<const volatile std::uint64_t*>(fleet->opaque) != kFleetTag) return nullptr;
  return std::launder(reinterpret_cast<const Fleet*>(fleet->opaque + 1));
}

bool has_room(const tern_track* tracks, std::int32_t room, const tern_track_piece* pieces, std::int32_t piece_room) {
  return (room <= 0 || tracks != nullptr) && (piece_room <= 0 || pieces != nullptr);
}

}  // namespace

extern "C" {

std::uint8_t tern_fleet_begin(tern_fleet* fleet, const tern_fleet_spec* spec, const tern_trajectory* flown,
                              std::int64_t now) {
  if (fleet == nullptr || spec == nullptr || flown == nullptr) return kInvalid;
  Fleet* made = object(fleet);
  if (made == nullptr) {
    fleet->opaque[0] = kFleetTag;
    made = new (fleet->opaque + 1) Fleet;
  }
  return code(made->begin(*spec, *flown, now));
}

std::uint8_t tern_fleet_add(tern_fleet* fleet, std::uint16_t id, std::int64_t now) {
  Fleet* const of = object(fleet);
  return of == nullptr ? kInvalid : code(of->add(id, now));
}

std::uint8_t tern_fleet_remove(tern_fleet* fleet, std::uint16_t id, std::int64_t now) {
  Fleet* const of = object(fleet);
  return of == nullptr ? kInvalid : code(of->remove(id, now));
}

std::uint8_t tern_fleet_announce(tern_fleet* fleet, const tern_trajectory* plan, std::int64_t takeover,
                                 std::int64_t now) {
  Fleet* const of = object(fleet);
  return of == nullptr || plan == nullptr ? kInvalid : code(of->announce(*plan, takeover, now));
}

void tern_fleet_withdraw(tern_fleet* fleet, std::int64_t now) {
  Fleet* const of = object(fleet);
  if (of != nullptr) of->withdraw(now);
}

void tern_fleet_leave(tern_fleet* fleet, std::int64_t now) {
  Fleet* const of = object(fleet);
  if (of != nullptr) of->leave(now);
}

std::uint8_t tern_fleet_receive(tern_fleet* fleet, const std::uint8_t* packet, std::int32_t size, std::int64_t now) {
  Fleet* const of = object(fleet);
  return static_cast<std::uint8_t>(of == nullptr ? tern::Heard::kDamaged : of->receive(packet, size, now));
}

std::int32_t tern_fleet_write(tern_fleet* fleet, std::uint8_t* packet, std::int32_t room) {
  Fleet* const of = object(fleet);
  return of == nullptr ? 0 : of->write(packet, room);
}

void tern_fleet_advance(tern_fleet* fleet, std::int64_t now, std::uint32_t work) {
  Fleet* const of = object(fleet);
  tern::Work units(work);
  if (of != nullptr) of->advance(now, units);
}

void tern_fleet_get_report(const tern_fleet* fleet, tern_fleet_report* report) {
  const Fleet* const of = object(fleet);
  if (report != nullptr) *report = of == nullptr ? tern::FleetReport{} : of->report();
}

const tern_trajectory* tern_fleet_flown(const tern_fleet* fleet) {
  const Fleet* const of = object(fleet);
  return of == nullptr ? nullptr : of->flown();
}

const tern_trajectory* tern_fleet_announced(const tern_fleet* fleet) {
  const Fleet* const of = object(fleet);
  return of == nullptr ? nullptr : of->announced();
}

std::int32_t tern_fleet_neighbours(const tern_fleet* fleet) {
  const Fleet* const of = object(fleet);
  return of == nullptr ? 0 : of->neighbours();
}

void tern_fleet_neighbour(const tern_fleet* fleet, std::int32_t index, tern_neighbour* neighbour) {
  const Fleet* const of = object(fleet);
  if (neighbour != nullptr) *neighbour = of == nullptr ? tern::Neighbour{} : of->neighbour(index);
}

std::uint8_t tern_fleet_traffic(const tern_fleet* fleet, std::int64_t now, tern_track* tracks, std::int32_t room,
                                tern_track_piece* pieces, std::int32_t piece_room, std::int32_t* count) {
  const Fleet* const of = object(fleet);
  if (of == nullptr || count == nullptr || !has_room(tracks, room, pieces, piece_room)) return kInvalid;
  return code(of->traffic(now, tracks, room, pieces, piece_room, *count));
}

std::uint8_t tern_fleet_traffic_of(const tern_fleet* fleet, std::int32_t index, std::int64_t now, tern_track* tracks,
                                   std::int32_t room, tern_track_piece* pieces, std::int32_t piece_room,
                                   std::int32_t* count) {
  const Fleet* const of = object(fleet);
  if (of == nullptr || count == nullptr || !has_room(tracks, room, pieces, piece_room)) return kInvalid;
  return code(of->traffic_of(index, now, tracks, room, pieces, piece_room, *count));
}

}  // extern "C"
