// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Larger polyhedra around the same segment, where the largest is known.
#include "corridor/improve.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "support/corridor_reference.hpp"

namespace tern_test {
namespace {

using tern::GrowScratch;
using tern::Halfspace;
using tern::LocalBox;
using tern::Polyhedron;
using tern::SegmentMargin;
using tern::Status;
using tern::Vec3;

class CorridorImprove : public ::testing::Test {
 protected:
  CorridorImprove() {
    reset_counters(*scratch_);
    for (int a = 0; a < 3; ++a) {
      const Vec3 n{a == 0 ? 1.0 : 0.0, a == 1 ? 1.0 : 0.0, a == 2 ? 1.0 : 0.0};
      polyhedron_.planes[polyhedron_.count++] = {n, 4.0};
      polyhedron_.planes[polyhedron_.count++] = {{-n.x, -n.y, -n.z}, 0.0};
    }
  }

  /// Improves the cube of 4 m, cut by one half-space a box, around the segment.
  Status run(const std::vector<LocalBox>& boxes, const std::vector<Halfspace>& cuts) {
    for (const Halfspace& cut : cuts) polyhedron_.planes[polyhedron_.count++] = cut;
    const tern::Obstacles obstacles{boxes.data(), static_cast<int>(boxes.size()), 0.0};
    tern::Improvement improvement;
    tern::Work all{0xFFFFFFFFu};
    Status status = Status::kOk;
    improve_begin(improvement);
    improve_advance(improvement, {obstacles, segment_, 0.01, 6}, *scratch_, polyhedron_, all, status);
    center_ = tern::to_vec3(improvement.center);
    return status;
  }

  double reach(const Vec3& n) const {
    double most = -1e300;
    for (const Vec3& v : vertices_of(polyhedron_)) most = std::max(most, dot3(n, v));
    return most;
  }

  const SegmentMargin segment_{{1.0, 2.0, 2.0}, {1.5, 2.0, 2.0}, 0.005};
  std::unique_ptr<GrowScratch> scratch_ = std::make_unique<GrowScratch>();
  Polyhedron polyhedron_{};
  Vec3 center_{};
};

const LocalBox kWall{{3.0, 0.0, 0.0}, {4.0, 4.0, 4.0}};  // x >= 3
const Halfspace kTilted{{0.8, 0.6, 0.0}, 2.4};           // through the wall's edge at y = 0
const LocalBox kStep{{2.0, 3.0, 0.0}, {4.0, 4.0, 4.0}};  // a corner of the room
const Halfspace kBeforeStep{{1.0, 0.0, 0.0}, 2.0};       // takes half of the room: y <= 3 takes a quarter

TEST_F(CorridorImprove, NothingToImproveStays) {
  ASSERT_EQ(run({}, {}), Status::kOk);
  EXPECT_EQ(polyhedron_.count, 6);
  EXPECT_NEAR(norm3(minus3(center_, {2.0, 2.0, 2.0})), 0.0, 0.05);
  EXPECT_EQ(scratch_->planes_high, 0);
}

TEST_F(CorridorImprove, ATiltedPlaneStandsUp) {
  ASSERT_EQ(run({kWall}, {kTilted}), Status::kOk);
  ASSERT_EQ(polyhedron_.count, 7);
  EXPECT_NEAR(polyhedron_.planes[6].normal.x, 1.0, 1e-9);
  EXPECT_NEAR(polyhedron_.planes[6].offset, 3.0, 1e-7);
  // The cube's face counts though it is redundant: 1 / x = 1 / (3 - x) + 1 / (4 - x), (14 - 52^(1/2)) / 6.
  EXPECT_NEAR(norm3(minus3(center_, {1.1315, 2.0, 2.0})), 0.0, 0.02);
}

TEST_F(CorridorImprove, LeavingOutFindsTheOtherSide) {
  // Inside x <= 2 every ellipsoid is nearer to the step's left face than to its lower one; without that half-space the
  // room is the cube, whose ellipsoid meets the step at its edge or below.
  ASSERT_EQ(run({kStep}, {kBeforeStep}), Status::kOk);
  ASSERT_EQ(polyhedron_.count, 7);
  EXPECT_GT(reach({1.0, 0.0, 0.0}), 3.9);
  for (const Vec3& v : vertices_of(polyhedron_))
    EXPECT_GE(point_cube_distance(v, {{2.0, 3.0, 0.0}, {4.0, 4.0, 4.0}}), 0.0);
  EXPECT_GE(cube_support(polyhedron_.planes[6].normal, {{2.0, 3.0, 0.0}, {4.0, 4.0, 4.0}}),
            polyhedron_.planes[6].offset);
}

}  // namespace
}  // namespace tern_test
