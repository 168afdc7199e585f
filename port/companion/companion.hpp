// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The companion: an autopilot on one side, sensors on the other, and a flight between them. It has no clock and no
// descriptors of its own, so that a simulation can run it at any speed.
#ifndef TERN_COMPANION_COMPANION_HPP
#define TERN_COMPANION_COMPANION_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "companion/autopilot.hpp"
#include "companion/engagement.hpp"
#include "companion/goals.hpp"
#include "companion/sensor_table.hpp"
#include "companion/traffic.hpp"
#include "tern_onboard/onboard.hpp"
#include "tern_onboard/record_files.hpp"

namespace tern_companion {

struct CompanionSettings {
  tern_onboard::Settings onboard;
  TrafficSettings traffic;         ///< how reports of other aircraft are read
  std::uint8_t system = 0;         ///< of the autopilot; 0: the first one that is heard
  std::vector<tern::Via> mission;  ///< its last point is the goal; empty: a ground station says where to
  std::string record;              ///< folder for the records of flights; empty: none
  bool asks_for_mode = false;      ///< it asks for the mode itself, once all is ready
  bool ends_at_goal = false;       ///< the program ends a second after the arrival
};

/// Times are nanoseconds of one clock, that of the stamps of depth.
class Companion {
 public:
  struct Outputs {
    std::function<void(const std::vector<std::uint8_t>&)> send;  ///< bytes for the autopilot
    std::function<void(const std::string&)> say;                 ///< lines for the log
  };

  /// Throws std::invalid_argument for settings that make no flight.
  Companion(const CompanionSettings& settings, Outputs outputs);

  /// Takes bytes of the link. True if a heartbeat of the autopilot was among them: their sender is the one to answer.
  bool read(const std::uint8_t* bytes, std::size_t count, std::int64_t now);
  /// The autopilot's request of the time, if it waits for its answer; in lockstep, its ts1 is the time to step to.
  const std::optional<TimeSync>& time_request() const { return autopilot_.time_request(); }
  void answer_time(std::int64_t now) { autopilot_.answer_time(now); }
  void take_depth(const tern_depth_header& header, const std::uint8_t* payload, std::int64_t now);
  /// Does what is due; to be called every few milliseconds.
  void tick(std::int64_t now);
  std::int64_t next_tick(std::int64_t now) const { return onboard_.next_tick(now); }
  /// Brings the vehicle to rest and ends.
  void end() { ending_ = true; }
  /// Set once the program is to end: its exit status.
  const std::optional<int>& outcome() const { return outcome_; }
  /// Writes what was recorded to the flight's file.
  void save();
  /// What was flown, and how old images were.
  std::string summary(std::int64_t now) const;

  Phase phase() const { return phase_; }
  const Autopilot& autopilot() const { return autopilot_; }
  const FrameCounts& frames() const { return reader_.counts(); }

 private:
  Facts facts(std::int64_t now);
  void enter(Phase phase, std::int64_t now);
  void steer(std::int64_t now);
  void begin(std::int64_t now);
  void relay_notices();
  void tell_of_map(const tern_onboard::Status& status);
  void send_setpoint(std::int64_t now);
  void judge(const tern_onboard::Status& status, std::int64_t now);
  void take_goal(const GoalMessage& message, const Frame& frame);
  void take_traffic(const Frame& frame, const LocalFrame* local, std::int64_t now);
  void say_once(const std::string& text);
  void warn_about_frames();

  CompanionSettings settings_;
  Outputs outputs_;
  Autopilot autopilot_;
  tern_onboard::Onboard onboard_;
  tern_onboard::RecordFiles record_;
  SensorTable sensors_;
  Traffic traffic_;
  FrameReader reader_;
  std::vector<tern::Via> mission_;  // what is to be flown
  Phase phase_ = Phase::kNoAutopilot;
  std::set<std::string> said_;
  std::optional<int> outcome_;
  std::int64_t frame_at_ = 0, moved_at_ = 0, setpoint_due_ = 0, retry_at_ = 0, arrived_at_ = 0, ended_at_ = 0,
               mode_due_ = 0, save_at_ = 0;
  bool begun_ = false, ending_ = false, paused_ = false, map_stale_ = false;
  bool new_goal_ = false;  // one came since the flight was given up
  std::uint64_t setpoints_ = 0;
};

}  // namespace tern_companion

#endif
