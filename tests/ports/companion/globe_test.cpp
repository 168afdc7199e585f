// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Places on the globe in an autopilot's local frame: by hand, and beside vectors between points of the ellipsoid.
#include "companion/globe.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random.hpp"

namespace tern_companion {
namespace {

constexpr double kRadian = 3.14159265358979323846 / 180.0;

LocalFrame frame_at(double latitude, double longitude, Projection projection) {
  const auto whole = [](double degrees) { return static_cast<std::int32_t>(std::lround(1e7 * degrees)); };
  return {{whole(latitude), whole(longitude), 0, 0}, projection};
}

/// A point of the ellipsoid, earth-centred.
void earth_of(double latitude, double longitude, double (&p)[3]) {
  constexpr double kEquator = 6378137.0, kSquare = 6.69437999014e-3;
  const double sine = std::sin(kRadian * latitude), cosine = std::cos(kRadian * latitude);
  const double normal = kEquator / std::sqrt(1.0 - kSquare * sine * sine);
  p[0] = normal * cosine * std::cos(kRadian * longitude);
  p[1] = normal * cosine * std::sin(kRadian * longitude);
  p[2] = normal * (1.0 - kSquare) * sine;
}

/// From a to b, in the directions east and north at the origin.
tern::Vec3 true_vector(const LocalFrame& frame, const double (&a)[2], const double (&b)[2]) {
  const double latitude = 1e-7 * kRadian * frame.origin.latitude, longitude = 1e-7 * kRadian * frame.origin.longitude;
  double p[3], q[3];
  earth_of(a[0], a[1], p);
  earth_of(b[0], b[1], q);
  const double d[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  const double out = std::cos(longitude) * d[0] + std::sin(longitude) * d[1];
  return {-std::sin(longitude) * d[0] + std::cos(longitude) * d[1],
          -std::sin(latitude) * out + std::cos(latitude) * d[2], 0.0};
}

TEST(CompanionGlobe, IsTheAutopilotsOwn) {
  const LocalFrame px4 = frame_at(0.0, 0.0, Projection::kAzimuthal),
                   ardupilot = frame_at(60.0, 10.0, Projection::kFlat);
  EXPECT_NEAR(place_in(px4, 0.01, 0.0)->y, 1111.949266, 1e-6);  // 6371 km x 0.01 degrees
  EXPECT_NEAR(place_in(px4, 0.0, -0.01)->x, -1111.949266, 1e-6);
  EXPECT_EQ(place_in(px4, 0.0, 0.0)->x, 0.0);
  EXPECT_NEAR(place_in(ardupilot, 60.01, 10.0)->y, 1113.188450, 1e-6);
  EXPECT_NEAR(place_in(ardupilot, 60.0, 10.01)->x, 556.594225, 1e-6);  // cos 60 = 1/2
  // A parallel is no straight line: 9 km along it at 60 degrees bend north by 9^2 tan(60) / (2 x 6371) = 0.0110 km.
  const LocalFrame north = frame_at(60.0, 10.0, Projection::kAzimuthal);
  const double degrees = 9.0 / (6371.0 * 0.5 * kRadian);
  EXPECT_NEAR(place_in(north, 60.0, 10.0 + degrees)->y, 11.01, 0.02);
}

TEST(CompanionGlobe, GoesTheShorterWayRound) {
  for (const Projection projection : {Projection::kAzimuthal, Projection::kFlat}) {
    const LocalFrame frame = frame_at(0.0, 179.99, projection);
    EXPECT_NEAR(place_in(frame, 0.0, -179.99)->x, 2225.0, 3.0);
  }
}

TEST(CompanionGlobe, PlacesNothingFarAwayOrNearAPole) {
  for (const Projection projection : {Projection::kAzimuthal, Projection::kFlat}) {
    EXPECT_TRUE(place_in(frame_at(47.0, 8.0, projection), 47.089, 8.0).has_value());
    EXPECT_FALSE(place_in(frame_at(47.0, 8.0, projection), 47.091, 8.0).has_value());
    EXPECT_FALSE(place_in(frame_at(47.0, 8.0, projection), -47.0, -172.0).has_value());
    EXPECT_TRUE(place_in(frame_at(-80.0, 8.0, projection), -80.0, 8.0).has_value());
    EXPECT_FALSE(place_in(frame_at(80.1, 8.0, projection), 80.1, 8.0).has_value());
    EXPECT_FALSE(place_in(frame_at(47.0, 8.0, projection), 91.0, 8.0).has_value());
    EXPECT_FALSE(place_in(frame_at(47.0, 8.0, projection), 214.7483647, 214.7483647).has_value());
  }
}

/// Vectors between two places err by no more than kScaleError of their length, and by more than half of it somewhere.
TEST(CompanionGlobe, ErrsByLessThanItSays) {
  tern_test::Random random(11);
  double worst = 0.0;
  for (int k = 0; k < tern_test::scaled(20000); ++k) {
    const auto projection = random.chance(0.5) ? Projection::kAzimuthal : Projection::kFlat;
    const LocalFrame frame = frame_at(random.real(-80.0, 80.0), random.real(-180.0, 180.0), projection);
    // A vehicle within 8 km of the origin, and a thing within 1.5 km of it.
    const double from[2] = {random.real(0.0, 7900.0), random.real(0.0, 360.0) * kRadian};
    const double to[2] = {random.real(1.0, 1500.0), random.real(0.0, 360.0) * kRadian};
    const auto go = [](const double(&at)[2], double distance, double course, double(&out)[2]) {
      out[0] = at[0] + distance * std::cos(course) / 111200.0;
      out[1] = at[1] + distance * std::sin(course) / (111200.0 * std::cos(kRadian * at[0]));
    };
    double vehicle[2], thing[2];
    const double origin[2] = {1e-7 * frame.origin.latitude, 1e-7 * frame.origin.longitude};
    go(origin, from[0], from[1], vehicle);
    go(vehicle, to[0], to[1], thing);
    const auto a = place_in(frame, vehicle[0], vehicle[1]), b = place_in(frame, thing[0], thing[1]);
    ASSERT_TRUE(a && b);
    const tern::Vec3 is = true_vector(frame, vehicle, thing);
    const double length = std::hypot(is.x, is.y);
    worst = std::max(worst, std::hypot(b->x - a->x - is.x, b->y - a->y - is.y) / length);
  }
  EXPECT_LT(worst, kScaleError);
  EXPECT_GT(worst, 0.005);
}

}  // namespace
}  // namespace tern_companion
