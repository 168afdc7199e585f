// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proofs by range in slices: a tick takes no more than its units and one piece, and slices of any size find the same.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "fleet/fleet_access.hpp"
#include "fleet/range_pair.hpp"

namespace {

using namespace tern_test;
using tern::Announcement;
using tern::FleetBlock;
using tern::Vec3;

/// The longest piece: a proof against a plan of as many segments as there may be begins.
constexpr std::int64_t kLongestPiece =
    tern::plan_work(tern::kMaxSegments + 1) + tern::ops::kCurve * tern::kMaxSegments + 2 * tern::ops::kPiece;

/// A way to a place in so many segments, each of which takes `seconds`.
tern::Trajectory in_steps(const Vec3& from, const Vec3& to, std::int64_t begin, int count, double seconds) {
  tern::Trajectory plan = resting(from, begin);
  plan.count = count;
  for (int s = 0; s < count; ++s) {
    plan.segments[s].duration = seconds;
    for (int k = 0; k < tern::kControlPoints; ++k) {
      const double part = static_cast<double>(k < 4 ? s : s + 1) / count;
      plan.segments[s].points[k] = {part * (to.x - from.x), part * (to.y - from.y), part * (to.z - from.z)};
    }
  }
  return plan;
}

class FleetSlices : public FleetRangePair {
 protected:
  bool is_proving(const tern::Fleet& fleet) const { return fleet.report().announcement == Announcement::kProving; }

  /// Goes on with proofs in ticks of so many units, without time passing. How many ticks.
  int prove(tern::Fleet& fleet, std::uint32_t units) {
    int ticks = 0;
    for (; is_proving(fleet) && ticks < 100000; ++ticks) {
      tern::Work work(units);
      fleet.advance(now_, work);
      const std::int64_t most = std::max(tern::kUnit * units, always_);
      EXPECT_LE(tern::kUnit * units - work.operations(), most + kLongestPiece) << units;
    }
    return ticks;
  }
  /// Vehicle 1 hears strangers anywhere around, most of them out of its way.
  void hear_strangers(Random& random, int count) {
    for (int k = 0; k < count; ++k) {
      const double far = random.chance(0.9) ? 45.0 : 25.0;
      const Vec3 place{random.real(-150.0, 150.0), random.chance(0.5) ? far : -far, 1.0};
      hear(0, {beacon_of(static_cast<std::uint16_t>(3 + k), place, now_)});
    }
  }
  /// Both by list: 1 has these members, and 2 has 1.
  void begin_by_list(const std::vector<std::uint16_t>& members) {
    for (const int v : {0, 1}) {
      tern::FleetSpec by_list = spec(v);
      by_list.range = tern::FleetRange{};
      ASSERT_EQ(fleet(v).begin(by_list, resting(place(v, 10.0), 0), now_), tern::Status::kOk);
    }
    for (const std::uint16_t member : members) fleet(0).add(member, now_);
    fleet(1).add(1, now_);
    for (const int v : {0, 1, 0, 1}) say(v);
  }
  void expect_same(tern::Fleet& a, tern::Fleet& b) {
    EXPECT_EQ(a.report().announcement, b.report().announcement);
    EXPECT_EQ(a.report().blocked, b.report().blocked);
    EXPECT_EQ(a.report().blocked_by, b.report().blocked_by);
    std::uint8_t of_a[1400];
    std::uint8_t of_b[1400];
    while (const std::int32_t size = a.write(of_a, sizeof of_a)) {
      ASSERT_EQ(b.write(of_b, sizeof of_b), size);
      ASSERT_EQ(std::memcmp(of_a, of_b, static_cast<std::size_t>(size)), 0);
    }
    EXPECT_EQ(b.write(of_b, sizeof of_b), 0);
  }

  std::int64_t always_ = 0;  ///< what every tick of the fleet under test takes
};

TEST_F(FleetSlices, SlicesOfAnySizeFindTheSame) {
  Random random(1);
  int found[16] = {};
  int ticks = 0;
  for (int turn = 0; turn < scaled(200); ++turn) {
    now_ = kSecond;
    lease_ = 30 * kSecond;
    begin(random.chance(0.7) ? 15.0 : 200.0);
    go_on(2.0);
    hear_strangers(random, random.integer(0, 60));
    always_ = advance_without_proofs(fleet(0), now_);
    const Vec3 to{random.chance(0.2) ? 14.5 : random.real(-12.0, 12.0), random.real(-4.0, 4.0), 1.0};
    const std::int64_t takeover = now_ + kSecond;
    const tern::Trajectory plan = in_steps({0, 0, 1}, to, takeover, random.integer(1, 10), random.real(0.3, 0.7));
    ASSERT_EQ(fleet(0).announce(plan, takeover, now_), tern::Status::kOk);
    const auto whole = std::make_unique<tern::Fleet>(fleet(0));
    prove(*whole, 100000);
    for (const std::uint32_t units : {20u, 50u}) {
      const auto sliced = std::make_unique<tern::Fleet>(fleet(0));
      ticks = std::max(ticks, prove(*sliced, units));
      const auto copy = std::make_unique<tern::Fleet>(*whole);
      expect_same(*sliced, *copy);
    }
    for (int k = 0; k < 100000 && is_proving(fleet(0)); ++k) advance_a_piece(fleet(0), now_);
    ++found[static_cast<int>(whole->report().blocked)];
    expect_same(fleet(0), *whole);
  }
  EXPECT_GT(ticks, 2);
  for (const FleetBlock why : {FleetBlock::kNone, FleetBlock::kConflict, FleetBlock::kStranger})
    EXPECT_GE(found[static_cast<int>(why)], scaled(200) / 50) << static_cast<int>(why);
}

TEST_F(FleetSlices, AMostCrowdedSkyIsDoneInManyTicks) {
  begin(1000.0);
  go_on(2.0);
  now_ += kSecond / 10;
  for (int k = 0; k < tern::kMaxBeacons; ++k) {
    hear(0, {beacon_of(static_cast<std::uint16_t>(10 + k), {0.1 * k, 90.0, 1.0}, now_)});
  }
  always_ = advance_without_proofs(fleet(0), now_);
  EXPECT_LT(always_, 15 * tern::kUnit);
  const std::int64_t takeover = now_ + kSecond;
  const tern::Trajectory plan = in_steps({0, 0, 1}, {0, 4, 1}, takeover, tern::kMaxSegments, 0.1);
  for (const std::uint32_t units : {20u, 60u}) {
    ASSERT_EQ(fleet(0).announce(plan, takeover, now_), tern::Status::kOk);
    EXPECT_GT(prove(fleet(0), units), units < 50 ? 10 : 2) << units;
    EXPECT_EQ(fleet(0).report().announcement, Announcement::kOpen);
  }
}

/// Else nobody among many members would ever get through: in every tick, one of them flies something else.
TEST_F(FleetSlices, WhoFliesSomethingElseIsProvenAgainAndNobodyElseIs) {
  begin(15.0);
  go_on(2.0);
  announce(1);
  go_on(0.8);
  ASSERT_TRUE(fleet(1).report().cleared);
  hear(0, {beacon_of(7, {0, 90, 1}, now_), beacon_of(9, {0, 90, 1}, now_)});
  const std::int64_t takeover = now_ + kSecond;
  ASSERT_EQ(fleet(0).announce(straight({0, 0, 1}, {0, -2, 1}, takeover, 4.0), takeover, now_), tern::Status::kOk);
  const tern::ProofJob& job = tern::memory_of(fleet(0))->job;
  for (int k = 0; k < 1000 && job.heard <= 7; ++k) advance_a_piece(fleet(0), now_);
  ASSERT_EQ(job.heard, 8);
  ASSERT_EQ(job.peer, 1) << "the member is done";
  now_ += kSecond / 4;
  advance(1);
  ASSERT_EQ(fleet(1).report().announcement, Announcement::kTaken);
  say(1);
  EXPECT_EQ(job.peer, 0);
  EXPECT_EQ(job.heard, 8);
  advance(0);
  EXPECT_EQ(fleet(0).report().announcement, Announcement::kOpen);
}

/// Else nobody among many members would ever get through: in every tick, one of them parts.
TEST_F(FleetSlices, WhoPartsLeavesProofsAboutOthersAsTheyAre) {
  begin(15.0);
  go_on(2.0);
  hear(0, {beacon_of(7, {0, 90, 1}, now_), beacon_of(9, {0, 90, 1}, now_)});
  for (const std::uint16_t id : {11, 12, 13}) {
    hear(0, {beacon_of(id, {0, 15, 1}, now_)});
    advance(0);
  }
  ASSERT_EQ(fleet(0).neighbours(), 4);
  const std::int64_t takeover = now_ + kSecond;
  ASSERT_EQ(fleet(0).announce(straight({0, 0, 1}, {0, -2, 1}, takeover, 4.0), takeover, now_), tern::Status::kOk);
  const tern::ProofJob& job = tern::memory_of(fleet(0))->job;
  const auto part = [&](std::uint16_t id) {
    now_ += kSecond / 50;
    hear(0, {beacon_of(id, {0, 90, 1}, now_)});
    advance_without_proofs(fleet(0), now_);
  };
  for (int k = 0; k < 1000 && !job.runs; ++k) advance_a_piece(fleet(0), now_);
  part(11);
  EXPECT_TRUE(job.runs) << "the proof about 2 goes on";
  EXPECT_EQ(job.peer, 0);
  for (int k = 0; k < 1000 && job.peer < 1; ++k) advance_a_piece(fleet(0), now_);
  part(13);
  ASSERT_EQ(fleet(0).neighbours(), 2);
  ASSERT_EQ(job.peer, 1);
  EXPECT_EQ(tern::memory_of(fleet(0))->peers[1].id, 12) << "2 is done, and 12 is not";
  for (int k = 0; k < 1000 && job.heard <= 7; ++k) advance_a_piece(fleet(0), now_);
  part(12);
  EXPECT_EQ(job.heard, 8) << "2 and 7 are done";
  EXPECT_EQ(job.peer, 1);
  advance(0);
  EXPECT_EQ(fleet(0).report().announcement, Announcement::kOpen);
}

/// By list.
TEST_F(FleetSlices, AnAnswerIsWorkedOutWhileAnotherMemberIsRemoved) {
  begin_by_list({3, 2});
  fly(1, {10, 0, 1}, {10, 5, 1}, 4.0);
  say(1);
  const tern::ProofJob& job = tern::memory_of(fleet(0))->job;
  for (int k = 0; k < 1000 && !job.runs; ++k) advance_a_piece(fleet(0), now_);
  ASSERT_EQ(job.peer, 1);
  fleet(0).remove(3, now_);
  EXPECT_TRUE(job.runs);
  advance(0);
  say(0);
  EXPECT_TRUE(fleet(1).report().cleared);
}

/// By list. 2 asks for the place to which a plan leads that is clear of 2 and not yet of 3; then 3 is removed.
TEST_F(FleetSlices, WhoAsksBetweenProofsIsAnsweredAfterThem) {
  begin_by_list({2, 3});
  const std::int64_t takeover = now_ + kSecond;
  ASSERT_EQ(fleet(0).announce(straight({0, 0, 1}, {10, 5, 1}, takeover, 4.0), takeover, now_), tern::Status::kOk);
  for (int k = 0; k < 1000 && tern::memory_of(fleet(0))->job.peer == 0; ++k) advance_a_piece(fleet(0), now_);
  ASSERT_TRUE(is_proving(fleet(0))) << "clear of 2, and not yet of 3";
  fly(1, {10, 0, 1}, {10, 5, 1}, 4.0);
  say(1);
  fleet(0).remove(3, now_);
  advance(0);
  EXPECT_EQ(fleet(0).report().announcement, Announcement::kOpen);
  say(0);
  advance(1);
  expect_dropped(1, FleetBlock::kRefused, 1);
}

/// Who comes while others are being proven clear of is proven clear of, too: at its first beacon, and where beacons of
/// it come again.
TEST_F(FleetSlices, WhoComesMeanwhileIsNotForgotten) {
  for (const bool is_new : {true, false}) {
    now_ = kSecond;
    begin(1000.0);
    if (!is_new) hear(0, {beacon_of(5, {0, 25, 1}, now_)});
    go_on(2.0);  // after which what was heard of 5 is stale
    hear(0, {beacon_of(7, {0, 90, 1}, now_), beacon_of(9, {0, 90, 1}, now_)});
    const std::int64_t takeover = now_ + kSecond;
    ASSERT_EQ(fleet(0).announce(straight({0, 0, 1}, {0, 2, 1}, takeover, 4.0), takeover, now_), tern::Status::kOk);
    for (int k = 0; k < 100 && tern::memory_of(fleet(0))->job.heard <= 7; ++k) advance_a_piece(fleet(0), now_);
    ASSERT_TRUE(is_proving(fleet(0)));
    ASSERT_EQ(tern::memory_of(fleet(0))->job.heard, 8) << "7 is done, and 9 is not";
    hear(0, {beacon_of(5, {0, 25, 1}, now_)});
    advance(0);
    expect_dropped(0, FleetBlock::kStranger, 5);
  }
}

}  // namespace
