// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/yaw/yaw_wish.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

tern::Heading heading_of(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

void expect_count(const char* mode, const char* wanted, bool right, std::size_t found, const Place& place) {
  if (!right) throw_count(std::string("yaw ") + mode, wanted, found, place);
}

std::vector<tern::TimedHeading> timed_headings(const std::vector<double>& v, const Place& place) {
  std::vector<tern::TimedHeading> timed;
  for (std::size_t i = 0; i + 1 < v.size(); i += 2) {
    timed.push_back({v[i], heading_of(yaw_angle("yaw timed", v[i + 1], place))});
  }
  return timed;
}

}  // namespace

const char* yaw_mode_word(tern::YawMode mode) {
  switch (mode) {
    case tern::YawMode::kFixed:
      return "fixed";
    case tern::YawMode::kAlongMotion:
      return "motion";
    case tern::YawMode::kTowardsPoint:
      return "point";
    case tern::YawMode::kTimed:
      return "timed";
  }
  return "unknown";
}

void read_yaw_record(const Words& words, const Place& place, YawWish& wish) {
  const std::string mode = words.size() > 1 ? words[1] : "";
  const std::vector<double> v =
      words.size() > 1 ? numbers(Words(words.begin() + 1, words.end()), place) : std::vector<double>{};
  if (mode == "motion") {
    expect_count("motion", "no number", v.empty(), v.size(), place);
    wish.mode = tern::YawMode::kAlongMotion;
  } else if (mode == "fixed") {
    expect_count("fixed", "1 number", v.size() == 1, v.size(), place);
    wish.mode = tern::YawMode::kFixed;
    wish.heading = yaw_angle("yaw fixed", v[0], place);
  } else if (mode == "point") {
    expect_count("point", "3 numbers", v.size() == 3, v.size(), place);
    wish.mode = tern::YawMode::kTowardsPoint;
    wish.point = {v[0], v[1], v[2]};
  } else if (mode == "timed") {
    expect_count("timed", "a time and an angle, any number of times", !v.empty() && v.size() % 2 == 0, v.size(), place);
    wish.mode = tern::YawMode::kTimed;
    wish.timed = timed_headings(v, place);
  } else {
    throw RecordError(place, "'yaw' is 'motion', 'fixed', 'point' or 'timed', found " + quote(mode));
  }
}

tern::Status plan_yaw(const YawWish& wish, const tern::Trajectory& trajectory, tern::YawPlan& plan) {
  tern::YawRequest request = tern::yaw_request(heading_of(wish.start), wish.rate_max, wish.acceleration_max);
  request.mode = wish.mode;
  request.start_rate = wish.start_rate;
  request.start_acceleration = wish.start_acceleration;
  request.heading = heading_of(wish.heading);
  request.point = wish.point;
  request.timed = wish.timed.data();
  request.timed_count = static_cast<std::int32_t>(wish.timed.size());
  return std::make_unique<tern::YawPlanner>()->plan(trajectory, request, plan);
}

YawPeaks yaw_peaks(const tern::YawPlan& plan) {
  YawPeaks peaks{0.0, 0.0};
  const int samples = 50 * (plan.count + 1);
  for (int i = 0; i <= samples; ++i) {
    const tern::YawSample sample = tern::evaluate(plan, tern::duration(plan) * i / samples);
    peaks.rate = std::max(peaks.rate, std::fabs(sample.yaw.rate));
    peaks.acceleration = std::max(peaks.acceleration, std::fabs(sample.acceleration));
  }
  return peaks;
}

}  // namespace tern_host
