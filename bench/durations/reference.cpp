// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans beside the best that an interior-point solver finds for the same segments, corridor and rows: their cost at the
// plan's weight, and the least duration. tools/bench reference runs it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <coin/IpIpoptApplication.hpp>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "durations/duration_programme.hpp"
#include "host/flight/family_scenario.hpp"
#include "host/session.hpp"
#include "quantile.hpp"
#include "times/time_unit.hpp"
#include "trajectory/relative_corridor.hpp"

namespace {

/// Stands for the least duration.
constexpr double kLeastTime = 1e6;

struct Best {
  double cost = 0.0;
  double seconds = 0.0;
};

/// What the reference needs of a plan.
struct Given {
  std::unique_ptr<tern::Corridor> corridor;
  tern::MotionLimits limits;
  double unit;
};

Given given_by(const tern_host::PlanResult& result) {
  Given given{std::make_unique<tern::Corridor>(), result.scenario.limits, 0.0};
  const tern::Vec3 goal = result.scenario.goal.position - result.trajectory.origin;
  tern::relative_corridor(*result.corridor, result.trajectory.origin - result.grid.origin, {}, goal, {},
                          *given.corridor);
  const auto chain = std::make_unique<tern::Chain>();
  chain->goal.d[0] = goal;
  given.unit = tern::time_unit(*chain, *given.corridor, given.limits);
  return given;
}

double cost_of(const tern::Trajectory& plan, double rate) {
  return tern::snap_cost(plan) + rate * tern::duration(plan);
}

class Reference {
 public:
  /// `near`: the search stays near the plan that it begins at.
  Reference(int iterations, bool near) : ipopt_(IpoptApplicationFactory()) {
    ipopt_->Options()->SetIntegerValue("print_level", 0);
    ipopt_->Options()->SetStringValue("sb", "yes");
    ipopt_->Options()->SetIntegerValue("max_iter", iterations);
    ipopt_->Options()->SetNumericValue("tol", 1e-6);
    ipopt_->Options()->SetNumericValue("acceptable_tol", 1e-4);
    ipopt_->Options()->SetStringValue("mu_strategy", near ? "monotone" : "adaptive");
    if (near) {
      ipopt_->Options()->SetNumericValue("mu_init", 0.1);
      ipopt_->Options()->SetNumericValue("bound_push", 1e-6);
      ipopt_->Options()->SetNumericValue("slack_bound_push", 1e-6);
    }
    ipopt_->Initialize();
  }

  /// The best of all plans and of what a search from one of them finds.
  Best solve(const Given& given, const std::vector<tern::Trajectory>& plans, std::size_t from, double weight) {
    const double rate = weight * given.unit;
    Best best;
    for (const tern::Trajectory& plan : plans) take({cost_of(plan, rate), tern::duration(plan)}, best);
    const Ipopt::SmartPtr<tern_bench::DurationProgramme> programme =
        new tern_bench::DurationProgramme(*given.corridor, given.limits, plans[from], rate);
    ipopt_->OptimizeTNLP(programme);
    ++searches_;
    if (programme->converged()) ++converged_;
    if (programme->keeps_rows()) take({programme->cost(), programme->duration()}, best);
    return best;
  }
  void print() const { std::printf("%d of %d searches converged\n", converged_, searches_); }

 private:
  static void take(const Best& found, Best& best) {
    if (!(best.cost > 0.0) || found.cost < best.cost) best = found;
  }

  Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt_;
  int searches_ = 0;
  int converged_ = 0;
};

/// One weight's plans, each over the reference.
struct Ratios {
  std::vector<double> cost, duration, least;

  void print(double weight) const {
    using tern_bench::quantile;
    std::printf("weight %6g, %zu plans: cost over the best %.4f median, %.4f p90, %.4f worst; ", weight, cost.size(),
                quantile(cost, 0.5), quantile(cost, 0.9), quantile(cost, 1.0));
    std::printf("duration over the best %.4f, %.4f, %.4f; over the least %.4f, %.4f, %.4f\n", quantile(duration, 0.5),
                quantile(duration, 0.9), quantile(duration, 1.0), quantile(least, 0.5), quantile(least, 0.9),
                quantile(least, 1.0));
  }
};

/// A scenario's plans, one a weight; none unless the optimiser made all of them.
std::vector<tern::Trajectory> plans_of(tern_host::Session& session, const std::string& file,
                                       const std::vector<double>& weights, Given& given) {
  tern_host::Scenario scenario = tern_host::named_scenario(file);
  std::vector<tern::Trajectory> plans;
  for (const double weight : weights) {
    scenario.time_weight = weight;
    const tern_host::PlanResult result = session.plan(scenario);
    if (!result.ok() || result.report.quality != tern::Quality::kOptimised) return {};
    plans.push_back(result.trajectory);
    given = given_by(result);
  }
  return plans;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Plans beside an interior-point solver's, from rest to rest");
  std::vector<std::string> files;
  std::vector<double> weights{40, 200, 1000};
  std::string csv_path;
  int iterations = 120;
  bool no_least = false;
  bool near = false;
  app.add_option("FILE", files, "Scenarios")->required()->check(CLI::ExistingFile);
  app.add_option("--weights", weights, "Time weights");
  app.add_option("--iterations", iterations, "The most iterations of IPOPT for each plan");
  app.add_flag("--no-least", no_least, "Do not look for the least duration");
  app.add_flag("--near", near, "Stay near the plan, which finds better ones with limits of thrust, tilt and rates");
  app.add_option("--csv", csv_path, "Write a row for each plan");
  CLI11_PARSE(app, argc, argv);
  std::ofstream csv;
  if (!csv_path.empty()) csv.open(csv_path);
  csv.precision(9);
  csv << "case,time_weight,duration_s,cost,best_duration_s,best_cost,least_duration_s\n";
  tern_host::Session session;
  Reference reference(iterations, near);
  std::vector<Ratios> ratios(weights.size());
  for (const std::string& file : files) {
    Given given;
    const std::vector<tern::Trajectory> plans = plans_of(session, file, weights, given);
    if (plans.empty()) continue;
    const double least =
        no_least ? tern::duration(plans.back()) : reference.solve(given, plans, plans.size() - 1, kLeastTime).seconds;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const Best best = reference.solve(given, plans, i, weights[i]);
      const double cost = cost_of(plans[i], weights[i] * given.unit);
      const double seconds = tern::duration(plans[i]);
      ratios[i].cost.push_back(cost / best.cost);
      ratios[i].duration.push_back(seconds / best.seconds);
      ratios[i].least.push_back(seconds / least);
      csv << file << ',' << weights[i] << ',' << seconds << ',' << cost << ',' << best.seconds << ',' << best.cost
          << ',' << least << std::endl;
    }
  }
  for (std::size_t i = 0; i < weights.size(); ++i) ratios[i].print(weights[i]);
  reference.print();
  return 0;
}
