// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the check accepts where a plan passes its vias, and what it finds where the plan does not.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "base/math.hpp"
#include "prove/check_stage.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Finding;
using tern::Vec3;
using tern::Via;

/// Two segments of 2 s, from (1, 1, 1) by (3, 1, 1) to (3, 4, 1).
class ProveVias : public testing::Test {
 protected:
  ProveVias() : world_({80, 80, 40}, 0.1, 0.2) {
    plan_.count = 2;
    plan_.origin = {1.0, 1.0, 1.0};
    rest({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 0);
    rest({2.0, 0.0, 0.0}, {2.0, 3.0, 0.0}, 1);
  }
  /// From rest to rest.
  void rest(const Vec3& from, const Vec3& to, int index) {
    plan_.segments[index].duration = 2.0;
    for (int k = 0; k < 4; ++k) {
      plan_.segments[index].points[k] = from;
      plan_.segments[index].points[tern::kDegree - k] = to;
    }
  }
  /// At a constant velocity, 1 m/s along x.
  void glide() {
    for (int i = 0; i < 2; ++i) {
      for (int k = 0; k <= tern::kDegree; ++k) plan_.segments[i].points[k] = {2.0 * i + k * (2.0 / 7.0), 0.0, 0.0};
    }
  }
  bool met(const std::vector<Via>& vias, const std::vector<std::int32_t>& joints) {
    tern::CheckQuery query{};
    query.vias = vias.data();
    query.joints = joints.data();
    query.via_count = static_cast<std::int32_t>(vias.size());
    found_ = tern::ProofReport{};
    return tern::vias_met(world_.grid, plan_, query, found_);
  }
  void expect_missed(int via, int derivative, int axis, double excess) {
    EXPECT_EQ(found_.finding, Finding::kVia);
    EXPECT_EQ(found_.via, via);
    EXPECT_EQ(found_.derivative, derivative);
    EXPECT_EQ(found_.axis, axis);
    EXPECT_NEAR(found_.excess, excess, 1e-6);
  }

  World world_;
  tern::Trajectory plan_{};
  tern::ProofReport found_{};
};

TEST_F(ProveVias, AcceptsWhatIsPassed) {
  EXPECT_TRUE(met({}, {}));
  EXPECT_TRUE(met({{{3, 1, 1}, 0.0, false, false, {}}}, {1}));
  EXPECT_TRUE(
      met({{{1, 1, 1}, 0.0, true, false, {}}, {{3, 1.3, 1.4}, 0.5, true, false, {}}, {{3, 4, 1}, 0, true, false, {}}},
          {0, 1, 2}))
      << "both ends are joints, and 0.3 and 0.4 m are 0.5 m away";
  EXPECT_TRUE(met({{{3, 1, 1}, 0.0, false, false, {}}, {{3, 1, 1}, 0.0, false, false, {}}}, {1, 1}));
  EXPECT_EQ(found_.finding, Finding::kNone);
  EXPECT_EQ(found_.via, -1);
}

TEST_F(ProveVias, FindsAMiss) {
  EXPECT_FALSE(met({{{3, 1, 1}, 0.0, false, false, {}}, {{3, 4.3, 1}, 0.1, false, false, {}}}, {1, 2}));
  expect_missed(1, 0, -1, 0.2);
  EXPECT_FALSE(met({{{3, 1, 1 + 3e-9}, 0.0, false, false, {}}}, {1})) << "three nanometres";
  EXPECT_TRUE(met({{{3, 1, 1 + 5e-10}, 0.0, false, false, {}}}, {1})) << "half a nanometre";
}

TEST_F(ProveVias, FindsTheWrongOrderAndJointsThatAreNone) {
  const Via second{{3, 4, 1}, 0.0, false, false, {}};
  const Via first{{3, 1, 1}, 0.0, false, false, {}};
  EXPECT_TRUE(met({first, second}, {1, 2}));
  EXPECT_FALSE(met({second, first}, {2, 1}));
  EXPECT_EQ(found_.via, 1);
  EXPECT_FALSE(met({second}, {3}));
  EXPECT_FALSE(met({first}, {-1}));
  EXPECT_EQ(found_.finding, Finding::kVia);
}

TEST_F(ProveVias, FindsMotionAtAStop) {
  glide();
  EXPECT_TRUE(met({{{3, 1, 1}, 0.0, false, false, {}}}, {1}));
  EXPECT_FALSE(met({{{3, 1, 1}, 0.0, true, false, {}}}, {1}));
  expect_missed(0, 1, 0, 1.0);
}

TEST_F(ProveVias, FindsADwellThatIsShortOrMoves) {
  const Via via{{3, 1, 1}, 0.0, true, false, {}, 3.0};
  EXPECT_FALSE(met({via}, {1})) << "it goes on at once";
  plan_.segments[plan_.count++] = plan_.segments[1];
  rest({2.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 1);
  EXPECT_FALSE(met({via}, {1}));
  expect_missed(0, 0, -1, 1.0);
  plan_.segments[1].duration = 3.0;
  EXPECT_TRUE(met({via}, {1}));
  plan_.segments[1].points[4].x += 1e-6;  // there and back, at rest at both ends
  EXPECT_FALSE(met({via}, {1}));
  expect_missed(0, 0, -1, 1e-6);
  EXPECT_FALSE(met({{{3, 4, 1}, 0.0, true, false, {}, 1.0}}, {3})) << "no segment is left";
}

TEST_F(ProveVias, FindsAccelerationAtAStop) {
  plan_.segments[1].points[2] = {2.0, 0.042, 0.0};  // 42 / T^2 times as much
  EXPECT_FALSE(met({{{3, 1, 1}, 0.0, true, false, {}}}, {1}));
  expect_missed(0, 2, 1, 42.0 * 0.042 / 4.0);
}

TEST_F(ProveVias, FindsJerkAtAStop) {
  plan_.segments[1].points[3] = {2.0, 0.0, -0.021};  // 210 / T^3 times as much
  EXPECT_FALSE(met({{{3, 1, 1}, 0.0, true, false, {}}}, {1}));
  expect_missed(0, 3, 2, 210.0 * 0.021 / 8.0);
}

TEST_F(ProveVias, FindsAnotherVelocity) {
  glide();
  EXPECT_TRUE(met({{{3, 1, 1}, 0.0, false, true, {1.0, 0.0, 0.0}}}, {1}));
  EXPECT_FALSE(met({{{3, 1, 1}, 0.0, false, true, {1.0, 0.25, 0.0}}}, {1}));
  expect_missed(0, 1, 1, 0.25);
}

}  // namespace
}  // namespace tern_test
