// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/checker.hpp"

#include <cstdarg>
#include <cstdio>

#include "attack/clearance.hpp"
#include "attack/solid.hpp"

namespace tern_attack {

void report(Findings& findings, const char* kind, const char* format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  findings.push_back({kind, text});
}

Real rounding(const tern::Segment& segment, int order) {
  Real most = 0;
  for (const tern::Vec3& p : segment.points) most = std::max(most, largest(point(p)));
  Real factor = 1;
  for (int k = 0; k < order; ++k) factor *= 2 * (tern::kDegree - k) / static_cast<Real>(segment.duration);
  return factor * kUlp * most;
}

Real contact_slack(const World& world) {
  const tern::GridSpec& spec = world.spec;
  const Real cell = spec.cell;
  Real size = 0;
  for (int a = 0; a < 3; ++a)
    size += 4 * std::fabs(static_cast<Real>(axis(spec.origin, a))) + 16 * cell * axis(spec.dims, a);
  return kContactSlack * std::max(1.0L, cell) + kUlp * size;
}

Point shift_of(const World& world, const tern::Trajectory& trajectory) {
  return point(trajectory.origin) - point(world.spec.origin);
}

void check_obstacles(const World& world, const tern::Trajectory& trajectory, Findings& findings) {
  const Point shift = shift_of(world, trajectory);
  for (int s = 0; s < trajectory.count; ++s) {
    const Curve curve = curve_of(trajectory.segments[s].points, shift);
    const Real least = world.radius() - 2 * contact_slack(world);
    const Clearance found = clearance(world, curve, least);
    if (found.proof == Proof::kProven) continue;
    report(findings, found.proof == Proof::kBroken ? "clearance" : "clearance_unproven",
           "segment %d u %.17Lg: %.12Lg m from voxel (%d, %d, %d), radius %.17g", s, found.where, found.distance,
           found.voxel.x, found.voxel.y, found.voxel.z, world.spec.radius);
    return;
  }
}

void check_boundary(const World& world, const tern::Trajectory& trajectory, Findings& findings) {
  const Point shift = shift_of(world, trajectory);
  for (int s = 0; s < trajectory.count; ++s) {
    const Curve curve = curve_of(trajectory.segments[s].points, shift);
    const Real slack = contact_slack(world);
    const auto inside = [&](const Point& p) {
      for (int a = 0; a < 3; ++a) {
        const Real origin = axis(world.spec.origin, a);
        const Real face = 4 * kUlp * std::fabs(origin) + 1e-9L * world.spec.cell;  // on the lattice but for rounding
        if (p[a] < axis(world.spec.boundary.lower, a) - origin - slack - face) return false;
        if (p[a] > axis(world.spec.boundary.upper, a) - origin + slack + face) return false;
      }
      return true;
    };
    const Verdict verdict = prove(curve, inside);
    if (verdict.proof == Proof::kProven) continue;
    const Point p = value(curve_of(trajectory.segments[s].points, shift), verdict.where);
    report(findings, verdict.proof == Proof::kBroken ? "boundary" : "boundary_unproven",
           "segment %d u %.17Lg at (%.17Lg, %.17Lg, %.17Lg) local", s, verdict.where, p[0], p[1], p[2]);
    return;
  }
}

namespace {

void check_fence(const World& world, const tern::Fence& fence, int number, const tern::Trajectory& trajectory,
                 Findings& findings) {
  const Point shift = shift_of(world, trajectory);
  const bool keep_in = fence.kind == tern::FenceKind::kKeepIn;
  const std::vector<Plane> planes = planes_of(world, fence);
  const Solid solid(world, fence);
  for (int s = 0; s < trajectory.count; ++s) {
    const Curve curve = curve_of(trajectory.segments[s].points, shift);
    const Real spacing = 16 * kUlp * (magnitude(curve) + largest(point(world.spec.origin)));
    const auto inside = [&](const Point& p) {
      for (const Plane& plane : planes) {
        if (dot(plane.normal, p) > plane.offset + contact_slack(world) + spacing) return false;
      }
      return true;
    };
    const Verdict verdict =
        keep_in ? prove(curve, inside) : solid.keeps(curve, world.radius() - 2 * contact_slack(world) - spacing);
    if (verdict.proof == Proof::kProven) continue;
    const Real far = keep_in ? 0 : solid.distance(value(curve, verdict.where));
    report(findings, verdict.proof == Proof::kBroken ? (keep_in ? "keep_in" : "keep_out") : "fence_unproven",
           "fence %d, segment %d u %.17Lg, distance %.12Lg", number, s, verdict.where, far);
    return;
  }
}

}  // namespace

void check_fences(const World& world, const tern::Request& request, const tern::Trajectory& trajectory,
                  Findings& findings) {
  for (int f = 0; f < request.fence_count; ++f) {
    if (tern::is_timed(request.fences[f])) continue;  // check_windows()
    check_fence(world, request.fences[f], f, trajectory, findings);
  }
}

namespace {

bool well_formed(const tern::Trajectory& trajectory) {
  if (trajectory.count < 1 || trajectory.count > tern::kMaxSegments) return false;
  for (int s = 0; s < trajectory.count; ++s) {
    const tern::Segment& segment = trajectory.segments[s];
    if (!(segment.duration > 0.0) || !std::isfinite(segment.duration)) return false;
    for (const tern::Vec3& p : segment.points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
    }
  }
  return true;
}

}  // namespace

void check_plan(Rng& rng, const World& world, const tern::Request& request, const tern::Trajectory& trajectory,
                double entered, Findings& findings) {
  if (!well_formed(trajectory)) return report(findings, "malformed", "%d segments", trajectory.count);
  check_obstacles(world, trajectory, findings);
  check_boundary(world, trajectory, findings);
  check_fences(world, request, trajectory, findings);
  check_limits(request, trajectory, findings);
  check_vehicle(request, trajectory, findings);
  check_joints(trajectory, findings);
  check_ends(world, request, trajectory, entered, findings);
  check_evaluate(rng, world, trajectory, 6, findings);
}

}  // namespace tern_attack
