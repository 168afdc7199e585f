// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Evasions: brakes that begin a few ticks ahead, because something came into the way, the user says stop, or the
// vehicle strays and is to fly slower.
#ifndef TERN_FLIGHT_EVASION_HPP
#define TERN_FLIGHT_EVASION_HPP

#include <cstdint>

#include "flight/branch.hpp"
#include "flight/draft.hpp"
#include "flight/flight_facts.hpp"
#include "flight/watch.hpp"

namespace tern {

/// The fewest ticks from the start of an evasion to its brake. They double after every second evasion that skipped
/// ticks made late, and after every evasion that had no time to judge a brake.
constexpr int kEvadeTicks = 3;
/// Units to prove that the committed plan touches at most the alarm, and to judge the sharpest brake. They must fit
/// into the ticks after the first, beside the share that the yaw takes of each tick.
constexpr std::uint32_t kEvadeWork = 900;

/// Which property of a brake is being proven.
enum class BrakeProof : std::uint8_t {
  kClear,   ///< it is clear and keeps the limits: it may be flown
  kLimits,  ///< it is not clear, but keeps the limits after its contact as well
  kAlarm,   ///< it is clear of everything but the alarm
};

/// A brake that is not proven clear, and its contact.
struct JudgedBrake {
  int number;    ///< negative: none
  double until;  ///< seconds since its beginning: until then it is clear
  double speed;  ///< m/s, at that time
  bool known;    ///< clear of everything but the alarm
};

/// True if the brake, from this takeover on, is better than the committed plan, although it is not proven.
bool helps(const JudgedBrake& brake, const FlightFacts& flight, const Watch& watch, std::int64_t takeover) noexcept;

/// What an evasion is about to do.
enum class EvasionResult : std::uint8_t {
  kProving,  ///< prove a brake, or another property of it
  kProven,   ///< commit the draft, which is a proven brake
  kOver,     ///< end: all brakes were tried
};

struct Evasion {
  bool is_running;
  bool stop_asked;    ///< a stop was asked for, and its brake is not made yet
  bool serves_stop;   ///< the current evasion serves a stop
  bool slow_asked;    ///< the vehicle is to fly slower, and no brake is made for that yet
  bool slows;         ///< the current evasion serves nothing else
  bool was_tried;     ///< an evasion of the threat was tried on this map
  int missed;         ///< evasions in a row that were too late; one that judged no brake counts twice
  int number;         ///< of the brake that is being judged
  int straight;       ///< brakes straight ahead that were tried
  int along;          ///< brakes along the committed plan that were tried
  JudgedBrake tried;  ///< the brake that is being judged
  JudgedBrake best;   ///< the best brake of those that were judged
  BrakeProof proves;  ///< the property of `tried` that the draft's proof is about

  void ask_for_stop() noexcept { stop_asked = true; }
  void forget_stop() noexcept { stop_asked = false; }
  /// Brakes for nothing but threats: any other needs a clearance.
  void forget_wishes() noexcept { stop_asked = slow_asked = false; }
  void ask_to_slow() noexcept { slow_asked = true; }
  /// The threat is gone or new: brakes may be tried again.
  void note_news() noexcept { was_tried = false; }
  /// Begins the draft of a brake. False if no brake is needed, or none may begin now.
  bool begin(const FlightFacts& flight, const Watch& watch, Draft& draft) noexcept;
  /// Tries all brakes from the first one on: begins to prove the next one that can be made. kProving or kOver.
  EvasionResult try_brakes(const FlightFacts& flight, const Watch& watch, Draft& draft, Work& work) noexcept;
  EvasionResult try_next(const FlightFacts& flight, const Watch& watch, Draft& draft, Work& work) noexcept;
  /// Judges the brake by the draft's proof, which is done.
  EvasionResult judge(const FlightFacts& flight, const Watch& watch, Draft& draft, Work& work) noexcept;
  /// Ends an evasion that has proven no brake. True if the draft is a brake that is better than the committed plan all
  /// the same.
  bool end(const FlightFacts& flight, const Watch& watch, Draft& draft, Work& work) noexcept;
  /// The evasion was not done in time, for example because ticks were skipped. It is tried again, unless there is a new
  /// goal and no threat.
  void miss(bool has_goal) noexcept;
  void leave() noexcept { is_running = false; }

  /// True if an evasion is to begin, beside a pending plan with this takeover if there is one. The pending plan may go
  /// on if it leaves time to brake. No evasion begins while the committed plan is being proven, or the map slides.
  bool is_called_for(const FlightFacts& flight, const Watch& watch, bool has_pending,
                     std::int64_t takeover) const noexcept;
  /// Ticks until the brake of an evasion begins.
  std::int64_t ticks(const FlightSpec& spec) const noexcept { return ticks_after(missed, spec); }
  /// The same, if so many evasions in a row were missed.
  static std::int64_t ticks_after(int missed, const FlightSpec& spec) noexcept;
  /// True if a plan with this takeover may go on under a threat because there is time left to brake if it fails.
  bool leaves_time(const FlightFacts& flight, const Watch& watch, std::int64_t takeover) const noexcept;

  bool begin_brake_proof(BrakeProof what, const FlightFacts& flight, const Watch& watch, Draft& draft) noexcept;
  int number_of_next() noexcept;

 private:
  bool go_on_proving(const FlightFacts& flight, const Watch& watch, Draft& draft) noexcept;
};

}  // namespace tern

#endif
