// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "autopilot/companion_flight.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <utility>

#include "autopilot/body_sensors.hpp"
#include "host/flight/flight_recorder.hpp"
#include "host/flight/flight_specs.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/number.hpp"
#include "tern_onboard/pose.hpp"

namespace tern_autopilot {
namespace {

using namespace tern_companion;

constexpr std::int64_t kStep = 10000000;         // ns
constexpr int kLooks = 5;                        // at the clearance, in a step
constexpr std::int64_t kBootLater = 5000000000;  // the autopilot's clock began so long after the companion's
constexpr double kMostFree = 2.0;                // m, that is stated to be free around the start
constexpr double kHoverDrift = 0.1;              // m, around the start until the flight begins
constexpr std::int64_t kPatience = 20000000000;  // ns for the answer to a step

double distance(const tern::Vec3& a, const tern::Vec3& b) {
  return tern_onboard::length(tern_onboard::minus(a, b));
}

std::string point(const tern::Vec3& p) {
  return tern_host::fixed(p.x, 4) + "," + tern_host::fixed(p.y, 4) + "," + tern_host::fixed(p.z, 4);
}

/// A ball around the start that is free, apart from floor and ceiling, of which fences keep the vehicle away.
double free_radius_of(tern_host::FlightWorld world) {
  world.boundary.lower.z -= kMostFree;
  world.boundary.upper.z += kMostFree;
  return std::min(kMostFree, tern_host::clearance(world, world.start) - kHoverDrift);
}

/// Errors of a frame's attitude, rad: the autopilot's is true here, and only read between its messages.
constexpr double kAngleMargin = 0.005;

/// What an operator would set for this world.
std::vector<std::string> arguments_of(const tern_host::FlightWorld& world, const CompanionFlight& flight) {
  const tern_host::FlightSettings& s = world.settings;
  std::vector<std::string> words;
  if (!flight.goal_by_link) words = {"--goal", point(world.goal), "--end-at-goal"};
  const auto set = [&words](const std::string& name, double value) {
    words.insert(words.end(), {"--set", name + "=" + tern_host::fixed(value, 4)});
  };
  set("cell", s.cell);
  set("radius", s.body_radius + s.pose_margin);
  set("tracking_margin", s.tracking_margin);
  set("range", s.sensor_range);
  set("horizon", 0.8 * s.sensor_range);
  set("depth_margin", s.depth_margin + s.depth_noise * s.sensor_range);
  set("pose_margin", s.pose_margin);
  set("angle_margin", kAngleMargin);
  set("free_radius", free_radius_of(world));
  set("ground", world.boundary.lower.z);
  set("ceiling", world.boundary.upper.z - s.body_radius - s.pose_margin - s.tracking_margin);
  const bool sees_all_around = flight.sensors == "lidar" || flight.sensors == "both";
  set("field_of_view", sees_all_around ? 0.0 : s.fov_horizontal);
  set("scan_pixel", s.scan_pixel);
  set("speed", s.v_max);
  set("acceleration", s.a_max);
  set("acceleration_z", s.a_max);
  set("jerk", s.j_max);
  if (!flight.real_time) words.emplace_back("--lockstep");
  words.insert(words.end(), flight.arguments.begin(), flight.arguments.end());
  return words;
}

tern_host::VehicleSettings vehicle_of(const tern_host::FlightSettings& s) {
  tern_host::VehicleSettings vehicle = tern_host::vehicle_settings_of(s);
  vehicle.kind = "px4";
  vehicle.pose_margin = 0.0;
  vehicle.tick = 1e-9 * static_cast<double>(kStep);
  return vehicle;
}

std::int64_t monotonic() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1000000000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec;
}

class Simulation {
 public:
  Simulation(const tern_host::FlightWorld& world, const CompanionFlight& flight)
      : world_(world),
        flight_(flight),
        noise_(world.settings.seed),
        companion_(flight.program, arguments_of(world, flight)),
        autopilot_(flight.autopilot, vehicle_of(world.settings), world.start,
                   std::atan2(world.goal.y - world.start.y, world.goal.x - world.start.x),
                   [this](const std::vector<std::uint8_t>& bytes) { waiting_.push_back(bytes); }),
        began_(flight.real_time ? monotonic() : kBootLater),
        sensors_(world, flight.sensors, companion_.depth_path(), began_) {}

  FlightOutcome fly() {
    const auto end = static_cast<std::int64_t>(1e9 * world_.settings.time_limit);
    companion_.wait_until_it_says("a sender of depth has connected");  // first, in all flights
    autopilot_.report();                                               // a heartbeat: the companion answers nobody else
    flush();
    for (time_ = kStep; time_ <= end && !outcome_.touched && goes_on(); time_ += kStep) {
      move();
      const double t = 1e-9 * static_cast<double>(time_);
      if (flight_.pilot) {
        flight_.pilot(t, {autopilot_, companion_, camera_works_});
      } else {
        plain_pilot(t, {autopilot_, companion_, camera_works_});
      }
      if (camera_works_) sensors_.take(body(), time_, noise_);
      sensors_.deliver(time_);
      flight_.real_time ? keep_time() : step();
      outcome_.time = t;
    }
    return finish();
  }

 private:
  bool goes_on() {
    if (!companion_.has_ended()) ended_ = time_;
    return time_ <= ended_ + static_cast<std::int64_t>(1e9 * flight_.after_end);
  }

  /// To the end of the step; looks at the true world on the way.
  void move() {
    for (int k = kLooks - 1; k >= 0 && !outcome_.touched; --k) {
      const tern::Vec3 before = autopilot_.vehicle().position();
      autopilot_.fly_to(time_ - k * (kStep / kLooks));
      const tern::Vec3& now = autopilot_.vehicle().position();
      outcome_.length += distance(before, now);
      outcome_.clearance =
          std::min(outcome_.clearance, tern_host::clearance(world_, now) - world_.settings.body_radius);
      outcome_.touched = outcome_.clearance < 0.0;
    }
  }

  tern::Pose body() const {
    const std::array<double, 4> a = autopilot_.vehicle().attitude();
    return {autopilot_.vehicle().position(), {a[0], a[1], a[2], a[3]}};
  }

  /// What the autopilot said a step ago has arrived by now; then the companion does this step, and its answer ends it.
  void step() {
    flush();
    autopilot_.report();
    if (companion_.has_ended()) return;
    companion_.send(autopilot_.step_request(time_ + began_));
    const std::int64_t patience = monotonic() + kPatience;
    while (!autopilot_.take_step_answer()) {
      const std::vector<std::uint8_t> bytes = companion_.receive(100);
      autopilot_.receive(bytes.data(), bytes.size());
      if (companion_.has_ended()) return;
      if (monotonic() > patience)
        throw std::runtime_error("the companion does not answer. It said: " + companion_.said());
    }
  }

  void keep_time() {
    autopilot_.report();
    flush();
    do {
      const int left = static_cast<int>((time_ + began_ - monotonic()) / 1000000);
      const std::vector<std::uint8_t> bytes = companion_.receive(std::clamp(left, 0, 10));
      autopilot_.receive(bytes.data(), bytes.size());
      flush();
    } while (monotonic() < time_ + began_ && !companion_.has_ended());
  }

  void flush() {
    for (const std::vector<std::uint8_t>& bytes : waiting_) companion_.send(bytes);
    waiting_.clear();
  }

  FlightOutcome finish() {
    const tern_host::Vehicle& vehicle = autopilot_.vehicle();
    if (!companion_.has_ended() && outcome_.touched) companion_.interrupt();
    outcome_.exit_status = companion_.has_ended() ? companion_.wait() : -1;
    outcome_.said = companion_.said();
    outcome_.counts = autopilot_.counts();
    outcome_.texts = autopilot_.texts();
    outcome_.from_goal = distance(vehicle.estimate(), world_.goal);
    outcome_.speed_at_end = tern_onboard::length(vehicle.velocity());
    return outcome_;
  }

  const tern_host::FlightWorld& world_;
  const CompanionFlight& flight_;
  tern_host::Noise noise_;
  CompanionProcess companion_;
  std::vector<std::vector<std::uint8_t>> waiting_;
  SimulatedAutopilot autopilot_;
  std::int64_t began_;  // the companion's clock when the autopilot booted
  BodySensors sensors_;
  std::int64_t time_ = 0, ended_ = 0;
  bool camera_works_ = true;
  FlightOutcome outcome_;
};

}  // namespace

std::vector<std::string> companion_world_settings() {
  return {"a_max=2",     "j_max=4", "tracking_margin=0.4", "pose_margin=0.05", "depth_noise=0.01", "sensor_size=120,90",
          "sensor_hz=15"};
}

void plain_pilot(double t, const FlightHands& hands) {
  if (t >= 0.5) hands.autopilot.set_armed(true);
  if (t >= 1.0) hands.autopilot.set_in_air(true);
  if (t >= 2.0 && !hands.autopilot.follows()) hands.autopilot.switch_to_companion();
}

FlightOutcome fly(const tern_host::FlightWorld& world, const CompanionFlight& flight) {
  return std::make_unique<Simulation>(world, flight)->fly();
}

}  // namespace tern_autopilot
