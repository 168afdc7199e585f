// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/intent_text.hpp"

#include <algorithm>
#include <cmath>

#include "host/airspace/airspace.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

std::string place_text(const GeoPoint& point) {
  return fixed(point.latitude, 6) + ", " + fixed(point.longitude, 6);
}

std::string outline_text(const ZoneArea& area) {
  if (area.radius > 0.0) return "circle of " + fixed(area.radius, 2) + " m about " + place_text(area.centre);
  return "polygon of " + std::to_string(area.ring.size()) + " corners from " + place_text(area.ring[0]);
}

std::string height_text(double low, double high) {
  if (std::isinf(low) && std::isinf(high)) return "all heights";
  if (std::isinf(low)) return "up to " + fixed(high, 1) + " m";
  return std::isinf(high) ? "from " + fixed(low, 1) + " m" : fixed(low, 1) + " to " + fixed(high, 1) + " m";
}

std::string name_of(const UtmEntity& entity) {
  std::string name = printable(entity.id);
  if (!entity.manager.empty()) name += " of " + printable(entity.manager);
  return name + " (" + printable(entity.volumes.front().type) + ")";
}

}  // namespace

namespace {

PlanBox box_of(const ZoneArea& area, const LocalFrame& frame) {
  if (area.radius > 0.0) {
    const Plan2 c = frame.plan(area.centre);
    return {{c.east - area.radius, c.north - area.radius}, {c.east + area.radius, c.north + area.radius}};
  }
  PlanBox box{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (const GeoPoint& corner : area.ring) {
    const Plan2 p = frame.plan(corner);
    box.lower = {std::min(box.lower.east, p.east), std::min(box.lower.north, p.north)};
    box.upper = {std::max(box.upper.east, p.east), std::max(box.upper.north, p.north)};
  }
  return box;
}

/// " (415.7 to 439.1 m AMSL)"; empty where there is no geoid.
std::string sea_level_text(const Zone& zone, const ZoneHeights& heights) {
  if (!heights.knows_sea_level()) return "";
  const HeightRange above =
      heights.above_sea_level({zone.lower->metres, zone.upper->metres}, box_of(zone.areas[0], heights.frame()));
  return " (" + height_text(above.low, above.high) + " AMSL)";
}

}  // namespace

std::string volumes_text(const UtmEntity& intent, const ZoneHeights& heights) {
  std::string text;
  for (std::size_t i = 0; i < intent.volumes.size(); ++i) {
    const Zone& zone = intent.volumes[i];
    text += "volume " + std::to_string(i + 1) + ": " + span_text(span_of(zone)) + ", " +
            height_text(zone.lower->metres, zone.upper->metres) + sea_level_text(zone, heights) + ", " +
            outline_text(zone.areas[0]) + "\n";
  }
  return text;
}

std::string conflicts_text(const std::vector<Conflict>& conflicts, const std::vector<UtmEntity>& others) {
  std::string text;
  for (const Conflict& c : conflicts) {
    text += "volume " + std::to_string(c.volume + 1) + " meets volume " + std::to_string(c.other_volume + 1) + " of " +
            name_of(others[c.other]) + ": " + span_text(c.span) + ", " + height_text(c.low, c.high) + ", at " +
            place_text(c.place) + (c.binding ? "; yours gives way\n" : "; theirs gives way\n");
  }
  return text;
}

}  // namespace tern_host
