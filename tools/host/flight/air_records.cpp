// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/air_records.hpp"

#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

/// Without an angle, the seed decides where to.
void set_wind(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = numbers(words, place);
  if (values.empty() || values.size() > 2) throw_count(words[0], "one or two numbers", values.size(), place);
  s.air.wind = within(words[0], values[0], {0.0, 100.0}, place);
  s.air.has_angle = values.size() == 2;
  s.air.angle = values.size() == 2 ? yaw_angle("the angle of wind", values[1], place) : 0.0;
}

void set_gusts(FlightSettings& s, const Words& words, const Place& place) {
  s.air.gusts = number_within(words, {0.0, 100.0}, place);
  s.air.has_gusts = true;
}

void set_drag(FlightSettings& s, const Words& words, const Place& place) {
  s.air.drag = number_within(words, {0.0, 10.0}, place);
}

}  // namespace

void add_air_setters(Setters& setters) {
  setters["wind"] = set_wind;
  setters["gusts"] = set_gusts;
  setters["drag"] = set_drag;
}

}  // namespace tern_host
