// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Table 8 and Figure 24: whole planners on random maps.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#ifdef TERN_HAVE_NLOPT
#include "baselines/soft_bspline.hpp"
#endif
#include "host/figures.hpp"
#include "host/number.hpp"
#include "paper/experiments.hpp"
#include "paper/figure.hpp"
#include "paper/front_end.hpp"
#include "paper/random_map.hpp"
#include "paper/statistics.hpp"
#include "tern/tern.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;
using tern_host::fixed;

constexpr double kStep = 2e-3;
/// First intervals of the B-spline, as multiples of what the limit speed would need.
constexpr double kUnhurriedPace = 1.5;
constexpr double kBriskPace = 1.0;
/// What a sampled clearance and limit may fall short by: 1 mm, 1 %.
constexpr double kClearanceSlack = 1e-3;
constexpr double kLimitSlack = 1.01;

enum Method { kTern, kSoft, kBrisk, kSlowed, kMethods };
constexpr const char* kNames[kMethods] = {"Tern", "soft unhurried", "soft brisk", "soft brisk slowed"};

/// A flight, sampled densely and independently of whoever planned it.
struct Flight {
  double duration = 0.0, length = 0.0, jerk_cost = 0.0, v_peak = 0.0, a_peak = 0.0, clearance = 0.0;
};

double largest(const Vec3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

template <typename Evaluate>
Flight fly(double duration, const tern_host::Scenario& scenario, Evaluate evaluate) {
  Flight flight;
  flight.duration = duration;
  flight.clearance = std::numeric_limits<double>::infinity();
  const int samples = std::max(1, static_cast<int>(std::ceil(duration / kStep)));
  Vec3 last = scenario.start.position;
  for (int i = 0; i <= samples; ++i) {
    const tern::Sample s = evaluate(duration * i / samples);
    flight.length += tern_bench::distance(last, s.position);
    last = s.position;
    flight.v_peak = std::max(flight.v_peak, largest(s.velocity));
    flight.a_peak = std::max(flight.a_peak, largest(s.acceleration));
    const Vec3& j = s.jerk;
    flight.jerk_cost += (j.x * j.x + j.y * j.y + j.z * j.z) * duration / (samples + 1);
    flight.clearance = std::min(flight.clearance, tern_host::distance_to_blocks(s.position, scenario));
  }
  return flight;
}

struct Tally {
  int runs = 0, failed = 0, hits = 0, beyond = 0, success = 0;
  std::vector<double> costs, times, durations, lengths, peaks;

  void add(const Flight& flight, double time, const tern_host::Scenario& scenario) {
    ++runs;
    const bool hit = flight.clearance < scenario.radius - kClearanceSlack;
    const bool fast =
        flight.v_peak > kLimitSlack * scenario.limits.v_max.x || flight.a_peak > kLimitSlack * scenario.limits.a_max.x;
    hits += hit ? 1 : 0;
    beyond += fast ? 1 : 0;
    success += hit || fast ? 0 : 1;
    costs.push_back(flight.jerk_cost);
    times.push_back(time);
    durations.push_back(flight.duration);
    lengths.push_back(flight.length);
    peaks.push_back(flight.a_peak);
  }
  void add_failure() {
    ++runs;
    ++failed;
  }
};

using Tallies = std::array<Tally, kMethods>;

/// Tern's planner with its memory, timed like the others: processor time, from the inflated grid on.
class TimedTern {
 public:
  TimedTern() : memory_(new unsigned char[tern::kWorkspaceBytes]), planner_(memory_.get(), tern::kWorkspaceBytes) {}

  tern::Status plan(const ScenarioGrid& world, const tern_host::Scenario& scenario) {
    tern::Request request{};
    request.start = scenario.start;
    request.goal = scenario.goal;
    request.limits = scenario.limits;
    const double begin = thread_time();
    const tern::Status status = planner_.plan(world.grid(), request, trajectory, report);
    time = thread_time() - begin;
    return status;
  }

  tern::Trajectory trajectory{};
  tern::Report report{};
  double time = 0.0;  ///< milliseconds

 private:
  std::unique_ptr<unsigned char[]> memory_;
  tern::Planner planner_;
};

/// False where start and goal are not connected.
bool add_tern(TimedTern& tern, const ScenarioGrid& world, const tern_host::Scenario& scenario, Tallies& tallies,
              int& stop_and_go) {
  const tern::Status status = tern.plan(world, scenario);
  if (status == tern::Status::kNoPath) return false;
  if (status != tern::Status::kOk) {
    progress(scenario.name + ": " + tern::status_name(status));
    tallies[kTern].add_failure();
    return true;
  }
  stop_and_go += tern.report.quality == tern::Quality::kStopAndGo ? 1 : 0;
  const Flight flight =
      fly(tern::duration(tern.trajectory), scenario, [&](double t) { return tern::evaluate(tern.trajectory, t); });
  tallies[kTern].add(flight, tern.time, scenario);
  return true;
}

#ifdef TERN_HAVE_NLOPT
/// The same curve, flown so slowly that its peaks are at the limits where they were above them.
BSpline slowed(const BSpline& curve, const Flight& flight, const tern_host::Scenario& scenario) {
  BSpline slower = curve;
  slower.interval *=
      std::max({1.0, flight.v_peak / scenario.limits.v_max.x, std::sqrt(flight.a_peak / scenario.limits.a_max.x)});
  return slower;
}

void add_soft(const ScenarioGrid& world, const tern_host::Scenario& scenario, Tallies& tallies) {
  const TimedRoute route = plain_astar(world, scenario, 1);
  if (!route.route.found) {
    for (const Method method : {kSoft, kBrisk, kSlowed}) tallies[method].add_failure();
    return;
  }
  const auto flown = [&](const BSpline& curve) {
    return fly(curve.duration(), scenario, [&](double t) { return curve.evaluate(t); });
  };
  for (const bool brisk : {false, true}) {
    SoftWeights weights;
    weights.pace = brisk ? kBriskPace : kUnhurriedPace;
    const double begin = thread_time();
    const SoftResult result = soft_bspline(route.route.points, scenario, weights);
    const double time = route.time + (thread_time() - begin);
    const Flight flight = flown(result.curve);
    tallies[brisk ? kBrisk : kSoft].add(flight, time, scenario);
    if (brisk) tallies[kSlowed].add(flown(slowed(result.curve, flight, scenario)), time, scenario);
  }
}
#endif

void write_rows(Table& table, const std::string& set, const Tallies& tallies, int unsolvable, int stop_and_go) {
  for (std::size_t m = 0; m < kMethods; ++m) {
    const Tally& t = tallies[m];
    if (t.runs == 0) continue;
    std::vector<std::string> row{set,
                                 kNames[m],
                                 std::to_string(t.runs),
                                 std::to_string(unsolvable),
                                 std::to_string(t.failed),
                                 std::to_string(t.hits),
                                 std::to_string(t.beyond),
                                 std::to_string(t.success),
                                 m == kTern ? std::to_string(stop_and_go) : ""};
    for (const std::vector<double>* values : {&t.costs, &t.times, &t.durations, &t.lengths, &t.peaks}) {
      row.push_back(fixed(quantile(*values, 0.0), 4));
      row.push_back(fixed(mean(*values), 4));
      row.push_back(fixed(quantile(*values, 0.5), 4));
      row.push_back(fixed(quantile(*values, 1.0), 4));
    }
    table.row(row);
  }
}

std::string columns() {
  std::string text = "set,method,maps,unsolvable,failed,hits,beyond,success,stop_and_go";
  for (const char* quantity : {"cost", "time_ms", "duration_s", "length_m", "a_peak"}) {
    for (const char* what : {"min", "mean", "median", "max"}) text += std::string(",") + quantity + "_" + what;
  }
  return text;
}

/// Values in ascending order against the part of the maps.
Curve sorted_curve(std::vector<double> values, const std::string& style) {
  std::sort(values.begin(), values.end());
  Curve curve{{}, {}, style};
  for (std::size_t i = 0; i < values.size(); ++i) {
    curve.x.push_back(100.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(values.size()));
    curve.y.push_back(values[i]);
  }
  return curve;
}

void draw_figure(const Run& run, const Tallies& all) {
  const char* const colours[kMethods] = {"#a01e96", "#2f8f5b", "#c8553d", "#2b6cb0"};
  Figure figure("Figure 24: path length and peak acceleration over all maps", "planners");
  std::vector<Key> keys;
  std::vector<Curve> lengths, peaks;
  double longest = 0.0;
  for (std::size_t m = 0; m < kMethods; ++m) {
    if (all[m].lengths.empty()) continue;
    const std::string style = std::string("class=\"curve\" stroke=\"") + colours[m] + "\"";
    keys.push_back({kNames[m], style});
    lengths.push_back(sorted_curve(all[m].lengths, style));
    peaks.push_back(sorted_curve(all[m].peaks, style));
    longest = std::max(longest, quantile(all[m].lengths, 1.0));
  }
  peaks.push_back({{0.0, 100.0}, {2.0, 2.0}, "class=\"limit\" stroke=\"#8b2e2e\""});
  keys.push_back({"limit of an axis", "class=\"limit\" stroke=\"#8b2e2e\""});
  figure.legend(keys);
  const double x = kFigureMargin + kPanelLeft;
  const double width = kFigureWidth - x - kFigureMargin;
  const Rect first{x, figure.top() + kPanelAbove, width, 230.0};
  const Rect second{x, first.bottom() + kPanelBelow + kPanelAbove, width, 230.0};
  draw_plot(figure.canvas(), {first, {0.0, 100.0}, {0.0, 1.05 * longest}}, lengths, "Length of the trajectory",
            "part of the maps, each method in its own order (%)", "m");
  draw_plot(figure.canvas(), {second, {0.0, 100.0}, {0.0, 6.0}}, peaks,
            "Peak acceleration of an axis (cut off at 6 m/s²)", "part of the maps, each method in its own order (%)",
            "m/s²");
  figure.write(run, "planners.svg", second.bottom() + kPanelBelow);
}

void append(Tally& all, const Tally& t) {
  all.runs += t.runs;
  all.failed += t.failed;
  all.hits += t.hits;
  all.beyond += t.beyond;
  all.success += t.success;
  const auto add = [](std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  add(all.costs, t.costs);
  add(all.times, t.times);
  add(all.durations, t.durations);
  add(all.lengths, t.lengths);
  add(all.peaks, t.peaks);
}

}  // namespace

void planners_experiment(const Run& run) {
  Table table(columns());
  TimedTern tern;
  Tallies all;
  int all_unsolvable = 0;
  int all_stops = 0;
#ifndef TERN_HAVE_NLOPT
  progress("built without NLopt: the soft B-spline is left out");
#endif
  for (const int percent : {10, 15, 20, 25, 30}) {
    const MapKind kind{"forest", {20.0, 20.0, 4.0}, 0.01 * percent, 0.1, 0.25, 0.5};
    Tallies tallies;
    int unsolvable = 0;
    int stops = 0;
    for (int seed = 1; seed <= pick(run, 220, 8); ++seed) {
      if (seed % 20 == 0) progress(std::to_string(percent) + " %: map " + std::to_string(seed));
      const tern_host::Scenario scenario = random_map(kind, static_cast<std::uint64_t>(1000 * percent + seed));
      const ScenarioGrid world(scenario);
      if (!add_tern(tern, world, scenario, tallies, stops)) {
        ++unsolvable;
        continue;
      }
#ifdef TERN_HAVE_NLOPT
      add_soft(world, scenario, tallies);
#endif
    }
    write_rows(table, std::to_string(percent) + " %", tallies, unsolvable, stops);
    for (std::size_t m = 0; m < kMethods; ++m) append(all[m], tallies[m]);
    all_unsolvable += unsolvable;
    all_stops += stops;
  }
  write_rows(table, "all", all, all_unsolvable, all_stops);
  table.write(run, "planners.csv");
  draw_figure(run, all);
}

}  // namespace tern_bench
