// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/export/plan_export.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "host/export/held_end.hpp"
#include "host/number.hpp"
#include "tern/flatness.hpp"

namespace tern_host {
namespace {

constexpr double kMostFrames = 1e6;
constexpr double kMostStamp = 4294967295.0;  // ms

/// The bytes of a float, the lowest first, on any machine.
void append_float(std::string& out, float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  for (int i = 0; i < 4; ++i) out += static_cast<char>(bits >> (8 * i) & 0xFF);
}

/// The times of setpoints as whole numbers of `tick` a second. The last one is not before the end of the export.
std::vector<std::int64_t> stamps_of(const PlanResult& result, double rate, double tick) {
  const double end = export_end(result);
  const double frames = std::ceil(end * rate) + 1.0;
  if (!(rate > 0.0) || !(rate <= 1000.0) || !(frames <= kMostFrames) || !(end <= kMostStamp / 1000.0 - 1.0)) {
    throw std::invalid_argument(
        "the rate must be above 0 and at most 1000 a second, and make at most a million frames");
  }
  std::vector<std::int64_t> stamps;
  stamps.reserve(static_cast<std::size_t>(frames));
  for (int i = 0; i < static_cast<int>(frames); ++i) {
    stamps.push_back(std::min(std::llround(tick * i / rate), static_cast<long long>(std::ceil(tick * end))));
  }
  return stamps;
}

tern::Yaw yaw_at(const PlanResult& result, double t) {
  return result.yaw != nullptr ? tern::evaluate(*result.yaw, t).yaw : tern::Yaw{1.0, 0.0, 0.0};
}

std::string yaml_vector(const char* name, const tern::Vec3& v) {
  return std::string(name) + ": {x: " + exact(v.x) + ", y: " + exact(v.y) + ", z: " + exact(v.z) + "}";
}

std::string yaml_point(const PlanResult& result, double t, const tern::Vec3& origin) {
  const tern::Sample s = tern::evaluate(result.trajectory, t);
  const tern::Vec3 position{s.position.x - origin.x, s.position.y - origin.y, s.position.z - origin.z};
  const tern::Yaw yaw = yaw_at(result, t);
  const tern::FlatState flat = tern::flat_state(s, yaw);
  const double* q = flat.quaternion;
  return "- transforms: [{" + yaml_vector("translation", position) + ", rotation: {w: " + exact(q[0]) +
         ", x: " + exact(q[1]) + ", y: " + exact(q[2]) + ", z: " + exact(q[3]) + "}}]\n  velocities: [{" +
         yaml_vector("linear", s.velocity) + ", " + yaml_vector("angular", {0.0, 0.0, yaw.rate}) +
         "}]\n  accelerations: [{" + yaml_vector("linear", s.acceleration) + ", " +
         yaml_vector("angular", {0.0, 0.0, 0.0}) + "}]\n";
}

/// What positions lose that are computed in the world and written in full: a few units in their last place.
tern::ExportError rounding_of(const tern::Vec3& place, const tern::Vec3& origin) {
  const double size = std::fabs(place.x) + std::fabs(place.y) + std::fabs(place.z) + std::fabs(origin.x) +
                      std::fabs(origin.y) + std::fabs(origin.z);
  return {4.0 * std::numeric_limits<double>::epsilon() * size, 0.0, 0.0, 0.0, 0.0, 0.0};
}

}  // namespace

RawForm crazyflie_raw(const PlanResult& result, const tern::Vec3& origin) {
  RawForm form{std::vector<tern::Poly4d>(tern::kCrazyfliePieces), {}};
  std::int32_t count = 0;
  const tern::Trajectory held = held_trajectory(result);
  if (tern::crazyflie_raw(held, result.yaw.get(), origin, form.pieces.data(), tern::kCrazyfliePieces, count,
                          form.error) != tern::Status::kOk) {
    const int holds = held.count - result.trajectory.count;
    throw std::runtime_error(
        "the plan has " + std::to_string(held.count) + " segments" +
        (holds > 0 ? ", " + std::to_string(holds) + " of them to hold the position until the yaw plan ends" : "") +
        "; a Crazyflie's memory has room for " + std::to_string(tern::kCrazyfliePieces) +
        ". Plan shorter legs, or use the compressed form");
  }
  form.pieces.resize(static_cast<std::size_t>(count));
  return form;
}

std::string RawForm::bytes() const {
  std::string bytes;
  for (const tern::Poly4d& piece : pieces) {
    for (const auto& row : piece.p) {
      for (const float coefficient : row) append_float(bytes, coefficient);
    }
    append_float(bytes, piece.duration);
  }
  return bytes;
}

std::string RawForm::csv() const {
  std::string text = "Duration";
  for (const char* const name : {"x", "y", "z", "yaw"}) {
    for (int k = 0; k < 8; ++k) text += std::string(",") + name + "^" + std::to_string(k);
  }
  text += "\n";
  for (const tern::Poly4d& piece : pieces) {
    text += exact(static_cast<double>(piece.duration));
    for (const auto& row : piece.p) {
      for (const float coefficient : row) text += "," + exact(static_cast<double>(coefficient));
    }
    text += "\n";
  }
  return text;
}

CompressedForm crazyflie_compressed(const PlanResult& result, const tern::Vec3& origin) {
  const std::int32_t room = tern::crazyflie_compressed_bytes(tern::kMaxSegments);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(room));
  std::int32_t used = 0;
  CompressedForm form{};
  if (tern::crazyflie_compressed(held_trajectory(result), result.yaw.get(), origin, bytes.data(), room, used,
                                 form.error) != tern::Status::kOk) {
    throw std::runtime_error(
        "the plan does not fit the compressed form: coordinates must lie within 32.767 m of the origin (see --origin), "
        "and every segment must last 0.001 to 65.535 s");
  }
  if (tern::crazyflie_decompressed(bytes.data(), used, origin, form.curve) != tern::Status::kOk) {
    throw std::runtime_error("the compressed form cannot be read back");
  }
  form.bytes.assign(bytes.begin(), bytes.begin() + used);
  return form;
}

SetpointStream mavlink_stream(const PlanResult& result, double rate, const tern::Vec3& origin) {
  SetpointStream stream{"", 0, tern::setpoint_error(result.trajectory, result.yaw.get(), origin)};
  for (const std::int64_t ms : stamps_of(result, rate, 1e3)) {
    const double t = static_cast<double>(ms) / 1e3;
    const tern::Sample sample = tern::evaluate(result.trajectory, t);
    const tern::SetpointNed setpoint = result.yaw == nullptr
                                           ? tern::setpoint_ned(sample, origin)
                                           : tern::setpoint_ned(sample, tern::evaluate(*result.yaw, t), origin);
    const tern::MavlinkHeader header{
        255, 190, 1, 1, static_cast<std::uint8_t>(stream.count++ & 0xFF), static_cast<std::uint32_t>(ms)};
    std::uint8_t frame[tern::kMavlinkSetpointBytes];
    const std::int32_t length = tern::mavlink_setpoint(setpoint, header, frame);
    if (length == 0) throw std::runtime_error("the plan is too far from the origin for MAVLink's floats: see --origin");
    stream.content.append(reinterpret_cast<const char*>(frame), static_cast<std::size_t>(length));
  }
  return stream;
}

SetpointStream multidof_yaml(const PlanResult& result, double rate, const tern::Vec3& origin) {
  SetpointStream stream{"header: {frame_id: map}\njoint_names: [base_link]\npoints:\n", 0,
                        rounding_of(result.trajectory.origin, origin)};
  for (const std::int64_t ns : stamps_of(result, rate, 1e9)) {
    stream.content += yaml_point(result, static_cast<double>(ns) / 1e9, origin) +
                      "  time_from_start: {secs: " + std::to_string(ns / kSecond) +
                      ", nsecs: " + std::to_string(ns % kSecond) + "}\n";
    ++stream.count;
  }
  return stream;
}

}  // namespace tern_host
