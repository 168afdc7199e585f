// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/detection_records.hpp"

#include <algorithm>

#include "tern_onboard/parameters.hpp"

namespace tern_host {
namespace {

void set_detection_error(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  s.detection_error = within(words[0], values[0], {0.0, 10.0}, place);
  s.detection_speed_error = within(words[0], values[1], {0.0, 10.0}, place);
}

/// A source, and for clusters what they are taken for. What sensors are to track, they must see.
void set_detection_source(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<std::string>& classes = tern_onboard::class_words();
  const bool is_truth = words.size() == 2 && words[1] == "truth";
  const auto kind =
      words.size() == 3 && words[1] == "clusters" ? std::find(classes.begin(), classes.end(), words[2]) : classes.end();
  if (!is_truth && kind == classes.end()) {
    throw RecordError(place,
                      "detection_source is truth, or clusters and a class: person, cyclist, car, truck, bird, "
                      "drone or aircraft");
  }
  s.detection_source = words[1];
  if (is_truth) return;
  s.cluster_class = static_cast<tern::TrackClass>(kind - classes.begin());
  s.things_seen = 1;
}

void set_from_beyond(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  s.beyond_speed = within(words[0], values[0], {0.0, 1000.0}, place);
  s.beyond_size = within(words[0], values[1], {0.0, 1000.0}, place);
}

}  // namespace

void add_detection_setters(Setters& setters) {
  using S = FlightSettings;
  setters["things"] = whole(&S::things, 0.0, 1.0);
  setters["things_seen"] = whole(&S::things_seen, 0.0, 1.0);
  setters["detection_source"] = set_detection_source;
  setters["thing_memory"] = real(&S::thing_memory, 0.0, 1e6);
  setters["detection_hz"] = real(&S::detection_hz, 0.1, 1000.0);
  setters["detection_latency"] = real(&S::detection_latency, 0.0, 10.0);
  setters["detection_error"] = set_detection_error;
  setters["detection_range"] = real(&S::detection_range, 0.0, 1e6);
  setters["detection_misses"] = real(&S::detection_misses, 0.0, 1.0);
  setters["detection_swaps"] = real(&S::detection_swaps, 0.0, 1.0);
  setters["detection_occlusion"] = whole(&S::detection_occlusion, 0.0, 1.0);
  setters["from_beyond"] = set_from_beyond;
  setters["thing_bounds"] = real(&S::thing_bounds, 0.0, 100.0);
}

}  // namespace tern_host
