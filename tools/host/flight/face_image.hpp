// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a camera sees that may look anywhere. Every thing is drawn face by face.
#ifndef TERN_HOST_FLIGHT_FACE_IMAGE_HPP
#define TERN_HOST_FLIGHT_FACE_IMAGE_HPP

#include <vector>

#include "host/flight/flight_world.hpp"
#include "tern/map.hpp"

namespace tern_host {

/// Depths along the optical axis, metres, row by row: of the nearest point of any thing, or of the boundary's faces,
/// that lies in a pixel's area, but `far` at most. `part`: the share of a pixel's width and height, around its middle,
/// that it sees; 1 is all of it. Things nearer than a centimetre are not seen, and a cylinder counts as the upright
/// prism around it, up to two millimetres wider.
std::vector<double> depths_of_faces(const FlightWorld& world, const tern::Pose& camera, const tern::DepthView& view,
                                    double far, double part);

}  // namespace tern_host

#endif
