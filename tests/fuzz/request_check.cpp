// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "fuzz/byte_source.hpp"
#include "fuzz/fuzz_checks.hpp"
#include "tern/tern.hpp"

namespace tern_fuzz {
namespace {

/// Made once for all inputs.
struct Memory {
  tern::Workspace workspace;
  tern::Trajectory plan;
  tern::Trajectory untouched;
};

struct Asked {
  std::vector<tern::Halfspace> planes;
  std::vector<tern::Fence> fences;
  std::vector<tern::Via> vias;
  tern::Request request{};
};

tern::State state_of(ByteSource& source) {
  tern::State state{};
  state.position = source.vector(0.0, 3.0);
  if (source.below(3) == 0) state.velocity = source.vector(-2.0, 2.0);
  if (source.below(4) == 0) state.acceleration = source.vector(-2.0, 2.0);
  if (source.below(6) == 0) state.jerk = source.vector(-5.0, 5.0);
  return state;
}

void add_parts(ByteSource& source, Asked& asked) {
  for (int k = source.below(4); k > 0; --k) {
    for (int p = 0; p < 6; ++p) asked.planes.push_back({source.vector(-1.0, 1.0), source.number(-2.0, 4.0)});
  }
  for (std::size_t k = 0; 6 * k < asked.planes.size(); ++k) {
    const auto kind = source.below(2) == 0 ? tern::FenceKind::kKeepIn : tern::FenceKind::kKeepOut;
    asked.fences.push_back({asked.planes.data() + 6 * k, 1 + source.below(6), kind});
  }
  for (int k = source.below(3); k > 0; --k) {
    tern::Via via{
        source.vector(0.0, 3.0), source.number(0.0, 0.5), source.below(3) == 0, source.below(4) == 0, {}, 0.0};
    if (source.below(4) == 0) via.dwell = source.number(-1.0, 10.0);
    if (via.has_velocity) via.velocity = source.vector(-1.0, 1.0);
    asked.vias.push_back(via);
  }
}

void make_request(ByteSource& source, Asked& asked) {
  tern::Request& r = asked.request;
  r.start = state_of(source);
  r.goal = state_of(source);
  r.limits.v_max = source.vector(0.2, 4.0);
  r.limits.a_max = source.vector(0.5, 8.0);
  if (source.below(4) == 0) r.limits.v_min = source.vector(-3.0, -0.2);
  if (source.below(4) == 0) r.limits.j_max = source.vector(1.0, 60.0);
  if (source.below(4) == 0) r.limits.v_horizontal = source.number(0.2, 4.0);
  if (source.below(8) == 0) r.time_weight = source.number(0.001, 1000.0);
  if (source.below(4) == 0) r.budget.search = static_cast<std::uint32_t>(source.byte());
  if (source.below(4) == 0) r.budget.corridor = static_cast<std::uint32_t>(source.byte());
  if (source.below(4) == 0) r.budget.trajectory = static_cast<std::uint32_t>(source.byte());
  r.search = static_cast<tern::SearchMode>(source.below(2));
  r.goal_mode = static_cast<tern::GoalMode>(source.below(2));
  add_parts(source, asked);
  r.fences = asked.fences.data();
  r.fence_count = static_cast<std::int32_t>(asked.fences.size());
  r.vias = asked.vias.data();
  r.via_count = static_cast<std::int32_t>(asked.vias.size());
}

bool near(const tern::Vec3& a, const tern::Vec3& b) {
  return std::abs(a.x - b.x) < 1e-6 && std::abs(a.y - b.y) < 1e-6 && std::abs(a.z - b.z) < 1e-6;
}

std::string wrong_with(const Memory& m, const tern::Request& request, const tern::Report& report, tern::Status status) {
  if (report.status != status) return "the report has another status";
  const bool ok = status == tern::Status::kOk;
  if (ok == (report.quality == tern::Quality::kNone)) return "the quality does not fit the status";
  for (const tern::StageReport& stage : report.diagnostics.stages) {
    if (stage.work > stage.bound) return "more work than its bound";
  }
  if (!ok) return std::memcmp(&m.plan, &m.untouched, sizeof m.plan) == 0 ? "" : "the output is not untouched";
  if (m.plan.count < 1 || m.plan.count > tern::kMaxSegments) return "no number of segments";
  const tern::Vec3 goal = report.goal_missed == tern::Status::kOk ? request.goal.position : report.reachable;
  const double end = tern::duration(m.plan);
  if (!std::isfinite(end) || !near(tern::evaluate(m.plan, 0.0).position, request.start.position))
    return "a wrong start";
  return near(tern::evaluate(m.plan, end).position, goal) ? "" : "a wrong goal";
}

}  // namespace

std::string check_request(const std::uint8_t* data, std::size_t size) {
  static const auto memory = std::make_unique<Memory>();
  ByteSource source(data, size);
  tern::GridSpec spec{source.vector(0.0, 0.1),
                      source.number(0.1, 0.4),
                      {8 + source.below(17), 8 + source.below(9), 8 + source.below(9)},
                      {},
                      source.number(0.0, 0.5),
                      0.0};
  spec.boundary = {{0.0, 0.0, 0.0}, {3.0, 3.0, 3.0}};
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  if (grid.bind(spec, words.data(), words.size()) != tern::Status::kOk) return "";
  for (int k = source.below(12); k > 0; --k) {
    const tern::Vec3 lower = source.vector(0.0, 3.0);
    const tern::Vec3 more = source.vector(0.0, 1.0);
    (void)grid.mark_box({lower, {lower.x + more.x, lower.y + more.y, lower.z + more.z}});
  }
  grid.inflate();
  Asked asked;
  make_request(source, asked);
  std::memset(static_cast<void*>(&memory->plan), 0x5A, sizeof memory->plan);
  std::memset(static_cast<void*>(&memory->untouched), 0x5A, sizeof memory->untouched);
  tern::Planner planner(&memory->workspace, sizeof memory->workspace);
  tern::Report report;
  const tern::Status status = planner.plan(grid, asked.request, memory->plan, report);
  return wrong_with(*memory, asked.request, report, status);
}

}  // namespace tern_fuzz
