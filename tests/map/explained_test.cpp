// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hits that things which move explain, against a slower test of each voxel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "support/grid_storage.hpp"
#include "support/owned_map.hpp"
#include "support/random.hpp"
#include "tern/map.hpp"

namespace {

using tern::MapSpec;
using tern::Status;
using tern::Track;
using tern::TrackEnd;
using tern::TrackShape;
using tern::Vec3;
using tern::Voxel;
using tern_test::Image;
using tern_test::OwnedMap;
using tern_test::Random;

constexpr std::int64_t kFrameTime = 7000000000;
const tern::Pose kAhead{{1.05, 3.0, 1.5}, {0.5, -0.5, 0.5, -0.5}};  // along x

MapSpec spec_of() {
  MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 60, 30}, 0.0);
  spec.range = 5.0;
  spec.depth_margin = 0.02;
  spec.depth_margin_square = 0.004;
  spec.pose_margin = 0.03;
  spec.angle_margin = 0.01;
  return spec;
}

Track thing_at(const Vec3& position) {
  Track thing;
  thing.measured = kFrameTime;
  thing.position = position;
  thing.radius = 0.3;
  return thing;
}

/// Where it is along an axis, `since` seconds after it was measured: Bernstein's polynomials.
long double place_of(const Track& thing, long double since, double Vec3::*axis) {
  if (thing.piece_count == 0) return thing.position.*axis + since * thing.velocity.*axis;
  int p = 0;
  while (p + 1 < thing.piece_count && since > thing.pieces[p].duration) since -= thing.pieces[p++].duration;
  const long double u = fminl(1.0L, fmaxl(0.0L, since / thing.pieces[p].duration));
  constexpr int kChoose[] = {1, 7, 21, 35, 35, 21, 7, 1};
  long double sum = thing.position.*axis;
  for (int k = 0; k < 8; ++k) sum += kChoose[k] * powl(u, k) * powl(1.0L - u, 7 - k) * thing.pieces[p].points[k].*axis;
  return sum;
}

/// Where it is and how far it may be off, at the time of the frame, and by how much a voxel's centre is in it: negative
/// outside. In long double, from the definition.
long double depth_in(const MapSpec& spec, const Track& thing, std::int64_t begin, const Vec3& centre) {
  const bool has_ended = thing.end == TrackEnd::kStays && kFrameTime - begin > thing.until;
  const long double when = static_cast<long double>(kFrameTime) - begin;
  const long double since = ((has_ended ? thing.until : when) - thing.measured) * 1e-9L;
  const long double apart = fabsl(since);
  const long double error = thing.error + apart * thing.error_speed + apart * apart * thing.error_growth / 2;
  const long double place[3] = {place_of(thing, since, &Vec3::x), place_of(thing, since, &Vec3::y),
                                place_of(thing, since, &Vec3::z)};
  const long double from_eye[3] = {place[0] - kAhead.position.x, place[1] - kAhead.position.y,
                                   place[2] - kAhead.position.z};
  const long double far =
      fminl(spec.range, sqrtl(from_eye[0] * from_eye[0] + from_eye[1] * from_eye[1] + from_eye[2] * from_eye[2]));
  const long double grown = error + spec.pose_margin + spec.angle_margin * far + spec.depth_margin +
                            spec.depth_margin_square * far * far + 0.5L * sqrtl(3.0L) * spec.cell;
  const long double x = centre.x - place[0];
  const long double y = centre.y - place[1];
  const long double z = centre.z - place[2];
  if (thing.shape == TrackShape::kBall) return thing.radius + grown - sqrtl(x * x + y * y + z * z);
  const long double up = thing.half.z + grown - fabsl(z);
  if (thing.shape == TrackShape::kCylinder) return fminl(up, thing.radius + grown - sqrtl(x * x + y * y));
  return fminl(up, fminl(thing.half.x + grown - fabsl(x), thing.half.y + grown - fabsl(y)));
}

class MapExplained : public ::testing::Test {
 protected:
  MapExplained() : image(61, 41, 30.0) {}

  void enter(OwnedMap& owned, const Track* things, int count, std::int64_t begin, std::uint32_t slice) {
    ASSERT_EQ(owned.map.begin_frame(image.view, kAhead, kFrameTime), Status::kRunning);
    owned.map.explain_hits(things, count, begin);
    for (int k = 0; k < 2000000 && owned.map.step(slice) == Status::kRunning;) ++k;
    owned.map.explain_hits(nullptr, 0);
    ASSERT_FALSE(owned.map.busy());
  }
  /// A wall 3 m ahead, which one thing in front of it is to explain: how many voxels of it are marked all the same.
  int marked(const Track& thing, std::int64_t begin = 0) {
    for (float& z : image.z) z = 3.0f;
    OwnedMap owned(spec);
    enter(owned, &thing, 1, begin, 1000);
    return tern_test::count_obstacles(owned.map.route());
  }

  MapSpec spec = spec_of();
  Image image;
};

Track random_thing(Random& random, std::int64_t begin) {
  Track thing = thing_at({random.real(1.5, 6.0), random.real(1.0, 5.0), random.real(0.5, 2.5)});
  thing.measured = kFrameTime - begin + static_cast<std::int64_t>(random.real(-0.49e9, 0.49e9));
  thing.velocity = {random.real(-2.0, 2.0), random.real(-2.0, 2.0), random.real(-1.0, 1.0)};
  thing.shape = static_cast<TrackShape>(random.integer(0, 2));
  thing.radius = random.real(0.0, 0.6);
  thing.half = {random.real(0.0, 0.5), random.real(0.0, 0.5), random.real(0.0, 1.0)};
  thing.error = random.real(0.0, 0.2);
  thing.error_speed = random.real(0.0, 0.3);
  thing.error_growth = random.real(0.0, 3.0);
  return thing;
}

/// Makes it follow two pieces, which it may have begun or ended some seconds before the frame, or have left for good.
void bend(Track& thing, Random& random, std::int64_t begin, tern::TrackPiece (&pieces)[2]) {
  for (tern::TrackPiece& piece : pieces) {
    piece.duration = random.real(0.5, 3.0);
    for (Vec3& point : piece.points) {
      point = {random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-0.5, 0.5)};
    }
  }
  thing.measured = kFrameTime - begin - static_cast<std::int64_t>(random.real(-0.49e9, 4e9));
  thing.pieces = pieces;
  thing.piece_count = 2;
  thing.error_speed = thing.error_growth = 0.0;
  thing.end = random.integer(0, 1) == 0 ? TrackEnd::kGoesOn : TrackEnd::kStays;
  thing.until = thing.measured + static_cast<std::int64_t>(random.real(0.0, 5e9));
}

// The voxels that are marked are those that are marked without the things, but for voxels whose centre is in one.
TEST_F(MapExplained, LeavesOutTheVoxelsOfThingsAndNoOthers) {
  Random random(4401);
  int left_out = 0;
  const int worlds = std::max(4, tern_test::scaled(40));
  for (int k = 0; k < worlds; ++k) {
    for (float& z : image.z) z = static_cast<float>(random.real(0.5, 5.0));
    const std::int64_t begin = k % 2 == 0 ? 0 : INT64_C(1700000000123456789);
    Track things[3];
    for (Track& thing : things) thing = random_thing(random, begin);
    tern::TrackPiece pieces[2];
    bend(things[2], random, begin, pieces);
    OwnedMap all(spec);
    OwnedMap owned(spec);
    enter(all, nullptr, 0, 0, 1000);
    enter(owned, things, 3, begin, k % 3 == 0 ? 1 : 1000);
    for (int n = 0; n < 64 * 60 * 30; ++n) {
      const Voxel voxel{n % 64, n / 64 % 60, n / 3840};
      if (!all.map.route().obstacle(voxel)) {
        ASSERT_FALSE(owned.map.route().obstacle(voxel)) << k << ' ' << n;
        continue;
      }
      long double inside = -1e9L;
      const Vec3 centre = all.map.route().center(voxel);
      for (const Track& thing : things) inside = fmaxl(inside, depth_in(spec, thing, begin, centre));
      if (fabsl(inside) < 1e-6L) continue;
      ASSERT_EQ(owned.map.route().obstacle(voxel), inside < 0.0L) << k << ' ' << n << ' ' << inside;
      left_out += inside > 0.0L ? 1 : 0;
    }
  }
  EXPECT_GT(left_out, 50 * worlds);
}

// What a thing hides is neither an obstacle nor seen free; what lies in front of it is seen.
TEST_F(MapExplained, ShowsNothingOfWhatIsInAThing) {
  for (float& z : image.z) z = 3.0f;
  OwnedMap owned(spec);
  const Track thing = thing_at({4.05, 3.05, 1.55});
  enter(owned, &thing, 1, 0, 1000);
  EXPECT_FALSE(owned.map.route().obstacle({40, 30, 15}));
  EXPECT_FALSE(owned.map.seen({40, 30, 15}));
  EXPECT_FALSE(owned.map.seen({42, 30, 15}));
  EXPECT_TRUE(owned.map.seen({30, 30, 15}));
  EXPECT_TRUE(owned.map.route().obstacle({40, 15, 15}));
}

TEST_F(MapExplained, DoesNotExplainWhatItSaysTooLittleAbout) {
  Track thing = thing_at({4.05, 3.05, 1.55});
  const int without = marked(thing_at({-40.0, 0.0, 0.0}));
  EXPECT_LT(marked(thing), without - 40);
  for (const std::int64_t off : {INT64_C(-500000001), INT64_C(500000001), INT64_MIN / 2, INT64_MAX / 2}) {
    thing.measured = kFrameTime + off;
    EXPECT_EQ(marked(thing), without) << off;
  }
  thing.measured = kFrameTime + 500000000;
  EXPECT_LT(marked(thing), without);
  thing.measured = 0;
  EXPECT_LT(marked(thing, kFrameTime), without);
  EXPECT_EQ(marked(thing, INT64_MIN), without);
  thing = thing_at({4.05, 3.05, 1.55});
  thing.error = tern::kExplainsWithin + 1e-9;
  EXPECT_EQ(marked(thing), without);
  thing.error = 0.0;
  thing.end = TrackEnd::kGone;
  thing.until = kFrameTime - 1;
  EXPECT_EQ(marked(thing), without);
  thing.until = kFrameTime;
  EXPECT_LT(marked(thing), without);
}

// A box may be much larger than the window.
TEST_F(MapExplained, TakesThingsOfAnySize) {
  Track thing = thing_at({4.0, 3.0, 1.5});
  thing.shape = TrackShape::kBox;
  thing.half = {1e12, 1e12, 1e12};
  EXPECT_EQ(marked(thing), 0);
  thing.shape = TrackShape::kBall;
  thing.radius = 1e12;
  EXPECT_EQ(marked(thing), 0);
  thing.position = {1e12, -1e12, 1e12};
  thing.radius = 0.3;
  EXPECT_GT(marked(thing), 0);
}

// A scan's hits are explained as those of an image are, and the next frame marks what no thing explains any more.
TEST_F(MapExplained, HoldsForScansAndEndsWithTheThing) {
  spec.scan_pixel = 0.1;
  spec.pixels = 6 * 25 * 25;
  OwnedMap owned(spec);
  const Vec3 point{3.05, 3.05, 1.55};
  const Track thing = thing_at(point);
  owned.map.explain_hits(&thing, 1);
  ASSERT_EQ(owned.map.begin_scan(&point, 1, kAhead.position, kFrameTime), Status::kRunning);
  EXPECT_EQ(tern_test::finish(owned.map), Status::kOk);
  EXPECT_EQ(tern_test::count_obstacles(owned.map.route()), 0);
  owned.map.explain_hits(nullptr, 1);
  ASSERT_EQ(owned.map.begin_scan(&point, 1, kAhead.position, kFrameTime + 1), Status::kRunning);
  EXPECT_EQ(tern_test::finish(owned.map), Status::kOk);
  EXPECT_EQ(tern_test::count_obstacles(owned.map.route()), 1);
}

}  // namespace
