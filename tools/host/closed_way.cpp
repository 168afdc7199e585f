// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/closed_way.hpp"

#include <cmath>

#include "host/grid_layout.hpp"
#include "host/number.hpp"
#include "host/session.hpp"

namespace tern_host {
namespace {

/// Halvings of the interval that holds the largest radius that gets through: to a hundredth of the robot's.
constexpr int kRadii = 7;

/// Cut to two digits: what is smaller gets through as well.
double cut(double radius) {
  if (!(radius > 0.0)) return radius;
  const double digit = std::pow(10.0, std::floor(std::log10(radius)) - 1.0);
  return std::floor(radius / digit) * digit;
}

/// The scenario with less in the way.
class Relaxed {
 public:
  explicit Relaxed(const Scenario& scenario) : asked_(scenario) {
    asked_.goal_mode = tern::GoalMode::kExact;
    asked_.has_yaw = false;
  }

  /// Small enough to be planned in again and again.
  bool is_small() const { return is_small(asked_); }

  bool opens_without_fences() {
    if (asked_.fences.empty()) return false;
    Scenario trial = asked_;
    trial.fences.clear();
    return opens(trial);
  }

  bool opens_if_unknown_is_free() {
    if (asked_.unknown != Unknown::kSolid || asked_.known.empty()) return false;
    Scenario trial = asked_;
    trial.unknown = Unknown::kFree;
    return opens(trial);
  }

  /// The largest half, quarter and so on of the resolution that opens a way; 0 if none does.
  double finer_resolution() {
    Scenario trial = asked_;
    for (int k = 0; k < kClosedWayHalvings; ++k) {
      trial.resolution *= 0.5;
      if (!is_small(trial)) return 0.0;
      if (opens(trial)) return trial.resolution;
    }
    return 0.0;
  }

  /// A radius that gets through at the scenario's resolution, nearly the largest; negative if even 0 does not.
  double radius_that_fits() {
    Scenario trial = asked_;
    trial.tracking_margin = 0.0;
    trial.radius = 0.0;
    if (!opens(trial)) return -1.0;
    double fits = 0.0;
    double closed = asked_.clearance();
    for (int k = 0; k < kRadii; ++k) {
      trial.radius = 0.5 * (fits + closed);
      (opens(trial) ? fits : closed) = trial.radius;
    }
    return fits;
  }

 private:
  static bool is_small(const Scenario& scenario) {
    try {
      const tern::Voxel dims = lay_out_grid(scenario).dims;
      return static_cast<double>(dims.x) * dims.y * dims.z <= kClosedWayVoxels;
    } catch (const ScenarioError&) {
      return false;  // beyond a capacity
    }
  }

  /// Any answer after the search says that free voxels connect the ends.
  bool opens(const Scenario& trial) { return session_.plan(trial).path != nullptr; }

  Scenario asked_;
  Session session_;
};

}  // namespace

std::string describe_closed_way(const Scenario& scenario) {
  Relaxed relaxed(scenario);
  if (!relaxed.is_small()) return "";
  if (relaxed.opens_without_fences()) return "; without the geofences there is a way";
  if (relaxed.opens_if_unknown_is_free()) {
    return "; there is a way if space that the map does not know is free (`unknown free`)";
  }
  const double resolution = relaxed.finer_resolution();
  if (resolution > 0.0)
    return "; a passage is too narrow for these voxels: a resolution of " + brief(resolution) + " m opens it";
  const double radius = cut(relaxed.radius_that_fits());
  if (radius > 0.0) {
    return "; a passage is too narrow for the robot: at this resolution, radius and tracking margin together may be " +
           brief(radius) + " m";
  }
  return radius < 0.0 ? "; obstacles and the boundary close every way at this resolution, even for a point"
                      : "; every way is too narrow at this resolution for a robot of any size";
}

}  // namespace tern_host
