// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/progress.hpp"

#include <cmath>

#include "tern_onboard/notices.hpp"

namespace tern_onboard {
namespace {

constexpr std::int64_t kPatience = 30000000000;  // ns
constexpr double kNearer = 0.5;                  // m that count as progress

/// The flight rests, and goes no further by itself.
bool has_given_up(const tern::FlightReport& report) {
  using Reason = tern::FlightReason;
  const Reason r = report.reason;
  return report.mode == tern::FlightMode::kRest &&
         (r == Reason::kNearest || r == Reason::kNoProgress || r == Reason::kGoalUnseen || r == Reason::kHemmedIn ||
          r == Reason::kViaBlocked || r == Reason::kViaUnreachable || r == Reason::kGroundUnseen ||
          r == Reason::kGroundUneven || r == Reason::kHeldUp);
}

/// It is not under way: without a goal, at the goal, or because no frames come, which is said elsewhere.
bool does_not_try(tern::FlightReason reason) {
  using Reason = tern::FlightReason;
  return reason == Reason::kNoGoal || reason == Reason::kArrived || reason == Reason::kLanded ||
         reason == Reason::kMapStale;
}

}  // namespace

double narrowest_way(const MapSettings& map) {
  return map.cell * (2.0 * std::ceil((map.radius + map.tracking_margin) / map.cell - 1e-9) + 1.0);
}

std::string narrowest_way_text(const MapSettings& map) {
  return "a way must be more than " + metres(narrowest_way(map)) + " wide: radius (" + metres(map.radius) +
         ") and tracking_margin (" + metres(map.tracking_margin) + ") on both sides, in voxels of cell (" +
         metres(map.cell) + "); what the sensor does not see beside walls comes on top (docs/map.md, Gaps)";
}

const char* Progress::note(const tern::FlightReport& report, double away, std::int64_t now) {
  const bool rested = rested_;
  rested_ = has_given_up(report);
  if (rested_ && !rested) return "the vehicle rests before its goal";
  if (!begun_ || away < nearest_ - kNearer) {
    nearest_ = away;
    nearest_at_ = now;
    begun_ = true;
  }
  if (rested_ || does_not_try(report.reason)) nearest_at_ = now;
  if (now - nearest_at_ < kPatience) return nullptr;
  nearest_at_ = now;
  return "for 30 s, the vehicle has come no nearer to its goal";
}

}  // namespace tern_onboard
