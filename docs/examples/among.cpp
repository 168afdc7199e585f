// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/tracks.md: a plan among things that move: a man, another vehicle on its plan, and airspace that is closed for a
// while.
#include <cstdint>
#include <memory>
#include <vector>

#include "tern/tern.hpp"

static constexpr std::int64_t kSecond = 1000000000;

static tern::Status plan_among(const tern::Grid& grid, tern::Planner& planner, const tern::Trajectory& other,
                               tern::Request request, tern::Trajectory& plan, tern::Report& report) {
  tern::Track tracks[2];  // like all that follows, they must stay until the plan begins
  tern::Track& man = tracks[0];
  man.measured = request.begin;
  man.position = {7.0, 7.5, 0.9};
  man.velocity = {0.0, -1.1, 0.0};
  man.shape = tern::TrackShape::kCylinder;
  man.radius = 0.3;
  man.half.z = 0.9;
  man.error = 0.05;
  man.error_speed = 0.1;  // what is known of him is 5 cm off, and 10 cm more each second
  tern::TrackPiece pieces[tern::kMaxSegments];
  tern::track_of(other, 0.3, pieces, tern::kMaxSegments, tracks[1]);
  tern::Halfspace faces[tern::kBoxPlanes];
  tern::box_planes({{8.0, 3.0, 0.0}, {9.0, 6.0, 3.0}}, faces);
  tern::Fence closed{faces, tern::kBoxPlanes, tern::FenceKind::kKeepOut};
  closed.from = request.begin + 2 * kSecond;
  closed.until = request.begin + 20 * kSecond;
  closed.clock_error = 0.1;
  request.tracks = tracks;
  request.track_count = 2;
  request.fences = &closed;
  request.fence_count = 1;
  request.rest_clear = 1.0;  // the goal is to stay clear for a second
  return planner.plan(grid, request, plan, report);
}

int main() {
  tern::GridSpec spec{};
  spec.cell = 0.1;
  spec.dims = {120, 80, 30};
  spec.boundary = {{0.0, 0.0, 0.0}, {12.0, 8.0, 3.0}};
  spec.radius = 0.3;
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  if (grid.bind(spec, words.data(), words.size()) != tern::Status::kOk) return 1;
  grid.mark_box({{4.0, 0.0, 0.0}, {4.5, 5.0, 3.0}});
  grid.inflate();

  auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  tern::Request request;
  request.begin = 1000 * kSecond;
  request.limits = {{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}};
  tern::Trajectory other{};
  tern::Trajectory plan{};
  tern::Report report{};
  request.start.position = {11.0, 1.0, 1.5};
  request.goal.position = {6.0, 6.5, 1.5};
  if (planner.plan(grid, request, other, report) != tern::Status::kOk) return 1;
  request.start.position = {1.0, 4.5, 1.5};
  request.goal.position = {11.0, 4.5, 1.5};
  if (plan_among(grid, planner, other, request, plan, report) != tern::Status::kOk) return 1;
  return report.rest_clear_until >= tern::duration(plan) + 1.0 ? 0 : 1;
}
