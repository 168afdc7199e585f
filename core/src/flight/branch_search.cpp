// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/branch_search.hpp"

#include "base/math.hpp"
#include "flight/foresight.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// Branches must be later than this, in seconds since the draft's beginning. In an extension, a branch no later than
/// the committed one would change nothing. A new plan must fly for two ticks before its branch.
double earliest_branch(const FlightFacts& flight, const Draft& draft) {
  return draft.extends ? flight.plans.in_flight.branch : 2.0 * 1e-9 * static_cast<double>(flight.spec.tick);
}

/// A plan to a lookout moves a resting vehicle by so many voxels at least: the lookout may be in the next one.
constexpr double kLeastLookOut = 0.5;

/// Most brakes that cannot be proven end in what nobody saw. A vehicle that has something within its radius may end
/// there, too.
bool ends_clear(const FlightFacts& flight, const Draft& draft, Work& work) {
  if (draft.plan.hemmed_in) return true;
  const Grid& safe = flight.map.safe();
  const Vec3 end = safe.to_local(draft.plan.end());
  const Voxel voxel = safe.voxel_of(end);
  if (!safe.inside(voxel) || safe.obstacle(voxel)) return false;
  work.spend(clear_operations(safe.spec(), kZero, safe.spec().clearance()));
  return point_clear(safe, end, safe.spec().clearance());
}

}  // namespace

bool leads_on(const FlightFacts& flight, const Vec3& start, const Draft& draft) noexcept {
  const double least = draft.plan.looks_out ? kLeastLookOut : 1.0;
  return !flight.rests_at(draft.takeover) || draft.plan.at_target ||
         distance(draft.plan.end(), start) >= least * flight.map.safe().spec().cell;
}

void BranchSearch::begin(double until) noexcept {
  reached = until;
  candidate = -1;
  is_proving = false;
}

Progress BranchSearch::advance(const FlightFacts& flight, const Vec3& start, Draft& draft, Work& work) noexcept {
  while (is_proving || candidate + 1 < kBranches * kBranchShapes) {
    if (!is_proving) {
      if (!work.left()) return Progress::kMore;
      ++candidate;
      work.spend(draft.branch_operations(flight, candidate % kBranchShapes));
      is_proving = make_candidate(flight, start, draft, work);
      continue;
    }
    if (draft.proof.step(work) == Status::kRunning) return Progress::kMore;
    is_proving = false;
    if (draft.proof.report().finding == Finding::kNone) return Progress::kDone;
  }
  return Progress::kFailed;
}

/// The candidates begin at the last proven instant and go back in time. All brakes are tried at each instant.
bool BranchSearch::make_candidate(const FlightFacts& flight, const Vec3& start, Draft& draft,
                                  Work& work) const noexcept {
  const double earliest = earliest_branch(flight, draft);
  const int from_last = candidate / kBranchShapes;
  const double at = off_joints(draft.plan.planned, reached - (reached - earliest) * from_last / kBranches);
  return at > earliest && draft.branch_off(flight, at, candidate % kBranchShapes) && leads_on(flight, start, draft) &&
         ends_clear(flight, draft, work) &&
         !meets_thing(draft.plan.trajectory, at, draft.plan.tubes, flight.map.safe().spec().clearance(), work) &&
         draft.begin_proof(flight, draft.plan.trajectory, at) == Status::kRunning;
}

}  // namespace tern
