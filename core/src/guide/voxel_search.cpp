// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/voxel_search.hpp"

namespace tern {
namespace {

/// Beginning a guided search or a flood clears the buckets and the index of pages.
constexpr Operations kBeginOperations = 2 * ops::kTurn * kGuidedBuckets;

void raise_high_water(VoxelSearch& search) {
  raise(search.nodes_high, static_cast<std::int32_t>(search.optimal.store.count));
  raise(search.open_high, search.optimal.open.high);
}

void begin_optimal(VoxelSearch& search, const Grid& grid) {
  search.method = SearchMethod::kOptimal;
  search_begin(search.optimal, grid, search.start, search.goal);
}

/// Begins the guided search after the first expansions. The least f of the open list is a lower bound for the cost of
/// all paths, because the heuristic is consistent.
void begin_guided(VoxelSearch& search, const Grid& grid) {
  const Cost proven = static_cast<Cost>(search.optimal.open.bin) << kBinBits;
  if (search.least < proven) search.least = proven;
  search.method = SearchMethod::kGuided;
  if (!guided_begin(search.guided, grid, search.start, search.goal)) begin_optimal(search, grid);
}

/// True if the first expansions are done and a guided search must follow.
bool first_over(const VoxelSearch& search) {
  const bool first = search.method == SearchMethod::kFirst;
  return first && search.optimal.jumped >= kFirstJumps;
}

Status advance_optimal(VoxelSearch& search, const Grid& grid, Work& work) {
  Status status = Status::kRunning;
  while (status == Status::kRunning && !first_over(search) && work.left()) {
    status = search_expand(search.optimal, grid, work);
    ++search.entries;
    raise_high_water(search);
  }
  return status;
}

bool proves(Status status) {
  return status == Status::kOk || status == Status::kNoPath;
}

void begin_pocket(VoxelSearch& search, const Grid& grid, SearchMethod method) {
  search.method = method;
  search.start_flooded |= method == SearchMethod::kStartPocket;
  search.goal_flooded |= method == SearchMethod::kGoalPocket;
  pocket_begin(search.guided, grid, method == SearchMethod::kGoalPocket ? search.goal : search.start);
}

/// Advances a flood. kRunning if no work is left; otherwise as pocket_take.
Status advance_pocket(VoxelSearch& search, const Grid& grid, Work& work) {
  const Voxel& to = search.method == SearchMethod::kGoalPocket ? search.start : search.goal;
  Status status = Status::kRunning;
  while (status == Status::kRunning && work.left()) {
    work.spend(kPocketOperations);
    ++search.entries;
    status = pocket_take(search.guided, grid, to);
  }
  return status;
}

/// Begins a guided search with small blocks, after one with large blocks. False if the last one had small blocks, or if
/// the grid has too many.
bool begin_small(VoxelSearch& search, const Grid& grid) {
  if (!search.guided.guide.map.large()) return false;
  search.method = SearchMethod::kGuided;
  if (!guided_begin(search.guided, grid, search.start, search.goal, true)) return false;
  guided_reopen(search.guided, grid);  // it must not stall again
  return true;
}

/// Begins the next method after a guided search that stalls or gives up, or after a flood that proves nothing. False if
/// nothing is left to try.
bool begin_next(VoxelSearch& search, const Grid& grid) {
  if (search.method == SearchMethod::kStartPocket && !search.gave_up) {
    search.method = SearchMethod::kGuided;
    guided_reopen(search.guided, grid);
    return true;
  }
  if (search.start_flooded && search.goal_flooded) return begin_small(search, grid);
  begin_pocket(search, grid, search.start_flooded ? SearchMethod::kGoalPocket : SearchMethod::kStartPocket);
  return true;
}

/// The most turns of advance_guided(): a guided search, a flood around the start, the guided search again, a flood
/// around the goal, and a guided search with small blocks.
constexpr int kGuidedTurns = 5;

/// The guided search, with floods around the ends: around the start if the guide stalls, and around both ends if the
/// search gives up. If the blocks were large, a guided search with small blocks follows. Returns the status of the last
/// of them; kNodesFull and kOpenFull prove nothing.
Status advance_guided(VoxelSearch& search, const Grid& grid, Work& work) {
  Status status = Status::kRunning;
  for (int turn = 0; turn < kGuidedTurns; ++turn) {
    const bool floods = search.method != SearchMethod::kGuided;
    const std::uint32_t before = search.guided.entries;
    status = floods ? advance_pocket(search, grid, work) : guided_advance(search.guided, grid, work);
    search.entries += search.guided.entries - before;
    const bool stalls = !floods && status == Status::kRunning && guide_stalls(search.guided);
    if (proves(status) || (status == Status::kRunning && !stalls)) return status;
    search.gave_up = search.gave_up || (!floods && !stalls);
    work.spend(kBeginOperations);
    if (!begin_next(search, grid)) return status;
  }
  return status;
}

}  // namespace

void voxel_search_begin(VoxelSearch& search, const Grid& grid, const Voxel& start, const Voxel& goal,
                        SearchMode mode) noexcept {
  search.start = start;
  search.goal = goal;
  search.least = octile(start, goal);
  search.entries = 0;
  search.nodes_high = 0;
  search.open_high = 0;
  search.start_flooded = false;
  search.goal_flooded = false;
  search.gave_up = false;
  begin_optimal(search, grid);
  if (mode == SearchMode::kFast) search.method = SearchMethod::kFirst;
}

Status voxel_search_advance(VoxelSearch& search, const Grid& grid, Work& work) noexcept {
  if (search.method == SearchMethod::kFirst) {
    const Status status = advance_optimal(search, grid, work);
    if (proves(status) || (status == Status::kRunning && !first_over(search))) return status;
    work.spend(kBeginOperations);
    begin_guided(search, grid);
  }
  if (search.method == SearchMethod::kOptimal) return advance_optimal(search, grid, work);
  Status status = advance_guided(search, grid, work);
  if (proves(status) || status == Status::kRunning) return status;
  begin_optimal(search, grid);
  return advance_optimal(search, grid, work);
}

Status voxel_search_extract(VoxelSearch& search, const Grid& grid, int reserve, Path& path) noexcept {
  if (search.method == SearchMethod::kGuided) return guided_extract(search.guided, grid, reserve, path);
  return search_extract(search.optimal, grid, reserve, path);
}

bool voxel_search_again(VoxelSearch& search, const Grid& grid) noexcept {
  if (search.method != SearchMethod::kGuided) return false;
  begin_optimal(search, grid);
  return true;
}

SearchUsed search_used(const VoxelSearch& search) noexcept {
  return search.method == SearchMethod::kGuided ? SearchUsed::kGuided : SearchUsed::kOptimal;
}

double search_bound(const VoxelSearch& search, double cost) noexcept {
  if (search.method != SearchMethod::kGuided) return 1.0;
  const double least = static_cast<double>(search.least) / static_cast<double>(kStraightCost);
  return cost > least ? cost / least : 1.0;
}

}  // namespace tern
