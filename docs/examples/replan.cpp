// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The README's loop: plans anew in flight whenever the map has changed. Exit status 0 where the goal is reached.
#include <cstdint>
#include <cstdio>

#include "tern/tern.hpp"

namespace {

constexpr double kCycle = 0.1;  // seconds

tern::Workspace workspace;
std::uint64_t words[9729];

/// Stands for a sensor: a pillar in the way comes into sight bit by bit. True where there is something new.
bool look_around(tern::Grid& grid, const tern::Vec3& from) {
  static double seen = 0.0;
  if (from.x < 2.0 || seen > 3.0) return false;
  seen += 0.5;
  return grid.mark_box({{4.0, 0.0, 0.0}, {4.5, seen, 3.0}}) == tern::Status::kOk;
}

bool clear_of_pillar(const tern::Trajectory& plan) {
  for (double t = 0.0; t < tern::duration(plan); t += 0.01) {
    const tern::Vec3 at = tern::evaluate(plan, t).position;
    if (at.x > 4.0 && at.x < 4.5 && at.y < 3.5 + 0.3) return false;
  }
  return true;
}

/// Stands for the vehicle's own emergency stop.
void brake(const tern::Sample& at) {
  std::printf("braking at %.1f %.1f %.1f\n", at.position.x, at.position.y, at.position.z);
}

/// Flies `plan`, and what replaces it, to its end.
void fly(tern::Planner& planner, tern::Grid& grid, tern::Request request, tern::Trajectory& plan) {
  tern::Trajectory next;
  tern::Report report;
  for (double t = kCycle; t < tern::duration(plan); t += kCycle) {  // t: time on the plan when this cycle ends
    const tern::Sample at = tern::evaluate(plan, t);
    if (!look_around(grid, at.position)) continue;  // yours: mark what the sensors see
    grid.inflate();
    request.start = {at.position, at.velocity, at.acceleration, at.jerk};  // the new plan begins where this cycle ends
    request.previous = &plan;                                              // the fallback: the rest of this plan
    request.previous_time = t;
    request.goal_mode = tern::GoalMode::kNearest;  // if the goal is cut off, fly as near to it as possible
    if (planner.plan(grid, request, next, report) != tern::Status::kOk) {
      if (tern::clear_until(grid, plan, t) < tern::duration(plan)) return brake(at);  // yours: something is in the way
      continue;                                                                       // fly on along this plan
    }
    plan = next;
    t = report.entered;  // 0, or as before if the old plan goes on
  }
}

}  // namespace

int main() {
  tern::Grid grid;
  grid.bind({{0, 0, 0}, 0.1, {100, 80, 30}, {{0, 0, 0}, {10, 8, 3}}, 0.3, 0}, words, 9729);
  grid.inflate();
  tern::Request request;
  request.start.position = {1, 1, 1};
  request.goal.position = {9, 1, 1};
  request.limits = {{2, 2, 1}, {4, 4, 2}};
  tern::Planner planner(&workspace, sizeof workspace);
  tern::Trajectory plan;
  tern::Report report;
  if (planner.plan(grid, request, plan, report) != tern::Status::kOk) return 1;
  fly(planner, grid, request, plan);
  const tern::Vec3 begin = tern::evaluate(plan, 0.0).position;
  const tern::Vec3 end = tern::evaluate(plan, tern::duration(plan)).position;
  std::printf("the last plan leads from %.1f %.1f %.1f to %.1f %.1f %.1f\n", begin.x, begin.y, begin.z, end.x, end.y,
              end.z);
  return begin.x > 2.0 && end.x > 8.999 && clear_of_pillar(plan) ? 0 : 1;
}
