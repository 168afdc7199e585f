// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What other ways round would gain: each plan beside plans in the same world with one more column on its path.
// tools/bench ways runs it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "host/session.hpp"

namespace {

using tern_host::PlanResult;
using tern_host::Scenario;

struct Options {
  std::vector<std::string> files;
  std::string csv;
  double time_weight = tern::kDefaultTimeWeight;
  double edge = 0.6;
  int columns = 5;
  int others = 1;
};

/// A way that was planned along.
struct Way {
  double length;    ///< metres
  double estimate;  ///< seconds, from the path alone
  double duration;  ///< seconds
};

tern::Vec3 minus(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

double dot(const tern::Vec3& a, const tern::Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Seconds along the path: cruising at the speed limits, and for each turn a part of the time that a stop takes.
double estimate(const tern::Path& path, const tern::Limits& limits) {
  double time = 0.0;
  tern::Vec3 before{};
  for (int i = 0; i + 1 < path.count; ++i) {
    const tern::Vec3 leg = minus(path.points[i + 1], path.points[i]);
    const double length = std::sqrt(dot(leg, leg));
    if (!(length > 0.0)) continue;
    time += std::max(
        {std::fabs(leg.x) / limits.v_max.x, std::fabs(leg.y) / limits.v_max.y, std::fabs(leg.z) / limits.v_max.z});
    const tern::Vec3 along{leg.x / length, leg.y / length, leg.z / length};
    if (i > 0) time += 0.5 * (1.0 - dot(before, along)) * limits.v_max.x / limits.a_max.x;
    before = along;
  }
  return time;
}

/// The point at this part of the path's length, grid frame.
tern::Vec3 point_at(const tern::Path& path, double part) {
  double left = part * path.length;
  for (int i = 0; i + 1 < path.count; ++i) {
    const tern::Vec3& a = path.points[i];
    const tern::Vec3 leg = minus(path.points[i + 1], a);
    const double length = std::sqrt(dot(leg, leg));
    if (left < length) return {a.x + left / length * leg.x, a.y + left / length * leg.y, a.z + left / length * leg.z};
    left -= length;
  }
  return path.points[path.count - 1];
}

double work_of(const PlanResult& plan, bool whole) {
  double work = 0.0;
  for (int s = 0; s < tern::kStageCount; ++s) {
    const auto stage = static_cast<tern::Stage>(s);
    const bool counts = whole || stage == tern::Stage::kSearch || stage == tern::Stage::kShortcut;
    work += counts ? static_cast<double>(plan.report.diagnostics.stages[s].work) : 0.0;
  }
  return work;
}

Scenario with_column(const Scenario& scenario, const PlanResult& plan, double part, double edge) {
  const tern::Vec3 at = point_at(*plan.path, part);
  const tern::Vec3 middle{at.x + plan.grid.origin.x, at.y + plan.grid.origin.y, at.z + plan.grid.origin.z};
  Scenario changed = scenario;
  changed.blocks.push_back({{{middle.x - 0.5 * edge, middle.y - 0.5 * edge, scenario.boundary.lower.z},
                             {middle.x + 0.5 * edge, middle.y + 0.5 * edge, scenario.boundary.upper.z}},
                            false});
  return changed;
}

/// Ratios of durations to the first plan's, summed over scenarios.
struct Sums {
  int count = 0;
  int wins = 0;
  double by_length = 0.0;
  double by_estimate = 0.0;
  double alone = 0.0;  ///< the least estimate of all ways, planned alone
  double of_all = 0.0;
  double routes = 0.0;  ///< work of searches and shortcuts, over the first plan's
};

/// The least duration of the first plan and the first `others` of the list.
double least_of(double first, const std::vector<Way>& ways, int others) {
  double least = first;
  for (std::size_t i = 0; i < ways.size() && i < static_cast<std::size_t>(others); ++i) {
    least = std::min(least, ways[i].duration);
  }
  return least;
}

void measure(tern_host::Session& session, const std::string& file, const Options& options, std::ofstream& csv,
             Sums& sums) {
  Scenario scenario = tern_host::read_scenario(file);
  scenario.time_weight = options.time_weight;
  const PlanResult plan = session.plan(scenario);
  if (!plan.ok() || plan.path == nullptr) return;
  const Way first{plan.path->length, estimate(*plan.path, scenario.limits), tern::duration(plan.trajectory)};
  std::vector<Way> ways;
  double routes = 0.0;
  for (int k = 0; k < options.columns; ++k) {
    const PlanResult other =
        session.plan(with_column(scenario, plan, (k + 1.0) / (options.columns + 1.0), options.edge));
    routes += work_of(other, false);
    if (!other.ok() || other.path == nullptr) continue;
    ways.push_back({other.path->length, estimate(*other.path, scenario.limits), tern::duration(other.trajectory)});
    csv << file << ',' << first.duration << ',' << ways.back().length << ',' << ways.back().estimate << ','
        << ways.back().duration << '\n';
  }
  std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.length < b.length; });
  sums.by_length += least_of(first.duration, ways, options.others) / first.duration;
  std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.estimate < b.estimate; });
  const double best = least_of(first.duration, ways, options.others) / first.duration;
  const bool looks_faster = !ways.empty() && ways.front().estimate < first.estimate;
  ++sums.count;
  sums.wins += best < 0.98 ? 1 : 0;
  sums.by_estimate += best;
  sums.alone += looks_faster ? ways.front().duration / first.duration : 1.0;
  sums.of_all += least_of(first.duration, ways, options.columns) / first.duration;
  sums.routes += routes / work_of(plan, true);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Plans beside plans along other ways round");
  Options options;
  app.add_option("FILE", options.files, "Scenarios")->check(CLI::ExistingFile);
  app.add_option("--csv", options.csv, "Write a row for each other way");
  app.add_option("--time-weight", options.time_weight, "Weight of time");
  app.add_option("--edge", options.edge, "Edge of a column, metres")->capture_default_str();
  app.add_option("--columns", options.columns, "Columns, each in a world of its own")->capture_default_str();
  app.add_option("--others", options.others, "Other ways that are planned along")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  std::ofstream csv;
  if (!options.csv.empty()) csv.open(options.csv);
  csv << "scenario,first_s,length_m,estimate_s,duration_s\n";
  tern_host::Session session;
  Sums sums;
  for (const std::string& file : options.files) measure(session, file, options, csv, sums);
  const double n = sums.count;
  std::printf("%d plans; durations over those of the first plans, means:\n", sums.count);
  std::printf(
      "least of the first and of %d others, chosen by length %.4f, by estimate %.4f (2 %% less in %d), of all %.4f\n",
      options.others, sums.by_length / n, sums.by_estimate / n, sums.wins, sums.of_all / n);
  std::printf("the least estimate, planned alone %.4f; routes take %.2f of the first plan's work\n", sums.alone / n,
              sums.routes / n);
  return 0;
}
