// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The tracks of sightings: bounds by hand, and beside a slower way to the same ones.
#include "tern_onboard/sighting.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "support/random.hpp"

namespace {

using tern_onboard::largest_deviation;
using tern_onboard::Sighting;
using tern_onboard::track_of;

TEST(OnboardSighting, BoundsAreDeviationsTimesSigmasAndWhatNoDeviationCovers) {
  Sighting sighting;
  sighting.stamp = 7;
  sighting.position = {1.0, 2.0, 3.0};
  sighting.has_velocity = true;
  sighting.velocity = {0.0, 1.5, 0.0};
  sighting.deviation = 0.05;
  sighting.speed_deviation = 0.125;
  sighting.error = 0.25;
  sighting.speed_error = 0.25;
  sighting.height_error = 2.0;
  sighting.time_error = 0.5;
  const tern::Track track = track_of(sighting, 4.0);
  EXPECT_EQ(track.measured, 7);
  EXPECT_EQ(track.position.y, 2.0);
  EXPECT_EQ(track.velocity.y, 1.5);
  EXPECT_EQ(track.error_speed, 0.75);                   // 4 x 0.125 + 0.25
  EXPECT_NEAR(track.error, 0.2 + 0.25 + 1.125, 1e-15);  // and half a second at 1.5 + 0.75 m/s
  EXPECT_EQ(track.shape, tern::TrackShape::kCylinder);
  EXPECT_EQ(track.radius, 0.4);
  EXPECT_EQ(track.half.z, 3.0);  // a person, and the error of the height
  EXPECT_EQ(track.reach, 3.0);
  EXPECT_EQ(track.error_growth, 3.0);
}

TEST(OnboardSighting, WithoutAVelocityItMayGoAnywhereAsFastAsItsClass) {
  Sighting sighting;
  sighting.kind = tern::TrackClass::kBird;
  sighting.velocity = {5.0, 0.0, 0.0};  // not known to be one
  sighting.time_error = 0.5;
  const tern::Track track = track_of(sighting, 4.0);
  EXPECT_EQ(track.velocity.x, 0.0);
  EXPECT_EQ(track.error_speed, 23.0);
  EXPECT_EQ(track.error, 11.5);
  EXPECT_EQ(track.half.z, 0.7);  // of the ball
}

TEST(OnboardSighting, ItsOwnSizeAndSpeedCount) {
  Sighting sighting;
  sighting.radius = 0.25;
  sighting.half_height = 0.75;
  sighting.has_velocity = true;
  sighting.velocity = {3.0, 4.0, 0.0};
  const tern::Track track = track_of(sighting, 4.0);
  EXPECT_EQ(track.radius, 0.25);
  EXPECT_EQ(track.half.z, 0.75);
  EXPECT_EQ(track.reach, 5.0);
}

TEST(OnboardSighting, SizesThatJitterStay) {
  tern::Track before, now;
  before.radius = 0.5;
  before.half.z = 1.0;
  before.reach = 3.0;
  before.error_growth = 3.0;
  now.radius = 0.45;        // smaller: as it was
  now.half.z = 1.1;         // larger: taken
  now.reach = 1.5;          // smaller by half: taken
  now.error_growth = 2.99;  // as it was
  tern_onboard::keep_bounds(before, now);
  EXPECT_EQ(now.radius, 0.5);
  EXPECT_EQ(now.half.z, 1.1);
  EXPECT_EQ(now.reach, 1.5);
  EXPECT_EQ(now.error_growth, 3.0);
}

/// No direction has a larger deviation, and the bound is no larger than three axes explain.
TEST(OnboardSighting, NoDirectionHasALargerDeviation) {
  tern_test::Random random(20261129);
  for (int k = 0; k < tern_test::scaled(2000); ++k) {
    Eigen::Matrix3d half;
    for (int i = 0; i < 9; ++i) half(i / 3, i % 3) = random.real(-1.0, 1.0);
    const Eigen::Matrix3d matrix = half * half.transpose();
    double covariance[9];
    for (int i = 0; i < 9; ++i) covariance[i] = matrix(i / 3, i % 3);
    const double largest = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvalues()(2));
    EXPECT_GE(largest_deviation(covariance), largest * (1.0 - 1e-12));
    EXPECT_LE(largest_deviation(covariance), largest * std::sqrt(std::sqrt(3.0)) * (1.0 + 1e-12));
  }
  const double of_axes[9] = {0.04, 0.0, 0.0, 0.0, 0.25, 0.0, 0.0, 0.0, 0.01};
  EXPECT_EQ(largest_deviation(of_axes), 0.5);
}

TEST(OnboardSighting, NoCovarianceIsNoNumber) {
  double covariance[9] = {0.04, 0.0, 0.0, 0.0, -0.25, 0.0, 0.0, 0.0, 0.01};
  EXPECT_TRUE(std::isnan(largest_deviation(covariance)));
  covariance[4] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(largest_deviation(covariance)));
}

/// A thing of known deviations: its place is within the track's error as often as the page says for four of them.
TEST(OnboardSighting, FourDeviationsHoldMoreThan998Of1000) {
  tern_test::Random random(4);
  Sighting sighting;
  const double variances[9] = {0.04, 0.0, 0.0, 0.0, 0.04, 0.0, 0.0, 0.0, 0.04};
  sighting.deviation = largest_deviation(variances);
  const double error = track_of(sighting, 4.0).error;
  const int cases = tern_test::scaled(200000);
  const auto normal = [&] {
    const double u = random.real(1e-12, 1.0), turn = random.real(0.0, 6.283185307179586);
    return 0.2 * std::sqrt(-2.0 * std::log(u)) * std::cos(turn);
  };
  int outside = 0;
  for (int k = 0; k < cases; ++k) outside += std::hypot(normal(), normal(), normal()) > error ? 1 : 0;
  EXPECT_LT(outside, 0.002 * cases);
  EXPECT_GT(outside, 0.0003 * cases);  // 0.00113 is exact
}

}  // namespace
