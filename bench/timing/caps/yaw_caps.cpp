// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A yaw plan of as many pieces as there may be, with turns that its limits cannot follow anywhere.
#include "caps/cap.hpp"
#include "tern/yaw.hpp"

namespace tern_caps {
namespace {

constexpr double kDuration = 0.1 * tern::kMaxYawPieces;
constexpr int kTurns = 4 * tern::kMaxYawPieces / 10;
constexpr std::size_t kTrajectoryOffset = std::size_t{1} << 20;
constexpr std::size_t kPlanOffset = std::size_t{2} << 20;
constexpr std::size_t kTurnsOffset = std::size_t{3} << 20;

/// There and back by less than a half turn, every quarter of a second.
void fill(tern::TimedHeading (&turns)[kTurns]) {
  for (int i = 0; i < kTurns; ++i) turns[i] = {0.25 * (i + 1), {-0.9, i % 2 == 0 ? 0.4 : -0.4}};
}

}  // namespace

void yaw_caps() {
  auto& planner = state_at<tern::YawPlanner>(0);
  auto& trajectory = state_at<tern::Trajectory>(kTrajectoryOffset);
  auto& plan = state_at<tern::YawPlan>(kPlanOffset);
  auto& turns = state_at<tern::TimedHeading[kTurns]>(kTurnsOffset);
  fill(turns);
  trajectory.count = 1;
  trajectory.origin = {0.0, 0.0, 0.0};
  trajectory.segments[0] = {};
  trajectory.segments[0].duration = kDuration;
  tern::YawRequest request = tern::yaw_request({1.0, 0.0}, 1.0, 2.0);
  request.mode = tern::YawMode::kTimed;
  request.timed = turns;
  request.timed_count = kTurns;
  const std::uint64_t instructions = count([&] { planner.plan(trajectory, request, plan); });
  std::uint64_t units = 0;
  tern::Status status = planner.begin(trajectory, request);
  for (; status == tern::Status::kRunning; ++units) status = planner.step(1);
  report({"yaw_pieces", "yaw", instructions, static_cast<std::uint64_t>(plan.count), tern::kMaxYawPieces, units, 1});
}

}  // namespace tern_caps
