// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Worlds that change: boxes come and go through a grid and its copies, storage is bound anew, two worlds take turns,
// and one planner is kept through all of it. After each change it has to answer as a planner that finds the map new.
#include <cstdio>

#include "attack/attack_case.hpp"

namespace tern_attack {
namespace {

using tern::Status;

/// A box of voxels, upper corner excluded.
struct VoxelBox {
  int low[3];
  int high[3];
};
using VoxelBoxes = std::vector<VoxelBox>;

/// Through which view of a storage changes come.
enum class Through : int {
  kAny,       ///< the grid, an old copy of it, or a new one
  kNewCopy,   ///< always a copy made for the purpose, as where a grid is handed over by value
  kTwoViews,  ///< the grid or an old copy
};

struct Changing {
  World world;
  tern::Grid copy;     ///< an older view of the same storage
  VoxelBoxes sets[3];  ///< what comes and goes
  bool standing[3] = {};
  Through through = Through::kAny;
  bool wide = false;
  int last_set = -1;  ///< the set of the last frame
};

VoxelBoxes make_set(Rng& rng, const World& world, bool wide) {
  VoxelBoxes set(static_cast<std::size_t>(wide ? 12 : rng.integer(1, 8)));
  for (VoxelBox& box : set) {
    for (int a = 0; a < 3; ++a) {
      const int count = axis(world.spec.dims, a);
      box.low[a] = a == 2 ? 0 : rng.integer(0, count - 1);
      box.high[a] = std::min(count, box.low[a] + rng.integer(1, wide ? 20 : 1 + count / 4));
      if (a == 2 && (wide || rng.chance(0.7))) box.high[a] = count;
    }
  }
  return set;
}

/// Tells a view of the grid and the record alike.
void apply(World& world, tern::Grid& view, const VoxelBoxes& set, bool value) {
  const double cell = world.spec.cell;
  const tern::Vec3& o = world.spec.origin;
  for (const VoxelBox& b : set) {
    const tern::Box box{{o.x + b.low[0] * cell, o.y + b.low[1] * cell, o.z + b.low[2] * cell},
                        {o.x + b.high[0] * cell, o.y + b.high[1] * cell, o.z + b.high[2] * cell}};
    (void)(value ? view.mark_box(box) : view.clear_box(box));
    for (int z = b.low[2]; z < b.high[2]; ++z) {
      for (int y = b.low[1]; y < b.high[1]; ++y) {
        for (int x = b.low[0]; x < b.high[0]; ++x) world.set(x, y, z, value);
      }
    }
  }
}

bool begin_world(Context& context, Changing& c) {
  make_world(context.rng, Family::kChanges, c.world);
  if (c.world.spec.dims.x >= 100 || context.rng.chance(0.5)) std::fill(c.world.solid.begin(), c.world.solid.end(), 0);
  thin_out(context.bench, c.world);
  const Status bound = bind_and_mark(context.rng, c.world);
  if (bound != Status::kOk) report(context.findings, "bind", "%s", tern::status_name(bound));
  c.wide = c.world.spec.dims.x >= 100;
  constexpr Through kThrough[] = {Through::kAny, Through::kNewCopy, Through::kTwoViews};
  c.through = context.rng.pick(kThrough);
  for (VoxelBoxes& set : c.sets) set = make_set(context.rng, c.world, c.wide);
  c.copy = c.world.grid;
  return bound == Status::kOk;
}

/// One frame: sets `first` and, where `count` is 2, the one after it come, or go if they stand.
void frame(Rng& rng, Changing& c, int first, int count) {
  tern::Grid by_value = c.world.grid;
  tern::Grid* const views[] = {&c.world.grid, &c.copy, &by_value};
  const int from = c.through == Through::kNewCopy ? 2 : 0;
  const int to = c.through == Through::kTwoViews ? 1 : 2;
  tern::Grid& view = *views[rng.integer(from, to)];
  for (int k = 0; k < count; ++k) {
    const int s = (first + k) % 3;
    apply(c.world, view, c.sets[s], !c.standing[s]);
    c.standing[s] = !c.standing[s];
  }
  view.inflate();
  // Whoever holds another view inflates it before planning on it, as the grid asks for.
  c.world.grid.inflate();
}

/// One frame; or two that the planner sees as one, the second of them with the change that it saw last, so that whoever
/// tells contents apart by the last change takes another world for the one that was seen.
void come_and_go(Rng& rng, Changing& c) {
  const int set = c.last_set >= 0 && rng.chance(0.5) ? c.last_set : rng.integer(0, 2);
  const bool unseen = set == c.last_set;
  if (unseen) frame(rng, c, set, 2);
  frame(rng, c, set, unseen || rng.chance(0.5) ? 1 : 2);
  c.last_set = set;
}

/// The same storage bound anew, by the same object or as a new one, as it was or with another radius.
void bind_again(Context& context, Changing& c) {
  Rng& rng = context.rng;
  if (rng.chance(0.5)) c.world.grid = tern::Grid();
  if (rng.chance(0.5)) c.world.spec.radius = rng.integer(0, 2) * c.world.spec.cell;
  if (rng.chance(0.3)) c.world.words.assign(c.world.words.size(), 0);
  const Status bound = c.world.grid.bind(c.world.spec, c.world.words.data(), c.world.words.size());
  if (bound != Status::kOk) report(context.findings, "bind", "again: %s", tern::status_name(bound));
  std::fill(c.world.solid.begin(), c.world.solid.end(), 0);
  for (int s = 0; s < 3; ++s) {
    c.standing[s] = rng.chance(0.5);
    if (c.standing[s]) apply(c.world, c.world.grid, c.sets[s], true);
  }
  c.world.grid.inflate();
  c.copy = c.world.grid;
}

void ask_both(Context& context, tern::Planner& kept, Changing& c) {
  const Map map = map_of(c.world);
  check_layers(c.world, map, context.findings);
  const int count = c.wide ? 6 : context.rng.integer(1, 3);
  for (int k = 0; k < count && context.findings.empty(); ++k) {
    Ask ask;
    make_request(context.rng, Family::kChanges, c.world, map, ask);
    if (c.wide || context.rng.chance(0.7)) ask.request.budget.trajectory = 0;
    const Status status = ask_once(context, kept, c.world, map, ask, "plan on a changed world");
    compare_fresh(context, c.world, ask, status);
  }
}

/// Something that the plan in hand must notice. The world's record is not kept up: it is thrown away afterwards.
const char* change_under_way(Context& context, Changing& c, World& other) {
  World& world = c.world;
  const tern::Voxel v{world.spec.dims.x / 2, 0, 0};
  tern::Grid by_value = world.grid;
  switch (context.rng.integer(0, 5)) {
    case 0:
      return (void)world.grid.mark_voxel(v), "a mark";
    case 1:
      return (void)world.grid.clear_voxel(v), world.grid.inflate(), "a mark and an inflation";
    case 2:
      return (void)by_value.mark_box(world.spec.boundary), by_value.inflate(), "a mark through a copy";
    case 3:
      return (void)world.grid.bind(world.spec, world.words.data(), world.words.size()), "bind to the same storage";
    case 4:
      return world.grid = other.grid, "another grid in the object";
    default:
      world.grid = tern::Grid();
      (void)world.grid.bind(other.spec, other.words.data(), other.words.size());
      other.grid = world.grid;
      mark_difference(context.rng, other, std::vector<std::uint8_t>(other.solid.size(), 0), world.grid);
      world.grid.inflate();
      return "a new object, bound to other storage";
  }
}

void change_between_slices(Context& context, tern::Planner& planner, Changing& c, World& other) {
  const Map map = map_of(c.world);
  Ask ask;
  make_request(context.rng, Family::kChanges, c.world, map, ask);
  Status status = planner.begin(c.world.grid, ask.request);
  const int steps = context.rng.integer(0, 6);
  const auto size = static_cast<std::uint32_t>(context.rng.integer(1, 40));
  for (int k = 0; k < steps && status == Status::kRunning; ++k) status = planner.step(size);
  if (status != Status::kRunning) return;
  const char* change = change_under_way(context, c, other);
  if (context.verbose) std::printf("between slices: %s after %d steps of %u\n", change, steps, size);
  status = planner.step(size);
  tern::Report answer;
  spoil(context.bench.second);
  for (int k = 0; k < 100000 && status == Status::kRunning; ++k) status = planner.step(size);
  const Status finished = planner.finish(context.bench.second, answer);
  if (status != Status::kMapChanged || finished != status) {
    report(context.findings, "map_changed", "%s between slices: step says %s, finish %s", change,
           tern::status_name(status), tern::status_name(finished));
  }
  if (finished != Status::kOk && !spoiled(context.bench.second)) report(context.findings, "touched", "%s", change);
}

}  // namespace

void run_changes(Context& context) {
  Changing worlds[2];
  if (!begin_world(context, worlds[0]) || !begin_world(context, worlds[1])) return;
  tern::Planner kept(&context.bench.kept_memory, sizeof(tern::Workspace));
  Rng& rng = context.rng;
  const int changes = worlds[0].wide ? 5 : rng.integer(1, 4);
  for (int k = 0; k < changes && context.findings.empty(); ++k) {
    Changing& c = worlds[rng.chance(0.85) ? 0 : 1];
    if (rng.chance(0.12)) {
      bind_again(context, c);
    } else {
      come_and_go(rng, c);
    }
    ask_both(context, kept, c);
  }
  if (rng.chance(0.4) && context.findings.empty()) change_between_slices(context, kept, worlds[0], worlds[1].world);
}

}  // namespace tern_attack
