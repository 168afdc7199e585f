// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights whose map gets no frames: when they say so, and what they do about it.
#include <gtest/gtest.h>

#include <vector>

#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Image;

FlightSpec spec_with(std::int64_t stale_after) {
  FlightSpec spec = FlightRoom::flight_spec();
  spec.stale_after = stale_after;
  return spec;
}

/// Frames that show nothing.
struct Blind : FlightRoom {
  explicit Blind(std::int64_t stale_after) : FlightRoom(spec_with(stale_after)), image(8, 8, 4.0) {}
  void enter_frame() {
    ASSERT_EQ(map().begin_frame(image.view, {start, {1.0, 0.0, 0.0, 0.0}}, time), Status::kRunning);
  }
  Image image;
};

TEST(FlightStale, AMapIsStaleAfterSoLongWithoutFrames) {
  Blind room(30000000);
  const bool stale[] = {false, false, false, false, true, true};
  for (int k = 0; k < 6; ++k) {
    room.tick();
    EXPECT_EQ(room.report.frame_age, 10000000 * k);
    EXPECT_EQ(room.report.map_stale, stale[k]) << k;
  }
  room.enter_frame();
  for (int k = 0; k < 6; ++k) {
    room.tick();
    EXPECT_EQ(room.report.frame_age, 10000000 * k);
    EXPECT_EQ(room.report.map_stale, stale[k]) << k;
  }
  EXPECT_EQ(room.map().frames(), 1u);
}

TEST(FlightStale, AMapThatNobodyFillsNeedNotBe) {
  Blind room(0);
  room.time = 3600000000000;
  room.tick();
  EXPECT_EQ(room.report.frame_age, 3600000000000);
  EXPECT_FALSE(room.report.map_stale);
}

TEST(FlightStale, TimesBelowZeroAreRefused) {
  FlightRoom room;
  const FlightSpec spec = spec_with(-1);
  EXPECT_EQ(room.flight.start(spec, room.map(), room.planner, room.words.data(), room.words.size(), room.start, 0),
            Status::kInvalidArgument);
}

/// All the ways at an end: with frames that is no progress, without them a stale map, and no point is left out for it.
/// The next frame makes the flight go on.
TEST(FlightStale, AFlightThatGivesUpWithoutFramesSaysSo) {
  for (const bool stale : {true, false}) {
    Blind room(stale ? 1000000000 : 0);
    const Via points[2] = {{{8.125, 0.125, 1.125}}, {{8.125, 4.0, 1.125}}};
    ASSERT_EQ(room.flight.set_mission(points, 2, ViaPolicy::kSkip), Status::kOk);
    FlightState& state = room.state();
    state.facts.time = 2000000000;
    state.block = {BlockedBy::kUnseen, {1.125, 0.125, 1.125}, kNoFence};
    for (int k = 0; k <= kIdleCycles; ++k) state.give_up();
    EXPECT_TRUE(state.search.is_looking);
    state.facts.time += 6720000000;  // four directions of 0.928 s, and 3 s
    state.give_up();
    EXPECT_EQ(state.facts.itinerary.parked, stale);
    EXPECT_EQ(state.facts.itinerary.leg, stale ? 0 : 1);
    EXPECT_EQ(room.flight.point_state(0), stale ? PointState::kAhead : PointState::kSkipped);
    if (!stale) continue;
    EXPECT_EQ(state.facts.itinerary.reason, FlightReason::kMapStale);
    room.time = state.facts.time;
    room.tick();
    EXPECT_EQ(room.report.reason, FlightReason::kMapStale);
    EXPECT_EQ(room.report.mode, FlightMode::kRest);
    room.enter_frame();
    room.tick();
    EXPECT_EQ(room.report.reason, FlightReason::kNone);
    EXPECT_FALSE(state.facts.itinerary.parked);
  }
}

}  // namespace
