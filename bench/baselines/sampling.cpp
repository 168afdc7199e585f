// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/sampling.hpp"

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <chrono>
#include <memory>

namespace tern_bench {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using tern::Vec3;

/// States of a motion are checked so far apart, in voxels.
constexpr double kMotionStep = 0.5;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Vec3 point_of(const ob::State* state) {
  const auto* values = state->as<ob::RealVectorStateSpace::StateType>();
  return {values->values[0], values->values[1], values->values[2]};
}

ob::StateSpacePtr space_of(const tern::Box& box) {
  auto space = std::make_shared<ob::RealVectorStateSpace>(3);
  ob::RealVectorBounds bounds(3);
  bounds.low = {box.lower.x, box.lower.y, box.lower.z};
  bounds.high = {box.upper.x, box.upper.y, box.upper.z};
  space->setBounds(bounds);
  return space;
}

/// One planner on one query; solve() goes on from where it stopped.
class Query {
 public:
  Query(Sampler sampler, const tern::Grid& grid, const tern_host::Scenario& scenario)
      : space_(space_of(scenario.boundary)), info_(std::make_shared<ob::SpaceInformation>(space_)) {
    info_->setStateValidityChecker(
        [&grid](const ob::State* s) { return grid.free(grid.voxel_of(grid.to_local(point_of(s)))); });
    info_->setStateValidityCheckingResolution(kMotionStep * grid.spec().cell / space_->getMaximumExtent());
    info_->setup();
    problem_ = std::make_shared<ob::ProblemDefinition>(info_);
    problem_->setStartAndGoalStates(state(scenario.start.position), state(scenario.goal.position), 1e-9);
    objective_ = std::make_shared<ob::PathLengthOptimizationObjective>(info_);
    problem_->setOptimizationObjective(objective_);
    if (sampler == Sampler::kRrtStar) {
      planner_ = std::make_shared<og::RRTstar>(info_);
    } else {
      planner_ = std::make_shared<og::PRM>(info_);
    }
    planner_->setProblemDefinition(problem_);
    planner_->setup();
  }

  /// Until there is a solution, or the time has come.
  void solve_first(double seconds) {
    // Any path will do.
    objective_->setCostThreshold(ob::Cost(objective_->infiniteCost()));
    planner_->solve(ob::timedPlannerTerminationCondition(seconds));
  }
  void improve(double seconds) {
    objective_->setCostThreshold(objective_->identityCost());
    // A solution of the lower aim would be taken for the better one whatever its length.
    problem_->clearSolutionPaths();
    planner_->solve(ob::timedPlannerTerminationCondition(seconds));
  }

  Route route() const {
    Route route;
    route.found = problem_->hasExactSolution();
    if (!route.found) return route;
    const auto path = std::dynamic_pointer_cast<og::PathGeometric>(problem_->getSolutionPath());
    for (const ob::State* s : path->getStates()) route.points.push_back(point_of(s));
    return route;
  }

 private:
  ob::ScopedState<> state(const Vec3& p) const {
    ob::ScopedState<> s(space_);
    s[0] = p.x;
    s[1] = p.y;
    s[2] = p.z;
    return s;
  }

  ob::StateSpacePtr space_;
  ob::SpaceInformationPtr info_;
  ob::ProblemDefinitionPtr problem_;
  ob::OptimizationObjectivePtr objective_;
  ob::PlannerPtr planner_;
};

}  // namespace

bool has_sampling() {
  return true;
}

std::vector<Snapshot> run_sampler(Sampler sampler, const tern::Grid& grid, const tern_host::Scenario& scenario,
                                  std::uint32_t seed, const std::vector<double>& times) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(seed);
  Query query(sampler, grid, scenario);
  const double begin = seconds_now();
  std::vector<Snapshot> snapshots;
  query.solve_first(times.back());
  snapshots.push_back({seconds_now() - begin, query.route()});
  for (const double time : times) {
    const double left = time - (seconds_now() - begin);
    if (left > 0.0) query.improve(left);
    // What took longer than this to find was not there by then.
    const bool late = snapshots.front().time > time;
    snapshots.push_back({time, late ? Route{} : query.route()});
  }
  return snapshots;
}

}  // namespace tern_bench
