// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Looks for contacts with things that move, at every instant, and holds the flight to its promise: while the vehicle
// moves, it touches no thing that stays in the tube that it had when the committed plan was proven. It shares no code
// with what plans and proves.
#ifndef TERN_HOST_THINGS_THING_WATCH_HPP
#define TERN_HOST_THINGS_THING_WATCH_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/things/detector.hpp"
#include "host/things/thing_motion.hpp"

namespace tern_host {

/// The body began to touch a thing.
struct ThingContact {
  std::size_t thing;
  double time;     ///< s
  double speed;    ///< of the command, m/s
  bool in_motion;  ///< rather than at rest
  bool in_tube;    ///< the thing was where the proof of what was flown allowed it to be
};

/// True if a thing at `place` at time t, ns, is in both tubes of a track: all of it, whatever shape the track has.
bool is_in_tube(const tern::Track& track, const Thing& thing, const tern::Vec3& place, std::int64_t t);

/// The vehicle: a ball.
struct MovingBody {
  tern::Vec3 position;
  double speed;         ///< m/s
  double acceleration;  ///< m/s^2, at most
  double radius;        ///< m
};

class ThingWatch {
 public:
  /// Both must outlive the watch.
  ThingWatch(const std::vector<Thing>& things, const std::vector<ThingMotion>& motions);

  /// A plan was committed, proven or not, when `detector` had told the flight what it knows now.
  void note_commit(bool proven, const Detector& detector);
  /// When to look again: from where body and things are, none can touch the body before. `end` at the latest.
  std::int64_t next(std::int64_t t, std::int64_t end) const;
  /// Looks at all things that are due. `command_speed`: m/s.
  void look(std::int64_t t, const MovingBody& body, double command_speed);

  const std::vector<ThingContact>& contacts() const { return contacts_; }
  /// The first contact in motion; null while there is none.
  const ThingContact* in_motion() const;

 private:
  void begin_contact(std::size_t thing, std::int64_t t, const tern::Vec3& place, double command_speed);

  const std::vector<Thing>& things_;
  const std::vector<ThingMotion>& motions_;
  std::vector<std::int64_t> due_;
  std::vector<bool> touches_;
  std::vector<std::optional<tern::Track>> proven_with_;  ///< empty where a thing was not known
  bool is_proven_ = true;
  std::vector<ThingContact> contacts_;
};

}  // namespace tern_host

#endif
