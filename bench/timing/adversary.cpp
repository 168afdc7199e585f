// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An adversary: a seeded evolution of small worlds in which one stage takes as many instructions as it can be made to.
// Arguments: the stage's name and the number of rounds. Prints its progress and the worst world as a scenario file.
//
// Worlds live on a lattice of 0.1 m, in integers, so that the decimals printed are the doubles that were planned with.
#include <cstdint>

#include "baremetal/board.hpp"
#include "support/random.hpp"
#include "timing/case_grid.hpp"

namespace {

using tern_board::print;
using tern_test::Random;

constexpr int kMaxStrips = 96;
constexpr int kFirstBlocks = 30;
constexpr int kParents = 4;
constexpr int kFirstWorlds = 16;
constexpr int kSizes[3] = {120, 120, 30};
/// A find must not stand at a capacity's edge, where the next change of the planner turns its plan into an overflow.
constexpr int kMostSegments = 40;
/// What one case may take in the gate, in instructions of the whole plan.
constexpr std::uint64_t kMostInstructions = 1200u * 1000u * 1000u;

struct Triple {
  int v[3];
};
struct Cuboid {
  Triple lower;
  Triple upper;
};
/// A scenario in tenths of a metre.
struct World {
  int count;
  Cuboid blocks[kMaxStrips];
  Triple start;
  Triple goal;
  int resolution;  // 1 or 2
  int radius;      // 0 .. 4
  std::uint64_t score;
};

TERN_BOARD_LARGE tern::Workspace workspace;
TERN_BOARD_LARGE std::uint64_t words[2 * 1024 * 1024 / 64];
tern::Trajectory trajectory;
tern::Box boxes[kMaxStrips];
World parents[kParents];

tern::Vec3 metres(const Triple& t) {
  return {t.v[0] / 10.0, t.v[1] / 10.0, t.v[2] / 10.0};
}

Triple random_point(Random& random) {
  Triple point;
  for (int a = 0; a < 3; ++a) point.v[a] = random.integer(5, kSizes[a] - 5);
  return point;
}

/// A pillar, a wall, a beam or a stone.
Cuboid random_cuboid(Random& random) {
  const int kind = random.integer(0, 3);
  Cuboid cuboid;
  for (int a = 0; a < 3; ++a) {
    const bool full = kind < 2 && a == 2;
    const bool longer = (kind == 1 || kind == 2) && a == random.integer(0, 1);
    const int length = full ? kSizes[a] : random.integer(1, longer ? kSizes[a] * 9 / 10 : 8);
    cuboid.lower.v[a] = full ? 0 : random.integer(0, kSizes[a] - length);
    cuboid.upper.v[a] = cuboid.lower.v[a] + length;
  }
  return cuboid;
}

World random_world(Random& random) {
  World world{};
  world.count = kFirstBlocks;
  for (int i = 0; i < world.count; ++i) world.blocks[i] = random_cuboid(random);
  world.start = {{8, 8, 10}};
  world.goal = {{kSizes[0] - 8, kSizes[1] - 8, 20}};
  world.resolution = 1;
  world.radius = random.integer(0, 3);
  return world;
}

void shift(Random& random, Cuboid& cuboid) {
  const int a = random.integer(0, 2);
  const int room = kSizes[a] - cuboid.upper.v[a];
  const int most = cuboid.lower.v[a] < 10 ? cuboid.lower.v[a] : 10;
  const int step = random.integer(-most, room < 10 ? room : 10);
  cuboid.lower.v[a] += step;
  cuboid.upper.v[a] += step;
}

void mutate(Random& random, World& world) {
  const int kind = random.integer(0, 19);
  const int block = world.count > 0 ? random.integer(0, world.count - 1) : 0;
  if (kind == 0) world.start = random_point(random);
  if (kind == 1) world.goal = random_point(random);
  if (kind == 2) world.radius = random.integer(0, 4);
  if (kind == 3) world.resolution = random.integer(1, 2);
  if (kind >= 4 && kind < 10 && world.count < kMaxStrips) world.blocks[world.count++] = random_cuboid(random);
  if (kind >= 10 && kind < 12 && world.count > 0) world.blocks[block] = world.blocks[--world.count];
  if (kind >= 12 && kind < 17 && world.count > 0) shift(random, world.blocks[block]);
  if (kind >= 17 && world.count > 0) world.blocks[block] = random_cuboid(random);
}

tern_timing::Case case_of(const World& world) {
  tern_timing::Case input{};
  for (int i = 0; i < world.count; ++i) boxes[i] = {metres(world.blocks[i].lower), metres(world.blocks[i].upper)};
  input.boundary.upper = metres({{kSizes[0], kSizes[1], kSizes[2]}});
  input.resolution = world.resolution / 10.0;
  input.radius = world.radius / 10.0;
  input.blocks = boxes;
  input.block_count = world.count;
  input.request.start.position = metres(world.start);
  input.request.goal.position = metres(world.goal);
  input.request.limits.v_max = input.request.limits.a_max = {2.0, 2.0, 2.0};
  return input;
}

/// The stage's instructions; 0 where the world has no plan, or none that the corpus wants. Stage 0 is inflation.
std::uint64_t score_of(const World& world, int stage, tern::Planner& planner) {
  const tern_timing::Case input = case_of(world);
  tern::Grid grid;
  if (grid.bind(tern_timing::spec_of(input), words, sizeof words / sizeof words[0]) != tern::Status::kOk) return 0;
  for (int i = 0; i < input.block_count; ++i) grid.mark_box(boxes[i]);
  const std::uint64_t begin = tern_board::counter();
  grid.inflate();
  const std::uint64_t inflated = tern_board::counter();
  tern::Report report;
  const tern::Status status = planner.plan(grid, input.request, trajectory, report);
  const std::uint64_t planned = tern_board::counter() - inflated;
  if (status != tern::Status::kOk || report.diagnostics.high_water.segments > kMostSegments) return 0;
  if (planned > kMostInstructions) return 0;
  return stage == 0 ? inflated - begin : report.diagnostics.stages[stage].ticks;
}

/// Takes the place of the parent with the lowest score, if it has a higher one.
bool settle(const World& world) {
  World* least = &parents[0];
  for (World& parent : parents) {
    if (parent.score < least->score) least = &parent;
  }
  if (world.score <= least->score) return false;
  *least = world;
  return true;
}

const World& worst() {
  const World* most = &parents[0];
  for (const World& parent : parents) {
    if (parent.score > most->score) most = &parent;
  }
  return *most;
}

void evolve(int stage, int rounds, tern::Planner& planner) {
  Random random(static_cast<std::uint64_t>(stage) + 1);
  for (int round = 0; round < rounds; ++round) {
    const bool fresh = round < kFirstWorlds;
    World world = fresh ? random_world(random) : parents[random.integer(0, kParents - 1)];
    for (int left = fresh ? 0 : random.integer(1, 4); left > 0; --left) mutate(random, world);
    world.score = score_of(world, stage, planner);
    if (settle(world) && worst().score == world.score) {
      print("# round ", round, ": ", world.score, " instructions, ", world.count, " blocks\n");
    }
  }
}

void put_tenths(const Triple& t) {
  for (const int v : t.v) print(" ", v / 10, ".", v % 10);
}

void put_scenario(const World& world, const char* stage) {
  print("# what an adversary found for the stage ", stage, "; written by adversaries.py\nboundary 0.0 0.0 0.0");
  put_tenths({{kSizes[0], kSizes[1], kSizes[2]}});
  for (int i = 0; i < world.count; ++i) {
    print("\nblock");
    put_tenths(world.blocks[i].lower);
    put_tenths(world.blocks[i].upper);
  }
  print("\nstart");
  put_tenths(world.start);
  print("\ngoal");
  put_tenths(world.goal);
  print("\nresolution 0.", world.resolution, "\nradius 0.", world.radius, "\nv_max 2\na_max 2\n");
}

bool equal(const char* a, const char* b) {
  for (; *a == *b; ++a, ++b) {
    if (*a == '\0') return true;
  }
  return false;
}

/// The index of a stage by its name, 0 for "inflate"; -1 for none.
int stage_named(const char* name) {
  if (equal(name, "inflate")) return 0;
  for (int s = 1; s < tern::kStageCount; ++s) {
    if (equal(name, tern::stage_name(static_cast<tern::Stage>(s)))) return s;
  }
  return -1;
}

int number(const char* text) {
  int value = 0;
  for (; *text >= '0' && *text <= '9'; ++text) value = 10 * value + (*text - '0');
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2) {
    // QEMU puts the image's own name first.
    const char* name = argv[argc - 2];
    const int stage = stage_named(name);
    tern::Planner planner(&workspace, sizeof workspace);
    planner.set_clock([](void*) { return tern_board::counter(); }, nullptr);
    if (stage >= 0) {
      evolve(stage, number(argv[argc - 1]), planner);
      if (worst().score > 0) {
        put_scenario(worst(), name);
        return 0;
      }
    }
  }
  print("usage: STAGE ROUNDS\n");
  return 2;
}
