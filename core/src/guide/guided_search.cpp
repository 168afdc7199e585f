// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/guided_search.hpp"

#include "base/capacity.hpp"
#include "search/neighbourhood.hpp"
#include "search/prune.hpp"
#include "search/turn_writer.hpp"

namespace tern {
namespace {

constexpr int kGuidedBucketBits = 6;

/// Blocks from the current one to the carrot. Aiming ahead smooths the corners of the guide's path, which the path of
/// voxels need not follow.
constexpr int kCarrotBlocks = 2;

/// The heuristic with its weight of one and a half.
constexpr std::uint64_t weighted(GuideCost left) {
  return std::uint64_t{left} + left / 2;
}

struct MoveCosts {
  GuideCost of[kDirections];
};
constexpr MoveCosts make_move_costs() {
  MoveCosts costs{};
  for (int move = 0; move < kDirections; ++move) costs.of[move] = guide_cost(move);
  return costs;
}
constexpr MoveCosts kMoveCosts = make_move_costs();

constexpr std::uint32_t entry(std::int32_t page, int place) {
  return static_cast<std::uint32_t>(page) << 6 | static_cast<std::uint32_t>(place);
}

/// The next block on the guide's path. If the path misses the voxel's part of a split block: the block beside that part
/// that is nearest to the goal.
Voxel next_block(GuidedSearch& search, const Grid& grid, const Voxel& block, const Voxel& voxel) {
  BlockMap& map = search.guide.map;
  const int arrival = map.at(block).arrival();
  const Voxel step = offset(opposite(arrival));
  const Voxel next = block + step;
  if (arrival == kHere || !block_split(map, grid, block)) return next;
  const VoxelMask part = connected(VoxelMask{1} << place_in_page(voxel), block_voxels(grid, block));
  const SideMask sides = sides_touched(part) & map.joined(block);
  if ((sides & sides_of(opposite(arrival))) != 0) return next;
  Voxel best = block;
  GuideCost least = kFar;
  for (int side = 0; side < kSides; ++side) {
    if ((sides >> side & 1u) == 0) continue;
    const Voxel beside = block + offset(kSideMove[side]);
    block_touch(map, grid, beside);
    const Block& at = map.at(beside);
    if (!at.closed() || at.distance >= least) continue;
    best = beside;
    least = at.distance;
  }
  return best;
}

/// Sets the carrot of a page whose block is closed. This is the middle of the block two blocks further along the
/// guide's path, or the goal if the path ends first.
void set_carrot(GuidedSearch& search, const Grid& grid, const Voxel& voxel, Page& page) {
  const BlockMap& map = search.guide.map;
  Voxel block = next_block(search, grid, map.block_of(voxel), voxel);
  for (int k = 1; k < kCarrotBlocks; ++k) {
    block = block + offset(opposite(map.at(block).arrival()));
  }
  const Block& reached = map.at(block);
  const std::int32_t half = 1 << (map.log - 1);
  page.heads = true;
  page.rest = reached.distance;
  page.carrot = {(block.x << map.log) + half, (block.y << map.log) + half, (block.z << map.log) + half};
  if (reached.arrival() == kHere) page.carrot = search.goal;
}

/// Sets the heuristic of a new page. If its block is not closed yet, this is a lower bound: from the f that the guide
/// has reached, or from the distance in an empty map.
void set_heuristic(GuidedSearch& search, const Grid& grid, const Voxel& voxel, Page& page) {
  const BlockMap& map = search.guide.map;
  const Voxel block = map.block_of(voxel);
  block_touch(search.guide.map, grid, block);
  if (block_closed(search.guide, map.index(block))) return set_carrot(search, grid, voxel, page);
  const GuideCost to_start = guide_octile(block, search.guide.target) << map.log;
  const GuideCost to_goal = guide_octile(block, map.block_of(search.goal)) << map.log;
  page.rest = search.guide.f > to_start + to_goal ? search.guide.f - to_start : to_goal;
}

std::uint32_t bucket_of(const Page& page, const Voxel& voxel, GuideCost cost) {
  const GuideCost left = page.heads ? page.rest + guide_octile(voxel, page.carrot) : page.rest;
  return static_cast<std::uint32_t>((cost + weighted(left)) >> kGuidedBucketBits);
}

/// The voxel's page; kGuidePages if there is no room for it.
std::int32_t page_of(GuidedSearch& search, const Grid& grid, const Voxel& voxel) {
  const std::int32_t before = search.store.count;
  const std::int32_t index = page_find_or_add(search.store, voxel);
  if (search.store.count > before) set_heuristic(search, grid, voxel, search.store.pages[index]);
  return index;
}

/// Records a path of this cost that arrives at a voxel by `move`, if it is the best so far. kRunning or kOpenFull.
Status reach(GuidedSearch& search, std::int32_t index, const Voxel& voxel, GuideCost cost, int move) {
  Page& page = search.store.pages[index];
  const int place = place_in_page(voxel);
  const std::uint64_t bit = std::uint64_t{1} << place;
  if ((page.closed & bit) != 0 || ((page.reached & bit) != 0 && page.cost[place] <= cost)) return Status::kRunning;
  page.reached |= bit;
  page.cost[place] = cost;
  page.arrival[place] = static_cast<std::uint8_t>(move);
  const bool room = queue_put(search.open, bucket_of(page, voxel, cost), entry(index, place));
  return is_full(!room) ? Status::kOpenFull : Status::kRunning;
}

/// A search that can follow its guide expands hardly more voxels than its path has. If it expands several times as
/// many, the guide leads astray.
constexpr std::uint32_t kLeastExpansions = 256;
constexpr std::uint32_t kExpansionsPerVoxel = 8;

std::uint32_t most_expansions(const GuidedSearch& search) {
  const GuideCost length = search.guide.map.at(search.guide.target).distance / kGuideStraight;
  return least(kGuidedExpansions, kLeastExpansions + kExpansionsPerVoxel * length);
}

Status expand(GuidedSearch& search, const Grid& grid, std::int32_t index, const Voxel& at, int place) {
  if (same(at, search.goal)) return Status::kOk;
  if (search.expanded == 0) search.most = most_expansions(search);
  if (is_full(++search.expanded > search.most)) return Status::kNodesFull;
  const Page& from = search.store.pages[index];
  const GuideCost cost = from.cost[place];
  const CellMask free = free_cells(grid, at);
  // Moves to voxels that the voxel before has reached directly, as far as the cells around this voxel show.
  const int arrival = from.arrival[place];
  const CellMask known = cells_after(legal_moves(cells_after(free, opposite(arrival))), arrival);
  for (CellMask left = legal_moves(free) & ~known; left != 0; left &= left - 1) {
    const int move = __builtin_ctz(left);
    const Voxel to = at + kMoveOf.at[move].step;
    const bool here = (((to.x ^ at.x) | (to.y ^ at.y) | (to.z ^ at.z)) & ~3) == 0;
    const std::int32_t page = here ? index : page_of(search, grid, to);
    if (is_full(page == kGuidePages)) return Status::kNodesFull;
    const Status status = reach(search, page, to, cost + kMoveCosts.of[move], move);
    if (status != Status::kRunning) return status;
  }
  return Status::kRunning;
}

/// Takes one entry off the open list of voxels.
Status take_voxel(GuidedSearch& search, const Grid& grid) {
  if (search.open.count == 0) return Status::kNoPath;
  if (is_full(++search.taken > kGuidedTaken)) return Status::kNodesFull;
  const std::uint32_t taken = queue_take(search.open);
  const auto index = static_cast<std::int32_t>(taken >> 6);
  const int place = static_cast<int>(taken & 63u);
  Page& page = search.store.pages[index];
  if ((page.closed >> place & 1u) != 0) return Status::kRunning;
  const Voxel at = voxel_in_page(page.at, place);
  if (!page.heads) {
    search.awaited = search.guide.map.index(search.guide.map.block_of(at));
    if (!block_closed(search.guide, search.awaited)) {
      queue_put(search.open, search.open.current, taken);
      return Status::kRunning;
    }
    set_carrot(search, grid, at, page);
  }
  // If the entry comes too early, the guide has improved the heuristic since, or the ring had no bucket for the entry.
  const std::uint32_t bucket = bucket_of(page, at, page.cost[place]);
  if (bucket > search.open.current) {
    queue_put(search.open, bucket, taken);
    return Status::kRunning;
  }
  page.closed |= std::uint64_t{1} << place;
  return expand(search, grid, index, at, place);
}

/// Lets the guide take entries off its list, one a piece of work. Ends once the guide has closed the awaited block,
/// stalls or fails, or if nothing is left of the slice.
Status advance_guide(GuidedSearch& search, const Grid& grid, Work& work) {
  const Block& awaited = search.guide.map.blocks[search.awaited];
  // If guide_left is 0 here, the guide has closed the start's block, and may take any number of entries.
  const std::uint32_t most = search.guide_left == 0 ? ~std::uint32_t{0} : search.guide_left;
  std::uint32_t taken = 0;
  Status status = Status::kRunning;
  while (status == Status::kRunning && taken < most && work.left() && !awaited.closed()) {
    work.spend(4 * ops::kNode);
    status = block_search_take(search.guide, grid);
    ++taken;
  }
  search.entries += taken;
  search.guide_left -= taken;
  return status;
}

}  // namespace

bool guided_begin(GuidedSearch& search, const Grid& grid, const Voxel& start, const Voxel& goal, bool small) noexcept {
  search.start = start;
  search.goal = goal;
  search.expanded = 0;
  search.most = 0;
  search.entries = 0;
  if (!block_search_begin(search.guide, grid, goal, start, small)) return false;
  search.awaited = search.guide.map.index(search.guide.target);
  guided_reopen(search, grid);
  search.guide_left = kGuideStallLimit;
  return true;
}

void guided_reopen(GuidedSearch& search, const Grid& grid) noexcept {
  search.taken = 0;
  search.guide_left = ~std::uint32_t{0};  // more than the guide ever takes
  queue_reset(search.open);
  page_store_reset(search.store);
  reach(search, page_of(search, grid, search.start), search.start, 0, kHere);  // the lists are empty, so it fits
}

Status guided_advance(GuidedSearch& search, const Grid& grid, Work& work) noexcept {
  Status status = Status::kRunning;
  while (status == Status::kRunning && work.left()) {
    if (block_closed(search.guide, search.awaited)) {
      work.spend(9 * ops::kNode);
      ++search.entries;
      status = take_voxel(search, grid);
      continue;
    }
    status = advance_guide(search, grid, work);
    if (status == Status::kRunning && guide_stalls(search)) return status;
  }
  return status;
}

namespace {

/// The stored move of a voxel on the path: the move that reaches it, or, once the moves are reversed, the one that
/// leaves it.
std::uint8_t& move_at(GuidedSearch& search, const Voxel& voxel) {
  return search.store.pages[page_find_or_add(search.store, voxel)].arrival[place_in_page(voxel)];
}

/// Reverses the moves, which then lead from the start to the goal.
void reverse_moves(GuidedSearch& search) {
  Voxel at = search.goal;
  std::uint8_t departure = kHere;
  // A path contains each expanded voxel at most once.
  for (std::uint32_t k = 0; k <= kGuidedExpansions; ++k) {
    std::uint8_t& move = move_at(search, at);
    const std::uint8_t arrival = move;
    move = departure;
    if (arrival == kHere) return;
    const Voxel step = offset(arrival);
    at = {at.x - step.x, at.y - step.y, at.z - step.z};
    departure = arrival;
  }
}

}  // namespace

Status guided_extract(GuidedSearch& search, const Grid& grid, int reserve, Path& path) noexcept {
  reverse_moves(search);
  TurnWriter writer(grid, path, reserve, search.start);
  for (std::uint32_t k = 0; k <= kGuidedExpansions && !same(writer.last, search.goal); ++k) {
    writer.run(move_at(search, writer.last), 1);
  }
  return writer.finish();
}

}  // namespace tern
