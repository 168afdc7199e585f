// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tern's searches and the plain A*, one query after the other, side by side.
#ifndef TERN_BENCH_CONTEST_HPP
#define TERN_BENCH_CONTEST_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "baselines/plain_astar.hpp"
#include "guide/voxel_search.hpp"
#include "search/worlds.hpp"

namespace tern_bench {

/// One searcher on one set of queries. Times are processor times, microseconds: the least of each query's repetitions,
/// and the first one's.
struct Tally {
  std::vector<double> times;
  std::vector<double> first_times;
  std::uint64_t expanded = 0;  ///< over all queries
};

/// Both on one set.
struct Outcome {
  std::string set;
  Tally astar;
  Tally tern;                ///< the optimal search, with what it kept of the map
  Tally fast;                ///< the fast search, on a new map each time: it keeps nothing
  double excess = 0.0;       ///< of the fast search's cost over the optimum, relative: the sum over all queries
  double most_excess = 0.0;  ///< and of the worst query
  int unsolved = 0;          ///< queries without a path, by both; they are not counted otherwise
  int wrong = 0;             ///< queries whose verdicts or costs differ, or that are cheaper than optimal
  double least_ratio = 0.0;  ///< A*'s time over Tern's, of the query where Tern does worst
  std::uint32_t nodes = 0;   ///< most nodes of one query
  std::int32_t heap = 0;     ///< most open entries of one query
};

/// Runs queries on both and tells the outcome. Either is given the map before the first query: the A* copies it, Tern
/// finds it in the grid, and out about it in its first queries.
class Contest {
 public:
  /// `repetitions` of every query, fewer where one takes long.
  Contest(std::string set, int repetitions);

  void add(const World& world, const std::vector<Query>& queries);
  const Outcome& outcome() const { return outcome_; }

 private:
  void add_fast(const tern::Grid& grid, const Query& query, bool found, tern::Cost optimum);
  void add_query(const tern::Grid& grid, PlainAStar& astar, const Query& query);

  int repetitions_;
  Outcome outcome_;
  std::unique_ptr<tern::Search> search_;
  std::unique_ptr<tern::VoxelSearch> fast_;
  std::unique_ptr<tern::Path> path_;
};

}  // namespace tern_bench

#endif
