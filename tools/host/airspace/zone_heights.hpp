// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights above whatever a file refers to as heights of a local frame: exact, or between two bounds.
#ifndef TERN_HOST_AIRSPACE_ZONE_HEIGHTS_HPP
#define TERN_HOST_AIRSPACE_ZONE_HEIGHTS_HPP

#include <memory>
#include <optional>
#include <string>

#include "host/airspace/local_frame.hpp"
#include "host/airspace/zone.hpp"

namespace GeographicLib {
class Geoid;
}

namespace tern_host {

class TerrainGrid;

/// Lowest and highest, metres.
struct HeightRange {
  double low;
  double high;
};

/// A part of the plan of a frame, metres.
struct PlanBox {
  Plan2 lower;
  Plan2 upper;
};

/// What is known of the geoid and the ground, as the caller states or files say it.
struct HeightSources {
  std::optional<double> undulation;        ///< of the geoid above the ellipsoid, metres: the same all over
  std::string geoid_file;                  ///< of GeographicLib, such as egm96-5.pgm; empty: none
  std::optional<HeightRange> ground;       ///< above mean sea level: no ground is lower or higher
  std::string terrain_file;                ///< of SRTM, such as N47E008.hgt; empty: none
  std::optional<double> origin_sea_level;  ///< height of the origin above mean sea level, if that is how it is given
  std::optional<GeoPosition> home;         ///< of a mission; its height is above mean sea level
};

/// Converts heights. Throws std::invalid_argument with the reason and what to do where a source is missing or bad.
class ZoneHeights {
 public:
  /// `origin`: its height counts only if sources.origin_sea_level is not given; nothing is known of it if it is NaN.
  /// Then only heights above home are read, and home is at 0.
  ZoneHeights(const GeoPosition& origin, const HeightSources& sources);

  /// The frame, with the origin's height as far as it is known, else 0.
  const LocalFrame& frame() const { return frame_; }
  bool knows_origin() const { return known_; }

  /// Where, in the frame, a surface `height` above its reference is within the box.
  HeightRange local(const ZoneHeight& height, const PlanBox& box) const;

  /// Lowest and highest ground within the box above mean sea level; none if it is not known, or not where it is.
  std::optional<HeightRange> known_ground(const PlanBox& box) const;
  /// Height of the origin above mean sea level; none if it is not known.
  std::optional<double> origin_above_sea_level() const;

  /// True if heights can be given above mean sea level, too.
  bool knows_sea_level() const { return sources_.undulation.has_value() || geoid_ != nullptr; }
  /// Heights above the ellipsoid as heights above mean sea level, which hold them wherever in the box they are.
  HeightRange above_sea_level(const HeightRange& above_ellipsoid, const PlanBox& box) const;

 private:
  HeightRange undulation(const PlanBox& box) const;
  HeightRange ground(const PlanBox& box) const;
  double undulation_at(const GeoPoint& point) const;

  HeightSources sources_;
  std::shared_ptr<const GeographicLib::Geoid> geoid_;
  std::shared_ptr<const TerrainGrid> terrain_;
  bool known_ = false;
  LocalFrame frame_;
};

}  // namespace tern_host

#endif
