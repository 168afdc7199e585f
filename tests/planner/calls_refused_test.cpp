// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults of use and of the platform: F15 to F21.
#include <gtest/gtest.h>

#include <cfenv>
#include <cstring>
#include <vector>

#include "support/random.hpp"
#include "support/world.hpp"

namespace {

using tern::Field;
using tern::Status;
using tern_test::World;

World walled_world() {
  World world({40, 40, 20}, 0.1, 0.15);
  world.block({1.5, 0.0, 0.0}, {1.7, 2.8, 2.0}).block({2.6, 1.2, 0.0}, {2.8, 4.0, 2.0});
  world.from({0.55, 0.55, 1.05}).to({3.45, 3.45, 1.05});
  world.grid.inflate();
  return world;
}

bool same_bits(const tern::Trajectory& a, const tern::Trajectory& b) {
  if (a.count != b.count) return false;
  for (int i = 0; i < a.count; ++i) {
    if (std::memcmp(&a.segments[i].duration, &b.segments[i].duration, sizeof(double)) != 0) return false;
    if (std::memcmp(a.segments[i].points, b.segments[i].points, sizeof a.segments[i].points) != 0) return false;
    if (a.segments[i].polyhedron != b.segments[i].polyhedron) return false;
  }
  return true;
}

Status run_in_slices(World& world, std::uint32_t slice) {
  Status status = world.planner.begin(world.grid, world.request);
  for (int i = 0; i < 10000000 && status == Status::kRunning; ++i) status = world.planner.step(slice);
  return world.planner.finish(world.trajectory, world.report);
}

TEST(CallFault, SlicesGiveTheSameBits) {  // C3, F16
  World whole = walled_world();
  ASSERT_EQ(whole.replan(), Status::kOk);
  for (const std::uint32_t slice : {1u, 2u, 3u, 7u, 50u, 1000u}) {
    World sliced = walled_world();
    ASSERT_EQ(run_in_slices(sliced, slice), Status::kOk);
    EXPECT_TRUE(same_bits(whole.trajectory, sliced.trajectory)) << slice;
    for (int s = 0; s < tern::kStageCount; ++s)
      EXPECT_EQ(whole.report.diagnostics.stages[s].work, sliced.report.diagnostics.stages[s].work);
  }
}

TEST(CallFault, SliceOfNothingMakesNoProgress) {  // F16
  World world = walled_world();
  ASSERT_EQ(world.planner.begin(world.grid, world.request), Status::kRunning);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(world.planner.step(0), Status::kRunning);
  EXPECT_EQ(world.planner.step(0xFFFFFFFFu) == Status::kInvalidArgument, false);
}

/// Plans with one budget field at every value up to what the plan needs, in one slice and in many: short of it, the
/// answer is `expired`; from some value on, it is the plan.
void expect_every_budget(std::uint32_t tern::Budget::*field, tern::Stage stage, Status expired) {
  World reference = walled_world();
  ASSERT_EQ(reference.replan(), Status::kOk);
  const auto need = static_cast<std::uint32_t>(reference.report.diagnostics.stages[static_cast<int>(stage)].work);
  ASSERT_GT(need, 0u);
  bool suffices = false;
  const std::uint32_t stride = need > 400 ? need / 200 : 1;
  for (std::uint32_t k = 0; k <= need; k += (k + stride > need && k < need) ? need - k : stride) {
    World world = walled_world();
    world.request.budget.*field = k;
    const Status status = world.replan();
    EXPECT_LE(world.report.diagnostics.stages[static_cast<int>(stage)].work,
              world.report.diagnostics.stages[static_cast<int>(stage)].bound);
    if (status == Status::kOk) {
      EXPECT_TRUE(same_bits(world.trajectory, reference.trajectory)) << k;
    } else {
      EXPECT_EQ(status, expired) << k;
      EXPECT_EQ(world.report.stage, stage);
      EXPECT_TRUE(world.trajectory_untouched());
    }
    EXPECT_TRUE(status == Status::kOk || !suffices) << k;
    suffices = status == Status::kOk;
    World sliced = walled_world();
    sliced.request.budget.*field = k;
    Status answer = sliced.planner.begin(sliced.grid, sliced.request);
    while (answer == Status::kRunning) answer = sliced.planner.step(1);
    EXPECT_EQ(answer, status) << k;
    EXPECT_EQ(sliced.planner.finish(sliced.trajectory, sliced.report), status);
    EXPECT_EQ(sliced.report.diagnostics.stages[static_cast<int>(stage)].work,
              world.report.diagnostics.stages[static_cast<int>(stage)].work)
        << k;
  }
  EXPECT_TRUE(suffices);
}

TEST(CallFault, EverySearchBudget) {  // F17
  expect_every_budget(&tern::Budget::search, tern::Stage::kSearch, Status::kBudgetSearch);
}
TEST(CallFault, EveryShortcutBudget) {  // F17
  expect_every_budget(&tern::Budget::shortcut, tern::Stage::kShortcut, Status::kBudgetShortcut);
}
TEST(CallFault, EveryCorridorBudget) {  // F17
  expect_every_budget(&tern::Budget::corridor, tern::Stage::kCorridor, Status::kBudgetCorridor);
}

TEST(CallFault, EveryTrajectoryBudgetStillFlies) {  // F17, C6
  World reference = walled_world();
  ASSERT_EQ(reference.replan(), Status::kOk);
  ASSERT_EQ(reference.report.quality, tern::Quality::kOptimised);
  const auto need =
      static_cast<std::uint32_t>(reference.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work);
  const std::uint32_t stride = need / 100 + 1;
  for (std::uint32_t k = 0; k < need + stride; k += stride) {
    World world = walled_world();
    world.request.budget.trajectory = k;
    ASSERT_EQ(world.replan(), Status::kOk) << k;
    if (world.report.optimiser == Status::kOk) {
      EXPECT_EQ(world.report.quality, tern::Quality::kOptimised);
    } else {
      EXPECT_EQ(world.report.optimiser, Status::kBudgetOptimise);
    }
    if (k == 0) {
      EXPECT_EQ(world.report.quality, tern::Quality::kStopAndGo);
    }
    if (k >= need) {
      EXPECT_TRUE(same_bits(world.trajectory, reference.trajectory));
    }
  }
}

struct FakeClock {
  enum Kind { kFrozen, kBackwards, kWrapping, kJumping } kind;
  std::uint64_t value;
};

std::uint64_t fake_ticks(void* context) {
  auto& clock = *static_cast<FakeClock*>(context);
  switch (clock.kind) {
    case FakeClock::kFrozen:
      break;
    case FakeClock::kBackwards:
      clock.value -= 3;
      break;
    case FakeClock::kWrapping:
      clock.value += 0x4000000000000001u;
      break;
    case FakeClock::kJumping:
      clock.value += (clock.value & 1) != 0 ? 1 : 0x1000000001u;
      break;
  }
  return clock.value;
}

TEST(CallFault, ClockChangesNothing) {  // F18
  World reference = walled_world();
  ASSERT_EQ(reference.replan(), Status::kOk);
  EXPECT_FALSE(reference.report.diagnostics.timing_known);
  for (const auto kind : {FakeClock::kFrozen, FakeClock::kBackwards, FakeClock::kWrapping, FakeClock::kJumping}) {
    World world = walled_world();
    FakeClock clock{kind, 1000};
    world.planner.set_clock(&fake_ticks, &clock);
    ASSERT_EQ(world.replan(), Status::kOk);
    EXPECT_TRUE(same_bits(world.trajectory, reference.trajectory));
    if (kind != FakeClock::kJumping) {
      EXPECT_FALSE(world.report.diagnostics.timing_known) << kind;
    }
    if (!world.report.diagnostics.timing_known) {
      for (const tern::StageReport& stage : world.report.diagnostics.stages) EXPECT_EQ(stage.ticks, 0u);
    }
  }
}

TEST(CallFault, MapChangedBetweenSlices) {  // F19
  World world = walled_world();
  ASSERT_EQ(world.planner.begin(world.grid, world.request), Status::kRunning);
  ASSERT_EQ(world.planner.step(1), Status::kRunning);
  world.block({3.0, 0.2, 0.0}, {3.2, 0.4, 1.0});
  EXPECT_EQ(world.planner.step(1), Status::kMapChanged);
  std::memset(static_cast<void*>(&world.trajectory), 0x5A, sizeof world.trajectory);
  EXPECT_EQ(world.planner.finish(world.trajectory, world.report), Status::kMapChanged);
  EXPECT_TRUE(world.trajectory_untouched());
  world.grid.inflate();
  EXPECT_EQ(world.replan(), Status::kOk);
}

TEST(CallFault, CallsOutOfOrder) {  // F20
  World world = walled_world();
  EXPECT_EQ(world.planner.step(10), Status::kInvalidArgument);
  EXPECT_EQ(world.planner.finish(world.trajectory, world.report), Status::kInvalidArgument);
  EXPECT_EQ(world.report.field, Field::kCallOrder);
  ASSERT_EQ(world.planner.begin(world.grid, world.request), Status::kRunning);
  EXPECT_EQ(world.planner.finish(world.trajectory, world.report), Status::kInvalidArgument);  // unfinished
  EXPECT_EQ(world.report.field, Field::kCallOrder);
  EXPECT_EQ(world.planner.step(10), Status::kInvalidArgument);
  EXPECT_EQ(world.replan(), Status::kOk);  // usable again at once
  EXPECT_NE(world.planner.path(), nullptr);
  EXPECT_NE(world.planner.corridor(), nullptr);
}

TEST(CallFault, TwoPlannersInterleaved) {  // F20
  World alone = walled_world();
  ASSERT_EQ(alone.replan(), Status::kOk);
  World a = walled_world();
  World b = walled_world();
  ASSERT_EQ(a.planner.begin(a.grid, a.request), Status::kRunning);
  ASSERT_EQ(b.planner.begin(b.grid, b.request), Status::kRunning);
  Status sa = Status::kRunning;
  Status sb = Status::kRunning;
  for (int i = 0; i < 1000000 && (sa == Status::kRunning || sb == Status::kRunning); ++i) {
    if (sa == Status::kRunning) sa = a.planner.step(3);
    if (sb == Status::kRunning) sb = b.planner.step(5);
  }
  ASSERT_EQ(a.planner.finish(a.trajectory, a.report), Status::kOk);
  ASSERT_EQ(b.planner.finish(b.trajectory, b.report), Status::kOk);
  EXPECT_TRUE(same_bits(a.trajectory, alone.trajectory));
  EXPECT_TRUE(same_bits(b.trajectory, alone.trajectory));
}

TEST(CallFault, ReuseAfterAnError) {  // F20
  World world = walled_world();
  ASSERT_EQ(world.replan(), Status::kOk);
  const tern::Trajectory first = world.trajectory;
  world.request.goal.position.x = 1e9;
  EXPECT_EQ(world.replan(), Status::kOutOfMap);
  EXPECT_EQ(world.planner.path(), nullptr);
  EXPECT_EQ(world.planner.corridor(), nullptr);
  world.request.goal.position.x = 3.45;
  ASSERT_EQ(world.replan(), Status::kOk);
  EXPECT_TRUE(same_bits(first, world.trajectory));
}

TEST(CallFault, WorkspaceOfAnyContentAndAlignment) {  // F21
  World reference = walled_world();
  ASSERT_EQ(reference.replan(), Status::kOk);
  std::vector<unsigned char> block(tern::kWorkspaceBytes + 64);
  tern_test::Random random(21);
  for (int variant = 0; variant < 4; ++variant) {
    for (unsigned char& byte : block) {
      byte = variant == 0   ? 0xA5
             : variant == 1 ? 0xFF
             : variant == 2 ? 0x00
                            : static_cast<unsigned char>(random.next());
    }
    World world = walled_world();
    tern::Planner planner(block.data() + 1 + variant, tern::kWorkspaceBytes);
    ASSERT_EQ(planner.plan(world.grid, world.request, world.trajectory, world.report), Status::kOk) << variant;
    EXPECT_TRUE(same_bits(reference.trajectory, world.trajectory)) << variant;
  }
}

TEST(CallFault, WorkspaceTooSmall) {  // F02
  World world = walled_world();
  tern::Planner none(nullptr, tern::kWorkspaceBytes);
  EXPECT_EQ(none.finish(world.trajectory, world.report), Status::kInvalidArgument);
  EXPECT_EQ(world.report.field, Field::kCallOrder);
  EXPECT_EQ(none.plan(world.grid, world.request, world.trajectory, world.report), Status::kInvalidArgument);
  EXPECT_EQ(world.report.field, Field::kWorkspace);
  tern::Planner small(world.memory.get(), tern::kWorkspaceBytes - 1);
  EXPECT_EQ(small.plan(world.grid, world.request, world.trajectory, world.report), Status::kInvalidArgument);
}

TEST(SelfTest, HealthyMachine) {  // F15
  std::uint32_t faults = 99;
  EXPECT_EQ(tern::self_test(tern::configuration_hash(), &faults), Status::kOk);
  EXPECT_EQ(faults, 0u);
}

TEST(SelfTest, ConfigurationMismatch) {  // F15
  std::uint32_t faults = 0;
  EXPECT_EQ(tern::self_test(tern::configuration_hash() ^ 1, &faults), Status::kSelfTestFailed);
  EXPECT_EQ(faults, static_cast<std::uint32_t>(tern::kFaultConfiguration));
}

TEST(SelfTest, RoundingModes) {  // F15
  for (const int mode : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    std::uint32_t faults = 0;
    const Status status = tern::self_test(tern::configuration_hash(), &faults);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(status, Status::kSelfTestFailed) << mode;
    EXPECT_TRUE((faults & tern::kFaultRoundingMode) != 0) << mode;
  }
}

}  // namespace
