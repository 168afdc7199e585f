// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/number.hpp"
#include "host/plan_file.hpp"

namespace tern_host {
namespace {

constexpr double kMaxRows = 1e7;

void append(std::string& out, const tern::Vec3& v) {
  out += "," + exact(v.x) + "," + exact(v.y) + "," + exact(v.z);
}

void append_yaw(std::string& out, const tern::YawPlan& yaw, double t) {
  const tern::YawSample sample = tern::evaluate(yaw, t);
  out += "," + exact(sample.angle) + "," + exact(sample.yaw.rate) + "," + exact(sample.acceleration);
}

void append_row(std::string& out, const tern::Trajectory& trajectory, const tern::YawPlan* yaw, double t) {
  const tern::Sample sample = tern::evaluate(trajectory, t);
  out += exact(t);
  append(out, sample.position);
  append(out, sample.velocity);
  append(out, sample.acceleration);
  append(out, sample.jerk);
  append(out, sample.snap);
  if (yaw != nullptr) append_yaw(out, *yaw, t);
  out += "\n";
}

}  // namespace

std::string trajectory_csv(const tern::Trajectory& trajectory, double step, const tern::YawPlan* yaw) {
  const double end = std::max(tern::duration(trajectory), yaw == nullptr ? 0.0 : tern::duration(*yaw));
  if (!(step > 0.0) || !(end / step < kMaxRows)) throw std::invalid_argument("the CSV step makes too many rows");
  std::string out = "t,px,py,pz,vx,vy,vz,ax,ay,az,jx,jy,jz,sx,sy,sz";
  out += yaw == nullptr ? "\n" : ",yaw,yaw_rate,yaw_acceleration\n";
  // The last whole step may fall on the end but for rounding: the end itself is written once.
  const double last_before_end = end - 1e-9 * step;
  for (int i = 0; i * step < last_before_end; ++i) append_row(out, trajectory, yaw, i * step);
  append_row(out, trajectory, yaw, end);
  return out;
}

}  // namespace tern_host
