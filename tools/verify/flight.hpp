// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The committed plans of a flight and what was flown of them, held against the true world.
#ifndef TERN_VERIFY_FLIGHT_HPP
#define TERN_VERIFY_FLIGHT_HPP

#include <optional>
#include <string>
#include <vector>

#include "verify/claim.hpp"
#include "verify/plan.hpp"
#include "verify/world.hpp"

namespace tern_verify {

/// Times are seconds since the flight's beginning.
struct Commit {
  Rational time;                      ///< of the tick that committed it
  Rational begin;                     ///< of the first segment
  std::optional<Rational> withdrawn;  ///< of the tick that dropped it before it began
  Point origin;
  std::vector<Segment> segments;  ///< their polyhedra mean nothing

  /// When it would be flown from: where it begins, or if it extends the plan before, where it is committed.
  Rational takeover() const { return begin > time ? begin : time; }
};

/// The vehicle at each tick, the first at time 0. World frame.
struct Track {
  Rational tick;                 ///< seconds
  std::vector<Point> commanded;  ///< where it was told to be,
  std::vector<Point> believed;   ///< where it believed to be,
  std::vector<Point> real;       ///< and where it was

  Rational end() const { return tick * (commanded.size() - 1); }
};

struct Flight {
  std::string name;
  World world;                         ///< that the log says
  std::string world_name;              ///< likewise
  bool is_world_given;                 ///< it was compared with one from elsewhere
  bool reached;                        ///< by its status, the vehicle rests at the goal
  Rational tracking_error, clearance;  ///< the largest and the least that the log says
  std::vector<Commit> commits;
  Track track;
};

/// Reads a log of `tern fly --json --commits` ("tern-flight/1", docs/formats.md). Throws InputError.
Flight parse_flight(const std::string& text, const std::string& name);

/// True for a text that is a log of a flight rather than a plan.
bool is_flight(const std::string& text);

/// Compares the world and the settings with those of a world from elsewhere. Throws InputError where they differ.
void compare(const World& world, const std::string& name, Flight& flight);

/// One claim a kind, that of the commit or the tick with the least room. Throws InputError where the log's own figures
/// are better than its track.
Claims prove(const Flight& flight);

/// What no proof covers and a reader must know, one text each.
std::vector<std::string> assumed_of(const Flight& flight);

}  // namespace tern_verify

#endif
