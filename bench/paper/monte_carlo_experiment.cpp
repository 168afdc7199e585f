// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Table 5: front ends on random maps. Cell 0.2 m and clearance 0.1 m, as the spacing of the paper's waypoints tells: on
// cuboids that lie on that lattice the paper's grid and Tern's are the same.
#include <array>
#include <stdexcept>

#include "baselines/paper_search.hpp"
#include "host/number.hpp"
#include "paper/experiments.hpp"
#include "paper/figure.hpp"
#include "paper/front_end.hpp"
#include "paper/random_map.hpp"
#include "paper/statistics.hpp"

namespace tern_bench {
namespace {

using tern_host::fixed;

constexpr double kLeastWay = 0.3;
constexpr std::array<MapKind, 6> kKinds{{
    {"Small-Low", {10.0, 10.0, 3.0}, 0.1, kPaperCell, kPaperMargin, kLeastWay},
    {"Small-High", {10.0, 10.0, 3.0}, 0.3, kPaperCell, kPaperMargin, kLeastWay},
    {"Medium-Low", {20.0, 20.0, 4.0}, 0.1, kPaperCell, kPaperMargin, kLeastWay},
    {"Medium-High", {20.0, 20.0, 4.0}, 0.3, kPaperCell, kPaperMargin, kLeastWay},
    {"Large-Low", {40.0, 40.0, 5.0}, 0.1, kPaperCell, kPaperMargin, kLeastWay},
    {"Large-High", {40.0, 40.0, 5.0}, 0.3, kPaperCell, kPaperMargin, kLeastWay},
}};

enum Method { kPaperAStar, kPaperJps, kPaperShortened, kAStar, kJps, kTern, kMethods };
constexpr const char* kNames[kMethods] = {"paper A*", "paper JPS", "paper JPS-Bresenham", "A*", "JPS", "Tern"};

struct Samples {
  std::vector<double> lengths, waypoints, times, expanded;
  int unsafe = 0;  ///< paths that come nearer to a block than the clearance asked for

  void add(const TimedRoute& timed, const tern_host::Scenario& scenario) {
    lengths.push_back(length(timed.route.points));
    waypoints.push_back(static_cast<double>(timed.route.points.size()));
    times.push_back(timed.time);
    expanded.push_back(static_cast<double>(timed.route.expanded));
    unsafe += clearance(timed.route.points, scenario) < scenario.radius - 1e-6 ? 1 : 0;
  }
};

struct Trials {
  std::array<Samples, kMethods> methods;
  int solved = 0;
  int unsolved = 0;  ///< start and goal not connected
  int lost = 0;      ///< connected, but the paper's search found nothing
  int cut = 0;       ///< found by the paper's search alone, across a corner between two obstacles
  int longer = 0;    ///< Tern's search not as short as A*'s
};

void add_trial(const tern_host::Scenario& scenario, int repetitions, TernFrontEnd& front_end, Trials& trials) {
  const ScenarioGrid world(scenario);
  const PaperMap map(scenario, kPaperCell, kPaperMargin);
  const PaperRoutes paper = paper_front_end(map, scenario, repetitions);
  const TernRoutes tern = front_end.run(world, scenario, repetitions);
  const std::array<TimedRoute, kMethods> routes{paper_astar(map, scenario, repetitions),
                                                paper.jump_points,
                                                paper.shortened,
                                                plain_astar(world, scenario, repetitions),
                                                plain_jps(world, scenario, repetitions),
                                                tern.shortened};
  const bool connected = routes[kAStar].route.found;
  if (connected != routes[kTern].route.found || connected != routes[kJps].route.found ||
      connected != routes[kPaperAStar].route.found) {
    throw std::runtime_error(scenario.name + ": complete searches disagree on whether there is a path");
  }
  if (!connected || !routes[kPaperJps].route.found) {
    (connected ? trials.lost : (routes[kPaperJps].route.found ? trials.cut : trials.unsolved)) += 1;
    return;
  }
  ++trials.solved;
  const double optimal = length(routes[kAStar].route.points);
  trials.longer += length(tern.jump_points.route.points) > optimal + 1e-6 ? 1 : 0;
  for (std::size_t m = 0; m < kMethods; ++m) trials.methods[m].add(routes[m], scenario);
}

void write_rows(Table& table, const MapKind& kind, const Trials& trials) {
  for (std::size_t m = 0; m < kMethods; ++m) {
    const Samples& s = trials.methods[m];
    table.row({kind.name, kNames[m], std::to_string(trials.solved), std::to_string(trials.unsolved),
               std::to_string(trials.lost), std::to_string(trials.cut), std::to_string(trials.longer),
               fixed(mean(s.lengths), 4), fixed(mean(s.waypoints), 2), fixed(mean(s.times), 4),
               fixed(quantile(s.times, 0.5), 4), fixed(quantile(s.times, 1.0), 4), fixed(mean(s.expanded), 1),
               std::to_string(s.unsafe)});
  }
}

/// Bars of the mean of one quantity, a group of methods for each kind of map.
void draw_bars(Canvas& canvas, const Rect& frame, const std::vector<Trials>& trials,
               std::vector<double> Samples::*quantity, const std::string& heading, const std::string& unit,
               const std::array<std::string, kMethods>& colours) {
  double high = 0.0;
  for (const Trials& t : trials) {
    for (const Samples& s : t.methods) high = std::max(high, mean(s.*quantity));
  }
  const Axes axes{frame, {0.0, static_cast<double>(trials.size())}, {0.0, 1.08 * high}};
  canvas.rect(frame, "class=\"paper\"");
  for (const double v : tern_host::ticks(axes.vertical, 5.0)) {
    canvas.line(axes.at(0.0, v), axes.at(axes.horizontal.high, v), "class=\"grid\"");
    canvas.text({frame.x - 8.0, axes.at(0.0, v).y + 4.5}, fixed(v, v < 10.0 && high < 10.0 ? 1 : 0),
                "class=\"number\" text-anchor=\"end\"");
  }
  for (std::size_t k = 0; k < trials.size(); ++k) {
    const double base = static_cast<double>(k);
    for (std::size_t m = 0; m < kMethods; ++m) {
      const Pixel top = axes.at(base + 0.1 + 0.13 * static_cast<double>(m), mean(trials[k].methods[m].*quantity));
      const Pixel foot = axes.at(base + 0.21 + 0.13 * static_cast<double>(m), 0.0);
      canvas.rect({top.x, top.y, foot.x - top.x, foot.y - top.y}, "fill=\"" + colours[m] + "\"");
    }
    canvas.text({axes.at(base + 0.5, 0.0).x, frame.bottom() + 19.0}, kKinds[k].name,
                "class=\"number\" text-anchor=\"middle\"");
  }
  canvas.rect(frame, "class=\"frame\"");
  canvas.text({frame.x, frame.y - 10.0}, heading + " (" + unit + ")", "class=\"heading\"");
}

void draw_figure(const Run& run, const std::vector<Trials>& trials) {
  const std::array<std::string, kMethods> colours{"#d9b46a", "#b7791f", "#7c4f10", "#9aa4b2", "#5f6b7a", "#a01e96"};
  Figure figure("Table 5 as a picture: means over the solved maps", "monte_carlo");
  std::vector<Key> keys;
  for (std::size_t m = 0; m < kMethods; ++m) {
    keys.push_back({kNames[m], "stroke=\"" + colours[m] + "\" stroke-width=\"9\""});
  }
  figure.legend(keys);
  const double x = kFigureMargin + kPanelLeft;
  const double width = kFigureWidth - x - kFigureMargin;
  const Rect first{x, figure.top() + kPanelAbove, width, 210.0};
  const Rect second{x, first.bottom() + kPanelBelow + kPanelAbove, width, 210.0};
  draw_bars(figure.canvas(), first, trials, &Samples::lengths, "Path length", "m", colours);
  draw_bars(figure.canvas(), second, trials, &Samples::waypoints, "Waypoints", "points", colours);
  figure.write(run, "monte_carlo.svg", second.bottom() + kPanelBelow);
}

}  // namespace

void monte_carlo_experiment(const Run& run) {
  Table table(
      "config,method,solved,unsolved,lost,cut,longer,length_m,waypoints,time_ms,time_median_ms,time_max_ms,expanded,"
      "unsafe");
  TernFrontEnd front_end;
  std::vector<Trials> all;
  for (const MapKind& kind : kKinds) {
    Trials trials;
    for (int seed = 1; seed <= pick(run, 50, 3); ++seed) {
      if (seed % 10 == 0) progress(std::string(kind.name) + ": " + std::to_string(seed));
      add_trial(random_map(kind, static_cast<std::uint64_t>(seed)), pick(run, 3, 1), front_end, trials);
    }
    write_rows(table, kind, trials);
    all.push_back(trials);
  }
  table.write(run, "monte_carlo.csv");
  draw_figure(run, all);
}

}  // namespace tern_bench
