// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/fence_records.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "verify/emptiness.hpp"

namespace tern_verify {
namespace {

const std::set<std::string> kKeys = {"keepin", "keepout", "keepin_halfspaces", "keepout_halfspaces"};

/// The six faces of a box.
std::vector<HalfSpace> faces_of(const Box& box) {
  std::vector<HalfSpace> faces;
  for (std::size_t a = 0; a < 3; ++a) {
    Point axis{0, 0, 0};
    axis[a] = 1;
    faces.push_back({axis, box.upper[a]});
    axis[a] = -1;
    faces.push_back({axis, -box.lower[a]});
  }
  return faces;
}

bool equal_planes(const HalfSpace& a, const HalfSpace& b) {
  return std::tie(a.normal, a.offset) == std::tie(b.normal, b.offset);
}

}  // namespace

std::string take_zone(Record& record) {
  const auto zone = std::find(record.words.begin(), record.words.end(), "zone");
  std::string name;
  for (auto word = zone; word != record.words.end(); ++word) {
    // The times would be lost in the name, and the fence would hold always.
    if (*word == "during" && word + 1 != record.words.end() && is_number(word[1])) {
      record.refuse("the times come before the name: 'during t0 t1 zone NAME'");
    }
    if (word != zone) name += (name.empty() ? "" : " ") + *word;
  }
  record.words.erase(zone, record.words.end());
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return name;
}

std::optional<Window> take_window(Record& record) {
  const auto during = std::find(record.words.begin(), record.words.end(), "during");
  if (during == record.words.end()) return std::nullopt;
  const std::vector<Rational> times = Record{record.file, record.line, {during, record.words.end()}}.numbers();
  record.words.erase(during, record.words.end());
  if (times.size() != 2 && times.size() != 3) record.refuse("'during' needs 2 or 3 numbers");
  const Window window{whole_nanoseconds(times[0]), whole_nanoseconds(times[1]),
                      times.size() == 3 ? times[2] : Rational(0)};
  if (!(window.from < window.until) || window.clock_error < 0) record.refuse("'during' is no interval of time");
  return window;
}

void require_cover(const Record& record, const Box& boundary, const Rational& clearance) {
  const std::vector<Rational> v = record.numbers(1, 7);
  const Box made_for = box_from(record, v);
  // Numbers are the doubles next to decimals, so that sums may be off by a rounding.
  const Rational touch = decimal(1, 9);
  if (v[6] < 0) record.refuse("the clearance of 'fences_within' must not be less than 0");
  if (clearance > v[6] + touch) {
    record.refuse("the fences were made for a clearance of " + record.words[7] + " m, but the flight keeps " +
                  text_above(clearance) + " m: zones may be missing");
  }
  for (std::size_t a = 0; a < 3; ++a) {
    if (boundary.lower[a] + touch >= made_for.lower[a] && boundary.upper[a] <= made_for.upper[a] + touch) continue;
    record.refuse("the boundary reaches beyond the one that the fences were made for: zones may be missing");
  }
}

bool is_fence(const std::string& key) {
  return kKeys.count(key) != 0;
}

Fence fence_from(const Record& given) {
  Record record = given;
  const std::string& key = record.key();
  Fence result{key.rfind("keepout", 0) != 0, {}};
  result.zone = take_zone(record);
  result.window = take_window(record);
  if (key == "keepin" || key == "keepout") {
    result.planes = faces_of(box_from(record, record.numbers(1, 6)));
    return result;
  }
  const std::vector<Rational> v = record.numbers();
  if (v.empty() || v.size() % 4 != 0) record.refuse("'" + key + "' needs 4 numbers a half-space");
  for (std::size_t i = 0; i < v.size(); i += 4) {
    result.planes.push_back({point_from(v, i), v[i + 3]});
    if (dot(result.planes.back().normal, result.planes.back().normal) == 0) record.refuse("a normal is no direction");
  }
  return result;
}

Fence fence_of(const Json& json) {
  Fence fence{json.at("kind").get<std::string>() == "keep_in", {}};
  for (const Json& plane : json.at("half_spaces")) fence.planes.push_back({point_of(plane), number_of(plane.at(3))});
  if (fence.planes.empty()) throw InputError("a fence has no half-spaces");
  fence.zone = json.value("zone", "");
  if (!json.contains("from_ns")) return fence;
  const auto seconds = [&](const char* key) { return Rational(json.at(key).get<std::int64_t>()) / 1000000000; };
  fence.window = Window{seconds("from_ns"), seconds("until_ns"), number_of(json.at("clock_error_s"))};
  return fence;
}

std::string with_zone(const std::string& title, const std::string& zone) {
  return zone.empty() ? title : title + " (" + zone + ")";
}

std::string title_of(const std::vector<Fence>& fences, std::size_t f) {
  return with_zone("fence " + std::to_string(f + 1), fences[f].zone);
}

bool same(const Fence& a, const Fence& b) {
  const auto times = [](const Fence& f) { return std::tie(f.window->from, f.window->until, f.window->clock_error); };
  if (a.window.has_value() != b.window.has_value() || (a.window && times(a) != times(b))) return false;
  return a.keep_in == b.keep_in && a.distance == b.distance &&
         std::equal(a.planes.begin(), a.planes.end(), b.planes.begin(), b.planes.end(), equal_planes);
}

void keep_distance(const Rational& clearance, std::vector<Fence>& fences) {
  for (Fence& fence : fences) {
    if (!fence.keep_in) fence.distance += clearance;
  }
}

void refuse_empty(const std::vector<Fence>& fences, const std::vector<Record>& records, const Box& boundary) {
  const std::optional<std::size_t> empty = empty_fence(fences, boundary);
  if (empty) records[*empty].refuse("'" + records[*empty].key() + "': " + empty_text(fences[*empty]));
}

}  // namespace tern_verify
