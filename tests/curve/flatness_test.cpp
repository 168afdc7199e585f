// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flat outputs against hand-computed attitudes, against differences over time, and at their singularities.
#include "tern/flatness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/math.hpp"
#include "support/numbers.hpp"
#include "support/random.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::expect_near;
using tern_test::kNan;

constexpr Yaw kNorth{1.0, 0.0, 0.0};

Vec3 column(const FlatState& state, int i) {
  return {state.attitude[0][i], state.attitude[1][i], state.attitude[2][i]};
}

/// Axes orthonormal and right-handed; the quaternion is unit and turns each axis to the same place.
void expect_rotation(const FlatState& state) {
  const double* const q = state.quaternion;
  EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1.0, 1e-12);
  EXPECT_GE(q[0], 0.0);
  const double expected[3][3] = {
      {1 - 2 * (q[2] * q[2] + q[3] * q[3]), 2 * (q[1] * q[2] - q[0] * q[3]), 2 * (q[1] * q[3] + q[0] * q[2])},
      {2 * (q[1] * q[2] + q[0] * q[3]), 1 - 2 * (q[1] * q[1] + q[3] * q[3]), 2 * (q[2] * q[3] - q[0] * q[1])},
      {2 * (q[1] * q[3] - q[0] * q[2]), 2 * (q[2] * q[3] + q[0] * q[1]), 1 - 2 * (q[1] * q[1] + q[2] * q[2])}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(state.attitude[i][j], expected[i][j], 1e-12);
      EXPECT_NEAR(dot(column(state, i), column(state, j)), i == j ? 1.0 : 0.0, 1e-12);
    }
  }
}

TEST(FlatState, HoverIsLevelAndCarriesGravity) {
  const FlatState state = flat_state(Sample{}, {0.0, 2.0, 0.5});  // facing along y, turning
  EXPECT_DOUBLE_EQ(state.thrust, kGravity);
  expect_near(column(state, 0), {0, 1, 0}, 1e-15);
  expect_near(column(state, 2), {0, 0, 1}, 1e-15);
  expect_near(state.body_rates, {0, 0, 0.5}, 1e-15);
  EXPECT_NEAR(state.quaternion[0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(state.quaternion[3], std::sqrt(0.5), 1e-15);
  expect_rotation(state);
}

TEST(FlatState, AcceleratingForwardPitchesDown) {
  Sample sample{};
  sample.acceleration = {kGravity, 0, 0};  // 45 degrees
  sample.jerk = {0, 3.0, 0};               // rolls to the left: a negative rate about x
  const FlatState state = flat_state(sample, kNorth);
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(state.thrust, kGravity / half, 1e-12);
  expect_near(column(state, 0), {half, 0, -half}, 1e-15);
  expect_near(column(state, 1), {0, 1, 0}, 1e-15);
  EXPECT_NEAR(state.body_rates.x, -3.0 * half / kGravity, 1e-12);
  EXPECT_NEAR(state.body_rates.y, 0.0, 1e-12);
  EXPECT_NEAR(state.quaternion[2], std::sin(0.125 * 3.14159265358979323846), 1e-12);
  expect_rotation(state);
}

TEST(FlatState, RatesAreTheAttitudesDerivative) {
  tern_test::Random random(1);
  const double h = 1e-5;
  for (int n = 0; n < tern_test::scaled(500); ++n) {
    const auto draw = [&](double most) {
      return Vec3{random.real(-most, most), random.real(-most, most), random.real(-most, most)};
    };
    const Vec3 a = draw(8.0);
    const Vec3 j = draw(20.0);
    const double angle = random.real(-3.0, 3.0);
    const double rate = random.real(-2.0, 2.0);
    const auto at = [&](double t) {
      Sample sample{};
      sample.acceleration = a + t * j;
      sample.jerk = j;
      return flat_state(sample, {std::cos(angle + rate * t), std::sin(angle + rate * t), rate});
    };
    const FlatState state = at(0.0);
    ASSERT_EQ(state.singularity, Singularity::kNone);
    expect_rotation(state);
    const FlatState before = at(-h);
    const FlatState after = at(h);
    const auto change = [&](int i) { return (0.5 / h) * (column(after, i) - column(before, i)); };
    // R' = R [w]: the derivative of y along z is the rate about x, and so on.
    const Vec3 expected{dot(change(1), column(state, 2)), dot(change(2), column(state, 0)),
                        dot(change(0), column(state, 1))};
    expect_near(state.body_rates, expected, 1e-4 * (1.0 + std::sqrt(dot(expected, expected))));
  }
}

TEST(FlatState, SingularitiesAreNamedAndTotal) {
  Sample fall{};
  fall.acceleration = {0, 0, -kGravity};
  EXPECT_EQ(flat_state(fall, kNorth).singularity, Singularity::kFreeFall);
  expect_rotation(flat_state(fall, kNorth));
  Sample sideways{};
  sideways.acceleration = {0, 5.0, -kGravity};  // the thrust points left of the heading
  sideways.jerk = {1, 2, 3};
  const FlatState lost = flat_state(sideways, kNorth);
  EXPECT_EQ(lost.singularity, Singularity::kHeading);
  EXPECT_EQ(lost.body_rates.z, 0.0);
  expect_near(column(lost, 0), {1, 0, 0}, 1e-12);
  expect_rotation(lost);
  Sample broken{};
  broken.jerk.y = kNan;
  const FlatState stand_in = flat_state(broken, kNorth);
  EXPECT_EQ(stand_in.singularity, Singularity::kNotFinite);
  EXPECT_EQ(stand_in.thrust, kGravity);
  expect_near(stand_in.body_rates, {0, 0, 0}, 0.0);
  expect_rotation(stand_in);
  for (const Yaw& yaw : {Yaw{0.0, 0.0, 0.0}, Yaw{kNan, 1.0, kNan}}) {
    const FlatState state = flat_state(Sample{}, yaw);
    expect_near(column(state, 0), {1, 0, 0}, 0.0);
    expect_near(state.body_rates, {0, 0, 0}, 0.0);
  }
}

TEST(FlatState, NumbersThatAreNoneGiveALevelAttitude) {
  // 1e200: a number, but its square is none.
  for (const double bad : {kNan, std::numeric_limits<double>::infinity(), 1e200}) {
    for (int a = 0; a < 6; ++a) {
      Sample sample{};
      axis(a < 3 ? sample.acceleration : sample.jerk, a % 3) = bad;
      const FlatState state = flat_state(sample, kNorth);
      EXPECT_EQ(state.singularity, Singularity::kNotFinite) << a;
      EXPECT_EQ(state.thrust, kGravity);
      expect_near(column(state, 2), {0, 0, 1}, 0.0);
    }
  }
}

TEST(FlatState, UpsideDownIsARotationToo) {
  Sample sample{};
  sample.acceleration = {0.3, 0.2, -3.0 * kGravity};
  for (const Yaw& yaw : {kNorth, Yaw{-1.0, 0.0, 0.0}, Yaw{0.0, 1.0, 0.0}}) expect_rotation(flat_state(sample, yaw));
}

}  // namespace
