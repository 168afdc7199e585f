// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights through C: the same commands as through C++, and an answer to every call that comes too early or is wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "support/flown.hpp"
#include "tern/tern_flight.h"

namespace {

using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::Scene;

constexpr std::uint8_t kOk = 0;
constexpr auto kInvalid = static_cast<std::uint8_t>(tern::Status::kInvalidArgument);

/// A C map over words of its own that knows the ball around the start.
struct MapInC {
  MapInC() : spec(Flown::spec_of(FlightSettings{})), words(tern_map_words(&spec)) {
    EXPECT_EQ(tern_map_bind(&map, &spec, words.data(), words.size(), nullptr), kOk);
    EXPECT_EQ(tern_map_assume_free(&map, &start, 1.2), kOk);
  }
  tern_vec3 start = FlightSettings{}.start;
  tern_map_spec spec;
  std::vector<std::uint64_t> words;
  tern_map map{};
};

/// A C map with a planner and a flight's words, not started.
struct FlightInC : MapInC {
  FlightInC() : memory(std::make_unique<tern::Workspace>()), flight_words(tern_flight_words(MapInC::spec.dims)) {
    EXPECT_EQ(tern_planner_init(&planner, memory.get(), sizeof *memory), kOk);
    const tern_limits limits{{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}};
    tern_flight_spec_init(&flight_spec, &limits);
  }
  std::uint8_t begin() {
    return tern_flight_start(&flight, &flight_spec, &map, &planner, flight_words.data(), flight_words.size(), &start, 0,
                             nullptr);
  }
  std::unique_ptr<tern::Workspace> memory;
  std::vector<std::uint64_t> flight_words;
  tern_planner planner{};
  tern_flight_spec flight_spec{};
  tern_flight flight{};
};

TEST(FlightC, SaysThatNoFramesCome) {
  FlightInC c;
  EXPECT_EQ(c.flight_spec.stale_after, 1000000000);
  ASSERT_EQ(c.begin(), kOk);
  tern_flight_report report{};
  EXPECT_EQ(tern_flight_tick(&c.flight, 1000000000, &report), kOk);
  EXPECT_FALSE(report.map_stale);
  EXPECT_EQ(tern_flight_tick(&c.flight, 1000000001, &report), kOk);
  EXPECT_TRUE(report.map_stale);
  EXPECT_EQ(report.frame_age, 1000000001);
  EXPECT_STRNE(tern_flight_reason_text(TERN_FLIGHT_MAP_STALE), "unknown");
  EXPECT_EQ(static_cast<int>(report.blocked_by), TERN_BLOCKED_BY_NOTHING);
  EXPECT_STREQ(tern_blocked_by_text(TERN_BLOCKED_BY_FENCE), "a fence");
}

TEST(FlightC, TakesMeasuredPositions) {
  FlightInC c;
  ASSERT_EQ(c.begin(), kOk);
  tern_flight_report report{};
  const tern_vec3 measured{c.start.x, c.start.y + 0.125, c.start.z};
  EXPECT_EQ(tern_flight_note_position(&c.flight, nullptr, 0), kInvalid);
  EXPECT_EQ(tern_flight_note_position(&c.flight, &measured, 0), kOk);
  EXPECT_EQ(tern_flight_tick(&c.flight, 0, &report), kOk);
  EXPECT_NEAR(report.stray, 0.125, 1e-12);
  EXPECT_EQ(report.speed_share, 1.0);  // this map has no tracking margin
  EXPECT_STRNE(tern_flight_reason_text(TERN_FLIGHT_MARGIN_EXCEEDED), "unknown");
}

TEST(FlightC, TakesThingsThatMove) {
  FlightInC c;
  ASSERT_EQ(c.begin(), kOk);
  tern_track track{};
  track.id = 9;
  track.position = {c.start.x + 3.0, c.start.y, c.start.z};
  track.velocity = {-1.0, 0.0, 0.0};
  EXPECT_EQ(tern_flight_update_track(&c.flight, nullptr), kInvalid);
  EXPECT_EQ(tern_flight_update_track(&c.flight, &track), kOk);
  tern_flight_report report{};
  EXPECT_EQ(tern_flight_tick(&c.flight, 0, &report), kOk);
  EXPECT_LT(tern_flight_rest_clear_until(&c.flight), 3000000000);
  EXPECT_EQ(tern_flight_forget_track(&c.flight, 8), kInvalid);
  EXPECT_EQ(tern_flight_forget_track(&c.flight, 9), kOk);
  EXPECT_EQ(tern_flight_tick(&c.flight, 10000000, &report), kOk);
  EXPECT_EQ(tern_flight_rest_clear_until(&c.flight), INT64_MAX);
  EXPECT_STREQ(tern_blocked_by_text(TERN_BLOCKED_BY_TRACK), "something that moves");
  tern_limits limits = FlightRoom::flight_spec().limits;
  const tern_flight_spec spec = FlightRoom::flight_spec();
  tern_trajectory room;
  EXPECT_EQ(tern_limit_speed(3.2, 0.1, 4.0, 0.35, nullptr, 0.5, &limits, &room), kInvalid);
  EXPECT_EQ(tern_limit_speed(3.2, 0.1, 4.0, 0.35, &spec, 0.5, nullptr, &room), kInvalid);
  EXPECT_EQ(tern_limit_speed(3.2, 0.1, 4.0, 0.35, &spec, 0.5, &limits, nullptr), kInvalid);
  EXPECT_EQ(tern_limit_speed(3.2, 0.1, 4.0, 0.35, &spec, 0.5, &limits, &room), kOk);
  EXPECT_LT(limits.v_max.x, spec.limits.v_max.x);
}

/// The window is 51.2 m long.
TEST(FlightC, HorizonsOfHalfTheWindowAreRefused) {
  FlightInC c;
  c.flight_spec.horizon = 25.6;
  EXPECT_EQ(c.begin(), kInvalid);
  c.flight_spec.horizon = 25.5;
  EXPECT_EQ(c.begin(), kOk);
}

TEST(FlightC, EqualsTheFlightInCpp) {
  Flown flown(Scene{}, FlightSettings{});
  ASSERT_EQ(flown.started, tern::Status::kOk);
  MapInC c;
  auto memory = std::make_unique<tern::Workspace>();
  tern_planner planner{};
  ASSERT_EQ(tern_planner_init(&planner, memory.get(), sizeof *memory), kOk);
  tern_flight_spec spec{};
  tern_flight_spec_init(&spec, &flown.spec.limits);
  std::vector<std::uint64_t> words(tern_flight_words(c.spec.dims));
  EXPECT_EQ(words.size(), flown.words.size());
  tern_flight flight{};
  ASSERT_EQ(tern_flight_start(&flight, &spec, &c.map, &planner, words.data(), words.size(), &c.start, 0, nullptr), kOk);
  const tern_vec3 goal{3.0, 0.5, 1.5};
  ASSERT_EQ(tern_flight_set_goal(&flight, &goal), kOk);
  ASSERT_EQ(flown.flight.set_goal(goal), tern::Status::kOk);
  flown.frames = false;
  for (int k = 0; k < 60; ++k) {
    tern_flight_report report{};
    ASSERT_EQ(tern_flight_tick(&flight, k * spec.tick, &report), kOk);
    flown.tick();
    EXPECT_EQ(report.committed, flown.report.committed);
    tern_command command{};
    tern_flight_command(&flight, k * spec.tick, &command);
    const tern::Command other = flown.flight.command(k * spec.tick);
    EXPECT_EQ(std::memcmp(&command, &other, sizeof command), 0);
    tern_vec3 rest{};
    tern_flight_rest_position(&flight, &rest);
    const tern::Vec3 other_rest = flown.flight.rest_position();
    EXPECT_EQ(std::memcmp(&rest, &other_rest, sizeof rest), 0);
    tern_trajectory plan;
    ASSERT_EQ(tern_flight_committed_plan(&flight, &plan), kOk);
    tern::Trajectory other_plan;
    ASSERT_EQ(flown.flight.committed_plan(other_plan), tern::Status::kOk);
    EXPECT_EQ(plan.begin, other_plan.begin);
    EXPECT_EQ(tern_duration(&plan), tern::duration(other_plan));
  }
  EXPECT_EQ(tern_flight_committed_plan(&flight, nullptr), kInvalid);
  tern_flight_rest_position(&flight, nullptr);
  EXPECT_GT(flown.report.committed, 0u);
  EXPECT_EQ(tern_flight_stop(&flight), kOk);
}

TEST(FlightC, BeginsOnTheGroundAndLands) {
  FlightInC c;
  c.start = {0.0, 0.0, 0.15};
  const tern_vec3 place{0.0, 0.0, 0.15};
  EXPECT_EQ(tern_flight_land(&c.flight, &place, 0.05, 0.5), kInvalid);
  EXPECT_EQ(c.begin(), static_cast<std::uint8_t>(tern::Status::kStartOccupied));
  const tern_cylinder column{{0.0, 0.0, 0.05}, 1.3, 3.0};
  ASSERT_EQ(tern_map_assume_column(&c.map, &column), kOk);
  ASSERT_EQ(c.begin(), kOk);
  tern_flight_refusal why{};
  EXPECT_EQ(tern_flight_check_goal(&c.flight, nullptr, &why), kInvalid);
  EXPECT_EQ(tern_flight_check_goal(&c.flight, &place, &why), static_cast<std::uint8_t>(tern::Status::kGoalOccupied));
  EXPECT_NEAR(why.distance, 0.1, 1e-12);
  EXPECT_EQ(tern_flight_land(&c.flight, nullptr, 0.05, 0.5), kInvalid);
  EXPECT_EQ(tern_flight_land(&c.flight, &place, 0.05, -0.5), kInvalid);
  ASSERT_EQ(tern_flight_land(&c.flight, &place, 0.05, 0.5), kOk);
  tern_flight_report report{};
  for (int k = 0; k < 1000 && report.reason != tern::FlightReason::kLanded; ++k) {
    ASSERT_EQ(tern_flight_tick(&c.flight, k * c.flight_spec.tick, &report), kOk);
  }
  EXPECT_EQ(static_cast<int>(report.reason), TERN_FLIGHT_LANDED);
  for (const int reason : {TERN_FLIGHT_LANDED, TERN_FLIGHT_GROUND_UNSEEN, TERN_FLIGHT_GROUND_UNEVEN}) {
    EXPECT_STRNE(tern_flight_reason_text(static_cast<std::uint8_t>(reason)), "unknown");
  }
}

TEST(FlightC, MissionsAreSetAndRefused) {
  FlightInC c;
  const tern_via points[2] = {{{0.4, 0.0, 1.5}, 0.1}, {{0.0, 0.4, 1.5}}};
  EXPECT_EQ(tern_flight_set_mission(&c.flight, points, 2, TERN_VIA_SKIP), kInvalid);
  EXPECT_EQ(tern_flight_set_mission(nullptr, points, 2, TERN_VIA_SKIP), kInvalid);
  ASSERT_EQ(c.begin(), kOk);
  EXPECT_EQ(tern_flight_set_mission(&c.flight, nullptr, 2, TERN_VIA_SKIP), kInvalid);
  EXPECT_EQ(tern_flight_set_mission(&c.flight, points, 2, 7), kInvalid);
  ASSERT_EQ(tern_flight_set_mission(&c.flight, points, 2, TERN_VIA_END), kOk);
  tern_flight_report report{};
  for (int k = 0; k < 600 && report.reason != tern::FlightReason::kArrived; ++k) {
    ASSERT_EQ(tern_flight_tick(&c.flight, k * c.flight_spec.tick, &report), kOk);
  }
  EXPECT_EQ(report.passed, 2);
  EXPECT_EQ(report.leg, 1);
  EXPECT_EQ(tern_flight_point_state(&c.flight, 0), TERN_POINT_PASSED);
  EXPECT_EQ(tern_flight_point_state(&c.flight, 2), TERN_POINT_AHEAD);
  EXPECT_EQ(tern_flight_point_state(nullptr, 0), TERN_POINT_AHEAD);
}

TEST(FlightC, YawIsPlannedAndRefused) {
  FlightInC c;
  tern_flight_yaw yaw{};
  yaw.mode = tern::FlightYawMode::kFixed;
  yaw.acceleration_max = 4.0;
  yaw.start = {1.0, 0.0};
  yaw.heading = {0.0, 1.0};
  EXPECT_EQ(tern_flight_set_yaw(&c.flight, &yaw), kInvalid);
  ASSERT_EQ(c.begin(), kOk);
  EXPECT_EQ(tern_flight_set_yaw(&c.flight, nullptr), kInvalid);
  EXPECT_EQ(tern_flight_set_yaw(nullptr, &yaw), kInvalid);
  ASSERT_EQ(tern_flight_set_yaw(&c.flight, &yaw), kOk);
  for (int k = 0; k < 300; ++k) ASSERT_EQ(tern_flight_tick(&c.flight, k * c.flight_spec.tick, nullptr), kOk);
  tern_yaw_sample at{};
  tern_flight_yaw_at(&c.flight, 300 * c.flight_spec.tick, &at);
  EXPECT_NEAR(at.yaw.sine, 1.0, 1e-3);
  EXPECT_NEAR(at.yaw.rate, 0.0, 1e-2);
  tern_flight_yaw_at(&c.flight, 0, nullptr);
}

TEST(FlightC, ProofEqualsTheProofInCpp) {
  MapInC c;
  tern_grid safe{};
  ASSERT_EQ(tern_map_safe(&c.map, &safe), kOk);
  tern_trajectory plan{};
  plan.count = 1;
  plan.origin = c.start;
  plan.segments[0].duration = 4.0;
  for (int i = 0; i < tern::kControlPoints; ++i) plan.segments[0].points[i] = {i / 7.0 * 4.0, 0.0, 0.0};
  tern_proof_report report{};
  const double until = tern_clear_until(&safe, &plan, 0.0, nullptr, TERN_BEYOND_SOLID, &report);
  EXPECT_GT(until, 0.3);
  EXPECT_LT(until, 1.2);
  EXPECT_EQ(static_cast<int>(report.finding), TERN_FINDING_OBSTACLE);
  EXPECT_TRUE(std::isnan(tern_clear_until(nullptr, &plan, 0.0, nullptr, 0, nullptr)));
  EXPECT_TRUE(std::isnan(tern_clear_until(&safe, nullptr, 0.0, nullptr, 0, nullptr)));
  const tern_grid none{};
  EXPECT_EQ(tern_clear_until(&none, &plan, 0.5, nullptr, 0, nullptr), 0.5);
}

TEST(FlightC, PointsOfAMissionAreChecked) {
  FlightInC c;
  ASSERT_EQ(c.begin(), kOk);
  const auto set = [&c](auto change, int number = 0) {
    tern_via points[2] = {{{0.4, 0.0, 1.5}, 0.1}, {{0.4, 0.0, 1.5}, 0.1}};
    change(points[number]);
    return static_cast<tern::Status>(tern_flight_set_mission(&c.flight, points, 2, TERN_VIA_SKIP));
  };
  using tern::Status;
  EXPECT_EQ(set([](tern_via&) {}), Status::kOk);
  EXPECT_EQ(set([](tern_via& v) { v.position.y = NAN; }), Status::kNonFiniteInput);
  EXPECT_EQ(set([](tern_via& v) { v.tolerance = NAN; }), Status::kNonFiniteInput);
  EXPECT_EQ(set([](tern_via& v) { v.tolerance = -0.1; }), Status::kInvalidArgument);
  EXPECT_EQ(set([](tern_via& v) { v.has_velocity = true; }), Status::kInvalidArgument);
  // The goal's tolerance and stop mean nothing.
  EXPECT_EQ(set([](tern_via& v) { v.tolerance = NAN; }, 1), Status::kOk);
  EXPECT_EQ(set([](tern_via& v) { v.tolerance = -0.1; }, 1), Status::kOk);
  EXPECT_EQ(set([](tern_via& v) { v.stop = true; }, 1), Status::kOk);
  EXPECT_EQ(set([](tern_via& v) { v.position.z = INFINITY; }, 1), Status::kNonFiniteInput);
  EXPECT_EQ(set([](tern_via& v) { v.has_velocity = true; }, 1), Status::kInvalidArgument);
  const std::vector<tern_via> many(tern::kMaxMissionPoints + 1);
  EXPECT_EQ(tern_flight_set_mission(&c.flight, many.data(), 0, TERN_VIA_SKIP), kInvalid);
  EXPECT_EQ(
      static_cast<Status>(tern_flight_set_mission(&c.flight, many.data(), tern::kMaxMissionPoints + 1, TERN_VIA_SKIP)),
      Status::kViasFull);
  EXPECT_EQ(tern_flight_point_state(&c.flight, -1), TERN_POINT_AHEAD);
}

TEST(FlightC, YawPlansAreChecked) {
  FlightInC c;
  ASSERT_EQ(c.begin(), kOk);
  const auto set = [&c](auto change) {
    tern_flight_yaw yaw{};
    yaw.mode = tern::FlightYawMode::kFixed;
    yaw.acceleration_max = 4.0;
    yaw.start = {1.0, 0.0};
    yaw.heading = {0.0, 1.0};
    change(yaw);
    return static_cast<tern::Status>(tern_flight_set_yaw(&c.flight, &yaw));
  };
  using tern::Status;
  EXPECT_EQ(set([](tern_flight_yaw& y) { y.start = {0.0, 0.0}; }), Status::kInvalidArgument);
  EXPECT_EQ(set([](tern_flight_yaw& y) { y.start.cosine = NAN; }), Status::kNonFiniteInput);
  EXPECT_EQ(set([](tern_flight_yaw&) {}), Status::kOk);
  EXPECT_EQ(set([](tern_flight_yaw& y) { y.acceleration_max = NAN; }), Status::kNonFiniteInput);
  EXPECT_EQ(set([](tern_flight_yaw& y) { y.field_of_view = NAN; }), Status::kNonFiniteInput);
  EXPECT_EQ(set([](tern_flight_yaw& y) { y.acceleration_max = 1e-3; }), Status::kLimitsInvalid);
  EXPECT_EQ(set([](tern_flight_yaw& y) { y.acceleration_max = 1e4; }), Status::kLimitsInvalid);
  EXPECT_EQ(set([](tern_flight_yaw& y) { y.start = {0.0, 0.0}; }), Status::kOk);  // it is read once
  EXPECT_EQ(set([](tern_flight_yaw& y) { y.heading = {NAN, 1.0}; }), Status::kNonFiniteInput);
  EXPECT_EQ(set([](tern_flight_yaw& y) { y.heading = {0.0, 0.0}; }), Status::kInvalidArgument);
}

TEST(FlightC, CallsThatComeTooEarlyAreRefused) {
  tern_flight flight{};
  tern_flight_report report{};
  const tern_vec3 goal{1.0, 0.0, 1.0};
  EXPECT_EQ(tern_flight_set_goal(&flight, &goal), kInvalid);
  EXPECT_EQ(tern_flight_set_goal(&flight, nullptr), kInvalid);
  EXPECT_EQ(tern_flight_set_goal(nullptr, &goal), kInvalid);
  EXPECT_EQ(tern_flight_stop(&flight), kInvalid);
  EXPECT_EQ(tern_flight_tick(&flight, 0, &report), kInvalid);
  EXPECT_EQ(tern_flight_set_clock(&flight, 0), kInvalid);
  EXPECT_EQ(tern_flight_set_clock(nullptr, 0), kInvalid);
  EXPECT_EQ(tern_flight_note_position(&flight, &goal, 0), kInvalid);
  EXPECT_EQ(tern_flight_note_position(nullptr, &goal, 0), kInvalid);
  const tern_track track{};
  EXPECT_EQ(tern_flight_update_track(nullptr, &track), kInvalid);
  EXPECT_EQ(tern_flight_update_track(&flight, &track), kInvalid);
  EXPECT_EQ(tern_flight_forget_track(&flight, 0), kInvalid);
  EXPECT_EQ(tern_flight_rest_clear_until(nullptr), INT64_MAX);
  tern_trajectory plan{};
  std::int64_t takeover = 0;
  EXPECT_EQ(tern_flight_proposal(nullptr, &plan, &takeover), 0u);
  EXPECT_EQ(tern_flight_proposal(&flight, nullptr, &takeover), 0u);
  EXPECT_EQ(tern_flight_answer(&flight, 1, true), kInvalid);
  EXPECT_EQ(tern_flight_set_clearance(&flight, 1000), kInvalid);
  tern_command command{};
  command.look_at = goal;
  tern_flight_command(&flight, 0, &command);
  EXPECT_EQ(command.look_at.x, 0.0);
  tern_flight_command(&flight, 0, nullptr);
  tern_flight_spec_init(nullptr, nullptr);
  EXPECT_EQ(tern_flight_words({0, 1, 1}), 0u);
  FlightInC c;
  EXPECT_EQ(tern_flight_start(nullptr, &c.flight_spec, &c.map, &c.planner, nullptr, 0, &goal, 0, nullptr), kInvalid);
  EXPECT_EQ(tern_flight_start(&flight, nullptr, &c.map, &c.planner, nullptr, 0, &goal, 0, nullptr), kInvalid);
  EXPECT_EQ(tern_flight_start(&flight, &c.flight_spec, nullptr, &c.planner, nullptr, 0, &goal, 0, nullptr), kInvalid);
  EXPECT_EQ(tern_flight_start(&flight, &c.flight_spec, &c.map, nullptr, nullptr, 0, &goal, 0, nullptr), kInvalid);
  EXPECT_EQ(tern_flight_start(&flight, &c.flight_spec, &c.map, &c.planner, nullptr, 0, nullptr, 0, nullptr), kInvalid);
  EXPECT_EQ(tern_flight_start(&flight, &c.flight_spec, &c.map, &c.planner, nullptr, 0, &goal, 0, nullptr), kInvalid);
  const tern_map none{};
  EXPECT_EQ(tern_flight_start(&flight, &c.flight_spec, &none, &c.planner, c.flight_words.data(), c.flight_words.size(),
                              &goal, 0, nullptr),
            kInvalid);
  tern_flight_spec kept = c.flight_spec;
  tern_flight_spec_init(&kept, nullptr);
  EXPECT_EQ(kept.tick, c.flight_spec.tick);
}

/// flight_refusals_test.cpp has what is refused; here, that the reason reaches C.
TEST(FlightC, ARefusalSaysWhatIsWrong) {
  FlightInC c;
  tern_flight_refusal refusal{tern::Field::kCell, 7};
  const auto start = [&] {
    return tern_flight_start(&c.flight, &c.flight_spec, &c.map, &c.planner, c.flight_words.data(),
                             c.flight_words.size(), &c.start, 0, &refusal);
  };
  const tern_halfspace planes[] = {{{1.0, 0.0, 0.0}, 9.0}, {{NAN, 0.0, 0.0}, 9.0}};
  const tern_fence fences[] = {{planes, 1, tern::FenceKind::kKeepIn}, {planes + 1, 1, tern::FenceKind::kKeepIn}};
  c.flight_spec.fences = fences;
  c.flight_spec.fence_count = 2;
  EXPECT_EQ(start(), static_cast<std::uint8_t>(tern::Status::kNonFiniteInput));
  EXPECT_EQ(refusal.field, tern::Field::kFences);
  EXPECT_EQ(refusal.fence, 1);
  EXPECT_EQ(tern_flight_stop(&c.flight), kInvalid);
  c.flight_spec.fence_count = 1;
  EXPECT_EQ(start(), kOk);
  EXPECT_EQ(refusal.field, tern::Field::kNone);
  EXPECT_EQ(refusal.fence, tern::kNoFence);
}

TEST(FlightC, NothingWasLookedAtInVain) {
  FlightInC c;
  ASSERT_EQ(c.begin(), kOk);
  tern_unseen_voxel voxel{{1.0, 2.0, 3.0}, 7, {}};
  EXPECT_EQ(tern_flight_looked_in_vain(&c.flight, &voxel, 1), 0);
  EXPECT_EQ(voxel.views, 7);
  EXPECT_EQ(tern_flight_looked_in_vain(&c.flight, nullptr, 1), 0);
  EXPECT_EQ(tern_flight_looked_in_vain(nullptr, &voxel, 1), 0);
}

TEST(FlightC, TimeMustNotFall) {
  FlightInC c;
  ASSERT_EQ(c.begin(), kOk);
  EXPECT_EQ(tern_flight_tick(&c.flight, 1000, nullptr), kOk);
  EXPECT_EQ(tern_flight_tick(&c.flight, 999, nullptr), TERN_CLOCK_BEHIND);
  EXPECT_EQ(tern_flight_tick(&c.flight, 1000, nullptr), kOk);
  EXPECT_EQ(tern_flight_set_clock(&c.flight, 5), kOk);
  EXPECT_EQ(tern_flight_tick(&c.flight, 5, nullptr), kOk);
}

}  // namespace
