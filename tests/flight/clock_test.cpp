// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Clocks that fall, that are set, and that show extreme numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Flying;

constexpr std::int64_t kFirst = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kSecond = 1000000000;
constexpr Vec3 kGoal{8.125, 0.125, 1.125};

bool same_bits(const Command& a, const Command& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

double gap(const Command& a, const Command& b) {
  const Vec3& p = a.sample.position;
  const Vec3& q = b.sample.position;
  return std::hypot(p.x - q.x, std::hypot(p.y - q.y, p.z - q.z));
}

FlightYaw turning() {
  FlightYaw yaw{};
  yaw.mode = FlightYawMode::kAlongMotion;
  yaw.acceleration_max = 5.0;
  yaw.start = {0.0, 1.0};
  return yaw;
}

/// Starts the room's flight anew when the clock shows `t`.
Status start_at(FlightRoom& room, std::int64_t t) {
  room.time = t;
  return room.flight.start(room.spec, room.map(), room.planner, room.words.data(), room.words.size(), room.start, t);
}

TEST(FlightClock, WhileItIsBehindTheLastCommandStays) {
  Flying room;
  const std::int64_t last = room.time - room.spec.tick;
  const Command kept = room.flight.command(last);
  const FlightReport before = room.report;
  for (std::int64_t t = last - 10 * kSecond; t < last; t += room.spec.tick) {
    EXPECT_TRUE(same_bits(room.flight.command(t), kept)) << t;
    FlightReport report{};
    ASSERT_EQ(room.flight.tick(t, report), Status::kClockBehind);
    EXPECT_EQ(report.mode, before.mode);
    EXPECT_EQ(report.committed, before.committed);
    EXPECT_EQ(report.work, 0u);
    EXPECT_TRUE(same_bits(room.flight.command(t), kept)) << t;
  }
  // It has caught up: the flight goes on as if nothing had been.
  EXPECT_EQ(room.flight.tick(last, room.report), Status::kOk);
  EXPECT_TRUE(same_bits(room.flight.command(last), kept));
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
}

TEST(FlightClock, YawStaysToo) {
  FlightRoom room;
  ASSERT_EQ(room.flight.set_yaw(turning()), Status::kOk);
  room.flight.set_goal(kGoal);
  ASSERT_TRUE(room.tick_until([&] { return room.flight.yaw(room.time).yaw.rate < -1.0; }, 400));
  const std::int64_t last = room.time - room.spec.tick;
  const YawSample kept = room.flight.yaw(last);
  for (const std::int64_t t : {last - 1, last - kSecond, std::int64_t{0}, -kSecond, kFirst}) {
    EXPECT_EQ(room.flight.yaw(t).angle, kept.angle) << t;
    EXPECT_EQ(room.flight.yaw(t).yaw.rate, kept.yaw.rate) << t;
  }
}

/// What the clock shows after it was set is one tick after the last one: the flight goes on with the command that was
/// due anyway, to the same bits.
TEST(FlightClock, FlightGoesOnAfterItWasSet) {
  for (const std::int64_t now : {-kSecond, 1000 * kSecond, kFirst, kLast - 60 * kSecond}) {
    Flying plain;
    Flying set;
    ASSERT_EQ(set.flight.set_clock(now), Status::kOk);
    const std::int64_t ahead = plain.time;
    for (int k = 0; k < 300; ++k) {
      const std::int64_t t = k * plain.spec.tick;
      FlightReport report{};
      ASSERT_EQ(plain.flight.tick(ahead + t, plain.report), Status::kOk);
      ASSERT_EQ(set.flight.tick(now + t, report), Status::kOk);
      EXPECT_TRUE(same_bits(set.flight.command(now + t + 12345), plain.flight.command(ahead + t + 12345))) << t;
      EXPECT_EQ(report.reason, plain.report.reason);
    }
    EXPECT_EQ(plain.report.reason, FlightReason::kArrived);
  }
  EXPECT_EQ(Flight{}.set_clock(0), Status::kInvalidArgument);
}

TEST(FlightClock, NothingLeapsWhereItIsSetLate) {
  Flying room;
  Command last = room.flight.command(room.time);
  const double most = 3.0 * 1.1e-9 * static_cast<double>(room.spec.tick);
  std::int64_t t = room.time;
  for (int k = 0; k < 400; ++k, t += room.spec.tick) {
    if (k == 20) t -= 3600 * kSecond;
    const Command unticked = room.flight.command(t);
    EXPECT_LE(gap(unticked, last), most) << k;
    const Status ticked = room.flight.tick(t, room.report);
    EXPECT_EQ(ticked, k >= 20 && k < 50 ? Status::kClockBehind : Status::kOk) << k;
    if (k == 49) room.flight.set_clock(t + room.spec.tick);
    last = room.flight.command(t);
    EXPECT_LE(gap(unticked, last), 1e-9) << k;
  }
  EXPECT_EQ(room.report.reason, FlightReason::kArrived);
}

/// A follower that shares the clock has only the committed plans. It takes each one once it begins, and flies what the
/// flight commands, to the same bits, wherever the clock is and after it was set.
TEST(FlightClock, FollowerOfCommittedPlansFliesTheCommands) {
  for (const std::int64_t begin : {std::int64_t{0}, 1700000000 * kSecond, kFirst, kLast - 60 * kSecond}) {
    FlightRoom room;
    ASSERT_EQ(start_at(room, begin), Status::kOk);
    ASSERT_EQ(room.flight.set_goal(kGoal), Status::kOk);
    Trajectory flown;
    ASSERT_EQ(room.flight.committed_plan(flown), Status::kOk);
    EXPECT_EQ(flown.begin, begin);
    int takeovers = 0;
    for (int k = 0; k < 600 && room.report.reason != FlightReason::kArrived; ++k) {
      room.tick();
      if (k == 100) {
        room.time = begin + 5 * kSecond;
        ASSERT_EQ(room.flight.set_clock(room.time), Status::kOk);
      }
      Trajectory latest;
      ASSERT_EQ(room.flight.committed_plan(latest), Status::kOk);
      for (std::int64_t t = room.time; t < room.time + room.spec.tick; t += room.spec.tick / 3) {
        if (latest.begin <= t) {
          takeovers += latest.begin != flown.begin ? 1 : 0;
          flown = latest;
        }
        const Sample sample = evaluate(flown, time_on(flown, t));
        const Sample commanded = room.flight.command(t).sample;
        ASSERT_EQ(std::memcmp(&sample, &commanded, sizeof sample), 0) << begin << " " << k;
      }
    }
    EXPECT_EQ(room.report.reason, FlightReason::kArrived);
    EXPECT_GT(takeovers, 3);
  }
  Trajectory none;
  EXPECT_EQ(Flight{}.committed_plan(none), Status::kInvalidArgument);
}

/// The planner's plans know when they take over: the request for them says so.
TEST(FlightClock, PlansBeginAtTheirTakeover) {
  FlightRoom room;
  FlightState& state = room.state();
  ASSERT_EQ(room.flight.set_goal(kGoal), Status::kOk);
  ASSERT_TRUE(room.tick_until([&] { return state.facts.plans.has_waiting; }, 100));
  const Commitment& waiting = state.facts.plans.waiting;
  EXPECT_EQ(waiting.begin(), state.draft.takeover);
  EXPECT_EQ(state.cycle.plan.begin, state.draft.takeover);
  EXPECT_EQ(waiting.trajectory.begin, waiting.begin());
  ASSERT_TRUE(room.tick_until([&] { return room.speed() > 2.5 && !state.facts.plans.has_waiting; }, 400));
  ASSERT_EQ(room.flight.stop(), Status::kOk);
  ASSERT_TRUE(room.tick_until([&] { return state.facts.plans.has_waiting; }, 100));
  EXPECT_EQ(state.facts.plans.latest().begin(), state.draft.takeover);
  EXPECT_EQ(state.facts.plans.latest().trajectory.begin, state.draft.takeover);
}

/// The map's frames carry times of the same clock.
TEST(FlightClock, MapTakesFramesOfTheNewTime) {
  Flying room;
  const Vec3 at = room.position();
  MapSpec spec = FlightRoom::map_spec();
  spec.scan_pixel = 0.1;
  spec.pixels = 10000;
  tern_test::OwnedMap owned(spec);
  ASSERT_EQ(owned.map.assume_free(room.start, 40.0), Status::kOk);
  ASSERT_EQ(room.flight.start(room.spec, owned.map, room.planner, room.words.data(), room.words.size(), room.start, 0),
            Status::kOk);
  const auto enter = [&](std::int64_t t) {
    const Status begun = owned.map.begin_scan(&at, 1, room.start, t);
    while (owned.map.step(1000) == Status::kRunning) {
    }
    return begun;
  };
  EXPECT_EQ(enter(kSecond), Status::kRunning);
  EXPECT_EQ(enter(kSecond - tern::kMaxFrameDelay - 1), Status::kClockBehind);
  ASSERT_EQ(room.flight.set_clock(5), Status::kOk);
  EXPECT_EQ(enter(5), Status::kRunning);
  EXPECT_EQ(enter(4 - tern::kMaxFrameDelay), Status::kClockBehind);
}

/// From the first time to the last one, all that was seen ages; the difference has 64 bits.
TEST(FlightClock, MapsAgeFromTheFirstTimeToTheLast) {
  for (const std::int64_t age : {std::int64_t{0}, 86400 * kSecond}) {
    MapSpec spec = FlightRoom::map_spec();
    spec.scan_pixel = 0.1;
    spec.pixels = 10000;
    spec.age = age;
    tern_test::OwnedMap owned(spec);
    ASSERT_EQ(owned.map.assume_free(kGoal, 2.0), Status::kOk);
    const Voxel there = owned.map.safe().voxel_of(owned.map.safe().to_local(kGoal));
    for (const std::int64_t t : {kFirst + 5, kFirst + 5 + kSecond, kLast}) {
      ASSERT_EQ(owned.map.begin_scan(nullptr, 0, {0.125, 0.125, 1.125}, t), Status::kRunning);
      while (owned.map.step(1000) == Status::kRunning) {
      }
      EXPECT_EQ(owned.map.seen(there), age == 0 || t < 0) << t;
    }
  }
}

/// Each flight from an extreme time is that from 0, bit for bit.
TEST(FlightClock, ExtremeTimesAreTimesLikeOthers) {
  const auto fly_from = [](std::int64_t begin) {
    FlightRoom room;
    EXPECT_EQ(start_at(room, begin), Status::kOk);
    EXPECT_EQ(room.flight.set_yaw(turning()), Status::kOk);
    EXPECT_EQ(room.flight.set_goal(kGoal), Status::kOk);
    std::vector<Command> flown;
    std::vector<double> turned;
    for (int k = 0; k < 400; ++k) {
      room.tick();
      flown.push_back(room.flight.command(room.time + 1234567));
      turned.push_back(room.flight.yaw(room.time + 1234567).angle);
    }
    EXPECT_EQ(room.report.reason, FlightReason::kArrived);
    EXPECT_EQ(room.report.frame_age, 399 * room.spec.tick);
    return std::make_pair(flown, turned);
  };
  const auto plain = fly_from(0);
  for (const std::int64_t begin : {kFirst, kFirst + 5, -2 * kSecond, kLast - 5 * kSecond}) {
    const auto flown = fly_from(begin);
    EXPECT_EQ(flown.second, plain.second);
    for (std::size_t k = 0; k < plain.first.size(); ++k) {
      ASSERT_TRUE(same_bits(flown.first[k], plain.first[k])) << begin << " " << k;
    }
  }
}

TEST(FlightClock, WholeRangeIsAnswered) {
  for (const std::int64_t begin : {kFirst, kFirst + 5, std::int64_t{0}, kLast - 5, kLast}) {
    FlightRoom room;
    ASSERT_EQ(start_at(room, begin), Status::kOk);
    ASSERT_EQ(room.flight.set_yaw(turning()), Status::kOk);
    ASSERT_EQ(room.flight.set_goal(kGoal), Status::kOk);
    for (const std::int64_t t : {kFirst, begin, kLast}) {
      EXPECT_EQ(room.flight.command(t).sample.position.x, room.start.x);
      EXPECT_EQ(room.flight.yaw(t).yaw.sine, 1.0);
    }
    for (int k = 0; k < 30 && begin < 1; ++k) room.tick();
    const Vec3 end = room.flight.rest_position();
    EXPECT_EQ(room.flight.command(kLast).sample.position.x, end.x);
    for (int k = 0; k < 3; ++k) ASSERT_EQ(room.flight.tick(kLast, room.report), Status::kOk);
    EXPECT_EQ(room.flight.command(kLast).sample.position.x, end.x);
    EXPECT_GE(room.report.frame_age, 0);
    if (begin == kLast) continue;
    EXPECT_EQ(room.flight.tick(0, room.report), Status::kClockBehind);
    // A single wrong reading ends no flight.
    ASSERT_EQ(room.flight.set_clock(0), Status::kOk);
    room.time = 0;
    EXPECT_EQ(room.fly(), FlightReason::kArrived) << begin;
  }
}

TEST(FlightClock, ContactsAreOfTheCallersTime) {
  Flying room;
  ASSERT_EQ(room.flight.set_clock(kFirst + 7), Status::kOk);
  room.time = kFirst + 7;
  const Vec3 p = room.position();
  room.mark({{p.x + 1.5, -1.0, -1.0}, {p.x + 1.75, 1.5, 3.0}});
  ASSERT_TRUE(room.tick_until([&] { return room.report.mode == FlightMode::kThreat; }, 20));
  EXPECT_GT(room.report.contact_time, room.time - room.spec.tick);
  EXPECT_LT(room.report.contact_time, room.time + kSecond);
}

TEST(FlightClock, TicksAndStalenessOutOfRangeAreRefused) {
  FlightRoom room;
  for (const std::int64_t tick : {std::int64_t{0}, std::int64_t{-1}, kFirst, 10 * kSecond + 1, kLast}) {
    room.spec.tick = tick;
    EXPECT_EQ(start_at(room, 0), Status::kInvalidArgument) << tick;
  }
  room.spec.tick = 10 * kSecond;
  for (const std::int64_t age : {std::int64_t{-1}, kFirst}) {
    room.spec.stale_after = age;
    EXPECT_EQ(start_at(room, 0), Status::kInvalidArgument) << age;
  }
}

/// A contact after the last number that the clock has, and a plan that ends after the farthest time.
TEST(FlightClock, WhatComesLaterIsShownAsTheLastNumber) {
  FlightRoom room;
  ASSERT_EQ(start_at(room, kLast - kSecond), Status::kOk);
  FlightState& state = room.state();
  state.watch.threat = true;
  for (const std::int64_t beyond : {-1, 0, 1}) {
    state.watch.contact = {kSecond + beyond, 1.0};
    state.finish_report(0);
    EXPECT_EQ(state.report.contact_time, beyond < 0 ? kLast - 1 : kLast) << beyond;
  }
  state.facts.plans.in_flight.trajectory.segments[0].duration = 1e12;
  EXPECT_EQ(state.facts.plans.rest_begins(), state.facts.plans.in_flight.begin() + kFarthest + 1);
}

/// The longest tick, the least work and the largest plan together, late in the longest flight.
TEST(FlightClock, LargestLeadsFitIntoTheLargestTimes) {
  FlightRoom room;
  room.spec.tick = 10 * kSecond;
  room.spec.work_per_tick = 256;
  room.spec.plan_work = std::numeric_limits<std::uint32_t>::max();
  room.spec.stale_after = kLast;
  ASSERT_EQ(start_at(room, kFirst), Status::kOk);
  ASSERT_EQ(room.flight.set_yaw(turning()), Status::kOk);
  ASSERT_EQ(room.flight.set_goal(kGoal), Status::kOk);
  for (const std::int64_t t : {kFirst, kFirst + kSecond, kFirst + 1, kLast, kLast}) {
    FlightReport report{};
    const Status ticked = room.flight.tick(t, report);
    EXPECT_EQ(ticked, t == kFirst + 1 ? Status::kClockBehind : Status::kOk);
    EXPECT_FALSE(report.map_stale);
  }
  room.flight.stop();
  EXPECT_EQ(room.flight.tick(kLast, room.report), Status::kOk);
  EXPECT_EQ(room.flight.command(kLast).sample.position.x, room.start.x);
}

}  // namespace
