// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An autopilot that speaks MAVLink, over a simulated vehicle: what PX4 and ArduPilot do about modes, time-outs and
// setpoints (docs/integration). One cascade, in the manner of PX4's, flies for both.
#ifndef TERN_AUTOPILOT_SIMULATED_AUTOPILOT_HPP
#define TERN_AUTOPILOT_SIMULATED_AUTOPILOT_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "companion/frame.hpp"
#include "companion/mode_rules.hpp"
#include "host/vehicle/vehicle.hpp"

namespace tern_autopilot {

struct AutopilotSettings {
  bool is_px4 = true;
  double loss_time = 1.0;     ///< PX4's COM_OF_LOSS_T, s
  double guided_timeout = 3;  ///< ArduPilot's GUID_TIMEOUT, s
  std::uint8_t system = 1;
};

/// What became of the companion's messages.
struct AutopilotCounts {
  std::uint64_t setpoints = 0;   ///< that came
  std::uint64_t followed = 0;    ///< of them, in the mode in which they are
  std::uint64_t refused = 0;     ///< of another frame, as forces, or not of numbers
  std::uint64_t heartbeats = 0;  ///< of the companion
  std::uint64_t failsafes = 0;   ///< the stream ended in its mode
  double longest_gap = 0.0;      ///< between two setpoints that were followed, s
  double largest_step = 0.0;     ///< from one followed setpoint to where the one before led to, m
};

class SimulatedAutopilot {
 public:
  using Send = std::function<void(const std::vector<std::uint8_t>&)>;

  /// Hovers at `start`, disarmed and on the ground for all that it says, and holds its place.
  SimulatedAutopilot(const AutopilotSettings& settings, const tern_host::VehicleSettings& vehicle,
                     const tern::Vec3& start, double yaw, Send send);

  /// Bytes of the companion.
  void receive(const std::uint8_t* bytes, std::size_t count);
  /// Flies on to `t`, nanoseconds since boot.
  void fly_to(std::int64_t t);
  /// Says what is due.
  void report();
  /// For lockstep: a request of the companion's time, which carries `step`, and whether its answer has come since.
  std::vector<std::uint8_t> step_request(std::int64_t step);
  bool take_step_answer();

  void set_armed(bool armed) { armed_ = armed; }
  void set_in_air(bool in_air) { in_air_ = in_air; }
  /// No byte leaves it any more.
  void set_silent(bool silent) { silent_ = silent; }
  /// The pilot's switch: to the mode in which setpoints are followed, or away from it. False if it is refused.
  bool switch_to_companion();
  void switch_to_pilot();

  const tern_host::Vehicle& vehicle() const { return *vehicle_; }
  bool follows() const { return follows_; }
  const AutopilotCounts& counts() const { return counts_; }
  /// The last setpoint that was taken, in east, north, up; without one, the place that it holds.
  tern_host::Setpoint target(double t) const;
  const std::vector<tern_companion::StatusText>& texts() const { return texts_; }

 private:
  template <class Message>
  void send(const Message& message) {
    if (!silent_) send_(tern_companion::pack(sender_, message));
  }
  void take(const tern_companion::Frame& frame);
  void take(const tern_companion::SetPositionTarget& target);
  void take(const tern_companion::CommandLong& command);
  bool sets_mode(const tern_companion::CommandLong& command);
  void watch_stream();
  bool is_due(std::uint32_t message, double default_hz);
  void hold_here();
  double seconds() const { return 1e-9 * static_cast<double>(time_); }

  AutopilotSettings settings_;
  const tern_companion::ModeRules& rules_;
  std::unique_ptr<tern_host::Vehicle> vehicle_;
  tern_host::PoseJumps jumps_;
  Send send_;
  tern_companion::Sender sender_;
  tern_companion::FrameReader reader_;
  std::map<std::uint32_t, double> periods_;  // s, of the messages that were asked for
  std::map<std::uint32_t, double> due_;
  std::int64_t time_ = 0, step_ = 0;
  bool step_done_ = false;
  bool armed_ = false, in_air_ = false, silent_ = false, follows_ = false;
  std::optional<tern_companion::SetPositionTarget> last_;  // that was followed
  double last_at_ = -1e9, stream_since_ = 0.0, followed_at_ = 0.0;
  tern_host::Setpoint hold_{};
  AutopilotCounts counts_;
  std::vector<tern_companion::StatusText> texts_;
};

}  // namespace tern_autopilot

#endif
