// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keep-ins for a while are the links of a chain: the vehicle must always be in one of those that hold. Where a vehicle
// that rests in a link may go before that ends.
#ifndef TERN_FLIGHT_CHAIN_HPP
#define TERN_FLIGHT_CHAIN_HPP

#include <cstdint>

#include "base/work.hpp"
#include "flight/flight_facts.hpp"

namespace tern {

/// A way from a link around the vehicle into one that it meets, in which the vehicle may stay in the chain for longer
/// than where it rests.
struct WayOn {
  std::int32_t from;
  std::int32_t to;
  double until;  ///< the vehicle must be in both links by then, seconds since it rests
  double lasts;  ///< so long it may then stay in the chain, seconds since it rests
};

/// Ways that are told apart: those after which the vehicle may stay longest.
constexpr std::int32_t kWaysOn = 4;

struct WaysOn {
  std::int32_t count = 0;
  WayOn way[kWaysOn];

  /// Those that last longer come first, then those that leave more time.
  void add(const WayOn& added) noexcept;
};

/// The ways on for a vehicle that rests at the place from `rests` on. None if it may stay there for as long as anywhere
/// that it could go, or if no link around it holds.
WaysOn ways_on(const FlightFacts& flight, const Vec3& place, std::int64_t rests, Work& work) noexcept;

/// The place in both links of the way that is nearest to another place, up to two voxels away from their faces. False
/// if the keep-ins that always hold leave none.
bool place_on(const FlightFacts& flight, const WayOn& way, const Vec3& near, Vec3& found, Work& work) noexcept;

/// Finds out which links meet within the keep-ins that always hold.
void find_meetings(FlightFacts& flight) noexcept;

}  // namespace tern

#endif
