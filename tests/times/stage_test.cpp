// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "times/times_stage.hpp"

namespace tern_test {
namespace {

using tern::Chain;
using tern::Corridor;
using tern::Limits;
using tern::State;
using tern::Status;
using tern::Vec3;
using tern::Work;

constexpr Limits kTwo{{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
constexpr double kSlack = 1.5;  // docs/times.md

class Times : public testing::Test {
 protected:
  Times() : corridor_(new Corridor{}), chain_(new Chain) {}
  void leg(const Vec3& from, const Vec3& to) {
    corridor_->polyhedra[corridor_->count].from = from;
    corridor_->polyhedra[corridor_->count].to = to;
    ++corridor_->count;
  }
  State first() const { return {corridor_->polyhedra[0].from, {}, {}}; }
  State last() const { return {corridor_->polyhedra[corridor_->count - 1].to, {}, {}}; }
  void begin(const State& start, const State& goal, const Limits& limits = kTwo) {
    tern::times_begin(stage_, *corridor_, {start, goal, limits}, *chain_);
  }
  tern::Progress advance(std::uint32_t units) {
    Work work{units};
    return tern::times_advance(stage_, *corridor_, work, *chain_);
  }

  std::unique_ptr<Corridor> corridor_;
  std::unique_ptr<Chain> chain_;
  tern::TimesStage stage_;
};

TEST_F(Times, RampsAtBothEndsAndCruisingBetween) {
  // 30 m in three legs of 10 m. One needs 2 m to reach 2 m/s and stop again: its pieces are 2.5 times that at most.
  for (int i = 0; i < 3; ++i) leg({10.0 * i, 0.0, 0.0}, {10.0 * (i + 1), 0.0, 0.0});
  begin(first(), last());
  ASSERT_EQ(advance(100), tern::Progress::kDone);
  ASSERT_EQ(chain_->count, 6);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(chain_->polyhedron[i], i / 2);
    EXPECT_NEAR(chain_->length[i], 5.0, 1e-12);
    // 5 m at 2 m/s; an end from rest takes v / 2a = 0.5 s more.
    EXPECT_NEAR(chain_->duration[i], kSlack * (i == 0 || i == 5 ? 3.0 : 2.5), 1e-12) << i;
  }
}

TEST_F(Times, AShortLegTakesItsTriangleAtMost) {
  leg({0.0, 0.0, 0.0}, {0.02, 0.0, 0.0});
  leg({0.02, 0.0, 0.0}, {4.0, 0.0, 0.0});
  begin(first(), last());
  ASSERT_EQ(advance(100), tern::Progress::kDone);
  // The ramp to 1.4 m/s alone would take 0.35 s, more than 2 sqrt(x / a).
  EXPECT_EQ(chain_->polyhedron[1], 1);
  EXPECT_NEAR(chain_->duration[0], kSlack * 2.0 * std::sqrt(0.02 / 2.0), 1e-12);
}

TEST_F(Times, ALimitBeyondReachIsNoneAtAll) {
  leg({0.0, 0.0, 0.0}, {10.0, 0.0, 0.0});
  for (const double v : {2.5, 5.0, 20.0, 1000.0}) {
    begin(first(), last(), {{v, v, v}, {2.0, 2.0, 2.0}});
    ASSERT_EQ(advance(100), tern::Progress::kDone);
    // A lone leg is five pieces. There is room for half of sqrt(2 m/s^2 * 10 m).
    ASSERT_EQ(chain_->count, 5);
    const double speed = 0.5 * std::sqrt(20.0);
    const double cruise = 2.0 / speed;
    EXPECT_NEAR(chain_->duration[0], kSlack * (cruise + speed / 4.0), 1e-12);
    for (int i = 1; i < 4; ++i) EXPECT_NEAR(chain_->duration[i], kSlack * cruise, 1e-12);
    EXPECT_NEAR(chain_->duration[4], kSlack * (cruise + speed / 4.0), 1e-12);
  }
}

TEST_F(Times, EachPolyhedronGetsItsPartOfFiveSegments) {
  const double fast = 100.0;  // no leg is long for these limits
  const Limits limits{{fast, fast, fast}, {2.0, 2.0, 2.0}};
  leg({0.0, 0.0, 0.0}, {5.0, 0.0, 0.0});
  leg({5.0, 0.0, 0.0}, {10.0, 0.0, 0.0});
  begin(first(), last(), limits);
  EXPECT_EQ(chain_->count, 6);  // 2.5 each, rounded
  leg({10.0, 0.0, 0.0}, {10.0, 1.5, 0.0});
  begin(first(), last(), limits);
  // 2.17, 2.17 and 0.65 of five.
  const int expected[] = {0, 0, 1, 1, 2};
  ASSERT_EQ(chain_->count, 5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(chain_->polyhedron[i], expected[i]) << i;
}

TEST_F(Times, NoLengthTakesTheLeastDuration) {
  leg({0.0, 0.0, 0.0}, {4.0, 0.0, 0.0});
  leg({4.0, 0.0, 0.0}, {4.0, 0.0, 0.0});
  leg({4.0, 0.0, 0.0}, {4.0, 4.0, 0.0});
  begin(first(), last());
  ASSERT_EQ(advance(100), tern::Progress::kDone);
  bool found = false;
  for (int i = 0; i < chain_->count; ++i) {
    if (chain_->polyhedron[i] != 1) continue;
    found = true;
    EXPECT_EQ(chain_->duration[i], tern::kMinDuration);
  }
  EXPECT_TRUE(found);
}

TEST_F(Times, ALongLegIsSplitWhereItTurns) {
  // Pieces are 2.5 m at most: 8 m are three of them. The straight polyhedra between are for cruising.
  const Limits one{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}};
  for (int i = 0; i < 6; ++i) leg({8.0 * i, 0.0, 0.0}, {8.0 * (i + 1), 0.0, 0.0});
  leg({48.0, 0.0, 0.0}, {48.0, 8.0, 0.0});
  begin(first(), last(), one);
  const int pieces[] = {3, 1, 1, 1, 1, 3, 3};
  int k = 0;
  for (int i = 0; i < 7; ++i) {
    for (int n = 0; n < pieces[i]; ++n, ++k) EXPECT_EQ(chain_->polyhedron[k], i) << k;
  }
  EXPECT_EQ(chain_->count, k);
}

TEST_F(Times, AMovingEndNeedNotBrake) {
  leg({0.0, 0.0, 0.0}, {0.9, 0.0, 0.0});
  leg({0.9, 0.0, 0.0}, {9.0, 0.0, 0.0});
  State start = first();
  start.velocity = {2.0, 0.0, 0.0};
  begin(start, last());
  ASSERT_EQ(advance(100), tern::Progress::kDone);
  // Three pieces at the full speed, which is the start's: no time to brake in 0.9 m, which takes 1 s and 1 m.
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(chain_->polyhedron[i], 0);
    EXPECT_NEAR(chain_->duration[i], kSlack * (0.9 / 3.0) / 2.0, 1e-12);
  }
  EXPECT_EQ(chain_->polyhedron[3], 1);
}

TEST_F(Times, AShortWayAtAMovingEndHasFewerPieces) {
  const State moving{{}, {2.0, 0.0, 0.0}, {}};
  // At 2 m/s a piece needs 0.3 m.
  const double ways[] = {0.89, 0.61, 0.59, 0.0};
  const int pieces[] = {2, 2, 1, 1};
  for (int i = 0; i < 4; ++i) {
    corridor_->count = 0;
    leg({0.0, 0.0, 0.0}, {ways[i], 0.0, 0.0});
    leg({ways[i], 0.0, 0.0}, {9.0, 0.0, 0.0});
    begin(moving, last());
    EXPECT_EQ(chain_->polyhedron[pieces[i] - 1], 0) << i;
    EXPECT_EQ(chain_->polyhedron[pieces[i]], 1) << i;
  }
}

TEST_F(Times, AJerkLimitMakesRampsLonger) {
  for (int i = 0; i < 3; ++i) leg({10.0 * i, 0.0, 0.0}, {10.0 * (i + 1), 0.0, 0.0});
  Limits limits = kTwo;
  limits.j_max = {4.0, 4.0, 4.0};
  begin(first(), last(), limits);
  ASSERT_EQ(advance(100), tern::Progress::kDone);
  // From rest to 2 m/s takes 1 s and half a second to full acceleration: half of it more than cruising.
  EXPECT_NEAR(chain_->duration[0], kSlack * (2.5 + 0.75), 1e-12);
  EXPECT_NEAR(chain_->duration[1], kSlack * 2.5, 1e-12);
}

TEST_F(Times, SlicesEndWhereAWholeRunDoes) {
  for (int i = 0; i < 5; ++i) leg({3.0 * i, 0.1 * i * i, 0.0}, {3.0 * (i + 1), 0.1 * (i + 1) * (i + 1), 0.0});
  begin(first(), last());
  ASSERT_EQ(advance(100), tern::Progress::kDone);
  const Chain whole = *chain_;
  begin(first(), last());
  int slices = 1;
  while (advance(1) == tern::Progress::kMore) ++slices;
  EXPECT_GT(slices, 1);
  EXPECT_LE(slices, whole.count);
  EXPECT_LE(static_cast<std::uint32_t>(stage_.timed), tern::kTimesBound);
  for (int i = 0; i < whole.count; ++i) EXPECT_EQ(chain_->duration[i], whole.duration[i]);
}

TEST_F(Times, MorePiecesThanFitBecomeFewer) {
  for (int i = 0; i < tern::kMaxSegments; ++i) leg({40.0 * i, 0.0, 0.0}, {40.0 * (i + 1), 0.0, 0.0});
  begin(first(), last());
  ASSERT_EQ(advance(0xFFFFFFFFu), tern::Progress::kDone);
  EXPECT_EQ(chain_->count, tern::kMaxSegments);
}

/// 30 m in three legs of 10 m, each of two segments, and an earlier plan that flies along them at constant speed.
class TimesWithPace : public Times {
 protected:
  TimesWithPace() {
    for (int i = 0; i < 3; ++i) leg({10.0 * i, 0.0, 0.0}, {10.0 * (i + 1), 0.0, 0.0});
  }
  /// The durations, after an earlier plan along `length` metres of the way, `aside` metres beside it.
  void begin_after(double length, double speed, double aside, double from = 0.0) {
    earlier_ = std::make_unique<tern::Trajectory>();
    earlier_->count = 1;
    earlier_->segments[0].duration = length / speed;
    for (int k = 0; k < tern::kControlPoints; ++k) {
      earlier_->segments[0].points[k] = {length * k / tern::kDegree - speed * from, 0.0, 0.0};
    }
    tern::TimesQuery query{first(), last(), kTwo};
    query.pace = {earlier_.get(), from, {0.0, aside, 0.0}, is_rival_};
    tern::times_begin(stage_, *corridor_, query, *chain_);
    ASSERT_EQ(advance(100), tern::Progress::kDone);
    ASSERT_EQ(chain_->count, 6);
  }

  std::unique_ptr<tern::Trajectory> earlier_;
  bool is_rival_ = false;
};

TEST_F(TimesWithPace, SegmentsTakeTheTimeOfTheEarlierPlan) {
  for (const double from : {0.0, 0.7}) {
    begin_after(30.0 + 1.6 * from, 1.6, 1.4, from);
    EXPECT_TRUE(stage_.paced);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(chain_->duration[i], 1.05 * 5.0 / 1.6, 1e-12) << i;
  }
}

TEST_F(TimesWithPace, APlanThatHasToBeatTheEarlierOneBeginsAPercentFaster) {
  is_rival_ = true;
  begin_after(30.0, 1.6, 1.4);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(chain_->duration[i], 0.99 * 5.0 / 1.6, 1e-12) << i;
}

TEST_F(TimesWithPace, AnEarlierPlanElsewhereDoesNotCount) {
  begin_after(30.0, 1.6, 1.6);
  EXPECT_FALSE(stage_.paced);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(chain_->duration[i], kSlack * (i == 0 || i == 5 ? 3.0 : 2.5), 1e-12) << i;
}

TEST_F(TimesWithPace, BeyondTheEarlierPlanSegmentsTakeTheirOwnTime) {
  begin_after(16.0, 1.6, 0.0);  // ends 1 m beyond the third joint
  EXPECT_TRUE(stage_.paced);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(chain_->duration[i], 1.05 * 5.0 / 1.6, 1e-12) << i;
  EXPECT_NEAR(chain_->duration[3], kSlack * 2.5, 1e-12);
  EXPECT_NEAR(chain_->duration[5], kSlack * 3.0, 1e-12);
}

TEST_F(TimesWithPace, BoundsHoldWhateverTheEarlierPlanTook) {
  begin_after(30.0, 0.1, 0.0);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(chain_->duration[i], kSlack * (i == 0 || i == 5 ? 3.0 : 2.5), 1e-12) << i;
  for (const double speed : {50.0, 1e300}) {
    begin_after(30.0, speed, 0.0);
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(chain_->duration[i], 0.4 * kSlack * (i == 0 || i == 5 ? 3.0 : 2.5), 1e-12) << i;
    }
  }
}

TEST_F(TimesWithPace, SlicesChangeNoBit) {
  begin_after(30.0, 1.6, 1.0);
  const Chain whole = *chain_;
  tern::TimesQuery query{first(), last(), kTwo};
  query.pace = {earlier_.get(), 0.0, {0.0, 1.0, 0.0}};
  tern::times_begin(stage_, *corridor_, query, *chain_);
  for (int i = 0; i < 5; ++i) ASSERT_EQ(advance(1), tern::Progress::kMore);
  ASSERT_EQ(advance(1), tern::Progress::kDone);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(chain_->duration[i], whole.duration[i]) << i;
}

}  // namespace
}  // namespace tern_test
