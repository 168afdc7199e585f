// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/sensor_records.hpp"

#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr Range kFov{0.174, 2.62};
/// The horizontal field of view of what sees all around, with room for 6.2832.
constexpr double kAllAround = 360.0 * kDegree;
constexpr double kReadRounding = 1e-3;
/// How far a camera may look up or down, with room for 1.5708.
constexpr Range kPitch{-1.571, 1.571};
constexpr Range kTurned{-3.142, 3.142};

[[noreturn]] void throw_fov(double horizontal, double vertical, const Place& place) {
  std::string text = "sensor_fov " + brief(horizontal) + " " + brief(vertical) + ": both are in rad, " +
                     brief(kFov.least) + " to " + brief(kFov.most) +
                     "; with sensor lidar, the first may also be 6.2832";
  if (horizontal > kAllAround + kReadRounding || vertical > kAllAround + kReadRounding) {
    text += "; if that is in degrees, write " + fixed(kDegree * horizontal, 4) + " " + fixed(kDegree * vertical, 4);
  }
  throw RecordError(place, text);
}

void set_fov(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  const bool sees_all = std::fabs(values[0] - kAllAround) <= kReadRounding;
  if (!(sees_all || holds(kFov, values[0])) || !holds(kFov, values[1])) throw_fov(values[0], values[1], place);
  s.fov_horizontal = sees_all ? kAllAround : values[0];
  s.fov_vertical = values[1];
}

void set_size(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  s.width = static_cast<int>(whole_within(words[0], values[0], {8.0, 1000.0}, place));
  s.height = static_cast<int>(whole_within(words[0], values[1], {8.0, 1000.0}, place));
}

/// A RealSense D435 as it is flown: fixed to the body, with its depth's field of view.
void set_d435(FlightSettings& s) {
  s.sensor = "camera";
  s.mount.kind = "body";
  s.fov_horizontal = 87.0 * kDegree;
  s.fov_vertical = 58.0 * kDegree;
  s.width = 160;
  s.height = 90;
  s.sensor_hz = 15.0;
  s.sensor_min = 0.28;
}

/// A Livox Mid-360, pitched forward: level, it hardly sees below itself. Its beams are at most 0.35 of these pixels
/// from any direction.
void set_livox(FlightSettings& s) {
  s.sensor = "lidar";
  s.mount.kind = "body";
  s.mount.pitch = -0.35;
  s.beams = 20000;
  s.scan_pixel = 0.045;
  s.fov_horizontal = kAllAround;
  s.fov_vertical = 59.0 * kDegree;
  s.sensor_hz = 10.0;
}

void set_sensor(FlightSettings& s, const Words& words, const Place& place) {
  const std::string kind = words.size() == 2 ? words[1] : "";
  if (kind == "d435") return set_d435(s);
  if (kind == "livox") return set_livox(s);
  if (kind != "camera" && kind != "lidar") throw RecordError(place, "sensor is camera, lidar, d435 or livox");
  s.sensor = kind;
}

void set_mount(FlightSettings& s, const Words& words, const Place& place) {
  const std::string kind = words.size() == 2 ? words[1] : "";
  if (kind != "level" && kind != "body") throw RecordError(place, "mount is level or body");
  s.mount.kind = kind;
}

void set_offset(FlightSettings& s, const Words& words, const Place& place) {
  s.mount.offset = vector(words, place);
  const Range near{-2.0, 2.0};
  for (const double d : {s.mount.offset.x, s.mount.offset.y, s.mount.offset.z}) within(words[0], d, near, place);
}

void set_pitch(FlightSettings& s, const Words& words, const Place& place) {
  s.mount.pitch = number_within(words, kPitch, place);
}

/// Each record adds one.
void add_camera(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  s.cameras.push_back({within(words[0], values[0], kTurned, place), within(words[0], values[1], kPitch, place)});
}

void set_gimbal(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  s.mount.gimbal_low = within(words[0], values[0], kPitch, place);
  s.mount.gimbal_high = within(words[0], values[1], {values[0], kPitch.most}, place);
}

void set_error(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  s.depth_error.base = within(words[0], values[0], {0.0, 1.0}, place);
  s.depth_error.square = within(words[0], values[1], {0.0, 1.0}, place);
}

}  // namespace

void check_fov(const FlightSettings& s, const Place& place) {
  const bool has_camera = s.sensor != "lidar" || !s.cameras.empty();
  if (has_camera && !holds(kFov, s.fov_horizontal)) throw_fov(s.fov_horizontal, s.fov_vertical, place);
}

void add_sensor_setters(Setters& setters) {
  using S = FlightSettings;
  setters["sensor"] = set_sensor;
  setters["sensor_range"] = real(&S::sensor_range, 0.5, 1000.0);
  setters["sensor_min"] = real(&S::sensor_min, 0.0, 10.0);
  setters["sensor_far"] = real(&S::sensor_far, 0.0, 1000.0);
  setters["sensor_fov"] = set_fov;
  setters["sensor_size"] = set_size;
  setters["sensor_hz"] = real(&S::sensor_hz, 0.1, 1000.0);
  setters["sensor_latency"] = real(&S::sensor_latency, 0.0, 10.0);
  setters["pixel_part"] = real(&S::pixel_part, 0.0, 1.0);
  setters["mount"] = set_mount;
  setters["mount_offset"] = set_offset;
  setters["mount_pitch"] = set_pitch;
  setters["further_camera"] = add_camera;
  setters["gimbal_pitch"] = set_gimbal;
  setters["no_return"] = real(&S::no_return, 0.0, 1000.0);
  setters["depth_noise"] = real(&S::depth_noise, 0.0, 0.5);
  setters["depth_error"] = set_error;
  setters["holes"] = real(&S::holes, 0.0, 1.0);
  setters["dropout"] = real(&S::dropout, 0.0, 1.0);
  setters["outliers"] = real(&S::outliers, 0.0, 1.0);
  setters["speckle_filter"] = whole(&S::speckle_filter, 0.0, 1.0);
  setters["beams"] = whole(&S::beams, 0.0, 1e6);
  setters["scan_pixel"] = real(&S::scan_pixel, 0.01, 0.2);
}

}  // namespace tern_host
