// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/replay.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "tern/planner.hpp"

namespace tern_host {
namespace {

void require(tern::Status status) {
  if (status == tern::Status::kOk) return;
  throw std::runtime_error(std::string(tern::status_name(status)) + ": " + tern::status_meaning(status));
}

template <typename Value>
bool same_bits(const Value& a, const Value& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

std::string segment_difference(const tern::Segment& a, const tern::Segment& b) {
  if (!same_bits(a.duration, b.duration)) return "duration";
  for (int i = 0; i < tern::kControlPoints; ++i) {
    if (!same_bits(a.points[i], b.points[i])) return "control point " + std::to_string(i);
  }
  return a.polyhedron != b.polyhedron ? "polyhedron" : "";
}

std::string plan_difference(const tern::Trajectory& a, const tern::Trajectory& b) {
  if (a.count != b.count) return std::to_string(a.count) + " segments, now " + std::to_string(b.count);
  if (a.begin != b.begin) return "the time of its beginning";
  if (!same_bits(a.origin, b.origin)) return "the origin";
  for (int i = 0; i < a.count; ++i) {
    const std::string what = segment_difference(a.segments[i], b.segments[i]);
    if (!what.empty()) return what + " of segment " + std::to_string(i);
  }
  return "";
}

}  // namespace

Replay replay(const std::string& bytes) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  Replay result;
  result.record = std::make_unique<tern::PlanRecord>();
  tern::PlanRecord& record = *result.record;
  require(tern::read_plan_record(data, bytes.size(), record));
  std::vector<std::uint64_t> words(tern::grid_words(record.grid.dims));
  tern::Grid grid;
  require(tern::read_plan_record(data, bytes.size(), record, grid, words.data(), words.size()));
  const auto workspace = std::make_unique<tern::Workspace>();
  tern::Planner planner(workspace.get(), sizeof *workspace);
  tern::Report report{};
  result.status = planner.plan(grid, record.request, result.plan, report);
  if (result.status != record.status) {
    result.difference = std::string("the answer was ") + tern::status_name(record.status);
  } else if (result.status == tern::Status::kOk) {
    result.difference = plan_difference(record.plan, result.plan);
  }
  return result;
}

}  // namespace tern_host
