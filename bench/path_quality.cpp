// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How short Tern's paths are: beside a slow any-angle reference, and beside what OMPL's RRT* finds in a second on the
// same inflated grid, where OMPL is installed.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "baselines/any_angle.hpp"
#include "host/atomic_file.hpp"
#include "host/flight/family_scenario.hpp"
#include "host/session.hpp"
#include "paper/world.hpp"
#ifdef TERN_HAVE_OMPL
#include "baselines/ompl_planner.hpp"
#endif

namespace {

struct Options {
  std::vector<std::string> scenarios;
  std::vector<std::string> settings;
  int seeds = 0;
  double seconds = 1.0;
  std::string csv_file;
};

/// Lengths that RRT* found, one a seed, ascending; runs without a solution are left out.
std::vector<double> rrt_star(const tern::Grid& grid, const tern_host::Scenario& scenario, const Options& options) {
  std::vector<double> lengths;
#ifdef TERN_HAVE_OMPL
  for (int seed = 1; seed <= options.seeds; ++seed) {
    const auto results = tern_bench::ompl_plan(grid, {tern_bench::OmplAlgorithm::kRrtStar,
                                                      scenario.start.position,
                                                      scenario.goal.position,
                                                      {options.seconds},
                                                      static_cast<std::uint32_t>(seed)});
    if (results.back().solved) lengths.push_back(results.back().length);
  }
#else
  (void)grid, (void)scenario, (void)options;
#endif
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

std::string number(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// One row; the ratio of Tern's length to the reference's is added to `ratios`.
std::string row(const std::string& file, const Options& options, std::vector<double>& ratios) {
  const tern_host::Scenario scenario = tern_host::named_scenario(file, options.settings);
  static tern_host::Session session;
  const tern_host::PlanResult plan = session.plan(scenario);
  if (plan.path == nullptr) return file + ",no path\n";
  const tern_bench::ScenarioGrid world(scenario);
  const auto best = tern_bench::any_angle_path(world.grid(), scenario.start.position, scenario.goal.position);
  const double reference = tern_bench::path_length(best);
  ratios.push_back(plan.path->length / reference);
  const auto& shortcut = plan.report.diagnostics.stages[static_cast<int>(tern::Stage::kShortcut)];
  std::string text = file.substr(file.find_last_of('/') + 1) + number(",%.3f", plan.path->raw_length) +
                     number(",%.3f", plan.path->length) + "," + std::to_string(plan.path->count) +
                     number(",%.3f", reference) + number(",%.4f", ratios.back()) + "," + std::to_string(shortcut.work) +
                     number(",%.1f", plan.timing.of(tern::Stage::kShortcut));
  const std::vector<double> others = rrt_star(world.grid(), scenario, options);
  if (!others.empty()) {
    text +=
        number(",%.3f", others.front()) + number(",%.3f", others[others.size() / 2]) + number(",%.3f", others.back());
  }
  return text + "\n";
}

void measure(const Options& options) {
  std::string table =
      "scenario,jump_points_m,path_m,waypoints,reference_m,path_to_reference,work,shortcut_us,rrt_star_least_m,"
      "rrt_star_median_m,rrt_star_most_m\n";
  std::fputs(table.c_str(), stdout);
  std::vector<double> ratios;
  for (const std::string& file : options.scenarios) {
    const std::string line = row(file, options, ratios);
    std::fputs(line.c_str(), stdout);
    std::fflush(stdout);
    table += line;
  }
  double sum = 0.0;
  for (const double ratio : ratios) sum += ratio;
  if (!ratios.empty()) {
    std::printf("mean ratio to the reference %.4f, largest %.4f, over %zu paths\n",
                sum / static_cast<double>(ratios.size()), *std::max_element(ratios.begin(), ratios.end()),
                ratios.size());
  }
  if (!options.csv_file.empty()) tern_host::write_file(options.csv_file, table);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Lengths of Tern's paths beside an any-angle reference and OMPL's RRT*.");
  Options options;
  app.add_option("SCENARIO", options.scenarios, "Scenario files (docs/formats.md)")->required();
  app.add_option("--set", options.settings, "Replace a setting, KEY=VALUE");
  app.add_option("--seeds", options.seeds, "Runs of RRT*; 0 for none")->capture_default_str();
  app.add_option("--seconds", options.seconds, "Time of each run")->capture_default_str();
  app.add_option("--csv", options.csv_file, "Write the table as CSV as well")->type_name("OUT");
  CLI11_PARSE(app, argc, argv);
#ifndef TERN_HAVE_OMPL
  if (options.seeds > 0) {
    std::fputs("built without OMPL: no RRT* (tools/setup baselines installs it)\n", stderr);
    return 2;
  }
#endif
  try {
    measure(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
