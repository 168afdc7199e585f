// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/export/held_end.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr double kLongestHold = 60.0;  // s; the Crazyflie's compressed form has room for 65.535
constexpr double kSame = 1e-6;         // m

}  // namespace

bool ends_at_rest(const tern::Trajectory& trajectory) {
  if (trajectory.count < 1) return true;
  const tern::Vec3* points = trajectory.segments[trajectory.count - 1].points;
  const tern::Vec3& end = points[tern::kDegree];
  double most = 0.0;
  for (int i = tern::kDegree - 2; i < tern::kDegree; ++i) {  // those that make velocity and acceleration
    most = std::max(
        {most, std::fabs(points[i].x - end.x), std::fabs(points[i].y - end.y), std::fabs(points[i].z - end.z)});
  }
  return most <= kSame;
}

double export_end(const PlanResult& result) {
  const double end = tern::duration(result.trajectory);
  if (result.yaw == nullptr || !ends_at_rest(result.trajectory)) return end;
  return std::max(end, tern::duration(*result.yaw));
}

tern::Trajectory held_trajectory(const PlanResult& result) {
  tern::Trajectory held = result.trajectory;
  const double rest = export_end(result) - tern::duration(held);
  if (!(rest > 0.0)) return held;
  const double pieces = std::ceil(rest / kLongestHold);
  if (held.count + pieces > tern::kMaxSegments) {
    throw std::runtime_error("the plan has " + std::to_string(held.count) +
                             " segments, and no room is left to hold the position for " + fixed(rest, 3) +
                             " s until the yaw plan ends. Plan a faster yaw (yaw_rate_max) or fewer segments");
  }
  tern::Segment hold = held.segments[held.count - 1];
  hold.duration = rest / pieces;
  for (tern::Vec3& point : hold.points) point = hold.points[tern::kDegree];
  for (int i = 0; i < static_cast<int>(pieces); ++i) held.segments[held.count++] = hold;
  return held;
}

}  // namespace tern_host
