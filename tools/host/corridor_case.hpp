// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corridor programmes as text: joints, durations, polyhedra and limits of one minimum-snap problem, for the solver
// alone. The format is in docs/formats.md.
#ifndef TERN_HOST_CORRIDOR_CASE_HPP
#define TERN_HOST_CORRIDOR_CASE_HPP

#include <string>
#include <vector>

#include "host/text_records.hpp"
#include "tern/corridor.hpp"

namespace tern_host {

/// One problem: degree 7, C3, from a state to rest. SI units.
struct CorridorCase {
  std::string id;
  std::string kind;  ///< class of problem that it stands for; free text
  int segments = 0;
  bool start_jerk_fixed = true;
  bool goal_jerk_fixed = true;
  double v_max = 0.0;        ///< of every control point of the velocity, an axis
  double a_max = 0.0;        ///< of every control point of the acceleration, an axis
  tern::Vec3 start[4] = {};  ///< position, velocity, acceleration, jerk
  tern::Vec3 goal{};
  tern::Vec3 shift{};                                ///< of the start's position, for a warm start
  std::vector<double> durations;                     ///< one a segment, > 0
  std::vector<tern::Vec3> waypoints;                 ///< segments + 1; positions of joints are counted from them
  std::vector<std::vector<tern::Halfspace>> planes;  ///< of each segment's polyhedron
};

/// Parses a whole case. Throws RecordError; a case beyond a compiled capacity is an error that names the constant.
CorridorCase parse_corridor_case(const std::string& text, const std::string& name);

/// Reads and parses a file. Throws RecordError.
CorridorCase read_corridor_case(const std::string& path);

}  // namespace tern_host

#endif
