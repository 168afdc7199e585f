// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A seeded flight of frames, scans, slides and things told, as a hash of all that the map held on the way. Firmware
// runs it, too.
#ifndef TERN_TESTS_SUPPORT_MAP_FLIGHT_HPP
#define TERN_TESTS_SUPPORT_MAP_FLIGHT_HPP

#include <cstddef>
#include <cstdint>

#include "support/map_noise.hpp"

namespace tern_test {

/// The hash that every compiler, optimisation level and platform must reach. It changes only with a deliberate change
/// of what a map makes of its frames.
constexpr std::uint64_t kMapFlightHash = 0x07d2d1e0c0dc768fu;

/// Storage of a flight.
struct MapFlight {
  static constexpr std::size_t kWords = 56 * 1024;
  static constexpr int kWidth = 48, kHeight = 36, kPoints = 4000;

  std::uint64_t words[kWords];
  float depths[kWidth * kHeight];
  tern::Vec3 points[kPoints];
};

inline tern::MapSpec map_flight_spec(const tern::Box (&prior)[2]) {
  tern::MapSpec spec = tern::map_spec({-6.4, -3.0, 0.0}, 0.1, {130, 60, 30}, 0.25);
  spec.range = 4.0;
  spec.angle_margin = 0.005;
  spec.hits = 2;
  spec.age = 700;
  spec.slack = 2;
  spec.scan_pixel = 0.05;
  spec.pixels = 6 * 50 * 50;
  spec.prior = prior;
  spec.prior_count = 2;
  return spec;
}

inline std::uint64_t map_flight_hash(MapFlight& flight, std::uint32_t slice) {
  Random random(331);
  const tern::Box prior[] = {{{3.0, -2.0, 0.0}, {3.5, 2.0, 2.5}}, {{-9.0, 1.0, 0.0}, {9.0, 1.2, 4.0}}};
  tern::RollingMap map;
  const tern::MapSpec spec = map_flight_spec(prior);
  std::uint64_t hash = static_cast<std::uint64_t>(map.bind(spec, flight.words, MapFlight::kWords));
  const auto add = [&](std::uint64_t number) { hash = (hash ^ number) * 0x100000001B3u; };
  const tern::DepthView view{nullptr,
                             flight.depths,
                             MapFlight::kWidth,
                             MapFlight::kHeight,
                             MapFlight::kWidth,
                             24.0,
                             24.0,
                             0.5 * (MapFlight::kWidth - 1),
                             0.5 * (MapFlight::kHeight - 1),
                             1.0,
                             0.1,
                             50.0,
                             0.0};
  tern::Vec3 eye{0.0, 0.0, 1.5};
  add(static_cast<std::uint64_t>(map.assume_free(eye, 0.8)));
  for (int k = 0; k < 24; ++k) {
    eye = {eye.x + random.real(0.0, 0.8), eye.y + random.real(-0.2, 0.3), eye.z + random.real(-0.1, 0.2)};
    add(static_cast<std::uint64_t>(map.follow(eye)));
    finish(map, slice);
    if (k % 4 == 3) {
      const double far = random.real(0.5, 5.0);
      for (tern::Vec3& p : flight.points) {
        p = {eye.x + far * random.real(-1, 1), eye.y + far * random.real(-1, 1), eye.z + far * random.real(-1, 1)};
      }
      add(static_cast<std::uint64_t>(map.begin_scan(flight.points, MapFlight::kPoints, eye, 30 * k)));
    } else {
      fill_randomly(random, flight.depths, MapFlight::kWidth, MapFlight::kHeight, spec.range);
      tern::Pose pose{eye, {}};
      random_quaternion(random, pose.quaternion);
      add(static_cast<std::uint64_t>(map.begin_frame(view, pose, 30 * k)));
    }
    finish(map, slice);
    add(hash_of(map));
  }
  return hash;
}

}  // namespace tern_test

#endif
