// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes beside the tube that they must hold: sampled densely, on the ellipsoid, with outlines as geodesics.
#include "host/intent/tube_volumes.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/Gnomonic.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "intent/path_case.hpp"

namespace {

using tern_host::GeoPoint;
using tern_host::GeoPosition;
using tern_host::Instant;
using tern_host::LocalFrame;
using tern_host::TimedPath;
using tern_host::TubeSettings;
using tern_host::Zone;
using tern_test::PathPiece;
using tern_test::Random;
using tern_test::straight;

const GeographicLib::Geodesic& earth() {
  return GeographicLib::Geodesic::WGS84();
}

/// Shortest lines through the point are straight lines of this projection, and those that pass it nearly so.
bool is_within(const Zone& zone, const GeoPoint& point) {
  const tern_host::ZoneArea& area = zone.areas[0];
  if (area.radius > 0.0) {
    double distance = 0.0;
    earth().Inverse(area.centre.latitude, area.centre.longitude, point.latitude, point.longitude, distance);
    return distance <= area.radius;
  }
  const GeographicLib::Gnomonic gnomonic(earth());
  int turns = 0;
  double x = 0.0, y = 0.0;
  const GeoPoint& last = area.ring.back();
  gnomonic.Forward(point.latitude, point.longitude, last.latitude, last.longitude, x, y);
  for (const GeoPoint& corner : area.ring) {
    double u = 0.0, v = 0.0;
    gnomonic.Forward(point.latitude, point.longitude, corner.latitude, corner.longitude, u, v);
    const long double side = static_cast<long double>(u) * y - static_cast<long double>(x) * v;
    if (y <= 0.0 && v > 0.0 && side < 0.0L) ++turns;
    if (y > 0.0 && v <= 0.0 && side > 0.0L) --turns;
    x = u;
    y = v;
  }
  return turns != 0;
}

bool holds(const std::vector<Zone>& volumes, const GeoPosition& p, Instant at) {
  return std::any_of(volumes.begin(), volumes.end(), [&](const Zone& zone) {
    return *zone.times[0].from <= at && at <= *zone.times[0].until && zone.lower->metres <= p.height &&
           p.height <= zone.upper->metres && is_within(zone, p.point);
  });
}

Instant instant_of(const TubeSettings& settings, long double seconds) {
  return settings.epoch + static_cast<Instant>(std::floor(seconds * 1e9L));
}

TubeSettings random_settings(Random& random) {
  TubeSettings settings;
  settings.epoch = *tern_host::parse_instant("2026-03-01T09:30:00Z") + random.integer(0, 999999999);
  settings.looseness = random.real(7.0, 30.0) * (random.chance(0.3) ? 3.0 : 1.0);
  settings.longest = random.real(4.0, 120.0);
  settings.clock_error = random.chance(0.5) ? random.real(0.0, 3.0) : 0.0;
  return settings;
}

LocalFrame random_frame(Random& random) {
  return LocalFrame({{random.real(-75.0, 75.0), random.real(-180.0, 180.0)}, random.real(-50.0, 3000.0)});
}

tern::Vec3 place_at(const TimedPath& path, double t) {
  const double at = std::clamp(t, path.pieces.front().begin, path.pieces.back().end);
  const auto piece =
      std::find_if(path.pieces.begin(), path.pieces.end(), [at](const PathPiece& p) { return at <= p.end; });
  return tern_test::position(*piece, at);
}

/// Places of the tube at a time, on its skin.
void expect_held(const std::vector<Zone>& volumes, const LocalFrame& frame, const TimedPath& path,
                 const TubeSettings& settings, double t, Random& random) {
  const GeoPosition centre = frame.position(place_at(path, t));
  const Instant at = instant_of(settings, t + random.real(-1.0, 1.0) * settings.clock_error);
  const double azimuth = random.real(-180.0, 180.0), r = path.radius;
  GeoPosition side = centre;
  earth().Direct(centre.point.latitude, centre.point.longitude, azimuth, r, side.point.latitude, side.point.longitude);
  EXPECT_TRUE(holds(volumes, side, at)) << "at " << t << " s, towards " << azimuth;
  EXPECT_TRUE(holds(volumes, {centre.point, centre.height + r}, at)) << "at " << t;
  EXPECT_TRUE(holds(volumes, {centre.point, centre.height - r}, at)) << "at " << t;
}

TEST(TubeVolumes, HoldTheTube) {
  Random random(101);
  const int cases = tern_test::scaled(400);
  for (int c = 0; c < cases; ++c) {
    const TimedPath path = tern_test::random_path(random);
    const TubeSettings settings = random_settings(random);
    const LocalFrame frame = random_frame(random);
    const std::vector<Zone> volumes = tube_volumes(path, frame, settings);
    const double begin = path.pieces.front().begin, end = path.pieces.back().end;
    for (int i = 0; i <= 60; ++i) {
      expect_held(volumes, frame, path, settings, begin + (end - begin) * i / 60, random);
      if (HasFailure()) FAIL() << "case " << c;
    }
  }
}

/// Where the way is while the volume holds, a thousand times.
std::vector<tern::Vec3> places_of(const TimedPath& path, const Zone& zone, const TubeSettings& settings) {
  const double from = static_cast<double>(*zone.times[0].from - settings.epoch) * 1e-9;
  const double until = static_cast<double>(*zone.times[0].until - settings.epoch) * 1e-9;
  std::vector<tern::Vec3> places;
  for (int i = 0; i <= 1000; ++i) places.push_back(place_at(path, from + (until - from) * i / 1000));
  return places;
}

/// Some place of the way is no farther away than the tube's radius and the looseness.
bool is_near(const std::vector<tern::Vec3>& places, double most, const tern::Vec3& p) {
  // Samples are up to 1 m apart.
  return std::any_of(places.begin(), places.end(), [&p, most](const tern::Vec3& q) {
    return std::hypot(p.x - q.x, p.y - q.y) <= most + 1.0 && std::fabs(p.z - q.z) <= most + 1.0;
  });
}

TEST(TubeVolumes, AreNoLooserThanTold) {
  Random random(102);
  const int cases = tern_test::scaled(100);
  for (int c = 0; c < cases; ++c) {
    const TimedPath path = tern_test::random_path(random);
    const TubeSettings settings = random_settings(random);
    const LocalFrame frame = random_frame(random);
    for (const Zone& zone : tube_volumes(path, frame, settings)) {
      const double seconds = static_cast<double>(*zone.times[0].until - *zone.times[0].from) * 1e-9;
      const std::vector<tern::Vec3> places = places_of(path, zone, settings);
      const double most = path.radius + settings.looseness;
      EXPECT_LE(seconds, settings.longest + 2.0 * settings.clock_error + 0.002);
      for (const double z : {zone.lower->metres, zone.upper->metres}) {
        for (const GeoPoint& corner : zone.areas[0].ring) {
          const tern::Vec3 p = frame.local({corner, z});
          EXPECT_TRUE(is_near(places, most, p)) << "case " << c;
        }
        if (zone.areas[0].radius > 0.0) {
          tern::Vec3 p = frame.local({zone.areas[0].centre, z});
          p.x += zone.areas[0].radius;
          EXPECT_TRUE(is_near(places, most, p)) << "case " << c;
        }
      }
    }
  }
}

const LocalFrame kFrame({{47.0, 8.0}, 400.0});

TubeSettings noon() {
  TubeSettings settings;
  settings.epoch = *tern_host::parse_instant("2026-03-01T12:00:00Z");
  return settings;
}

TEST(TubeVolumes, GoAroundAStraightWay) {
  const TimedPath path{"straight", {straight(10.0, 30.0, {0, 0, 50}, {100, 0, 50})}, 2.0};
  TubeSettings settings = noon();
  settings.clock_error = 0.5;
  const std::vector<Zone> volumes = tube_volumes(path, kFrame, settings);
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_EQ(tern_host::instant_text(*volumes[0].times[0].from), "2026-03-01T12:00:09.499Z");
  EXPECT_EQ(tern_host::instant_text(*volumes[0].times[0].until), "2026-03-01T12:00:30.501Z");
  EXPECT_NEAR(volumes[0].lower->metres, 448.0, 0.0011);
  EXPECT_NEAR(volumes[0].upper->metres, 452.0, 0.0011);
  double west = 0, east = 0, south = 0, north = 0;
  for (const GeoPoint& corner : volumes[0].areas[0].ring) {
    const tern_host::Plan2 p = kFrame.plan(corner);
    west = std::min(west, p.east);
    east = std::max(east, p.east);
    south = std::min(south, p.north);
    north = std::max(north, p.north);
  }
  // A corner of the regular polygon points each way, 2 m / cos(pi / 16) from the way's end; sides are left out up to a
  // metre from there.
  const double by = 2.0 / std::cos(3.14159265358979 / 16.0);
  EXPECT_LT(volumes[0].areas[0].ring.size(), 12u);
  EXPECT_LT(west, -by + 1e-4);
  EXPECT_GT(west, -by - 1.0);
  EXPECT_GT(east, 100.0 + by - 1e-4);
  EXPECT_LT(east, 100.0 + by + 1.0);
  EXPECT_LT(south, -by + 1e-4);
  EXPECT_GT(south, -by - 1.0);
  EXPECT_GT(north, by - 1e-4);
  EXPECT_LT(north, by + 1.0);
}

TEST(TubeVolumes, EndWhenTheyAreLongEnough) {
  const TimedPath path{"straight", {straight(0.0, 20.0, {0, 0, 50}, {100, 0, 50})}, 2.0};
  TubeSettings settings = noon();
  settings.longest = 5.0;
  EXPECT_EQ(tube_volumes(path, kFrame, settings).size(), 4u);
  settings.longest = 4.9;
  EXPECT_EQ(tube_volumes(path, kFrame, settings).size(), 5u);
}

TEST(TubeVolumes, AreLevelsOfASlope) {
  // 40 m up in 5 levels of no more than 10 m less two millimetres.
  const TimedPath path{"slope", {straight(0.0, 20.0, {0, 0, 0}, {400, 0, 40})}, 2.0};
  EXPECT_EQ(tube_volumes(path, kFrame, noon()).size(), 5u);
}

TEST(TubeVolumes, ClimbInOneCircle) {
  const TimedPath path{"climb", {straight(0.0, 20.0, {30, 40, 0}, {30, 40, 100})}, 2.0};
  const std::vector<Zone> volumes = tube_volumes(path, kFrame, noon());
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_NEAR(volumes[0].areas[0].radius, 2.0, 0.011);
  EXPECT_NEAR(kFrame.plan(volumes[0].areas[0].centre).north, 40.0, 1e-6);
  EXPECT_NEAR(volumes[0].lower->metres, 398.0, 0.0011);
  EXPECT_NEAR(volumes[0].upper->metres, 502.0, 0.0011);
}

TEST(TubeVolumes, HoldARestAtTheEnd) {
  const TimedPath path{"straight", {straight(0.0, 20.0, {0, 0, 50}, {100, 0, 50})}, 2.0};
  const std::vector<Zone> volumes = tube_volumes(tern_host::with_rest(path, 30.0), kFrame, noon());
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_EQ(tern_host::instant_text(*volumes[0].times[0].until), "2026-03-01T12:00:50.001Z");
}

TEST(TubeVolumes, RefuseSettingsAndPlaces) {
  TimedPath path{"straight", {straight(0.0, 20.0, {0, 0, 50}, {100, 0, 50})}, 2.0};
  TubeSettings settings = noon();
  settings.looseness = 0.05;
  EXPECT_THROW(tube_volumes(path, kFrame, settings), std::invalid_argument);
  settings = noon();
  settings.longest = 0.5;
  EXPECT_THROW(tube_volumes(path, kFrame, settings), std::invalid_argument);
  settings = noon();
  settings.clock_error = -1.0;
  EXPECT_THROW(tube_volumes(path, kFrame, settings), std::invalid_argument);
  settings = noon();
  settings.longest = 1.0;
  path.pieces[0] = straight(0.0, 3600.0, {0, 0, 50}, {100, 0, 50});
  EXPECT_THROW(tube_volumes(path, kFrame, settings), std::invalid_argument);
  path.pieces[0] = straight(0.0, 20.0, {0, 0, 50}, {11000, 0, 50});
  EXPECT_THROW(tube_volumes(path, kFrame, noon()), std::invalid_argument);
}

}  // namespace
