// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_DEPTH_CAMERA_HPP
#define TERN_HOST_FLIGHT_DEPTH_CAMERA_HPP

#include <cstdint>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"
#include "tern/map.hpp"

namespace tern_host {

/// One image, with the pose that it was taken at. The view points into `depths`.
struct DepthFrame {
  std::vector<float> depths;
  tern::DepthView view{};
  tern::Pose pose{};
  std::int64_t taken = 0;
};

/// Size, focal lengths and principal point of the settings' camera, and what it can measure; without an image.
tern::DepthView lens_of(const FlightSettings& settings);

/// What a level camera at `eye` sees that looks along `yaw`, with its errors. A pixel has the depth of the nearest
/// thing in its whole area, as the map demands.
DepthFrame take_frame(const FlightWorld& world, const tern::Vec3& eye, double yaw, std::int64_t t, Noise& noise);

/// The same of a camera with any pose, whose pixels see `pixel_part` of their area.
DepthFrame take_frame(const FlightWorld& world, const tern::Pose& camera, std::int64_t t, Noise& noise);

}  // namespace tern_host

#endif
