// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Table 4 and Figures 9 to 14.
#include <string>
#include <utility>

#include "baselines/paper_search.hpp"
#ifdef TERN_HAVE_OMPL
#include "baselines/ompl_planner.hpp"
#endif
#include "host/number.hpp"
#include "paper/experiments.hpp"
#include "paper/figure.hpp"
#include "paper/front_end.hpp"
#include "paper/statistics.hpp"

namespace tern_bench {
namespace {

using tern_host::fixed;

constexpr int kMaps = 6;
constexpr int kRepetitions = 7;

/// What one method came to on one map over its runs (one where it is deterministic).
struct Outcome {
  std::vector<double> lengths, waypoints, times, clearances;
  int runs = 0;
  std::uint64_t expanded = 0;

  void add(const TimedRoute& timed, const tern_host::Scenario& scenario) {
    ++runs;
    if (!timed.route.found) return;
    lengths.push_back(length(timed.route.points));
    waypoints.push_back(static_cast<double>(timed.route.points.size()));
    times.push_back(timed.time);
    clearances.push_back(clearance(timed.route.points, scenario));
    expanded = timed.route.expanded;
  }
};

void write_row(Table& table, int map, const std::string& method, const std::string& state, const Outcome& o) {
  table.row({std::to_string(map), method, state, std::to_string(o.lengths.size()), std::to_string(o.runs),
             fixed(mean(o.lengths), 4), fixed(standard_deviation(o.lengths), 4), fixed(mean(o.waypoints), 1),
             fixed(mean(o.times), 4), fixed(standard_deviation(o.times), 4), std::to_string(o.expanded),
             fixed(quantile(o.clearances, 0.0), 4)});
}

/// The routes that a map's figure shows.
struct Shown {
  std::vector<tern::Vec3> astar, paper, paper_short, tern, rrt, prm;
};

void run_grid_methods(Table& table, int map, const tern_host::Scenario& scenario, const ScenarioGrid& world,
                      Shown& shown) {
  const auto add = [&](const std::string& method, const std::string& state, const TimedRoute& timed) {
    Outcome outcome;
    outcome.add(timed, scenario);
    write_row(table, map, method, state, outcome);
    return timed.route.points;
  };
  shown.astar = add("A*", "", plain_astar(world, scenario, kRepetitions));
  add("JPS", "", plain_jps(world, scenario, kRepetitions));
  const PaperMap paper_grid(scenario, kPaperCell, kPaperMargin);
  const PaperRoutes paper = paper_front_end(paper_grid, scenario, kRepetitions);
  shown.paper = add("paper JPS", "", paper.jump_points);
  shown.paper_short = add("paper JPS-Bresenham", "", paper.shortened);
  TernFrontEnd front_end;
  const TernRoutes tern = front_end.run(world, scenario, kRepetitions);
  add("Tern search", "", tern.jump_points);
  shown.tern = add("Tern", "", tern.shortened);
}

#ifdef TERN_HAVE_OMPL
/// One planner's runs with all seeds; returns what the first seed has at the end.
std::vector<tern::Vec3> run_sampling(Table& table, const Run& run, int map, const tern_host::Scenario& scenario,
                                     const ScenarioGrid& world, OmplAlgorithm algorithm) {
  const std::vector<double> times = run.quick ? std::vector<double>{0.05} : std::vector<double>{0.1, 1.0};
  std::vector<Outcome> outcomes(times.size() + 1);
  std::vector<tern::Vec3> shown;
  for (int seed = 1; seed <= pick(run, 20, 2); ++seed) {
    const std::vector<OmplResult> results = ompl_plan(
        world.grid(),
        {algorithm, scenario.start.position, scenario.goal.position, times, static_cast<std::uint32_t>(seed)});
    for (std::size_t i = 0; i < results.size(); ++i) {
      outcomes[i].add({{results[i].solved, results[i].path, 0}, 1e3 * results[i].seconds}, scenario);
    }
    if (seed == 1) shown = results.back().path;
  }
  const char* const name = algorithm == OmplAlgorithm::kPrm ? "PRM" : "RRT*";
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    write_row(table, map, name, i == 0 ? "first" : fixed(times[i - 1], 2) + " s", outcomes[i]);
  }
  return shown;
}
#endif

void run_sampling_methods(Table& table, const Run& run, int map, const tern_host::Scenario& scenario,
                          const ScenarioGrid& world, Shown& shown) {
#ifdef TERN_HAVE_OMPL
  shown.rrt = run_sampling(table, run, map, scenario, world, OmplAlgorithm::kRrtStar);
  shown.prm = run_sampling(table, run, map, scenario, world, OmplAlgorithm::kPrm);
#else
  if (map == 1) progress("built without OMPL: RRT* and PRM are left out");
  (void)table, (void)run, (void)scenario, (void)world, (void)shown;
#endif
}

void draw_figure(const Run& run, int map, const tern_host::Scenario& scenario, const Shown& shown) {
  const std::vector<std::pair<Key, const std::vector<tern::Vec3>*>> entries = {
      {{"A*", "stroke=\"#7a8594\" stroke-width=\"2.2\""}, &shown.astar},
      {{"paper's JPS", "stroke=\"#b7791f\" stroke-width=\"1.8\" stroke-dasharray=\"2 4\""}, &shown.paper},
      {{"paper's JPS-Bresenham", "stroke=\"#b7791f\" stroke-width=\"2.2\""}, &shown.paper_short},
      {{"RRT*", "stroke=\"#2f8f5b\" stroke-width=\"1.6\" stroke-dasharray=\"8 3\""}, &shown.rrt},
      {{"PRM", "stroke=\"#2b6cb0\" stroke-width=\"1.6\" stroke-dasharray=\"8 3 2 3\""}, &shown.prm},
      {{"Tern", "stroke=\"#a01e96\" stroke-width=\"2.8\""}, &shown.tern}};
  Figure figure("Figure " + std::to_string(map + 8) + ": paths on Map " + std::to_string(map), "front_end");
  std::vector<Key> keys;
  for (const auto& entry : entries) {
    if (!entry.second->empty()) keys.push_back(entry.first);
  }
  figure.legend(keys);
  const MapViews views = lay_out_views(scenario, figure.top());
  draw_map(figure.canvas(), views, scenario);
  for (const auto& entry : entries) draw_route(figure.canvas(), views, *entry.second, entry.first.style);
  finish_map(figure.canvas(), views, scenario, shown.tern);
  figure.write(run, "map" + std::to_string(map) + "_paths.svg", views.bottom);
}

}  // namespace

void front_end_experiment(const Run& run) {
  Table table("map,method,state,found,runs,length_m,length_sd,waypoints,time_ms,time_sd,expanded,clearance_m");
  for (int map = 1; map <= kMaps; ++map) {
    progress("map " + std::to_string(map));
    const tern_host::Scenario scenario = paper_map(map);
    const ScenarioGrid world(scenario);
    Shown shown;
    run_grid_methods(table, map, scenario, world, shown);
    run_sampling_methods(table, run, map, scenario, world, shown);
    draw_figure(run, map, scenario, shown);
  }
  table.write(run, "front_end.csv");
}

}  // namespace tern_bench
