// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parts of a map that add nothing to it, or little: most likely they are in another unit, or have other axes.
#ifndef TERN_HOST_MAP_MAP_WARNINGS_HPP
#define TERN_HOST_MAP_MAP_WARNINGS_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "host/scenario.hpp"

namespace tern_host {

/// The boundary, and as far around it as an obstacle can matter.
tern::Box reach_of(const Scenario& scenario);

/// True where the interiors of two boxes meet; a flat box has those of its points.
bool meets(const tern::Box& a, const tern::Box& b);

/// A question, after ": ", where most of the points would lie within the box if they were in another unit, or had other
/// axes. Empty where they would not.
std::string likely_mistake(const std::vector<tern::Vec3>& points, const tern::Box& box);

/// Records of one kind, of which some may be beyond all that matters.
class RecordsWithin {
 public:
  RecordsWithin(const char* key, const tern::Box& reach) : key_(key), reach_(reach) {}

  void add(const tern::Box& box, int line);
  /// Adds one warning if any of them is.
  void warn(const std::string& file, std::vector<std::string>& warnings) const;

 private:
  const char* key_;
  tern::Box reach_;
  std::size_t total_ = 0;
  std::size_t outside_ = 0;
  int first_ = 0;
  std::vector<tern::Vec3> corners_;
};

/// The warning of one map file, or none: its obstacles are few within the boundary. `extent` holds all of them.
void warn_of_map_file(const MapFile& file, const MapContent& content, const std::vector<tern::Vec3>& points,
                      const Scenario& scenario, std::vector<std::string>& warnings);

}  // namespace tern_host

#endif
