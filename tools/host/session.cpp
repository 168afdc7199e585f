// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/session.hpp"

#include <cstring>
#include <stdexcept>
#include <utility>

#include "host/fence_choice.hpp"
#include "host/grid_layout.hpp"
#include "host/map/scenario_grid.hpp"
#include "host/nanoseconds.hpp"
#include "tern/record.hpp"
#include "tern_port/port.hpp"

namespace tern_host {
namespace {

tern::Request request_of(const Scenario& scenario, const tern::Limits& limits, const std::vector<tern::Fence>& fences,
                         const std::vector<tern::Track>& tracks) {
  tern::Request request{};
  request.begin = nanoseconds(scenario.start_time);
  request.tracks = tracks.data();
  request.track_count = static_cast<std::int32_t>(tracks.size());
  request.rest_clear = scenario.rest_clear;
  request.fences = fences.data();
  request.fence_count = static_cast<std::int32_t>(fences.size());
  request.start = scenario.start;
  request.goal = scenario.goal;
  request.vias = scenario.vias.data();
  request.via_count = static_cast<std::int32_t>(scenario.vias.size());
  request.limits = limits;
  request.time_weight = scenario.time_weight;
  request.search = scenario.search;
  request.goal_mode = scenario.goal_mode;
  return request;
}

/// Firmware's memory is there before the planner runs. Here each page is taken from the system when first written,
/// which would count as the time of the stage that writes it.
std::unique_ptr<unsigned char[]> touched_memory(std::size_t bytes) {
  std::unique_ptr<unsigned char[]> memory(new unsigned char[bytes]);
  std::memset(memory.get(), 0, bytes);
  return memory;
}

void add_yaw(PlanResult& result) {
  if (!result.ok() || !result.scenario.has_yaw) return;
  auto plan = std::make_unique<tern::YawPlan>();
  result.yaw_status = plan_yaw(result.scenario.yaw, result.trajectory, *plan);
  if (result.yaw_status == tern::Status::kOk) result.yaw = std::move(plan);
}

/// Plans that are too fast for a chain are made again, each with four fifths of the speed before: 0.13 in the end.
constexpr int kSlower = 9;
constexpr double kSlowerBy = 0.8;

tern::Limits slower(tern::Limits limits) {
  for (tern::Vec3* const v : {&limits.v_max, &limits.v_min})
    *v = {kSlowerBy * v->x, kSlowerBy * v->y, kSlowerBy * v->z};
  limits.v_horizontal *= kSlowerBy;
  return limits;
}

/// True if there is no plan because all break a keep-in for a while: where the vehicle must be elsewhere soon, it
/// cannot wait until a link holds, but fly there more slowly.
bool leaves_chain(const PlanResult& result) {
  const tern::Status status = result.report.status;
  if (status != tern::Status::kGoalCovered && status != tern::Status::kNoClearTime) return false;
  if (result.report.fence == tern::kNoFence) return false;
  const tern::Fence& fence = result.scenario.fences[static_cast<std::size_t>(result.report.fence)].fence;
  return fence.kind == tern::FenceKind::kKeepIn && tern::is_timed(fence);
}

tern::Status refuse(PlanResult& result, tern::Status status) {
  result.report.status = status;
  result.report.stage = tern::Stage::kRequest;
  return status;
}

}  // namespace

Clock platform_clock() {
  return {tern_port::ticks, nullptr, tern_port::ticks_per_second()};
}

double Timing::total() const {
  double sum = inflate;
  for (const double stage : stages) sum += stage;
  return sum;
}

Session::Session(const Clock& clock)
    : clock_(clock),
      memory_(touched_memory(tern::kWorkspaceBytes + tern::kWorkspaceAlignment)),
      planner_(memory_.get(), tern::kWorkspaceBytes + tern::kWorkspaceAlignment) {
  planner_.set_clock(clock_.read, clock_.context);
}

double Session::microseconds(std::uint64_t ticks) const {
  return static_cast<double>(ticks) * (1e6 / clock_.ticks_per_second);
}

tern::Status Session::build_grid(PlanResult& result) {
  words_.resize(tern::grid_words(result.grid.dims));
  const tern::Status status = grid_.bind(result.grid, words_.data(), words_.size(), &result.report.field);
  if (status != tern::Status::kOk) return refuse(result, status);
  const tern::Status filled = fill_grid(result.scenario, grid_);
  if (filled != tern::Status::kOk) return refuse(result, filled);
  const std::uint64_t before = clock_.read(clock_.context);
  grid_.inflate();
  result.timing.inflate = microseconds(clock_.read(clock_.context) - before);
  return status;
}

PlanResult Session::plan(const Scenario& scenario, const tern::Trajectory* previous, double previous_time) {
  PlanResult result = plan_among(scenario, scenario.limits, previous, previous_time);
  tern::Limits limits = scenario.limits;
  for (int k = 0; k < kSlower && leaves_chain(result); ++k) {
    limits = slower(limits);
    PlanResult next = plan_among(scenario, limits, previous, previous_time);
    if (next.ok()) return next;
  }
  return result;
}

PlanResult Session::plan_among(const Scenario& scenario, const tern::Limits& limits, const tern::Trajectory* previous,
                               double previous_time) {
  if (exceeds_capacity(scenario.fences)) return plan_chosen(scenario, limits, previous, previous_time);
  PlanResult once = plan_once(scenario, limits, previous, previous_time);
  if (once.report.status != tern::Status::kFencePlanesFull) return once;
  PlanResult result = plan_chosen(scenario, limits, previous, previous_time);
  result.among_all = once.report.status;
  return result;
}

PlanResult Session::plan_chosen(const Scenario& scenario, const tern::Limits& limits, const tern::Trajectory* previous,
                                double previous_time) {
  FenceChoice choice(scenario);
  const auto has_changed = [&choice](const PlanResult& result) {
    if (result.ok()) return choice.add_broken(result.trajectory);
    // The planner also counts the corners of fences, which are not known before.
    return result.report.status == tern::Status::kFencePlanesFull && choice.mark_first();
  };
  PlanResult result = plan_once(choice.chosen(), limits, previous, previous_time);
  while (has_changed(result)) result = plan_once(choice.chosen(), limits, previous, previous_time);
  result.scenario.fences = scenario.fences;
  result.report.fence = choice.index_of(result.report.fence);
  result.report.check.fence = choice.index_of(result.report.check.fence);
  return result;
}

PlanResult Session::plan_once(const Scenario& scenario, const tern::Limits& limits, const tern::Trajectory* previous,
                              double previous_time) {
  PlanResult result;
  result.scenario = scenario;
  result.limits = limits;
  result.grid = lay_out_grid(scenario);
  const tern::Status healthy = tern::self_test(tern::configuration_hash(), nullptr);
  if (healthy != tern::Status::kOk) {
    refuse(result, healthy);
    return result;
  }
  if (build_grid(result) != tern::Status::kOk) return result;
  const std::vector<tern::Fence> fences = fences_of(scenario.fences);
  const std::vector<tern::Track> tracks = tracks_of(result.scenario.tracks);
  tern::Request request = request_of(scenario, limits, fences, tracks);
  if (previous != nullptr && scenario.depends_on_time()) request.begin = previous->begin + nanoseconds(previous_time);
  request.previous = previous;
  request.previous_time = previous_time;
  planner_.plan(grid_, request, result.trajectory, result.report);
  for (int i = 0; i < tern::kStageCount; ++i)
    result.timing.stages[i] = microseconds(result.report.diagnostics.stages[i].ticks);
  if (planner_.path() != nullptr) result.path = std::make_unique<tern::Path>(*planner_.path());
  if (planner_.corridor() != nullptr) result.corridor = std::make_unique<tern::Corridor>(*planner_.corridor());
  add_yaw(result);
  return result;
}

std::string Session::record(const PlanResult& result) const {
  if (result.among_all != tern::Status::kOk) {
    throw std::runtime_error(std::string("this query cannot be recorded: ") + tern::status_meaning(result.among_all));
  }
  const std::vector<tern::Fence> fences = fences_of(result.scenario.fences);
  const std::vector<tern::Track> tracks = tracks_of(result.scenario.tracks);
  std::string bytes(tern::plan_record_bytes(result.grid.dims), '\0');
  std::size_t used = 0;
  const tern::Status status =
      tern::record_plan(grid_, request_of(result.scenario, result.limits, fences, tracks), result.report.status,
                        result.trajectory, reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size(), &used);
  if (status != tern::Status::kOk) {
    throw std::runtime_error(std::string("this query cannot be recorded: ") + tern::status_meaning(status));
  }
  bytes.resize(used);
  return bytes;
}

}  // namespace tern_host
