// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the runs of plans and of flights have in common: numbers that are rounded to what an eye can see, and the
// vehicle's motion as columns.
#ifndef TERN_HOST_PAGE_RUN_JSON_HPP
#define TERN_HOST_PAGE_RUN_JSON_HPP

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/fence_record.hpp"
#include "tern/corridor.hpp"
#include "tern/flatness.hpp"
#include "tern/halfspace.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"
#include "tern/via.hpp"

namespace tern_host {

using RunJson = nlohmann::ordered_json;

/// `value` with so many decimals; null where it is not finite.
RunJson rounded(double value, int decimals = 3);
RunJson rounded(const tern::Vec3& v);
RunJson rounded(const tern::Box& box);

/// Appends x, y and z to a flat list.
void append_point(RunJson& list, const tern::Vec3& v);

/// [nx, ny, nz, offset] for a half-space of the frame whose origin is at `origin`: n . x <= offset in the world.
RunJson halfspace_json(const tern::Halfspace& plane, const tern::Vec3& origin);

RunJson fences_json(const std::vector<FenceRecord>& records);
/// x, y, z and the tolerance of each.
RunJson vias_json(const std::vector<tern::Via>& list);

/// A thing that moves: its shape, and `rows` of place and error, `step` seconds apart; null while it is not there.
struct ShownThing {
  std::string name;
  bool is_fence;
  tern::TrackShape shape;
  double radius;
  tern::Vec3 half;
  double step;
  RunJson rows;
};
RunJson thing_json(const ShownThing& thing);

/// The half-spaces of each polyhedron.
RunJson corridor_json(const tern::Corridor& corridor, const tern::Vec3& origin);

/// The vehicle's motion, one row after the other, `step` seconds apart. World frame, SI units.
class MotionColumns {
 public:
  /// `clearance`: of the centre from the nearest obstacle.
  void add(const tern::Sample& sample, const std::array<double, 4>& quaternion, double clearance);
  /// One more number of a row, in a column of its own.
  void add(const char* column, const RunJson& number) { columns_[column].push_back(number); }
  RunJson json(double step) const { return {{"step", step}, {"columns", columns_}}; }

 private:
  void append(const char* first, const tern::Vec3& v);
  RunJson columns_ = RunJson::object();
};

}  // namespace tern_host

#endif
