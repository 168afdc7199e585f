// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The front ends that search a grid, each as one call that times itself.
#ifndef TERN_BENCH_PAPER_FRONT_END_HPP
#define TERN_BENCH_PAPER_FRONT_END_HPP

#include <memory>

#include "baselines/paper_map.hpp"
#include "baselines/route.hpp"
#include "host/scenario.hpp"
#include "paper/world.hpp"
#include "path/search_stage.hpp"
#include "path/shortcut_stage.hpp"

namespace tern_bench {

struct TimedRoute {
  Route route;
  double time = 0.0;  ///< milliseconds, the least of the repetitions; without what building the map takes
};

/// Plain A* and plain jump point search on Tern's grid, by Tern's rules.
TimedRoute plain_astar(const ScenarioGrid& world, const tern_host::Scenario& scenario, int repetitions);
TimedRoute plain_jps(const ScenarioGrid& world, const tern_host::Scenario& scenario, int repetitions);

/// The paper's search, and the same with its shortening.
struct PaperRoutes {
  TimedRoute jump_points;
  TimedRoute shortened;
};
PaperRoutes paper_front_end(const PaperMap& map, const tern_host::Scenario& scenario, int repetitions);
/// A* as the spacing of Table 5's waypoints tells it.
TimedRoute paper_astar(const PaperMap& map, const tern_host::Scenario& scenario, int repetitions);

/// Tern's search alone, and with its shortcut.
struct TernRoutes {
  TimedRoute jump_points;
  TimedRoute shortened;
  tern::Status status;
};

/// Tern's search and shortcut stages with the memory they need.
class TernFrontEnd {
 public:
  TernFrontEnd();
  TernRoutes run(const ScenarioGrid& world, const tern_host::Scenario& scenario, int repetitions);

 private:
  std::unique_ptr<tern::SearchStage> search_;
  std::unique_ptr<tern::ShortcutStage> shortcut_;
  std::unique_ptr<tern::Path> path_;
};

}  // namespace tern_bench

#endif
