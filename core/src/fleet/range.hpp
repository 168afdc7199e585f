// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Members by range: who becomes one and for how long, and whether a plan needs nobody's agreement because it keeps
// clear of all that a vehicle may do.
#ifndef TERN_FLEET_RANGE_HPP
#define TERN_FLEET_RANGE_HPP

#include <cstdint>

#include "fleet/beacons.hpp"
#include "tern/fleet.hpp"

namespace tern {

struct FleetMemory;

/// True if members come by range.
bool is_by_range(const FleetMemory& fleet) noexcept;
/// Every tick: who is near becomes a member, and who is far away is none any more once nobody relies on it.
void update_members(FleetMemory& fleet, std::int64_t now, Work& work) noexcept;

/// A part of a plan, or all of it.
struct PlanPart {
  Box hull;    ///< from the plan's origin
  double end;  ///< s after the plan's beginning
};
PlanPart whole_of(const Trajectory& plan) noexcept;

/// A piece of the proof that the plan which is announced is clear, from its takeover until it rests, of all that any
/// vehicle may do which did not promise to ask or to tell until then: the next vehicle that was heard, and behind the
/// last one, all that were not. kRunning; kOk at its end: `why` and `by` say of whom the plan is not clear, if of any.
/// What was proven stays true, as vehicles are no faster than FleetRange::speed.
Status step_alone(FleetMemory& fleet, std::int64_t now, Work& work, FleetBlock& why, std::uint16_t& by) noexcept;

/// What was promised to members before begin().
struct Promises {
  std::int32_t count = 0;
  std::uint16_t ids[kMaxNeighbours];
  std::int64_t until[kMaxNeighbours];
};
Promises promises_of(const FleetMemory& fleet, std::int64_t now) noexcept;
/// Listens from now on, and keeps what was promised.
void begin_range(FleetMemory& fleet, const Promises& promises, std::int64_t now) noexcept;

}  // namespace tern

#endif
