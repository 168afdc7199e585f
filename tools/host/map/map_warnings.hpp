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

/// The boundary, and as far around it as an obstacle can matter for a map of this clearance and these voxels, metres.
tern::Box reach_of(const tern::Box& boundary, double clearance, double cell);
tern::Box reach_of(const Scenario& scenario);

/// True where the interiors of two boxes meet; a flat box has those of its points.
bool meets(const tern::Box& a, const tern::Box& b);

/// A question, after ": ", where most of the points would lie within the box if they were in another unit, or had other
/// axes. Empty where they would not.
std::string likely_mistake(const std::vector<tern::Vec3>& points, const tern::Box& box);

/// A record of a file that fills a box, or keeps the flight within it.
struct BoxRecord {
  const char* key;  ///< the record's: `keepin` is the only one that keeps the flight within
  tern::Box box;
  int line;
};

/// Adds a warning for each kind of record of which some add nothing to a map: they lie beyond its reach, or are
/// keep-ins that hold all of its boundary and would not if they were in another unit.
void warn_of_records(const std::vector<BoxRecord>& records, const tern::Box& boundary, const tern::Box& reach,
                     const std::string& file, std::vector<std::string>& warnings);

/// The warning of one map file, or none: its obstacles are few within the boundary. `extent` holds all of them.
void warn_of_map_file(const MapFile& file, const MapContent& content, const std::vector<tern::Vec3>& points,
                      const Scenario& scenario, std::vector<std::string>& warnings);

}  // namespace tern_host

#endif
