// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corridor cases: maps of cuboids with segments and polylines between them, for tests and benchmarks. One record a
// line: `boundary` and `block` with two corners, `segment` with two points, `polyline` with two points or more.
#ifndef TERN_TESTS_SUPPORT_CORRIDOR_CASE_HPP
#define TERN_TESTS_SUPPORT_CORRIDOR_CASE_HPP

#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tern/vec3.hpp"

namespace tern_test {

/// World frame, metres.
struct CorridorCase {
  tern::Box boundary{};
  std::vector<tern::Box> blocks;
  std::vector<std::array<tern::Vec3, 2>> segments;
  std::vector<std::vector<tern::Vec3>> polylines;
};

inline std::vector<tern::Vec3> read_points(std::istream& in) {
  std::vector<tern::Vec3> points;
  for (tern::Vec3 p; in >> p.x >> p.y >> p.z;) points.push_back(p);
  return points;
}

/// False where the file cannot be opened.
inline bool read_corridor_case(const std::string& file, CorridorCase& out) {
  std::ifstream in(file);
  if (!in) return false;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string record;
    words >> record;
    const std::vector<tern::Vec3> points = read_points(words);
    if (points.size() < 2) continue;
    if (record == "boundary") out.boundary = {points[0], points[1]};
    if (record == "block") out.blocks.push_back({points[0], points[1]});
    if (record == "segment") out.segments.push_back({points[0], points[1]});
    if (record == "polyline") out.polylines.push_back(points);
  }
  return true;
}

/// The segments, then the polylines' pieces.
inline std::vector<std::array<tern::Vec3, 2>> all_segments(const CorridorCase& c) {
  std::vector<std::array<tern::Vec3, 2>> segments = c.segments;
  for (const std::vector<tern::Vec3>& line : c.polylines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) segments.push_back({line[i], line[i + 1]});
  }
  return segments;
}

}  // namespace tern_test

#endif
