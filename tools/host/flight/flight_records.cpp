// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "host/fence_record.hpp"
#include "host/flight/air_records.hpp"
#include "host/flight/detection_records.hpp"
#include "host/flight/far_guide.hpp"
#include "host/flight/fault_records.hpp"
#include "host/flight/flight_pads.hpp"
#include "host/flight/flight_world.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/flight/sensor_records.hpp"
#include "host/flight/setting_readers.hpp"
#include "host/flight/world_family.hpp"
#include "host/map/map_warnings.hpp"
#include "host/number.hpp"
#include "host/text_records.hpp"
#include "host/things/thing_record.hpp"
#include "host/vehicle/vehicle.hpp"
#include "host/via_record.hpp"
#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

void set_window(FlightSettings& s, const Words& words, const Place& place) {
  s.window = vector(words, place);
  if (!(s.window.x > 0.0 && s.window.y > 0.0 && s.window.z > 0.0)) throw RecordError(place, "window: not positive");
}

void set_tracking(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<std::string>& kinds = vehicle_kinds();
  if (words.size() != 2 || std::find(kinds.begin(), kinds.end(), words[1]) == kinds.end()) {
    throw RecordError(place, "tracking is perfect, bounded, quadrotor, px4 or ardupilot");
  }
  s.tracking = words[1];
}

void set_yaw(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<std::string> kinds = {"gimbal", "unseen", "motion", "point", "heading"};
  if (words.size() < 2 || std::find(kinds.begin(), kinds.end(), words[1]) == kinds.end()) {
    throw RecordError(place, "yaw is gimbal, unseen, motion, point x y z, or heading ANGLE");
  }
  const Words rest(words.begin() + 1, words.end());
  const std::vector<double> values = numbers(rest, place);
  const std::size_t needed = words[1] == "point" ? 3 : (words[1] == "heading" ? 1 : 0);
  if (values.size() != needed)
    throw_count("yaw " + words[1], std::to_string(needed) + " numbers", values.size(), place);
  s.yaw = words[1];
  if (needed == 3) s.yaw_point = {values[0], values[1], values[2]};
  if (needed == 1) s.yaw_heading = yaw_angle("yaw heading", values[0], place);
}

constexpr Range kTurning{0.01, 1e9};

void set_yaw_rate(FlightSettings& s, const Words& words, const Place& place) {
  s.yaw_rate = yaw_rate(words[0], number_within(words, kTurning, place), place);
}

void set_yaw_acceleration(FlightSettings& s, const Words& words, const Place& place) {
  s.yaw_acceleration = yaw_acceleration(words[0], number_within(words, kTurning, place), place);
}

Setters all_setters() {
  using S = FlightSettings;
  Setters all = {{"body_radius", real(&S::body_radius, 0.01, 10.0)},
                 {"tracking_margin", real(&S::tracking_margin, 0.0, 10.0)},
                 {"pose_margin", real(&S::pose_margin, 0.0, 10.0)},
                 {"depth_margin", real(&S::depth_margin, 0.0, 10.0)},
                 {"cell", real(&S::cell, 0.01, 10.0)},
                 {"hits", whole(&S::hits, 1.0, 4.0)},
                 {"support", whole(&S::support, 0.0, 8.0)},
                 {"v_max", real(&S::v_max, 0.01, 100.0)},
                 {"a_max", real(&S::a_max, 0.01, 100.0)},
                 {"j_max", real(&S::j_max, 0.0, 1e6)},
                 {"thrust_max", real(&S::thrust_max, 0.0, 1e3)},
                 {"thrust_min", real(&S::thrust_min, 0.0, 9.8)},
                 {"tilt_tangent", real(&S::tilt_tangent, 0.0, 1e3)},
                 {"rate_max", real(&S::rate_max, 0.0, 1e3)},
                 {"monitor", whole(&S::monitor, 0.0, 1.0)},
                 {"stack_speed", real(&S::stack_speed, 0.1, 100.0)},
                 {"yaw_rate", set_yaw_rate},
                 {"yaw_acceleration", set_yaw_acceleration},
                 {"yaw", set_yaw},
                 {"tick_hz", real(&S::tick_hz, 1.0, 1000.0)},
                 {"work_per_tick", whole(&S::work_per_tick, 256.0, 1e8)},
                 {"far_cell", real(&S::far_cell, 0.0, 1000.0)},
                 {"time_limit", real(&S::time_limit, 0.1, kLongestFlight)},
                 {"goal_tolerance", real(&S::goal_tolerance, 1e-9, 10.0)},
                 {"window", set_window},
                 {"tracking", set_tracking},
                 {"seed", [](S& s, const Words& words, const Place& place) {
                    s.seed = static_cast<std::uint64_t>(whole_number_within(words, {0.0, 9e15}, place));
                  }}};
  add_air_setters(all);
  add_sensor_setters(all);
  add_fault_setters(all);
  add_detection_setters(all);
  return all;
}

const Setters& setters() {
  static const Setters all = all_setters();
  return all;
}

tern::Via flown_via(const Words& words, const FlightWorld& world, const Place& place) {
  const tern::Via via = read_via(words, place);
  if (via.has_velocity) throw RecordError(place, "a flight promises no velocity at a via");
  if (via.tolerance < 0.0) throw RecordError(place, "a via's tolerance is 0 or more");
  if (world.vias.size() + 1 == std::size_t{tern::kMaxMissionPoints}) throw RecordError(place, "too many vias");
  return via;
}

tern::ViaPolicy policy_of(const Words& words, const Place& place) {
  const bool is_known = words.size() == 2 && (words[1] == "end" || words[1] == "skip");
  if (!is_known) throw RecordError(place, "via_policy is end or skip");
  return words[1] == "end" ? tern::ViaPolicy::kEnd : tern::ViaPolicy::kSkip;
}

/// The column stands above `start`; its axis is set once all records are read.
tern::Cylinder read_column(const Words& words, const Place& place) {
  const std::vector<double> values = numbers(words, place);
  if (values.size() != 3) throw_count("column", "the ground's height, a radius and a height", values.size(), place);
  return {{0.0, 0.0, values[0]},
          within("column", values[1], {0.01, 100.0}, place),
          within("column", values[2], {0.01, 100.0}, place)};
}

/// What to do about a record that only a plan's scenario may have.
std::string hint_for(const std::string& key) {
  if (key == "radius") return ": body_radius is the vehicle's, and the margins come on top";
  if (key != "track" && key != "track_piece") return "";
  return ": what moves in a flight's world is a 'thing', which says how it moves. 'tern plan' plans among tracks";
}

void add_record(const Words& words, const Place& place, FlightWorld& world) {
  const std::string& key = words[0];
  const auto setter = setters().find(key);
  if (setter != setters().end()) return setter->second(world.settings, words, place);
  if (key == "boundary") {
    world.boundary = box_of(numbers(words, place), key, place);
  } else if (key == "block") {
    world.blocks.push_back(block_box(words, place));
  } else if (key == "unmapped") {
    world.unmapped.push_back(world.blocks.size());
    world.blocks.push_back(block_box(words, place));
  } else if (key == "cylinder") {
    world.cylinders.push_back(read_cylinder(words, place));
  } else if (key == "appear") {
    world.appearing.push_back(read_appearance(words, place));
  } else if (key == "thing") {
    world.things.push_back(read_thing(words, place));
  } else if (is_fence(key)) {
    Words fence = words;
    const FenceEnd end = take_end(place, fence);
    add_fence(fence, place, world.fences, end);
    if (exceeds_capacity(world.fences)) {
      throw RecordError(place, "more fences or half-spaces than a flight takes (TERN_MAX_FENCES " +
                                   std::to_string(tern::kMaxFences) + ", TERN_MAX_FENCE_PLANES " +
                                   std::to_string(tern::kMaxFencePlanes) + ")");
    }
  } else if (key == "fences_within") {
    world.fences_within = read_fence_cover(words, place);
  } else if (is_earth_record(key)) {
    add_earth_record(words, place, world.earth);
  } else if (key == "start") {
    world.start = vector(words, place);
    world.places.start = place;
  } else if (key == "goal") {
    world.goal = vector(words, place);
    world.places.goal = place;
  } else if (key == "column") {
    world.column = read_column(words, place);
    world.places.column = place;
  } else if (key == "land") {
    const std::vector<double> values = numbers(words, place);
    if (values.size() != 2) throw_count(key, "the ground's height and a speed", values.size(), place);
    world.landing = {values[0], within(key, values[1], {0.01, 100.0}, place)};
  } else if (key == "via") {
    world.vias.push_back(flown_via(words, world, place));
    world.places.vias.push_back(place);
  } else if (key == "via_policy") {
    world.via_policy = policy_of(words, place);
  } else {
    throw RecordError(place, "there is no record " + quote(key) + " for flights" + hint_for(key));
  }
}

tern::Box box_around(const Cylinder& c) {
  return {{c.x - c.radius, c.y - c.radius, c.bottom}, {c.x + c.radius, c.y + c.radius, c.top}};
}

/// The box of a record that was just added, if it has one.
void note_box(const Words& words, const Place& place, const FlightWorld& world, std::vector<BoxRecord>& boxes) {
  const std::string& key = words[0];
  if (key == "block") boxes.push_back({"block", world.blocks.back(), place.line});
  if (key == "unmapped") boxes.push_back({"unmapped", world.blocks.back(), place.line});
  if (key == "cylinder") boxes.push_back({"cylinder", box_around(world.cylinders.back()), place.line});
  if (key == "keepin" || key == "keepout") {
    Words box = words;
    take_end(place, box);
    boxes.push_back({key == "keepin" ? "keepin" : "keepout", box_of(numbers(box, place), key, place), place.line});
  }
  if (key != "appear") return;
  const Appearance& appears = world.appearing.back();
  boxes.push_back({"appear", appears.is_block ? appears.block : box_around(appears.cylinder), place.line});
}

Words words_of(const std::string& override_text, const Place& place) {
  const std::size_t equals = override_text.find('=');
  if (equals == std::string::npos) throw RecordError(place, quote(override_text) + " is not KEY=VALUE");
  Words words = split_words(override_text.substr(equals + 1), true);
  words.insert(words.begin(), override_text.substr(0, equals));
  return words;
}

/// A storey has doors, which coarse voxels close.
constexpr double kStorey = 3.5;

void choose_voxels(FlightWorld& world) {
  FlightSettings& s = world.settings;
  const bool indoors = world.boundary.upper.z - world.boundary.lower.z <= kStorey;
  if (!(s.cell > 0.0)) s.cell = indoors ? 0.1 : 0.2;
  if (!(s.window.x > 0.0)) s.window = indoors ? tern::Vec3{25.6, 20.0, 8.0} : tern::Vec3{51.2, 30.0, 8.0};
}

void choose_evidence(FlightSettings& s) {
  if (s.speckle_filter < 0) s.speckle_filter = s.outliers > 0.0 ? 1 : 0;
  const bool errs = s.outliers > 0.0 && s.speckle_filter == 0;
  if (s.hits == 0) s.hits = errs ? 2 : 1;
  if (s.support < 0) s.support = errs ? 1 : 0;
}

void choose_monitor(FlightSettings& s) {
  if (s.monitor < 0) s.monitor = is_stack(s.tracking) ? 1 : 0;
}

void replace_settings(const std::vector<std::string>& overrides, FlightWorld& world) {
  for (const std::string& setting : overrides) {
    const Place place{"--set", 0};
    const Words words = words_of(setting, place);
    if (setters().count(words[0]) == 0) throw RecordError(place, "there is no setting " + quote(words[0]));
    add_record(words, place, world);
  }
}

}  // namespace

FlightSettings flight_settings(const std::vector<std::string>& overrides, const FlightSettings& defaults) {
  FlightWorld world;
  world.settings = defaults;
  replace_settings(overrides, world);
  check_fov(world.settings, {"--set", 0});
  return world.settings;
}

FlightWorld read_flight_world(const std::string& path, const std::vector<std::string>& overrides) {
  FlightWorld world;
  world.name = path;
  FamilyMember member;
  const std::string text = is_member(path, member) ? world_text(member) : read_text(path);
  world.places.start = world.places.goal = {path, 0};
  std::vector<BoxRecord> boxes;
  const Place end = for_each_record(text, path, [&](const Words& words, const Place& place) {
    add_record(words, place, world);
    note_box(words, place, world, boxes);
  });
  replace_settings(overrides, world);
  const tern::Box& b = world.boundary;
  if (!(b.upper.x > b.lower.x && b.upper.y > b.lower.y && b.upper.z > b.lower.z)) {
    throw RecordError(end, "there is no boundary");
  }
  if (world.fences_within) {
    check_fence_cover(*world.fences_within, b, radius_of(world.settings),
                      "body_radius + pose_margin + tracking_margin");
  }
  refuse_empty_fences(world.fences, b, world.settings.body_radius + world.settings.tracking_margin);
  check_fov(world.settings, {path, 0});
  if (world.settings.things == 0) world.things.clear();
  choose_voxels(world);
  choose_evidence(world.settings);
  choose_monitor(world.settings);
  warn_of_records(boxes, b, reach_of(b, radius_of(world.settings), world.settings.cell), path, world.warnings);
  if (world.settings.goal_jitter.size > 0.0 && !world.vias.empty()) {
    throw RecordError({path, 0}, "goal_jitter is for worlds without vias: each new goal begins the mission anew");
  }
  if (world.landing.speed > 0.0 && (!world.vias.empty() || world.settings.goal_jitter.size > 0.0)) {
    throw RecordError({path, 0}, "land is for worlds without vias, and without goal_jitter");
  }
  refuse_far_way(world, {path, 0});
  place_goal(world, {path, 0});
  world.column.base.x = world.start.x;
  world.column.base.y = world.start.y;
  refuse_untrue_ground(world);
  return world;
}

}  // namespace tern_host
