// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random missions in random rooms, by dense sampling: every via is passed in order and as near as asked, the plan keeps
// the limits and the radius, and what the map connects has a plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/math.hpp"
#include "support/random.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::Sample;
using tern::Status;
using tern::Vec3;
using tern::Via;

constexpr int kSamples = 20000;

/// A room of 8 x 8 x 3 m with boxes in it, the boxes' corners on the lattice.
struct Room {
  World world;
  std::vector<Box> boxes;

  explicit Room(Random& random) : world({80, 80, 30}, 0.1, 0.25, {-3.0, 7.0, 0.5}) {
    for (int k = random.integer(0, 10); k > 0; --k) {
      const Vec3 low{0.1 * random.integer(0, 75), 0.1 * random.integer(0, 75), 0.1 * random.integer(0, 20)};
      const Vec3 size{0.1 * random.integer(1, 20), 0.1 * random.integer(1, 20), 0.1 * random.integer(1, 30)};
      add({low, low + size});
    }
    world.grid.inflate();
  }
  void add(const Box& box) {
    const Vec3& o = world.spec.origin;
    // A hair smaller, lest rounding mark the voxels beside it.
    const Vec3 hair{1e-6, 1e-6, 1e-6};
    world.block(box.lower + hair, box.upper - hair);
    boxes.push_back({box.lower + o, box.upper + o});
  }
  double clearance(const Vec3& p) const {
    double least = 1e300;
    for (const Box& box : boxes) {
      Vec3 gap{};
      for (int a = 0; a < 3; ++a) {
        const double below = tern::axis(box.lower, a) - tern::axis(p, a);
        const double above = tern::axis(p, a) - tern::axis(box.upper, a);
        tern::axis(gap, a) = std::max({0.0, below, above});
      }
      least = std::min(least, tern::length(gap));
    }
    return least;
  }
  /// A point that keeps the radius, anywhere.
  Vec3 point(Random& random) const {
    Vec3 p{};
    do {
      p = world.spec.origin + Vec3{random.real(0.0, 8.0), random.real(0.0, 8.0), random.real(0.0, 3.0)};
    } while (clearance(p) < world.spec.radius + 0.2);  // in free voxels
    return p;
  }
};

std::vector<Via> random_vias(Random& random, const Room& room) {
  std::vector<Via> vias;
  for (int k = random.integer(1, 6); k > 0; --k) {
    Via via;
    via.position = room.point(random);
    if (random.chance(0.5)) via.tolerance = random.real(0.0, 0.8);
    via.stop = random.chance(0.15);
    vias.push_back(via);
  }
  return vias;
}

/// The first sample from `from` on that is near enough to the via, but for half a sample's way; -1 if none is.
int first_near(const tern::Trajectory& plan, const Via& via, int from, double way) {
  const double end = tern::duration(plan);
  for (int k = from; k <= kSamples; ++k) {
    const Sample sample = tern::evaluate(plan, end * k / kSamples);
    if (tern::distance(sample.position, via.position) <= via.tolerance + way) return k;
  }
  return -1;
}

void expect_order(const tern::Trajectory& plan, const std::vector<Via>& vias) {
  const double way = std::sqrt(3.0) * 2.0 * tern::duration(plan) / kSamples;  // between two samples, at the limits
  int from = 0;
  for (std::size_t v = 0; v < vias.size(); ++v) {
    from = first_near(plan, vias[v], from, way);
    ASSERT_GE(from, 0) << "via " << v;
  }
}

void expect_limits_and_clearance(const Room& room) {
  const tern::Trajectory& plan = room.world.trajectory;
  const double end = tern::duration(plan);
  for (int k = 0; k < kSamples; k += 10) {
    const Sample sample = tern::evaluate(plan, end * k / kSamples);
    for (int a = 0; a < 3; ++a) {
      ASSERT_LE(std::fabs(tern::axis(sample.velocity, a)), 2.0 * (1.0 + 4e-8));
      ASSERT_LE(std::fabs(tern::axis(sample.acceleration, a)), 2.0 * (1.0 + 4e-8));
    }
    ASSERT_GE(room.clearance(sample.position), room.world.spec.radius - 1e-8);
  }
}

void expect_passages(const World& world, const std::vector<Via>& vias) {
  double last = 0.0;
  for (std::size_t v = 0; v < vias.size(); ++v) {
    const tern::ViaPassage& passage = world.report.vias[v];
    const Sample sample = tern::evaluate(world.trajectory, passage.time);
    ASSERT_GE(passage.time, last);
    ASSERT_NEAR(tern::distance(sample.position, vias[v].position), passage.distance, 1e-9);
    ASSERT_LE(passage.distance, vias[v].tolerance + 1e-9);
    if (vias[v].stop) {
      ASSERT_LE(tern::length(sample.velocity), 1e-8);
    }
    last = passage.time;
  }
}

/// Whether each leg alone has a plan.
bool legs_connect(World& world, const std::vector<Via>& vias) {
  const tern::Request asked = world.request;
  world.request.vias = nullptr;
  world.request.via_count = 0;
  bool all = true;
  for (std::size_t leg = 0; leg <= vias.size() && all; ++leg) {
    world.request.start.position = leg == 0 ? asked.start.position : vias[leg - 1].position;
    world.request.goal.position = leg == vias.size() ? asked.goal.position : vias[leg].position;
    all = world.replan() == Status::kOk;
  }
  world.request = asked;
  return all;
}

TEST(ViasPlans, PassEveryViaInOrderWithinLimitsAndClearOfObstacles) {
  Random random(1811);
  int planned = 0;
  int missions = 0;
  for (int i = 0; i < scaled(60); ++i) {
    Room room(random);
    World& world = room.world;
    world.request.start.position = room.point(random);
    world.request.goal.position = room.point(random);
    if (random.chance(0.3)) world.request.time_weight = 1000.0;
    const std::vector<Via> vias = random_vias(random, room);
    world.request.vias = vias.data();
    world.request.via_count = static_cast<std::int32_t>(vias.size());
    ++missions;
    if (world.replan() != Status::kOk) {
      const bool full = world.report.status == Status::kSegmentsFull;
      EXPECT_TRUE(full || !legs_connect(world, vias)) << tern::status_name(world.report.status);
      continue;
    }
    ++planned;
    expect_passages(world, vias);
    expect_order(world.trajectory, vias);
    expect_limits_and_clearance(room);
    if (HasFatalFailure()) FAIL() << "mission " << i;
  }
  EXPECT_GE(10 * planned, 8 * missions) << "most rooms connect their points";
}

}  // namespace
}  // namespace tern_test
