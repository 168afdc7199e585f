// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/front_end.hpp"

#include <algorithm>
#include <limits>

#include "baselines/paper_search.hpp"
#include "baselines/plain_astar.hpp"
#include "baselines/plain_jps.hpp"
#include "paper/statistics.hpp"

namespace tern_bench {
namespace {

using tern::Voxel;

constexpr std::uint32_t kNoBudget = 0xFFFFFFFFu;

/// The points in front of and behind which the path turns, and both ends.
std::vector<Voxel> turning_points(const std::vector<Voxel>& path) {
  const auto sign = [](int v) { return (v > 0) - (v < 0); };
  const auto heading = [&](const Voxel& a, const Voxel& b) {
    return tern::direction(sign(b.x - a.x), sign(b.y - a.y), sign(b.z - a.z));
  };
  std::vector<Voxel> turns;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool inner = i > 0 && i + 1 < path.size();
    if (!inner || heading(path[i - 1], path[i]) != heading(path[i], path[i + 1])) turns.push_back(path[i]);
  }
  return turns;
}

/// A jump goes along three axes, then two, then one: its voxels where those change.
std::vector<Voxel> with_bends(const std::vector<Voxel>& jump_points) {
  std::vector<Voxel> path;
  for (const Voxel& to : jump_points) {
    while (!path.empty() && !tern::same(path.back(), to)) {
      const Voxel& at = path.back();
      const auto sign = [](int v) { return (v > 0) - (v < 0); };
      const int dx = to.x - at.x, dy = to.y - at.y, dz = to.z - at.z;
      path.push_back({at.x + sign(dx), at.y + sign(dy), at.z + sign(dz)});
    }
    if (path.empty()) path.push_back(to);
  }
  return turning_points(path);
}

template <typename Search>
TimedRoute run_on_grid(Search& search, const ScenarioGrid& world, const tern_host::Scenario& scenario,
                       int repetitions) {
  TimedRoute timed;
  Voxel start{};
  Voxel goal{};
  if (!world.nearest_free(scenario.start.position, start) || !world.nearest_free(scenario.goal.position, goal)) {
    return timed;
  }
  timed.time = least_time(repetitions, [&] { timed.route.found = search.run(start, goal); });
  timed.route.expanded = search.expanded();
  return timed;
}

std::vector<tern::Vec3> world_points(const ScenarioGrid& world, const tern::Vec3* local, int count) {
  std::vector<tern::Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(world.to_world(local[i]));
  return points;
}

}  // namespace

TimedRoute plain_astar(const ScenarioGrid& world, const tern_host::Scenario& scenario, int repetitions) {
  PlainAStar search(world.grid());
  TimedRoute timed = run_on_grid(search, world, scenario, repetitions);
  if (timed.route.found) {
    timed.route.points = world.chain(scenario.start.position, search.path(), scenario.goal.position);
  }
  return timed;
}

TimedRoute plain_jps(const ScenarioGrid& world, const tern_host::Scenario& scenario, int repetitions) {
  PlainJps search(world.grid());
  TimedRoute timed = run_on_grid(search, world, scenario, repetitions);
  if (timed.route.found) {
    timed.route.points = world.chain(scenario.start.position, with_bends(search.path()), scenario.goal.position);
  }
  return timed;
}

PaperRoutes paper_front_end(const PaperMap& map, const tern_host::Scenario& scenario, int repetitions) {
  PaperRoutes routes;
  const tern::Vec3& start = scenario.start.position;
  const tern::Vec3& goal = scenario.goal.position;
  Route& raw = routes.jump_points.route;
  routes.jump_points.time = least_time(repetitions, [&] { raw = greedy_jump_search(map, start, goal); });
  routes.shortened.route = raw;
  const double extra =
      least_time(repetitions, [&] { routes.shortened.route.points = shorten_by_sight(map, raw.points); });
  routes.shortened.time = routes.jump_points.time + extra;
  return routes;
}

TimedRoute paper_astar(const PaperMap& map, const tern_host::Scenario& scenario, int repetitions) {
  TimedRoute timed;
  timed.time = least_time(
      repetitions, [&] { timed.route = six_neighbour_astar(map, scenario.start.position, scenario.goal.position); });
  return timed;
}

TernFrontEnd::TernFrontEnd()
    : search_(new tern::SearchStage), shortcut_(new tern::ShortcutStage), path_(new tern::Path) {}

TernRoutes TernFrontEnd::run(const ScenarioGrid& world, const tern_host::Scenario& scenario, int repetitions) {
  TernRoutes routes;
  const tern::Grid& grid = world.grid();
  const tern::SearchQuery query{grid.to_local(scenario.start.position), grid.to_local(scenario.goal.position)};
  double searching = std::numeric_limits<double>::infinity();
  double shortening = searching;
  for (int k = 0; k < repetitions; ++k) {
    tern::Work work{kNoBudget};
    const double begin = thread_time();
    tern::search_begin(*search_, tern::World(grid), query);
    const tern::Progress searched = tern::search_advance(*search_, tern::World(grid), work, *path_);
    const double between = thread_time();
    routes.status = search_->status;
    if (searched == tern::Progress::kDone) {
      tern::shortcut_begin(*shortcut_, grid, *path_);
      tern::shortcut_advance(*shortcut_, grid, work, *path_);
      routes.status = shortcut_->status;
    }
    searching = std::min(searching, between - begin);
    shortening = std::min(shortening, thread_time() - between);
  }
  const bool found = routes.status == tern::Status::kOk;
  routes.jump_points = {{found, {}, search_->pieces}, searching};
  routes.shortened = {{found, {}, search_->pieces}, searching + shortening};
  if (found) {
    routes.jump_points.route.points = world_points(world, path_->raw, path_->raw_count);
    routes.shortened.route.points = world_points(world, path_->points, path_->count);
  }
  return routes;
}

}  // namespace tern_bench
