// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Members by range: who becomes one and who is none any more, and which plans need nobody's agreement.
#include <gtest/gtest.h>

#include <vector>

#include "fleet/fleet_access.hpp"
#include "fleet/plans.hpp"
#include "fleet/range_pair.hpp"
#include "tern/fleet.hpp"

namespace {

using namespace tern_test;
using tern::Announcement;
using tern::FleetBlock;
using tern::Heard;
using tern::Status;

/// Changes until when a state promises something, which must be all in one packet.
void forge_until(std::vector<std::uint8_t>& packet, std::int64_t until) {
  constexpr int kUntil = tern::kPacketHeadBytes + 31;
  for (int k = 0; k < 8; ++k) packet[kUntil + k] = static_cast<std::uint8_t>(until >> (8 * k));
  sign(packet);
}

TEST_F(FleetRangePair, NobodyAsksWhoIsFarAway) {
  begin(100.0);
  go_on(2.0);
  EXPECT_EQ(fleet(0).neighbours(), 0);
  announce(1);  // the other one would have the right of way
  EXPECT_TRUE(fleet(1).report().cleared);
  now_ += kSecond;
  advance(1);
  EXPECT_EQ(fleet(1).report().announcement, Announcement::kTaken);
}

TEST_F(FleetRangePair, NobodyFliesBeforeItListened) {
  begin(100.0);
  announce(0);
  expect_dropped(0, FleetBlock::kUnheard, 0);
}

TEST_F(FleetRangePair, APlanThatLeadsTooFarIsDropped) {
  begin(100.0);
  go_on(2.0);
  const std::int64_t takeover = now_ + kSecond;
  ASSERT_EQ(fleet(0).announce(straight({0, 0, 1}, {0, 300, 1}, takeover, 4.0), takeover, now_), Status::kOk);
  advance(0);
  expect_dropped(0, FleetBlock::kUnheard, 0);
}

TEST_F(FleetRangePair, WhoMayComeTooNearIsInTheWay) {
  begin(25.0);  // 5 s of 5 m/s reach that far
  go_on(2.0);
  EXPECT_EQ(fleet(0).neighbours(), 0);
  announce(0);
  expect_dropped(0, FleetBlock::kStranger, 2);
}

TEST_F(FleetRangePair, WhoIsNearBecomesAMemberAndIsAsked) {
  begin(15.0);
  go_on(2.0);
  ASSERT_EQ(fleet(1).neighbours(), 1);
  EXPECT_TRUE(fleet(1).neighbour(0).ready);
  EXPECT_TRUE(fleet(1).neighbour(0).has_right_of_way);
  announce(1);
  EXPECT_EQ(fleet(1).report().announcement, Announcement::kOpen);
  EXPECT_FALSE(fleet(1).report().cleared);
  go_on(0.5);
  EXPECT_TRUE(fleet(1).report().cleared);
}

TEST_F(FleetRangePair, PlansLongerThanThePromiseAreInTheWay) {
  begin(15.0);
  go_on(2.0);
  const std::int64_t takeover = now_ + kSecond;
  ASSERT_EQ(fleet(0).announce(straight({0, 0, 1}, {0, 2, 1}, takeover, 8.0), takeover, now_), Status::kOk);
  advance(0);
  expect_dropped(0, FleetBlock::kStranger, 2);
}

// 1 has the right of way and is bound to 2, which is not yet bound to 1 and takes a plan over unasked while 1 is
// between its proof about 2 and the announcement. Then 2 promises to be bound until 1's plan rests.
TEST_F(FleetRangePair, WhatAMemberTookOverUnaskedIsProvenBeforeItsPromiseCounts) {
  lease_ = 30 * kSecond;
  begin(18.0);
  now_ += 11 * kSecond / 10;
  for (int k = 0; k < 2; ++k) {  // both hear where the other one is, then what it says of itself
    now_ += kSecond / 10;
    for (const int v : {0, 1}) advance(v);
    for (const int v : {0, 1}) say(v);
  }
  now_ += kSecond / 10;
  for (const int v : {0, 1}) advance(v);
  const auto late = round(0);
  const std::int64_t unasked = now_ + kSecond / 5;
  ASSERT_EQ(fleet(1).announce(straight({18, 0, 1}, {16.2, 0, 1}, unasked, 1.0), unasked, now_), Status::kOk);
  advance(1);
  ASSERT_TRUE(fleet(1).report().cleared) << "nobody binds it";
  // Clear of where 2 is, and not of where it goes.
  const std::int64_t takeover = now_ + kSecond;
  ASSERT_EQ(fleet(0).announce(straight({0, 0, 1}, {16.9, 0, 1}, takeover, 8.0), takeover, now_), Status::kOk);
  for (int k = 0; k < 1000 && tern::memory_of(fleet(0))->job.peer == 0; ++k) {
    advance_a_piece(fleet(0), now_);
  }
  ASSERT_EQ(fleet(0).report().announcement, Announcement::kProving);
  ASSERT_EQ(tern::memory_of(fleet(0))->job.peer, 1) << "the proof about 2 is over";
  hear(1, late);
  now_ = unasked;
  advance(1);
  ASSERT_EQ(fleet(1).report().announcement, Announcement::kTaken);
  say(1);
  advance(0);
  expect_dropped(0, FleetBlock::kConflict, 2);
}

TEST_F(FleetRangePair, AVehicleWhoseClockIsBehindIsInTheWayAsLong) {
  clock_error_ = kSecond / 2;
  begin(25.0);
  now_ += 2 * kSecond;
  advance(1);
  const auto beacon = round(1);
  now_ += kSecond / 2;  // by which the other one's clock is behind
  hear(0, beacon);
  now_ += 9 * kSecond / 10;  // it is 0.9 s old
  advance(0);
  announce(0);
  expect_dropped(0, FleetBlock::kStranger, 2);
}

TEST_F(FleetRangePair, ALateTakeoverIsAllowedFor) {
  begin(26.5);  // 5 s of 5 m/s and both bodies do not reach that far; 0.2 s more do
  go_on(2.0);
  announce(0);
  expect_dropped(0, FleetBlock::kStranger, 2);
}

TEST_F(FleetRangePair, WhoLeftIsInTheWayAsLongAsItsBeaconsCome) {
  begin(15.0);
  go_on(2.0);
  fleet(1).leave(now_);
  go_on(20.0);  // longer than what was promised before
  const std::int64_t takeover = now_ + kSecond;
  ASSERT_EQ(fleet(0).announce(straight({0, 0, 1}, {14.5, 0, 1}, takeover, 4.0), takeover, now_), Status::kOk);
  advance(0);
  expect_dropped(0, FleetBlock::kConflict, 2);
}

TEST_F(FleetRangePair, NobodyPromisesForLongerThanItsLease) {
  begin(15.0);
  go_on(2.0);
  const std::int64_t trusted = tern::memory_of(fleet(0))->peers[0].link.trusted;
  ASSERT_GT(trusted, now_);
  for (const std::int64_t until : {INT64_MIN, INT64_MAX, now_ + lease_ + 1}) {
    ASSERT_EQ(fleet(1).announce(resting(place(1, 15.0), now_), now_ + kSecond, now_), Status::kOk);
    advance(1);  // has something new to say
    for (std::vector<std::uint8_t> packet : round(1)) {
      if (packet[0] == tern::form_of(tern::MessageKind::kRangeState)) forge_until(packet, until);
      hear(0, {packet});
    }
    EXPECT_EQ(tern::memory_of(fleet(0))->peers[0].link.trusted, trusted) << until;
  }
}

TEST_F(FleetRangePair, PromisesEndAndOutliveABeginning) {
  begin(15.0);
  go_on(2.0);
  ++incarnation_;
  const tern::Trajectory flown = resting(place(1, 15.0), 0);
  ASSERT_EQ(fleet(1).begin(spec(1), flown, now_), Status::kOk);
  ASSERT_EQ(fleet(1).neighbours(), 1) << "it was promised that it is asked";
  for (int k = 0; k < 85; ++k) {  // nobody hears anything
    now_ += kSecond / 10;
    advance(0);
    advance(1);
    const bool is_bound = fleet(1).neighbours() == 1;
    EXPECT_TRUE(is_bound || k >= 68) << k;
  }
  EXPECT_EQ(fleet(0).neighbours(), 0);
  EXPECT_EQ(fleet(1).neighbours(), 0);
}

// 2, which has the right of way, did not hear 1 for so long that it has no members any more. For 1, it still is in
// range.
TEST_F(FleetRangePair, WhoHasNoMembersAnyMoreSaysSo) {
  priorities_[1] = 1;
  begin(19.0);
  go_on(2.0);
  fly(0, {0, 0, 1}, {-3, 0, 1}, 4.0);
  go_on(6.0);
  for (int k = 0; k < 100; ++k) {
    now_ += kSecond / 10;
    for (const int v : {0, 1}) advance(v);
    say(1);
  }
  go_on(10.0);
  ASSERT_EQ(fleet(1).neighbours(), 0);
  ASSERT_EQ(fleet(0).neighbours(), 1);
  fly(0, {-3, 0, 1}, {-4, 0, 1}, 1.0);
  go_on(1.5);
  EXPECT_EQ(fleet(0).report().announcement, Announcement::kTaken);
}

TEST_F(FleetRangePair, ListsAndRangesDoNotMix) {
  begin(15.0);
  EXPECT_EQ(fleet(0).add(2, now_), Status::kInvalidArgument);
  EXPECT_EQ(fleet(0).remove(2, now_), Status::kInvalidArgument);
  tern::FleetSpec by_list = spec(1);
  by_list.range = tern::FleetRange{};
  ASSERT_EQ(fleet(1).begin(by_list, resting(place(1, 15.0), 0), now_), Status::kOk);
  ASSERT_EQ(fleet(1).add(1, now_), Status::kOk);
  go_on(2.0);
  EXPECT_EQ(fleet(0).neighbours(), 0);
  EXPECT_FALSE(fleet(1).neighbour(0).ready);
}

TEST_F(FleetRangePair, AMemberOfAListIsNotPromisedAnythingByRange) {
  tern::FleetSpec by_list = spec(0);
  by_list.range = tern::FleetRange{};
  ASSERT_EQ(fleet(0).begin(by_list, resting({}, 0), now_), Status::kOk);
  ASSERT_EQ(fleet(0).add(2, now_), Status::kOk);
  ++incarnation_;
  ASSERT_EQ(fleet(0).begin(spec(0), resting({}, 0), now_), Status::kOk);
  EXPECT_EQ(fleet(0).neighbours(), 0);
}

TEST_F(FleetRangePair, RangesThatAreRefused) {
  const std::vector<void (*)(tern::FleetRange&)> faults = {
      [](tern::FleetRange& r) { r.join = -1.0; }, [](tern::FleetRange& r) { r.join = NAN; },
      [](tern::FleetRange& r) { r.heard = 0.0; }, [](tern::FleetRange& r) { r.heard = INFINITY; },
      [](tern::FleetRange& r) { r.speed = 0.0; }, [](tern::FleetRange& r) { r.speed = NAN; },
      [](tern::FleetRange& r) { r.within = 0; },  [](tern::FleetRange& r) { r.within = 61 * kSecond; },
      [](tern::FleetRange& r) { r.lease = 0; },   [](tern::FleetRange& r) { r.lease = 3601 * kSecond; }};
  for (const auto& fault : faults) {
    tern::FleetSpec wrong = spec(0);
    fault(wrong.range);
    EXPECT_EQ(fleet(0).begin(wrong, resting({}, 0), now_), Status::kInvalidArgument);
  }
}

}  // namespace
