// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences for a while, and places where the vehicle rests: a plan that ends in a keep-out that is about to begin, or in
// a keep-in that is about to end, leads into a trap, and a vehicle that rests in one leaves while it can.
#ifndef TERN_FLIGHT_CLOSING_HPP
#define TERN_FLIGHT_CLOSING_HPP

#include <cstdint>

#include "base/work.hpp"
#include "flight/flight_facts.hpp"
#include "tern/fence.hpp"

namespace tern {

/// Seconds that must be left besides the time to leave. With less than kLeaveSpare, the vehicle leaves; no plan to the
/// goal ends with less than kStaySpare, which is more, so that it does not come back at once. A way out needs none.
constexpr double kStaySpare = 6.0;
constexpr double kLeaveSpare = 4.0;

/// The first keep-out for a while that holds, or begins, before a vehicle could leave the place that rests there from
/// `rests` on, with `spare` seconds to spare. If there is none, the keep-in for a while that it must leave before it
/// ends for the next one; kNoFence: none either.
std::int32_t closing_fence(const FlightFacts& flight, const Vec3& place, std::int64_t rests, double spare,
                           Work& work) noexcept;

/// A place outside of the keep-out, and of all others that hold or begin meanwhile: the quickest straight way that
/// seems free (number 0), the next one (number 1), and so on, then the quickest again; the place itself if none seems
/// free.
Vec3 way_out_of(const FlightFacts& flight, const Fence& fence, const Vec3& place, std::int32_t number,
                Work& work) noexcept;

/// A place in a keep-in for a while around the place and in the next one of the chain, for a vehicle that rests at the
/// place from `rests` on: the one after which it may stay longest, nearest to the place (number 0) or to the next point
/// (number 1), then the next best ones; the place itself if there is none.
Vec3 way_on_from(const FlightFacts& flight, const Vec3& place, std::int64_t rests, std::int32_t number,
                 Work& work) noexcept;

/// True if the fence is a keep-out for a while that holds at this time, or begins within `ahead` seconds.
bool is_closed(const Fence& fence, std::int64_t time, double ahead) noexcept;

/// False if a vehicle at the place is in the keep-out, or nearer to it than the radius.
bool is_clear_of(const FlightFacts& flight, const Fence& fence, const Vec3& place, Work& work) noexcept;

}  // namespace tern

#endif
