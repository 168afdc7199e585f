// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A plan as the bytes of a message, and the track that it is to those who receive it. Control points are whole numbers
// of 16 bits, in a unit that is a power of two, relative to the plan's origin; those that two segments share are sent
// once. Each is off by half a unit on each axis at most, so the curve is, too: half a cube's diagonal is its error.
// Durations and times are exact.
#ifndef TERN_FLEET_PLAN_BYTES_HPP
#define TERN_FLEET_PLAN_BYTES_HPP

#include <cstdint>

#include "base/work.hpp"
#include "fleet/packets.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Bytes before the durations and points of a plan.
constexpr std::int32_t kPlanHeadBytes = 54;
/// Bytes of a plan of so many segments: 8 for each duration, 6 for each point.
constexpr std::int32_t plan_bytes(std::int32_t segments) {
  return kPlanHeadBytes + 6 + 50 * segments;
}
constexpr std::int32_t kMaxPlanBytes = in_whole_parts(plan_bytes(kMaxSegments));
/// What write_plan() and read_plan() take at most.
constexpr Operations plan_work(std::int32_t segments) {
  return 24 * ops::kPiece + segments * ops::kCurve;
}

/// Whose plan it is, which one, and when it is taken over, ns. A vehicle numbers its plans from 1 in each incarnation.
struct PlanName {
  std::uint16_t id;
  std::uint32_t incarnation;
  std::uint32_t number;
  std::int64_t takeover;
};

/// ns: no time that is sent is later, or earlier than its negative, so that no difference of two overflows.
constexpr std::int64_t kLatest = std::int64_t{1} << 61;
/// False for a place with coordinates that are not finite or too large.
bool is_place(const Vec3& place) noexcept;

/// False for a plan that cannot be flown in a fleet: without segments, with numbers that are not finite or too large,
/// a beginning after the takeover, or an end in motion.
bool is_sendable(const Trajectory& plan, std::int64_t takeover) noexcept;
/// Writes a plan to `bytes`, which has room for kMaxPlanBytes. Returns their number; 0 for one that is not sendable.
std::int32_t write_plan(const Trajectory& plan, const PlanName& name, std::uint8_t* bytes) noexcept;

/// True for the bytes of a plan that this build has room for, whoever wrote them. Only then may they be read.
bool is_plan(const std::uint8_t* bytes, std::int32_t size) noexcept;
PlanName read_name(const std::uint8_t* bytes, std::int32_t size) noexcept;
std::int32_t read_piece_count(const std::uint8_t* bytes, std::int32_t size) noexcept;

/// The tube in which the sender is as long as it flies the plan, if its clock is off by `clock_error` ns at most: the
/// plan, with the error of the points and of the clock, behind a wait of `clock_error` at its beginning, and at rest
/// after its end. `pieces` has room for kMaxSegments + 1.
void read_plan(const std::uint8_t* bytes, std::int32_t size, std::int64_t clock_error, TrackPiece* pieces,
               Track& track) noexcept;

}  // namespace tern

#endif
