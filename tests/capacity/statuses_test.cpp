// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every status is reached: a table of all of them, each with the smallest case that leads there. A status without a
// case fails. Capacities that a plan runs out of have cases of their own in exceeded_test.cpp; here, one of each is
// enough.
#include <gtest/gtest.h>

#include <cfenv>
#include <functional>
#include <limits>
#include <memory>

#include "capacity/cases.hpp"
#include "corridor/grow.hpp"
#include "planner/layout.hpp"
#include "support/at_once.hpp"
#include "support/owned_map.hpp"
#include "support/qp_dense.hpp"
#include "support/world.hpp"
#include "tern/record.hpp"
#include "tern/self_test.hpp"

namespace tern_capacity {
namespace {

using tern::Status;
using tern::Vec3;
using tern_test::open_world;
using tern_test::World;

struct Case {
  Status status;
  std::function<Status()> reach;
};

/// The answer to a plan in an open room, after a change.
Status plan_after(const std::function<void(World&)>& change) {
  World world = open_world();
  change(world);
  return world.plan();
}

Status plan_with_via(const tern::Via& via, const std::function<void(World&)>& change = {}) {
  World world = open_world();
  if (change) change(world);
  world.request.vias = &via;
  world.request.via_count = 1;
  return world.plan();
}

/// A keep-out box around a point; reversed where its size is negative.
Status plan_fenced(const Vec3& point, const tern::Via* via = nullptr, double size = 0.3) {
  World world = open_world();
  tern::Halfspace faces[tern::kBoxPlanes];
  const Vec3 reach{size, size, size};
  tern::box_planes({point - reach, point + reach}, faces);
  const tern::Fence fence{faces, tern::kBoxPlanes, tern::FenceKind::kKeepOut};
  world.request.fences = &fence;
  world.request.fence_count = 1;
  world.request.vias = via;
  world.request.via_count = via == nullptr ? 0 : 1;
  return world.plan();
}

/// A ball that stands for ever.
Status plan_among(const Vec3& place, double radius) {
  World world = open_world();
  tern::Track track;
  track.position = place;
  track.radius = radius;
  world.request.tracks = &track;
  world.request.track_count = 1;
  return world.plan();
}

/// A shaft around x = y = 1 in a solid corner, so narrow that none of its voxels keeps the radius; its middle does.
Status plan_in_shaft(const Vec3& from, const Vec3& to, const tern::Via* via = nullptr) {
  World world({40, 40, 20}, 0.1, 0.19);
  world.block({0.0, 0.0, 0.0}, {0.8, 2.0, 2.0}).block({1.2, 0.0, 0.0}, {2.0, 2.0, 2.0});
  world.block({0.8, 0.0, 0.0}, {1.2, 0.8, 2.0}).block({0.8, 1.2, 0.0}, {1.2, 2.0, 2.0});
  world.from(from).to(to);
  world.request.vias = via;
  world.request.via_count = via == nullptr ? 0 : 1;
  return world.plan();
}

/// A wall through a small room.
Status plan_behind_wall() {
  World world({20, 10, 1}, 0.1, 0.0);
  world.block({0.9, 0.0, 0.0}, {1.0, 1.0, 0.1}).from({0.25, 0.25, 0.05}).to({1.75, 0.75, 0.05});
  return world.plan();
}

Status optimiser_at_wall() {
  World world = open_world();
  world.block({0.9, 0.0, 0.0}, {1.0, 4.0, 1.9}).from({0.55, 2.0, 1.05}).to({0.55, 3.0, 1.05});
  world.request.start.velocity = {2.0, 0.0, 0.0};
  world.plan();
  return world.report.optimiser;
}

Status no_trajectory() {
  World world = open_world();
  world.block({0.9, 0.0, 0.0}, {1.0, 4.0, 1.9}).from({0.55, 2.0, 1.05}).to({0.55, 3.0, 1.05});
  world.request.start.velocity = {2.0, 0.0, 0.0};
  return world.plan();
}

Status map_changed() {
  World world = open_world();
  world.grid.inflate();
  Status status = world.planner.begin(world.grid, world.request);
  if (status != Status::kRunning) return status;
  world.grid.mark_voxel({1, 1, 1});
  return world.planner.step(1);
}

/// An obstacle in a line that a corridor is to hold: the path's stages leave none there.
Status grow_through_obstacle() {
  World world = open_world();
  world.block({1.5, 1.5, 0.5}, {1.6, 1.6, 1.5}).grid.inflate();
  const auto scratch = std::make_unique<tern::GrowScratch>();
  const auto polyhedron = std::make_unique<tern::Polyhedron>();
  tern::reset_counters(*scratch);
  return tern_test::grow_polyhedron(tern::World(world.grid), {1.0, 1.55, 1.0}, {2.0, 1.55, 1.0}, *scratch, *polyhedron);
}

/// The check looks at a plan that was spoilt in the workspace: no request is known that leads there.
Status check_failed() {
  World world = open_world();
  world.grid.inflate();
  world.request.budget.trajectory = 0;  // stop-and-go, which nothing can replace
  const auto address = reinterpret_cast<std::uintptr_t>(world.memory.get());
  const std::uintptr_t mask = tern::kWorkspaceAlignment - 1;
  auto& layout = *reinterpret_cast<tern::Layout*>((address + mask) & ~mask);
  Status status = world.planner.begin(world.grid, world.request);
  layout.trajectory.count = -1;
  while (status == Status::kRunning && layout.trajectory.count == -1) status = world.planner.step(1);
  layout.trajectory.segments[0].points[4].z += 100.0;
  while (status == Status::kRunning) status = world.planner.step(1);
  return world.planner.finish(world.trajectory, world.report);
}

Status numerical() {
  tern_test::QpBench bench;
  bench.start({1.0});
  bench.add_point({0.0, 0.0, 0.0}, 0, {1.0});
  bench.problem->hessian[0][0] = std::numeric_limits<double>::quiet_NaN();
  return bench.solve();
}

Status self_test_failed() {
  std::uint32_t faults = 0;
  return tern::self_test(tern::configuration_hash() ^ 1u, &faults);
}

/// `set_back`: a second one, a nanosecond before the first.
Status frame(const std::function<void(tern_test::Image&, tern::Pose&)>& change, bool set_back = false) {
  tern::MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 16, 16}, 0.2);
  spec.pixels = 1024;
  tern_test::OwnedMap owned(spec);
  tern_test::Image image(32, 32, 16.0);
  tern::Pose pose{{0.5, 0.8, 0.8}, {0.5, -0.5, 0.5, -0.5}};
  change(image, pose);
  const Status begun = owned.map.begin_frame(image.view, pose, 1000);
  if (!set_back) return begun;
  while (owned.map.step(100000) == Status::kRunning) {
  }
  return owned.map.begin_frame(image.view, pose, 999 - tern::kMaxFrameDelay);
}

std::vector<std::uint8_t> record() {
  World world = open_world();
  world.plan();
  std::vector<std::uint8_t> bytes(tern::plan_record_bytes(world.spec.dims));
  std::size_t used = 0;
  tern::record_plan(world.grid, world.request, world.report.status, world.trajectory, bytes.data(), bytes.size(),
                    &used);
  bytes.resize(used);
  return bytes;
}

Status read(const std::vector<std::uint8_t>& bytes) {
  const auto out = std::make_unique<tern::PlanRecord>();
  return tern::read_plan_record(bytes.data(), bytes.size(), *out);
}

Status read_altered(std::size_t byte) {
  std::vector<std::uint8_t> bytes = record();
  bytes[byte] = static_cast<std::uint8_t>(bytes[byte] ^ 0x10u);
  return read(bytes);
}

tern::Via via_at(const Vec3& position) {
  tern::Via via{};
  via.position = position;
  return via;
}

tern::Via fast_via() {
  tern::Via via = via_at({2.0, 2.0, 1.0});
  via.has_velocity = true;
  via.velocity = {9.0, 0.0, 0.0};
  return via;
}

const Vec3 kMiddle{2.05, 2.05, 1.05};

std::vector<Case> request_cases() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {
      {Status::kOk, [] { return plan_after([](World&) {}); }},
      {Status::kRunning,
       [] {
         World world = open_world();
         world.grid.inflate();
         return world.planner.begin(world.grid, world.request);
       }},
      {Status::kNonFiniteInput, [=] { return plan_after([=](World& w) { w.request.start.position.x = nan; }); }},
      {Status::kInvalidArgument, [] { return tern::Grid().bind({}, nullptr, 0); }},
      {Status::kLimitsInvalid, [] { return plan_after([](World& w) { w.request.limits.v_max.x = 0.0; }); }},
      {Status::kOutOfMap, [] { return plan_after([](World& w) {
                                 w.to({9.0, 1.0, 1.0});
                               }); }},
      {Status::kStartExceedsLimits, [] { return plan_after([](World& w) { w.request.start.velocity.x = 9.0; }); }},
      {Status::kGoalExceedsLimits, [] { return plan_after([](World& w) { w.request.goal.velocity.x = 9.0; }); }},
      {Status::kViaExceedsLimits, [] { return plan_with_via(fast_via()); }},
      {Status::kFenceEmpty, [] { return plan_fenced(kMiddle, nullptr, -0.3); }},
      {Status::kPoseInvalid, [] { return frame([](tern_test::Image&, tern::Pose& p) { p.quaternion[0] = 5.0; }); }},
      {Status::kCameraInvalid, [] { return frame([](tern_test::Image& i, tern::Pose&) { i.view.fx = 0.0; }); }},
      {Status::kRecordDamaged, [] { return read_altered(200); }},
      {Status::kRecordVersion, [] { return read_altered(8); }},
      {Status::kClockBehind, [] { return frame([](tern_test::Image&, tern::Pose&) {}, true); }},
  };
}

std::vector<Case> world_cases() {
  return {
      {Status::kStartOccupied, [] { return plan_after([](World& w) {
                                      w.block({0.4, 0.4, 0.9}, {0.7, 0.7, 1.2});
                                    }); }},
      {Status::kGoalOccupied, [] { return plan_after([](World& w) {
                                     w.block({3.3, 3.3, 0.9}, {3.6, 3.6, 1.2});
                                   }); }},
      {Status::kNoPath, plan_behind_wall},
      {Status::kMapChanged, map_changed},
      {Status::kCorridorBlocked, grow_through_obstacle},
      {Status::kNoTrajectory, no_trajectory},
      {Status::kStartTooNarrow,
       [] {
         return plan_in_shaft({1.0, 1.0, 1.0}, {3.0, 3.0, 1.0});
       }},
      {Status::kGoalTooNarrow,
       [] {
         return plan_in_shaft({3.0, 3.0, 1.0}, {1.0, 1.0, 1.0});
       }},
      {Status::kViaTooNarrow,
       [] {
         tern::Via via{};
         via.position = {1.0, 1.0, 1.0};
         return plan_in_shaft({3.0, 3.0, 1.0}, {3.0, 3.2, 1.0}, &via);
       }},
      {Status::kStartInContact, [] { return plan_among(open_world().request.start.position, 0.1); }},
      {Status::kGoalCovered, [] { return plan_among(open_world().request.goal.position, 0.1); }},
      {Status::kNoClearTime, [] { return plan_among(kMiddle, 1.7); }},
      {Status::kStartFenced, [] { return plan_fenced(open_world().request.start.position); }},
      {Status::kGoalFenced, [] { return plan_fenced(open_world().request.goal.position); }},
      {Status::kViaOccupied,
       [] { return plan_with_via(via_at(kMiddle), [](World& w) {
              w.block({1.9, 1.9, 0.9}, {2.2, 2.2, 1.2});
            }); }},
      {Status::kViaFenced,
       [] {
         const tern::Via via = via_at(kMiddle);
         return plan_fenced(kMiddle, &via);
       }},
  };
}

/// Those of a plan as exceeded_test.cpp has them, too, and what else has no room.
std::vector<Case> capacity_cases() {
  std::vector<Case> cases;
  for (const Exceeded& exceeded : exceeded_capacities()) {
    if (exceeded.status != Status::kOk) cases.push_back({exceeded.status, exceeded.beyond});
  }
  return cases;
}

std::vector<Case> other_cases() {
  return {
      {Status::kInfeasible, optimiser_at_wall},
      {Status::kNumerical, numerical},
      {Status::kCheckFailed, check_failed},
      {Status::kSelfTestFailed, self_test_failed},
  };
}

std::vector<Case> all_cases() {
  std::vector<Case> cases = request_cases();
  for (const auto& more : {world_cases(), capacity_cases(), other_cases()}) {
    cases.insert(cases.end(), more.begin(), more.end());
  }
  return cases;
}

/// Every number that has a name.
std::vector<Status> all_statuses() {
  std::vector<Status> statuses;
  for (int number = 0; number < 256; ++number) {
    const auto status = static_cast<Status>(number);
    if (std::string(tern::status_name(status)) != "unknown") statuses.push_back(status);
  }
  return statuses;
}

class EveryStatus : public testing::TestWithParam<Status> {};

TEST_P(EveryStatus, IsReached) {
  int found = 0;
  for (const Case& one : all_cases()) {
    if (one.status != GetParam()) continue;
    EXPECT_STREQ(tern::status_name(one.reach()), tern::status_name(GetParam()));
    ++found;
  }
  EXPECT_GT(found, 0) << "no case leads to " << tern::status_name(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Statuses, EveryStatus, testing::ValuesIn(all_statuses()),
                         [](const auto& test) { return std::string(tern::status_name(test.param)); });

}  // namespace
}  // namespace tern_capacity
