// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every stop that is accepted is one, by sampling: within the limits, smooth, from the state to rest.
#include "curve/stopping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/math.hpp"
#include "support/box_corridor.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::scaled;

double least_of(const Vec3& least, const Vec3& most, int a) {
  return axis(least, a) < 0.0 ? axis(least, a) : -axis(most, a);
}

/// Excess over the limits, relative; below zero where they are kept.
double excess(const Vec3& v, const Vec3& least, const Vec3& most, double horizontal) {
  double worst = -1.0;
  for (int a = 0; a < 3; ++a) {
    const double x = axis(v, a);
    worst = std::max(worst, x / (x < 0.0 ? least_of(least, most, a) : axis(most, a)) - 1.0);
  }
  return horizontal > 0.0 ? std::max(worst, std::hypot(v.x, v.y) / horizontal - 1.0) : worst;
}

double speed_excess(const Vec3& v, const Limits& l) {
  return excess(v, l.v_min, l.v_max, l.v_horizontal);
}
double pull_excess(const Vec3& a, const Limits& l) {
  return excess(a, l.a_min, l.a_max, l.a_horizontal);
}

Vec3 random_within(Random& random, const Vec3& least, const Vec3& most, double horizontal) {
  Vec3 v;
  do {
    for (int a = 0; a < 3; ++a) axis(v, a) = random.real(least_of(least, most, a), axis(most, a));
  } while (excess(v, least, most, horizontal) > 0.0);
  return v;
}

Sample at(const Segment& segment, double t) {
  Trajectory one{};
  one.count = 1;
  one.segments[0] = segment;
  return evaluate(one, t);
}

/// The last instant that the segment itself speaks for.
Sample end_of(const Segment& segment) {
  return at(segment, std::nextafter(segment.duration, 0.0));
}

/// What rounding control points of a few metres does to a derivative.
double rounding(double duration, int order) {
  const double factor[4] = {1.0, 14.0, 168.0, 1680.0};
  return 1e-13 * factor[order] / std::pow(duration, order) + 1e-9;
}

void expect_joins(const Segment& before, const Segment& after) {
  const Sample left = end_of(before);
  const Sample right = at(after, 0.0);
  const double shorter = std::min(before.duration, after.duration);
  ASSERT_EQ(std::memcmp(&before.points[kDegree], &after.points[0], sizeof(Vec3)), 0);
  for (int a = 0; a < 3; ++a) {
    ASSERT_NEAR(axis(left.velocity, a), axis(right.velocity, a), rounding(shorter, 1));
    ASSERT_NEAR(axis(left.acceleration, a), axis(right.acceleration, a), rounding(shorter, 2));
    ASSERT_NEAR(axis(left.jerk, a), axis(right.jerk, a), rounding(shorter, 3));
  }
}

void expect_begins_at(const Segment& segment, const State& state) {
  const Sample first = at(segment, 0.0);
  for (int a = 0; a < 3; ++a) {
    ASSERT_EQ(axis(segment.points[0], a), axis(state.position, a));
    ASSERT_NEAR(axis(first.velocity, a), axis(state.velocity, a), rounding(segment.duration, 1));
    ASSERT_NEAR(axis(first.acceleration, a), axis(state.acceleration, a), rounding(segment.duration, 2));
    ASSERT_NEAR(axis(first.jerk, a), axis(state.jerk, a), rounding(segment.duration, 3));
  }
}

void expect_rests(const Segment& segment) {
  const Sample last = end_of(segment);
  for (int a = 0; a < 3; ++a) {
    ASSERT_NEAR(axis(last.velocity, a), 0.0, rounding(segment.duration, 1));
    ASSERT_NEAR(axis(last.acceleration, a), 0.0, rounding(segment.duration, 2));
    ASSERT_NEAR(axis(last.jerk, a), 0.0, rounding(segment.duration, 3));
  }
}

void expect_keeps(const Segment& segment, const Limits& limits) {
  const int steps = 40;
  for (int k = 0; k <= steps; ++k) {
    const bool joint = k == 0 || k == steps;
    const Sample sample = k == steps ? end_of(segment) : at(segment, segment.duration * k / steps);
    const double claim = joint ? kStopTolerance : 1e-6;
    ASSERT_LE(speed_excess(sample.velocity, limits), claim + rounding(segment.duration, 1)) << k;
    ASSERT_LE(pull_excess(sample.acceleration, limits), claim + rounding(segment.duration, 2)) << k;
    if (!(limits.j_max.x > 0.0)) continue;
    ASSERT_LE(excess(sample.jerk, {}, limits.j_max, 0.0), claim + rounding(segment.duration, 3)) << k;
  }
}

void expect_stops(const State& state, const Limits& limits, const Stopping& stopping) {
  ASSERT_GE(stopping.count, 1);
  ASSERT_LE(stopping.count, kStoppingSegments);
  ASSERT_NO_FATAL_FAILURE(expect_begins_at(stopping.segments[0], state));
  ASSERT_NO_FATAL_FAILURE(expect_rests(stopping.segments[stopping.count - 1]));
  for (int i = 0; i < stopping.count; ++i) {
    ASSERT_GT(stopping.segments[i].duration, 0.0);
    ASSERT_NO_FATAL_FAILURE(expect_keeps(stopping.segments[i], limits)) << "segment " << i;
    if (i == 0) continue;
    ASSERT_NO_FATAL_FAILURE(expect_joins(stopping.segments[i - 1], stopping.segments[i])) << "joint " << i;
  }
}

bool same_bits(const Stopping& a, const Stopping& b) {
  if (a.count != b.count) return false;
  for (int i = 0; i < a.count; ++i) {
    if (std::memcmp(a.segments[i].points, b.segments[i].points, sizeof a.segments[i].points) != 0) return false;
    if (std::memcmp(&a.segments[i].duration, &b.segments[i].duration, sizeof(double)) != 0) return false;
  }
  return true;
}

/// Flown backwards: the same places, speeds and jerks of the other sign.
void expect_reverse_of(const Stopping& forwards, const Stopping& back) {
  ASSERT_EQ(forwards.count, back.count);
  for (int i = 0; i < forwards.count; ++i) {
    const Segment& one = forwards.segments[i];
    const Segment& other = back.segments[back.count - 1 - i];
    ASSERT_EQ(one.duration, other.duration);
    for (const double u : {0.2, 0.5, 0.9}) {
      const Sample a = at(one, u * one.duration);
      const Sample b = at(other, (1.0 - u) * one.duration);
      for (int k = 0; k < 3; ++k) {
        ASSERT_NEAR(axis(a.position, k), axis(b.position, k), 1e-9);
        ASSERT_NEAR(axis(a.velocity, k), -axis(b.velocity, k), rounding(one.duration, 1) + 1e-8);
      }
    }
  }
}

TEST(Stopping, EveryAcceptedChoiceIsAStop) {
  Random random(61);
  int accepted = 0;
  int of_kind[4] = {0, 0, 0, 0};
  for (int i = 0; i < scaled(12); ++i) {
    const Limits limits = i % 2 == 0 ? tern_test::random_limits(random) : tern_test::random_uneven_limits(random);
    const State state{{random.real(-5, 5), random.real(-5, 5), random.real(-5, 5)},
                      random_within(random, limits.v_min, limits.v_max, limits.v_horizontal),
                      random_within(random, limits.a_min, limits.a_max, limits.a_horizontal)};
    for (int choice = 0; choice < kStoppingChoices; ++choice) {
      Stopping stopping;
      if (!make_stopping(state, limits, choice, stopping)) continue;
      ++accepted;
      const int index = choice % kStoppingManoeuvres;
      const int axes = kBrakeShapes + kAxisBrakes;
      ++of_kind[index < kBrakeShapes ? 0 : (index < axes ? 1 : (index < axes + 2 * kTurns ? 2 : 3))];
      ASSERT_NO_FATAL_FAILURE(expect_stops(state, limits, stopping)) << "state " << i << ", choice " << choice;
      Stopping back = stopping;
      reverse(back);
      ASSERT_NO_FATAL_FAILURE(expect_reverse_of(stopping, back));
      EXPECT_FALSE(same_bits(stopping, back)) << "reversed once is another motion";
      reverse(back);
      ASSERT_TRUE(same_bits(stopping, back)) << "state " << i << ", choice " << choice;
    }
  }
  EXPECT_GT(accepted, scaled(12) * 100);
  for (const int count : of_kind) EXPECT_GT(count, 0);
}

TEST(Stopping, JerkIsContinuedAndLimited) {
  Random random(62);
  int stopped = 0;
  const int cases = scaled(60);
  for (int i = 0; i < cases; ++i) {
    Limits limits{{3, 3, 2}, {4, 4, 3}};
    const double j = random.real(2.0, 20.0);
    limits.j_max = {j, j, j};
    State state{{0, 0, 0},
                random_within(random, {-2, -2, -1}, {2, 2, 1}, 0.0),
                random_within(random, {-1, -1, -1}, {1, 1, 1}, 0.0),
                random_within(random, -0.8 * limits.j_max, 0.8 * limits.j_max, 0.0)};
    int accepted = 0;
    for (int choice = 0; choice < kStoppingManoeuvres; ++choice) {
      Stopping stopping;
      if (!make_stopping(state, limits, choice, stopping)) continue;
      ++accepted;
      ASSERT_NO_FATAL_FAILURE(expect_stops(state, limits, stopping)) << "state " << i << ", choice " << choice;
    }
    stopped += accepted > 0 ? 1 : 0;
  }
  EXPECT_GE(stopped, cases * 9 / 10);
}

TEST(Stopping, RefusesWhatBreaksTheLimits) {
  const Limits limits{{2, 2, 2}, {2, 2, 2}};
  Stopping stopping;
  for (int choice = 0; choice < kStoppingChoices; ++choice) {
    EXPECT_FALSE(make_stopping({{0, 0, 0}, {2.1, 0, 0}, {0, 0, 0}}, limits, choice, stopping)) << choice;
  }
}

/// The straight choices that are accepted.
int straight_choices(const State& state, const Limits& limits, bool* levelled) {
  int count = 0;
  for (int choice = 0; choice < kBrakeShapes; ++choice) {
    Stopping stopping;
    if (!make_stopping(state, limits, choice, stopping)) continue;
    ++count;
    *levelled = *levelled || stopping.count == kBrakeSegments + 1;
    expect_stops(state, limits, stopping);
    // Straight ahead: nothing to the sides.
    for (int i = 0; i < stopping.count; ++i) EXPECT_EQ(at(stopping.segments[i], 0.0).velocity.z, 0.0);
  }
  return count;
}

TEST(Stopping, LevelsOffAtTheSpeedLimit) {
  const Limits limits{{2, 2, 2}, {2, 2, 2}};
  // What rounding leaves of an acceleration at a plan's peak speed: levelled off before it counts.
  bool levelled = false;
  EXPECT_GT(straight_choices({{0, 0, 0}, {2.0, 0, 0}, {1e-3, 0, 0}}, limits, &levelled), 0);
  // 20 um/s below the limit, speeding up at half the limit: only 40 us are left for levelling off.
  EXPECT_GT(straight_choices({{0, 0, 0}, {2.0 - 2e-5, 0, 0}, {1.0, 0, 0}}, limits, &levelled), 0);
  EXPECT_TRUE(levelled);
  levelled = false;
  EXPECT_GT(straight_choices({{0, 0, 0}, {0, -(2.0 - 2e-5), 0}, {0, -1.0, 0}}, limits, &levelled), 0);
  EXPECT_TRUE(levelled);
}

}  // namespace
