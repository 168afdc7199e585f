// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/mission_watch.hpp"

#include <cmath>
#include <limits>

#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr std::int64_t kSample = 1000000;  ///< nanoseconds between two samples

const char* state_name(tern::PointState state) {
  constexpr const char* kNames[] = {"ahead", "passed", "skipped"};
  return kNames[static_cast<int>(state)];
}

}  // namespace

MissionWatch::MissionWatch(const FlightWorld& world, const tern::Flight& flight, Commands commands)
    : world_(world), flight_(flight), commands_(std::move(commands)) {
  for (const tern::Via& via : mission_of(world)) {
    points_.push_back({via.position, via.tolerance, "ahead", 0.0, std::numeric_limits<double>::infinity(), 0.0});
  }
}

/// The next point has the nearest sample of those since it is the next one.
void MissionWatch::approach(std::int64_t from, std::int64_t to) {
  for (std::int64_t t = from; leg_ < points_.size() && t <= to; t += kSample) {
    MissionPoint& point = points_[leg_];
    const tern::Sample sample = commands_(t);
    const tern::Vec3 off{sample.position.x - point.position.x, sample.position.y - point.position.y,
                         sample.position.z - point.position.z};
    if (!(length(off) < point.distance)) continue;
    point.distance = length(off);
    point.time = seconds_of(t);
    point.speed = length(sample.velocity);
  }
}

/// Between two samples the vehicle may come nearer by what it flies in half a step.
void MissionWatch::close(std::size_t i) {
  MissionPoint& point = points_[i];
  const tern::PointState state = flight_.point_state(static_cast<std::int32_t>(i));
  point.state = state_name(state);
  const double slack = 1e-9 + 0.5e-9 * static_cast<double>(kSample) * 1.01 * 2.0 * world_.settings.v_max;
  const double tolerance = i + 1 == points_.size() ? 0.0 : point.tolerance;
  if (state != tern::PointState::kPassed || point.distance <= tolerance + slack || !broken_.empty()) return;
  broken_ = "mission: point " + std::to_string(i + 1) + " counts as passed from " + brief(point.distance) + " m away";
}

void MissionWatch::move_goal(const tern::Vec3& goal, std::int64_t t) {
  points_.back().position = goal;
  points_.back().distance = std::numeric_limits<double>::infinity();
  last_ = t;
}

void MissionWatch::look(std::int64_t t, const tern::FlightReport& report) {
  const bool is_over = report.reason == tern::FlightReason::kArrived || report.reason == tern::FlightReason::kLanded;
  const std::size_t leg = static_cast<std::size_t>(report.leg) + (is_over ? 1 : 0);
  approach(last_, t);
  while (leg_ < leg) {
    close(leg_++);
    approach(last_, t);  // several may be passed in one tick
  }
  last_ = t;
}

}  // namespace tern_host
