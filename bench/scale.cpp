// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the work of a plan grows: with the cells of the map, with vias, with legs, and with things that move; that
// of far ways through a city, and that of vehicles in a swarm. Counts units, which are the same on every machine.
// tools/bench scale runs it; bench/scale_plot.py draws its table.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "host/session.hpp"
#include "quantile.hpp"
#include "scale_rows.hpp"
#include "support/random.hpp"

namespace {

using tern::Vec3;
using tern_bench::quantile;
using tern_host::PlanResult;
using tern_host::Scenario;
using tern_test::Random;

constexpr double kHeight = 6.0;   ///< of a world of columns, metres
constexpr double kDensity = 0.1;  ///< part of its ground that columns cover, but for overlaps
constexpr double kGap = 12.0;     ///< metres from wall to wall of a slalom

const double kEdges[] = {4.0, 8.0, 16.0, 32.0, 64.0, 105.0};  ///< of worlds of columns, metres
const int kVias[] = {1, 2, 4, 8, 16};
const int kWalls[] = {1, 2, 4, 8, 16, 24};
const int kThings[] = {1, 2, 5, 10, 20, 50, 100, 200};

struct Options {
  std::string csv;
  int worlds = 9;
};

tern_host::Block block_of(double x, double y, double edge_x, double edge_y, double height) {
  return {{{x, y, 0.0}, {x + edge_x, y + edge_y, height}}, false};
}

/// A square of this edge, with columns of 1 m, from one corner to the other.
Scenario columns(double edge, Random& random) {
  Scenario scenario;
  scenario.boundary = {{0.0, 0.0, 0.0}, {edge, edge, kHeight}};
  scenario.start.position = {1.0, 1.0, 0.5 * kHeight};
  scenario.goal.position = {edge - 1.0, edge - 1.0, 0.5 * kHeight};
  const auto is_near = [](double x, double y, const Vec3& end) {
    return std::fabs(x + 0.5 - end.x) < 1.2 && std::fabs(y + 0.5 - end.y) < 1.2;
  };
  const int count = static_cast<int>(kDensity * edge * edge);
  for (int k = 0; k < count; ++k) {
    const double x = random.real(0.0, edge - 1.0);
    const double y = random.real(0.0, edge - 1.0);
    if (is_near(x, y, scenario.start.position) || is_near(x, y, scenario.goal.position)) continue;
    scenario.blocks.push_back(block_of(x, y, 1.0, 1.0, kHeight));
  }
  return scenario;
}

/// Walls across the way, with a gap at one end, then at the other.
Scenario slalom(int walls) {
  Scenario scenario;
  scenario.resolution = 0.25;
  scenario.boundary = {{0.0, 0.0, 0.0}, {kGap * (walls + 1), 10.0, 3.0}};
  scenario.start.position = {2.0, 5.0, 1.5};
  scenario.goal.position = {kGap * walls + 10.0, 5.0, 1.5};
  for (int w = 0; w < walls; ++w) {
    scenario.blocks.push_back(block_of(kGap * (w + 1), w % 2 == 0 ? 0.0 : 3.0, 0.5, 7.0, 3.0));
  }
  return scenario;
}

constexpr tern::Stage kStages[] = {tern::Stage::kSearch,     tern::Stage::kShortcut, tern::Stage::kCorridor,
                                   tern::Stage::kTrajectory, tern::Stage::kTracks,   tern::Stage::kCheck};
constexpr int kColumns = sizeof(kStages) / sizeof(kStages[0]);

/// Units of each stage, of the plans of one size.
struct Row {
  std::vector<double> units[kColumns];
  std::vector<double> inflate;  ///< microseconds: the grid's own work counts no units
  int asked = 0;

  void add(const PlanResult& plan) {
    ++asked;
    if (!plan.ok()) return;
    for (int k = 0; k < kColumns; ++k) {
      const auto& stage = plan.report.diagnostics.stages[static_cast<int>(kStages[k])];
      units[k].push_back(static_cast<double>(stage.work));
    }
    inflate.push_back(plan.timing.inflate);
  }

  void write(const char* what, double size, std::ofstream& csv) const {
    const std::size_t planned = inflate.size();
    std::printf("%s %.4g: %zu of %d planned", what, size, planned, asked);
    csv << what << ',' << size << ',' << planned << ',' << asked;
    for (const std::vector<double>& values : units) {
      const double median = planned > 0 ? quantile(values, 0.5) : 0.0;
      std::printf(", %.0f", median);
      csv << ',' << median;
    }
    std::printf(" units, inflate %.0f us\n", planned > 0 ? quantile(inflate, 0.5) : 0.0);
    csv << ',' << (planned > 0 ? quantile(inflate, 0.5) : 0.0) << ",0,0,0\n";
  }
};

double cells_of(const PlanResult& plan) {
  return static_cast<double>(plan.grid.dims.x) * plan.grid.dims.y * plan.grid.dims.z;
}

void over_cells(tern_host::Session& session, const Options& options, std::ofstream& csv) {
  for (const double edge : kEdges) {
    Row row;
    double cells = 0.0;
    for (int seed = 1; seed <= options.worlds; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      const PlanResult plan = session.plan(columns(edge, random));
      cells = cells_of(plan);
      row.add(plan);
    }
    row.write("cells", cells, csv);
  }
}

void over_vias(tern_host::Session& session, const Options& options, std::ofstream& csv) {
  for (const int vias : kVias) {
    Row row;
    for (int seed = 1; seed <= options.worlds; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      Scenario scenario = columns(32.0, random);
      scenario.blocks.clear();  // vias in an empty world: in a forest, many would lie in columns
      for (int v = 0; v < vias; ++v) {
        scenario.vias.push_back(
            {{random.real(2.0, 30.0), random.real(2.0, 30.0), random.real(1.0, 5.0)}, 0.0, false, false, {}});
      }
      row.add(session.plan(scenario));
    }
    row.write("vias", vias, csv);
  }
}

/// A ball that crosses the world of columns in a straight line. It is not at the start in the first seconds.
tern_host::TrackRecord ball(double edge, const Vec3& start, Random& random) {
  tern_host::TrackRecord thing;
  Vec3& place = thing.track.position;
  do {
    place = {random.real(0.0, edge), random.real(0.0, edge), random.real(0.5, kHeight - 0.5)};
  } while (std::hypot(place.x - start.x, place.y - start.y) < 5.0);
  thing.track.velocity = {random.real(-1.0, 1.0), random.real(-1.0, 1.0), 0.0};
  thing.track.radius = 0.3;
  thing.track.error = 0.05;
  thing.track.error_speed = 0.02;
  return thing;
}

void over_things(tern_host::Session& session, const Options& options, std::ofstream& csv) {
  constexpr double kEdge = 16.0;
  for (const int things : kThings) {
    Row row;
    for (int seed = 1; seed <= options.worlds; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      Scenario scenario = columns(kEdge, random);
      for (int t = 0; t < things; ++t) scenario.tracks.push_back(ball(kEdge, scenario.start.position, random));
      row.add(session.plan(scenario));
    }
    row.write("things", things, csv);
  }
}

void over_walls(tern_host::Session& session, std::ofstream& csv) {
  for (const int walls : kWalls) {
    Row row;
    row.add(session.plan(slalom(walls)));
    row.write("walls", walls, csv);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How the work of a plan grows with the size of what is asked");
  Options options;
  app.add_option("--csv", options.csv, "Write the table as CSV as well");
  app.add_option("--worlds", options.worlds, "Worlds of each size")->capture_default_str()->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  std::ofstream csv;
  if (!options.csv.empty()) csv.open(options.csv);
  csv << "what,size,planned,asked,search,shortcut,corridor,trajectory,tracks,check,inflate_us,far,flight,fleet\n";
  tern_host::Session session;
  over_cells(session, options, csv);
  over_vias(session, options, csv);
  over_walls(session, csv);
  over_things(session, options, csv);
  tern_bench::over_cities(csv);
  tern_bench::over_vehicles(csv);
  return 0;
}
