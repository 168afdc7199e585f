// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random zones as fences, beside an even-odd count in degrees or, for geodesics, in the gnomonic projection about the
// point that is asked for: neither knows of the frame, of pieces and of half-spaces.
#include "host/airspace/zone_fences.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Gnomonic.hpp>
#include <algorithm>
#include <cmath>

#include "airspace/zone_case.hpp"
#include "support/random.hpp"

namespace {

using tern_host::EdgeRule;
using tern_host::Zone;
using namespace tern_test;

using Ring = std::vector<GeoPoint>;

bool crosses(double ax, double ay, double bx, double by) {
  // A ray from 0 in the direction +x.
  return (ay > 0.0) != (by > 0.0) && ax + (bx - ax) * ay / (ay - by) > 0.0;
}

bool inside_in_degrees(const Ring& ring, const GeoPoint& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GeoPoint& a = ring[i];
    const GeoPoint& b = ring[(i + 1) % ring.size()];
    const double ax = std::remainder(a.longitude - p.longitude, 360.0),
                 bx = ax + std::remainder(b.longitude - a.longitude, 360.0);
    if (crosses(ax, a.latitude - p.latitude, bx, b.latitude - p.latitude)) inside = !inside;
  }
  return inside;
}

bool inside_by_geodesics(const Ring& ring, const GeoPoint& p) {
  const GeographicLib::Gnomonic about(GeographicLib::Geodesic::WGS84());
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GeoPoint& a = ring[i];
    const GeoPoint& b = ring[(i + 1) % ring.size()];
    double ax = 0.0, ay = 0.0, bx = 0.0, by = 0.0;
    about.Forward(p.latitude, p.longitude, a.latitude, a.longitude, ax, ay);
    about.Forward(p.latitude, p.longitude, b.latitude, b.longitude, bx, by);
    if (crosses(ax, ay, bx, by)) inside = !inside;
  }
  return inside;
}

bool inside_area(const ZoneArea& area, EdgeRule rule, const GeoPoint& p) {
  const auto inside = [&](const Ring& ring) {
    return rule == EdgeRule::kDegrees ? inside_in_degrees(ring, p) : inside_by_geodesics(ring, p);
  };
  return inside(area.ring) && std::none_of(area.holes.begin(), area.holes.end(), inside);
}

/// Distance in plan from a point to an outline, whose edges are taken apart in degrees.
double distance_to(const LocalFrame& frame, const Ring& ring, const Plan2& p) {
  constexpr int kParts = 64;
  double least = INFINITY;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const GeoPoint& a = ring[i];
    const GeoPoint& b = ring[(i + 1) % ring.size()];
    const double east = std::remainder(b.longitude - a.longitude, 360.0);
    Plan2 from = frame.plan(a);
    for (int k = 1; k <= kParts; ++k) {
      const double t = static_cast<double>(k) / kParts;
      const Plan2 to = frame.plan({a.latitude + t * (b.latitude - a.latitude), a.longitude + t * east});
      const double dx = to.east - from.east, dy = to.north - from.north, square = dx * dx + dy * dy;
      const double along = square > 0.0 ? ((p.east - from.east) * dx + (p.north - from.north) * dy) / square : 0.0;
      const double s = std::clamp(along, 0.0, 1.0);
      least = std::min(least, std::hypot(p.east - from.east - s * dx, p.north - from.north - s * dy));
      from = to;
    }
  }
  return least;
}

double distance_to(const LocalFrame& frame, const ZoneArea& area, const Plan2& p) {
  double least = distance_to(frame, area.ring, p);
  for (const Ring& hole : area.holes) least = std::min(least, distance_to(frame, hole, p));
  return least;
}

/// A star-shaped ring about a place in the frame, either way round.
Ring star_ring(Random& random, const LocalFrame& frame, const Plan2& middle, double least, double most) {
  Ring ring;
  const int corners = random.integer(4, 16);
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + 0.9 * random.unit()) * 6.283185307179586 / corners, r = random.real(least, most);
    ring.push_back(frame.point({middle.east + r * std::cos(angle), middle.north + r * std::sin(angle)}));
  }
  if (random.chance(0.5)) std::reverse(ring.begin(), ring.end());
  return ring;
}

ZoneCase random_case(Random& random, ZoneKind kind) {
  const double longitude = random.chance(0.3) ? 180.0 - random.real(0.0, 0.02) : random.real(-180.0, 180.0);
  const tern_host::GeoPosition origin{{random.real(-78.0, 78.0), longitude}, 0.0};
  ZoneCase c{LocalFrame(origin), ZoneHeights(origin, {}), {}, {}};
  const double half = random.real(500.0, 7000.0);
  c.settings.boundary = {{-half, -half, 0.0}, {half, half, 100.0}};
  c.settings.looseness = random.chance(0.5) ? 1.0 : random.real(0.002, 20.0);
  c.zone.kind = kind;
  const EdgeRule rules[] = {EdgeRule::kDegrees, EdgeRule::kGeodesic, EdgeRule::kEither};
  c.zone.edges = rules[random.integer(0, 2)];
  const Plan2 middle{random.real(-0.7, 0.7) * half, random.real(-0.7, 0.7) * half};
  const double most = c.zone.edges == EdgeRule::kEither ? 2.0 : 30.0;
  const double size = half * (random.chance(0.2) ? random.real(1.0, most) : random.real(0.05, 1.0));
  ZoneArea area;
  area.ring = star_ring(random, c.frame, middle, (random.chance(0.3) ? 0.95 : 0.4) * size, size);
  if (size < half && random.chance(0.4))
    area.holes.push_back(star_ring(random, c.frame, middle, 0.1 * size, 0.35 * size));
  c.zone.areas.push_back(area);
  return c;
}

Plan2 random_place(Random& random, const ZoneCase& c) {
  const double half = c.settings.boundary.upper.x;
  const Plan2 anywhere{random.real(-half, half), random.real(-half, half)};
  if (random.chance(0.5)) return anywhere;
  // Beside a corner or an edge.
  const Ring& ring = c.zone.areas[0].ring;
  const std::size_t i = static_cast<std::size_t>(random.integer(0, static_cast<int>(ring.size()) - 1));
  const Plan2 a = c.frame.plan(ring[i]), b = c.frame.plan(ring[(i + 1) % ring.size()]);
  const double t = random.chance(0.5) ? 0.0 : random.unit(), near = 3.0 * c.settings.looseness;
  const Plan2 p{a.east + t * (b.east - a.east) + random.real(-near, near),
                a.north + t * (b.north - a.north) + random.real(-near, near)};
  return std::max(std::fabs(p.east), std::fabs(p.north)) < half ? p : anywhere;
}

TEST(ZoneFences, KeepOutsCoverTheirZonesAndLittleMore) {
  Random random(11);
  int inside = 0, near = 0;
  for (int i = 0; i < tern_test::scaled(400); ++i) {
    const ZoneCase c = random_case(random, ZoneKind::kKeepOut);
    const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
    for (int k = 0; k < 100; ++k) {
      const Plan2 p = random_place(random, c);
      const bool in = inside_area(c.zone.areas[0], c.zone.edges, c.frame.point(p));
      const bool closed = !allowed(fitted, {p.east, p.north, 50.0});
      ASSERT_TRUE(closed || !in) << "case " << i << ": open at " << p.east << " " << p.north;
      inside += in;
      if (in || !closed) continue;
      ++near;
      // Edges of the reference are in degrees: beside geodesics, it is off by what is between the two.
      const double bend = c.zone.edges == EdgeRule::kGeodesic ? c.settings.boundary.upper.x * 0.2 : 0.0;
      ASSERT_LE(distance_to(c.frame, c.zone.areas[0], p), fitted.off + 1e-3 + bend) << "case " << i;
    }
  }
  EXPECT_GT(inside, tern_test::scaled(400) * 5);
  EXPECT_GT(near, 0);
}

TEST(ZoneFences, KeepInsAreWithinTheirZonesAndLittleLess) {
  Random random(12);
  int open = 0;
  for (int i = 0; i < tern_test::scaled(400); ++i) {
    ZoneCase c = random_case(random, ZoneKind::kKeepIn);
    if (i % 2 == 1) c.zone.times.push_back({});  // keep-outs of all around it
    const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
    for (int k = 0; k < 100; ++k) {
      const Plan2 p = random_place(random, c);
      const bool in = inside_area(c.zone.areas[0], c.zone.edges, c.frame.point(p));
      const bool may = allowed(fitted, {p.east, p.north, 50.0});
      ASSERT_TRUE(in || !may) << "case " << i << ": open at " << p.east << " " << p.north;
      open += may;
      if (may || !in || c.zone.edges == EdgeRule::kGeodesic) continue;
      ASSERT_LE(distance_to(c.frame, c.zone.areas[0], p), fitted.off + 1e-3) << "case " << i;
    }
  }
  EXPECT_GT(open, tern_test::scaled(400) * 5);
}

TEST(ZoneFences, ScribblesAreCovered) {
  Random random(13);
  for (int i = 0; i < tern_test::scaled(300); ++i) {
    ZoneCase c = random_case(random, ZoneKind::kKeepOut);
    const double half = c.settings.boundary.upper.x;
    Ring& ring = c.zone.areas[0].ring;
    ring.clear();
    for (int k = random.integer(3, 12); k > 0; --k)
      ring.push_back(c.frame.point({random.real(-half, half), random.real(-half, half)}));
    c.zone.areas[0].holes.clear();
    const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
    for (int k = 0; k < 100; ++k) {
      const Plan2 p = random_place(random, c);
      if (!inside_area(c.zone.areas[0], c.zone.edges, c.frame.point(p))) continue;
      ASSERT_FALSE(allowed(fitted, {p.east, p.north, 50.0})) << "scribble " << i;
    }
  }
}

TEST(ZoneFences, CirclesAreOnTheSafeSide) {
  Random random(14);
  for (int i = 0; i < tern_test::scaled(300); ++i) {
    for (const ZoneKind kind : {ZoneKind::kKeepOut, ZoneKind::kKeepIn}) {
      ZoneCase c = random_case(random, kind);
      const double half = c.settings.boundary.upper.x;
      ZoneArea circle;
      circle.radius = half * random.real(0.05, 1.5);
      circle.centre = c.frame.point({random.real(-half, half), random.real(-half, half)});
      c.zone.areas = {circle};
      const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
      for (int k = 0; k < 50; ++k) {
        const Plan2 p{random.real(-half, half), random.real(-half, half)};
        const GeoPoint there = c.frame.point(p);
        double distance = 0.0;
        GeographicLib::Geodesic::WGS84().Inverse(circle.centre.latitude, circle.centre.longitude, there.latitude,
                                                 there.longitude, distance);
        const bool open = allowed(fitted, {p.east, p.north, 50.0});
        const double outside = (distance - circle.radius) * (kind == ZoneKind::kKeepOut ? 1.0 : -1.0);
        ASSERT_FALSE(open && outside < 0.0) << "circle " << i << ", " << outside;
        ASSERT_FALSE(!open && outside > fitted.off + 0.01) << "circle " << i << ", " << outside;
      }
    }
  }
}

}  // namespace
