// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/fence_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host/map/scenario_grid.hpp"
#include "tern/proof.hpp"

namespace tern_host {
namespace {

/// The proofs are about fences alone: a grid of some voxels will do.
constexpr double kVoxels = 16.0;
/// A proof needs a radius, and grants itself twice this.
constexpr double kLeastRadius = 2e-9;

Scenario without_obstacles(const Scenario& scenario) {
  Scenario empty;
  empty.name = scenario.name;
  empty.boundary = scenario.boundary;
  empty.boundary_place = scenario.boundary_place;
  const tern::Box& b = scenario.boundary;
  const double size = std::max({b.upper.x - b.lower.x, b.upper.y - b.lower.y, b.upper.z - b.lower.z});
  empty.resolution = std::max(size / kVoxels, scenario.resolution);
  empty.radius = std::max(scenario.clearance(), kLeastRadius);
  return empty;
}

}  // namespace

FenceChoice::FenceChoice(const Scenario& scenario)
    : scenario_(scenario),
      map_(std::make_unique<GridMap>(without_obstacles(scenario))),
      closed_(scenario.fences.size(), false) {
  if (map_->status != tern::Status::kOk) {
    throw ScenarioError(scenario.boundary_place, std::string("no grid: ") + tern::status_meaning(map_->status));
  }
  for (std::size_t i = 0; i < scenario.fences.size(); ++i) {
    if (scenario.fences[i].fence.kind == tern::FenceKind::kKeepIn) added_.push_back(i);
  }
}

FenceChoice::~FenceChoice() = default;

Scenario FenceChoice::chosen() const {
  Scenario some = scenario_;
  some.fences.clear();
  for (const std::size_t i : added_) some.fences.push_back(record(i));
  for (const std::size_t i : marked_) some.marked.push_back(record(i));
  return some;
}

FenceRecord FenceChoice::record(std::size_t i) const {
  FenceRecord record = scenario_.fences[i];
  if (closed_[i]) record.fence.from = record.fence.until = 0;
  return record;
}

std::int32_t FenceChoice::index_of(std::int32_t chosen) const {
  const bool known = chosen >= 0 && static_cast<std::size_t>(chosen) < added_.size();
  return known ? static_cast<std::int32_t>(added_[static_cast<std::size_t>(chosen)]) : chosen;
}

/// Infinite if all of the plan is clear of the fence.
double FenceChoice::clear_until(const FenceRecord& record, const tern::Trajectory& plan) const {
  const std::vector<FenceRecord> records{record};
  const std::vector<tern::Fence> fence = fences_of(records);
  tern::ProofReport report{};
  if (tern::is_timed(fence[0])) {
    tern::TrackGrounds grounds;
    grounds.radius = scenario_.clearance();
    grounds.rest = scenario_.rest_clear;
    grounds.fences = fence.data();
    grounds.fence_count = 1;
    report.finding = tern::Finding::kMalformed;
    tern::clear_until(plan, 0.0, grounds, &report);
  } else {
    tern::ProofGrounds grounds;
    grounds.fences = fence.data();
    grounds.fence_count = 1;
    tern::Proof proof;
    tern::Status status = proof.begin(map_->grid, plan, 0.0, nullptr, tern::Beyond::kEmpty, grounds);
    while (status == tern::Status::kRunning) status = proof.step(100000);
    report = proof.report();
    if (status != tern::Status::kOk) report.finding = tern::Finding::kMalformed;
  }
  return report.finding == tern::Finding::kNone ? std::numeric_limits<double>::infinity() : report.until;
}

bool FenceChoice::is_full() const {
  std::vector<FenceRecord> added;
  for (const std::size_t i : added_) added.push_back(record(i));
  return exceeds_capacity(added);
}

bool FenceChoice::mark_first() {
  const auto first = [this](bool timed) {
    return std::find_if(added_.begin(), added_.end(), [this, timed](std::size_t i) {
      const tern::Fence fence = record(i).fence;
      return fence.kind == tern::FenceKind::kKeepOut && tern::is_timed(fence) == timed;
    });
  };
  auto marked = first(false);
  if (marked == added_.end()) marked = first(true);
  if (marked == added_.end()) return false;
  closed_[*marked] = true;
  marked_.push_back(*marked);
  added_.erase(marked);
  return true;
}

bool FenceChoice::add_broken(const tern::Trajectory& plan) {
  const auto is_in = [](const std::vector<std::size_t>& list, std::size_t i) {
    return std::find(list.begin(), list.end(), i) != list.end();
  };
  double first = std::numeric_limits<double>::infinity();
  std::size_t broken = 0;
  for (std::size_t i = 0; i < scenario_.fences.size(); ++i) {
    if (is_in(added_, i)) continue;
    const double until = clear_until(scenario_.fences[i], plan);
    if (until >= first) continue;
    if (is_in(marked_, i)) throw std::logic_error("a plan breaks a fence that is marked in its grid");
    first = until;
    broken = i;
  }
  if (std::isinf(first)) return false;
  added_.push_back(broken);
  while (is_full() && mark_first()) {
  }
  return true;
}

}  // namespace tern_host
