// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights among things whose curves are known, as other vehicles' plans are, and where a flight keeps their pieces.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "flight/track_pieces.hpp"
#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;

constexpr double kBall = 0.3;

/// At a steady pace from the origin of the track.
TrackPiece straight_piece(const Vec3& from, const Vec3& to, double time) {
  TrackPiece piece{time, {}};
  for (int k = 0; k < kControlPoints; ++k) piece.points[k] = from + (k / 7.0) * (to - from);
  return piece;
}

/// A vehicle that flies along these pieces, and stays at their end.
Track vehicle(std::uint32_t id, const Vec3& position, const std::vector<TrackPiece>& pieces, std::int64_t begin) {
  Track track;
  track.id = id;
  track.measured = begin;
  track.position = position;
  track.radius = kBall;
  track.pieces = pieces.data();
  track.piece_count = static_cast<std::int32_t>(pieces.size());
  return track;
}

/// It comes towards the vehicle on its own line, waits aside for a second and a half, and goes on.
std::vector<TrackPiece> head_on() {
  return {straight_piece({}, {-6.0, 0.0, 0.0}, 2.0), straight_piece({-6.0, 0.0, 0.0}, {-6.0, 1.5, 0.0}, 1.0),
          straight_piece({-6.0, 1.5, 0.0}, {-6.0, 1.5, 0.0}, 1.5),
          straight_piece({-6.0, 1.5, 0.0}, {-12.0, 1.5, 0.0}, 3.0)};
}

/// Where it is after these seconds.
Vec3 place_of(const Vec3& begin, const std::vector<TrackPiece>& pieces, double time) {
  for (const TrackPiece& piece : pieces) {
    const double share = std::fmax(0.0, std::fmin(1.0, time / piece.duration));
    if (time < piece.duration) return begin + piece.points[0] + share * (piece.points[7] - piece.points[0]);
    time -= piece.duration;
  }
  return begin + pieces.back().points[7];
}

// The caller's pieces are spoilt right after the call: the flight has its own.
TEST(FlightCurves, AnotherVehiclesPlanIsKeptClearOf) {
  FlightRoom room;
  const Vec3 begin{10.125, 0.125, 1.125};
  const std::vector<TrackPiece> pieces = head_on();
  std::vector<TrackPiece> given = pieces;
  room.flight.set_goal({12.125, 0.125, 1.125});
  EXPECT_EQ(room.flight.update_track(vehicle(3, begin, given, 500000000)), Status::kOk);
  for (TrackPiece& piece : given) piece = TrackPiece{};
  int threats = 0;
  EXPECT_TRUE(room.tick_until(
      [&] {
        const double now = 1e-9 * static_cast<double>(room.time - 500000000);
        EXPECT_GE(distance(place_of(begin, pieces, now), room.position()), kBall + FlightRoom::kRadius - 1e-6) << now;
        threats += room.report.mode == FlightMode::kThreat ? 1 : 0;
        return room.report.reason == FlightReason::kArrived;
      },
      1500));
  EXPECT_EQ(threats, 0);
}

// A curve across the way that the flight learns of in flight is a threat; the next one, which ends before the way, is
// none.
TEST(FlightCurves, AnotherCurveIsNews) {
  FlightRoom room;
  room.flight.set_goal({12.125, 0.125, 1.125});
  EXPECT_TRUE(room.tick_until([&] { return room.speed() > 2.9; }, 400));
  const Vec3 begin = room.position() + Vec3{3.0, -2.0, 0.0};
  const std::vector<TrackPiece> across = {straight_piece({}, {0.0, 2.0, 0.0}, 0.9)};
  const std::vector<TrackPiece> aside = {straight_piece({}, {0.0, 0.5, 0.0}, 0.9)};
  EXPECT_EQ(room.flight.update_track(vehicle(3, begin, across, room.time)), Status::kOk);
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);
  EXPECT_EQ(room.flight.update_track(vehicle(3, begin, aside, room.time)), Status::kOk);
  room.tick();
  EXPECT_NE(room.report.mode, FlightMode::kThreat);
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
}

// The vehicle stays where its curve ends, at the goal: the flight goes as near as it may, and waits for it to leave.
TEST(FlightCurves, WhatRestsAtTheGoalIsWaitedFor) {
  FlightRoom room;
  const Vec3 goal{6.125, 0.125, 1.125};
  const std::vector<TrackPiece> still = {straight_piece({}, {}, 0.5)};
  const std::vector<TrackPiece> leaves = {straight_piece({}, {0.0, 4.0, 0.0}, 2.0)};
  EXPECT_EQ(room.flight.update_track(vehicle(9, goal, still, 0)), Status::kOk);
  room.flight.set_goal(goal);
  EXPECT_FALSE(room.tick_until([&] { return room.report.reason == FlightReason::kArrived; }, 800));
  EXPECT_EQ(room.speed(), 0.0);
  EXPECT_NEAR(distance(room.position(), goal), kBall + 3.0 * FlightRoom::kRadius, 1e-6);
  EXPECT_EQ(room.flight.update_track(vehicle(9, goal, leaves, room.time)), Status::kOk);
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
}

// A flight that gave up goes on once another vehicle has another curve.
TEST(FlightCurves, AnotherCurveEndsAFlightsRest) {
  FlightRoom room;
  room.flight.set_goal({6.125, 0.125, 1.125});
  room.state().park(FlightReason::kNoProgress);
  room.tick();
  EXPECT_EQ(room.report.reason, FlightReason::kNoProgress);
  const std::vector<TrackPiece> leaves = {straight_piece({}, {0.0, 4.0, 0.0}, 2.0)};
  EXPECT_EQ(room.flight.update_track(vehicle(9, {3.0, 2.0, 1.0}, leaves, room.time)), Status::kOk);
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
}

TEST(FlightCurves, RefusesWhatItHasNoRoomFor) {
  FlightRoom room;
  room.tick();
  const Vec3 far{0.0, 12.0, 0.0};
  const std::vector<TrackPiece> half(kMaxTrackPieces / 2, straight_piece({}, {}, 0.1));
  const std::vector<TrackPiece> rest(kMaxTrackPieces - kMaxTrackPieces / 2, straight_piece({}, {}, 0.1));
  const std::vector<TrackPiece> one(1, straight_piece({}, {}, 0.1));
  EXPECT_EQ(room.flight.update_track(vehicle(1, far, half, 0)), Status::kOk);
  EXPECT_EQ(room.flight.update_track(vehicle(2, far, rest, 0)), Status::kOk);
  EXPECT_EQ(room.flight.update_track(vehicle(3, far, one, 0)), Status::kTrackPiecesFull);
  EXPECT_EQ(room.flight.forget_track(1), Status::kOk);
  EXPECT_EQ(room.flight.update_track(vehicle(3, far, one, 0)), Status::kOk);
  Track bad = vehicle(4, far, one, 0);
  bad.pieces = nullptr;
  EXPECT_EQ(room.flight.update_track(bad), Status::kInvalidArgument);
}

/// A table with a thing for each of these runs of pieces.
std::unique_ptr<TrackTable> table_of(const TrackPieces& kept, const std::vector<std::pair<int, int>>& runs) {
  auto table = std::make_unique<TrackTable>();
  for (const auto& [first, count] : runs) {
    Track track;
    track.id = static_cast<std::uint32_t>(first);
    track.pieces = kept.pieces + first;
    track.piece_count = count;
    table->tracks[table->count++] = track;
  }
  return table;
}

TEST(TrackPieces, KeepsPiecesWhereNoTableHasAny) {
  const auto kept = std::make_unique<TrackPieces>();
  const std::vector<TrackPiece> three = {straight_piece({}, {1, 0, 0}, 1.0), straight_piece({}, {2, 0, 0}, 2.0),
                                         straight_piece({}, {3, 0, 0}, 3.0)};
  const auto first = table_of(*kept, {{0, 2}, {7, 1}});
  const auto second = table_of(*kept, {{0, 2}, {4, 2}, {11, kMaxFlightPieces - 13}});
  const TrackTable* const tables[] = {first.get(), second.get()};
  Track track = vehicle(1, {}, three, 0);
  ASSERT_TRUE(kept->keep(track, tables, 2));
  EXPECT_EQ(track.pieces, kept->pieces + 8);  // 2 and 3, and 6, are free, too, but no three in a row
  EXPECT_EQ(kept->pieces[10].points[7].x, 3.0);
  const auto third = table_of(*kept, {{8, 1}});
  const TrackTable* const all[] = {first.get(), second.get(), third.get()};
  Track other = vehicle(2, {}, three, 0);
  EXPECT_FALSE(kept->keep(other, all, 3));
  EXPECT_EQ(other.pieces, three.data());
  other.piece_count = 2;
  ASSERT_TRUE(kept->keep(other, all, 3));
  EXPECT_EQ(other.pieces, kept->pieces + 2);
}

}  // namespace
