// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights, refusals and notes of zones that are fitted, by hand.
#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/Geoid.hpp>
#include <fstream>
#include <stdexcept>

#include "airspace/zone_case.hpp"
#include "host/airspace/terrain_grid.hpp"
#include "host/text_records.hpp"
#include "support/own_folder.hpp"

namespace {

using namespace tern_test;

/// Metres along the ellipsoid.
double geodesic(const GeoPoint& a, const GeoPoint& b) {
  double length = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(a.latitude, a.longitude, b.latitude, b.longitude, length);
  return length;
}

TEST(ZoneFit, AFarCircleIsCoveredAlthoughTheFrameStretchesIt) {
  ZoneCase c = square_case(ZoneKind::kKeepOut, {});
  c.settings.boundary = {{-7000.0, -1000.0, 0.0}, {7000.0, 1000.0, 150.0}};
  ZoneArea circle;
  circle.centre = c.frame.point({0.0, 100000.0});
  circle.radius = 100000.0;
  c.zone.areas = {circle};
  const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
  for (int i = -1000; i <= 1000; ++i) {
    // Just within the circle, at its southern side, by bisection.
    double outside = -900.0, inside = 900.0;
    while (inside - outside > 1e-6) {
      const double middle = 0.5 * (outside + inside);
      (geodesic(circle.centre, c.frame.point({7.0 * i, middle})) < circle.radius - 1e-3 ? inside : outside) = middle;
    }
    EXPECT_FALSE(allowed(fitted, {7.0 * i, inside, 50.0})) << i;
  }
}

/// The lowest and highest z that a fence has above a place.
std::pair<double, double> heights_of(const FittedFence& fence) {
  std::pair<double, double> range{-INFINITY, INFINITY};
  for (const tern::Halfspace& h : fence.planes) {
    if (h.normal.z > 0.0) range.second = h.offset;
    if (h.normal.z < 0.0) range.first = -h.offset;
  }
  return range;
}

TEST(ZoneFit, HeightsAreConverted) {
  tern_host::HeightSources sources;
  sources.undulation = 50.0;
  sources.ground = tern_host::HeightRange{360.0, 380.0};
  ZoneCase c = square_case(ZoneKind::kKeepOut, sources);
  c.zone.lower = tern_host::ZoneHeight{420.0, HeightReference::kEllipsoid};
  c.zone.upper = tern_host::ZoneHeight{450.0, HeightReference::kSeaLevel};
  FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
  ASSERT_EQ(fitted.fences.size(), 1u);
  EXPECT_EQ(fitted.fences[0].planes.size(), 6u);
  EXPECT_EQ(heights_of(fitted.fences[0]), std::make_pair(20.0, 100.0));  // 420 - 400; 450 + 50 - 400
  c.zone.lower = tern_host::ZoneHeight{30.0, HeightReference::kGround};
  c.zone.upper = tern_host::ZoneHeight{60.0, HeightReference::kGround};
  fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
  EXPECT_EQ(heights_of(fitted.fences[0]), std::make_pair(40.0, 90.0));  // 30 + 360 + 50 - 400; 60 + 380 + 50 - 400
  EXPECT_EQ(fitted.height_off, 20.0);
  c.zone.kind = ZoneKind::kKeepIn;
  fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
  EXPECT_EQ(heights_of(fitted.fences[0]), std::make_pair(60.0, 70.0));
  // Above the boundary, there is no fence.
  c.zone.kind = ZoneKind::kKeepOut;
  c.zone.lower = tern_host::ZoneHeight{560.0, HeightReference::kEllipsoid};
  c.zone.upper.reset();
  EXPECT_TRUE(tern_host::fit_zone(c.zone, c.heights, c.settings).fences.empty());
}

void expect_refused(const ZoneCase& c, const std::string& part) {
  try {
    tern_host::fit_zone(c.zone, c.heights, c.settings);
    FAIL() << "not refused: " << part;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(ZoneFit, RefusesHeightsThatItCannotConvert) {
  ZoneCase c = square_case(ZoneKind::kKeepOut, {});
  c.zone.upper = tern_host::ZoneHeight{100.0, HeightReference::kSeaLevel};
  expect_refused(c, "--geoid");
  tern_host::HeightSources geoid_alone;
  geoid_alone.undulation = 50.0;
  ZoneCase above = square_case(ZoneKind::kKeepOut, geoid_alone);
  above.zone.upper = tern_host::ZoneHeight{100.0, HeightReference::kGround};
  expect_refused(above, "--terrain");
  ZoneCase unknown = square_case(ZoneKind::kKeepOut, {}, NAN);
  unknown.zone.upper = tern_host::ZoneHeight{100.0, HeightReference::kEllipsoid};
  expect_refused(unknown, "--height");
  ZoneCase reversed = square_case(ZoneKind::kKeepOut, {});
  reversed.zone.lower = tern_host::ZoneHeight{500.0, HeightReference::kEllipsoid};
  reversed.zone.upper = tern_host::ZoneHeight{450.0, HeightReference::kEllipsoid};
  expect_refused(reversed, "below its lower");
}

TEST(ZoneFit, AKeepInWithTimesClosesAllAroundIt) {
  ZoneCase c = square_case(ZoneKind::kKeepIn, {});
  c.zone.times.push_back({});
  c.zone.upper = tern_host::ZoneHeight{440.0, HeightReference::kEllipsoid};
  const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
  ASSERT_EQ(fitted.fences.size(), 5u);
  for (const FittedFence& fence : fitted.fences) {
    EXPECT_EQ(fence.kind, tern::FenceKind::kKeepOut);
    EXPECT_EQ(fence.planes.size(), 1u);
    ASSERT_EQ(fence.outline.size(), 4u);
    // The side is about 100 m from the origin, and the boundary with its clearance ends 500.5 m from it.
    const double area =
        std::fabs((fence.outline[2].x - fence.outline[0].x) * (fence.outline[3].y - fence.outline[1].y) -
                  (fence.outline[2].y - fence.outline[0].y) * (fence.outline[3].x - fence.outline[1].x)) /
        2.0;
    const bool level = fence.planes[0].normal.z != 0.0;
    EXPECT_NEAR(area, level ? 1001.0 * 1001.0 : 1001.0 * 400.5, 20.0);
    EXPECT_EQ(fence.bottom, level ? 40.0 : -INFINITY);
  }
  EXPECT_TRUE(allowed(fitted, {99.0, -99.0, 39.0}));
  EXPECT_FALSE(allowed(fitted, {99.0, -99.0, 41.0}));
  EXPECT_FALSE(allowed(fitted, {-101.0, 0.0, 39.0}));
  // What holds the whole boundary closes nothing.
  c.settings.boundary = {{-50.0, -50.0, 0.0}, {50.0, 50.0, 30.0}};
  EXPECT_TRUE(tern_host::fit_zone(c.zone, c.heights, c.settings).fences.empty());
}

TEST(ZoneFit, RefusesWhatItCannotFit) {
  ZoneCase away = square_case(ZoneKind::kKeepIn, {});
  for (GeoPoint& p : away.zone.areas[0].ring) p.latitude += 1.0;
  expect_refused(away, "leaves no room");
  ZoneCase around = square_case(ZoneKind::kKeepOut, {});
  around.zone.areas[0].ring = {{-80.0, -180.0}, {-80.0, 180.0}, {80.0, 180.0}, {80.0, -180.0}};
  expect_refused(around, "all around the earth");
  ZoneCase half = square_case(ZoneKind::kKeepOut, {});
  half.zone.areas[0].ring = {{-60.0, -80.0}, {-60.0, 90.0}, {70.0, 90.0}, {70.0, -80.0}};
  expect_refused(half, "more than 5000 km");
  ZoneCase uncertain = square_case(ZoneKind::kKeepOut, {});
  uncertain.zone.edges = tern_host::EdgeRule::kEither;
  uncertain.zone.areas[0].ring = {{47.0, 5.0}, {47.0, 11.0}, {48.0, 8.0}};
  expect_refused(uncertain, "m uncertain");
}

TEST(ZoneFit, SaysWhatItMadeOfCrossings) {
  ZoneCase c = square_case(ZoneKind::kKeepOut, {});
  std::swap(c.zone.areas[0].ring[1], c.zone.areas[0].ring[2]);
  const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
  EXPECT_EQ(fitted.fences.size(), 2u);
  ASSERT_EQ(fitted.notes.size(), 1u);
  EXPECT_NE(fitted.notes[0].find("crosses itself"), std::string::npos);
}

TEST(ZoneFit, ThePentagramIsClosedAndItsMiddleIsNoPlaceToStay) {
  for (const ZoneKind kind : {ZoneKind::kKeepOut, ZoneKind::kKeepIn}) {
    ZoneCase c = square_case(kind, {});
    c.settings.looseness = 0.01;
    c.zone.areas[0].ring.clear();
    for (int i = 0; i < 5; ++i) {
      const double angle = 2.0 * i * 6.283185307179586 / 5.0;
      c.zone.areas[0].ring.push_back(c.frame.point({100.0 * std::cos(angle), 100.0 * std::sin(angle)}));
    }
    const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
    EXPECT_FALSE(allowed(fitted, {0.0, 0.0, 50.0}));
    EXPECT_EQ(allowed(fitted, {70.0, 0.0, 50.0}), kind == ZoneKind::kKeepIn);
    EXPECT_EQ(allowed(fitted, {-60.0, 0.0, 50.0}), kind == ZoneKind::kKeepOut);
    ASSERT_GE(fitted.notes.size(), 1u);
    EXPECT_NE(fitted.notes[0].find("crosses itself"), std::string::npos);
  }
}

TEST(ZoneFit, AShallowDentIsFilledAndSaid) {
  for (const ZoneKind kind : {ZoneKind::kKeepOut, ZoneKind::kKeepIn}) {
    ZoneCase c = square_case(kind, {});
    c.zone.areas[0].ring.push_back(c.frame.point({-99.6, 0.0}));  // 0.4 m within the western side
    const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
    EXPECT_EQ(fitted.fences.size(), 1u);
    EXPECT_NEAR(fitted.off, 0.4, 0.01);
    EXPECT_FALSE(allowed(fitted, {-99.7, 0.0, 50.0}));
    c.settings.looseness = 0.7;
    EXPECT_EQ(tern_host::fit_zone(c.zone, c.heights, c.settings).fences.size(), 2u);
  }
}

TEST(ZoneFit, AFlatZoneIsNotElsewhere) {
  ZoneCase c = square_case(ZoneKind::kKeepOut, {});
  c.zone.areas[0].ring = {{47.0, 8.0}, {47.001, 8.0}, {47.0, 8.0}};
  const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
  EXPECT_TRUE(fitted.fences.empty());
  EXPECT_TRUE(fitted.flat);
  c.zone.areas[0].ring = {{48.0, 8.0}, {48.001, 8.0}, {48.0, 8.0}};
  EXPECT_FALSE(tern_host::fit_zone(c.zone, c.heights, c.settings).flat);
}

TEST(ZoneFit, AZoneFarAwayIsNoFence) {
  for (const GeoPoint& there : {GeoPoint{-47.0, -172.0}, GeoPoint{10.0, 100.0}, GeoPoint{47.0, 9.0}}) {
    ZoneCase c = square_case(ZoneKind::kKeepOut, {});
    c.zone.areas[0].ring = {{there.latitude - 0.01, there.longitude - 0.01},
                            {there.latitude - 0.01, there.longitude + 0.01},
                            {there.latitude + 0.01, there.longitude}};
    EXPECT_TRUE(tern_host::fit_zone(c.zone, c.heights, c.settings).fences.empty());
  }
}

TEST(ZoneFit, LongEdgesElsewhereAreNotUncertainHere) {
  ZoneCase c = square_case(ZoneKind::kKeepOut, {});
  c.zone.edges = tern_host::EdgeRule::kEither;
  // The long edge is uncertain by kilometres, but passes 111 km to the north.
  c.zone.areas[0].ring = {{48.0, 5.0}, {48.0, 10.0}, {49.0, 8.0}};
  EXPECT_TRUE(tern_host::fit_zone(c.zone, c.heights, c.settings).fences.empty());
  c.zone.areas[0].ring = {{48.0, 5.0}, {48.0, 10.0}, {47.003, 8.002}, {46.998, 8.0}, {47.003, 7.998}};
  expect_refused(c, "uncertain");  // two edges of 190 km end here
}

TEST(ZoneFit, ACountryIsReadAndCoversTheBoundary) {
  ZoneCase c = square_case(ZoneKind::kKeepOut, {});
  c.zone.edges = tern_host::EdgeRule::kDegrees;
  c.zone.areas[0].ring = {{45.8, 5.9}, {45.8, 10.5}, {47.8, 10.5}, {47.8, 5.9}};
  const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
  ASSERT_EQ(fitted.fences.size(), 1u);
  EXPECT_TRUE(within_fence(fitted.fences[0], {400.0, -400.0, 100.0}));
  ASSERT_EQ(fitted.notes.size(), 1u);
  EXPECT_EQ(fitted.notes[0], "it covers all of the boundary");
}

TEST(ZoneFit, ChecksItsSettings) {
  tern_host::FitSettings settings;
  settings.boundary = {{-8000.0, -8000.0, 0.0}, {8000.0, 8000.0, 100.0}};
  EXPECT_THROW(tern_host::check_fit(settings), std::invalid_argument);  // its corners are 11.3 km away
  settings.boundary = {{-7000.0, -7000.0, 0.0}, {7000.0, 7000.0, 100.0}};
  EXPECT_NO_THROW(tern_host::check_fit(settings));
  settings.looseness = 0.0;
  EXPECT_THROW(tern_host::check_fit(settings), std::invalid_argument);
  settings.looseness = 1.0;
  settings.clearance = -1.0;
  EXPECT_THROW(tern_host::check_fit(settings), std::invalid_argument);
  settings.clearance = 0.5;
  settings.boundary.upper.x = -9000.0;
  EXPECT_THROW(tern_host::check_fit(settings), std::invalid_argument);
}

/// A tile of 1201 x 1201 posts, each as high as its row from the north plus its column from the west.
std::string sloping_tile() {
  std::string bytes;
  for (int row = 0; row < 1201; ++row) {
    for (int column = 0; column < 1201; ++column) {
      const int height = row + column;
      bytes += static_cast<char>(height / 256);
      bytes += static_cast<char>(height % 256);
    }
  }
  return bytes;
}

TEST(TerrainGrid, HasTheHeightsOfAllCellsBelow) {
  const tern_host::TerrainGrid tile(sloping_tile(), "folder/N47E008.hgt");
  double low = INFINITY, high = -INFINITY;
  // From 0.25 to 0.5 degrees north and 0.1 to 0.2 east: rows 600 to 900, columns 120 to 240.
  tile.widen({47.2501, 8.1001}, {47.4999, 8.1999}, low, high);
  EXPECT_EQ(low, 720.0);
  EXPECT_EQ(high, 1140.0);
  EXPECT_THROW(tile.widen({46.9, 8.1}, {47.1, 8.2}, low, high), std::invalid_argument);
  EXPECT_THROW(tile.widen({47.1, 8.9}, {47.2, 9.1}, low, high), std::invalid_argument);
  std::string hole = sloping_tile();
  hole[2 * (700 * 1201 + 200)] = '\x80';
  hole[2 * (700 * 1201 + 200) + 1] = '\0';
  EXPECT_THROW(tern_host::TerrainGrid(hole, "N47E008.hgt").widen({47.25, 8.1}, {47.5, 8.2}, low, high),
               std::invalid_argument);
}

TEST(TerrainGrid, RefusesOtherFiles) {
  EXPECT_THROW(tern_host::TerrainGrid("abc", "N47E008.hgt"), tern_host::RecordError);
  EXPECT_THROW(tern_host::TerrainGrid(sloping_tile(), "tile.hgt"), tern_host::RecordError);
  EXPECT_THROW(tern_host::TerrainGrid(sloping_tile(), "N4xE008.hgt"), tern_host::RecordError);
}

TEST(ZoneHeights, TakeTheGeoidFromAFile) {
  // 45 degrees between places; every place as high as its row from the north: 10, 20 ... m.
  const std::string& folder = tern_test::own_folder();
  std::ofstream file(folder + "rows.pgm", std::ios::binary);
  file << "P5\n# Geoid file in PGM format for the GeographicLib::Geoid class\n# Origin 90N 0E\n# Offset 0\n# Scale "
          "0.01\n8 5\n65535\n";
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 8; ++column) {
      const int value = 1000 * (row + 1);
      file.put(static_cast<char>(value / 256)).put(static_cast<char>(value % 256));
    }
  }
  file.close();
  tern_host::HeightSources sources;
  sources.geoid_file = folder + "rows.pgm";
  ZoneCase c = square_case(ZoneKind::kKeepOut, sources);
  c.zone.upper = tern_host::ZoneHeight{450.0, HeightReference::kSeaLevel};
  const FittedZone fitted = tern_host::fit_zone(c.zone, c.heights, c.settings);
  const double exact = GeographicLib::Geoid("rows", folder)(47.0, 8.0);
  EXPECT_NEAR(exact, 19.6, 0.5);
  const double top = heights_of(fitted.fences[0]).second;
  EXPECT_GE(top, 50.0 + exact);
  EXPECT_LE(top, 50.0 + exact + 0.02);
  EXPECT_LE(fitted.height_off, 0.04);
  sources.geoid_file = folder + "missing.pgm";
  EXPECT_THROW(square_case(ZoneKind::kKeepOut, sources), std::invalid_argument);
  sources.geoid_file = folder + "rows.txt";
  EXPECT_THROW(square_case(ZoneKind::kKeepOut, sources), std::invalid_argument);
}

}  // namespace
