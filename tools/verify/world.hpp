// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The world that a flight is flown in, and how it is flown, as far as proofs depend on it. The reader is the verifier's
// own (docs/formats.md).
#ifndef TERN_VERIFY_WORLD_HPP
#define TERN_VERIFY_WORLD_HPP

#include <map>
#include <string>
#include <vector>

#include "verify/nearest.hpp"
#include "verify/problem.hpp"

namespace tern_verify {

/// World frame, metres, seconds.
struct World {
  Box boundary;  ///< its faces are walls
  std::vector<Box> blocks;
  std::vector<Solid> cylinders;
  std::vector<Fence> fences;
  Point start;
  std::vector<Point> mission;                ///< the points to pass; the goal is the last one
  std::map<std::string, Rational> settings;  ///< those of kWorldSettings
  std::string tracking;                      ///< the kind of vehicle

  /// Throws std::out_of_range for a key that is none of kWorldSettings.
  const Rational& setting(const std::string& key) const { return settings.at(key); }
};

/// The settings that proofs depend on; besides them, `tracking`.
extern const std::vector<std::string> kWorldSettings;

/// Reads a flight world; `overrides` are `key=value` as for `tern fly --set`, and win. Throws InputError.
World parse_world(const std::string& text, const std::string& name, const std::vector<std::string>& overrides);

/// Blocks, cylinders and the walls around the boundary.
std::vector<Solid> solids_of(const World& world);

/// The limits that plans of this world keep.
std::vector<Bound> bounds_of(const World& world);

/// In what two worlds differ first, in words; empty where they are the same.
std::string difference(const World& a, const World& b);

}  // namespace tern_verify

#endif
