// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/ompl_planner.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

namespace tern_bench {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using Space = ob::RealVectorStateSpace;

tern::Vec3 point_of(const ob::State* state) {
  const double* values = state->as<Space::StateType>()->values;
  return {values[0], values[1], values[2]};
}

/// Exact lines instead of OMPL's samples along them.
class VoxelLines final : public ob::MotionValidator {
 public:
  VoxelLines(const ob::SpaceInformationPtr& information, const tern::Grid& grid)
      : ob::MotionValidator(information), grid_(grid) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return voxels_free(grid_, point_of(a), point_of(b));
  }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last) const override {
    if (checkMotion(a, b)) return true;
    last.second = 0.0;
    if (last.first != nullptr) si_->copyState(last.first, a);
    return false;
  }

 private:
  const tern::Grid& grid_;
};

/// The grid's boundary, local frame.
ob::StateSpacePtr space_of(const tern::Grid& grid) {
  const tern::Box boundary = grid.local_boundary();
  ob::RealVectorBounds bounds(3);
  bounds.low = {boundary.lower.x, boundary.lower.y, boundary.lower.z};
  bounds.high = {boundary.upper.x, boundary.upper.y, boundary.upper.z};
  const auto space = std::make_shared<Space>(3);
  space->setBounds(bounds);
  return space;
}

ob::ScopedState<Space> state_of(const ob::StateSpacePtr& space, const tern::Vec3& local) {
  ob::ScopedState<Space> state(space);
  state->values[0] = local.x;
  state->values[1] = local.y;
  state->values[2] = local.z;
  return state;
}

ob::PlannerPtr planner_of(const ob::SpaceInformationPtr& information, OmplAlgorithm algorithm) {
  if (algorithm == OmplAlgorithm::kPrm) return std::make_shared<og::PRM>(information);
  return std::make_shared<og::RRTstar>(information);
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A planner at work on a query, which goes on from where it stopped.
class OmplRun {
 public:
  OmplRun(const tern::Grid& grid, const OmplQuery& query)
      : grid_(grid), space_(space_of(grid)), setup_(space_), begin_(seconds_now()) {
    const ob::SpaceInformationPtr information = setup_.getSpaceInformation();
    setup_.setStateValidityChecker(
        [&grid](const ob::State* state) { return grid.free(grid.voxel_of(point_of(state))); });
    information->setMotionValidator(std::make_shared<VoxelLines>(information, grid));
    setup_.setStartAndGoalStates(state_of(space_, grid.to_local(query.start)),
                                 state_of(space_, grid.to_local(query.goal)));
    objective_ = std::make_shared<ob::PathLengthOptimizationObjective>(information);
    setup_.setOptimizationObjective(objective_);
    setup_.setPlanner(planner_of(information, query.algorithm));
  }

  double elapsed() const { return seconds_now() - begin_; }

  /// For so many seconds, or until there is any solution.
  void solve(double seconds, bool first) {
    objective_->setCostThreshold(first ? objective_->infiniteCost() : objective_->identityCost());
    // A solution of the lower aim would be taken for the better one whatever its length.
    setup_.getProblemDefinition()->clearSolutionPaths();
    setup_.solve(seconds);
  }

  OmplResult result(double seconds) const {
    OmplResult result;
    result.seconds = seconds;
    result.solved = setup_.haveExactSolutionPath();
    if (!result.solved) return result;
    result.length = setup_.getSolutionPath().length();
    const tern::Vec3& origin = grid_.spec().origin;
    for (const ob::State* state : setup_.getSolutionPath().getStates()) {
      const tern::Vec3 local = point_of(state);
      result.path.push_back({local.x + origin.x, local.y + origin.y, local.z + origin.z});
    }
    return result;
  }

 private:
  const tern::Grid& grid_;
  ob::StateSpacePtr space_;
  og::SimpleSetup setup_;
  ob::OptimizationObjectivePtr objective_;
  double begin_;
};

/// The parameters of the segment at which it passes from one voxel to the next along one axis.
void add_crossings(double from, double to, double cell, std::vector<double>& out) {
  const double low = std::min(from, to) / cell;
  const double high = std::max(from, to) / cell;
  for (double plane = std::floor(low) + 1.0; plane < high; plane += 1.0) {
    out.push_back((plane * cell - from) / (to - from));
  }
}

}  // namespace

bool voxels_free(const tern::Grid& grid, const tern::Vec3& a, const tern::Vec3& b) {
  thread_local std::vector<double> crossings;
  crossings.assign({0.0, 1.0});
  const double cell = grid.spec().cell;
  add_crossings(a.x, b.x, cell, crossings);
  add_crossings(a.y, b.y, cell, crossings);
  add_crossings(a.z, b.z, cell, crossings);
  std::sort(crossings.begin(), crossings.end());
  // Between two crossings the segment stays in one voxel.
  for (std::size_t k = 1; k < crossings.size(); ++k) {
    const double t = 0.5 * (crossings[k - 1] + crossings[k]);
    if (!grid.free(grid.voxel_of({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)}))) return false;
  }
  return true;
}

std::vector<OmplResult> ompl_plan(const tern::Grid& grid, const OmplQuery& query) {
  ompl::msg::noOutputHandler();
  ompl::RNG::setSeed(query.seed);
  OmplRun run(grid, query);
  std::vector<OmplResult> results;
  run.solve(query.times.back(), true);
  results.push_back(run.result(run.elapsed()));
  for (const double time : query.times) {
    const double left = time - run.elapsed();
    if (left > 0.0) run.solve(left, false);
    // What took longer than this to find was not there by then.
    const bool late = results.front().seconds > time;
    results.push_back(late ? OmplResult{} : run.result(time));
  }
  return results;
}

}  // namespace tern_bench
