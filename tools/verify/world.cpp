// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/world.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "verify/fence_records.hpp"

namespace tern_verify {
namespace {

/// Up and down, all flights are slower and gentler, and rigid bodies sink more gently still (docs/formats.md).
constexpr int kMostClimb = 2;
constexpr int kMostClimbAcceleration = 6;
constexpr int kMostSinkAcceleration = 3;

/// Worlds that are at most so high have smaller voxels: metres. The simulator subtracts doubles.
const Rational kStorey = Rational(7) / 2 + decimal(1, 9);

const std::map<std::string, Rational> kDefaults = {
    {"body_radius", 0.25}, {"tracking_margin", 0.10}, {"pose_margin", 0}, {"v_max", 3},        {"a_max", 6},
    {"j_max", 0},          {"thrust_max", 0},         {"thrust_min", 0},  {"tilt_tangent", 0}, {"rate_max", 0},
    {"tick_hz", 100}};

/// Settings that change no proof.
const std::set<std::string> kOthers = {"yaw",
                                       "hits",
                                       "wind",
                                       "seed",
                                       "further_camera",
                                       "beams",
                                       "mount",
                                       "holes",
                                       "window",
                                       "sensor",
                                       "dropout",
                                       "support",
                                       "outliers",
                                       "yaw_rate",
                                       "sensor_hz",
                                       "scan_pixel",
                                       "sensor_fov",
                                       "time_limit",
                                       "sensor_min",
                                       "sensor_far",
                                       "pixel_part",
                                       "sensor_size",
                                       "depth_noise",
                                       "mount_pitch",
                                       "depth_error",
                                       "depth_margin",
                                       "sensor_range",
                                       "mount_offset",
                                       "gimbal_pitch",
                                       "work_per_tick",
                                       "sensor_latency",
                                       "speckle_filter",
                                       "goal_tolerance",
                                       "yaw_acceleration"};

Solid cylinder_from(const Record& record) {
  const std::vector<Rational> v = record.numbers(1, 5);
  if (v[2] > v[3] || v[4] <= 0) record.refuse("a cylinder needs a height and a radius");
  return {{{v[0], v[1], v[2]}, {v[0], v[1], v[3]}}, v[4]};
}

bool is_setting(const std::string& key) {
  return kDefaults.count(key) != 0 || kOthers.count(key) != 0 || key == "cell" || key == "tracking";
}

/// Of several records, the last one counts.
void set(const Record& record, World& world) {
  const std::string& key = record.key();
  if (key == "tracking") {
    if (record.words.size() != 2) record.refuse("'tracking' needs a kind of vehicle");
    world.tracking = record.words[1];
  } else if (kOthers.count(key) == 0) {
    world.settings[key] = record.numbers(1, 1)[0];
  }
}

void add(const Record& record, Point& goal, World& world, std::vector<Record>& covers) {
  const std::string& key = record.key();
  if (is_setting(key)) {
    set(record, world);
  } else if (key == "boundary") {
    world.boundary = box_from(record, record.numbers(1, 6));
  } else if (key == "block") {
    world.blocks.push_back(block_from(record));
  } else if (key == "cylinder") {
    world.cylinders.push_back(cylinder_from(record));
  } else if (is_fence(key)) {
    world.fences.push_back(fence_from(record));
  } else if (key == "fences_within") {
    covers.push_back(record);
  } else if (key == "start") {
    world.start = point_from(record.numbers(1, 3));
  } else if (key == "goal") {
    goal = point_from(record.numbers(1, 3));
  } else if (key == "via") {
    world.mission.push_back(via_from(record).position);
  } else if (key != "via_policy" && key != "frame" && key != "epoch") {
    record.refuse("unknown record '" + key + "'");
  }
}

/// "v_max=2" or "window=20,20,8".
Record override_from(const std::string& text) {
  std::string words = text;
  std::replace(words.begin(), words.end(), '=', ' ');
  std::replace(words.begin(), words.end(), ',', ' ');
  const std::vector<Record> records = records_of(words, "--set " + text);
  if (records.size() != 1 || text.find('=') == std::string::npos || !is_setting(records[0].key())) {
    throw InputError("--set " + text + ": it is no setting of a flight");
  }
  return records[0];
}

/// Beyond each face of the boundary, as thick and wide as the boundary is long.
std::vector<Solid> walls_of(const Box& boundary) {
  Rational size = 1;
  for (std::size_t a = 0; a < 3; ++a) size += boundary.upper[a] - boundary.lower[a];
  std::vector<Solid> walls;
  for (std::size_t a = 0; a < 3; ++a) {
    Box around = boundary;
    for (std::size_t i = 0; i < 3; ++i) {
      around.lower[i] -= size;
      around.upper[i] += size;
    }
    Box below = around;
    below.upper[a] = boundary.lower[a];
    Box above = around;
    above.lower[a] = boundary.upper[a];
    walls.push_back({below, 0});
    walls.push_back({above, 0});
  }
  return walls;
}

bool same(const Box& a, const Box& b) {
  return std::tie(a.lower, a.upper) == std::tie(b.lower, b.upper);
}

bool same(const Solid& a, const Solid& b) {
  return same(a.box, b.box) && a.radius == b.radius;
}

template <typename T>
bool all_alike(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
}

}  // namespace

const std::vector<std::string> kWorldSettings = {"body_radius", "tracking_margin", "pose_margin", "cell",
                                                 "v_max",       "a_max",           "j_max",       "thrust_max",
                                                 "thrust_min",  "tilt_tangent",    "rate_max",    "tick_hz"};

World parse_world(const std::string& text, const std::string& name, const std::vector<std::string>& overrides) {
  World world;
  world.boundary = {{0, 0, 0}, {0, 0, 0}};
  world.start = {0, 0, 0};
  world.settings = kDefaults;
  world.tracking = "bounded";
  Point goal{0, 0, 0};
  std::vector<Record> fences, covers;
  for (const Record& record : records_of(text, name)) {
    add(record, goal, world, covers);
    if (world.fences.size() > fences.size()) fences.push_back(record);
  }
  for (const std::string& setting : overrides) set(override_from(setting), world);
  world.mission.push_back(goal);
  for (std::size_t a = 0; a < 3; ++a) {
    if (world.boundary.lower[a] >= world.boundary.upper[a]) throw InputError(name + ": there is no boundary");
  }
  refuse_empty(world.fences, fences, world.boundary);
  const Rational clearance =
      world.setting("body_radius") + world.setting("pose_margin") + world.setting("tracking_margin");
  for (const Record& cover : covers) require_cover(cover, world.boundary, clearance);
  const bool is_storey = world.boundary.upper[2] - world.boundary.lower[2] <= kStorey;
  world.settings.emplace("cell", is_storey ? 0.1 : 0.2);
  return world;
}

std::vector<Solid> solids_of(const World& world) {
  std::vector<Solid> solids = walls_of(world.boundary);
  for (const Box& block : world.blocks) solids.push_back({block, 0});
  solids.insert(solids.end(), world.cylinders.begin(), world.cylinders.end());
  return solids;
}

std::vector<Bound> bounds_of(const World& world) {
  const auto at_most = [](const Rational& limit, int most) { return std::min<Rational>(limit, most); };
  const Rational& speed = world.setting("v_max");
  const Rational& gentle = world.setting("a_max");
  const Rational& jerk = world.setting("j_max");
  const bool is_rigid = world.tracking == "quadrotor" || world.tracking == "px4" || world.tracking == "ardupilot";
  const Rational sink = -at_most(gentle, is_rigid ? kMostSinkAcceleration : kMostClimbAcceleration);
  std::vector<Bound> bounds;
  add_bounds(1, {speed, speed, at_most(speed, kMostClimb)}, {0, 0, 0}, speed, bounds);
  add_bounds(2, {gentle, gentle, at_most(gentle, kMostClimbAcceleration)}, {0, 0, sink}, gentle, bounds);
  add_bounds(3, {jerk, jerk, jerk}, {0, 0, 0}, 0, bounds);
  add_bounds({world.setting("thrust_max"), world.setting("thrust_min"), world.setting("tilt_tangent"),
              world.setting("rate_max")},
             bounds);
  return bounds;
}

std::string difference(const World& a, const World& b) {
  if (!same(a.boundary, b.boundary)) return "boundary";
  if (!all_alike(a.blocks, b.blocks)) return "blocks";
  if (!all_alike(a.cylinders, b.cylinders)) return "cylinders";
  if (!all_alike(a.fences, b.fences)) return "fences";
  if (a.start != b.start) return "start";
  if (a.mission != b.mission) return "points of the mission";
  for (const std::string& key : kWorldSettings) {
    if (a.setting(key) != b.setting(key)) return key;
  }
  return a.tracking == b.tracking ? "" : "tracking";
}

}  // namespace tern_verify
