// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/map_warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Box;
using tern::Vec3;

constexpr std::size_t kMostSamples = 4096;
/// Fewer points say nothing about their unit.
constexpr std::size_t kManyPoints = 10;

constexpr double kLeastPart = 0.1;

struct Unit {
  double metres;
  const char* name;
};
constexpr Unit kUnits[] = {{0.01, "centimetres"}, {0.001, "millimetres"}, {1000.0, "kilometres"}};

bool holds(const Box& b, const Vec3& p) {
  return p.x >= b.lower.x && p.x <= b.upper.x && p.y >= b.lower.y && p.y <= b.upper.y && p.z >= b.lower.z &&
         p.z <= b.upper.z;
}

Vec3 scaled(const Vec3& p, double factor) {
  return {factor * p.x, factor * p.y, factor * p.z};
}

double largest_side(const Box& b) {
  return std::max({b.upper.x - b.lower.x, b.upper.y - b.lower.y, b.upper.z - b.lower.z});
}

/// Points of another unit are spread through a part of the box that is worth the name, once they are in metres.
bool fits(const std::vector<Vec3>& points, const Box& box, double metres) {
  Box all{points[0], points[0]};
  for (const Vec3& p : points) {
    all.lower = {std::min(all.lower.x, p.x), std::min(all.lower.y, p.y), std::min(all.lower.z, p.z)};
    all.upper = {std::max(all.upper.x, p.x), std::max(all.upper.y, p.y), std::max(all.upper.z, p.z)};
  }
  return metres * largest_side(all) > kLeastPart * largest_side(box);
}

/// Most of the points, after a change.
template <typename Change>
bool most_within(const std::vector<Vec3>& points, const Box& box, Change change) {
  std::size_t within = 0;
  for (const Vec3& p : points) within += holds(box, change(p)) ? 1 : 0;
  return 2 * within > points.size();
}

/// Each axis from one of a point's own, forwards or backwards.
struct Axes {
  std::array<std::size_t, 3> from;
  int signs;

  Vec3 of(const Vec3& p) const {
    const double own[3] = {p.x, p.y, p.z};
    const auto value = [&](std::size_t a) { return (signs >> a & 1) != 0 ? -own[from[a]] : own[from[a]]; };
    return {value(0), value(1), value(2)};
  }
  std::string text() const {
    std::string all;
    for (std::size_t a = 0; a < 3; ++a) {
      all += std::string(a > 0 ? ", " : "") + ((signs >> a & 1) != 0 ? "-" : "") + "xyz"[from[a]];
    }
    return all;
  }
};

/// All but the point's own.
std::vector<Axes> other_axes() {
  std::vector<Axes> all;
  std::array<std::size_t, 3> from{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) all.push_back({from, signs});
  } while (std::next_permutation(from.begin(), from.end()));
  return {all.begin() + 1, all.end()};
}

std::vector<Vec3> sampled(const std::vector<Vec3>& points) {
  const std::size_t step = points.size() / kMostSamples + 1;
  std::vector<Vec3> samples;
  for (std::size_t i = 0; i < points.size(); i += step) samples.push_back(points[i]);
  return samples;
}

std::string text_of(const Vec3& p) {
  return "(" + brief(p.x) + ", " + brief(p.y) + ", " + brief(p.z) + ")";
}

std::string text_of(const Box& box) {
  return text_of(box.lower) + " to " + text_of(box.upper);
}

constexpr char kKeepIn[] = "keepin";

/// Records of one kind that add nothing.
struct Idle {
  std::string key;
  std::size_t total = 0;  ///< those that do, too
  std::size_t count = 0;
  int first = 0;
  std::vector<Vec3> corners{};

  void add(const BoxRecord& record) {
    if (count++ == 0) first = record.line;
    if (corners.size() > kMostSamples) return;
    corners.push_back(record.box.lower);
    corners.push_back(record.box.upper);
  }
};

/// A keep-in around all of a map may be meant so, unless it fits the map in another unit.
bool adds_nothing(const BoxRecord& record, const Box& boundary, const Box& reach) {
  if (record.key != std::string(kKeepIn)) return !meets(record.box, reach);
  const bool holds_all = holds(record.box, boundary.lower) && holds(record.box, boundary.upper);
  return holds_all && !likely_mistake({record.box.lower, record.box.upper}, reach).empty();
}

std::string counts_of(const MapFile& file, const MapContent& content) {
  const bool cloud = file.kind == MapFileKind::kCloud;
  std::string text = " of its " + std::to_string(content.read) + (cloud ? " points" : " occupied leaves");
  if (cloud) text += ", " + std::to_string(content.dropped) + " are not finite and";
  return text + " " + std::to_string(content.outside) + " are outside the boundary";
}

}  // namespace

Box reach_of(const Box& b, double clearance, double cell) {
  const double margin = clearance + 2.0 * cell;
  return {{b.lower.x - margin, b.lower.y - margin, b.lower.z - margin},
          {b.upper.x + margin, b.upper.y + margin, b.upper.z + margin}};
}

Box reach_of(const Scenario& scenario) {
  return reach_of(scenario.boundary, scenario.clearance(), scenario.resolution);
}

bool meets(const Box& a, const Box& b) {
  return a.lower.x < b.upper.x && b.lower.x < a.upper.x && a.lower.y < b.upper.y && b.lower.y < a.upper.y &&
         a.lower.z < b.upper.z && b.lower.z < a.upper.z;
}

std::string likely_mistake(const std::vector<Vec3>& points, const Box& box) {
  const std::vector<Vec3> samples = sampled(points);
  if (samples.empty()) return "";
  for (const Unit& unit : kUnits) {
    const auto in_metres = [&](const Vec3& p) { return scaled(p, unit.metres); };
    if (fits(samples, box, unit.metres) && most_within(samples, box, in_metres)) {
      return std::string(": are they in ") + unit.name + ", not metres?";
    }
  }
  for (const Axes& axes : other_axes()) {
    if (most_within(samples, box, [&](const Vec3& p) { return axes.of(p); })) {
      return ": have they other axes? As (" + axes.text() + ") they would be inside";
    }
  }
  return "";
}

void warn_of_records(const std::vector<BoxRecord>& records, const Box& boundary, const Box& reach,
                     const std::string& file, std::vector<std::string>& warnings) {
  std::vector<Idle> kinds;
  for (const BoxRecord& record : records) {
    const std::string key = record.key;
    auto kind = std::find_if(kinds.begin(), kinds.end(), [&key](const Idle& one) { return one.key == key; });
    if (kind == kinds.end()) kind = kinds.insert(kind, {key});
    ++kind->total;
    if (adds_nothing(record, boundary, reach)) kind->add(record);
  }
  for (const Idle& kind : kinds) {
    if (kind.count == 0) continue;
    warnings.push_back(file + ":" + std::to_string(kind.first) + ": " + std::to_string(kind.count) + " of " +
                       std::to_string(kind.total) + " '" + kind.key + "' records add" + (kind.count == 1 ? "s" : "") +
                       " nothing to the map, first this one: " +
                       (kind.key == kKeepIn ? "around all of the boundary" : "outside the boundary") +
                       likely_mistake(kind.corners, reach));
  }
}

void warn_of_map_file(const MapFile& file, const MapContent& content, const std::vector<Vec3>& points,
                      const Scenario& scenario, std::vector<std::string>& warnings) {
  const std::string name = file.place.file + ":" + std::to_string(file.place.line) + ": " + quote(file.name);
  const std::size_t finite = content.read - content.dropped;
  const std::size_t within = finite - content.outside;
  const double size = largest_side(content.extent);
  const std::string span = finite > 0 ? "; they lie at " + text_of(content.extent) : "";
  const Box reach = reach_of(scenario);
  if (content.has_viewpoint) {
    warnings.push_back(name + " has a 'VIEWPOINT', from where it was seen: its points are taken as they are");
  }
  if (within == 0 && !(content.free_within && scenario.unknown == Unknown::kSolid)) {
    warnings.push_back(name + " adds nothing to the map:" + counts_of(file, content) + span +
                       likely_mistake(points, reach));
  } else if (2 * content.outside > finite) {
    warnings.push_back(name + " is mostly left out:" + counts_of(file, content) + span + likely_mistake(points, reach));
  } else if (finite >= kManyPoints && size < scenario.resolution) {
    warnings.push_back(name + " adds next to nothing to the map: all of its " + std::to_string(finite) +
                       (file.kind == MapFileKind::kCloud ? " points" : " occupied leaves") + " lie within " +
                       brief(size) + " m: are they in kilometres, not metres?");
  }
}

}  // namespace tern_host
