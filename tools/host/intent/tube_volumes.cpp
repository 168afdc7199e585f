// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/tube_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/airspace/convex_plan.hpp"
#include "host/intent/outer_outline.hpp"
#include "host/intent/path_parts.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

/// Outlines go around a regular polygon of so many sides about each control point.
constexpr int kSides = 16;
constexpr double kPi = 3.14159265358979323846;
/// What rounding of corners to steps and of degrees to doubles amounts to at most, metres.
constexpr double kGuard = 4e-6;
/// Radii and heights are written in whole hundredths and thousandths of a metre.
constexpr double kRadiusParts = 100.0, kHeightParts = 1000.0;
constexpr double kMillisecond = 1e-3;
/// Outlines have fewer corners, at this part of the looseness.
constexpr double kOutlineShare = 0.1;

double farthest(const TimedPath& path) {
  double distance = 0.0;
  for (const PathPiece& piece : path.pieces) {
    for (const tern::Vec3& p : piece.points) distance = std::max(distance, std::hypot(p.x, p.y));
  }
  return distance;
}

/// Makes a zone of each part of a way.
class TubeVolumes {
 public:
  TubeVolumes(const TimedPath& path, const LocalFrame& frame, const TubeSettings& settings)
      : path_(path), frame_(frame), settings_(settings) {
    const double reach = farthest(path) + path.radius;
    if (!(reach <= largest_radius())) {
      throw std::invalid_argument("the plan is " + brief(std::ceil(reach)) +
                                  " m from the origin, where lengths are more than " + brief(kMostLengthError) +
                                  " m off: move the origin, or divide the flight");
    }
    // Lengths are off by as much, and so is the shortest line between two corners from the straight line of the frame.
    grown_ = path.radius + 2.0 * length_error(reach) + kGuard;
    beyond_ = grown_ / std::cos(kPi / kSides) - path.radius + 1.0 / kRadiusParts + kOutlineShare * settings.looseness;
    const double least = (beyond_ - kOutlineShare * settings.looseness + 2.0 / kHeightParts) / (1.0 - kOutlineShare);
    if (!(settings.looseness > 1.1 * least && settings.looseness <= 10000.0)) {
      throw std::invalid_argument("the looseness must be more than " + brief(std::ceil(1100.0 * least) / 1000.0) +
                                  " m, which outlines about the plan's tube take, and at most 10000 m");
    }
    if (!(settings.longest >= 1.0 && settings.longest <= 86400.0)) {
      throw std::invalid_argument("the longest volume must last 1 to 86400 s");
    }
    if (!(settings.clock_error >= 0.0 && settings.clock_error <= 3600.0)) {
      throw std::invalid_argument("the clock's error must be 0 to 3600 s");
    }
  }

  std::vector<Zone> run() const {
    const double room = settings_.looseness - beyond_;
    const PartLimits limits{settings_.longest, room, room, settings_.looseness - 2.0 / kHeightParts};
    const std::vector<PathPiece> pieces = halved(path_.pieces, limits);
    std::vector<Zone> zones;
    for (const PathPart& part : fewest_parts(pieces, limits)) {
      zones.push_back(volume({pieces.data() + part.first, pieces.data() + part.last}, part.column));
      zones.back().place = path_.name + ", volume " + std::to_string(zones.size());
    }
    return zones;
  }

 private:
  struct Pieces {
    const PathPiece* first;
    const PathPiece* last;
    const PathPiece* begin() const { return first; }
    const PathPiece* end() const { return last; }
  };

  Zone volume(const Pieces& pieces, bool column) const {
    Zone zone;
    zone.edges = EdgeRule::kGeodesic;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const PathPiece& piece : pieces) {
      for (const tern::Vec3& p : piece.points) {
        low = std::min(low, p.z);
        high = std::max(high, p.z);
      }
    }
    const double up = frame_.origin().height, by = path_.radius + kGuard;
    zone.lower = {std::floor((low + up - by) * kHeightParts) / kHeightParts, HeightReference::kEllipsoid};
    zone.upper = {std::ceil((high + up + by) * kHeightParts) / kHeightParts, HeightReference::kEllipsoid};
    zone.areas.push_back(column ? circle(pieces) : polygon(pieces));
    const double from = pieces.first->begin - settings_.clock_error;
    const double until = (pieces.last - 1)->end + settings_.clock_error;
    zone.times.push_back(
        {instant(std::floor(from / kMillisecond - 1e-6)), instant(std::ceil(until / kMillisecond + 1e-6)), {}});
    return zone;
  }

  Instant instant(double milliseconds) const {
    return settings_.epoch + static_cast<Instant>(milliseconds) * (kSecond / 1000);
  }

  ZoneArea circle(const Pieces& pieces) const {
    tern::Vec3 lower = pieces.first->points[0], upper = lower;
    for (const PathPiece& piece : pieces) {
      for (const tern::Vec3& p : piece.points) {
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), 0.0};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), 0.0};
      }
    }
    const Plan2 centre{0.5 * (lower.x + upper.x), 0.5 * (lower.y + upper.y)};
    double away = 0.0;
    for (const PathPiece& piece : pieces) {
      for (const tern::Vec3& p : piece.points) away = std::max(away, std::hypot(p.x - centre.east, p.y - centre.north));
    }
    ZoneArea area;
    area.centre = frame_.point(centre);
    area.radius = std::ceil((away + grown_) * kRadiusParts) / kRadiusParts;
    return area;
  }

  ZoneArea polygon(const Pieces& pieces) const {
    const double corner = grown_ / std::cos(kPi / kSides) / kStep;
    std::vector<Corner> corners;
    for (const PathPiece& piece : pieces) {
      for (const tern::Vec3& p : piece.points) {
        for (int k = 0; k < kSides; ++k) {
          const double angle = 2.0 * kPi * k / kSides;
          corners.push_back({static_cast<std::int64_t>(std::llround(p.x / kStep + corner * std::cos(angle))),
                             static_cast<std::int64_t>(std::llround(p.y / kStep + corner * std::sin(angle)))});
        }
      }
    }
    PlanPolygon outline;
    for (const Corner& c : hull_of(std::move(corners))) {
      outline.push_back({static_cast<double>(c.x) * kStep, static_cast<double>(c.y) * kStep});
    }
    ZoneArea area;
    for (const ConvexPiece::Vertex& v : outer_outline(outline, 3, kOutlineShare * settings_.looseness)) {
      area.ring.push_back(frame_.point({v.x, v.y}));
    }
    return area;
  }

  const TimedPath& path_;
  const LocalFrame& frame_;
  const TubeSettings& settings_;
  double grown_ = 0.0;   // the tube's radius, and what the frame and rounding may take
  double beyond_ = 0.0;  // how far an outline's corners are beyond the tube
};

}  // namespace

std::vector<Zone> tube_volumes(const TimedPath& path, const LocalFrame& frame, const TubeSettings& settings) {
  return TubeVolumes(path, frame, settings).run();
}

}  // namespace tern_host
