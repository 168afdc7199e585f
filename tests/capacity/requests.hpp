// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random requests that take the planner through all of its stages, small enough for the tiny profile.
#ifndef TERN_TESTS_CAPACITY_REQUESTS_HPP
#define TERN_TESTS_CAPACITY_REQUESTS_HPP

#include <memory>
#include <vector>

#include "support/world.hpp"

namespace tern_capacity {

/// A world with a request, and what the request points to.
struct Asked {
  Asked(const tern::Voxel& dims, double radius) : world(dims, 0.25, radius) {}
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;

  tern_test::World world;
  std::vector<tern::Halfspace> planes;
  std::vector<tern::Fence> fences;
  std::vector<tern::Via> vias;
  std::vector<tern::Track> tracks;
  tern::Trajectory previous{};
};

std::unique_ptr<Asked> random_request(std::uint64_t seed);

}  // namespace tern_capacity

#endif
