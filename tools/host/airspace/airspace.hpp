// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// All zones of some files as fences for one flight: what `tern airspace` prints, writes and draws.
#ifndef TERN_HOST_AIRSPACE_AIRSPACE_HPP
#define TERN_HOST_AIRSPACE_AIRSPACE_HPP

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/airspace/zone_fences.hpp"

namespace tern_host {

struct AirspaceSettings {
  FitSettings fit;
  HeightSources heights;
  std::optional<GeoPoint> origin;      ///< none: the home of the first mission
  std::optional<double> height;        ///< of the origin above the ellipsoid, m
  std::optional<Instant> epoch;        ///< when the flight's clock is 0
  double hours = 24.0;                 ///< zones that do not hold in so many hours after the epoch are left out
  double clock_error = 0.0;            ///< s, by which the flight's clock may be off
  DayEvents events;                    ///< when sunrise and the like are
  std::vector<std::string> leave_out;  ///< names of zones
  std::vector<std::string> keep_in;    ///< names of zones that are to be stayed in
  std::function<void(const std::string& what)> note;  ///< hears of what may take seconds, before it does; or empty
};

/// A zone and what became of it.
struct AirspaceEntry {
  Zone zone;
  FittedZone fit;
  std::vector<TimeSpan> spans;  ///< none: always
  std::string left_out;         ///< why it has no fence; empty where it has one
};

/// A point of a mission, in the frame.
struct LocalPoint {
  tern::Vec3 position;
  double tolerance;
  double dwell;
};

struct Airspace {
  GeoPosition origin{};
  bool knows_height = false;  ///< of the origin above the ellipsoid
  AirspaceSettings settings;
  std::vector<AirspaceEntry> entries;
  std::vector<std::string> left_out;  ///< entries of files that are no zones
  std::vector<LocalPoint> points;
  std::vector<LocalPoint> rally;

  int fence_count() const;
  int plane_count() const;
};

/// Throws std::invalid_argument with the zone, its place, the reason and what to do: one zone that cannot be made
/// fences of is enough, since a flight would not know of it.
Airspace make_airspace(const std::vector<AirspaceFile>& files, const AirspaceSettings& settings);

/// Records for a scenario file: fences, and the points of a mission as start, vias and goal.
std::string fences_text(const Airspace& airspace);

/// What there is and what became of it, for people.
std::string airspace_table(const Airspace& airspace);

/// A height with its reference, such as "150 AGL"; `otherwise` where there is none.
std::string height_text(const std::optional<ZoneHeight>& height, const char* otherwise);

/// The boundary and the fences in plan.
std::string airspace_svg(const Airspace& airspace);

/// Text of a file for a terminal: control characters become '?', and more than `most` characters are cut.
std::string printable(const std::string& text, std::size_t most = 40);

}  // namespace tern_host

#endif
