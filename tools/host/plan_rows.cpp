// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/plan_rows.hpp"

#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "host/figures.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

/// FNV-1a over the bits of durations and control points.
std::string plan_hash(const tern::Trajectory& trajectory) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  const auto add = [&hash](double value) {
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001B3u;
  };
  for (int s = 0; s < trajectory.count; ++s) {
    add(trajectory.segments[s].duration);
    for (const tern::Vec3& p : trajectory.segments[s].points) {
      add(p.x);
      add(p.y);
      add(p.z);
    }
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, hash);
  return text;
}

/// Units of all stages.
std::uint64_t work_of(const tern::Report& report) {
  std::uint64_t sum = 0;
  for (const tern::StageReport& stage : report.diagnostics.stages) sum += stage.work;
  return sum;
}

}  // namespace

std::string plan_rows_header() {
  return "scenario,status,stage,optimised,duration_s,length_m,clearance,least_clearance,work,hash\n";
}

std::string plan_row(const PlanResult& result) {
  const tern::Report& report = result.report;
  std::string row = result.scenario.name + "," + tern::status_name(report.status) + "," +
                    tern::stage_name(report.stage) + "," + (report.quality == tern::Quality::kOptimised ? "1" : "0");
  if (!result.ok())
    return row + ",,," + exact(result.scenario.clearance()) + ",," + std::to_string(work_of(report)) + ",\n";
  const Figures figures = measure(result.trajectory, result.scenario);
  row += "," + exact(figures.duration) + "," + exact(figures.length) + "," + exact(result.scenario.clearance()) + ",";
  if (std::isfinite(figures.clearance)) row += exact(figures.clearance);
  return row + "," + std::to_string(work_of(report)) + "," + plan_hash(result.trajectory) + "\n";
}

}  // namespace tern_host
