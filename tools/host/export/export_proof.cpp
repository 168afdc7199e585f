// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/export/export_proof.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "host/figures.hpp"
#include "host/map/scenario_grid.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"
#include "tern/proof.hpp"

namespace tern_host {
namespace {

constexpr double kFar = 500.0;         // m; floats are 3e-5 m apart there
constexpr double kLeastRadius = 2e-9;  // m; a proof needs a radius, and grants itself twice this
constexpr double kMoreReserve = 5.0;   // %: another plan is rounded otherwise

tern::ProofReport proof_of(Scenario scenario, tern::Trajectory curve, const tern::Limits* limits) {
  curve.begin = nanoseconds(scenario.start_time);
  scenario.radius = std::max(scenario.radius, kLeastRadius);
  const GridMap map(scenario);
  const std::vector<tern::Fence> fences = fences_of(scenario.fences);
  tern::ProofGrounds grounds;
  grounds.fences = fences.data();
  grounds.fence_count = static_cast<std::int32_t>(fences.size());
  const std::vector<tern::Track> tracks = tracks_of(scenario.tracks);
  grounds.tracks = tracks.data();
  grounds.track_count = static_cast<std::int32_t>(tracks.size());
  tern::Proof proof;
  tern::ProofReport report{};
  report.finding = tern::Finding::kMalformed;
  tern::Status status = proof.begin(map.grid, curve, 0.0, limits, tern::Beyond::kEmpty, grounds);
  while (status == tern::Status::kRunning) status = proof.step(100000);
  if (status == tern::Status::kOk) report = proof.report();
  return report;
}

double least_of(const LimitRange& range) {
  const tern::Vec3& lo = range.lower;
  const tern::Vec3& hi = range.upper;
  const double least = std::min({hi.x, hi.y, hi.z, -lo.x, -lo.y, -lo.z});
  return range.horizontal > 0.0 ? std::min(least, range.horizontal) : least;
}

/// The most of the limits that the error takes, as a part of them.
double excess_of(const Scenario& scenario, const tern::ExportError& error) {
  return std::max({error.velocity / least_of(velocity_range(scenario.limits)),
                   error.acceleration / least_of(acceleration_range(scenario.limits)),
                   error.jerk / least_of(jerk_range(scenario.limits))});
}

double length(const tern::Vec3& a, const tern::Vec3& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/// `where` says what is wrong with that, or nothing.
[[noreturn]] void refuse_error(const ExportCase& what, double allowed, const std::string& where) {
  const tern::Vec3& place = what.plan.origin;
  std::string text = "is up to " + brief(what.error.position) + " m off the plan; " + brief(allowed) +
                     " m is allowed without a proof" + where + ". ";
  if (!(length(place, what.origin) <= kFar)) {
    text += "Numbers are coarse so far from 0. Let a point near the plan be 0: --origin " +
            fixed(std::floor(place.x), 0) + " " + fixed(std::floor(place.y), 0) + " " + fixed(std::floor(place.z), 0);
  } else {
    text += "Plan with a tracking margin of " + brief(std::ceil(what.error.position * 1e3) / 1e2) + " m or more";
  }
  throw std::runtime_error(text);
}

[[noreturn]] void refuse_limits(const Scenario& scenario, const ExportCase& what, double until) {
  const Figures figures = measure(*what.curve, scenario);
  const double use = std::max({figures.v_use, figures.a_use, figures.j_use});
  char text[300];
  std::snprintf(text, sizeof text,
                "exceeds the limits at %.3f s: it uses %.1f %% of those of velocity, %.1f %% of acceleration and "
                "%.1f %% of jerk. Let it be planned with lower limits: --reserve %.0f",
                until, 100.0 * figures.v_use, 100.0 * figures.a_use, 100.0 * figures.j_use,
                std::ceil(100.0 * (1.0 - 1.0 / std::max(use, 1.0))) + kMoreReserve);
  throw std::runtime_error(text);
}

std::string prove_curve(const Scenario& scenario, const ExportCase& what, double allowed) {
  const tern::Limits limits = scaled(scenario.limits, 1.0 + kExportExcess);
  const tern::ProofReport report = proof_of(scenario, *what.curve, &limits);
  switch (report.finding) {
    case tern::Finding::kNone:
      return "proven clear and within the limits";
    case tern::Finding::kVelocity:
    case tern::Finding::kAcceleration:
    case tern::Finding::kJerk:
      refuse_limits(scenario, what, report.until);
    default:
      refuse_error(what, allowed, ", and the curve is proven clear only until " + fixed(report.until, 3) + " s");
  }
}

}  // namespace

tern::Limits scaled(tern::Limits limits, double factor) {
  for (tern::Vec3* v : {&limits.v_max, &limits.v_min, &limits.a_max, &limits.a_min, &limits.j_max}) {
    *v = {factor * v->x, factor * v->y, factor * v->z};
  }
  for (double* x : {&limits.v_horizontal, &limits.a_horizontal, &limits.j_horizontal}) *x *= factor;
  return limits;
}

std::string prove_export(const Scenario& scenario, const ExportCase& what) {
  const double allowed = std::max(kExportOff, kExportMarginShare * scenario.tracking_margin);
  const bool near = what.error.position <= allowed;
  const bool limits_kept = excess_of(scenario, what.error) <= kExportExcess;
  if (what.curve != nullptr && !(near && limits_kept)) return prove_curve(scenario, what, allowed);
  if (!near) refuse_error(what, allowed, "");
  if (!limits_kept) throw std::runtime_error("is too far off the plan's velocity or acceleration. Use another form");
  return "as clear as the plan but for that, and within the limits";
}

}  // namespace tern_host
