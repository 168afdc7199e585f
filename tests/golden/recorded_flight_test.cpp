// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records of flights: what the core writes, the host flies again to the same bits.
#include "golden/recorded_flight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "host/flight/flight_replay.hpp"
#include "tern/tern_flight_record.h"

namespace {

using namespace tern_golden;
using tern::FlightRecorder;
using tern::Status;

TEST(FlightRecord, AWholeFlightIsFlownAgainToTheSameBits) {
  const std::string bytes = record(kTicks);
  const tern_host::FlightReplay replayed = tern_host::replay_flight(bytes);
  EXPECT_EQ(replayed.difference, "");
  EXPECT_EQ(replayed.ticks, kTicks);
  EXPECT_GT(replayed.frames, 100);
  EXPECT_NEAR(replayed.seconds, 0.02 * (kTicks - 1), 1e-9);
  EXPECT_EQ(replayed.configuration, tern::kConfigurationHash);
}

TEST(FlightRecord, AStreamOfSmallBuffersIsTheSameRecord) {
  std::vector<std::uint8_t> bytes(16384);
  FlightRecorder recorder;
  ASSERT_EQ(recorder.begin(bytes.data(), bytes.size()), Status::kOk);
  std::string saved;
  fly_recorded(recorder, kShort, [&] {
    saved += text(bytes, recorder.pending());
    recorder.clear();
    EXPECT_EQ(recorder.pending(), 0u);
  });
  std::size_t used = 0;
  ASSERT_EQ(recorder.close(&used), Status::kOk);
  EXPECT_EQ(saved + text(bytes, used), short_record());
}

TEST(FlightRecord, WhatFitsIntoAFullBufferIsAGoodRecord) {
  const std::string& whole = short_record();
  for (const std::size_t room : {std::size_t{tern::kFlightRecordBytes}, whole.size() / 3, whole.size() - 8}) {
    const std::string part = record(kShort, room);
    EXPECT_LE(part.size(), room);
    const tern_host::FlightReplay replayed = tern_host::replay_flight(part);
    EXPECT_EQ(replayed.difference, "") << room;
    EXPECT_LT(replayed.ticks, kShort);
    EXPECT_EQ(whole.compare(0, part.size() - 16, part, 0, part.size() - 16), 0);
  }
  EXPECT_EQ(record(kShort, whole.size()), whole);
}

TEST(FlightRecord, ARecorderThatIsFullSaysSoFromThenOn) {
  std::uint8_t bytes[tern::kFlightRecordBytes + 40];
  FlightRecorder recorder;
  EXPECT_EQ(recorder.set_goal({1, 2, 3}, Status::kOk), Status::kInvalidArgument);
  EXPECT_EQ(recorder.begin(nullptr, sizeof bytes), Status::kInvalidArgument);
  EXPECT_EQ(recorder.begin(bytes, tern::kFlightRecordBytes - 1), Status::kRecordFull);
  ASSERT_EQ(recorder.begin(bytes, sizeof bytes), Status::kOk);
  EXPECT_EQ(recorder.set_goal({1, 2, 3}, Status::kNonFiniteInput), Status::kOk);  // refused: nothing to record
  EXPECT_EQ(recorder.pending(), kHeadBytes);
  EXPECT_EQ(recorder.mark_points(nullptr, 1, Status::kOk), Status::kInvalidArgument);
  EXPECT_EQ(recorder.set_goal({1, 2, 3}, Status::kOk), Status::kOk);
  EXPECT_EQ(recorder.set_goal({1, 2, 3}, Status::kOk), Status::kRecordFull);
  EXPECT_EQ(recorder.stop(Status::kOk), Status::kRecordFull);  // it would fit, but behind a gap
  std::size_t used = 0;
  EXPECT_EQ(recorder.close(&used), Status::kOk);
  EXPECT_EQ(used, tern::kFlightRecordBytes + 32);
  EXPECT_EQ(recorder.close(nullptr), Status::kInvalidArgument);
}

TEST(FlightRecord, NoFrameTakesMoreThanItsBound) {
  std::vector<std::uint8_t> bytes(1 << 20);
  std::vector<std::uint16_t> depths(70000);
  std::vector<float> floats(depths.size());
  for (const int pattern : {1, 2, 3, 4, 5}) {
    // Runs of `pattern` equal numbers: with three, each kind of run follows the other.
    for (std::size_t k = 0; k < depths.size(); ++k) {
      depths[k] = static_cast<std::uint16_t>(pattern == 5 ? 7 : k / static_cast<std::size_t>(pattern) % 977);
      if (pattern == 3 && k % 4 == 0) depths[k] = static_cast<std::uint16_t>(1000 + k % 977);
      floats[k] = depths[k];
    }
    for (const int kind : {16, 32}) {
      tern::DepthView view{};
      if (kind == 16) view.z16 = depths.data();
      if (kind == 32) view.z32 = floats.data();
      view.width = view.stride = 70000;
      view.height = 1;
      FlightRecorder recorder;
      ASSERT_EQ(recorder.begin(bytes.data(), tern::kFlightRecordBytes + tern::frame_record_bytes(view)), Status::kOk);
      EXPECT_EQ(recorder.frame(view, {{0, 0, 0}, {1, 0, 0, 0}}, 0, Status::kRunning), Status::kOk) << pattern;
      EXPECT_LT(recorder.pending(), pattern == 5 ? 300u : bytes.size());
    }
  }
  tern::DepthView none{};
  EXPECT_EQ(tern::frame_record_bytes(none), 0u);
}

/// A ball that flies past beside the way.
tern::Track ball_beside(int tick, std::int64_t t) {
  tern::Track ball;
  ball.id = 3;
  ball.measured = t;
  ball.position = {0.02 * tick, 1.3, kEyeHeight};
  ball.velocity = {1.0, 0.0, 0.0};
  ball.radius = 0.2;
  ball.error = 0.02;
  ball.error_growth = 0.5;
  ball.reach = 1.5;
  return ball;
}

/// Another vehicle, which flies to and fro at a distance.
void record_curve(FlightRecorder& recorder, tern::Flight& flight, std::int64_t t) {
  tern::TrackPiece pieces[2] = {{0.5, {}}, {0.5, {}}};
  for (int k = 0; k < 8; ++k) pieces[0].points[k] = pieces[1].points[7 - k] = {0.1 * k, 0.01 * k * k, 0.0};
  tern::Track vehicle;
  vehicle.id = 4;
  vehicle.measured = t;
  vehicle.position = {0.0, 4.0, kEyeHeight};
  vehicle.radius = 0.2;
  vehicle.pieces = pieces;
  vehicle.piece_count = 2;
  EXPECT_EQ(recorder.update_track(vehicle, flight.update_track(vehicle)), Status::kOk);
}

TEST(FlightRecord, ScansMarksAndYawsAreReplayedToo) {
  std::vector<std::uint8_t> bytes(1 << 20);
  FlightRecorder recorder;
  ASSERT_EQ(recorder.begin(bytes.data(), bytes.size()), Status::kOk);
  tern::MapSpec spec = map_spec_of(kSmallFlight);
  spec.scan_pixel = 0.2;
  const tern::Box wall{{9, -4, 0}, {9.5, 4, 3}};
  spec.prior = &wall;
  spec.prior_count = 1;
  const tern::Cylinder trunk{{8, 2, 0}, 0.3, 3};
  spec.prior_cylinders = &trunk;
  spec.prior_cylinder_count = 1;
  std::vector<std::uint64_t> map_words(tern::map_words(spec)), words(tern::flight_words(spec.dims));
  const auto workspace = std::make_unique<tern::Workspace>();
  tern::Planner planner(workspace.get(), sizeof *workspace);
  tern::RollingMap map;
  recorder.bind(spec, map.bind(spec, map_words.data(), map_words.size()));
  const tern::Vec3 eye{0, 0, kEyeHeight};
  recorder.assume_free(eye, 2.0, map.assume_free(eye, 2.0));
  const tern::Cylinder column{{0, 0, 0}, 1.5, 3};
  recorder.assume_column(column, map.assume_column(column));
  recorder.mark_box({{3, 2, 0}, {3.5, 3, 3}}, map.mark_box({{3, 2, 0}, {3.5, 3, 3}}));
  recorder.mark_cylinder({{4, -2, 0}, 0.3, 3}, map.mark_cylinder({{4, -2, 0}, 0.3, 3}));
  const tern::Vec3 points[] = {{5, 0.2, 1.5}, {5, 0.3, 1.5}, {6, -1, 1}};
  recorder.mark_points(points, 2, map.mark_points(points, 2));
  recorder.scan(points, 3, eye, 0, map.begin_scan(points, 3, eye, 0));
  for (Status done = Status::kRunning; done == Status::kRunning;) {
    done = map.step(5000);
    recorder.step(5000, done);
  }
  const float ranges[] = {3.5f, INFINITY, NAN};
  const tern::Beams beams{points, ranges, 3, 0.1, 50.0};
  recorder.scan(beams, eye, 0, map.begin_scan(beams, eye, 0));
  for (Status done = Status::kRunning; done == Status::kRunning;) {
    done = map.step(5000);
    recorder.step(5000, done);
  }
  recorder.follow({0.1, 0, kEyeHeight}, map.follow({0.1, 0, kEyeHeight}));
  tern::Halfspace floor{{0, 0, -1}, -0.2};
  tern::Fence fence{};
  fence.planes = &floor;
  fence.count = 1;
  tern::FlightSpec flown = flight_spec_of(kSmallFlight);
  flown.fences = &fence;
  flown.fence_count = 1;
  flown.clearance = 5 * flown.tick;
  tern::Flight flight;
  const Status begun = flight.start(flown, map, planner, words.data(), words.size(), eye, 0);
  ASSERT_EQ(begun, Status::kOk);
  recorder.start(flown, eye, 0, begun);
  tern::FlightYaw yaw{};
  yaw.mode = tern::FlightYawMode::kAtPoints;
  yaw.acceleration_max = 4.0;
  yaw.start = {1, 0};
  const tern::Heading headings[] = {{0, 1}, {1, 1}};
  yaw.headings = headings;
  yaw.heading_count = 2;
  tern::Via mission[2];
  mission[0].position = {0.6, 0.3, kEyeHeight};
  mission[0].tolerance = 0.3;
  mission[1].position = {1.2, 0, kEyeHeight};
  recorder.set_mission(mission, 2, tern::ViaPolicy::kSkip, flight.set_mission(mission, 2, tern::ViaPolicy::kSkip));
  const Status turned = flight.set_yaw(yaw);
  ASSERT_EQ(turned, Status::kOk);
  recorder.set_yaw(yaw, turned);
  tern::FlightReport report{};
  tern::Trajectory proposed{};
  std::int64_t takeover = 0;
  for (int k = 0; k < 200; ++k) {
    const std::int64_t t = k * kSmallFlight.tick;
    const tern::Vec3 measured = flight.command(t).sample.position;
    recorder.note_position(measured, t, flight.note_position(measured, t));
    const tern::Track ball = ball_beside(k, t);
    if (k % 5 == 0) recorder.update_track(ball, flight.update_track(ball));
    if (k % 50 == 7) record_curve(recorder, flight, t);
    if (k == 120) recorder.forget_track(ball.id, flight.forget_track(ball.id));
    recorder.tick(flight, t, report, flight.tick(t, report));
    if (const std::uint32_t number = flight.proposal(proposed, takeover); number != 0) {
      recorder.answer(number, number % 3 != 0, flight.answer(number, number % 3 != 0));
    }
    if (k == 60) recorder.set_clearance(100000000, flight.set_clearance(100000000));
    if (k == 110) recorder.land({0.3, 0, 0.2}, 0.1, 0.5, flight.land({0.3, 0, 0.2}, 0.1, 0.5));
    if (k == 150) recorder.stop(flight.stop());
  }
  // The clock falls: what is refused is not recorded, and the flight goes on once it knows.
  for (int k = 0; k < 3; ++k) {
    const Status fallen = flight.tick(k, report);
    EXPECT_EQ(fallen, Status::kClockBehind);
    EXPECT_EQ(recorder.tick(flight, k, report, fallen), Status::kOk);
  }
  recorder.set_clock(-5000, flight.set_clock(-5000));
  for (int k = 0; k < 10; ++k) {
    const std::int64_t t = -5000 + k * kSmallFlight.tick;
    recorder.tick(flight, t, report, flight.tick(t, report));
  }
  EXPECT_GT(report.committed, 0u);
  std::size_t used = 0;
  ASSERT_EQ(recorder.close(&used), Status::kOk);
  const tern_host::FlightReplay replayed = tern_host::replay_flight(text(bytes, used));
  EXPECT_EQ(replayed.difference, "");
  EXPECT_EQ(replayed.ticks, 210);
  EXPECT_NEAR(replayed.seconds, 0.02 * (199 + 9), 1e-9);
}

TEST(FlightRecord, CRecordsLikeCpp) {
  std::vector<std::uint8_t> ours(4096), theirs(4096);
  FlightRecorder recorder;
  tern_flight_recorder c{};
  const tern_vec3 goal{1, 2, 3};
  EXPECT_EQ(tern_flight_record_set_goal(&c, &goal, 0), static_cast<std::uint8_t>(Status::kInvalidArgument));
  EXPECT_EQ(tern_flight_record_begin(&c, theirs.data(), theirs.size()), 0);
  EXPECT_EQ(recorder.begin(ours.data(), ours.size()), Status::kOk);
  EXPECT_EQ(tern_flight_record_set_goal(&c, &goal, 0), 0);
  EXPECT_EQ(tern_flight_record_set_goal(&c, nullptr, 0), static_cast<std::uint8_t>(Status::kInvalidArgument));
  recorder.set_goal(goal, Status::kOk);
  const tern_flight none{};
  const tern_flight_report report{};
  EXPECT_EQ(tern_flight_record_tick(&c, &none, 5, &report, 0), 0);
  recorder.tick(tern::Flight{}, 5, report, Status::kOk);
  EXPECT_EQ(tern_flight_record_pending(&c), recorder.pending());
  std::size_t used = 0, same = 0;
  EXPECT_EQ(tern_flight_record_close(&c, &used), 0);
  recorder.close(&same);
  EXPECT_EQ(used, same);
  EXPECT_EQ(text(theirs, used), text(ours, same));
  tern_flight_record_clear(&c);
  EXPECT_EQ(tern_flight_record_pending(&c), 0u);
}

}  // namespace
