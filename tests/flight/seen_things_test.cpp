// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the camera sees appear where all was free: something that moves and has a track, something that moves and has
// none, and a wall that stays.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "support/flight_room.hpp"
#include "support/grid_storage.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Image;

constexpr double kBall = 0.3;

/// What the map and the flight made of what appeared.
struct Appearance {
  int threats = 0;        ///< ticks
  double begin = -1.0;    ///< s: the first of them
  double end = -1.0;      ///< s: the last of them
  int most_blocked = 0;   ///< voxels of the route grid
  int blocked_after = 0;  ///< the same at the end
  int brakes = 0;         ///< ticks with a plan that evades
  bool arrived = false;
};

/// The least depth that a pixel of a camera at `eye`, which looks along x, has of a ball.
float depth_of(const Vec3& eye, double right, double down, const Vec3& centre) {
  const Vec3 ray = (1.0 / std::sqrt(1.0 + right * right + down * down)) * Vec3{1.0, -right, -down};
  const Vec3 way = centre - eye;
  const double along = dot(way, ray);
  const double square = kBall * kBall - (dot(way, way) - along * along);
  return square > 0.0 && along > 0.0 ? static_cast<float>((along - std::sqrt(square)) * ray.x) : 0.0f;
}

void render(Image& image, const Vec3& eye, const Vec3& centre) {
  for (int v = 0; v < image.view.height; ++v) {
    for (int u = 0; u < image.view.width; ++u) {
      image.at(u, v) = depth_of(eye, (u - image.view.cx) / image.view.fx, (v - image.view.cy) / image.view.fy, centre);
    }
  }
}

/// A flight of 12 m along x with a camera of 20 Hz. `see` gets the image's number and renders it.
template <typename See>
Appearance fly(FlightRoom& room, See see, int ticks) {
  Image image(64, 48, 32.0);
  image.view.no_return = 20.0;
  room.flight.set_goal({12.125, 0.125, 1.125});
  Appearance found;
  for (int k = 0; k < ticks && !found.arrived; ++k) {
    const Vec3 eye = room.position();
    if (k % 5 == 0 && !room.map().busy()) {
      see(image, eye);
      EXPECT_EQ(room.map().begin_frame(image.view, {eye, {0.5, -0.5, 0.5, -0.5}}, room.time), Status::kRunning);
    }
    room.tick();
    const bool is_threat = room.report.mode == FlightMode::kThreat;
    found.threats += is_threat ? 1 : 0;
    found.brakes += room.state().facts.plans.latest().evades ? 1 : 0;
    if (is_threat) found.end = 1e-9 * static_cast<double>(room.time);
    if (is_threat && found.begin < 0.0) found.begin = found.end;
    found.blocked_after = tern_test::count_obstacles(room.map().route());
    found.most_blocked = std::max(found.most_blocked, found.blocked_after);
    found.arrived = room.report.reason == FlightReason::kArrived;
  }
  return found;
}

/// A ball crosses the way ahead of the vehicle.
Appearance cross(bool has_track) {
  FlightRoom room;
  const Vec3 velocity{0.0, 1.0, 0.0};
  const auto ball = [&] { return Vec3{7.0, -2.5, 1.1} + (1e-9 * static_cast<double>(room.time)) * velocity; };
  const auto see = [&](Image& image, const Vec3& eye) {
    Track track;
    track.measured = room.time;
    track.position = ball();
    track.velocity = velocity;
    track.radius = kBall;
    track.error = 0.03;
    track.error_speed = 0.1;
    track.error_growth = 0.5;
    if (has_track) {
      EXPECT_EQ(room.flight.update_track(track), Status::kOk);
    }
    render(image, eye, ball());
    EXPECT_GE(distance(ball(), eye), kBall + FlightRoom::kRadius - 1e-6);
  };
  return fly(room, see, 1500);
}

TEST(FlightSeenThings, WhatATrackExplainsRaisesNoAlarm) {
  const Appearance with = cross(true);
  EXPECT_TRUE(with.arrived);
  EXPECT_EQ(with.most_blocked, 0);
  EXPECT_EQ(with.threats, 0);
  EXPECT_EQ(with.brakes, 0);
}

/// The ball is 1.6 m wide with the radius around it, and 1 m/s fast.
TEST(FlightSeenThings, WhatMovesOnStopsTheVehicleAndTheAlarmEnds) {
  const Appearance without = cross(false);
  EXPECT_GT(without.most_blocked, 0);
  EXPECT_GT(without.threats, 0);
  EXPECT_GT(without.brakes, 0);
  EXPECT_LT(without.end, without.begin + 2.0);
  EXPECT_TRUE(without.arrived);
}

/// A wall closes the way 6 m ahead, in the images from 1 s on: the hit that makes it an obstacle raises the alarm.
TEST(FlightSeenThings, AWallThatStaysRaisesTheAlarmAfterAsManyFramesAsItTakesHits) {
  for (const int hits : {1, 3}) {
    MapSpec spec = FlightRoom::map_spec();
    spec.hits = hits;
    FlightRoom room(FlightRoom::flight_spec(), {}, spec);
    const double face = 7.0;
    const auto see = [&](Image& image, const Vec3& eye) {
      const bool is_there = room.time >= 1000000000;
      for (int i = 0; i < image.view.width * image.view.height; ++i) {
        image.at(i % image.view.width, i / image.view.width) = is_there ? static_cast<float>(face - eye.x) : 0.0f;
      }
    };
    const Appearance wall = fly(room, see, 400);
    EXPECT_GT(wall.begin, 1.0 + 0.05 * (hits - 1));
    EXPECT_LE(wall.begin, 1.0 + 0.05 * hits);
    EXPECT_GT(wall.blocked_after, 0);
    EXPECT_FALSE(wall.arrived);
    EXPECT_LE(room.position().x, face - FlightRoom::kRadius);
  }
}

}  // namespace
