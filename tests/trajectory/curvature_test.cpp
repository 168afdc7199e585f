// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/curvature.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <memory>
#include <random>

namespace {

using tern::Curvature;
using tern::kMaxSegments;

constexpr double kNone[kMaxSegments] = {};

/// The matrix, column by column from steps along the axes.
Eigen::MatrixXd matrix_of(const Curvature& curvature, int count) {
  Eigen::MatrixXd matrix(count, count);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < count; ++k) {
      const int high = i < k ? k : i;
      matrix(i, k) = curvature.entries[high * (high + 1) / 2 + (i + k - high)];
    }
  }
  return matrix;
}

TEST(TrajectoryCurvature, ADiagonalDividesEachSegmentsDescent) {
  const auto curvature = std::make_unique<Curvature>();
  const double diagonal[] = {2.0, 3.0, 4.0};
  const double extra[] = {0.0, 1.0, 4.0};
  const double descent[] = {1.0, -2.0, 4.0};
  double step[3];
  tern::curvature_begin(*curvature, diagonal, 3);
  tern::newton_step(*curvature, extra, descent, 3, step);
  EXPECT_NEAR(step[0], 0.5, 1e-15);
  EXPECT_NEAR(step[1], -0.5, 1e-15);
  EXPECT_NEAR(step[2], 0.5, 1e-15);
  tern::curvature_scale(*curvature, 0.5, 3);
  tern::newton_step(*curvature, kNone, descent, 3, step);
  EXPECT_NEAR(step[0], 1.0, 1e-15);
  EXPECT_NEAR(step[2], 2.0, 1e-15);
}

TEST(TrajectoryCurvature, WhatItLearnsHoldsAlongTheStep) {
  const auto curvature = std::make_unique<Curvature>();
  const double diagonal[] = {1.0, 1.0};
  const double step[] = {1.0, 1.0};
  const double change[] = {3.0, 1.0};
  tern::curvature_begin(*curvature, diagonal, 2);
  tern::curvature_learn(*curvature, step, change, 2);
  // I - (1/2) [1 1; 1 1] + (1/4) [9 3; 3 1], by hand.
  const Eigen::MatrixXd matrix = matrix_of(*curvature, 2);
  EXPECT_NEAR(matrix(0, 0), 2.75, 1e-15);
  EXPECT_NEAR(matrix(0, 1), 0.25, 1e-15);
  EXPECT_NEAR(matrix(1, 1), 0.75, 1e-15);
}

TEST(TrajectoryCurvature, NegativeCurvatureIsLearnedInPart) {
  const auto curvature = std::make_unique<Curvature>();
  const double diagonal[] = {1.0};
  const double step[] = {1.0};
  const double change[] = {-5.0};
  tern::curvature_begin(*curvature, diagonal, 1);
  tern::curvature_learn(*curvature, step, change, 1);
  EXPECT_NEAR(curvature->entries[0], 0.2, 1e-15);
  tern::curvature_learn(*curvature, kNone, change, 1);  // no step tells nothing
  EXPECT_NEAR(curvature->entries[0], 0.2, 1e-15);
}

TEST(TrajectoryCurvature, AChangeThatIsNoNumberTellsNothing) {
  const auto curvature = std::make_unique<Curvature>();
  const double diagonal[] = {2.0, 3.0};
  const double step[] = {1.0, -1.0};
  tern::curvature_begin(*curvature, diagonal, 2);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const double change[] = {bad, bad};
    tern::curvature_learn(*curvature, step, change, 2);
    EXPECT_EQ(curvature->entries[0], 2.0);
    EXPECT_EQ(curvature->entries[1], 0.0);
    EXPECT_EQ(curvature->entries[2], 3.0);
  }
}

TEST(TrajectoryCurvature, RandomStepsKeepItPositiveDefiniteAndSolvable) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto curvature = std::make_unique<Curvature>();
  for (const int count : {1, 2, 7, kMaxSegments}) {
    Eigen::VectorXd diagonal(count), step(count), change(count), extra(count), descent(count), solved(count);
    for (int i = 0; i < count; ++i) diagonal[i] = std::exp(normal(random));
    tern::curvature_begin(*curvature, diagonal.data(), count);
    for (int round = 0; round < 40; ++round) {
      for (int i = 0; i < count; ++i) {
        step[i] = normal(random);
        change[i] = normal(random) + step[i];
        extra[i] = std::fabs(normal(random));
        descent[i] = normal(random);
      }
      tern::curvature_learn(*curvature, step.data(), change.data(), count);
      tern::newton_step(*curvature, extra.data(), descent.data(), count, solved.data());
      Eigen::MatrixXd matrix = matrix_of(*curvature, count);
      EXPECT_GT(matrix.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
      matrix += extra.asDiagonal();
      EXPECT_LT((matrix * solved - descent).norm(), 1e-6 * (1.0 + matrix.norm() * solved.norm()));
    }
  }
}

TEST(TrajectoryCurvature, FindsTheLeastOfAQuadraticForm) {
  // f = 1/2 x'Ax - b'x with A of condition 100: quasi-Newton steps of full length end at A^-1 b.
  const int count = 5;
  Eigen::MatrixXd a = Eigen::MatrixXd::Constant(count, count, 0.8);
  for (int i = 0; i < count; ++i) a(i, i) = 1.0 + 3.0 * i;
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(count, 1.0, 2.0);
  const auto curvature = std::make_unique<Curvature>();
  const Eigen::VectorXd diagonal = 2.0 * a.diagonal();
  tern::curvature_begin(*curvature, diagonal.data(), count);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(count), step(count);
  for (int round = 0; round < 40; ++round) {
    const Eigen::VectorXd descent = b - a * x;
    tern::newton_step(*curvature, kNone, descent.data(), count, step.data());
    const Eigen::VectorXd change = a * step;
    tern::curvature_learn(*curvature, step.data(), change.data(), count);
    x += step;
  }
  EXPECT_LT((x - a.ldlt().solve(b)).norm(), 1e-9);
}

}  // namespace
