// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>

#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "tern/trajectory.hpp"

namespace tern {
namespace {

int segments_of(const Trajectory& trajectory) {
  return trajectory.count < kMaxSegments ? trajectory.count : kMaxSegments;
}

/// Position to snap of one segment at u in [0, 1].
Sample sample(const Segment& segment, double u) {
  Sample result{};
  Vec3* const derivatives[] = {&result.position, &result.velocity, &result.acceleration, &result.jerk, &result.snap};
  Curve curve = curve_of(segment);
  for (Vec3* const derivative : derivatives) {
    *derivative = value(curve, u);
    curve = hodograph(curve, segment.duration);
  }
  return result;
}

/// The sample past the end: the last position, at rest.
Sample hold(const Trajectory& trajectory, const Segment& last) {
  return Sample{trajectory.origin + last.points[kDegree], kZero, kZero, kZero, kZero};
}

}  // namespace

double duration(const Trajectory& trajectory) noexcept {
  double sum = 0.0;
  const int count = segments_of(trajectory);
  for (int i = 0; i < count; ++i) sum += trajectory.segments[i].duration;
  return sum;
}

double time_on(const Trajectory& trajectory, std::int64_t now) noexcept {
  const bool is_later = now >= trajectory.begin;
  // The difference may not fit into 63 bits; unsigned, it is exact.
  const auto a = static_cast<std::uint64_t>(now);
  const auto b = static_cast<std::uint64_t>(trajectory.begin);
  const double seconds = static_cast<double>(is_later ? a - b : b - a) * 1e-9;
  return is_later ? seconds : -seconds;
}

Sample evaluate(const Trajectory& trajectory, double t) noexcept {
  const int count = segments_of(trajectory);
  if (count <= 0) return Sample{kZero, kZero, kZero, kZero, kZero};
  const double time = t > 0.0 ? t : 0.0;  // NaN compares false
  // Sums the durations in the same order as duration(), so that a time of duration() is past the end.
  double begin = 0.0;
  int index = 0;
  while (index < count && time >= begin + trajectory.segments[index].duration) {
    begin += trajectory.segments[index].duration;
    ++index;
  }
  if (index == count) return hold(trajectory, trajectory.segments[count - 1]);
  const Segment& segment = trajectory.segments[index];
  Sample result = sample(segment, smaller((time - begin) / segment.duration, 1.0));
  result.position = trajectory.origin + result.position;
  return result;
}

double snap_cost(const Trajectory& trajectory) noexcept {
  double cost = 0.0;
  for (int i = 0; i < segments_of(trajectory); ++i) {
    const Curve snap = snap_of(trajectory.segments[i]);
    cost += integral_of_product(snap, snap, trajectory.segments[i].duration);
  }
  return cost;
}

}  // namespace tern
