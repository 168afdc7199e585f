// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "range_sensors.hpp"

#include "planning.hpp"

namespace tern_offboard {
namespace {

constexpr double kDegree = 0.01745329251994330;
constexpr int kMostAcross = 30;   // steps of beams across a cone
constexpr int kBeamsOfABin = 4;   // of a ring
constexpr double kNothing = 1e9;  // m: there is nothing as far as the sensor sees
constexpr uint16_t kUnknownBin = 65535;

static_assert((kMostAcross + 1) * (kMostAcross + 1) <= kMostBeams && 72 * kBeamsOfABin <= kMostBeams, "beams fit");

/// A vector of axes that `q` turns, as PX4's quaternions do: forward, right, down into north, east, down.
tern::Vec3 turned(const float* q, const tern::Vec3& v) {
  const double w = static_cast<double>(q[0]);
  const tern::Vec3 u = {static_cast<double>(q[1]), static_cast<double>(q[2]), static_cast<double>(q[3])};
  const tern::Vec3 t = {2.0 * (u.y * v.z - u.z * v.y), 2.0 * (u.z * v.x - u.x * v.z), 2.0 * (u.x * v.y - u.y * v.x)};
  return {v.x + w * t.x + u.y * t.z - u.z * t.y, v.y + w * t.y + u.z * t.x - u.x * t.z,
          v.z + w * t.z + u.x * t.y - u.y * t.x};
}

bool is_quaternion(const float* q) {
  const float norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  return fabsf(norm - 1.f) < 0.01f;  // false for NaN
}

/// Where the sensor looks, in the body's axes. False for a direction that is not read, up and down among them.
bool mounting(const distance_sensor_s& sensor, float* q) {
  if (sensor.orientation <= distance_sensor_s::ROTATION_YAW_315) {
    const double half = 22.5 * kDegree * static_cast<double>(sensor.orientation);
    q[0] = static_cast<float>(cos(half));
    q[1] = q[2] = 0.f;
    q[3] = static_cast<float>(sin(half));
    return true;
  }
  if (sensor.orientation != distance_sensor_s::ROTATION_CUSTOM || !is_quaternion(sensor.q)) return false;
  memcpy(q, sensor.q, 4 * sizeof *q);
  return fabs(turned(q, {1.0, 0.0, 0.0}).z) < 0.7;
}

/// What lies ahead of a distance sensor: a distance; kNothing, if there is nothing within the range of the map; NaN, if
/// nothing is known.
double reading(const distance_sensor_s& sensor) {
  const double distance = static_cast<double>(sensor.current_distance);
  const double most = static_cast<double>(sensor.max_distance);
  // PX4's drivers say -1 with a quality of 0 if nothing came back from within their range.
  const bool is_out = sensor.signal_quality == 0 && fabs(distance + 1.0) < 1e-6;
  if (sensor.signal_quality == 0 && !is_out) return static_cast<double>(NAN);
  if (is_out || distance >= most) return most >= kRange ? kNothing : static_cast<double>(NAN);
  return distance >= static_cast<double>(sensor.min_distance) ? distance : static_cast<double>(NAN);
}

double within(double value, double least, double most) {
  return value > least ? fmin(value, most) : least;  // the least for NaN
}

}  // namespace

/// One that works, and looks neither up nor down.
bool RangeSensors::is_usable(const distance_sensor_s& sensor) const {
  float q[4];
  const bool is_off = sensor.mode == distance_sensor_s::MODE_DISABLED;
  const bool is_invalid = sensor.signal_quality == 0 && !(fabsf(sensor.current_distance + 1.f) < 1e-6f);
  return !is_off && !is_invalid && mounting(sensor, q);
}

/// Wide enough, and looking ahead.
bool RangeSensors::shows_the_way(const distance_sensor_s& sensor) const {
  float q[4];
  return static_cast<double>(sensor.h_fov) >= kWideEnough && mounting(sensor, q) && turned(q, {1.0, 0.0, 0.0}).x > 0.9;
}

void RangeSensors::look(hrt_abstime now) {
  for (int k = 0; k < kDistanceSensors; ++k) {
    if (!distances_[k].update(&distance_[k])) continue;
    waits_[k] = is_usable(distance_[k]) && distance_[k].timestamp + kLongest >= now;
    if (waits_[k] && shows_the_way(distance_[k])) heard_ = now;
  }
  if (!rings_.update(&ring_)) return;
  waits_[kDistanceSensors] = ring_.increment > 0.f && ring_.increment <= 90.f && fabsf(ring_.angle_offset) < 720.f &&
                             ring_.timestamp + kLongest >= now;
  if (waits_[kDistanceSensors]) heard_ = now;
}

void RangeSensors::add(const tern::Vec3& ned, double range) {
  directions_[count_] = tern::ned_from_enu(ned);
  ranges_[count_] = range < kNothing ? static_cast<float>(range) : range > 0.0 ? INFINITY : NAN;
  ++count_;
}

void RangeSensors::scan_cone(const distance_sensor_s& sensor, const Seen& seen) {
  float q[4];
  mounting(sensor, q);
  const double range = reading(sensor);
  const double wide = within(static_cast<double>(sensor.h_fov), 0.0, 3.0);
  const double high = within(static_cast<double>(sensor.v_fov), 0.0, 3.0);
  const int columns = static_cast<int>(fmin(ceil(2.0 * wide / kScanPixel), kMostAcross));
  const int rows = static_cast<int>(fmin(ceil(2.0 * high / kScanPixel), kMostAcross));
  for (int row = 0; row <= rows; ++row) {
    const double v = rows > 0 ? 2.0 * row / rows - 1.0 : 0.0;
    for (int column = 0; column <= columns; ++column) {
      const double h = columns > 0 ? 2.0 * column / columns - 1.0 : 0.0;
      if (h * h + v * v > 1.0) continue;
      const double a = 0.5 * wide * h;
      const double b = 0.5 * high * v;
      add(turned(seen.attitude, turned(q, {cos(a) * cos(b), sin(a) * cos(b), sin(b)})), range);
    }
  }
}

void RangeSensors::scan_ring(const obstacle_distance_s& ring, const Seen& seen) {
  const tern::Vec3 ahead = turned(seen.attitude, {1.0, 0.0, 0.0});
  const bool is_body = ring.frame == obstacle_distance_s::MAV_FRAME_BODY_FRD;
  const double first = (is_body ? atan2(ahead.y, ahead.x) : 0.0) + kDegree * static_cast<double>(ring.angle_offset);
  const double step = kDegree * static_cast<double>(ring.increment);
  for (int k = 0; k < 72; ++k) {
    const bool is_known = ring.distances[k] != kUnknownBin && ring.distances[k] >= ring.min_distance;
    if (!is_known || ring.distances[k] >= ring.max_distance || k * step > 6.2832) continue;
    for (int beam = 0; beam < kBeamsOfABin; ++beam) {
      const double angle = first + step * (k + (beam + 0.5) / kBeamsOfABin - 0.5);
      add({cos(angle), sin(angle), 0.0}, 0.01 * static_cast<double>(ring.distances[k]));
    }
  }
}

/// Writes the beams of a measurement that waits. False if it is too old, or if nothing of the vehicle is known.
bool RangeSensors::scan(int sensor, const Seen& seen) {
  waits_[sensor] = false;
  const bool is_ring = sensor == kDistanceSensors;
  const hrt_abstime stamp = is_ring ? ring_.timestamp : distance_[sensor].timestamp;
  if (stamp + kLongest < seen.now || !seen.valid || !is_quaternion(seen.attitude)) return false;
  count_ = 0;
  if (is_ring) {
    scan_ring(ring_, seen);
  } else {
    scan_cone(distance_[sensor], seen);
  }
  return true;
}

void RangeSensors::enter(tern::RollingMap& map, const Seen& seen) {
  if (map.busy()) return;
  for (int tried = 0; tried <= kDistanceSensors; ++tried) {
    const int sensor = next_;
    next_ = (next_ + 1) % (kDistanceSensors + 1);
    if (!waits_[sensor] || !scan(sensor, seen)) continue;
    const tern::Beams beams = {directions_, ranges_, count_, 0.0, static_cast<double>(INFINITY)};
    map.begin_scan(beams, seen.here.position, nanoseconds(seen.now));
    return;
  }
}

}  // namespace tern_offboard
