// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight in a small world, tick by tick, and what must hold at each of them.
#ifndef TERN_TESTS_SUPPORT_FLOWN_HPP
#define TERN_TESTS_SUPPORT_FLOWN_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "support/flown_world.hpp"
#include "tern/flight.hpp"

namespace tern_test {

struct FlightSettings {
  double v = 3.0;
  double a = 6.0;
  double body = 0.25;
  double cell = 0.2;
  double radius = 0.35;
  double margin = 0.0;    ///< part of the radius that is MapSpec::tracking_margin
  double tracking = 0.0;  ///< largest tracking error, metres
  tern::Voxel window{256, 150, 20};
  tern::Vec3 start{0.0, 0.0, 1.5};
  double assumed = 1.2;
  double jerk = 0.0;  ///< 0: no limit
  std::uint32_t work_per_tick = 4000;
  double noise = 0.0;     ///< of a depth, part of it
  double outliers = 0.0;  ///< part of the pixels that show a random depth
  int hits = 1;
  int support = 0;
  double pose_margin = 0.0;
  std::vector<tern::Fence> fences{};
  double no_return = 0.0;   ///< as DepthView::no_return
  tern::Cylinder column{};  ///< as for RollingMap::assume_column(); a radius of 0: none
  bool centers = false;     ///< a pixel has the depth of its centre, not its least one
};

/// What the camera shows instead of the world.
enum class Images {
  kTrue,
  kBlind,  ///< no pixel has a depth
  kNear,   ///< all of them the shortest one
  kFar,    ///< all of them one beyond the range that is used
  kShort,  ///< the world, but nothing comes back from beyond the range
};

class Flown {
 public:
  Flown(const Scene& world, const FlightSettings& s)
      : scene(world),
        settings(s),
        owned(spec_of(s)),
        memory(new tern::Workspace),
        planner(memory.get(), sizeof *memory) {
    EXPECT_EQ(owned.status, tern::Status::kOk);
    EXPECT_EQ(owned.map.assume_free(s.start, s.assumed), tern::Status::kOk);
    if (s.column.radius > 0.0) {
      EXPECT_EQ(owned.map.assume_column(s.column), tern::Status::kOk);
    }
    tern::Limits limits{{s.v, s.v, std::min(s.v, 2.0)}, {s.a, s.a, std::min(s.a, 6.0)}};
    limits.v_horizontal = s.v;
    limits.a_horizontal = s.a;
    spec = tern::flight_spec(limits);
    spec.limits.j_max = {s.jerk, s.jerk, s.jerk};
    spec.work_per_tick = s.work_per_tick;
    spec.fences = settings.fences.data();
    spec.fence_count = static_cast<std::int32_t>(settings.fences.size());
    spec.plan_work = 4 * s.work_per_tick;
    words.assign(tern::flight_words(s.window), 0xA5A5A5A5A5A5A5A5u);
    started = flight.start(spec, owned.map, planner, words.data(), words.size(), s.start, 0, &refusal);
  }

  static tern::MapSpec spec_of(const FlightSettings& s) {
    const tern::Vec3 half{0.5 * s.window.x * s.cell, 0.5 * s.window.y * s.cell, 0.0};
    tern::MapSpec map = tern::map_spec({s.start.x - half.x, s.start.y - half.y, std::max(-0.4, s.start.z - 2.0)},
                                       s.cell, s.window, s.radius - s.margin);
    map.tracking_margin = s.margin;
    map.pixels = 160 * 120;
    map.pose_margin = s.pose_margin;
    map.depth_margin = 0.02;
    map.slack = 8;
    map.hits = s.hits;
    map.support = s.support;
    map.depth_margin += 10.0 * s.noise;
    return map;
  }

  /// One tick of 10 ms: a frame is taken every third, and arrives 30 ms later.
  void tick() {
    take_frame();
    const tern::Command ahead = flight.command(time + spec.tick);
    ASSERT_EQ(flight.tick(time, report), tern::Status::kOk);
    check_joint(ahead, flight.command(time + spec.tick));
    check_now();
    // While a frame is being entered, what it shows may be in the map already and the flight does not know it yet.
    ++unchecked;
    if (unchecked >= 25 && !owned.map.busy() && report.mode != tern::FlightMode::kThreat) check_ahead();
    turn();
    hash_command();
    time += spec.tick;
    ++ticks;
  }

  /// Ticks that are never done. The vehicle flies on.
  void skip(int count) {
    for (int k = 0; k < count && !testing::Test::HasFatalFailure(); ++k) {
      time += spec.tick;
      ++ticks;
      check_now();
    }
  }

  /// Until the vehicle rests for a reason, or time is up.
  tern::FlightReason fly(double seconds) {
    const std::int64_t end = time + static_cast<std::int64_t>(seconds * 1e9);
    while (time < end && !testing::Test::HasFatalFailure()) {
      tick();
      if (report.mode == tern::FlightMode::kRest && report.reason != tern::FlightReason::kNone) break;
    }
    return report.reason;
  }

  tern::Vec3 position() const { return flight.command(time).sample.position; }

  Scene scene;
  FlightSettings settings;
  OwnedMap owned;
  std::unique_ptr<tern::Workspace> memory;
  tern::Planner planner;
  tern::FlightSpec spec{};
  std::vector<std::uint64_t> words;
  tern::Flight flight;
  tern::Status started;
  tern::FlightRefusal refusal{};
  std::vector<tern::Vec3> pads;  ///< places where the vehicle may stand; z: the height that the ground does not exceed
  tern::FlightReport report{};
  std::int64_t time = 0;
  int ticks = 0;
  bool frames = true;
  bool follows_yaw = false;  ///< the camera looks where the nose points, not at Command::look_at
  double drop = 0.0;
  int late = 0;                  ///< ticks that a frame takes to arrive, besides one
  tern::Vec3 pose_error{};       ///< of the position that the vehicle believes to be at
  std::vector<Cylinder> ghosts;  ///< that the camera shows, and that are not there
  Images images = Images::kTrue;
  bool may_touch = false;  ///< an obstacle appeared: contacts are the test's affair
  double yaw = 0.0;
  double least_clearance = 1e9;
  std::uint64_t hash = 0xCBF29CE484222325u;
  Random random{7};

  /// Where the vehicle truly is: off the command by a smooth error, and by the pose's.
  tern::Vec3 truth() const {
    const double t = 1e-9 * static_cast<double>(time);
    const tern::Vec3 p = position();
    const double e = settings.tracking / std::sqrt(3.0);
    return {p.x + e * std::sin(1.3 * t) - pose_error.x, p.y + e * std::sin(1.7 * t + 1.0) - pose_error.y,
            p.z + e * std::sin(2.1 * t + 2.0) - pose_error.z};
  }

  /// From the nearest voxel that is not known to be free, or from the window's faces.
  /// Right above a pad, voxels that reach below it do not count.
  double solid_distance(const tern::Vec3& p) const {
    const double ground = ground_below(p) - owned.map.safe().spec().origin.z;
    const tern::Grid& safe = owned.map.safe();
    const tern::GridSpec& grid = safe.spec();
    const double q[3] = {p.x - grid.origin.x, p.y - grid.origin.y, p.z - grid.origin.z};
    const int dims[3] = {grid.dims.x, grid.dims.y, grid.dims.z};
    const int reach = static_cast<int>(settings.radius / grid.cell) + 2;
    double best = 1e9;
    int at[3];
    for (int a = 0; a < 3; ++a) {
      at[a] = static_cast<int>(std::floor(q[a] / grid.cell));
      best = std::min({best, q[a], dims[a] * grid.cell - q[a]});
    }
    for (int z = at[2] - reach; z <= at[2] + reach; ++z) {
      for (int y = at[1] - reach; y <= at[1] + reach; ++y) {
        for (int x = at[0] - reach; x <= at[0] + reach; ++x) {
          if (!safe.obstacle({x, y, z}) || z * grid.cell < ground) continue;
          const double lower[3] = {x * grid.cell, y * grid.cell, z * grid.cell};
          double square = 0.0;
          for (int a = 0; a < 3; ++a) {
            const double gap = std::max({lower[a] - q[a], q[a] - lower[a] - grid.cell, 0.0});
            square += gap * gap;
          }
          best = std::min(best, std::sqrt(square));
        }
      }
    }
    return best;
  }

  /// The height of the pad that a point is right above; far below if there is none.
  double ground_below(const tern::Vec3& p) const {
    for (const tern::Vec3& pad : pads) {
      if (std::hypot(pad.x - p.x, pad.y - p.y) < 1e-9 + settings.tracking) return pad.z;
    }
    return -1e9;
  }

 private:
  void take_frame() {
    if (!frames) waiting = false;
    if (waiting && !owned.map.busy() && ticks >= arrives) {
      EXPECT_EQ(owned.map.begin_frame(shown.image.view, shown.pose, time), tern::Status::kRunning);
      waiting = false;
    }
    // The image that is entered must stay: the next one is rendered once that is done.
    if (ticks % 3 == 0 && frames && !waiting && !owned.map.busy() && !random.chance(drop)) {
      shown.centers = settings.centers;
      haunted = haunted || !ghosts.empty();
      Scene imagined = scene;
      imagined.cylinders.insert(imagined.cylinders.end(), ghosts.begin(), ghosts.end());
      shown.render(imagined, truth(), yaw);
      shown.pose.position = {shown.pose.position.x + pose_error.x, shown.pose.position.y + pose_error.y,
                             shown.pose.position.z + pose_error.z};
      disturb(shown.image);
      replace(shown.image);
      waiting = true;
      arrives = ticks + late;
    }
  }

  /// Noise within the map's margin, and pixels that are wrong altogether.
  void disturb(Image& image) {
    if (settings.noise <= 0.0 && settings.outliers <= 0.0) return;
    for (float& z : image.z) {
      z *= static_cast<float>(1.0 + random.real(-settings.noise, settings.noise));
      if (random.chance(settings.outliers)) z = static_cast<float>(random.real(0.3, 10.0));
    }
  }

  void replace(Image& image) {
    if (images == Images::kTrue) return;
    if (images == Images::kShort) {
      for (float& z : image.z) z = static_cast<double>(z) < Flown::spec_of(settings).range ? z : 0.0f;
      image.view.no_return = settings.no_return;
      return;
    }
    haunted = true;
    const double depth =
        images == Images::kBlind ? 0.0 : (images == Images::kNear ? image.view.min : 0.99 * image.view.max);
    std::fill(image.z.begin(), image.z.end(), static_cast<float>(depth));
  }

  void turn() {
    if (follows_yaw) {
      yaw = flight.yaw(time + spec.tick).angle;
      return;
    }
    const tern::Command command = flight.command(time);
    const double x = command.look_at.x - command.sample.position.x;
    const double y = command.look_at.y - command.sample.position.y;
    if (std::hypot(x, y) < 0.4) return;
    const double off = std::remainder(std::atan2(y, x) - yaw, 2.0 * M_PI);
    yaw += std::min(0.025, std::max(-0.025, off));
  }

  void check_joint(const tern::Command& before, const tern::Command& after) {
    const auto near = [](const tern::Vec3& a, const tern::Vec3& b, double most) {
      EXPECT_NEAR(a.x, b.x, most);
      EXPECT_NEAR(a.y, b.y, most);
      EXPECT_NEAR(a.z, b.z, most);
    };
    near(before.sample.position, after.sample.position, 1e-11);
    near(before.sample.velocity, after.sample.velocity, 1e-9);
    near(before.sample.acceleration, after.sample.acceleration, 1e-7);
    near(before.sample.jerk, after.sample.jerk, 1e-4);
  }

  void check_now() {
    EXPECT_LE(report.work, spec.work_per_tick);
    const tern::Sample now = flight.command(time).sample;
    const double wider = 1.0 + 1e-6;
    EXPECT_LE(std::hypot(now.velocity.x, now.velocity.y), wider * spec.limits.v_horizontal);
    EXPECT_LE(std::abs(now.velocity.z), wider * spec.limits.v_max.z);
    EXPECT_LE(std::hypot(now.acceleration.x, now.acceleration.y), wider * spec.limits.a_horizontal);
    EXPECT_LE(std::abs(now.acceleration.z), wider * spec.limits.a_max.z);
    if (settings.jerk > 0.0) {
      EXPECT_LE(std::max({std::abs(now.jerk.x), std::abs(now.jerk.y), std::abs(now.jerk.z)}), wider * settings.jerk);
    }
    const tern::Vec3 p = truth();
    const double clearance = scene.clearance(p, ground_below(p) < -1e8);
    least_clearance = std::min(least_clearance, clearance);
    if (may_touch) return;
    ASSERT_GE(clearance, settings.body) << "contact at t = " << 1e-9 * static_cast<double>(time);
  }

  /// All that is committed from now on: clear on the safe grid, inside the window, and at rest in the end.
  void check_ahead() {
    // With wrong pixels, the vehicle may be leaving a place that one of them blocked.
    if (!owned.map.safe().bound() || settings.outliers > 0.0 || haunted || may_touch) return;
    unchecked = 0;
    const tern::Vec3 end = flight.rest_position();
    std::int64_t t = time;
    for (int k = 0; k < 1000; ++k, t += 20000000) {
      const tern::Sample sample = flight.command(t).sample;
      ASSERT_GE(solid_distance(sample.position), settings.radius - 1e-7) << "at " << 1e-9 * static_cast<double>(t);
      const tern::Vec3 away{sample.position.x - end.x, sample.position.y - end.y, sample.position.z - end.z};
      const double speed = std::hypot(sample.velocity.x, std::hypot(sample.velocity.y, sample.velocity.z));
      if (speed == 0.0 && std::hypot(away.x, std::hypot(away.y, away.z)) < 1e-12) return;
    }
    FAIL() << "the committed plan does not end at rest";
  }

  void hash_command() {
    const tern::Sample sample = flight.command(time).sample;
    unsigned char bytes[sizeof sample];
    std::memcpy(bytes, &sample, sizeof sample);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001B3u;
  }

  LevelCamera shown;
  bool waiting = false;
  int unchecked = 0;  ///< ticks since check_ahead()
  bool haunted = false;
  int arrives = 0;
};

}  // namespace tern_test

#endif
