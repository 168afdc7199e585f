// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
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

void append_row(std::string& out, const tern::Trajectory& trajectory, double t) {
  const tern::Sample sample = tern::evaluate(trajectory, t);
  out += exact(t);
  append(out, sample.position);
  append(out, sample.velocity);
  append(out, sample.acceleration);
  append(out, sample.jerk);
  append(out, sample.snap);
  out += "\n";
}

}  // namespace

std::string trajectory_csv(const tern::Trajectory& trajectory, double step) {
  const double end = tern::duration(trajectory);
  if (!(step > 0.0) || !(end / step < kMaxRows)) throw std::invalid_argument("the CSV step makes too many rows");
  std::string out = "t,px,py,pz,vx,vy,vz,ax,ay,az,jx,jy,jz,sx,sy,sz\n";
  // The last whole step may fall on the end but for rounding: the end itself is written once.
  const double last_before_end = end - 1e-9 * step;
  for (int i = 0; i * step < last_before_end; ++i) append_row(out, trajectory, i * step);
  append_row(out, trajectory, end);
  return out;
}

}  // namespace tern_host
