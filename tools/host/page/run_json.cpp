// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/page/run_json.hpp"

#include <cmath>
#include <string>

namespace tern_host {

RunJson rounded(double value, int decimals) {
  if (!std::isfinite(value)) return nullptr;
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale + 0.0;  // no -0
}

RunJson rounded(const tern::Vec3& v) {
  return {rounded(v.x), rounded(v.y), rounded(v.z)};
}

RunJson rounded(const tern::Box& box) {
  RunJson list = RunJson::array();
  append_point(list, box.lower);
  append_point(list, box.upper);
  return list;
}

void append_point(RunJson& list, const tern::Vec3& v) {
  for (const double number : {v.x, v.y, v.z}) list.push_back(rounded(number));
}

RunJson halfspace_json(const tern::Halfspace& plane, const tern::Vec3& origin) {
  const tern::Vec3& n = plane.normal;
  const double offset = plane.offset + (n.x * origin.x + n.y * origin.y + n.z * origin.z);
  return {rounded(n.x, 6), rounded(n.y, 6), rounded(n.z, 6), rounded(offset, 4)};
}

void MotionColumns::append(const char* first, const tern::Vec3& v) {
  const std::string name = first;
  columns_[name + "x"].push_back(rounded(v.x));
  columns_[name + "y"].push_back(rounded(v.y));
  columns_[name + "z"].push_back(rounded(v.z));
}

RunJson fences_json(const std::vector<FenceRecord>& records) {
  RunJson fences = RunJson::array();
  for (const FenceRecord& fence : records) {
    RunJson planes = RunJson::array();
    for (const tern::Halfspace& plane : fence.planes) planes.push_back(halfspace_json(plane, {}));
    fences.push_back({{"keep_in", fence.fence.kind == tern::FenceKind::kKeepIn}, {"halfspaces", planes}});
  }
  return fences;
}

RunJson vias_json(const std::vector<tern::Via>& list) {
  RunJson vias = RunJson::array();
  for (const tern::Via& via : list) {
    RunJson entry = rounded(via.position);
    entry.push_back(rounded(via.tolerance));
    vias.push_back(entry);
  }
  return vias;
}

RunJson thing_json(const ShownThing& thing) {
  constexpr const char* kShapes[] = {"ball", "cylinder", "box"};
  return {{"name", thing.name},
          {"fence", thing.is_fence},
          {"shape", kShapes[static_cast<int>(thing.shape)]},
          {"radius", rounded(thing.radius)},
          {"half", rounded(thing.half)},
          {"step", thing.step},
          {"rows", thing.rows}};
}

RunJson corridor_json(const tern::Corridor& corridor, const tern::Vec3& origin) {
  RunJson polyhedra = RunJson::array();
  for (int i = 0; i < corridor.count; ++i) {
    RunJson planes = RunJson::array();
    const tern::Polyhedron& polyhedron = corridor.polyhedra[i];
    for (int k = 0; k < polyhedron.count; ++k) planes.push_back(halfspace_json(polyhedron.planes[k], origin));
    polyhedra.push_back(planes);
  }
  return polyhedra;
}

void MotionColumns::add(const tern::Sample& sample, const std::array<double, 4>& quaternion, double clearance) {
  append("p", sample.position);
  append("v", sample.velocity);
  append("a", sample.acceleration);
  append("j", sample.jerk);
  const char* const names[] = {"qw", "qx", "qy", "qz"};
  for (std::size_t i = 0; i < 4; ++i) columns_[names[i]].push_back(rounded(quaternion[i], 4));
  columns_["clearance"].push_back(rounded(clearance));
}

}  // namespace tern_host
