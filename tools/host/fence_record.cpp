// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/fence_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/fence_fault.hpp"
#include "host/number.hpp"
#include "tern/config.hpp"

namespace tern_host {
namespace {

using tern::Halfspace;
using tern::Vec3;

/// Rounds of Dykstra's method; its steps shrink fast where few planes meet.
constexpr int kRounds = 200;
/// Seconds; further away, nanoseconds do not fit.
constexpr double kMostSeconds = 4e9;

double product(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Groups of four numbers a, b, c, d: a x + b y + c z <= d.
std::vector<Halfspace> halfspaces(const std::vector<double>& v, const std::string& key, const Place& place) {
  if (v.empty() || v.size() % 4 != 0) throw_count(key, "4 numbers a half-space", v.size(), place);
  std::vector<Halfspace> planes;
  for (std::size_t i = 0; i < v.size(); i += 4) {
    const double square = v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2];
    const bool usable = square >= tern::kMinFenceNormal * tern::kMinFenceNormal &&
                        square <= tern::kMaxFenceNormal * tern::kMaxFenceNormal;
    if (!usable) throw RecordError(place, "'" + key + "' has a normal that is no direction");
    planes.push_back({{v[i], v[i + 1], v[i + 2]}, v[i + 3]});
  }
  return planes;
}

std::vector<Halfspace> planes_of(const Words& words, const Place& place) {
  const std::string& key = words.front();
  const std::vector<double> values = numbers(words, place);
  if (key == "keepin_halfspaces" || key == "keepout_halfspaces") return halfspaces(values, key, place);
  Halfspace planes[tern::kBoxPlanes];
  tern::box_planes(box_of(values, key, place), planes);
  return {planes, planes + tern::kBoxPlanes};
}

/// Beyond a plane, metres; negative behind it.
double beyond(const Halfspace& plane, const Vec3& point) {
  return (product(plane.normal, point) - plane.offset) / std::sqrt(product(plane.normal, plane.normal));
}

/// Distance of a point from the polyhedron by Dykstra's alternating projections; 0 inside.
double distance_from(const std::vector<Halfspace>& planes, const Vec3& point) {
  std::vector<double> pushed(planes.size(), 0.0);
  Vec3 at = point;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const double norm = std::sqrt(product(planes[k].normal, planes[k].normal));
      const Vec3 n{planes[k].normal.x / norm, planes[k].normal.y / norm, planes[k].normal.z / norm};
      const double before = pushed[k];
      pushed[k] = std::max(0.0, beyond(planes[k], at) + before);
      const double step = before - pushed[k];
      at = {at.x + step * n.x, at.y + step * n.y, at.z + step * n.z};
    }
  }
  return std::hypot(at.x - point.x, at.y - point.y, at.z - point.z);
}

}  // namespace

tern::Box box_of(const std::vector<double>& v, const std::string& key, const Place& place) {
  if (v.size() != 6) throw_count(key, "6 numbers", v.size(), place);
  for (std::size_t a = 0; a < 3; ++a) {
    if (v[a] <= v[a + 3]) continue;
    throw RecordError(place, "'" + key + "' has its corners the wrong way round in " + "xyz"[a] + ": " + brief(v[a]) +
                                 " > " + brief(v[a + 3]));
  }
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

tern::Box block_box(const Words& words, const Place& place) {
  const std::vector<double> values = numbers(words, place);
  if (values.size() != 6 && values.size() != 9) {
    throw_count(words.front(), "6 numbers, or 9 with a colour", values.size(), place);
  }
  return box_of({values.begin(), values.begin() + 6}, words.front(), place);
}

bool is_fence(const std::string& key) {
  return key == "keepin" || key == "keepout" || key == "keepin_halfspaces" || key == "keepout_halfspaces";
}

namespace {

/// The words from `key` on, which are taken off.
Words take_from(const char* key, Words& words) {
  const auto found = std::find(words.begin(), words.end(), key);
  const Words taken(found, words.end());
  words.erase(found, words.end());
  return taken;
}

void read_window(const Words& words, const Place& place, FenceEnd& end) {
  const std::vector<double> times = numbers(words, place);
  if (times.size() != 2 && times.size() != 3) throw_count("during", "2 times, or 3 with an error", times.size(), place);
  for (const double time : times) {
    if (!(std::fabs(time) <= kMostSeconds)) throw RecordError(place, "the times of 'during' are too far away");
  }
  end.from = std::llround(times[0] * 1e9);
  end.until = std::llround(times[1] * 1e9);
  if (!(end.from < end.until)) throw RecordError(place, "'during' ends before it begins, or at once");
  if (times.size() == 3) end.clock_error = times[2];
  if (!(end.clock_error >= 0.0)) throw RecordError(place, "a clock's error must not be less than 0");
}

}  // namespace

bool hides_times(const Words& name) {
  for (std::size_t i = 1; i < name.size(); ++i) {
    double value = 0.0;
    if (name[i - 1] == "during" && parse_number(name[i], value) != NumberError::kMalformed) return true;
  }
  return false;
}

FenceEnd take_end(const Place& place, Words& words) {
  FenceEnd end;
  // A name may have 'during' too: it is taken off first.
  const Words zone = take_from("zone", words), during = take_from("during", words);
  if (zone.size() == 1) throw RecordError(place, "'zone' needs a name");
  if (hides_times(zone)) throw RecordError(place, "a name is to the end of the line: write 'during t0 t1 zone NAME'");
  for (std::size_t i = 1; i < zone.size(); ++i) end.zone += (i > 1 ? " " : "") + zone[i];
  if (!during.empty()) read_window(during, place, end);
  return end;
}

void add_fence(const Words& words, const Place& place, std::vector<FenceRecord>& fences, const FenceEnd& end) {
  const bool keeps_out = words.front().rfind("keepout", 0) == 0;
  FenceRecord fence{{}, planes_of(words, place), words.front(), place, end.zone};
  fence.fence.kind = keeps_out ? tern::FenceKind::kKeepOut : tern::FenceKind::kKeepIn;
  fence.fence.from = end.from;
  fence.fence.until = end.until;
  fence.fence.clock_error = end.clock_error;
  if (fence.planes.size() > static_cast<std::size_t>(tern::kMaxFencePlanes)) {
    throw RecordError(place, "a fence of more than " + std::to_string(tern::kMaxFencePlanes) +
                                 " half-spaces (TERN_MAX_FENCE_PLANES)");
  }
  if (fences.size() == kMostFences) {
    throw RecordError(place, "more than " + std::to_string(kMostFences) + " fences");
  }
  fences.push_back(fence);
}

namespace {

/// True if a keep-out has no point within the map, grown by the clearance.
bool misses(const FenceRecord& fence, const tern::GridSpec& map) {
  const double by = map.radius;
  const tern::Box room{{map.boundary.lower.x - by, map.boundary.lower.y - by, map.boundary.lower.z - by},
                       {map.boundary.upper.x + by, map.boundary.upper.y + by, map.boundary.upper.z + by}};
  std::vector<FenceRecord> within{fence};
  Halfspace faces[tern::kBoxPlanes];
  tern::box_planes(room, faces);
  within.front().planes.insert(within.front().planes.end(), faces, faces + tern::kBoxPlanes);
  return tern::find_fence_fault(fences_of(within).data(), 1, map).status == tern::Status::kFenceEmpty;
}

/// The index of an empty fence. The core looks at keep-outs one by one, and at all keep-ins together, which must fit a
/// request.
std::int32_t find_empty(const std::vector<FenceRecord>& fences, const tern::GridSpec& map) {
  const std::vector<tern::Fence> all = fences_of(fences);
  std::vector<tern::Fence> keep_ins;
  std::vector<std::int32_t> places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool keeps_in = all[i].kind == tern::FenceKind::kKeepIn;
    if (keeps_in) {
      keep_ins.push_back(all[i]);
      places.push_back(static_cast<std::int32_t>(i));
    } else if (tern::find_fence_fault(&all[i], 1, map).status == tern::Status::kFenceEmpty) {
      return static_cast<std::int32_t>(i);
    }
  }
  const auto count = static_cast<std::int32_t>(keep_ins.size());
  const tern::FenceFault fault = tern::find_fence_fault(keep_ins.data(), count, map);
  return fault.status == tern::Status::kFenceEmpty ? places[static_cast<std::size_t>(fault.fence)] : tern::kNoFence;
}

/// Half-spaces that miss the map are most likely a slip of a sign, and then nothing is kept out.
void refuse_keepouts_elsewhere(const std::vector<FenceRecord>& fences, const tern::GridSpec& map) {
  for (const FenceRecord& fence : fences) {
    if (fence.key != "keepout_halfspaces" || !misses(fence, map)) continue;
    throw RecordError(fence.place, "'" + fence.key + "' has no part inside the boundary; has one of its half-spaces " +
                                       "the wrong sign? Leave out a fence that is elsewhere");
  }
}

}  // namespace

void refuse_empty_fences(const std::vector<FenceRecord>& fences, const tern::Box& boundary, double clearance) {
  tern::GridSpec map{};
  map.boundary = boundary;
  map.radius = clearance;
  const std::int32_t found = find_empty(fences, map);
  if (found == tern::kNoFence) return refuse_keepouts_elsewhere(fences, map);
  const FenceRecord& empty = fences[static_cast<std::size_t>(found)];
  const bool keeps_in = empty.fence.kind == tern::FenceKind::kKeepIn;
  const std::string others = keeps_in && !tern::is_timed(empty.fence) ? " with those of the keep-ins before it" : "";
  throw RecordError(empty.place, "'" + empty.key + "' is empty: its half-spaces have no common point" + others +
                                     "; is one of them, or the order of the polygon, reversed?");
}

bool has_fence(const std::vector<FenceRecord>& fences, tern::FenceKind kind) {
  return std::any_of(fences.begin(), fences.end(),
                     [kind](const FenceRecord& fence) { return fence.fence.kind == kind; });
}

bool has_keepout(const std::vector<FenceRecord>& fences, bool for_a_while) {
  return std::any_of(fences.begin(), fences.end(), [for_a_while](const FenceRecord& fence) {
    return fence.fence.kind == tern::FenceKind::kKeepOut && tern::is_timed(fence.fence) == for_a_while;
  });
}

bool exceeds_capacity(const std::vector<FenceRecord>& fences) {
  std::size_t planes = 0;
  for (const FenceRecord& record : fences) planes += record.planes.size();
  return fences.size() > static_cast<std::size_t>(tern::kMaxFences) ||
         planes > static_cast<std::size_t>(tern::kMaxFencePlanes);
}

std::string zone_text(const std::vector<FenceRecord>& fences, std::int32_t index) {
  if (index < 0 || static_cast<std::size_t>(index) >= fences.size()) return "";
  const std::string& zone = fences[static_cast<std::size_t>(index)].zone;
  return zone.empty() ? "" : " (" + zone + ")";
}

FenceSpan span_of(const tern::Fence& fence) {
  const double wider = fence.kind == tern::FenceKind::kKeepOut ? fence.clock_error : -fence.clock_error;
  return {static_cast<double>(fence.from) / 1e9 - wider, static_cast<double>(fence.until) / 1e9 + wider};
}

std::vector<tern::Fence> fences_of(const std::vector<FenceRecord>& records) {
  std::vector<tern::Fence> fences;
  for (const FenceRecord& record : records) {
    fences.push_back(record.fence);
    fences.back().planes = record.planes.data();
    fences.back().count = static_cast<std::int32_t>(record.planes.size());
  }
  return fences;
}

nlohmann::ordered_json fence_json(const FenceRecord& fence) {
  nlohmann::ordered_json planes = nlohmann::ordered_json::array();
  for (const Halfspace& p : fence.planes) planes.push_back({p.normal.x, p.normal.y, p.normal.z, p.offset});
  const bool keeps_in = fence.fence.kind == tern::FenceKind::kKeepIn;
  nlohmann::ordered_json json{{"kind", keeps_in ? "keep_in" : "keep_out"}, {"half_spaces", planes}};
  if (!fence.zone.empty()) json["zone"] = fence.zone;
  if (!tern::is_timed(fence.fence)) return json;
  json["from_ns"] = fence.fence.from;
  json["until_ns"] = fence.fence.until;
  json["clock_error_s"] = fence.fence.clock_error;
  return json;
}

double beyond_planes(const FenceRecord& fence, const Vec3& point) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Halfspace& plane : fence.planes) most = std::max(most, beyond(plane, point));
  return most;
}

double fence_gap(const FenceRecord& fence, const Vec3& point) {
  const double most = beyond_planes(fence, point);
  if (fence.fence.kind == tern::FenceKind::kKeepIn) return -most;
  return most > 0.0 ? distance_from(fence.planes, point) : most;
}

}  // namespace tern_host
