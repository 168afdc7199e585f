// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Samples of a plan among things that move, before it is proven: most brakes that no proof accepts are told apart for a
// hundredth of a proof's price.
#ifndef TERN_FLIGHT_FORESIGHT_HPP
#define TERN_FLIGHT_FORESIGHT_HPP

#include <cstdint>

#include "base/work.hpp"
#include "flight/track_table.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// True if a plan is too near to a thing of the table at one of some instants from `from` on, seconds since its
/// beginning. `clearance`: of the vehicle, metres.
bool meets_thing(const Trajectory& plan, double from, const TrackTable& things, double clearance, Work& work) noexcept;

/// Steps for which a rest is looked at, and how long each is, seconds.
constexpr int kRestSteps = 10;
constexpr double kRestStep = 0.25;

/// For how many steps after `from`, seconds since its beginning, the end of a plan stays clear of the things of the
/// table: kRestSteps at most.
int rest_steps(const Trajectory& plan, double from, const TrackTable& things, double clearance, Work& work) noexcept;

}  // namespace tern

#endif
