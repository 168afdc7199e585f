// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A curve less a thing's curve, and the distance from the thing's shape that it needs: eight control points of four
// numbers each, three for the place and one for the distance. Whether a plane keeps the one off the other.
#ifndef TERN_PROVE_TRACK_TUBE_HPP
#define TERN_PROVE_TRACK_TUBE_HPP

#include <cstdint>

#include "prove/track_motion.hpp"
#include "prove/track_shape.hpp"
#include "tern/grid.hpp"
#include "tern/track.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Metres that rounding may add up to if the numbers are of this size. It is counted against the proof: each of the
/// four cuts takes 21 half units in the last place, the places of the cuts 98 and 14, and everything else 30.
double rounding_of_size(double size) noexcept;

/// The tube of a curve around a thing. Returns the rounding, metres, without that of the shape.
double make_tube(const Vec3* points, const ThingMotion& motion, double distance, double (*tube)[4]) noexcept;

/// The thing rests at `place`, and its error grows evenly.
void hold(const Vec3& place, double error, double growth, ThingMotion& motion) noexcept;

/// The same curve in a tube of a width of its own.
void widen(const double (*from)[4], double width, double growth, double (*tube)[4]) noexcept;

/// The part of the tube that is the piece `number` of 2^depth equal ones.
void take_dyadic_part(const double (*tube)[4], std::int32_t number, std::int32_t depth, double (*part)[4]) noexcept;

/// True only if the curve keeps the distance, because the plane through the shape's point nearest to the curve's middle
/// parts them.
bool plane_keeps_off(const Track& track, const double (*tube)[4], double slack) noexcept;
/// The same with planes across the axes.
bool axis_keeps_off(const Track& track, const double (*tube)[4], double slack) noexcept;

/// The distance of a point of the curve from the shape. A ball counts as its centre.
double gap_of(const Track& track, const double* point) noexcept;
/// True if a point of the curve is nearer to the shape than it needs to be.
bool touches(const Track& track, const double* point) noexcept;

/// True only if everything within `reach` of the shape along the motion is outside the box.
bool are_apart(const Track& track, const ThingMotion& motion, double reach, const Box& box) noexcept;

}  // namespace tern

#endif
