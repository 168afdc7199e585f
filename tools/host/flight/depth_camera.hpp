// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_DEPTH_CAMERA_HPP
#define TERN_HOST_FLIGHT_DEPTH_CAMERA_HPP

#include <cstdint>
#include <random>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "tern/map.hpp"

namespace tern_host {

/// Uniform numbers that are the same on every platform.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : engine_(seed) {}
  double within(double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(engine_() >> 11) * (1.0 / 9007199254740992.0));
  }
  bool chance(double part) { return within(0.0, 1.0) < part; }

 private:
  std::mt19937_64 engine_;
};

/// One image, with the pose that it was taken at. The view points into `depths`.
struct DepthFrame {
  std::vector<float> depths;
  tern::DepthView view{};
  tern::Pose pose{};
  std::int64_t taken = 0;
};

/// What a level camera at `eye` sees that looks along `yaw`, with noise and outliers. A pixel has its centre's depth.
DepthFrame take_frame(const FlightWorld& world, const tern::Vec3& eye, double yaw, std::int64_t t, Noise& noise);

}  // namespace tern_host

#endif
