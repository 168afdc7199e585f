// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move and that the camera sees: with a track, they are no obstacles; without one, they are.
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

/// What the map and the flight made of a ball that crosses the way ahead of the vehicle.
struct Crossing {
  int threats = 0;       ///< ticks
  int most_blocked = 0;  ///< voxels of the route grid
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

Crossing cross(bool has_track) {
  FlightRoom room;
  Image image(64, 48, 32.0);
  image.view.no_return = 20.0;
  room.flight.set_goal({12.125, 0.125, 1.125});
  Vec3 centre{7.0, -2.5, 1.1};
  const Vec3 velocity{0.0, 1.0, 0.0};
  Crossing crossing;
  for (int k = 0; k < 1500 && !crossing.arrived; ++k) {
    if (k % 5 == 0 && !room.map().busy()) {
      Track track;
      track.measured = room.time;
      track.position = centre;
      track.velocity = velocity;
      track.radius = kBall;
      track.error = 0.03;
      track.error_speed = 0.1;
      track.error_growth = 0.5;
      if (has_track) {
        EXPECT_EQ(room.flight.update_track(track), Status::kOk);
      }
      const Vec3 eye = room.position();
      render(image, eye, centre);
      EXPECT_EQ(room.map().begin_frame(image.view, {eye, {0.5, -0.5, 0.5, -0.5}}, room.time), Status::kRunning);
    }
    room.tick();
    centre = centre + (1e-9 * static_cast<double>(room.spec.tick)) * velocity;
    crossing.threats += room.report.mode == FlightMode::kThreat ? 1 : 0;
    if (k % 20 == 0)
      crossing.most_blocked = std::max(crossing.most_blocked, tern_test::count_obstacles(room.map().route()));
    EXPECT_GE(distance(centre, room.position()), kBall + FlightRoom::kRadius - 1e-6);
    crossing.arrived = room.report.reason == FlightReason::kArrived;
  }
  return crossing;
}

TEST(FlightSeenThings, AreNoObstaclesIfTheyHaveATrack) {
  const Crossing with = cross(true);
  EXPECT_TRUE(with.arrived);
  EXPECT_EQ(with.most_blocked, 0);
  EXPECT_EQ(with.threats, 0);
  const Crossing without = cross(false);
  EXPECT_GT(without.most_blocked, 0);
  EXPECT_GT(without.threats, 0);
}

}  // namespace
