// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long plans take: over a ladder of time weights and over ladders of limits, and how often the higher rung is the
// slower flight; and how much later a replan from a plan's own states arrives than that plan. tools/bench durations
// runs it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "host/flight/family_scenario.hpp"
#include "host/session.hpp"
#include "quantile.hpp"

namespace {

using tern_bench::quantile;

const double kWeights[] = {10, 40, 100, 200, 500, 1000, 1e4};
const double kLengths[] = {0.1, 0.3, 1, 3, 10, 30, 100};
const double kSpeeds[] = {0.5, 1, 2, 3, 5, 7, 10, 14, 20};
const double kAccelerations[] = {0.5, 1, 2, 4, 8, 16};
const double kFactors[] = {1, 1.25, 1.5, 2, 3, 5};
const double kLegs[] = {0.1, 0.3, 1, 2, 4, 6, 7.5, 8, 9, 10, 12, 14, 16, 18, 20, 25, 30, 40, 60, 100};
const double kLegSpeeds[] = {1, 2, 3, 5, 10, 20};
const double kLegAccelerations[] = {1, 2, 4, 10};

/// A flight that is longer by more than this part is a slower one.
constexpr double kSlower = 1e-3;

/// Neighbouring rungs of ladders, and those where the higher one is slower.
struct Ladder {
  int pairs = 0;
  int slower = 0;
  double worst = 1.0;
  double last = 0.0;

  void begin() { last = 0.0; }
  void climb(double seconds) {
    if (last > 0.0 && seconds > 0.0) {
      ++pairs;
      worst = std::max(worst, seconds / last);
      slower += seconds > last * (1.0 + kSlower) ? 1 : 0;
    }
    last = seconds;
  }
  void print(const char* name) const {
    std::printf("%-28s %5d pairs, %4d slower, the worst %+.2f %%\n", name, pairs, slower, 100.0 * (worst - 1.0));
  }
};

struct Tally {
  std::vector<double> seconds, snap, units, programmes;
};

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

class Bench {
 public:
  explicit Bench(std::ofstream& csv) : csv_(csv) {}

  /// The plan; of no segments where there is none.
  tern::Trajectory trajectory(const tern_host::Scenario& scenario) {
    const tern_host::PlanResult result = session_.plan(scenario);
    return result.ok() ? result.trajectory : tern::Trajectory{};
  }

  /// Seconds of the plan; 0 where there is none.
  double fly(const tern_host::Scenario& scenario, Tally* tally = nullptr, const tern::Trajectory* previous = nullptr,
             double previous_time = 0.0) {
    const tern_host::PlanResult result = session_.plan(scenario, previous, previous_time);
    if (!result.ok()) return 0.0;
    const double seconds = tern::duration(result.trajectory) - result.report.entered;
    const double snap = tern::snap_cost(result.trajectory);
    csv_ << scenario.name << ',' << scenario.limits.v_max.x << ',' << scenario.limits.a_max.x << ','
         << scenario.time_weight << ',' << seconds << ',' << snap << ','
         << result.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work << ','
         << result.report.diagnostics.high_water.qp_solves << ',' << static_cast<int>(result.report.quality) << '\n';
    if (tally == nullptr) return seconds;
    tally->seconds.push_back(seconds);
    tally->snap.push_back(snap);
    tally->units.push_back(
        static_cast<double>(result.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work));
    tally->programmes.push_back(result.report.diagnostics.high_water.qp_solves);
    return seconds;
  }

 private:
  std::ofstream& csv_;
  tern_host::Session session_;
};

void print(const std::string& group, double weight, const Tally& tally, const Ladder& ladder) {
  std::printf("%-10s %6g %4zu plans, %6.2f s median, %6.2f mean, snap %7.1f, units %4.0f (p99 %4.0f), ", group.c_str(),
              weight, tally.seconds.size(), quantile(tally.seconds, 0.5), mean(tally.seconds),
              quantile(tally.snap, 0.5), quantile(tally.units, 0.5), quantile(tally.units, 0.99));
  std::printf("programmes %2.0f (%2.0f), %3d slower, the worst %+.2f %%\n", quantile(tally.programmes, 0.5),
              quantile(tally.programmes, 1.0), ladder.slower, 100.0 * (ladder.worst - 1.0));
}

/// "forest_10_002.txt" is of the group "forest_10", "map3.txt" of "map".
std::string group_of(const std::string& file) {
  const std::string stem = std::filesystem::path(file).stem();
  return stem.substr(0, stem.find_last_not_of("_0123456789") + 1) + stem.substr(stem.find_first_of("_0123456789"), 3);
}

void over_weights(Bench& bench, const std::string& group, const std::vector<std::string>& files) {
  std::map<double, Tally> tallies;
  std::map<double, Ladder> ladders;
  for (const std::string& file : files) {
    tern_host::Scenario scenario = tern_host::named_scenario(file);
    double last = 0.0;
    for (const double weight : kWeights) {
      scenario.time_weight = weight;
      ladders[weight].last = last;
      last = bench.fly(scenario, &tallies[weight]);
      ladders[weight].climb(last);
    }
  }
  for (const auto& [weight, tally] : tallies) print(group, weight, tally, ladders[weight]);
}

/// A straight leg along x with nothing around.
tern_host::Scenario empty_space(double length) {
  tern_host::Scenario scenario;
  scenario.name = "leg" + std::to_string(length);
  scenario.resolution = length > 20.0 ? 0.5 : 0.2;
  scenario.boundary = {{0, 0, 0}, {length + 8.0, 8.0, 8.0}};
  scenario.start.position = {4.1, 4.1, 4.1};
  scenario.goal.position = {4.1 + length, 4.1, 4.1};
  return scenario;
}

void set_limits(tern_host::Scenario& scenario, double v, double a) {
  scenario.limits = {{v, v, v}, {a, a, a}};
}

/// A trapezoidal profile's seconds: the least that a vehicle without a limit on jerk takes.
double least_seconds(double length, double v, double a) {
  return length * a < v * v ? 2.0 * std::sqrt(length / a) : length / v + v / a;
}

void over_least_time(Bench& bench, double weight) {
  std::printf("empty space, weight %g: duration over the trapezoid's\n", weight);
  for (const double length : kLegs) {
    tern_host::Scenario scenario = empty_space(length);
    scenario.time_weight = weight;
    Tally tally;
    std::vector<double> ratio;
    for (const double a : kLegAccelerations) {
      for (const double v : kLegSpeeds) {
        set_limits(scenario, v, a);
        ratio.push_back(bench.fly(scenario, &tally) / least_seconds(length, v, a));
      }
    }
    std::printf("  %5g m: %.3f median, %.3f worst; units %.0f median, %.0f worst\n", length, quantile(ratio, 0.5),
                quantile(ratio, 1.0), quantile(tally.units, 0.5), quantile(tally.units, 1.0));
  }
}

void over_limits_in_empty_space(Bench& bench, double weight) {
  Ladder speeds, accelerations;
  for (const double length : kLengths) {
    tern_host::Scenario scenario = empty_space(length);
    scenario.time_weight = weight;
    for (const double a : kAccelerations) {
      speeds.begin();
      for (const double v : kSpeeds) {
        set_limits(scenario, v, a);
        speeds.climb(bench.fly(scenario));
      }
    }
    for (const double v : kSpeeds) {
      accelerations.begin();
      for (const double a : kAccelerations) {
        set_limits(scenario, v, a);
        accelerations.climb(bench.fly(scenario));
      }
    }
  }
  std::printf("empty space, weight %g\n", weight);
  speeds.print("  raising v_max");
  accelerations.print("  raising a_max");
}

void over_limits(Bench& bench, const std::vector<std::string>& files, double weight) {
  Ladder speeds, accelerations;
  for (const std::string& file : files) {
    const tern_host::Scenario given = tern_host::named_scenario(file);
    tern_host::Scenario scenario = given;
    scenario.time_weight = weight;
    speeds.begin();
    for (const double factor : kFactors) {
      set_limits(scenario, factor * given.limits.v_max.x, given.limits.a_max.x);
      speeds.climb(bench.fly(scenario));
    }
    accelerations.begin();
    for (const double factor : kFactors) {
      set_limits(scenario, given.limits.v_max.x, factor * given.limits.a_max.x);
      accelerations.climb(bench.fly(scenario));
    }
  }
  std::printf("the scenarios, weight %g\n", weight);
  speeds.print("  raising v_max");
  accelerations.print("  raising a_max");
}

/// Replans along plans. One a goal, in the same limits and weight.
struct Replans {
  int asked = 0;
  int refused = 0;
  int half_second = 0;  ///< that arrive so much later than the plan they replace
  int two_seconds = 0;
  std::vector<double> ratio;  ///< seconds over what was left of that plan
  Tally tally;

  void add(double seconds, double left) {
    ++asked;
    if (!(seconds > 0.0)) {
      ++refused;
      return;
    }
    half_second += seconds > left + 0.5 ? 1 : 0;
    two_seconds += seconds > left + 2.0 ? 1 : 0;
    ratio.push_back(seconds / left);
  }
  void print(const std::string& group, double weight, const char* handed_over) const {
    std::printf(
        "%-10s %6g replans %-16s %4d, refused %d, later by 0.5 s %d, by 2 s %d; ratio %.4f mean, %.4f median, "
        "%.4f p95, %.4f worst; %.0f units on average\n",
        group.c_str(), weight, handed_over, asked, refused, half_second, two_seconds, mean(ratio), quantile(ratio, 0.5),
        quantile(ratio, 0.95), quantile(ratio, 1.0), mean(tally.units));
  }
};

void over_replans(Bench& bench, const std::string& group, const std::vector<std::string>& files, double weight) {
  constexpr double kEvery = 0.3;
  Replans with_jerk, without, with_plan;
  for (const std::string& file : files) {
    tern_host::Scenario scenario = tern_host::named_scenario(file);
    scenario.time_weight = weight;
    const tern::Trajectory plan = bench.trajectory(scenario);
    const double end = tern::duration(plan);
    for (double t = kEvery; t < end - kEvery; t += kEvery) {
      const tern::Sample now = tern::evaluate(plan, t);
      scenario.start = {now.position, now.velocity, now.acceleration, now.jerk};
      with_jerk.add(bench.fly(scenario, &with_jerk.tally), end - t);
      with_plan.add(bench.fly(scenario, &with_plan.tally, &plan, t), end - t);
      scenario.start.jerk = {0.0, 0.0, 0.0};
      without.add(bench.fly(scenario, &without.tally), end - t);
    }
  }
  with_jerk.print(group, weight, "with jerk");
  without.print(group, weight, "without jerk");
  with_plan.print(group, weight, "previous plan");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Durations over ladders of weights and of limits, and of replans along plans");
  std::vector<std::string> files;
  std::string csv_path;
  bool weights_only = false;
  bool replans_only = false;
  bool legs_only = false;
  app.add_option("FILE", files, "Scenarios")->required()->check(CLI::ExistingFile);
  app.add_option("--csv", csv_path, "Write a row for each plan");
  app.add_flag("--weights-only", weights_only, "Leave out replans and the ladders of limits");
  app.add_flag("--replans-only", replans_only, "Leave out the ladders");
  app.add_flag("--legs-only", legs_only, "Straight legs in empty space over their least time, and nothing else");
  CLI11_PARSE(app, argc, argv);
  std::ofstream csv;
  if (!csv_path.empty()) csv.open(csv_path);
  csv.precision(9);
  csv << "case,v_max,a_max,time_weight,duration_s,snap,units,programmes,quality\n";
  Bench bench(csv);
  std::map<std::string, std::vector<std::string>> groups;
  for (const std::string& file : files) groups[group_of(file)].push_back(file);
  if (!replans_only && !legs_only) {
    for (const auto& [group, members] : groups) over_weights(bench, group, members);
  }
  if (weights_only) return 0;
  if (!legs_only) {
    for (const auto& [group, members] : groups) {
      for (const double weight : {40.0, 1000.0}) over_replans(bench, group, members, weight);
    }
  }
  if (replans_only) return 0;
  for (const double weight : {40.0, 1000.0}) over_least_time(bench, weight);
  if (legs_only) return 0;
  for (const double weight : {10.0, 40.0, 200.0, 1000.0}) over_limits_in_empty_space(bench, weight);
  for (const double weight : {40.0, 1000.0}) over_limits(bench, files, weight);
  return 0;
}
