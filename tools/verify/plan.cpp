// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/plan.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace tern_verify {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kControlPoints = 8;

Rational number(const Json& json) {
  const double value = json.get<double>();
  if (!std::isfinite(value)) throw InputError("a number is not finite");
  return Rational(value);
}

Point point(const Json& json) {
  if (json.size() != 3) throw InputError("a point has three coordinates");
  return {number(json.at(0)), number(json.at(1)), number(json.at(2))};
}

Segment segment(const Json& json, std::size_t polyhedra) {
  if (!json.contains("relative_points")) {
    throw InputError("a segment has no 'relative_points': write the plan anew with 'tern plan --json'");
  }
  Segment result{{}, number(json.at("duration")), json.at("polyhedron").get<std::size_t>()};
  for (const Json& p : json.at("relative_points")) result.points.push_back(point(p));
  if (result.points.size() != kControlPoints) throw InputError("a segment has eight control points");
  if (result.duration <= 0) throw InputError("a segment's duration is not above 0");
  if (result.polyhedron >= polyhedra) throw InputError("a segment's polyhedron is not in the corridor");
  return result;
}

HalfSpace half_space(const Json& json) {
  if (json.size() != 4) throw InputError("a half-space has four numbers");
  const HalfSpace result{{number(json.at(0)), number(json.at(1)), number(json.at(2))}, number(json.at(3))};
  if (dot(result.normal, result.normal) == 0) throw InputError("a half-space has no direction");
  return result;
}

Plan plan_of(const Json& json) {
  if (json.value("format", "") != "tern-plan/1") throw InputError("its 'format' is not 'tern-plan/1'");
  if (json.value("status", "") != "ok") throw InputError("it has no trajectory: its 'status' is not 'ok'");
  Plan plan;
  plan.origin = point(json.at("origin"));
  for (const Json& polyhedron : json.at("corridor")) {
    plan.corridor.emplace_back();
    for (const char* const key : {"halfspaces", "redundant"}) {
      for (const Json& plane : polyhedron.at(key)) plan.corridor.back().push_back(half_space(plane));
    }
  }
  for (const Json& s : json.at("segments")) plan.segments.push_back(segment(s, plan.corridor.size()));
  if (plan.segments.empty()) throw InputError("it has no segments");
  if (json.contains("goal_missed")) plan.reachable = point(json.at("reachable"));
  return plan;
}

}  // namespace

Plan parse_plan(const std::string& text, const std::string& name) {
  try {
    Plan plan = plan_of(Json::parse(text));
    plan.name = name;
    return plan;
  } catch (const Json::exception& error) {
    throw InputError(name + ": not a plan file: " + error.what());
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
}

Plan read_plan(const std::string& path) {
  return parse_plan(read_file(path), path);
}

}  // namespace tern_verify
