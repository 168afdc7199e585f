// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Steps that bend away from planes, by hand: two segments whose second derivatives are 2 and 4.
#include "trajectory/cutting_planes.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace {

using tern::CuttingPlanes;

constexpr int kSegments = 2;
constexpr double kFirst[] = {1.0, 0.0};
constexpr double kSecond[] = {0.0, 1.0};

class BentSteps : public testing::Test {
 protected:
  BentSteps() : curvature_(std::make_unique<tern::Curvature>()), planes_(std::make_unique<CuttingPlanes>()) {
    constexpr double kDiagonal[] = {2.0, 4.0};
    constexpr double kNoExtra[] = {0.0, 0.0};
    double step[kSegments];
    tern::curvature_begin(*curvature_, kDiagonal, kSegments);
    tern::newton_step(*curvature_, kNoExtra, kNoExtra, kSegments, step);
    planes_->found = 0;
  }

  /// A programme that was abandoned where the first segment was shorter by 1: its snap was 3 and fell by 1 for each
  /// part by which that lasts longer. So it says that the snap is at least 2 at the base. There it is `kBaseSnap`.
  void abandon_one() {
    constexpr double kStep[] = {-1.0, 0.0};
    tern::add_plane(*planes_, 3.0, kFirst, kStep, kSegments);
  }

  void bend(double first, double second) {
    step_[0] = first;
    step_[1] = second;
    tern::bend_step(*planes_, *curvature_, kBaseSnap, kSegments, step_);
  }

  static constexpr double kBaseSnap = 1.0;
  std::unique_ptr<tern::Curvature> curvature_;
  std::unique_ptr<CuttingPlanes> planes_;
  double step_[kSegments];
};

TEST_F(BentSteps, StayAsTheyAreWithoutAPlane) {
  bend(-0.4, 0.3);
  EXPECT_EQ(step_[0], -0.4);
  EXPECT_EQ(step_[1], 0.3);
}

TEST_F(BentSteps, KnowAPlaneWhereTheyBegin) {
  abandon_one();
  EXPECT_EQ(planes_->list[0].at_base, 2.0);
  constexpr double kOn[] = {0.25, 5.0};
  tern::move_base(*planes_, kOn, kSegments);
  EXPECT_EQ(planes_->list[0].at_base, 1.75);
}

/// The plane may rise to 1 + (3 - 1) / 2 = 2, which it does at the base: the first segment may not get shorter. To
/// lengthen it by 0.4 takes 0.8 of the plane, as the second derivative is 2.
TEST_F(BentSteps, EndWhereThePlaneIsLowEnough) {
  abandon_one();
  bend(-0.4, 0.3);
  EXPECT_NEAR(step_[0], 0.0, 1e-15);
  EXPECT_EQ(step_[1], 0.3);
}

/// The whole plane is worth 1 / 2.
TEST_F(BentSteps, FollowAPlaneNoFurtherThanItIsWorth) {
  abandon_one();
  bend(-2.0, 0.0);
  EXPECT_NEAR(step_[0], -1.5, 1e-15);
}

TEST_F(BentSteps, StayAsTheyAreBelowThePlane) {
  abandon_one();
  bend(0.2, -0.1);
  EXPECT_EQ(step_[0], 0.2);
  EXPECT_EQ(step_[1], -0.1);
}

/// Two planes that ask for different segments do not disturb each other.
TEST_F(BentSteps, BendAwayFromSeveralPlanes) {
  abandon_one();
  constexpr double kStep[] = {0.0, -1.0};
  tern::add_plane(*planes_, 3.0, kSecond, kStep, kSegments);
  bend(-0.4, -0.125);
  EXPECT_NEAR(step_[0], 0.0, 1e-15);
  EXPECT_NEAR(step_[1], 0.0, 1e-15);
}

TEST_F(BentSteps, ForgetTheOldestPlane) {
  abandon_one();
  constexpr double kStep[] = {0.0, 0.0};
  for (int k = 0; k < tern::kMaxCuttingPlanes; ++k) tern::add_plane(*planes_, 0.5, kSecond, kStep, kSegments);
  bend(-0.4, 0.3);
  EXPECT_EQ(step_[0], -0.4);
  EXPECT_EQ(step_[1], 0.3);
}

/// A plane without slope asks for nothing, however high it is.
TEST_F(BentSteps, StayAsTheyAreWhereAPlaneIsLevel) {
  constexpr double kLevel[] = {0.0, 0.0};
  constexpr double kStep[] = {-1.0, 0.0};
  tern::add_plane(*planes_, 3.0, kLevel, kStep, kSegments);
  bend(-0.4, 0.3);
  EXPECT_EQ(step_[0], -0.4);
  EXPECT_EQ(step_[1], 0.3);
}

}  // namespace
