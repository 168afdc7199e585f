// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the paper claims of its algorithms, measured: N_JB = K + 2 <= N_JPS, the shortcut's O(W D), and an ellipsoid
// that converges within finitely many steps.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "baselines/paper_corridor.hpp"
#include "baselines/paper_search.hpp"
#include "draw.hpp"
#include "host/number.hpp"
#include "paper/experiments.hpp"
#include "paper/figure.hpp"
#include "paper/front_end.hpp"
#include "paper/random_map.hpp"
#include "paper/statistics.hpp"
#include "path/shortcut.hpp"
#include "path/sight.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;
using tern_host::fixed;

constexpr double kStraight = 1e-9;

/// Times that a chain changes its direction: the paper's K.
int direction_changes(const std::vector<Vec3>& p) {
  int changes = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    const Vec3 a{p[i].x - p[i - 1].x, p[i].y - p[i - 1].y, p[i].z - p[i - 1].z};
    const Vec3 b{p[i + 1].x - p[i].x, p[i + 1].y - p[i].y, p[i + 1].z - p[i].z};
    const Vec3 c{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    const double straight = a.x * b.x + a.y * b.y + a.z * b.z;
    const double sine = std::hypot(c.x, c.y, c.z);
    if (sine > kStraight * std::fabs(straight) || straight < 0.0) ++changes;
  }
  return changes;
}

struct BoundCount {
  int maps = 0, equal = 0, fewer = 0, more = 0, beyond_jps = 0;
  std::string counterexample;

  /// N of the shortened chain against K + 2 of the chain that it was made from.
  void add(const std::vector<Vec3>& raw, const std::vector<Vec3>& shortened, const std::string& name) {
    const int bound = direction_changes(raw) + 2;
    const int n = static_cast<int>(shortened.size());
    ++maps;
    equal += n == bound ? 1 : 0;
    fewer += n < bound ? 1 : 0;
    more += n > bound ? 1 : 0;
    beyond_jps += n > static_cast<int>(raw.size()) ? 1 : 0;
    if (n != bound && counterexample.empty()) {
      counterexample = name + ": K + 2 = " + std::to_string(bound) + " of " + std::to_string(raw.size()) +
                       " jump points; kept " + std::to_string(n);
    }
  }
};

void waypoint_bound(const Run& run) {
  BoundCount paper, tern;
  TernFrontEnd front_end;
  for (int seed = 1; seed <= pick(run, 200, 5); ++seed) {
    const MapKind kind{"random map", {10.0, 10.0, 3.0}, seed % 2 == 0 ? 0.1 : 0.3, kPaperCell, kPaperMargin, 0.3};
    const tern_host::Scenario scenario = random_map(kind, static_cast<std::uint64_t>(seed));
    const PaperMap map(scenario, kPaperCell, kPaperMargin);
    const PaperRoutes routes = paper_front_end(map, scenario, 1);
    if (routes.jump_points.route.found) {
      paper.add(routes.jump_points.route.points, routes.shortened.route.points, scenario.name);
    }
    const ScenarioGrid world(scenario);
    const TernRoutes own = front_end.run(world, scenario, 1);
    if (own.shortened.route.found) tern.add(own.jump_points.route.points, own.shortened.route.points, scenario.name);
  }
  Table table("method,maps,equal,fewer,more,beyond_jps,counterexample");
  for (const auto& [name, count] : {std::pair<const char*, BoundCount&>{"paper", paper}, {"Tern", tern}}) {
    table.row({name, std::to_string(count.maps), std::to_string(count.equal), std::to_string(count.fewer),
               std::to_string(count.more), std::to_string(count.beyond_jps), count.counterexample});
  }
  table.write(run, "theory.csv");
}

/// A zigzag of `points` raw points, `stride` voxels apart, through a row of posts: none sees further than its
/// neighbours, so that every pair is tried; with `stride` growing, every line is longer.
class Zigzag {
 public:
  Zigzag(int points, int stride) : path_(new tern::Path), shortcut_(new tern::Shortcut) {
    tern::GridSpec spec{};
    spec.cell = 0.1;
    spec.dims = {points * stride + 2, 9, 3};
    spec.boundary = {{0.0, 0.0, 0.0}, {spec.dims.x * 0.1, 0.9, 0.3}};
    words_.resize(tern::grid_words(spec.dims));
    grid_.bind(spec, words_.data(), words_.size());
    for (int k = 0; k < points; ++k) {
      const bool up = k % 2 == 0;
      const tern::Voxel at{1 + k * stride, up ? 7 : 1, 1};
      path_->raw[k] = grid_.center(at);
      // A post opposite to each turn closes all lines but those to the neighbours.
      for (int y = up ? 0 : 4; y <= (up ? 4 : 8) && k > 0 && k + 1 < points; ++y) {
        for (int z = 0; z < 3; ++z) grid_.mark_voxel({at.x, y, z});
      }
    }
    path_->raw_count = points;
    grid_.inflate();
  }

  /// Milliseconds, lines walked, and the mean of the voxels between the ends of those.
  double run(int repetitions, std::uint64_t& lines) {
    return least_time(repetitions, [&] {
      lines = 0;
      tern::shortcut_begin(*shortcut_, grid_, *path_);
      while (tern::shortcut_needs_step(*shortcut_, *path_)) {
        tern::shortcut_step(*shortcut_, grid_, *path_);
        ++lines;
      }
    });
  }

 private:
  std::vector<std::uint64_t> words_;
  tern::Grid grid_;
  std::unique_ptr<tern::Path> path_;
  std::unique_ptr<tern::Shortcut> shortcut_;
};

/// One clear line of D voxels along a diagonal: what a single look costs.
double sight_time(int voxels, int repetitions) {
  tern::GridSpec spec{};
  spec.cell = 0.1;
  spec.dims = {voxels + 2, voxels / 2 + 2, 8};
  spec.boundary = {{0.0, 0.0, 0.0}, {spec.dims.x * 0.1, spec.dims.y * 0.1, 0.8}};
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  grid.bind(spec, words.data(), words.size());
  grid.inflate();
  const Vec3 a = grid.center({1, 1, 1});
  const Vec3 b = grid.center({voxels, voxels / 2, 6});
  constexpr int kCalls = 200;
  int seen = 0;
  const double time = least_time(repetitions, [&] {
    for (int i = 0; i < kCalls; ++i) seen += tern::line_of_sight(grid, a, b) ? 1 : 0;
  });
  if (seen == 0) progress("a clear line was not in sight");
  return time / kCalls;
}

/// The paper's own shortening of W points on one clear line of D voxels: every look goes back to the first point.
double paper_time(int points, int voxels, int repetitions) {
  const std::string size = fixed(kPaperCell * voxels, 1);
  const tern_host::Scenario empty =
      tern_host::parse_scenario("boundary 0 0 0 " + size + " 2 2\nstart 0.1 0.1 0.1\ngoal 0.3 0.1 0.1\n", "empty");
  const PaperMap map(empty, kPaperCell, 0.0);
  std::vector<Vec3> chain;
  for (int i = 0; i < points; ++i) {
    const double t = static_cast<double>(i) / (points - 1);
    chain.push_back({0.1 + t * kPaperCell * (voxels - 1), 0.1 + 1.8 * t, 0.1 + 1.8 * t});
  }
  return least_time(repetitions, [&] { shorten_by_sight(map, chain); });
}

struct Slopes {
  Curve points;  ///< log10 of W against log10 of milliseconds
  Curve lines;   ///< the same of lines walked
  Curve length;  ///< log10 of D against log10 of microseconds
  Curve paper;   ///< log10 of W against log10 of milliseconds, the paper's shortening
};

Slopes shortcut_complexity(const Run& run) {
  Slopes slopes;
  slopes.points.style = "class=\"curve\" stroke=\"#a01e96\"";
  slopes.lines.style = "class=\"curve\" stroke=\"#2b6cb0\"";
  slopes.paper.style = "class=\"curve\" stroke=\"#b7791f\"";
  slopes.length.style = "class=\"curve\" stroke=\"#c8553d\"";
  Table table("kind,size,lines,time_ms");
  const int repetitions = pick(run, 15, 3);
  for (int points = 16; points <= pick(run, 512, 128); points *= 2) {
    Zigzag zigzag(points, 3);
    std::uint64_t lines = 0;
    const double time = zigzag.run(repetitions, lines);
    table.row({"W", std::to_string(points), std::to_string(lines), fixed(time, 6)});
    slopes.points.x.push_back(std::log10(points));
    slopes.points.y.push_back(std::log10(time));
    slopes.lines.x.push_back(std::log10(points));
    slopes.lines.y.push_back(std::log10(static_cast<double>(std::max<std::uint64_t>(lines, 1))));
  }
  for (int voxels = 32; voxels <= pick(run, 1024, 256); voxels *= 2) {
    const double time = sight_time(voxels, repetitions);
    table.row({"D", std::to_string(voxels), "1", fixed(time, 6)});
    slopes.length.x.push_back(std::log10(voxels));
    slopes.length.y.push_back(std::log10(1e3 * time));
  }
  Curve paper_length;
  for (int size = 32; size <= pick(run, 512, 128); size *= 2) {
    const double by_points = paper_time(size, 256, repetitions);
    const double by_length = paper_time(128, size, repetitions);
    table.row({"paper W", std::to_string(size), "", fixed(by_points, 6)});
    table.row({"paper D", std::to_string(size), "", fixed(by_length, 6)});
    slopes.paper.x.push_back(std::log10(size));
    slopes.paper.y.push_back(std::log10(by_points));
    paper_length.x.push_back(std::log10(size));
    paper_length.y.push_back(std::log10(by_length));
  }
  table.row({"slope of the paper's time over W", fixed(slope(slopes.paper.x, slopes.paper.y), 3), "", ""});
  table.row({"slope of the paper's time over D", fixed(slope(paper_length.x, paper_length.y), 3), "", ""});
  table.row({"slope of lines over W", fixed(slope(slopes.lines.x, slopes.lines.y), 3), "", ""});
  table.row({"slope of time over W", fixed(slope(slopes.points.x, slopes.points.y), 3), "", ""});
  table.row({"slope of time over D", fixed(slope(slopes.length.x, slopes.length.y), 3), "", ""});
  table.write(run, "shortcut.csv");
  return slopes;
}

/// How often the paper's ellipsoid shrinks, against the points that it could shrink at.
void ellipsoid_iterations(const Run& run) {
  Table table("density,segments,shrinks_mean,shrinks_p99,shrinks_max,points_mean,planes_max");
  Draw draw(5);
  for (const int percent : {10, 20, 30, 45}) {
    std::vector<double> shrinks, counts, planes;
    for (int seed = 1; seed <= pick(run, 20, 2); ++seed) {
      const MapKind kind{"ellipsoid", {10.0, 10.0, 3.0}, 0.01 * percent, 0.1, 0.1, 0.3};
      const tern_host::Scenario scenario = random_map(kind, static_cast<std::uint64_t>(seed));
      const PaperMap map(scenario, 0.1, 0.1);
      const std::vector<Vec3> points = surface_points(map);
      const auto random_free = [&] {
        for (;;) {
          const tern::Voxel v{draw.integer(0, map.dims().x - 1), draw.integer(0, map.dims().y - 1),
                              draw.integer(0, map.dims().z - 1)};
          if (map.free(v)) return map.center(v);
        }
      };
      for (int k = 0; k < 20; ++k) {
        const Vec3 a = random_free();
        const Vec3 b = random_free();
        const double way = tern_bench::distance(a, b);
        if (way < 0.3 || way > 4.0 || !sampled_sight(map, a, b)) continue;
        const PaperPolyhedron p = grow_paper_polyhedron(a, b, points, 2.0);
        shrinks.push_back(p.shrinks);
        planes.push_back(static_cast<double>(p.planes.size()));
        counts.push_back(static_cast<double>(points.size()));
      }
    }
    table.row({std::to_string(percent) + " %", std::to_string(shrinks.size()), fixed(mean(shrinks), 2),
               fixed(quantile(shrinks, 0.99), 0), fixed(quantile(shrinks, 1.0), 0), fixed(mean(counts), 0),
               fixed(quantile(planes, 1.0), 0)});
  }
  table.write(run, "ellipsoid.csv");
}

AxisRange range_with_room(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {std::floor(*low), std::ceil(*high)};
}

void draw_figure(const Run& run, const Slopes& slopes) {
  Figure figure("The shortcut's cost, logarithmic", "theory");
  figure.legend({{"Tern: time over W points, all pairs tried (log10 ms)", slopes.points.style},
                 {"Tern: lines of sight walked (log10)", slopes.lines.style},
                 {"the paper's: time over W points (log10 ms)", slopes.paper.style},
                 {"Tern: one line over its D voxels (log10 µs)", slopes.length.style}});
  const double x = kFigureMargin + kPanelLeft;
  const double width = 0.5 * (kFigureWidth - 2.0 * kFigureMargin) - kPanelLeft;
  const Rect left{x, figure.top() + kPanelAbove, width, 280.0};
  const Rect right{x + width + kPanelLeft, left.y, width, 280.0};
  std::vector<double> all = slopes.points.y;
  all.insert(all.end(), slopes.lines.y.begin(), slopes.lines.y.end());
  all.insert(all.end(), slopes.paper.y.begin(), slopes.paper.y.end());
  draw_plot(figure.canvas(), {left, range_with_room(slopes.points.x), range_with_room(all)},
            {slopes.points, slopes.lines, slopes.paper}, "W points", "log10 W", "log10");
  draw_plot(figure.canvas(), {right, range_with_room(slopes.length.x), range_with_room(slopes.length.y)},
            {slopes.length}, "One line of D voxels", "log10 D", "log10 µs");
  figure.write(run, "theory.svg", left.bottom() + kPanelBelow);
}

}  // namespace

void theory_experiment(const Run& run) {
  progress("waypoint bound");
  waypoint_bound(run);
  progress("complexity of the shortcut");
  const Slopes slopes = shortcut_complexity(run);
  progress("iterations of the ellipsoid");
  ellipsoid_iterations(run);
  draw_figure(run, slopes);
}

}  // namespace tern_bench
