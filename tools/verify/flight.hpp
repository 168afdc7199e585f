// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The committed plans of a flight, held against the true world.
#ifndef TERN_VERIFY_FLIGHT_HPP
#define TERN_VERIFY_FLIGHT_HPP

#include <string>
#include <vector>

#include "verify/claim.hpp"
#include "verify/nearest.hpp"
#include "verify/plan.hpp"

namespace tern_verify {

struct Commit {
  Rational time;   ///< seconds, of the tick that committed it
  Rational begin;  ///< seconds, of the first segment
  bool evades;     ///< under a threat: it may come near to something
  bool leaves;     ///< it begins too near to something
  Point origin;
  std::vector<Segment> segments;  ///< their polyhedra mean nothing
};

struct Flight {
  std::string name;
  Box boundary;
  std::vector<Solid> solids;  ///< blocks, cylinders and the walls around the boundary
  std::vector<Fence> fences;
  std::vector<Bound> bounds;
  Rational body;             ///< radius of the body
  Rational radius;           ///< body, pose error and tracking margin
  Rational tracking_margin;  ///< within which the vehicle is to follow its commands
  Rational tracking_error;   ///< the largest that the simulator saw
  Rational clearance;        ///< the least of the body's centre that the simulator saw
  Rational cell;
  std::vector<Commit> commits;
};

/// Reads a log of `tern fly --json --commits` ("tern-flight/1", docs/formats.md). Throws InputError.
Flight parse_flight(const std::string& text, const std::string& name);

/// True for a text that is a log of a flight rather than a plan.
bool is_flight(const std::string& text);

/// One claim a kind, that of the commit with the least room.
Claims prove(const Flight& flight);

}  // namespace tern_verify

#endif
