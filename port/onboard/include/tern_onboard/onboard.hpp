// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight on a vehicle's computer: poses, frames and wishes go in from any thread, setpoints come out. No thread of
// its own, no clock, no ROS, no MAVLink.
#ifndef TERN_ONBOARD_ONBOARD_HPP
#define TERN_ONBOARD_ONBOARD_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "tern/flight.hpp"
#include "tern_onboard/latency.hpp"
#include "tern_onboard/notices.hpp"
#include "tern_onboard/poses.hpp"
#include "tern_onboard/progress.hpp"
#include "tern_onboard/recording.hpp"
#include "tern_onboard/sensors.hpp"
#include "tern_onboard/settings.hpp"
#include "tern_onboard/things.hpp"
#include "tern_onboard/wish.hpp"

namespace tern_onboard {

enum class State : std::uint8_t {
  kNoPose = 0,  ///< no pose, or none for too long: nothing can be flown
  kReady,       ///< poses come; begin() or a goal begins the flight
  kFlying,      ///< a flight is under way, at rest or in motion
  kLost,        ///< the flight ended because the vehicle left it; a new goal begins another one
};
const char* state_name(State state);

/// What to fly at one time, for an autopilot: in the world frame of the poses that came in, z up.
struct Setpoint {
  std::int64_t time;
  bool valid;  ///< false: there was no pose yet, and all else is 0; send nothing
  tern::Vec3 position, velocity, acceleration, jerk;
  double yaw;       ///< rad, counter-clockwise from x of the world; it counts whole turns
  double yaw_rate;  ///< rad/s
  tern::Vec3 look_at;
};

struct Status {
  State state = State::kNoPose;
  tern::FlightReport report{};  ///< of the last tick
  std::int64_t pose_age = 0;    ///< nanoseconds; negative: none came yet
  double stray = 0.0;           ///< how far the estimate is off the command, m
  double stray_max = 0.0;       ///< since the flight began
  tern::Vec3 offset{};          ///< sum of the estimate's jumps since the flight began, m
  std::uint64_t ticks = 0, ticks_skipped = 0;
  std::array<std::uint64_t, kFaults> faults{};  ///< how often each was
  std::size_t things = 0;                       ///< that move and are known
  std::vector<SensorState> sensors;
};

/// "fly: on the way", "rest: it rests at the goal" and so on, with what is in the way.
std::string describe(const Status& status);

/// The answer to a wish.
struct Answer {
  bool ok;
  std::string text;  ///< what was refused, why, and what to do; or what will happen
};

/// Safe to be called from several threads: one mutex guards everything. A call waits for a tick at most, some
/// milliseconds. All large memory is allocated when it is made.
///
/// **Times** are nanoseconds of one clock, which the caller chooses and passes as `now`: stamps of poses and frames
/// must be of that clock. If a driver stamps with another one, map it (SensorSettings::time_offset, MAVLink's TIMESYNC)
/// before it comes here. A clock that goes back is taken as it is: the flight goes on from the command that was due.
///
/// **Frames.** Poses, goals and setpoints are in the world frame of the estimator, z up. If the estimate jumps, the
/// flight goes on around it (Poses); a goal then stays at its numbers.
class Onboard {
 public:
  /// Throws std::invalid_argument with the parameter that is wrong. `detector`: what finds things that move in the
  /// frames of sensors, as tern_tracker::detector_of(settings) does; null: nothing.
  explicit Onboard(const Settings& settings, std::unique_ptr<Detector> detector = nullptr);
  Onboard(const Onboard&) = delete;
  Onboard& operator=(const Onboard&) = delete;

  /// Adds a sensor before the first frame; returns its index.
  int add_sensor(const SensorSpec& spec);
  /// As those of Sensors. Answer::ok is false if the numbers are no lens or pose.
  Answer set_lens(int sensor, const Lens& lens);
  Answer set_mounting(int sensor, const tern::Pose& in_body);
  void add_frame(int sensor, const DepthImage& image, std::int64_t now);
  void add_frame(int sensor, const PointScan& scan, std::int64_t now);
  /// As Poses::add().
  void add_pose(const StampedPose& pose, std::int64_t now, std::uint32_t resets = 0);
  /// Obstacles that are known, world frame. They are marked when a flight begins, and at once in one that is under way.
  /// What leaves the map's window is forgotten. For a world that is known as a whole, let the window hold all of it
  /// and free_radius reach around it, and set stale_after to 0.
  void add_known_points(const std::vector<tern::Vec3>& points);
  /// Something that moves was sighted. Flights keep clear of it (docs/flight.md), those that begin later, too.
  void add_sighting(const Sighting& sighting, std::int64_t now);
  /// The body's pose at `stamp`, for what was seen from it then, in the frame of the poses that came in. If all poses
  /// are older, but by no more than pose_gap, it is the newest one, and `late` says by how many seconds; else that is
  /// 0. False if there is none.
  bool body_at(std::int64_t stamp, tern::Pose& pose, double& late) const;

  /// Begins a flight at rest at the last pose. set_goal() and set_mission() do so themselves if there is none.
  Answer begin(std::int64_t now);
  /// Whether the autopilot follows the setpoints: it is armed, and in a mode that takes them. While it does not, there
  /// is no flight, and setpoints go with the estimate, so that the mode can be entered without a step. Once it does,
  /// they stay where the vehicle was then. Without this call, a flight may begin at any time, and setpoints go with the
  /// estimate until then.
  void set_following(bool following);
  Answer set_goal(const tern::Vec3& goal, std::int64_t now);
  Answer set_mission(const std::vector<tern::Via>& points, tern::ViaPolicy policy, std::int64_t now);
  /// Comes to rest and forgets the goal.
  Answer stop();
  /// How to turn the nose, as the parameter `yaw`; `point` for kTowardsPoint, `heading` for kFixed, rad.
  Answer set_yaw(tern::FlightYawMode mode, const tern::Vec3& point, double heading);

  /// To be called at next_tick() or a little later: does the ticks that are due. Of more than two, all but the last two
  /// are skipped.
  void tick(std::int64_t now);
  /// When the next tick is due, nanoseconds; `now` plus a tick without a flight.
  std::int64_t next_tick(std::int64_t now) const;
  /// What to fly at time `now` or soon after it.
  Setpoint setpoint(std::int64_t now) const;
  /// Says that setpoint(now) has been sent, for frame_ages().
  void sent(std::int64_t now);
  FrameAges frame_ages() const;
  Status status(std::int64_t now) const;
  std::vector<Notice> take_notices();
  Settings settings() const { return settings_; }

  /// Records the flights that begin from now on (docs/record.md). Of what was not taken for so long that it exceeds
  /// `room` bytes, and of what then follows, nothing is recorded: a notice says so.
  void record_flights(std::size_t room = kRecordRoom);
  /// What was recorded since the last call; from any thread.
  std::vector<RecordPart> take_record();

  // For displays, in the frame of the poses that came in.

  /// The committed plan from `now` on: a point every `step` nanoseconds, at most `most` of them. Empty without a
  /// flight.
  std::vector<tern::Vec3> plan_points(std::int64_t now, std::int64_t step, std::size_t most) const;
  /// Centres of the voxels in which something was seen. False while the map cannot be read: try again after a tick.
  bool obstacles(std::vector<tern::Vec3>& centres) const;
  /// The polyhedra of the corridor of the last new plan that was committed; empty if there is none.
  std::vector<std::vector<tern::Halfspace>> corridor() const;

 private:
  struct Flown {
    std::int64_t time;
    tern::Vec3 position;
  };

  Answer begin_locked(std::int64_t now);
  Answer begin_at(const StampedPose& at, std::int64_t now);
  void one_tick(std::int64_t now);
  void add_locked(const Sighting& sighting, std::int64_t now);
  void record_tick(tern::Status answer);
  void watch_progress();
  void keep_corridor(const tern::FlightReport& before);
  void set_back(std::int64_t now);
  void mark_known();
  void watch_poses(std::int64_t now);
  void watch_stray(const StampedPose& pose, std::int64_t now);
  Setpoint setpoint_here() const;
  void hold_here();
  void lose(Fault fault, std::int64_t now, const std::string& text);
  tern::Vec3 commanded(std::int64_t t) const;
  Answer send_wish();
  tern::Status start_flight(const tern::Vec3& position, std::int64_t now, tern::FlightRefusal* refusal);
  void try_settings();

  Settings settings_;
  tern::MapSpec map_spec_{};
  tern::FlightSpec spec_{};
  tern::Halfspace planes_[2];
  tern::Fence fence_{};
  std::unique_ptr<tern::Workspace> workspace_;
  tern::Planner planner_;
  std::vector<std::uint64_t> map_words_, flight_words_;
  tern::RollingMap map_;
  tern::Flight flight_;

  mutable std::mutex mutex_;
  Poses poses_;
  std::unique_ptr<Detector> detector_;
  Sensors sensors_;
  Notices notices_;
  Recording recording_;
  Progress progress_;
  Things things_;
  Wish wish_;
  std::vector<tern::Vec3> known_points_;
  std::size_t known_marked_ = 0;
  std::array<Flown, 64> flown_{};
  std::size_t flown_count_ = 0;
  Status status_;
  Latency latency_;
  tern::Corridor corridor_{};  // of the last plan that was committed
  tern::Vec3 corridor_origin_{}, plan_origin_{};
  Setpoint hold_{};                // what to fly without a flight
  std::optional<bool> following_;  // nothing if nobody said
  bool pose_lost_ = false;
  std::int64_t pose_stamp_ = 0;  // of the last pose, or when the clock was set
  std::int64_t time_ = 0;        // of the last tick
};

}  // namespace tern_onboard

#endif
