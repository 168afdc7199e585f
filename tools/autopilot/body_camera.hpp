// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A depth camera that is fixed to the body and tilts with it.
#ifndef TERN_AUTOPILOT_BODY_CAMERA_HPP
#define TERN_AUTOPILOT_BODY_CAMERA_HPP

#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"
#include "tern/map.hpp"

namespace tern_autopilot {

/// Pixels, as tern::DepthView has them.
struct CameraLens {
  int width, height;
  double fx, fy, cx, cy;
};

/// The lens of a world's camera: its settings' size and fields of view.
CameraLens lens_of(const tern_host::FlightSettings& settings);

/// Depths along the optical axis, m, row by row, up to `far`. A pixel has the least depth at its four corners. That is
/// the nearest thing in all of its area, but for parts of things that are narrower than a pixel.
std::vector<float> take_image(const tern_host::FlightWorld& world, const tern::Pose& camera, const CameraLens& lens,
                              double far, tern_host::Noise& noise);

}  // namespace tern_autopilot

#endif
