// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a rolling map refuses, and that it changes nothing then.
#include <gtest/gtest.h>

#include <cmath>

#include "support/numbers.hpp"
#include "support/owned_map.hpp"

namespace {

using tern::Box;
using tern::DepthView;
using tern::Field;
using tern::MapSpec;
using tern::Pose;
using tern::RollingMap;
using tern::Status;
using tern::Vec3;
using tern_test::finish;
using tern_test::Image;
using tern_test::kInfinity;
using tern_test::kNan;
using tern_test::OwnedMap;

constexpr Pose kLevel{{1.0, 1.0, 1.0}, {1.0, 0.0, 0.0, 0.0}};

MapSpec refused_spec() {
  MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {70, 20, 20}, 0.2);
  spec.pixels = 4096;
  spec.scan_pixel = 0.2;
  return spec;
}

/// bind() with one change to the spec.
template <typename Change>
void expect_refused(Field expected, Status status, Change change) {
  MapSpec spec = refused_spec();
  std::vector<std::uint64_t> words(tern::map_words(spec), 7u);
  const std::vector<std::uint64_t> before = words;
  change(spec);
  RollingMap map;
  Field field = Field::kNone;
  EXPECT_EQ(map.bind(spec, words.data(), words.size(), &field), status);
  EXPECT_EQ(field, expected);
  EXPECT_FALSE(map.bound());
  EXPECT_EQ(map.frames(), 0u);
  EXPECT_EQ(words, before);
}

TEST(MapRefused, Specs) {
  const Status invalid = Status::kInvalidArgument;
  expect_refused(Field::kRange, invalid, [](MapSpec& s) { s.range = 0.0; });
  expect_refused(Field::kRange, invalid, [](MapSpec& s) { s.range = kNan; });
  expect_refused(Field::kRange, invalid, [](MapSpec& s) { s.range = kInfinity; });
  expect_refused(Field::kRange, invalid, [](MapSpec& s) { s.range = 1.01 * tern::kMaxCell; });
  expect_refused(Field::kMargins, invalid, [](MapSpec& s) { s.depth_margin = -0.1; });
  expect_refused(Field::kMargins, invalid, [](MapSpec& s) { s.depth_margin_square = kNan; });
  expect_refused(Field::kMargins, invalid, [](MapSpec& s) { s.pose_margin = -1e-9; });
  expect_refused(Field::kMargins, invalid, [](MapSpec& s) { s.angle_margin = -0.1; });
  expect_refused(Field::kMargins, invalid, [](MapSpec& s) { s.angle_margin = 0.6; });
  expect_refused(Field::kScanPixel, invalid, [](MapSpec& s) { s.scan_pixel = 0.001; });
  expect_refused(Field::kScanPixel, invalid, [](MapSpec& s) { s.scan_pixel = kNan; });
  expect_refused(Field::kScanPixel, invalid, [](MapSpec& s) { s.scan_pixel = 1.01; });
  expect_refused(Field::kEvidence, invalid, [](MapSpec& s) { s.hits = 0; });
  expect_refused(Field::kEvidence, invalid, [](MapSpec& s) { s.hits = tern::kMaxEvidence + 1; });
  expect_refused(Field::kEvidence, invalid, [](MapSpec& s) { s.misses = 0; });
  expect_refused(Field::kEvidence, invalid, [](MapSpec& s) { s.misses = tern::kMaxEvidence + 1; });
  expect_refused(Field::kEvidence, invalid, [](MapSpec& s) { s.support = -1; });
  expect_refused(Field::kEvidence, invalid, [](MapSpec& s) { s.support = 9; });
  expect_refused(Field::kAge, invalid, [](MapSpec& s) { s.age = -1; });
  expect_refused(Field::kAge, invalid, [](MapSpec& s) { s.age = std::int64_t{86400} * 1000000000 + 1; });
  expect_refused(Field::kSlack, invalid, [](MapSpec& s) { s.slack = -1; });
  expect_refused(Field::kSlack, invalid, [](MapSpec& s) { s.slack = tern::kMaxDimension + 1; });
  expect_refused(Field::kPixels, invalid, [](MapSpec& s) { s.pixels = 0; });
  expect_refused(Field::kPixels, Status::kPixelsFull, [](MapSpec& s) { s.pixels = tern::kMaxPixels + 1; });
  expect_refused(Field::kPixels, Status::kPixelsFull, [](MapSpec& s) { s.pixels = 6 * 12 * 12 - 1; });
  expect_refused(Field::kPrior, Status::kPriorFull, [](MapSpec& s) { s.prior_count = tern::kMaxPriorBoxes + 1; });
  expect_refused(Field::kPrior, invalid, [](MapSpec& s) { s.prior_count = 1; });
  expect_refused(Field::kPrior, invalid, [](MapSpec& s) { s.prior_count = -1; });
  expect_refused(Field::kDimensions, invalid, [](MapSpec& s) { s.dims.y = 0; });
  expect_refused(Field::kCell, invalid, [](MapSpec& s) { s.cell = 0.0; });
  expect_refused(Field::kOrigin, Status::kNonFiniteInput, [](MapSpec& s) { s.origin.z = kNan; });
  expect_refused(Field::kStorage, invalid, [](MapSpec& s) { s.pixels = 4200; });
}

TEST(MapRefused, PriorBoxesThatAreNone) {
  static const Box kBoxes[] = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 1.0}},
                               {{0.0, 0.0, 0.0}, {1.0, kNan, 1.0}},
                               {{0.0, 0.0, -kInfinity}, {1.0, 1.0, 1.0}}};
  for (const Box& box : kBoxes) {
    expect_refused(Field::kPrior, Status::kInvalidArgument, [&box](MapSpec& s) {
      s.prior = &box;
      s.prior_count = 1;
    });
  }
}

TEST(MapRefused, PriorCylindersThatAreNone) {
  static const tern::Cylinder kCylinders[] = {
      {{0.0, 0.0, 0.0}, -0.1, 1.0}, {{0.0, 0.0, 0.0}, 0.1, -1.0}, {{0.0, kNan, 0.0}, 0.1, 1.0}};
  for (const tern::Cylinder& cylinder : kCylinders) {
    expect_refused(Field::kPrior, Status::kInvalidArgument, [&cylinder](MapSpec& s) {
      s.prior_cylinders = &cylinder;
      s.prior_cylinder_count = 1;
    });
  }
  expect_refused(Field::kPrior, Status::kInvalidArgument, [](MapSpec& s) { s.prior_cylinder_count = 1; });
  expect_refused(Field::kPrior, Status::kInvalidArgument, [](MapSpec& s) { s.prior_cylinder_count = -1; });
}

class MapFrames : public ::testing::Test {
 protected:
  MapFrames() : owned(refused_spec()), image(20, 10, 10.0) {
    for (float& z : image.z) z = 1.5f;
  }
  /// begin_frame() with what is at hand, which must change nothing.
  void expect(Status status) {
    const std::uint64_t before = tern_test::hash_of(owned.map);
    const std::uint64_t revision = owned.map.revision();
    EXPECT_EQ(owned.map.begin_frame(image.view, pose, t), status);
    EXPECT_FALSE(owned.map.busy());
    EXPECT_EQ(tern_test::hash_of(owned.map), before);
    EXPECT_EQ(owned.map.revision(), revision);
  }

  OwnedMap owned;
  Image image;
  Pose pose = kLevel;
  std::int64_t t = 0;
};

TEST_F(MapFrames, PosesThatAreNone) {
  for (const double w : {0.0, 0.99, 1.01, kNan, 1e300}) {
    pose = kLevel;
    pose.quaternion[0] = w;
    expect(Status::kPoseInvalid);
  }
  pose = kLevel;
  pose.position.y = kNan;
  expect(Status::kNonFiniteInput);
  pose.position.y = 2.1;
  expect(Status::kOutOfMap);
}

TEST_F(MapFrames, CamerasThatAreNone) {
  const DepthView good = image.view;
  const auto with = [&](auto change) {
    image.view = good;
    change(image.view);
    expect(Status::kCameraInvalid);
  };
  with([](DepthView& v) { v.width = 0; });
  with([](DepthView& v) { v.height = -1; });
  with([](DepthView& v) { v.stride = v.width - 1; });
  with([](DepthView& v) { v.fx = 0.0; });
  with([](DepthView& v) { v.fy = -10.0; });
  with([](DepthView& v) { v.fx = kNan; });
  with([](DepthView& v) { v.fx = 0.01; });
  with([](DepthView& v) { v.fy = 0.01; });
  with([](DepthView& v) { v.cx = 1e9; });
  with([](DepthView& v) { v.scale = 0.0; });
  with([](DepthView& v) { v.min = -1.0; });
  with([](DepthView& v) { v.max = v.min; });
  for (double DepthView::*number : {&DepthView::fx, &DepthView::fy, &DepthView::cx, &DepthView::cy, &DepthView::scale,
                                    &DepthView::min, &DepthView::max}) {
    with([number](DepthView& v) { v.*number = kNan; });
    with([number](DepthView& v) { v.*number = kInfinity; });
  }
}

TEST_F(MapFrames, ImagesThatAreMissingOrTooLarge) {
  const DepthView good = image.view;
  image.view.z32 = nullptr;
  expect(Status::kInvalidArgument);
  image.view = good;
  const std::uint16_t number = 0;
  image.view.z16 = &number;
  expect(Status::kInvalidArgument);
  image.view = good;
  image.view.width = image.view.stride = 100;
  image.view.height = 41;
  expect(Status::kPixelsFull);
}

TEST_F(MapFrames, FramesOutOfOrder) {
  t = 10;
  EXPECT_EQ(owned.map.begin_frame(image.view, pose, t), Status::kRunning);
  // One job at a time.
  EXPECT_EQ(owned.map.begin_frame(image.view, pose, t), Status::kInvalidArgument);
  EXPECT_EQ(owned.map.begin_scan(nullptr, 0, pose.position, t), Status::kInvalidArgument);
  EXPECT_EQ(owned.map.begin_scan({nullptr, nullptr, 0, 0.0, 1.0}, pose.position, t), Status::kInvalidArgument);
  EXPECT_EQ(owned.map.follow(pose.position), Status::kInvalidArgument);
  EXPECT_EQ(owned.map.assume_free(pose.position, 1.0), Status::kInvalidArgument);
  EXPECT_EQ(owned.map.mark_box({pose.position, pose.position}), Status::kInvalidArgument);
  EXPECT_EQ(owned.map.mark_cylinder({pose.position, 0.1, 0.1}), Status::kInvalidArgument);
  EXPECT_EQ(owned.map.mark_points(&pose.position, 1), Status::kInvalidArgument);
  EXPECT_EQ(finish(owned.map), Status::kOk);
  t = 9 - tern::kMaxFrameDelay;
  expect(Status::kClockBehind);
  EXPECT_EQ(owned.map.begin_scan(nullptr, 0, pose.position, t), Status::kClockBehind);
}

TEST_F(MapFrames, CallsThatAreWrong) {
  RollingMap& map = owned.map;
  EXPECT_EQ(map.begin_scan(nullptr, 1, pose.position, 0), Status::kInvalidArgument);
  EXPECT_EQ(map.begin_scan(nullptr, 0, {kNan, 0.0, 0.0}, 0), Status::kNonFiniteInput);
  const tern::Vec3 ahead{1.0, 0.0, 0.0};
  const float range = 1.0f;
  const tern::Beams wrong[] = {{nullptr, &range, 1, 0.1, 9.0}, {&ahead, nullptr, 1, 0.1, 9.0},
                               {&ahead, &range, 1, -0.1, 9.0}, {&ahead, &range, 1, 9.0, 9.0},
                               {&ahead, &range, 1, kNan, 9.0}, {&ahead, &range, 1, 0.1, kNan}};
  for (const tern::Beams& beams : wrong) {
    EXPECT_EQ(map.begin_scan(beams, pose.position, 0), Status::kInvalidArgument);
  }
  const tern::Beams right{&ahead, &range, 1, 0.0, kInfinity};
  EXPECT_EQ(map.begin_scan(right, {kNan, 0.0, 0.0}, 0), Status::kNonFiniteInput);
  EXPECT_EQ(map.begin_scan(right, {1e15, 0.0, 0.0}, 0), Status::kOutOfMap);
  EXPECT_EQ(map.follow({kNan, 0.0, 0.0}), Status::kNonFiniteInput);
  EXPECT_EQ(map.follow({1e15, 0.0, 0.0}), Status::kOutOfMap);
  EXPECT_EQ(map.assume_free({0.0, 0.0, 0.0}, -1.0), Status::kInvalidArgument);
  EXPECT_EQ(map.assume_column({{0.0, 0.0, 0.0}, -1.0, 1.0}), Status::kInvalidArgument);
  EXPECT_EQ(map.assume_column({{0.0, 0.0, 0.0}, 1.0, -1.0}), Status::kInvalidArgument);
  EXPECT_EQ(map.assume_column({{0.0, 0.0, kNan}, 1.0, 1.0}), Status::kNonFiniteInput);
  EXPECT_EQ(map.assume_free({0.0, 0.0, 0.0}, kNan), Status::kNonFiniteInput);
  EXPECT_EQ(map.assume_free({0.0, kInfinity, 0.0}, 1.0), Status::kNonFiniteInput);
  EXPECT_EQ(map.mark_box({{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}), Status::kInvalidArgument);
  EXPECT_EQ(map.mark_box({{kNan, 0.0, 0.0}, {0.0, 0.0, 0.0}}), Status::kNonFiniteInput);
  EXPECT_EQ(map.mark_box({{0.0, 0.0, 0.0}, {1.0, kInfinity, 1.0}}), Status::kNonFiniteInput);
  const Vec3 point{kNan, 0.0, 0.0};
  EXPECT_EQ(map.mark_points(&point, 1), Status::kNonFiniteInput);
  EXPECT_EQ(map.mark_cylinder({point, 0.1, 1.0}), Status::kNonFiniteInput);
  EXPECT_EQ(map.mark_cylinder({{1.0, 1.0, 0.0}, -0.1, 1.0}), Status::kInvalidArgument);
  EXPECT_EQ(map.mark_points(nullptr, 1), Status::kInvalidArgument);
}

TEST(MapRefused, AnythingWithoutABind) {
  RollingMap map;
  EXPECT_FALSE(map.bound());
  EXPECT_FALSE(map.busy());
  EXPECT_EQ(map.revision(), 0u);
  EXPECT_EQ(map.step(1), Status::kInvalidArgument);
  EXPECT_EQ(map.begin_frame({}, kLevel, 0), Status::kInvalidArgument);
  EXPECT_EQ(map.begin_scan(nullptr, 0, kLevel.position, 0), Status::kInvalidArgument);
  EXPECT_EQ(map.follow(kLevel.position), Status::kInvalidArgument);
  EXPECT_EQ(map.assume_column({kLevel.position, 1.0, 1.0}), Status::kInvalidArgument);
  double ground = 5.0;
  EXPECT_FALSE(map.ground_at(kLevel.position, 0.0, ground));
  EXPECT_EQ(ground, 5.0);
  EXPECT_EQ(map.assume_free(kLevel.position, 1.0), Status::kInvalidArgument);
  EXPECT_EQ(map.mark_box({}), Status::kInvalidArgument);
  EXPECT_EQ(map.mark_cylinder({}), Status::kInvalidArgument);
  EXPECT_EQ(map.mark_points(nullptr, 0), Status::kInvalidArgument);
  EXPECT_EQ(map.frame_work(10, 10), 0u);
  EXPECT_EQ(map.scan_work(10), 0u);
  EXPECT_FALSE(map.seen({0, 0, 0}));
}

/// The map lies where doubles just tell a thousandth of a cell apart: 2^52 thousandths of a cell from the origin. It
/// follows up to there, and not a few thousand cells further, although its numbers of voxels would reach much further.
TEST(MapRefused, ToFollowWhereDoublesAreTooCoarse) {
  MapSpec spec = refused_spec();
  const double last = 1e-3 * spec.cell * 4503599627370496.0;
  const double some = 5000.0 * spec.cell;
  spec.origin.x = last - some;
  OwnedMap owned(spec);
  ASSERT_EQ(owned.status, Status::kOk);
  EXPECT_EQ(owned.map.follow({last + some, 1.0, 1.0}), Status::kOutOfMap);
  EXPECT_FALSE(owned.map.busy());
  EXPECT_EQ(owned.map.follow({last - 0.5 * some, 1.0, 1.0}), Status::kRunning);
}

TEST(MapRefused, ScansWhereNoneAreExpected) {
  MapSpec spec = refused_spec();
  spec.scan_pixel = 0.0;
  OwnedMap owned(spec);
  EXPECT_EQ(owned.map.begin_scan(nullptr, 0, kLevel.position, 0), Status::kInvalidArgument);
  EXPECT_EQ(owned.map.begin_scan({nullptr, nullptr, 0, 0.1, 9.0}, kLevel.position, 0), Status::kInvalidArgument);
}

}  // namespace
