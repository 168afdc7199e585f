// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The local frame beside formulas of its own: WGS84 in earth-centred coordinates, in long double.
#include "host/airspace/local_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "support/random.hpp"

namespace {

using tern_host::GeoPoint;
using tern_host::GeoPosition;
using tern_host::LocalFrame;
using tern_host::Plan2;
using tern_test::Random;

constexpr long double kDegree = 3.14159265358979323846264338327950288L / 180.0L;
constexpr long double kMajor = 6378137.0L;
constexpr long double kFlattening = 1.0L / 298.257223563L;
constexpr long double kSquare = kFlattening * (2.0L - kFlattening);  // of the eccentricity

struct Centred {
  long double x, y, z;
};

long double normal_radius(long double latitude) {
  const long double s = std::sin(latitude);
  return kMajor / std::sqrt(1.0L - kSquare * s * s);
}

Centred centred(const GeoPosition& p) {
  const long double latitude = p.point.latitude * kDegree, longitude = p.point.longitude * kDegree;
  const long double n = normal_radius(latitude);
  return {(n + p.height) * std::cos(latitude) * std::cos(longitude),
          (n + p.height) * std::cos(latitude) * std::sin(longitude),
          (n * (1.0L - kSquare) + p.height) * std::sin(latitude)};
}

long double chord(const GeoPosition& a, const GeoPosition& b) {
  const Centred p = centred(a), q = centred(b);
  return std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z));
}

/// The length along the ellipsoid of a chord of some kilometres: an arc with Euler's radius in the chord's direction.
/// Off by less than 0.02 mm for 20 km, since the arc is but 8 mm longer than the chord.
long double arc(const GeoPoint& a, const GeoPoint& b) {
  const long double s = chord({a, 0.0}, {b, 0.0});
  const long double latitude = 0.5L * (a.latitude + b.latitude) * kDegree;
  const long double n = normal_radius(latitude);
  const long double m = n * n * n * (1.0L - kSquare) / (kMajor * kMajor);
  const long double north = (b.latitude - a.latitude) * m, east = (b.longitude - a.longitude) * n * std::cos(latitude);
  const long double part = north * north + east * east > 0.0L ? north * north / (north * north + east * east) : 0.0L;
  const long double radius = 1.0L / (part / m + (1.0L - part) / n);
  return s + s * s * s / (24.0L * radius * radius);
}

GeoPosition random_origin(Random& random) {
  return {{random.real(-80.0, 80.0), random.real(-180.0, 180.0)}, random.real(-100.0, 4000.0)};
}

Plan2 random_within(Random& random, double radius) {
  const double length = radius * std::sqrt(random.unit()), angle = random.real(0.0, 6.283185307179586);
  return {length * std::cos(angle), length * std::sin(angle)};
}

TEST(LocalFrame, KnowsItsAxes) {
  const LocalFrame frame({{47.0, 8.0}, 400.0});
  const tern::Vec3 origin = frame.local({{47.0, 8.0}, 400.0});
  EXPECT_NEAR(origin.x, 0.0, 1e-9);
  EXPECT_NEAR(origin.y, 0.0, 1e-9);
  EXPECT_EQ(origin.z, 0.0);
  // A degree of the meridian about 47 degrees is 111.17 km, one of its parallel 76.06 km.
  const tern::Vec3 north = frame.local({{47.01, 8.0}, 390.0});
  EXPECT_NEAR(north.x, 0.0, 1e-9);
  EXPECT_NEAR(north.y, 1111.7, 0.1);
  EXPECT_EQ(north.z, -10.0);
  const tern::Vec3 east = frame.local({{47.0, 8.01}, 520.0});
  EXPECT_NEAR(east.x, 760.6, 0.1);
  EXPECT_GT(east.y, 0.0);
  EXPECT_LT(east.y, 0.1);
  EXPECT_EQ(east.z, 120.0);
}

TEST(LocalFrame, DistancesFromTheOriginAreExact) {
  Random random(1);
  for (int i = 0; i < tern_test::scaled(2000); ++i) {
    const GeoPosition origin = random_origin(random);
    const LocalFrame frame(origin);
    const Plan2 plan = random_within(random, 10000.0);
    GeoPoint there = frame.point(plan);
    if (there.longitude - origin.point.longitude > 180.0) there.longitude -= 360.0;
    if (there.longitude - origin.point.longitude < -180.0) there.longitude += 360.0;
    EXPECT_NEAR(std::hypot(plan.east, plan.north), static_cast<double>(arc(origin.point, there)), 2e-5);
  }
}

TEST(LocalFrame, LengthsAreWithinTheStatedError) {
  Random random(2);
  double largest = 0.0;
  for (int i = 0; i < tern_test::scaled(5000); ++i) {
    const LocalFrame frame(random_origin(random));
    const double radius = i % 2 == 0 ? 10000.0 : random.real(100.0, tern_host::largest_radius());
    const Plan2 a = random_within(random, radius);
    const Plan2 b = i % 4 == 0 ? Plan2{-a.east, -a.north} : random_within(random, radius);
    GeoPoint from = frame.point(a), to = frame.point(b);
    if (to.longitude - from.longitude > 180.0) to.longitude -= 360.0;
    if (to.longitude - from.longitude < -180.0) to.longitude += 360.0;
    const double error = std::hypot(a.east - b.east, a.north - b.north) - static_cast<double>(arc(from, to));
    EXPECT_LE(std::fabs(error), tern_host::length_error(radius) + 3e-5) << "radius " << radius;
    largest = std::max(largest, std::fabs(error) / tern_host::length_error(radius));
  }
  EXPECT_LE(tern_host::length_error(10000.0), 0.01);
  EXPECT_LE(tern_host::length_error(tern_host::largest_radius()), tern_host::kMostLengthError);
  // The bound is no more than needed by much.
  EXPECT_GT(largest, 0.2);
}

TEST(LocalFrame, UprightLinesAreLongerByTheHeight) {
  const LocalFrame frame({{10.0, 20.0}, 0.0});
  const GeoPosition a = frame.position({-500.0, 0.0, 1000.0}), b = frame.position({500.0, 0.0, 1000.0});
  const double longer = static_cast<double>(chord(a, b)) / 1000.0 - 1.0;
  EXPECT_NEAR(longer, 1000.0 / 6378137.0, 1e-7);
  EXPECT_LE(longer, tern_host::height_scale(1000.0));
}

TEST(LocalFrame, GoesThereAndBack) {
  Random random(3);
  for (int i = 0; i < tern_test::scaled(2000); ++i) {
    const LocalFrame frame(random_origin(random));
    const tern::Vec3 local{random.real(-1e4, 1e4), random.real(-1e4, 1e4), random.real(-500.0, 500.0)};
    const tern::Vec3 back = frame.local(frame.position(local));
    EXPECT_NEAR(back.x, local.x, 2e-8);
    EXPECT_NEAR(back.y, local.y, 2e-8);
    EXPECT_NEAR(back.z, local.z, 1e-9);
  }
}

TEST(LocalFrame, CrossesTheAntimeridian) {
  const LocalFrame frame({{-17.0, 179.999}, 0.0});
  EXPECT_NEAR(frame.plan({-17.0, -179.999}).east, 0.002 * 106475.0, 0.5);
  EXPECT_NEAR(frame.plan({-17.0, 180.001}).east, 0.002 * 106475.0, 0.5);
}

TEST(LocalFrame, RefusesOrigins) {
  EXPECT_THROW(LocalFrame({{80.1, 0.0}, 0.0}), std::invalid_argument);
  EXPECT_THROW(LocalFrame({{std::nan(""), 0.0}, 0.0}), std::invalid_argument);
  EXPECT_THROW(LocalFrame({{0.0, 0.0}, INFINITY}), std::invalid_argument);
}

}  // namespace
