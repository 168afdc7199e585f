// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "measure.hpp"

#include <algorithm>
#include <memory>

#include "baselines/paper_corridor.hpp"
#include "corridor/corridor_stage.hpp"
#include "corridor/grow.hpp"
#include "map.hpp"
#include "support/at_once.hpp"
#include "tern_port/port.hpp"
#include "volume.hpp"

namespace tern_bench {
namespace {

using tern::Box;
using tern::Grid;
using tern::GrowScratch;
using tern::Polyhedron;
using tern::Status;
using tern::Vec3;
using tern_test::CorridorCase;

/// Each segment is grown so often, and its least time counts: the rest is other programs'.
constexpr int kTimings = 7;

Status grow_timed(const Grid& grid, const Vec3& from, const Vec3& to, GrowScratch& scratch, Polyhedron& out,
                  double& least) {
  Status status = Status::kOk;
  for (int i = 0; i < kTimings && status == Status::kOk; ++i) {
    reset_counters(scratch);
    const std::uint64_t before = tern_port::ticks(nullptr);
    status = tern_test::grow_polyhedron(tern::World(grid), from, to, scratch, out);
    const double taken =
        static_cast<double>(tern_port::ticks(nullptr) - before) * (1e6 / tern_port::ticks_per_second());
    least = i == 0 ? taken : std::min(least, taken);
  }
  return status;
}

/// What a search over voxels looks at in the local box, and where nothing bounds it.
void count_voxels(const Map& map, const Polyhedron& polyhedron, Samples& samples) {
  samples.voxels.push_back(count_surface(map, around(polyhedron.from, polyhedron.to, tern::kLocalMargin)));
  samples.voxels_without.push_back(static_cast<double>(map.surface.size()));
}

/// Grows one segment and notes all but what belongs to `segment` or `polyline` records alone. False where it fails.
bool measure_segment(const Map& map, const Vec3& from, const Vec3& to, GrowScratch& scratch, Polyhedron& out,
                     Samples& samples) {
  double least = 0.0;
  if (grow_timed(map.grid, from, to, scratch, out, least) != Status::kOk) {
    ++samples.failed;
    return false;
  }
  samples.microseconds.push_back(least);
  samples.planes.push_back(out.count);
  samples.unsafe += unsafe_volume(map, out);
  return true;
}

double room_at(const Polyhedron& polyhedron, const Vec3& p) {
  double room = 1e9;
  for (int i = 0; i < polyhedron.count; ++i) {
    const tern::Halfspace& h = polyhedron.planes[i];
    room = std::min(room, h.offset - (h.normal.x * p.x + h.normal.y * p.y + h.normal.z * p.z));
  }
  return room;
}

/// Volume by the paper's method, which takes voxels for points, within the same local box and the boundary.
double paper_volume(const Map& map, const Vec3& from, const Vec3& to) {
  std::vector<tern::Halfspace> planes = grow_paper_polyhedron(from, to, map.surface, tern::kLocalMargin).planes;
  for (const Box& box : {around(from, to, tern::kLocalMargin), map.grid.local_boundary()}) {
    const std::vector<tern::Halfspace> faces = planes_of(box);
    planes.insert(planes.end(), faces.begin(), faces.end());
  }
  return volume(planes);
}

void measure_polyline(const Map& map, const std::vector<Vec3>& line, GrowScratch& scratch, Samples& samples) {
  const auto polyhedron = std::make_unique<Polyhedron>();
  double room_before = -1.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (!measure_segment(map, line[i], line[i + 1], scratch, *polyhedron, samples)) return;
    samples.line_volume.push_back(volume(bounding_planes(*polyhedron)));
    samples.paper_line_volume.push_back(paper_volume(map, line[i], line[i + 1]));
    if (i > 0) samples.overlap.push_back(std::min(room_before, room_at(*polyhedron, line[i])));
    room_before = room_at(*polyhedron, line[i + 1]);
  }
}

/// The polyline as a path: how many polyhedra the stage makes for its legs.
void count_reuse(const Map& map, const std::vector<Vec3>& line, Samples& samples) {
  if (line.size() > static_cast<std::size_t>(tern::kMaxWaypoints)) return;
  const auto path = std::make_unique<tern::Path>();
  const auto stage = std::make_unique<tern::CorridorStage>();
  const auto corridor = std::make_unique<tern::Corridor>();
  path->count = static_cast<int>(line.size());
  std::copy(line.begin(), line.end(), path->points);
  corridor_begin(*stage, *path);
  tern::Work work{0xFFFFFFFFu};
  if (corridor_advance(*stage, tern::World(map.grid), *path, work, *corridor) != tern::Progress::kDone) {
    ++samples.failed;
    return;
  }
  samples.legs += path->count - 1;
  samples.polyhedra += corridor->count;
}

}  // namespace

void measure_case(const CorridorCase& c, Samples& samples) {
  const std::unique_ptr<Map> map = lay_out(c);
  const auto scratch = std::make_unique<GrowScratch>();
  const auto polyhedron = std::make_unique<Polyhedron>();
  for (const auto& segment : c.segments) {
    if (!measure_segment(*map, segment[0], segment[1], *scratch, *polyhedron, samples)) continue;
    samples.volume.push_back(volume(bounding_planes(*polyhedron)));
    samples.paper_volume.push_back(paper_volume(*map, segment[0], segment[1]));
    count_voxels(*map, *polyhedron, samples);
  }
  for (const std::vector<Vec3>& line : c.polylines) {
    measure_polyline(*map, line, *scratch, samples);
    count_reuse(*map, line, samples);
  }
}

}  // namespace tern_bench
