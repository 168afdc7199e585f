// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rolling map's capacities, each reached and then exceeded.
#include <gtest/gtest.h>

#include "support/owned_map.hpp"

namespace {

using tern::Box;
using tern::Field;
using tern::MapSpec;
using tern::RollingMap;
using tern::Status;

void expect_bind(const MapSpec& spec, Status status, Field expected) {
  std::vector<std::uint64_t> words(200000);
  RollingMap map;
  Field field = Field::kNone;
  EXPECT_EQ(map.bind(spec, words.data(), words.size(), &field), status);
  EXPECT_EQ(field, expected);
}

MapSpec small_spec() {
  MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 8, 8}, 0.1);
  spec.pixels = tern::kMaxPixels;
  return spec;
}

TEST(TinyMap, Pixels) {
  MapSpec spec = small_spec();
  expect_bind(spec, Status::kOk, Field::kNone);
  ++spec.pixels;
  expect_bind(spec, Status::kPixelsFull, Field::kPixels);
  spec = small_spec();
  spec.scan_pixel = 0.02;
  expect_bind(spec, Status::kPixelsFull, Field::kPixels);
}

TEST(TinyMap, PriorBoxes) {
  const std::vector<Box> boxes(tern::kMaxPriorBoxes + 1, Box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}});
  MapSpec spec = small_spec();
  spec.prior = boxes.data();
  spec.prior_count = tern::kMaxPriorBoxes;
  expect_bind(spec, Status::kOk, Field::kNone);
  ++spec.prior_count;
  expect_bind(spec, Status::kPriorFull, Field::kPrior);
}

TEST(TinyMap, PriorCylinders) {
  const std::vector<tern::Cylinder> cylinders(tern::kMaxPriorBoxes + 1, tern::Cylinder{{0.0, 0.0, 0.0}, 0.5, 1.0});
  MapSpec spec = small_spec();
  spec.prior_cylinders = cylinders.data();
  spec.prior_cylinder_count = tern::kMaxPriorBoxes;
  expect_bind(spec, Status::kOk, Field::kNone);
  ++spec.prior_cylinder_count;
  expect_bind(spec, Status::kPriorFull, Field::kPrior);
}

TEST(TinyMap, Cells) {
  MapSpec spec = small_spec();
  spec.dims = {64, 64, 64};
  expect_bind(spec, Status::kInvalidArgument, Field::kDimensions);
}

}  // namespace
