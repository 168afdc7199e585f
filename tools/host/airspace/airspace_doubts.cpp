// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/airspace_doubts.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

/// A home that is no farther from the origin is at the same place; heights of one place differ by no more. Metres.
constexpr double kSamePlace = 5.0, kSameHeight = 3.0;

/// What of the boundary's plan is under the zone, as a box; its lower corner is beyond its upper if nothing is.
PlanBox plan_of(const Zone& zone, const LocalFrame& frame, const tern::Box& boundary) {
  PlanBox box{{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  const auto widen = [&](const GeoPoint& point, double by) {
    const Plan2 p = frame.plan(point);
    box.lower = {std::min(box.lower.east, p.east - by), std::min(box.lower.north, p.north - by)};
    box.upper = {std::max(box.upper.east, p.east + by), std::max(box.upper.north, p.north + by)};
  };
  for (const ZoneArea& area : zone.areas) {
    if (area.radius > 0.0) widen(area.centre, area.radius);
    for (const GeoPoint& corner : area.ring) widen(corner, 0.0);
  }
  return {{std::max(box.lower.east, boundary.lower.x), std::max(box.lower.north, boundary.lower.y)},
          {std::min(box.upper.east, boundary.upper.x), std::min(box.upper.north, boundary.upper.y)}};
}

std::string range_text(double low, double high) {
  const std::string from = fixed(low, 1), to = fixed(high, 1);
  return from == to ? from : from + " to " + to;
}

bool is_within(const tern::Vec3& p, const tern::Box& box) {
  return p.x >= box.lower.x && p.x <= box.upper.x && p.y >= box.lower.y && p.y <= box.upper.y && p.z >= box.lower.z &&
         p.z <= box.upper.z;
}

}  // namespace

std::string doubt_of_ground(const HeightSources& sources, const ZoneHeights& heights) {
  const auto origin = heights.origin_above_sea_level();
  if (!sources.ground || !origin) return "";
  const HeightRange& ground = *sources.ground;
  if (*origin >= ground.low && *origin <= ground.high) return "";
  return "the origin is " + fixed(*origin, 1) + " m above mean sea level, but the ground from " + brief(ground.low) +
         " to " + brief(ground.high) + " m: are --ground and the origin's height right?";
}

std::string doubt_of_home(const HeightSources& sources, const ZoneHeights& heights) {
  const auto origin = heights.origin_above_sea_level();
  if (!sources.home || !origin) return "";
  const Plan2 at = heights.frame().plan(sources.home->point);
  const bool same_place = std::hypot(at.east, at.north) <= kSamePlace;
  if (!same_place || std::fabs(*origin - sources.home->height) <= kSameHeight) return "";
  return "the mission's home is " + fixed(sources.home->height, 1) +
         " m above mean sea level, but the origin, at the same place, " + fixed(*origin, 1) +
         " m: are the origin's height and the geoid or undulation right?";
}

std::string doubt_of_heights(Zone& zone, const ZoneHeights& heights, const tern::Box& boundary) {
  if (zone.kind != ZoneKind::kKeepOut || !zone.upper) return "";
  const PlanBox box = plan_of(zone, heights.frame(), boundary);
  if (!(box.lower.east <= box.upper.east && box.lower.north <= box.upper.north)) return "";
  const auto ground = heights.known_ground(box);
  if (!ground) return "";
  const double low = heights.local({ground->low, HeightReference::kSeaLevel}, box).low;
  const double high = heights.local({ground->high, HeightReference::kSeaLevel}, box).high;
  if (!(heights.local(*zone.upper, box).high <= low)) return "";
  const double origin = heights.frame().origin().height;
  std::string text = printable(zone.name) + ", " + zone.place + ": its top, " + height_text(zone.upper, "") +
                     ", is not above the ground, " + range_text(ground->low, ground->high) + " AMSL or " +
                     range_text(low + origin, high + origin) + " WGS84: ";
  if (!zone.empty_is_all || !zone.lower || zone.lower->reference != HeightReference::kGround) {
    return text + "are its heights right?";
  }
  zone.notes.push_back("its top is not above the ground: taken for all heights");
  zone.lower.reset();
  zone.upper.reset();
  return text + "taken for all heights";
}

std::string doubt_of_points(const std::vector<LocalPoint>& points, const tern::Box& boundary) {
  std::string first;
  int outside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const tern::Vec3& p = points[i].position;
    if (is_within(p, boundary) || ++outside > 1) continue;
    first = "point " + std::to_string(i + 1) + " of the mission, at " + fixed(p.x, 1) + ", " + fixed(p.y, 1) + ", " +
            fixed(p.z, 1) + ", is outside the boundary";
  }
  return outside > 1 ? first + " (the first of " + std::to_string(outside) + ")" : first;
}

}  // namespace tern_host
