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
void update_members(FleetMemory& fleet, std::int64_t now) noexcept;

/// True if the plan that is announced is clear, from its takeover until it rests, of all that any vehicle may do which
/// did not promise to ask or to tell until then. Else `why` and `by` say of whom it is not.
bool is_clear_alone(const FleetMemory& fleet, std::int64_t now, Work& work, FleetBlock& why,
                    std::uint16_t& by) noexcept;

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
