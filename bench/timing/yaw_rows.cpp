// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "timing/yaw_rows.hpp"

#include "baremetal-aarch64/counters.hpp"
#include "baremetal/board.hpp"

namespace tern_timing {
namespace {

using tern::YawMode;

constexpr const char* kModeNames[] = {"fixed", "motion", "point", "timed"};
constexpr double kRateMax = 1.0;
constexpr double kAccelerationMax = 2.0;

/// Turns that the limits cannot follow: both are at work all the time.
constexpr tern::TimedHeading kZigzag[] = {{0.5, {0.0, 1.0}}, {1.0, {1.0, 0.0}}, {1.5, {0.0, -1.0}}, {2.5, {-1.0, 0.1}},
                                          {3.0, {1.0, 0.0}}, {4.0, {0.0, 1.0}}, {6.0, {1.0, 1.0}}};
constexpr std::int32_t kZigzagCount = sizeof kZigzag / sizeof kZigzag[0];

}  // namespace

bool YawRows::plan(const tern::Trajectory& trajectory, const tern::YawRequest& request) {
  const std::uint64_t begin = tern_board::counter();
  if (planner_.plan(trajectory, request, yaw_) != tern::Status::kOk) return false;
  const std::uint64_t count = tern_board::counter() - begin;
  Cost cost{count, 0};
  tern::Status status = planner_.begin(trajectory, request);
  while (status == tern::Status::kRunning) {
    const std::uint64_t before = tern_board::counter();
    status = planner_.step(1);
    const std::uint64_t unit = tern_board::counter() - before;
    if (unit > longest_unit_) longest_unit_ = unit;
    ++cost.work;
  }
  Cost& most = most_[static_cast<int>(request.mode)];
  if (cost.count > most.count) most = cost;
  return status == tern::Status::kOk;
}

bool YawRows::add(const tern::Trajectory& trajectory) {
  tern::YawRequest request = tern::yaw_request({1.0, 0.0}, kRateMax, kAccelerationMax);
  request.heading = {-1.0, 0.5};
  request.point = tern::evaluate(trajectory, 0.5 * tern::duration(trajectory)).position;
  request.timed = kZigzag;
  request.timed_count = kZigzagCount;
  bool ok = true;
  for (int mode = 0; mode < kModes; ++mode) {
    request.mode = static_cast<YawMode>(mode);
    ok = plan(trajectory, request) && ok;
  }
  return ok;
}

void YawRows::print() const {
  for (int mode = 0; mode < kModes; ++mode) {
    tern_board::print("yaw,", kModeNames[mode], ",", most_[mode].count, ",", most_[mode].work, ",", tern::kYawWorkBound,
                      "\n");
  }
  tern_board::print("yaw,yaw unit,", longest_unit_, ",1,1\n");
}

}  // namespace tern_timing
