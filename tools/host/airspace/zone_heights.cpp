// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/zone_heights.hpp"

#include <GeographicLib/Geoid.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/airspace/terrain_grid.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

/// The geoid is read at so many places along each side of a box, and slopes by at most this much between them.
constexpr int kSamples = 17;
constexpr double kSteepestGeoid = 5e-4;

constexpr const char* kNoUndulation =
    "heights above mean sea level need a geoid: give --geoid FILE, or --undulation M, by which it is above the "
    "ellipsoid";

/// GeographicLib takes a name and a folder.
std::shared_ptr<const GeographicLib::Geoid> open_geoid(const std::string& file) {
  if (file.empty()) return nullptr;
  const std::size_t slash = file.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "." : file.substr(0, slash);
  std::string name = file.substr(slash == std::string::npos ? 0 : slash + 1);
  if (name.size() < 5 || name.substr(name.size() - 4) != ".pgm") {
    throw std::invalid_argument(file + ": not a geoid of GeographicLib, whose names end in .pgm");
  }
  name.resize(name.size() - 4);
  try {
    return std::make_shared<GeographicLib::Geoid>(name, folder);
  } catch (const std::exception&) {
    throw std::invalid_argument(file + ": cannot be read as a geoid of GeographicLib");
  }
}

/// The box in degrees, with the earth's roundness: the extremes lie on its border, or on the meridian of the origin.
void degrees_of(const LocalFrame& frame, const PlanBox& box, GeoPoint& south_west, GeoPoint& north_east) {
  south_west = {HUGE_VAL, HUGE_VAL};
  north_east = {-HUGE_VAL, -HUGE_VAL};
  const double centre = frame.origin().point.longitude;
  for (int i = 0; i < kSamples; ++i) {
    for (int k = 0; k < kSamples; ++k) {
      const double s = i / (kSamples - 1.0), t = k / (kSamples - 1.0);
      const GeoPoint p = frame.point({box.lower.east + s * (box.upper.east - box.lower.east),
                                      box.lower.north + t * (box.upper.north - box.lower.north)});
      const double longitude = centre + std::remainder(p.longitude - centre, 360.0);
      south_west = {std::min(south_west.latitude, p.latitude), std::min(south_west.longitude, longitude)};
      north_east = {std::max(north_east.latitude, p.latitude), std::max(north_east.longitude, longitude)};
    }
  }
  // Between samples, less than a metre: parallels bend by their length squared over the earth's radius.
  constexpr double kMore = 2e-5;
  south_west = {south_west.latitude - kMore, south_west.longitude - kMore};
  north_east = {north_east.latitude + kMore, north_east.longitude + kMore};
}

GeoPosition with_height(const GeoPosition& origin, double height) {
  return {origin.point, std::isfinite(height) ? height : 0.0};
}

}  // namespace

ZoneHeights::ZoneHeights(const GeoPosition& origin, const HeightSources& sources)
    : sources_(sources),
      geoid_(open_geoid(sources.geoid_file)),
      terrain_(sources.terrain_file.empty() ? nullptr : std::make_shared<TerrainGrid>(sources.terrain_file)),
      frame_(with_height(origin, 0.0)) {
  double height = origin.height;
  if (sources.origin_sea_level) height = *sources.origin_sea_level + undulation_at(origin.point);
  known_ = std::isfinite(height);
  frame_ = LocalFrame(with_height(origin, height));
}

double ZoneHeights::undulation_at(const GeoPoint& point) const {
  if (sources_.undulation) return *sources_.undulation;
  if (geoid_ == nullptr) throw std::invalid_argument(kNoUndulation);
  return (*geoid_)(point.latitude, point.longitude);
}

HeightRange ZoneHeights::undulation(const PlanBox& box) const {
  if (sources_.undulation) return {*sources_.undulation, *sources_.undulation};
  HeightRange range{HUGE_VAL, -HUGE_VAL};
  const double east = (box.upper.east - box.lower.east) / (kSamples - 1);
  const double north = (box.upper.north - box.lower.north) / (kSamples - 1);
  for (int i = 0; i < kSamples; ++i) {
    for (int k = 0; k < kSamples; ++k) {
      const double value = undulation_at(frame_.point({box.lower.east + i * east, box.lower.north + k * north}));
      range = {std::min(range.low, value), std::max(range.high, value)};
    }
  }
  const double between = kSteepestGeoid * 0.5 * std::hypot(east, north);
  return {range.low - between, range.high + between};
}

HeightRange ZoneHeights::ground(const PlanBox& box) const {
  if (terrain_ != nullptr) {
    GeoPoint south_west{}, north_east{};
    degrees_of(frame_, box, south_west, north_east);
    HeightRange range{HUGE_VAL, -HUGE_VAL};
    terrain_->widen(south_west, north_east, range.low, range.high);
    return range;
  }
  if (sources_.ground) return *sources_.ground;
  throw std::invalid_argument(
      "heights above the ground need the ground: give --terrain FILE, or --ground LOW HIGH, between which it is, in "
      "metres above mean sea level");
}

HeightRange ZoneHeights::local(const ZoneHeight& height, const PlanBox& box) const {
  const double m = height.metres, origin = frame_.origin().height;
  if (height.reference == HeightReference::kHome && !known_) return {m, m};
  if (!known_) {
    const std::string home =
        sources_.home ? "; home is " + brief(sources_.home->height) + " m above mean sea level" : "";
    throw std::invalid_argument("the height of the origin is not known: give --height or --height-amsl" + home);
  }
  if (height.reference == HeightReference::kEllipsoid) return {m - origin, m - origin};
  if (height.reference == HeightReference::kHome) {
    if (!sources_.home) throw std::invalid_argument("heights above home need a mission with a home");
    const double home = sources_.home->height + undulation_at(sources_.home->point);
    return {m + home - origin, m + home - origin};
  }
  const HeightRange geoid = undulation(box);
  if (height.reference == HeightReference::kSeaLevel) return {m + geoid.low - origin, m + geoid.high - origin};
  const HeightRange below = ground(box);
  return {m + below.low + geoid.low - origin, m + below.high + geoid.high - origin};
}

std::optional<HeightRange> ZoneHeights::known_ground(const PlanBox& box) const {
  if (!known_ || !knows_sea_level() || (terrain_ == nullptr && !sources_.ground)) return std::nullopt;
  try {
    return ground(box);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // the terrain ends before the box
  }
}

std::optional<double> ZoneHeights::origin_above_sea_level() const {
  if (!known_ || !knows_sea_level()) return std::nullopt;
  return frame_.origin().height - undulation_at(frame_.origin().point);
}

HeightRange ZoneHeights::above_sea_level(const HeightRange& above_ellipsoid, const PlanBox& box) const {
  const HeightRange geoid = undulation(box);
  return {above_ellipsoid.low - geoid.high, above_ellipsoid.high - geoid.low};
}

}  // namespace tern_host
