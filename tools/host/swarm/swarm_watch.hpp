// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether bodies touch, in continuous time, by code of its own: between two instants at which all positions are known,
// bodies that are far enough apart for their top speeds are clear; else the time is halved.
#ifndef TERN_HOST_SWARM_SWARM_WATCH_HPP
#define TERN_HOST_SWARM_SWARM_WATCH_HPP

#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "tern/vec3.hpp"

namespace tern_host {

/// Two bodies that touched, or, with `second` -1, a body and an obstacle or an intruder.
struct SwarmContact {
  std::int64_t time;  ///< ns
  int first, second;
  double distance;  ///< m, between centres, or from the obstacle
  int intruder = -1;
};

/// A ball that is no vehicle.
struct WatchedIntruder {
  double radius;     ///< m
  double top_speed;  ///< m/s
  std::function<tern::Vec3(std::int64_t t)> position;
};

class SwarmWatch {
 public:
  using Position = std::function<tern::Vec3(int vehicle, std::int64_t t)>;
  using Clearance = std::function<double(const tern::Vec3&)>;

  /// `top_speed`: of each body, m/s. `clearance`: from what stands still, m; null for none.
  SwarmWatch(int vehicles, double body_radius, double top_speed, Position position, Clearance clearance);

  void add_intruder(WatchedIntruder intruder) { intruders_.push_back(std::move(intruder)); }
  /// Looks at all bodies from one instant to another.
  void look(std::int64_t from, std::int64_t until);

  const std::vector<SwarmContact>& contacts() const { return contacts_; }
  /// Intruders that touched a vehicle at rest. They are contacts, too, if it moved before they were clear again.
  const std::vector<SwarmContact>& touched_at_rest() const { return touched_at_rest_; }
  /// Between a vehicle in motion and an intruder: of surfaces, m, at instants that were looked at.
  double least_gap() const { return least_gap_; }
  double least_distance() const { return least_distance_; }    ///< between two centres, m
  double least_clearance() const { return least_clearance_; }  ///< from what stands still, m

 private:
  void look_at_pair(int i, int j, std::int64_t from, std::int64_t until);
  void look_at_body(int i, std::int64_t from, std::int64_t until);
  void look_at_intruder(int i, int k, std::int64_t from, std::int64_t until);
  bool moves(int i, std::int64_t t, std::int64_t from, std::int64_t until) const;
  void note(std::int64_t time, int i, int j, double distance, bool touches);

  int vehicles_;
  double body_radius_, top_speed_;
  Position position_;
  Clearance clearance_;
  std::vector<SwarmContact> contacts_;
  std::set<std::pair<int, int>> touching_;
  std::vector<WatchedIntruder> intruders_;
  std::vector<SwarmContact> touched_at_rest_;
  std::set<std::pair<int, int>> resting_, moving_;  ///< vehicles and intruders that touch, and how the vehicle does
  std::vector<tern::Vec3> middle_;                  ///< places of all in the middle of what is looked at
  double least_distance_ = 1e9, least_clearance_ = 1e9, least_gap_ = 1e9;
};

}  // namespace tern_host

#endif
