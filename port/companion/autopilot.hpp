// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The autopilot at the other end of the link: who it is, what it does, and where it believes to be.
#ifndef TERN_COMPANION_AUTOPILOT_HPP
#define TERN_COMPANION_AUTOPILOT_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "companion/clock_sync.hpp"
#include "companion/frame.hpp"
#include "companion/mode_rules.hpp"
#include "tern_onboard/pose.hpp"

namespace tern_companion {

/// Times are nanoseconds of the companion's clock; 0 is never.
struct AutopilotState {
  const ModeRules* rules = nullptr;  ///< null until a known autopilot was heard
  std::uint8_t system = 0;
  bool armed = false, in_mode = false, in_air = false;
  std::int64_t heartbeat_at = 0, estimate_at = 0;
  /// Grows with every reset of the estimate that the autopilot tells of, and with its restarts.
  std::uint32_t resets = 0;
  tern_onboard::StampedPose pose{};
  tern::Vec3 velocity{};     ///< m/s, east, north, up
  GpsGlobalOrigin origin{};  ///< of the local frame
  bool origin_known = false;
  /// ns: what the Unix clock of its satellite receiver showed at its boot; 0 if it has not said.
  std::int64_t unix_boot = 0;
};

class Autopilot {
 public:
  using Send = std::function<void(const std::vector<std::uint8_t>&)>;
  using Say = std::function<void(const std::string&)>;
  using TakePose = std::function<void(const AutopilotState&)>;

  /// `system`: of the autopilot that is meant; 0: the first one that is heard. `take_pose` is called with each new
  /// estimate.
  Autopilot(std::uint8_t system, Send send, Say say, TakePose take_pose);

  /// Takes a frame. True if it is a heartbeat of the autopilot: its sender is the one to answer.
  bool read(const Frame& frame, std::int64_t now);
  /// Sends what is due: the companion's own heartbeat, requests of times and of messages.
  void tick(std::int64_t now);
  /// Asks for the mode in which setpoints are followed.
  void ask_for_mode();
  /// Its request of the companion's time, if one waits for its answer.
  const std::optional<TimeSync>& time_request() const { return time_request_; }
  void answer_time(std::int64_t now);
  /// To the ground station's log, by way of the autopilot's link: 6 is information, 4 a warning (RFC 5424).
  void say_to_ground(std::uint8_t severity, const std::string& text);

  const AutopilotState& state() const { return state_; }
  const ClockSync& clock() const { return clock_; }
  /// The Unix time, ns, when the companion's clock shows `now`, as its satellite receiver has it; nothing if it has not
  /// said.
  std::optional<std::int64_t> unix_time(std::int64_t now) const;
  /// The identity and sequence number under which all frames are sent.
  Sender& sender() { return sender_; }

 private:
  template <class Message>
  void send(const Message& message) {
    send_(pack(sender_, message));
  }
  bool is_autopilot(const Frame& frame) const {
    return state_.rules != nullptr && frame.system == state_.system && frame.component == kAutopilotComponent;
  }
  bool take_heartbeat(const Frame& frame, std::int64_t now);
  void take_message(const Frame& frame, std::int64_t now);
  void take(const AttitudeQuaternion& attitude, std::int64_t now);
  void take(const LocalPositionNed& position);
  void take(const Odometry& odometry, std::int64_t now);
  void take(const CommandAck& ack);
  void note_boot_time(std::int64_t boot_ms);
  void publish(std::int64_t boot_ns, const std::array<float, 4>& q, std::int64_t now);
  void command(std::uint16_t number, float first, float second, float third = 0.0f);
  void request_next(std::int64_t now);

  Send send_;
  Say say_;
  TakePose take_pose_;
  Sender sender_;
  AutopilotState state_;
  ClockSync clock_;
  std::int64_t heartbeat_due_ = 0, time_due_ = 0, request_due_ = 0;
  std::size_t request_ = 0;  // of the list of messages that are asked for
  int tries_ = 0;
  std::int64_t boot_ms_ = 0;      // the latest that any message had
  std::int64_t position_ns_ = 0;  // time of position and velocity since boot; 0: none
  std::uint32_t clock_restarts_ = 0;
  std::uint8_t reset_counter_ = 0;
  bool any_odometry_ = false;
  std::optional<TimeSync> time_request_;
};

}  // namespace tern_companion

#endif
