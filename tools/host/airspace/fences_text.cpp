// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host/airspace/airspace.hpp"
#include "host/fence_record.hpp"
#include "host/number.hpp"
#include "tern/config.hpp"

namespace tern_host {
namespace {

/// Seconds of the flight's clock, to the nanosecond. What is more than 30 years away is cut off there.
std::string seconds(Instant instant, Instant epoch) {
  const Instant most = Instant{1000000000} * kSecond;
  const Instant away = std::clamp(instant / 2 - epoch / 2, -most / 2, most / 2);
  const Instant exactly = away == instant / 2 - epoch / 2 ? instant - epoch : 2 * away;
  char text[40];
  std::snprintf(text, sizeof text, "%s%lld.%09lld", exactly < 0 ? "-" : "",
                static_cast<long long>(std::llabs(exactly) / kSecond),
                static_cast<long long>(std::llabs(exactly) % kSecond));
  return text;
}

std::string record(const FittedFence& fence) {
  std::string line = fence.kind == tern::FenceKind::kKeepIn ? "keepin_halfspaces" : "keepout_halfspaces";
  for (const tern::Halfspace& p : fence.planes) {
    for (const double value : {p.normal.x, p.normal.y, p.normal.z, p.offset}) line += " " + shortest(value);
  }
  return line;
}

/// As the end of a record: a '#' would begin a comment, and `during` with a number after it would be its times.
std::string zone_end(const Zone& zone) {
  std::string name = printable(zone.name, 80);
  std::replace(name.begin(), name.end(), '#', '-');
  if (hides_times(split_words(name, false))) {
    for (std::size_t at = name.find("during"); at != std::string::npos; at = name.find("during")) name[at] = 'D';
  }
  return name.find_first_not_of(' ') == std::string::npos ? "\n" : " zone " + name + "\n";
}

std::string entry_text(const AirspaceEntry& entry, const AirspaceSettings& settings) {
  std::string text = "\n# " + printable(entry.zone.name, 80) + ": " + printable(entry.zone.type, 80) +
                     ", off by at most " + fixed(entry.fit.off, 3) + " m in plan, " + fixed(entry.fit.height_off, 3) +
                     " m in height\n";
  for (const FittedFence& fence : entry.fit.fences) {
    if (entry.spans.empty()) text += record(fence) + zone_end(entry.zone);
    for (const TimeSpan& span : entry.spans) {
      text +=
          record(fence) + " during " + seconds(span.from, *settings.epoch) + " " + seconds(span.until, *settings.epoch);
      text += (settings.clock_error > 0.0 ? " " + shortest(settings.clock_error) : "") + zone_end(entry.zone);
    }
  }
  return text;
}

std::string xyz(const tern::Vec3& p) {
  return fixed(p.x, 3) + " " + fixed(p.y, 3) + " " + fixed(p.z, 3);
}

/// Holds at the ends: a plan begins after the first, and stays where it ends for the last.
std::string hold_text(const LocalPoint& p, bool at_start) {
  if (!(p.dwell > 0.0)) return "";
  const std::string seconds = shortest(p.dwell);
  return at_start ? "# held for " + seconds + " s before: begin that much later (start_time)\n"
                  : "rest_clear " + seconds + "  # held for so long\n";
}

/// The first point is the start and the last the goal.
std::string mission_text(const Airspace& airspace) {
  std::string text;
  const std::size_t count = airspace.points.size();
  if (count > 0) text += "\n# The mission\n";
  for (std::size_t i = 0; i < count; ++i) {
    const LocalPoint& p = airspace.points[i];
    if (i == 0 || (i + 1 == count && count > 1)) {
      text += (i == 0 ? "start " : "goal ") + xyz(p.position) + "\n" + hold_text(p, i == 0);
      continue;
    }
    text += "via " + xyz(p.position);
    if (p.tolerance > 0.0) text += " " + shortest(p.tolerance);
    if (p.dwell > 0.0) text += " dwell " + shortest(p.dwell);
    text += "\n";
  }
  for (const LocalPoint& p : airspace.rally) text += "# rally point " + xyz(p.position) + "\n";
  return text;
}

}  // namespace

std::string fences_text(const Airspace& airspace) {
  const tern::Box& b = airspace.settings.fit.boundary;
  const GeoPosition& origin = airspace.origin;
  std::string text = "# Fences by tern airspace: x east, y north, z up, m\n";
  text += "frame " + shortest(origin.point.latitude) + " " + shortest(origin.point.longitude);
  text += airspace.knows_height ? " " + shortest(origin.height) + "  # degrees, and m above the WGS84 ellipsoid\n"
                                : "  # degrees, at an unknown height\n";
  if (airspace.settings.epoch) text += "epoch " + instant_text(*airspace.settings.epoch) + "  # when the clock is 0\n";
  std::string corners;
  for (const double v : {b.lower.x, b.lower.y, b.lower.z, b.upper.x, b.upper.y, b.upper.z})
    corners += " " + shortest(v);
  text += "boundary" + corners + "\n";
  text += "fences_within" + corners + " " + shortest(airspace.settings.fit.clearance) +
          "  # the boundary, and radius + tracking_margin up to which these are all the fences\n";
  for (const AirspaceEntry& entry : airspace.entries) {
    if (entry.left_out.empty()) text += entry_text(entry, airspace.settings);
  }
  return text + mission_text(airspace);
}

}  // namespace tern_host
