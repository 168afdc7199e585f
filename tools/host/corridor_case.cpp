// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/corridor_case.hpp"

#include <set>

#include "tern/config.hpp"

namespace tern_host {
namespace {

/// The word after `key` in a record of pairs; null where there is none.
const std::string* find_value(const Words& words, const std::string& key) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] == key) return &words[i + 1];
  }
  return nullptr;
}

double positive_value(const Words& words, const std::string& key, const Place& place) {
  const std::string* const word = find_value(words, key);
  if (word == nullptr) throw RecordError(place, "'" + words.front() + "' needs a '" + key + "' with a value");
  const double value = number(*word, place);
  if (!(value > 0.0)) throw RecordError(place, "'" + key + "' must be more than 0");
  return value;
}

bool flag_value(const Words& words, const std::string& key, bool otherwise, const Place& place) {
  const std::string* const word = find_value(words, key);
  if (word == nullptr) return otherwise;
  if (*word != "0" && *word != "1") throw RecordError(place, "'" + key + "' must be 0 or 1, found " + quote(*word));
  return *word == "1";
}

int count(const std::string& word, int most, const std::string& constant, const Place& place) {
  const double value = number(word, place);
  if (!(value >= 1.0) || value > 1e6 || static_cast<double>(static_cast<int>(value)) < value) {
    throw RecordError(place, quote(word) + " is not a count above 0");
  }
  if (value > most) throw RecordError(place, "more than " + std::to_string(most) + " (" + constant + ")");
  return static_cast<int>(value);
}

/// Gathers records into a case.
class Builder {
 public:
  void add(const Words& words, const Place& place) {
    const std::string& key = words.front();
    if (key == "wp") return c_.waypoints.push_back(vector(words, place));
    if (key == "hs") return add_plane(words, place);
    if (!given_.insert(key).second) throw RecordError(place, quote(key) + " is given twice");
    if (tern::Vec3* const target = find_vector(key)) {
      *target = vector(words, place);
    } else if (key == "id") {
      add_name(words, place);
    } else if (key == "M") {
      add_shape(words, place);
    } else if (key == "vmax") {
      c_.v_max = positive_value(words, "vmax", place);
      c_.a_max = positive_value(words, "amax", place);
    } else if (key == "T") {
      add_durations(words, place);
    } else {
      throw RecordError(place, "unknown record " + quote(key));
    }
  }

  CorridorCase finish(const Place& end) const {
    for (const char* const key : {"id", "M", "vmax", "start_p", "goal_p", "T"}) {
      if (given_.count(key) == 0) throw RecordError(end, std::string("the file ends without a '") + key + "'");
    }
    const auto segments = static_cast<std::size_t>(c_.segments);
    if (c_.durations.size() != segments) throw_count("T", "one number a segment", c_.durations.size(), end);
    if (c_.waypoints.size() != segments + 1) throw_count("wp", "one record a joint", c_.waypoints.size(), end);
    return c_;
  }

 private:
  tern::Vec3* find_vector(const std::string& key) {
    const struct {
      const char* key;
      tern::Vec3* value;
    } vectors[] = {{"start_p", &c_.start[0]}, {"start_v", &c_.start[1]}, {"start_a", &c_.start[2]},
                   {"start_j", &c_.start[3]}, {"goal_p", &c_.goal},      {"warm_dp", &c_.shift}};
    for (const auto& entry : vectors) {
      if (key == entry.key) return entry.value;
    }
    return nullptr;
  }

  void add_name(const Words& words, const Place& place) {
    if (words.size() < 2) throw RecordError(place, "'id' needs a name");
    c_.id = words[1];
    const std::string* const kind = find_value(words, "class");
    if (kind != nullptr) c_.kind = *kind;
  }

  void add_shape(const Words& words, const Place& place) {
    if (words.size() < 2) throw RecordError(place, "'M' needs a number of segments");
    c_.segments = count(words[1], tern::kMaxSegments, "TERN_MAX_SEGMENTS", place);
    c_.planes.resize(static_cast<std::size_t>(c_.segments));
    const std::string* const degree = find_value(words, "degree");
    if (degree != nullptr && *degree != "7") throw RecordError(place, "'degree' must be 7, found " + quote(*degree));
    if (flag_value(words, "c4", false, place)) throw RecordError(place, "'c4' must be 0: joints are C3");
    c_.start_jerk_fixed = flag_value(words, "start_jerk_fixed", true, place);
    c_.goal_jerk_fixed = flag_value(words, "goal_jerk_fixed", true, place);
  }

  void add_durations(const Words& words, const Place& place) {
    c_.durations = numbers(words, place);
    for (const double duration : c_.durations) {
      if (!(duration > 0.0)) throw RecordError(place, "'T' must be more than 0");
    }
  }

  void add_plane(const Words& words, const Place& place) {
    const std::vector<double> v = numbers(words, place);
    if (v.size() != 5) throw_count("hs", "5 numbers: segment, normal, offset", v.size(), place);
    if (!(v[0] >= 0.0 && v[0] < c_.segments)) {
      throw RecordError(place, "no segment " + quote(words[1]) + "; 'M' gave " + std::to_string(c_.segments));
    }
    auto& planes = c_.planes[static_cast<std::size_t>(v[0])];
    if (planes.size() == tern::kMaxPlanes) {
      throw RecordError(place, "more than " + std::to_string(tern::kMaxPlanes) + " planes (TERN_MAX_PLANES)");
    }
    planes.push_back({{v[1], v[2], v[3]}, v[4]});
  }

  CorridorCase c_;
  std::set<std::string> given_;
};

}  // namespace

CorridorCase parse_corridor_case(const std::string& text, const std::string& name) {
  Builder builder;
  const Place end =
      for_each_record(text, name, [&](const Words& words, const Place& place) { builder.add(words, place); });
  return builder.finish(end);
}

CorridorCase read_corridor_case(const std::string& path) {
  return parse_corridor_case(read_text(path), path);
}

}  // namespace tern_host
