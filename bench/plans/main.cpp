// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What plans are worth, over scenarios and three sets of limits: durations beside the trapezoid's, fallbacks,
// programmes and units, and how much of each limit is used, in the plan and where a row binds. tools/bench plans
// runs it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "host/figures.hpp"
#include "host/flight/family_scenario.hpp"
#include "host/session.hpp"
#include "leg_times.hpp"
#include "plans/limit_rows.hpp"
#include "stage_rows.hpp"

namespace {

using tern_bench::LimitRow;
using tern_bench::quantile;
using tern_bench::RowKind;

/// Limits to fly with, and the weight of time.
struct Setting {
  const char* name;
  bool own;  ///< the scenario's limits
  tern::Limits limits;
  double time_weight;
};

/// As the files say; fast vehicles that pull little, so that accelerations bind; and limits of an autopilot.
const Setting kSettings[] = {
    {"own", true, {}, tern::kDefaultTimeWeight},
    {"own-fast", true, {}, 1000.0},
    {"agile", false, {{6, 6, 6}, {2, 2, 2}}, 1000.0},
    {"autopilot", false, {{2, 2, 1.5}, {2, 2, 1.5}, {0, 0, -1}, {0, 0, -1}, 2.0, 2.0}, 1000.0},
};

struct Tally {
  int planned = 0;
  int optimised = 0;
  std::vector<double> duration, ratio, programmes, units, use;
  std::map<std::string, std::vector<double>> rows;  ///< use where a row binds, by what it limits
};

/// The paper's allocation: every leg from rest to rest.
double trapezoid(const tern::Corridor& corridor, const tern::Limits& limits) {
  double sum = 0.0;
  for (const double time : tern_bench::leg_times(corridor, limits)) sum += time;
  return sum;
}

std::string name_of(const LimitRow& row) {
  const std::string order = row.order == 1 ? "v " : "a ";
  if (row.kind == RowKind::kHorizontal) return order + "horizontal";
  if (row.axis < 2) return order + "x, y";
  return order + (row.kind == RowKind::kUp ? "up" : "down");
}

void fly(tern_host::Session& session, tern_bench::Prober& prober, tern_host::Scenario scenario, Tally& tally) {
  const tern_host::PlanResult result = session.plan(scenario);
  if (!result.ok()) return;
  const double seconds = tern::duration(result.trajectory);
  const tern_host::Figures figures = tern_host::measure(result.trajectory, scenario);
  ++tally.planned;
  tally.optimised += result.report.quality == tern::Quality::kOptimised ? 1 : 0;
  tally.duration.push_back(seconds);
  tally.ratio.push_back(seconds / trapezoid(*result.corridor, scenario.limits));
  tally.programmes.push_back(result.report.diagnostics.high_water.qp_solves);
  tally.units.push_back(
      static_cast<double>(result.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work));
  tally.use.push_back(std::max(figures.v_use, figures.a_use));
  for (const LimitRow& row : prober.rows(*result.corridor, scenario.limits, scenario.time_weight)) {
    tally.rows[name_of(row)].push_back(row.use);
  }
}

void print(const Setting& setting, std::size_t files, const Tally& tally) {
  std::printf("%-10s %3d of %3zu planned, %3d optimised; duration %.2f s (max %.2f), of the trapezoid's %.3f (%.3f); ",
              setting.name, tally.planned, files, tally.optimised, quantile(tally.duration, 0.5),
              quantile(tally.duration, 1.0), quantile(tally.ratio, 0.5), quantile(tally.ratio, 1.0));
  std::printf("programmes %.0f (%.0f), units %.0f (%.0f); largest use of a limit: median %.3f, least %.3f\n",
              quantile(tally.programmes, 0.5), quantile(tally.programmes, 1.0), quantile(tally.units, 0.5),
              quantile(tally.units, 1.0), quantile(tally.use, 0.5), quantile(tally.use, 0.0));
  for (const auto& [name, use] : tally.rows) {
    std::printf("           %-13s %5zu rows bind; peak over limit: median %.3f, 5 %% below %.3f, least %.3f\n",
                name.c_str(), use.size(), quantile(use, 0.5), quantile(use, 0.05), quantile(use, 0.0));
  }
}

void write(std::ofstream& csv, const Setting& setting, const Tally& tally) {
  for (const auto& [name, use] : tally.rows) {
    csv << setting.name << ",\"" << name << "\"," << tally.planned << ',' << quantile(tally.duration, 0.5) << ','
        << quantile(tally.ratio, 0.5) << ',' << quantile(tally.units, 0.5) << ',' << use.size() << ','
        << quantile(use, 0.5) << ',' << quantile(use, 0.05) << ',' << quantile(use, 0.0) << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Durations, fallbacks, units and limit use of plans");
  std::vector<std::string> files;
  std::string csv_path;
  app.add_option("FILE", files, "Scenarios")->required()->check(CLI::ExistingFile);
  app.add_option("--csv", csv_path, "Write the rows that bind as a table");
  CLI11_PARSE(app, argc, argv);
  std::ofstream csv;
  if (!csv_path.empty()) csv.open(csv_path);
  csv << "setting,limit,planned,duration_s,of_trapezoid,units,rows,use_median,use_p5,use_least\n";
  tern_host::Session session;
  tern_bench::Prober prober;
  for (const Setting& setting : kSettings) {
    Tally tally;
    for (const std::string& file : files) {
      tern_host::Scenario scenario = tern_host::named_scenario(file);
      if (!setting.own) scenario.limits = setting.limits;
      scenario.time_weight = setting.time_weight;
      fly(session, prober, scenario, tally);
    }
    if (tally.planned == 0) continue;
    print(setting, files.size(), tally);
    write(csv, setting, tally);
  }
  return 0;
}
