// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/plan.hpp"

#include "verify/json.hpp"

namespace tern_verify {
namespace {

Segment segment_in(const Json& json, std::size_t polyhedra) {
  Segment segment = segment_of(json);
  segment.polyhedron = json.at("polyhedron").get<std::size_t>();
  if (segment.polyhedron >= polyhedra) throw InputError("a segment's polyhedron is not in the corridor");
  return segment;
}

HalfSpace half_space(const Json& json) {
  if (json.size() != 4) throw InputError("a half-space has four numbers");
  const HalfSpace result{point_of(json), number_of(json.at(3))};
  if (dot(result.normal, result.normal) == 0) throw InputError("a half-space has no direction");
  return result;
}

Plan plan_of(const Json& json) {
  if (json.value("format", "") != "tern-plan/1") throw InputError("its 'format' is not 'tern-plan/1'");
  if (json.value("status", "") != "ok") throw InputError("it has no trajectory: its 'status' is not 'ok'");
  Plan plan;
  plan.origin = point_of(json.at("origin"));
  for (const Json& polyhedron : json.at("corridor")) {
    plan.corridor.emplace_back();
    for (const char* const key : {"halfspaces", "redundant"}) {
      for (const Json& plane : polyhedron.at(key)) plan.corridor.back().push_back(half_space(plane));
    }
  }
  for (const Json& segment : json.at("segments")) plan.segments.push_back(segment_in(segment, plan.corridor.size()));
  if (plan.segments.empty()) throw InputError("it has no segments");
  if (json.contains("goal_missed")) plan.reachable = point_of(json.at("reachable"));
  return plan;
}

}  // namespace

Plan parse_plan(const std::string& text, const std::string& name) {
  Plan plan = read_json(text, name, "plan file", plan_of);
  plan.name = name;
  return plan;
}

Plan read_plan(const std::string& path) {
  return parse_plan(read_file(path), path);
}

}  // namespace tern_verify
