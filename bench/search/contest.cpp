// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/contest.hpp"

#include <time.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace tern_bench {
namespace {

/// A query that took longer than this is not repeated more than kLongRepetitions times.
constexpr double kLongQuery = 200e3;
constexpr int kLongRepetitions = 3;

/// Processor time of this thread, microseconds: other work on the machine counts only by what it does to the caches.
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e6 + static_cast<double>(t.tv_nsec) * 1e-3;
}

/// The cost of the path that the search found.
tern::Cost cost_of(tern::Search& search) {
  return search.store.nodes[store_find_or_add(search.store, search.goal)].g;
}

template <typename Run>
double timed(Run run) {
  const double begin = now();
  run();
  return now() - begin;
}

tern::Status run_tern(tern::Search& search, const tern::Grid& grid, const Query& query) {
  tern::search_begin(search, grid, query.start, query.goal);
  tern::Status status = tern::Status::kRunning;
  tern::Work work;
  while (status == tern::Status::kRunning) status = tern::search_expand(search, grid, work);
  return status;
}

tern::Status run_fast(tern::VoxelSearch& search, const tern::Grid& grid, const Query& query, tern::Path& path) {
  tern::voxel_search_begin(search, grid, query.start, query.goal, tern::SearchMode::kFast);
  tern::Work work{0xFFFFFFFFu};
  const tern::Status status = tern::voxel_search_advance(search, grid, work);
  path.raw_count = 0;
  return status == tern::Status::kOk ? tern::voxel_search_extract(search, grid, 0, path) : status;
}

}  // namespace

Contest::Contest(std::string set, int repetitions)
    : repetitions_(repetitions), search_(new tern::Search), fast_(new tern::VoxelSearch), path_(new tern::Path) {
  // A planner's memory is there before its first query, like the arrays of the A*: no query pays for its pages.
  std::memset(static_cast<void*>(search_.get()), 0xA5, sizeof(tern::Search));
  std::memset(static_cast<void*>(fast_.get()), 0xA5, sizeof(tern::VoxelSearch));
  outcome_.set = std::move(set);
  outcome_.least_ratio = std::numeric_limits<double>::infinity();
}

void Contest::add(const World& world, const std::vector<Query>& queries) {
  PlainAStar astar(world.grid);
  for (const Query& query : queries) add_query(world.grid, astar, query);
}

void Contest::add_fast(const tern::Grid& grid, const Query& query, bool found, tern::Cost optimum) {
  double time = std::numeric_limits<double>::infinity();
  tern::Status status = tern::Status::kOk;
  for (int k = 0; k < repetitions_; ++k) {
    time = std::min(time, timed([&] { status = run_fast(*fast_, grid, query, *path_); }));
  }
  if (status != (found ? tern::Status::kOk : tern::Status::kNoPath)) ++outcome_.wrong;
  if (!found) return;
  const double least = static_cast<double>(optimum) / static_cast<double>(tern::kStraightCost);
  const double excess = optimum > 0 ? path_->grid_length / least - 1.0 : 0.0;
  if (excess < -1e-9) ++outcome_.wrong;
  outcome_.fast.times.push_back(time);
  outcome_.excess += excess;
  outcome_.most_excess = std::max(outcome_.most_excess, excess);
}

void Contest::add_query(const tern::Grid& grid, PlainAStar& astar, const Query& query) {
  double astar_time = std::numeric_limits<double>::infinity();
  double tern_time = astar_time;
  double tern_first = 0.0;
  bool found = false;
  tern::Status status = tern::Status::kOk;
  // The two take turns, so that neither has the quieter machine.
  for (int k = 0; k < repetitions_ && (k < kLongRepetitions || astar_time < kLongQuery); ++k) {
    astar_time = std::min(astar_time, timed([&] { found = astar.run(query.start, query.goal); }));
    const double tern_once = timed([&] { status = run_tern(*search_, grid, query); });
    tern_time = std::min(tern_time, tern_once);
    if (k == 0) tern_first = tern_once;
  }
  add_fast(grid, query, found, found ? astar.cost() : 0);
  if (!found && status == tern::Status::kNoPath) {
    ++outcome_.unsolved;
    return;
  }
  const bool equal = found && status == tern::Status::kOk && cost_of(*search_) == astar.cost();
  if (!equal) ++outcome_.wrong;
  outcome_.astar.times.push_back(astar_time);
  outcome_.astar.expanded += astar.expanded();
  outcome_.tern.times.push_back(tern_time);
  outcome_.tern.first_times.push_back(tern_first);
  outcome_.tern.expanded += search_->expanded;
  outcome_.least_ratio = std::min(outcome_.least_ratio, astar_time / tern_time);
  outcome_.nodes = std::max(outcome_.nodes, search_->store.count);
  outcome_.heap = std::max(outcome_.heap, search_->open.high);
}

}  // namespace tern_bench
