// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proofs against tracks whose answers can be worked out by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "prove/track_answers.hpp"
#include "support/timed_proof.hpp"
#include "tern/track_proof.hpp"

namespace {

using namespace tern;
using tern_test::along_x;
using tern_test::ball_at;
using tern_test::kEarly;
using tern_test::kSecond;
using tern_test::prove;
using tern_test::TimedAnswer;

void expect_met(const TimedAnswer& answer, double when, std::int32_t track = 0) {
  EXPECT_EQ(answer.report.finding, Finding::kTrack);
  EXPECT_EQ(answer.report.track, track);
  EXPECT_LE(answer.until, when + 1e-8);
  EXPECT_GE(answer.until, when - kEarly);
}

void expect_clear(const TimedAnswer& answer, double until) {
  EXPECT_EQ(answer.report.finding, Finding::kNone);
  EXPECT_EQ(answer.report.track, kNoTrack);
  EXPECT_DOUBLE_EQ(answer.until, until);
}

TEST(TrackProof, NothingToKeepClearOf) {
  expect_clear(prove(along_x(), {}), 2.0);
}

TEST(TrackProof, StandingBall) {
  Track ball = ball_at({3.0, 0.0, 0.0}, 0.5);
  ball.error = 0.25;
  expect_met(prove(along_x(), {ball}), (3.0 - 1.25) / 2.0);
  ball.position.y = 1.26;
  expect_clear(prove(along_x(), {ball}), 2.0);
  ball.position.y = 1.24;
  expect_met(prove(along_x(), {ball}), (3.0 - std::sqrt(1.25 * 1.25 - 1.24 * 1.24)) / 2.0);
}

TEST(TrackProof, HeadOnAndOvertaken) {
  Track ball = ball_at({3.0, 0.0, 0.0}, 0.5);
  ball.velocity = {-1.0, 0.0, 0.0};
  expect_met(prove(along_x(), {ball}), 2.0 / 3.0);
  ball.position = {-3.0, 0.0, 0.0};
  ball.velocity = {4.0, 0.0, 0.0};
  expect_met(prove(along_x(), {ball}), 1.0);
  ball.velocity = {2.0, 0.0, 0.0};
  expect_clear(prove(along_x(), {ball}), 2.0);
}

/// The same after thirty years, and ten thousand kilometres away: not a digit is lost.
TEST(TrackProof, OldTracksFarAway) {
  Track ball = ball_at({1e7 + 3.0 + 1e9, 0.0, 0.0}, 0.5);
  ball.velocity = {-1.0, 0.0, 0.0};
  ball.measured = 5;
  const Trajectory plan = along_x({1e7, 0.0, 0.0}, 1000000000 * kSecond + 5);
  const TimedAnswer answer = prove(plan, {ball});
  expect_met(answer, 2.0 / 3.0);
  const Track near = ball_at({1e7 + 2.0, 1.0 - 3e-9, 0.0}, 0.5);
  const Track nearer = ball_at({1e7 + 2.0, 1.0 - 1e-8, 0.0}, 0.5);
  EXPECT_EQ(near.position.y, 1.0 - 3e-9);
  expect_clear(prove(plan, {near}), 2.0);
  EXPECT_EQ(prove(plan, {nearer}).report.finding, Finding::kTrack);
}

TEST(TrackProof, ErrorGrows) {
  Track ball = ball_at({3.0, 0.0, 0.0}, 0.5);
  ball.error_growth = 0.5;
  ball.measured = -kSecond;
  // 3 - 2 t = 1 + (t + 1)^2 / 4
  expect_met(prove(along_x(), {ball}), -5.0 + std::sqrt(32.0));
  ball.error_growth = 0.0;
  ball.error_speed = 0.5;
  expect_met(prove(along_x(), {ball}), 0.6);
}

TEST(TrackProof, CylinderAndBox) {
  Track post = ball_at({3.0, 0.3, 0.7}, 0.5);
  post.shape = TrackShape::kCylinder;
  post.half = {0.0, 0.0, 1.0};
  expect_met(prove(along_x(), {post}), (3.0 - std::sqrt(1.0 - 0.09)) / 2.0);
  post.position = {2.0, 0.0, 1.51};
  expect_clear(prove(along_x(), {post}), 2.0);
  post.position = {2.0, 0.0, 1.49};
  expect_met(prove(along_x(), {post}), (1.5 - std::sqrt(0.25 - 0.49 * 0.49)) / 2.0);
  Track box = ball_at({3.0, 0.0, 0.0}, 0.0);
  box.shape = TrackShape::kBox;
  box.half = {0.25, 1.0, 1.0};
  expect_met(prove(along_x(), {box}), (3.0 - 0.75) / 2.0);
  box.position = {2.0, 1.3, 1.4};
  expect_met(prove(along_x(), {box}, 0.6), (1.75 - std::sqrt(0.36 - 0.09 - 0.16)) / 2.0);
  box.position = {2.0, 1.31, 1.4};
  expect_clear(prove(along_x(), {box}, 0.5), 2.0);
}

TEST(TrackProof, BeforeItWasMeasuredThereIsNoThing) {
  Track ball = ball_at({2.0, 0.0, 0.0}, 0.5);
  ball.measured = 5 * kSecond / 4;
  expect_met(prove(along_x(), {ball}), 1.25);
  ball.measured = 2 * kSecond - 1;
  expect_clear(prove(along_x(), {ball}), 2.0);
}

TEST(TrackProof, WhatFollows) {
  Track ball = ball_at({-2.0, 0.0, 0.0}, 0.5);
  ball.velocity = {4.0, 0.0, 0.0};
  ball.until = kSecond / 4;
  expect_met(prove(along_x(), {ball}), 0.5);
  ball.end = TrackEnd::kGone;
  expect_clear(prove(along_x(), {ball}), 2.0);
  ball.end = TrackEnd::kStays;
  expect_clear(prove(along_x(), {ball}), 2.0);
  ball.end = TrackEnd::kReach;
  ball.reach = 3.0;
  // It stays at x = -1 with an error of 3 (t - 1/4), and within 3 t of x = -2: the plan meets the latter last.
  expect_met(prove(along_x(), {ball}), 1.0);
  // At x = -1.75 it is the other way round.
  ball.velocity = {1.0, 0.0, 0.0};
  expect_met(prove(along_x(), {ball}), 1.5);
}

/// What is clear of one of two tubes is clear of the thing.
TEST(TrackProof, ReachBall) {
  Track ball = ball_at({2.0, 1.5, 0.0}, 0.5);
  ball.error_growth = 8.0;
  EXPECT_EQ(prove(along_x(), {ball}).report.finding, Finding::kTrack);
  ball.reach = 0.1;
  expect_clear(prove(along_x(), {ball}), 2.0);
  ball.reach = 0.9;
  // Until both tubes have grown to the plan: 1.5^2 + (2 - 2 t)^2 = (1 + 0.9 t)^2, long after the error's.
  const double root = (9.8 - std::sqrt(9.8 * 9.8 - 4.0 * 3.19 * 5.25)) / (2.0 * 3.19);
  expect_met(prove(along_x(), {ball}), root);
}

TEST(TrackProof, AnotherVehiclesPlan) {
  Trajectory other = along_x({4.0, 0.0, 0.0}, kSecond);
  for (Vec3& point : other.segments[0].points) point.x = -point.x;
  TrackPiece pieces[2];
  Track track;
  ASSERT_EQ(track_of(other, 0.5, pieces, 2, track), Status::kOk);
  EXPECT_EQ(track.piece_count, 1);
  EXPECT_EQ(track.measured, kSecond);
  // 4 - 2 (t - 1) - 2 t = 1
  expect_met(prove(along_x(), {track}), 1.25);
  // It stays at its end, the origin.
  expect_met(prove(along_x({-4.5, 0.0, 0.0}, 4 * kSecond), {track}), 1.75);
  expect_clear(prove(along_x({1.0, 0.0, 0.0}, 4 * kSecond), {track}), 2.0);
  EXPECT_EQ(track_of(other, 0.5, pieces, 0, track), Status::kTrackPiecesFull);
  EXPECT_EQ(track_of(other, 0.5, nullptr, 2, track), Status::kInvalidArgument);
  other.count = 0;
  EXPECT_EQ(track_of(other, 0.5, pieces, 2, track), Status::kInvalidArgument);
}

TEST(TrackProof, RestAtTheEnd) {
  Track ball = ball_at({4.0, 5.0, 0.0}, 0.5);
  ball.velocity = {0.0, -1.0, 0.0};
  expect_clear(prove(along_x(), {ball}), 2.0);
  expect_clear(prove(along_x(), {ball}, 0.5, 1.75), 3.75);
  const TimedAnswer answer = prove(along_x(), {ball}, 0.5, 10.0);
  expect_met(answer, 4.0);
  EXPECT_EQ(answer.report.segment, 0);
}

TEST(TrackProof, TheEarliestCounts) {
  const std::vector<Track> tracks{ball_at({3.5, 0.0, 0.0}, 0.5), ball_at({2.5, 0.0, 0.0}, 0.5),
                                  ball_at({3.0, 0.0, 0.0}, 0.5)};
  expect_met(prove(along_x(), tracks), 0.75, 1);
  expect_met(prove(along_x(), tracks, 0.5, 0.0, false, 0.5), 0.75, 1);
  const TimedAnswer inside = prove(along_x(), tracks, 0.5, 0.0, false, 1.0);
  EXPECT_EQ(inside.until, 1.0);
  EXPECT_EQ(inside.report.track, 1);
  EXPECT_NEAR(inside.report.excess, 0.5, 1e-6);
}

TEST(TrackProof, LeavesWhatItBeginsTooNearTo) {
  // Today's gap is 0.7 of 1: the plan leads away at 2 m/s.
  const Track behind = ball_at({-0.7, 0.0, 0.0}, 0.5);
  const TimedAnswer refused = prove(along_x(), {behind});
  EXPECT_EQ(refused.until, 0.0);
  EXPECT_EQ(refused.report.finding, Finding::kTrack);
  EXPECT_NEAR(refused.report.excess, 0.3, 1e-6);
  expect_clear(prove(along_x(), {behind}, 0.5, 0.0, true), 2.0);
  // Towards it, the gap must not shrink.
  expect_met(prove(along_x(), {ball_at({0.7, 0.0, 0.0}, 0.5)}, 0.5, 0.0, true), 0.0);
  // A thing as fast as the plan stays as near: the gap has to grow after a second.
  Track beside = ball_at({0.0, 0.7, 0.0}, 0.5);
  beside.velocity = {2.0, 0.0, 0.0};
  expect_met(prove(along_x(), {beside}, 0.5, 0.0, true), kLeaveTime);
  beside.velocity = {2.0, 0.3, 0.0};
  expect_clear(prove(along_x(), {beside}, 0.5, 0.0, true), 2.0);
  // Inside the thing itself, there is no way out.
  expect_met(prove(along_x(), {ball_at({-0.4, 0.0, 0.0}, 0.5)}, 0.5, 0.0, true), 0.0);
}

TEST(TrackProof, SlicesDoNotMatter) {
  Track ball = ball_at({3.0, 0.7, 0.0}, 0.5);
  ball.error_growth = 0.3;
  const std::vector<Track> tracks{ball, ball_at({2.5, 1.01, 0.0}, 0.5)};
  const Trajectory plan = along_x();
  TrackGrounds grounds;
  grounds.tracks = tracks.data();
  grounds.count = 2;
  grounds.radius = 0.5;
  ProofReport whole;
  clear_until(plan, 0.0, grounds, &whole);
  TrackProof proof;
  ASSERT_EQ(proof.begin(plan, 0.0, grounds), Status::kRunning);
  Work work;
  int slices = 0;
  do {
    work.add(1);
    ++slices;
  } while (proof.step(work) == Status::kRunning);
  EXPECT_GT(slices, 3);
  EXPECT_EQ(proof.report().until, whole.until);
  EXPECT_EQ(proof.report().track, whole.track);
  EXPECT_EQ(proof.report().work, whole.work);
}

}  // namespace
