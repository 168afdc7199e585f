// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proves the committed plan anew near voxels that became solid. A proof that ends early is a threat.
#ifndef TERN_FLIGHT_WATCH_HPP
#define TERN_FLIGHT_WATCH_HPP

#include <cstdint>

#include "flight/committed_plans.hpp"
#include "flight/flight_facts.hpp"
#include "tern/proof.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Something that is too near to the resting vehicle, but comes no nearer, is shown as a threat for this time,
/// nanoseconds.
constexpr std::int64_t kThreatShown = 300000000;
/// Parts that are proven one after the other, at most.
constexpr int kWatchedParts = 4;

/// Which part of the committed plan is being proven.
enum class Watched : std::uint8_t {
  kBefore,  ///< the plan in flight, up to the takeover of the waiting plan
  kLatest,  ///< the latest committed plan, to its end
  kAlarm,   ///< the latest committed plan, without the obstacles of the alarm
};

/// What the end of a part shows.
enum class WatchResult : std::uint8_t {
  kOpen,      ///< nothing new, or another part is to be proven
  kNoThreat,  ///< the committed plan is proven
  kThreat,    ///< the committed plan is not proven
};

struct Watch {
  Proof proof;
  bool is_running;
  Watched part;
  bool has_added;           ///< the proof covers only what is near `added`
  bool covers_all;          ///< the next proof covers all of the plan, not only what is near `added`
  Box added;                ///< around the voxels that became solid since the last proof
  std::uint64_t revision;   ///< the safe grid's when the last proof began
  bool threat;              ///< the committed plan is not proven
  bool alarmed;             ///< a threat was found in this tick
  std::int64_t alarm_time;  ///< of the last tick with `alarmed`
  double beside;            ///< at rest under a threat: how near the nearest thing was, metres
  Contact contact;          ///< of the threat, on the committed plan when it was found
  bool meets_before;        ///< the plan in flight is not proven up to the takeover of the waiting plan
  Contact before;           ///< the contact up to that takeover; any contact of the waiting plan is later
  bool has_alarm;
  Alarm alarm;  ///< the voxels that became solid since the committed plan was proven
  bool known;   ///< the committed plan is clear of everything but the alarm

  void begin_tick() noexcept { alarmed = false; }
  /// Begins a proof, if there is anything to prove. Takes what was added to the map since the last call.
  void begin(const FlightFacts& flight, RollingMap& map) noexcept;
  void prove(const FlightFacts& flight, Watched which) noexcept;
  /// A thing that moves is not where a committed plan takes it to be: the next proof covers all of the plans.
  void prove_all() noexcept;
  /// Ends the proof of a part, and begins that of the next one.
  WatchResult end_part(const FlightFacts& flight) noexcept;
  /// Notes a threat. `nearest`: how near anything is to the resting vehicle; kAnywhere if it does not rest.
  void note_threat(const FlightFacts& flight, double nearest) noexcept;
  /// Goes on after a threat. `dropped`: the waiting plan was dropped. Without it, the flight may still be proven.
  void go_on(const FlightFacts& flight, bool dropped) noexcept;
  /// `nearest`: how near anything is to the resting vehicle, which may have come to rest after the threat was found.
  void note_beside(double nearest) noexcept { beside = nearest; }
  /// The waiting plan was dropped, and with it the contact before its takeover.
  void forget_before() noexcept { meets_before = false; }
  void note_takeover() noexcept;
  /// A draft with this takeover is committed. A contact before the takeover remains.
  void note_commit(bool extends, std::int64_t takeover) noexcept;
  /// The committed draft is a brake with this contact. `alarm_stays`: the alarm was there before the commit.
  void note_unproven_brake(const Contact& of_brake, bool is_known, bool alarm_stays) noexcept;

  bool is_running_but_for_alarm() const noexcept { return is_running && part != Watched::kAlarm; }
  /// Something is nearer to the resting vehicle than the radius.
  bool is_beside(const FlightFacts& flight) const noexcept { return threat && flight.rests(); }
  /// There is something beside the resting vehicle, and note_beside() is yet to say how near.
  bool lacks_beside(const FlightFacts& flight) const noexcept { return is_beside(flight) && !(beside < kAnywhere); }
  /// The threat is to be shown. At rest, something that is too near but comes no nearer is shown only for
  /// kThreatShown: the flight can only leave, or say why not.
  bool shows_threat(const FlightFacts& flight) const noexcept;
  const Contact& first_contact() const noexcept { return meets_before ? before : contact; }

 private:
  const Commitment& watched(const CommittedPlans& plans) const noexcept {
    return part == Watched::kBefore ? plans.in_flight : plans.latest();
  }
  Contact contact_on(const Commitment& plan) const noexcept;
};

}  // namespace tern

#endif
