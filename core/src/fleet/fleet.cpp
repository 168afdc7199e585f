// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/fleet.hpp"

#include <new>

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "base/work.hpp"
#include "fleet/fleet_access.hpp"

namespace tern {
namespace {

constexpr double kLargestRadius = 60.0;
constexpr std::int64_t kSecond = 1'000'000'000;

bool is_sound(const FleetRange& range) {
  if (!(finite(range.join) && range.join >= 0.0)) return false;
  return range.join <= 0.0 ||
         (finite(range.heard) && range.heard > 0.0 && finite(range.speed) && range.speed > 0.0 && range.within > 0 &&
          range.within <= kSecond * 60 && range.lease > 0 && range.lease <= kSecond * 3600);
}

bool is_sound(const FleetSpec& spec) {
  return spec.incarnation > 0 && finite(spec.radius) && spec.radius > 0.0 && spec.radius <= kLargestRadius &&
         spec.clock_error >= 0 && spec.clock_error <= kSecond && spec.tick > 0 && spec.tick <= kSecond &&
         finite(spec.speed) && spec.speed >= 0.0 && is_sound(spec.range);
}

void set(OwnPlan& own, const Trajectory& plan, const PlanName& name) {
  own.plan = plan;
  own.name = name;
  own.whole = whole_of(plan);
  own.size = write_plan(plan, name, own.bytes);
  own.crc = crc32(own.bytes, own.size);
}

/// True if the vehicle was a member and was removed, or if more were removed than are remembered.
bool was_removed(const FleetMemory& fleet, std::uint16_t id) {
  bool was = fleet.removed_count > kMaxNeighbours;
  for (std::int32_t k = 0; k < fleet.removed_count && !was; ++k) was = fleet.removed[k] == id;
  return was;
}

}  // namespace

void touch(FleetMemory& fleet, std::int64_t now) noexcept {
  fleet.has_changed = true;
  fleet.stamp = now;
}

void drop(FleetMemory& fleet, FleetBlock why, std::uint16_t by, std::int64_t now) noexcept {
  fleet.announcement = why == FleetBlock::kNone ? Announcement::kNone : Announcement::kDropped;
  fleet.blocked = why;
  fleet.blocked_by = by;
  restart_jobs(fleet);
  touch(fleet, now);
}

Status Fleet::begin(const FleetSpec& spec, const Trajectory& flown, std::int64_t now) noexcept {
  static_assert(sizeof(FleetMemory) <= sizeof(memory_), "raise kFleetBytes");
  static_assert(kMaxPlanBytes <= 65535 && kMaxStateBytes <= 65535, "sizes of messages have 16 bits");
  // A plan that lies in this fleet's own memory would be gone before it is read.
  const auto at = reinterpret_cast<std::uintptr_t>(&flown);
  const auto own = reinterpret_cast<std::uintptr_t>(memory_);
  if (at >= own && at < own + sizeof(memory_)) return Status::kInvalidArgument;
  if (!is_sound(spec) || flown.begin > now || !is_sendable(flown, flown.begin)) return Status::kInvalidArgument;
  const FleetMemory* const before = memory_of(*this);
  const Promises promises = before == nullptr ? Promises{} : promises_of(*before, now);
  FleetMemory& fleet = *new (memory_) FleetMemory{};
  set(fleet.own[0], flown, {spec.id, spec.incarnation, 1, flown.begin});
  fleet.has_begun = true;
  fleet.spec = spec;
  fleet.numbers = 1;
  begin_range(fleet, promises, now);
  touch(fleet, now);
  return Status::kOk;
}

Status Fleet::add(std::uint16_t id, std::int64_t now) noexcept {
  FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr || id == fleet->spec.id || is_by_range(*fleet)) return Status::kInvalidArgument;
  if (find_peer(*fleet, id) < fleet->peer_count) return Status::kOk;
  if (was_removed(*fleet, id)) return Status::kInvalidArgument;
  if (is_full(fleet->peer_count == kMaxNeighbours)) return Status::kNeighboursFull;
  forget_peer(fleet->peers[fleet->peer_count++], id);
  is_pending(*fleet) ? drop(*fleet, FleetBlock::kRestarted, id, now) : touch(*fleet, now);
  return Status::kOk;
}

Status Fleet::remove(std::uint16_t id, std::int64_t now) noexcept {
  FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr || is_by_range(*fleet)) return Status::kInvalidArgument;
  const std::int32_t p = find_peer(*fleet, id);
  if (p == fleet->peer_count) return Status::kInvalidArgument;
  if (fleet->removed_count < kMaxNeighbours) fleet->removed[fleet->removed_count] = id;
  ++fleet->removed_count;
  take_out_peer(*fleet, p);
  touch(*fleet, now);
  return Status::kOk;
}

Status Fleet::announce(const Trajectory& plan, std::int64_t takeover, std::int64_t now) noexcept {
  FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr || fleet->has_left || takeover <= now || fleet->numbers == UINT32_MAX) {
    return Status::kInvalidArgument;
  }
  const PlanName name{fleet->spec.id, fleet->spec.incarnation, fleet->numbers + 1, takeover};
  if (!is_sendable(plan, takeover)) return Status::kInvalidArgument;
  restart_jobs(*fleet);
  set(next_plan(*fleet), plan, name);
  ++fleet->numbers;
  fleet->announcement = Announcement::kProving;
  fleet->blocked = FleetBlock::kNone;
  fleet->blocked_by = 0;
  fleet->cursor = Cursor{};
  touch(*fleet, now);
  return Status::kOk;
}

void Fleet::withdraw(std::int64_t now) noexcept {
  FleetMemory* const fleet = memory_of(*this);
  if (fleet != nullptr && is_pending(*fleet)) drop(*fleet, FleetBlock::kNone, 0, now);
}

void Fleet::leave(std::int64_t now) noexcept {
  FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr) return;
  if (is_pending(*fleet)) drop(*fleet, FleetBlock::kNone, 0, now);
  fleet->has_left = true;
  touch(*fleet, now);
}

void Fleet::advance(std::int64_t now, Work& work) noexcept {
  FleetMemory* const fleet = memory_of(*this);
  if (fleet == nullptr) return;
  work.spend(ops::kPiece);
  decide(*fleet, now, work);
  if (is_by_range(*fleet)) update_members(*fleet, now, work);
  work_on_jobs(*fleet, now, work);
}

}  // namespace tern
