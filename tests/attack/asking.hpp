// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Requests at random, and what the reference says of them.
#ifndef TERN_TESTS_ATTACK_ASKING_HPP
#define TERN_TESTS_ATTACK_ASKING_HPP

#include <deque>
#include <vector>

#include "attack/checker.hpp"
#include "attack/reference.hpp"

namespace tern_attack {

/// The reference's view of a world.
struct Map {
  std::vector<Space> layer;
  std::vector<int> component;  ///< of voxels that are free beyond doubt
  std::vector<int> free;       ///< their indices
};
Map map_of(const World& world);

/// A request with the storage of its fences.
struct Ask {
  tern::Request request{};
  std::deque<std::vector<tern::Halfspace>> planes;
  std::vector<tern::Fence> fences;
  std::vector<tern::Via> vias;

  Ask() = default;
  Ask(const Ask&) = delete;  // fences point into the planes
  Ask& operator=(const Ask&) = delete;

  bool rest_to_rest() const;
  /// True where some via asks for a velocity.
  bool hurries() const;
  /// True where no stage before the optimiser has a budget.
  bool unlimited_search() const;
  bool unlimited() const { return unlimited_search() && request.budget.trajectory == 0xFFFFFFFFu; }
};

void make_request(Rng& rng, Family family, const World& world, const Map& map, Ask& ask);
/// Shrinks acceleration and jerk of start and goal until they keep the limits of thrust, tilt and body rates.
void calm_vehicle(tern::Request& request);
/// The same from via to via: `mission` gets points, tolerances, stops and velocities of its own. The fences stay those
/// of `ask`, which must outlive it.
void make_mission(Rng& rng, const World& world, const Map& map, const Ask& ask, Ask& mission);
void make_limits(Rng& rng, tern::Limits& limits);
void make_fences(Rng& rng, const World& world, Ask& ask);
/// Any point of the world that a request may name: centres, corners, faces, points exactly at the radius, and others.
tern::Vec3 make_point(Rng& rng, const World& world, const Map& map);

/// True where the answer has to be a plan as far as the map goes: start, vias and goal are inside the boundary, in free
/// voxels (or can join one, docs/search.md), and the free voxels connect them. Fences count by their own faces alone.
bool must_connect(const World& world, const Map& map, const Ask& ask);

/// True where the world is empty and the start's motion leaves room to stop straight ahead.
bool has_room_to_stop(const World& world, const Ask& ask);

}  // namespace tern_attack

#endif
