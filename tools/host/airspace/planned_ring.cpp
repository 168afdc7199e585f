// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/planned_ring.hpp"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tern_host {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadian = kPi / 180.0;
/// The ellipsoid's largest radius of curvature, metres: at a pole.
constexpr double kMostRadius = 6399594.0;
/// Beyond, the frame stretches lengths by more than an eighth.
constexpr double kFarthest = 5e6;
/// Longer parts of edges are always cut.
constexpr double kLongestPart = 50e3;
constexpr std::size_t kMostParts = 20000;
constexpr double kMostRadiusOfCircle = 500e3;

double length(const Plan2& p) {
  return std::hypot(p.east, p.north);
}

/// A bound on how far the line straight in degrees bends off the geodesic, for its length, metres. Its curvature is at
/// most 1.09 tan(latitude) / R on a sphere; the ellipsoid adds less than 1 %.
double bend_of_degrees(double span, double steepest_latitude) {
  return span * span / 8.0 * 1.2 * std::tan(steepest_latitude * kRadian) / kLeastRadius;
}

/// The same for a geodesic, which the frame bends: its curvature is less than distance / R^2.
double bend_of_frame(double span, double farthest) {
  return span * span / 8.0 * farthest / (kLeastRadius * kLeastRadius);
}

/// An edge between two corners, by a part t of it from 0 to 1.
class RingEdge {
 public:
  RingEdge(const GeoPoint& from, const GeoPoint& to, EdgeRule rule)
      : from_(from), degrees_(rule == EdgeRule::kDegrees) {
    north_ = to.latitude - from.latitude;
    east_ = std::remainder(to.longitude - from.longitude, 360.0);
    steepest_ = std::max(std::fabs(from.latitude), std::fabs(to.latitude));
    const double s = line_length(from, to);
    const bool crosses = (from.latitude < 0.0) != (to.latitude < 0.0);
    const double widest =
        crosses ? 1.0 : std::cos(std::min(std::fabs(from.latitude), std::fabs(to.latitude)) * kRadian);
    length_ = degrees_ ? kMostRadius * kRadian * std::hypot(north_, widest * east_) : s;
  }

  double length() const { return length_; }
  double steepest() const { return steepest_; }
  GeoPoint at(double t) const {
    if (degrees_) return {from_.latitude + t * north_, from_.longitude + t * east_};
    GeoPoint point{};
    line_.Position(t * line_.Distance(), point.latitude, point.longitude);
    return point;
  }

 private:
  double line_length(const GeoPoint& from, const GeoPoint& to) {
    line_ = GeographicLib::Geodesic::WGS84().InverseLine(from.latitude, from.longitude, to.latitude, to.longitude);
    return line_.Distance();
  }

  GeoPoint from_;
  bool degrees_;
  double north_ = 0.0, east_ = 0.0, steepest_ = 0.0, length_ = 0.0;
  GeographicLib::GeodesicLine line_;
};

class RingPlanner {
 public:
  RingPlanner(const LocalFrame& frame, EdgeRule rule, double tolerance, const Window& window)
      : frame_(frame), rule_(rule), tolerance_(tolerance), reach_(1.5 * window.reach) {}

  void add(const GeoPoint& from, const GeoPoint& to) {
    const RingEdge edge(from, to, rule_);
    const Plan2 first = frame_.plan(from), last = frame_.plan(to);
    between_ = rule_ == EdgeRule::kEither ? bend_of_degrees(edge.length(), edge.steepest()) : 0.0;
    // Halves still to be looked at, the nearest to the edge's beginning on top.
    std::vector<Part> parts{{0.0, 1.0, first, last}};
    while (!parts.empty()) {
      const Part part = parts.back();
      parts.pop_back();
      if (is_straight(part, edge)) {
        points_.push_back(part.first);
        if (points_.size() > kMostParts) throw std::invalid_argument("its edges have more than 20000 parts");
        continue;
      }
      const double middle = 0.5 * (part.from + part.to);
      const Plan2 there = frame_.plan(edge.at(middle));
      parts.push_back({middle, part.to, there, part.last});
      parts.push_back({part.from, middle, part.first, there});
    }
  }

  double slack() const { return slack_ + straightness_; }
  std::vector<Plan2> take() { return std::move(points_); }

 private:
  struct Part {
    double from, to;
    Plan2 first, last;
  };

  /// The part lies in two discs about its ends, which do not reach the window, nor does what is between the two rules:
  /// neither it nor any other line in them between the ends has the window on its other side.
  bool is_far(const Plan2& first, const Plan2& last, double span) const {
    return std::min(tern_host::length(first), tern_host::length(last)) - 1.5 * span > reach_ + 1.5 * between_;
  }

  bool is_straight(const Part& part, const RingEdge& edge) {
    const double span = edge.length() * (part.to - part.from);
    if (is_far(part.first, part.last, span)) return true;
    const double farthest = std::max(tern_host::length(part.first), tern_host::length(part.last)) + span;
    if (span > kLongestPart) return false;
    double bend = bend_of_frame(span, farthest);
    if (rule_ == EdgeRule::kDegrees) bend += bend_of_degrees(span, edge.steepest());
    if (bend > tolerance_) return false;
    straightness_ = std::max(straightness_, bend);
    slack_ = std::max(slack_, between_);
    return true;
  }

  const LocalFrame& frame_;
  const EdgeRule rule_;
  const double tolerance_;
  const double reach_;
  double between_ = 0.0;       // how far apart the two rules put the current edge
  double slack_ = 0.0;         // the largest between_ of the edges near the window
  double straightness_ = 0.0;  // of the parts
  std::vector<Plan2> points_;
};

/// The part of a closed outline with sign * coordinate <= most, by Sutherland and Hodgman: what it winds around there
/// stays.
std::vector<Plan2> clipped(const std::vector<Plan2>& ring, double Plan2::*axis, double sign, double most) {
  std::vector<Plan2> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Plan2& a = ring[i];
    const Plan2& b = ring[(i + 1) % ring.size()];
    const double past_a = sign * (a.*axis) - most, past_b = sign * (b.*axis) - most;
    if (past_a <= 0.0) out.push_back(a);
    if ((past_a <= 0.0) == (past_b <= 0.0)) continue;
    const double t = past_a / (past_a - past_b);
    Plan2 cut{a.east + t * (b.east - a.east), a.north + t * (b.north - a.north)};
    cut.*axis = sign * most;
    out.push_back(cut);
  }
  return out;
}

/// Longitudes go the shorter way round, which must be clear.
void check_longitudes(const std::vector<GeoPoint>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double apart = std::fabs(ring[(i + 1) % ring.size()].longitude - ring[i].longitude);
    if (apart >= 360.0) throw std::invalid_argument("an edge goes all around the earth: add corners to it");
    if (std::fabs(std::remainder(apart, 360.0)) > 179.0) {
      throw std::invalid_argument("an edge goes half around the earth: add corners to it");
    }
  }
}

/// True if the ring, straight in degrees, goes around the point.
bool goes_around(const std::vector<GeoPoint>& ring, const GeoPoint& point) {
  bool around = false;
  double x = std::remainder(ring[0].longitude - point.longitude, 360.0);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GeoPoint& a = ring[i];
    const GeoPoint& b = ring[(i + 1) % ring.size()];
    const double next = x + std::remainder(b.longitude - a.longitude, 360.0);
    const double above_a = a.latitude - point.latitude, above_b = b.latitude - point.latitude;
    if ((above_a > 0.0) != (above_b > 0.0) && x + (next - x) * above_a / (above_a - above_b) > 0.0) around = !around;
    x = next;
  }
  return around;
}

/// True if the ring is nowhere near. Throws where the frame does not say what it goes around.
bool is_elsewhere(const LocalFrame& frame, const std::vector<GeoPoint>& ring) {
  double nearest = HUGE_VAL, farthest = 0.0;
  for (const GeoPoint& corner : ring) {
    const double distance = length(frame.plan(corner));
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  if (nearest > kFarthest && !goes_around(ring, frame.origin().point)) return true;
  if (farthest > kFarthest) throw std::invalid_argument("it reaches to more than 5000 km from here");
  return false;
}

/// In steps, within the window.
std::vector<Corner> corners_of(std::vector<Plan2> ring, const Window& window) {
  for (const double sign : {1.0, -1.0}) {
    ring = clipped(ring, &Plan2::east, sign, window.reach);
    ring = clipped(ring, &Plan2::north, sign, window.reach);
  }
  std::vector<Corner> corners;
  for (const Plan2& p : ring) corners.push_back({std::llround(p.east / kStep), std::llround(p.north / kStep)});
  return corners;
}

}  // namespace

PlannedRing planned_ring(const LocalFrame& frame, const std::vector<GeoPoint>& ring, EdgeRule rule, double tolerance,
                         const Window& window) {
  check_longitudes(ring);
  if (is_elsewhere(frame, ring)) return {};
  RingPlanner planner(frame, rule, tolerance, window);
  for (std::size_t i = 0; i < ring.size(); ++i) planner.add(ring[i], ring[(i + 1) % ring.size()]);
  return {corners_of(planner.take(), window), planner.slack()};
}

PlannedRing planned_circle(const LocalFrame& frame, const GeoPoint& centre, double radius, bool inside,
                           double looseness, const Window& window, double& off) {
  off = 0.0;
  if (!(radius <= kMostRadiusOfCircle)) throw std::invalid_argument("a circle of more than 500 km is not read");
  const Plan2 middle = frame.plan(centre);
  const double distance = length(middle);
  if (distance > kFarthest || distance - 1.5 * radius > 1.5 * window.reach) return {};
  // The frame stretches lengths across the direction to the origin.
  const double angle = (distance + radius) / kLeastRadius;
  const double slack = radius * (angle / std::sin(angle) - 1.0);
  const double ratio = radius / (radius + looseness);
  const int sides = std::clamp(static_cast<int>(std::ceil(kPi / std::acos(ratio))), 8, 720);
  const double outer = inside ? radius : radius / std::cos(kPi / sides);
  off = inside ? radius * (1.0 - std::cos(kPi / sides)) : outer - radius;
  std::vector<Plan2> ring;
  for (int i = 0; i < sides; ++i) {
    const double turn = 2.0 * kPi * i / sides;
    ring.push_back({middle.east + outer * std::cos(turn), middle.north + outer * std::sin(turn)});
  }
  return {corners_of(ring, window), slack};
}

}  // namespace tern_host
