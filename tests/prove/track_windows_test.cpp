// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proofs against fences for a while: by hand, and beside dense samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/random.hpp"
#include "support/timed_proof.hpp"
#include "tern/track_proof.hpp"

namespace tern_test {
namespace {

using namespace tern;

std::int64_t ns(double seconds) {
  return std::llround(seconds * 1e9);
}

/// A box for a while, with its half-spaces.
struct TimedBox {
  TimedBox(FenceKind kind, const Vec3& lower, const Vec3& upper, double from, double until, double clock_error = 0.0) {
    box_planes({lower, upper}, planes);
    fence = {planes, kBoxPlanes, kind, ns(from), ns(until), clock_error};
  }

  Halfspace planes[kBoxPlanes];
  Fence fence;
};

TimedAnswer prove(const Trajectory& plan, const std::vector<TimedBox>& boxes, double radius = 0.5, double rest = 0.0) {
  std::vector<Fence> fences;
  for (const TimedBox& box : boxes) {
    fences.push_back(box.fence);
    fences.back().planes = box.planes;
  }
  TrackGrounds grounds;
  grounds.fences = fences.data();
  grounds.fence_count = static_cast<std::int32_t>(fences.size());
  grounds.radius = radius;
  grounds.rest = rest;
  return prove_from(0.0, plan, grounds);
}

void expect_met(const TimedAnswer& answer, double when, std::int32_t fence) {
  EXPECT_EQ(answer.report.finding, Finding::kFence);
  EXPECT_EQ(answer.report.fence, fence);
  EXPECT_EQ(answer.report.track, kNoTrack);
  EXPECT_LE(answer.until, when + 1e-8);
  EXPECT_GE(answer.until, when - kEarly);
}

void expect_clear(const TimedAnswer& answer, double until) {
  EXPECT_EQ(answer.report.finding, Finding::kNone);
  EXPECT_EQ(answer.report.fence, kNoFence);
  EXPECT_DOUBLE_EQ(answer.until, until);
}

/// Across the way at x = 2 .. 2.5; the curve is within half a metre of it from 0.75 s to 1.5 s.
TimedBox across(double from, double until, double clock_error = 0.0) {
  return {FenceKind::kKeepOut, {2.0, -1.0, -1.0}, {2.5, 1.0, 1.0}, from, until, clock_error};
}

TEST(TrackWindows, KeepOutForAWhile) {
  expect_clear(prove(along_x(), {across(-5.0, 0.75)}), 2.0);
  expect_clear(prove(along_x(), {across(1.5, 9.0)}), 2.0);
  expect_met(prove(along_x(), {across(0.0, 9.0)}), 0.75, 0);
  expect_met(prove(along_x(), {across(1.0, 9.0)}), 1.0, 0);
  expect_met(prove(along_x(), {across(1.6, 9.0), across(0.0, 0.8)}), 0.75, 1);
}

/// It counts on both sides.
TEST(TrackWindows, ClockErrorWidensKeepOutsAndNarrowsKeepIns) {
  expect_met(prove(along_x(), {across(-5.0, 0.7, 0.1)}), 0.75, 0);
  expect_met(prove(along_x(), {across(1.55, 9.0, 0.1)}), 1.45, 0);
  expect_clear(prove(along_x(), {across(1.65, 9.0, 0.1)}), 2.0);
  const TimedBox room(FenceKind::kKeepIn, {-1.0, -1.0, -1.0}, {5.0, 1.0, 1.0}, -0.1, 2.1, 0.05);
  expect_clear(prove(along_x(), {room}), 2.0);
  TimedBox late = room;
  late.fence.clock_error = 0.2;
  expect_met(prove(along_x(), {late}), 0.0, 0);
}

/// One room after the other, in place and in time; the radius plays no part.
TEST(TrackWindows, KeepInsAreAChain) {
  const TimedBox first(FenceKind::kKeepIn, {0.0, 0.0, 0.0}, {2.5, 0.0, 0.0}, 0.0, 1.2);
  const TimedBox second(FenceKind::kKeepIn, {1.5, -1.0, -1.0}, {4.0, 1.0, 1.0}, 0.9, 3.0);
  expect_clear(prove(along_x(), {first, second}), 2.0);
  expect_clear(prove(along_x(), {second, first}), 2.0);
  expect_met(prove(along_x(), {first}), 1.2, 0);
  // Both hold, but the curve is out of the first one before it is in the second.
  const TimedBox apart(FenceKind::kKeepIn, {2.6, -1.0, -1.0}, {4.0, 1.0, 1.0}, 0.0, 3.0);
  TimedBox lasting = first;
  lasting.fence.until = ns(3.0);
  expect_met(prove(along_x(), {lasting, apart}), 1.25, 0);
  // The second one begins when the first one is over.
  TimedBox after = second;
  after.fence.from = first.fence.until;
  expect_clear(prove(along_x(), {first, after}), 2.0);
  after.fence.from += 1;
  expect_met(prove(along_x(), {first, after}), 1.2, 0);
}

TEST(TrackWindows, RestCountsToo) {
  const TimedBox room(FenceKind::kKeepIn, {-1.0, -1.0, -1.0}, {5.0, 1.0, 1.0}, 0.0, 6.0);
  expect_clear(prove(along_x(), {room}, 0.5, 4.0), 6.0);
  expect_met(prove(along_x(), {room}, 0.5, 5.0), 6.0, 0);
  const TimedBox parking(FenceKind::kKeepOut, {3.6, -1.0, -1.0}, {4.4, 1.0, 1.0}, 7.0, 9.0);
  expect_met(prove(along_x(), {parking}, 0.5, 100.0), 7.0, 0);
  expect_clear(prove(along_x(), {parking}, 0.5, 5.0), 7.0);
}

/// Thirty years after the clock began, and a thousand kilometres away.
TEST(TrackWindows, OldClocksFarAway) {
  const std::int64_t begin = 1000000000 * kSecond + 5;
  TimedBox box(FenceKind::kKeepOut, {1e6 + 2.0, -1.0, -1.0}, {1e6 + 2.5, 1.0, 1.0}, 0.0, 1.0);
  box.fence.from = begin + ns(1.0);
  box.fence.until = begin + ns(9.0);
  expect_met(prove(along_x({1e6, 0.0, 0.0}, begin), {box}), 1.0, 0);
  box.fence.from = begin + ns(1.5) + 1;
  expect_clear(prove(along_x({1e6, 0.0, 0.0}, begin), {box}), 2.0);
}

TEST(TrackWindows, WhatAlwaysHoldsIsNotLookedAt) {
  TimedBox box = across(0.0, 9.0);
  box.fence.from = box.fence.until = 7;
  expect_clear(prove(along_x(), {box}), 2.0);
}

TEST(TrackWindows, RefusesWhatARequestRefuses) {
  const auto status_with = [](void (*spoil)(Fence&)) {
    TimedBox box = across(0.0, 9.0);
    spoil(box.fence);
    TrackGrounds grounds;
    box.fence.planes = box.planes;
    grounds.fences = &box.fence;
    grounds.fence_count = 1;
    TrackProof proof;
    const Trajectory plan = along_x();
    const Status status = proof.begin(plan, 0.0, grounds);
    EXPECT_EQ(proof.report().fence, status == Status::kRunning ? kNoFence : 0);
    return status;
  };
  EXPECT_EQ(status_with([](Fence&) {}), Status::kRunning);
  EXPECT_EQ(status_with([](Fence& f) { f.until = -1; }), Status::kInvalidArgument);
  EXPECT_EQ(status_with([](Fence& f) { f.clock_error = -1e-9; }), Status::kInvalidArgument);
  EXPECT_EQ(status_with([](Fence& f) { f.clock_error = std::numeric_limits<double>::quiet_NaN(); }),
            Status::kInvalidArgument);
  EXPECT_EQ(status_with([](Fence& f) { f.count = 0; }), Status::kInvalidArgument);
}

/// Where a curve is at a time, by de Casteljau.
Vec3 place_at(const Trajectory& plan, double time) {
  int s = 0;
  while (s + 1 < plan.count && time > plan.segments[s].duration) time -= plan.segments[s++].duration;
  const double u = std::min(time / plan.segments[s].duration, 1.0);
  Vec3 points[kControlPoints];
  for (int i = 0; i < kControlPoints; ++i) points[i] = plan.segments[s].points[i];
  for (int last = kDegree; last > 0; --last) {
    for (int i = 0; i < last; ++i) {
      points[i] = {points[i].x + u * (points[i + 1].x - points[i].x), points[i].y + u * (points[i + 1].y - points[i].y),
                   points[i].z + u * (points[i + 1].z - points[i].z)};
    }
  }
  return points[0];
}

double outside(const TimedBox& box, const Vec3& p) {
  double square = 0.0;
  double most = -1e9;
  const double at[3] = {p.x, p.y, p.z};
  for (int k = 0; k < kBoxPlanes; ++k) {
    const Vec3& n = box.planes[k].normal;
    const double by = n.x * at[0] + n.y * at[1] + n.z * at[2] - box.planes[k].offset;
    most = std::max(most, by);
    if (by > 0.0) square += by * by;
  }
  return most > 0.0 ? std::sqrt(square) : most;
}

/// By how much the curve breaks the fences at a time; an instant before and after a window does not count.
double broken_at(const std::vector<TimedBox>& boxes, const Trajectory& plan, double time, double radius) {
  constexpr double kInstant = 1e-6;
  const Vec3 p = place_at(plan, time);
  double worst = -1e9;
  double keep_in = 1e9;
  bool has_keep_in = false;
  for (const TimedBox& box : boxes) {
    const double from = 1e-9 * static_cast<double>(box.fence.from);
    const double until = 1e-9 * static_cast<double>(box.fence.until);
    if (box.fence.kind == FenceKind::kKeepIn) {
      has_keep_in = true;
      const bool holds =
          time > from + box.fence.clock_error - kInstant && time < until - box.fence.clock_error + kInstant;
      if (holds) keep_in = std::min(keep_in, outside(box, p));
    } else if (time > from - box.fence.clock_error + kInstant && time < until + box.fence.clock_error - kInstant) {
      worst = std::max(worst, radius - outside(box, p));
    }
  }
  return has_keep_in ? std::max(worst, keep_in) : worst;
}

/// Random curves and windows: no sample breaks what is proven, and what ends a proof is broken soon.
TEST(TrackWindows, BesideSamples) {
  Random random(77);
  int proven = 0;
  int lost = 0;
  for (int round = 0; round < scaled(400); ++round) {
    Trajectory plan{};
    plan.count = 2;
    Vec3 at{0.0, 0.0, 0.0};
    for (int s = 0; s < 2; ++s) {
      plan.segments[s].duration = random.real(0.5, 2.0);
      for (int i = 0; i < kControlPoints; ++i) {
        if (i > 0) {
          at = {at.x + random.real(-0.2, 0.6), at.y + random.real(-0.4, 0.4), at.z + random.real(-0.3, 0.3)};
        }
        plan.segments[s].points[i] = at;
      }
    }
    const double radius = random.real(0.05, 0.4);
    std::vector<TimedBox> boxes;
    const int count = 1 + static_cast<int>(random.real(0.0, 4.0));
    const bool has_keep_ins = random.real(0.0, 1.0) < 0.5;
    for (int k = 0; k < count; ++k) {
      const bool keeps_in = has_keep_ins && k > 0;
      const double from = random.real(-1.0, 2.0);
      const double size = keeps_in ? 1.6 : 0.4;
      const Vec3 c{random.real(-0.5, 3.0), random.real(-1.5, 1.5), random.real(-1.0, 1.0)};
      boxes.emplace_back(keeps_in ? FenceKind::kKeepIn : FenceKind::kKeepOut, Vec3{c.x - size, c.y - size, c.z - size},
                         Vec3{c.x + size, c.y + size, c.z + size}, from, from + random.real(0.01, 4.0),
                         random.real(0.0, 0.05));
    }
    const TimedAnswer answer = prove(plan, boxes, radius);
    const double end = plan.segments[0].duration + plan.segments[1].duration;
    answer.report.finding == Finding::kNone ? ++proven : ++lost;
    for (int k = 0; answer.until > 0.0 && k <= 2000; ++k) {
      const double time = answer.until * k / 2000.0;
      ASSERT_LE(broken_at(boxes, plan, time, radius), 5e-9) << round << " at " << time << " of " << answer.until;
    }
    if (answer.report.finding == Finding::kNone) continue;
    double worst = -1e9;
    for (int k = 0; k <= 2000; ++k) {
      const double time = std::min(end, answer.until + 1e-3 * k / 2000.0);
      worst = std::max(worst, broken_at(boxes, plan, time, radius));
    }
    EXPECT_GE(worst, -1e-5) << round << " was lost at " << answer.until;
  }
  EXPECT_GT(proven, 0);
  EXPECT_GT(lost, 0);
}

}  // namespace
}  // namespace tern_test
