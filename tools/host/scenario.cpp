// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/scenario.hpp"

#include <algorithm>

#include "base/bounds.hpp"
#include "host/map/map_files.hpp"
#include "host/scenario_records.hpp"

namespace tern_host {
namespace {

void parse_override(const std::string& option, ScenarioBuilder& builder) {
  const Place place{"--set " + option.substr(0, 80), 0};
  const std::size_t equals = option.find('=');
  if (equals == std::string::npos || equals == 0) throw ScenarioError(place, "expected key=value");
  builder.override_setting(option.substr(0, equals), split_words(option.substr(equals + 1), true), place);
}

LimitRange range(const tern::Vec3& upper, const tern::Vec3& lower, double horizontal) {
  const auto given = [](double least, double most) { return least < 0.0 ? least : -most; };
  return {{given(lower.x, upper.x), given(lower.y, upper.y), given(lower.z, upper.z)}, upper, horizontal};
}

}  // namespace

LimitRange velocity_range(const tern::Limits& limits) {
  return range(limits.v_max, limits.v_min, limits.v_horizontal);
}

LimitRange acceleration_range(const tern::Limits& limits) {
  return range(limits.a_max, limits.a_min, limits.a_horizontal);
}

LimitRange jerk_range(const tern::Limits& limits) {
  const tern::Bounds bounds = tern::make_optional_bounds(limits.j_max, limits.j_horizontal);
  return {bounds.lower, bounds.upper, bounds.horizontal};
}

bool limits_jerk(const tern::Limits& limits) {
  return tern::limits_anything(tern::make_optional_bounds(limits.j_max, limits.j_horizontal));
}

bool Scenario::depends_on_time() const {
  const auto is_timed = [](const FenceRecord& record) { return tern::is_timed(record.fence); };
  return !tracks.empty() || std::any_of(fences.begin(), fences.end(), is_timed);
}

Scenario parse_scenario(const std::string& text, const std::string& name, const std::vector<std::string>& overrides,
                        Ends ends) {
  ScenarioBuilder builder(name);
  const Place end =
      for_each_record(text, name, [&](const Words& words, const Place& place) { builder.add(words, place); });
  for (const std::string& option : overrides) parse_override(option, builder);
  return builder.finish(end, ends);
}

Scenario read_scenario(const std::string& path, const std::vector<std::string>& overrides, Ends ends) {
  Scenario scenario = parse_scenario(read_text(path), path, overrides, ends);
  load_map_files(scenario);
  load_plans(path.substr(0, path.find_last_of('/') + 1), scenario.earth, scenario.tracks);
  return scenario;
}

}  // namespace tern_host
