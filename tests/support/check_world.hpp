// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A good plan made by hand, for tests that spoil it.
#ifndef TERN_TESTS_SUPPORT_CHECK_WORLD_HPP
#define TERN_TESTS_SUPPORT_CHECK_WORLD_HPP

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "prove/check_stage.hpp"
#include "prove/grants.hpp"

namespace tern_test {

inline tern::Polyhedron box_polyhedron(const tern::Vec3& lower, const tern::Vec3& upper) {
  tern::Polyhedron polyhedron{};
  polyhedron.count = 6;
  polyhedron.planes[0] = {{1.0, 0.0, 0.0}, upper.x};
  polyhedron.planes[1] = {{-1.0, 0.0, 0.0}, -lower.x};
  polyhedron.planes[2] = {{0.0, 1.0, 0.0}, upper.y};
  polyhedron.planes[3] = {{0.0, -1.0, 0.0}, -lower.y};
  polyhedron.planes[4] = {{0.0, 0.0, 1.0}, upper.z};
  polyhedron.planes[5] = {{0.0, 0.0, -1.0}, -lower.z};
  return polyhedron;
}

/// At rest at both ends: the first four control points at `from`, the last four at `to`.
inline tern::Segment straight(const tern::Vec3& from, const tern::Vec3& to, double duration, int polyhedron) {
  tern::Segment segment{};
  segment.duration = duration;
  segment.polyhedron = polyhedron;
  for (int i = 0; i < 4; ++i) {
    segment.points[i] = from;
    segment.points[i + 4] = to;
  }
  return segment;
}

/// A 4 x 2 x 2 m grid with a wall of voxels at x in [2.0, 2.1), y < 1; two segments pass it at y = 1.5.
class CheckWorld : public testing::Test {
 protected:
  CheckWorld()
      : words_(tern::grid_words({40, 20, 20})), corridor_(new tern::Corridor), trajectory_(new tern::Trajectory) {
    tern::GridSpec spec{};
    spec.cell = 0.1;
    spec.dims = {40, 20, 20};
    spec.boundary = {{0.0, 0.0, 0.0}, {4.0, 2.0, 2.0}};
    spec.radius = 0.2;
    EXPECT_EQ(grid_.bind(spec, words_.data(), words_.size()), tern::Status::kOk);
    EXPECT_EQ(grid_.mark_box({{2.0, 0.0, 0.0}, {2.1, 1.0, 2.0}}), tern::Status::kOk);
    grid_.inflate();
    corridor_->count = 2;
    corridor_->polyhedra[0] = box_polyhedron({0.0, 1.2, 0.0}, {4.0, 2.0, 2.0});
    corridor_->polyhedra[1] = box_polyhedron({2.3, 0.0, 0.0}, {4.0, 2.0, 2.0});
    trajectory_->count = 2;
    trajectory_->origin = {0.0, 0.0, 0.0};
    trajectory_->segments[0] = straight({0.5, 1.5, 1.0}, {3.0, 1.5, 1.0}, 4.0, 0);
    trajectory_->segments[1] = straight({3.0, 1.5, 1.0}, {3.0, 0.5, 1.0}, 2.0, 1);
    query_.start.position = {0.5, 1.5, 1.0};
    query_.goal.position = {3.0, 0.5, 1.0};
    query_.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  }

  tern::Status run() {
    tern::check_begin(stage_);
    tern::Work work{tern::kCheckBound};
    tern::check_advance(stage_, grid_, *corridor_, *trajectory_, query_, work);
    return stage_.status;
  }

  const tern::ProofReport& expect(tern::Finding finding, int segment) {
    EXPECT_EQ(run(), tern::Status::kCheckFailed);
    EXPECT_EQ(stage_.found.finding, finding);
    EXPECT_EQ(stage_.found.segment, segment);
    EXPECT_GE(stage_.found.excess, 0.0);
    return stage_.found;
  }

  /// What is granted the plan.
  tern::Grant grant() const { return grant_to_plan(grid_, *trajectory_); }

  std::vector<std::uint64_t> words_;
  tern::Grid grid_;
  std::unique_ptr<tern::Corridor> corridor_;
  std::unique_ptr<tern::Trajectory> trajectory_;
  tern::CheckQuery query_{};
  tern::CheckStage stage_{};
};

}  // namespace tern_test

#endif
