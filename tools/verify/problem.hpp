// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a scenario asks for, in exact numbers. The reader is the verifier's own (docs/verify.md).
#ifndef TERN_VERIFY_PROBLEM_HPP
#define TERN_VERIFY_PROBLEM_HPP

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "verify/exact.hpp"
#include "verify/map_files.hpp"
#include "verify/tracks.hpp"

namespace tern_verify {

/// A file that cannot be read as what it should be; what() names it, the line and the reason.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Box {
  Point lower, upper;
};

/// normal . p <= offset. The normal has any length but 0.
struct HalfSpace {
  Point normal;
  Rational offset;
};

/// When a fence for a while holds, and by how much its clock may be off; seconds.
struct Window {
  Rational from, until;
  Rational clock_error;
};

struct Fence {
  bool keep_in;
  std::vector<HalfSpace> planes;
  Rational distance = 0;                        ///< that the centre keeps from a keep-out, metres
  std::optional<Window> window = std::nullopt;  ///< none: it always holds
  std::string zone{};                           ///< its name; empty: none
};

/// Position and its derivatives up to the jerk.
using Motion = std::array<Point, 4>;
constexpr const char* kDerivativeNames[] = {"position", "velocity", "acceleration", "jerk"};
constexpr const char* kUnits[] = {"m", "m/s", "m/s2", "m/s3"};

struct Via {
  Point position;
  Rational tolerance;
  bool stop;
  std::optional<Point> velocity;
  Rational dwell;  ///< seconds at rest
};

// In place of an axis: the length of (x, y); the thrust, which is the acceleration plus gravity; the tangent of its
// tilt; its rate of turning.
constexpr int kHorizontal = 3;
constexpr int kThrust = 4;
constexpr int kTilt = 5;
constexpr int kTurn = 6;

/// A limit on one derivative (1 velocity to 3 jerk) along one axis and direction, on its horizontal norm, or on the
/// thrust that follows from it.
struct Bound {
  int derivative;
  int axis;
  int sign;  ///< 1, or -1 for the opposite direction
  Rational most;
};

/// Upper and lower limits of one derivative on each axis; a `least` of 0 is minus `most`, and a limit of 0 on the jerk
/// or on a horizontal norm is none.
void add_bounds(int derivative, const Point& most, const Point& least, const Rational& horizontal,
                std::vector<Bound>& bounds);

/// Limits of the vehicle; 0 is none.
struct VehicleLimits {
  Rational thrust_max, thrust_min, tilt_tangent, rate_max;
};
/// Adds them. They may raise the lower limit of the vertical acceleration, so they come after those of add_bounds.
void add_bounds(const VehicleLimits& limits, std::vector<Bound>& bounds);
/// As the core has it, in doubles.
Rational gravity();

/// World frame, metres, seconds.
struct Problem {
  std::string name;
  Box boundary;
  std::vector<Box> blocks;
  std::vector<CloudPoint> points;  ///< of all clouds
  std::vector<Octree> octrees;
  bool unknown_is_solid = false;  ///< what no octree says is free is an obstacle
  std::vector<Fence> fences;
  std::vector<Thing> things;    ///< that move
  std::size_t keepouts = 0;     ///< `keepout` records of the file
  std::vector<Rational> frame;  ///< latitude, longitude and height of the origin, those that the file says
  std::string epoch;            ///< when the clock is 0, in the file's words
  Rational start_time = 0;
  Rational rest_clear = 0;
  Motion start, goal;
  std::vector<Via> vias;
  std::vector<Bound> bounds;
  Rational cell;
  Rational radius;
  Rational tracking_margin;
  Rational clearance;         ///< radius and tracking margin; a nanometre or less is 0
  bool may_end_near = false;  ///< `goal_mode nearest`
};

/// Reads a scenario file (docs/formats.md) and its map files. Throws InputError.
Problem read_problem(const std::string& path);

/// A scenario as text; `name` is for messages, and map files are in its folder.
Problem parse_problem(const std::string& text, const std::string& name);

/// A whole file. Throws InputError.
std::string read_file(const std::string& path);

}  // namespace tern_verify

#endif
