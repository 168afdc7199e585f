// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "host/flight/flight_pads.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr const char* kColumns =
    "t,true_x,true_y,true_z,true_v_x,true_v_y,true_v_z,set_p_x,set_p_y,set_p_z,set_v_x,set_v_y,set_v_z,"
    "set_a_x,set_a_y,set_a_z,set_j_x,set_j_y,set_j_z,yaw,tick_work,state,event\n";

double distance(const tern::Vec3& a, const tern::Vec3& b) {
  return std::hypot(a.x - b.x, std::hypot(a.y - b.y, a.z - b.z));
}

void append(std::string& row, const tern::Vec3& v) {
  for (const double number : {v.x, v.y, v.z}) row += "," + exact(number);
}

const char* mode_name(tern::FlightMode mode) {
  constexpr const char* kNames[] = {"rest", "look", "fly", "stop", "threat"};
  return kNames[static_cast<int>(mode)];
}

}  // namespace

VehicleSettings vehicle_settings_of(const FlightSettings& s) {
  VehicleSettings vehicle;
  vehicle.kind = s.tracking;
  vehicle.tracking_margin = s.tracking_margin;
  vehicle.pose_margin = s.pose_margin;
  vehicle.pose_jumps = s.pose_jump;
  vehicle.pose_drift = s.pose_drift;
  vehicle.pose_lag = s.pose_lag;
  vehicle.air = s.air;
  vehicle.stack_speed = s.stack_speed;
  vehicle.tick = 1.0 / s.tick_hz;
  vehicle.seed = s.seed;
  return vehicle;
}

void FlightRecorder::note_clearance(const Vehicle& vehicle) {
  const double aside = world_.settings.tracking_margin + world_.settings.pose_margin + kOverPad;
  clearance_ = clearance_of_flight(world_, vehicle.position(), aside);
  const double before = result_.track.empty() ? clearance_ : result_.min_clearance;
  result_.min_clearance = std::min(before, clearance_);
}

void FlightRecorder::note(std::int64_t t, const tern::Command& command, const Vehicle& vehicle, double yaw,
                          const tern::FlightReport& report, bool skipped) {
  const tern::Vec3 p = vehicle.position();
  const double seconds = seconds_of(t);
  note_clearance(vehicle);
  const double error = distance(vehicle.estimate(), command.sample.position);
  result_.tracking_max = std::max(result_.tracking_max, error);
  result_.pose_max = std::max(result_.pose_max, distance(vehicle.estimate(), p));
  squares_ += error * error;
  if (!result_.track.empty()) result_.length += distance(p, result_.track.back().position);
  const bool committed = report.committed != last_.committed;
  result_.track.push_back(
      {p, distance(vehicle.velocity(), {}), committed, command.sample.position, vehicle.estimate()});
  result_.seconds_in[static_cast<std::size_t>(report.mode)] += 1.0 / world_.settings.tick_hz;
  if (distance(command.sample.velocity, {}) < kStanding) result_.standing += 1.0 / world_.settings.tick_hz;
  result_.time = seconds;
  result_.skipped += skipped ? 1 : 0;
  work_.push_back(skipped ? 0 : report.work);
  result_.work_total += work_.back();
  hash(command.sample);
  const bool tells_touch = touched_ && !skipped && !committed;
  const char* const event = skipped ? "skipped" : (committed ? "commit" : (tells_touch ? "touched" : ""));
  add_row(seconds, command, vehicle, yaw, report, event);
  touched_ = touched_ && !tells_touch;
  last_ = report;
}

void FlightRecorder::add_row(double t, const tern::Command& command, const Vehicle& vehicle, double yaw,
                             const tern::FlightReport& report, const char* event) {
  std::string& rows = result_.samples;
  if (rows.empty()) rows = kColumns;
  rows += exact(t);
  append(rows, vehicle.position());
  append(rows, vehicle.velocity());
  const tern::Sample& set = command.sample;
  for (const tern::Vec3& v : {set.position, set.velocity, set.acceleration, set.jerk}) append(rows, v);
  rows += "," + exact(yaw) + "," + std::to_string(work_.back()) + "," + mode_name(report.mode) + "," + event + "\n";
}

void FlightRecorder::hash(const tern::Sample& sample) {
  unsigned char bytes[sizeof sample];
  std::memcpy(bytes, &sample, sizeof sample);
  for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001B3u;
}

FlightResult FlightRecorder::finish() {
  result_.asked = last_.asked;
  result_.committed = last_.committed;
  result_.dropped = last_.dropped;
  result_.failed = last_.failed;
  result_.commands_hash = hash_;
  if (!work_.empty()) {
    std::sort(work_.begin(), work_.end());
    result_.work_max = work_.back();
    result_.work_p99 = work_[work_.size() * 99 / 100];
    result_.tracking_rms = std::sqrt(squares_ / static_cast<double>(work_.size()));
  }
  return std::move(result_);
}

}  // namespace tern_host
