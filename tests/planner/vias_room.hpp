// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A room whose request passes vias.
#ifndef TERN_TESTS_PLANNER_VIAS_ROOM_HPP
#define TERN_TESTS_PLANNER_VIAS_ROOM_HPP

#include <gtest/gtest.h>

#include <vector>

#include "base/math.hpp"
#include "support/world.hpp"

namespace tern_test {

/// 8 x 4 x 2 m at 0.1 m, radius 0.25, away from the world's origin.
class ViasPlan : public testing::Test {
 protected:
  ViasPlan() : world_({80, 40, 20}, 0.1, 0.25, {10.0, -20.0, 5.0}) { world_.from({1.0, 1.0, 1.0}).to({7.0, 1.0, 1.0}); }
  tern::Vec3 at(const tern::Vec3& relative) const { return relative + world_.spec.origin; }
  tern::Via& via(const tern::Vec3& relative) {
    vias_.push_back({at(relative), 0.0, false, false, {}});
    return vias_.back();
  }
  tern::Status plan() {
    world_.request.vias = vias_.data();
    world_.request.via_count = static_cast<std::int32_t>(vias_.size());
    return world_.plan();
  }
  const tern::Report& report() const { return world_.report; }
  tern::Sample passage(std::size_t v) const { return tern::evaluate(world_.trajectory, report().vias[v].time); }
  static double speed(const tern::Sample& sample) { return tern::length(sample.velocity); }

  /// The report's distances are those of the trajectory, within the tolerances and in order.
  void expect_passes() {
    double last = 0.0;
    for (std::size_t v = 0; v < vias_.size(); ++v) {
      const tern::ViaPassage& passed = report().vias[v];
      EXPECT_GE(passed.time, last) << v;
      EXPECT_LE(passed.distance, vias_[v].tolerance + 1e-9) << v;
      EXPECT_NEAR(tern::distance(passage(v).position, vias_[v].position), passed.distance, 1e-9) << v;
      last = passed.time;
    }
    EXPECT_LE(last, tern::duration(world_.trajectory));
    EXPECT_EQ(report().via, tern::kNoVia);
    for (const tern::StageReport& stage : report().diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
  }
  void expect_refused(tern::Status status, int v) {
    EXPECT_EQ(plan(), status);
    EXPECT_EQ(report().field, tern::Field::kVias);
    EXPECT_EQ(report().stage, tern::Stage::kRequest);
    EXPECT_EQ(report().via, v);
    EXPECT_TRUE(world_.trajectory_untouched());
  }

  World world_;
  std::vector<tern::Via> vias_;
};

}  // namespace tern_test

#endif
