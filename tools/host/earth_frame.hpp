// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where on the earth a scenario is: `frame` and `epoch`, records of scenarios and of flight worlds. Plan files carry
// both on.
#ifndef TERN_HOST_EARTH_FRAME_HPP
#define TERN_HOST_EARTH_FRAME_HPP

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "host/instant.hpp"
#include "host/text_records.hpp"

namespace tern_host {

/// Degrees on the WGS84 ellipsoid.
struct EarthOrigin {
  double latitude;
  double longitude;
};

/// x is east, y is north and z is up about the origin (docs/airspace.md). All of it may be unknown.
struct EarthFrame {
  std::optional<EarthOrigin> origin;
  std::optional<double> height;  ///< of the origin above the WGS84 ellipsoid, m
  std::string epoch;             ///< when the clock is 0: parse_instant() reads it. Empty: unknown

  bool is_known() const { return origin || !epoch.empty(); }
};

/// True if both are the same, but for less than a tenth of a millimetre.
bool are_same(const EarthOrigin& a, const EarthOrigin& b);
bool are_same_heights(double a, double b);

/// Latitude, longitude, for messages.
std::string origin_text(const EarthOrigin& origin);

bool is_earth_record(const std::string& key);

/// Reads a record for which is_earth_record() holds. Throws RecordError; also where it is there already.
void add_earth_record(const Words& words, const Place& place, EarthFrame& frame);

/// As plan files have it: `latitude`, `longitude`, `height` and `epoch`, those that are known.
nlohmann::ordered_json earth_json(const EarthFrame& frame);

}  // namespace tern_host

#endif
