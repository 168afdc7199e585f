// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/export/plan_export.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "host/map/scenario_grid.hpp"
#include "host/number.hpp"
#include "tern/flatness.hpp"
#include "tern/proof.hpp"

namespace tern_host {
namespace {

constexpr double kMostFrames = 1e6;

std::vector<tern::Poly4d> pieces_of(const PlanResult& result) {
  const int count = result.trajectory.count;
  if (count > tern::kCrazyfliePieces) {
    throw std::runtime_error("the plan has " + std::to_string(count) + " segments; a Crazyflie's memory has room for " +
                             std::to_string(tern::kCrazyfliePieces) +
                             ". Plan shorter legs, or use the compressed form");
  }
  std::vector<tern::Poly4d> pieces(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    tern::poly4d(result.trajectory, result.yaw.get(), i, pieces[static_cast<std::size_t>(i)]);
  }
  return pieces;
}

/// The bytes of a float, the lowest first, on any machine.
void append_float(std::string& out, float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  for (int i = 0; i < 4; ++i) out += static_cast<char>(bits >> (8 * i) & 0xFF);
}

int frames_of(const PlanResult& result, double rate) {
  const double frames = std::ceil(tern::duration(result.trajectory) * rate) + 1.0;
  if (!(rate > 0.0) || !(frames <= kMostFrames)) throw std::invalid_argument("the rate makes too many frames");
  return static_cast<int>(frames);
}

tern::YawSample yaw_at(const PlanResult& result, double t) {
  return result.yaw != nullptr ? tern::evaluate(*result.yaw, t) : tern::YawSample{{1.0, 0.0, 0.0}, 0.0, 0.0};
}

double apart(const tern::Vec3& a, const tern::Vec3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/// Value, slope and curvature of a power series.
struct Jet {
  double value, slope, curvature;
};

Jet evaluate_series(const float (&p)[8], double t) {
  Jet jet{0.0, 0.0, 0.0};
  for (int k = 7; k >= 0; --k) {
    jet.curvature = jet.curvature * t + 2.0 * jet.slope;
    jet.slope = jet.slope * t + jet.value;
    jet.value = jet.value * t + static_cast<double>(p[k]);
  }
  return jet;
}

void widen(ExportError& error, const tern::Sample& a, const tern::Sample& b) {
  error.position = std::max(error.position, apart(a.position, b.position));
  error.velocity = std::max(error.velocity, apart(a.velocity, b.velocity));
  error.acceleration = std::max(error.acceleration, apart(a.acceleration, b.acceleration));
}

/// Samples of one segment, without its end: there the next one speaks.
int samples_of(double duration) {
  return static_cast<int>(std::clamp(duration * 1000.0, 10.0, 1e5));
}

std::string yaml_vector(const char* name, const tern::Vec3& v) {
  return std::string(name) + ": {x: " + exact(v.x) + ", y: " + exact(v.y) + ", z: " + exact(v.z) + "}";
}

}  // namespace

std::string crazyflie_raw(const PlanResult& result) {
  std::string bytes;
  for (const tern::Poly4d& piece : pieces_of(result)) {
    for (const auto& row : piece.p) {
      for (const float coefficient : row) append_float(bytes, coefficient);
    }
    append_float(bytes, piece.duration);
  }
  return bytes;
}

std::string crazyflie_csv(const PlanResult& result) {
  std::string text = "Duration";
  for (const char* const name : {"x", "y", "z", "yaw"}) {
    for (int k = 0; k < 8; ++k) text += std::string(",") + name + "^" + std::to_string(k);
  }
  text += "\n";
  for (const tern::Poly4d& piece : pieces_of(result)) {
    text += exact(static_cast<double>(piece.duration));
    for (const auto& row : piece.p) {
      for (const float coefficient : row) text += "," + exact(static_cast<double>(coefficient));
    }
    text += "\n";
  }
  return text;
}

std::string crazyflie_compressed(const PlanResult& result) {
  const std::int32_t room = tern::crazyflie_compressed_bytes(result.trajectory.count);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(room));
  std::int32_t used = 0;
  if (tern::crazyflie_compressed(result.trajectory, result.yaw.get(), bytes.data(), room, used) != tern::Status::kOk) {
    throw std::runtime_error(
        "the plan does not fit the compressed form: coordinates must lie within 32.767 m of the origin, and every "
        "segment must last 0.001 to 65.535 s");
  }
  return {bytes.begin(), bytes.begin() + used};
}

std::string mavlink_stream(const PlanResult& result, double rate) {
  const int frames = frames_of(result, rate);
  const double end = tern::duration(result.trajectory);
  std::string stream;
  for (int i = 0; i < frames; ++i) {
    const double t = std::min(i / rate, end);
    const tern::SetpointNed setpoint =
        tern::setpoint_ned(tern::evaluate(result.trajectory, t), yaw_at(result, t), {0.0, 0.0, 0.0});
    const tern::MavlinkHeader header{
        255, 190, 1, 1, static_cast<std::uint8_t>(i & 0xFF), static_cast<std::uint32_t>(std::llround(1000.0 * t))};
    std::uint8_t frame[tern::kMavlinkSetpointBytes];
    const std::int32_t length = tern::mavlink_setpoint(setpoint, header, frame);
    stream.append(reinterpret_cast<const char*>(frame), static_cast<std::size_t>(length));
  }
  return stream;
}

std::string multidof_yaml(const PlanResult& result, double rate) {
  const int frames = frames_of(result, rate);
  const double end = tern::duration(result.trajectory);
  std::string text = "header: {frame_id: map}\njoint_names: [base_link]\npoints:\n";
  for (int i = 0; i < frames; ++i) {
    const double t = std::min(i / rate, end);
    const tern::Sample s = tern::evaluate(result.trajectory, t);
    const tern::Yaw yaw = yaw_at(result, t).yaw;
    const tern::FlatState flat = tern::flat_state(s, yaw);
    const double* q = flat.quaternion;
    const auto whole = static_cast<long long>(t);
    text += "- transforms: [{" + yaml_vector("translation", s.position) + ", rotation: {w: " + exact(q[0]) +
            ", x: " + exact(q[1]) + ", y: " + exact(q[2]) + ", z: " + exact(q[3]) + "}}]\n  velocities: [{" +
            yaml_vector("linear", s.velocity) + ", " + yaml_vector("angular", {0.0, 0.0, yaw.rate}) +
            "}]\n  accelerations: [{" + yaml_vector("linear", s.acceleration) + ", " +
            yaml_vector("angular", {0.0, 0.0, 0.0}) + "}]\n  time_from_start: {secs: " + std::to_string(whole) +
            ", nsecs: " + std::to_string(std::llround(1e9 * (t - static_cast<double>(whole)))) + "}\n";
  }
  return text;
}

ExportError raw_error(const PlanResult& result) {
  ExportError error{0.0, 0.0, 0.0};
  double begin = 0.0;
  const std::vector<tern::Poly4d> pieces = pieces_of(result);
  for (int i = 0; i < result.trajectory.count; ++i) {
    const tern::Poly4d& piece = pieces[static_cast<std::size_t>(i)];
    const double duration = result.trajectory.segments[i].duration;
    const int samples = samples_of(duration);
    for (int k = 0; k < samples; ++k) {
      const double t = duration * k / samples;
      const Jet x = evaluate_series(piece.p[0], t);
      const Jet y = evaluate_series(piece.p[1], t);
      const Jet z = evaluate_series(piece.p[2], t);
      const tern::Sample flown{
          {x.value, y.value, z.value}, {x.slope, y.slope, z.slope}, {x.curvature, y.curvature, z.curvature}, {}, {}};
      widen(error, flown, tern::evaluate(result.trajectory, begin + t));
    }
    begin += duration;
  }
  return error;
}

CompressedCurve compressed_curve(const PlanResult& result, const std::string& bytes) {
  CompressedCurve curve{};
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const auto count = static_cast<std::int32_t>(bytes.size());
  if (tern::crazyflie_decompressed(data, count, result.trajectory, curve.trajectory) != tern::Status::kOk) {
    throw std::runtime_error("the compressed form cannot be read back");
  }
  double flown = 0.0;
  double planned = 0.0;
  for (int i = 0; i < curve.trajectory.count; ++i) {
    const double a = curve.trajectory.segments[i].duration;
    const double b = result.trajectory.segments[i].duration;
    const int samples = samples_of(a);
    for (int k = 0; k < samples; ++k) {
      const double part = static_cast<double>(k) / samples;
      widen(curve.error, tern::evaluate(curve.trajectory, flown + part * a),
            tern::evaluate(result.trajectory, planned + part * b));
    }
    flown += a;
    planned += b;
  }
  const GridMap map(result.scenario);
  curve.clear_until = tern::clear_until(map.grid, curve.trajectory, 0.0);
  curve.clear = curve.clear_until >= tern::duration(curve.trajectory);
  return curve;
}

}  // namespace tern_host
