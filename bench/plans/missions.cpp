// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Missions through random vias: their durations and their planning time beside plans from via to via with a stop at
// each. tools/bench missions runs it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "host/flight/family_scenario.hpp"
#include "host/session.hpp"
#include "plans/gates.hpp"
#include "quantile.hpp"
#include "support/random.hpp"

namespace {

using tern_bench::quantile;
using tern_host::PlanResult;
using tern_host::Scenario;
using tern_host::Session;

struct Options {
  std::vector<std::string> files;
  std::string csv;
  int vias = 5;
  double tolerance = 0.0;
  double reach = 1e3;  ///< farthest that a via may be from the one before, metres
  double time_weight = tern::kDefaultTimeWeight;
  int gates = 0;  ///< courses of ten gates instead
  int rounds = 400;
};

/// A mission beside its legs.
struct Pair {
  std::string status;
  double duration = 0.0;
  double legs_duration = 0.0;
  double cruise = 0.0;  ///< of the path, at the speed limits all along
  double time = 0.0;    ///< of planning, microseconds
  double legs_time = 0.0;
  std::uint64_t units = 0;
  std::uint64_t legs_units = 0;
  bool optimised = false;
};

tern::Vec3 random_point(tern_test::Random& random, const tern::Box& box) {
  return {random.real(box.lower.x, box.upper.x), random.real(box.lower.y, box.upper.y),
          random.real(box.lower.z, box.upper.z)};
}

double distance(const tern::Vec3& a, const tern::Vec3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/// Seconds along the path at the speed limits.
double cruise(const tern::Path& path, const tern::Limits& limits) {
  double sum = 0.0;
  for (int i = 0; i + 1 < path.count; ++i) {
    const tern::Vec3& a = path.points[i];
    const tern::Vec3& b = path.points[i + 1];
    sum += std::max({std::fabs(b.x - a.x) / limits.v_max.x, std::fabs(b.y - a.y) / limits.v_max.y,
                     std::fabs(b.z - a.z) / limits.v_max.z});
  }
  return sum;
}

/// The vias, each of which can be reached from the one before; and the plans between them.
bool find_legs(Session& session, tern_test::Random& random, const Options& options, Scenario& mission, Pair& pair) {
  constexpr int kTries = 2000;
  Scenario leg = mission;
  for (int tries = 0; static_cast<int>(mission.vias.size()) <= options.vias && tries < kTries; ++tries) {
    const bool last = static_cast<int>(mission.vias.size()) == options.vias;
    leg.goal.position = last ? mission.goal.position : random_point(random, mission.boundary);
    if (!last && distance(leg.start.position, leg.goal.position) > options.reach) continue;
    const PlanResult plan = session.plan(leg);
    if (!plan.ok()) continue;
    pair.legs_duration += tern::duration(plan.trajectory);
    pair.legs_time += plan.timing.total() - plan.timing.inflate;
    pair.legs_units += plan.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work;
    if (last) return true;
    mission.vias.push_back({leg.goal.position, options.tolerance, false, false, {}});
    leg.start.position = leg.goal.position;
  }
  return false;
}

bool fly(Session& session, const std::string& file, const Options& options, std::uint64_t seed, Pair& pair) {
  tern_test::Random random(seed);
  Scenario mission = tern_host::named_scenario(file);
  mission.time_weight = options.time_weight;
  session.plan(mission);  // both sides begin with what the search knows about the map
  if (!find_legs(session, random, options, mission, pair)) return false;
  const PlanResult plan = session.plan(mission);
  pair.status = tern::status_name(plan.report.status);
  pair.duration = tern::duration(plan.trajectory);
  if (plan.path != nullptr) pair.cruise = cruise(*plan.path, mission.limits);
  pair.time = plan.timing.total() - plan.timing.inflate;
  pair.units = plan.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work;
  pair.optimised = plan.report.quality == tern::Quality::kOptimised;
  return true;
}

void print(const char* what, const std::vector<double>& values) {
  std::printf("%s: median %.3f, 10 to 90 %% %.3f to %.3f, %.3f to %.3f\n", what, quantile(values, 0.5),
              quantile(values, 0.1), quantile(values, 0.9), quantile(values, 0.0), quantile(values, 1.0));
}

/// Ten gates in a row in an empty world, for each seed.
int measure_gates(const Options& options) {
  std::vector<double> climbed;
  std::vector<double> point_mass;
  for (int seed = 1; seed <= options.gates; ++seed) {
    const tern_bench::GateTimes times =
        tern_bench::fly_gates(static_cast<std::uint64_t>(seed), options.time_weight, options.tolerance, options.rounds);
    std::printf("course %d: %.3f s, %.3f s after the climb, %.3f s as a point mass\n", seed, times.planned,
                times.climbed, times.point_mass);
    if (!(times.planned > 0.0)) continue;
    climbed.push_back(times.planned / times.climbed);
    point_mass.push_back(times.planned / times.point_mass);
  }
  std::printf("%zu of %d courses planned\n", climbed.size(), options.gates);
  if (climbed.empty()) return 1;
  print("duration over the best of the climb", climbed);
  print("duration over the point mass's", point_mass);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Missions beside plans from stop to stop");
  Options options;
  app.add_option("FILE", options.files, "Scenarios")->check(CLI::ExistingFile);
  app.add_option("--csv", options.csv, "Write a row for each mission");
  app.add_option("--vias", options.vias, "Vias of each mission")->check(CLI::Range(1, int{tern::kMaxVias}));
  app.add_option("--tolerance", options.tolerance, "Tolerance of each via, metres");
  app.add_option("--reach", options.reach, "Farthest that a via may be from the one before, metres");
  app.add_option("--time-weight", options.time_weight, "Weight of time");
  app.add_option("--gates", options.gates, "Instead of scenarios: courses of ten gates in a row at the limits");
  app.add_option("--rounds", options.rounds, "Trials of the climb over the velocities at the gates");
  CLI11_PARSE(app, argc, argv);
  if (options.gates > 0) return measure_gates(options);
  std::ofstream csv;
  if (!options.csv.empty()) csv.open(options.csv);
  csv << "scenario,status,duration_s,legs_s,us,legs_us,units,legs_units\n";
  Session session;
  std::vector<double> ratios;
  std::vector<double> cruises;
  std::vector<double> times;
  std::vector<double> units;
  int missions = 0;
  int optimised = 0;
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    Pair pair;
    if (!fly(session, options.files[i], options, i + 1, pair)) continue;
    ++missions;
    optimised += pair.optimised ? 1 : 0;
    csv << options.files[i] << ',' << pair.status << ',' << pair.duration << ',' << pair.legs_duration << ','
        << pair.time << ',' << pair.legs_time << ',' << pair.units << ',' << pair.legs_units << '\n';
    if (pair.status != "ok") continue;
    ratios.push_back(pair.duration / pair.legs_duration);
    cruises.push_back(pair.cruise / pair.legs_duration);
    times.push_back(pair.time / pair.legs_time);
    units.push_back(static_cast<double>(pair.units) / static_cast<double>(pair.legs_units));
  }
  std::printf("%d missions, %zu planned, %d optimised\n", missions, ratios.size(), optimised);
  print("duration over that of the legs with stops", ratios);
  print("cruising along the path without turns, likewise", cruises);
  print("planning time over that of the legs", times);
  print("units of work over those of the legs", units);
  return 0;
}
