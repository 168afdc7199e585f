// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The corridor stage on random maps of cuboids, a family a row: microseconds a segment, half-spaces, volumes, what the
// polyhedra share and what of them is not free; and what the local box saves. Cases: TERN_SHARED_DIR/cases/corridor.
//
// tern_bench_corridor [--csv FILE]: prints the tables, and writes them to the file where one is given.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "corridor/grow.hpp"
#include "support/corridor_case.hpp"
#include "tern_port/port.hpp"
#include "volume.hpp"

namespace {

using tern::Box;
using tern::Grid;
using tern::GrowScratch;
using tern::Polyhedron;
using tern::Status;
using tern::Vec3;
using tern_test::CorridorCase;

constexpr double kCell = 0.1;
constexpr int kMapsOfFamily = 3;
/// Each segment is grown so often, and its least time counts: the rest is other programs'.
constexpr int kTimings = 7;

/// A case's map as a grid at kCell, radius 0.
struct Map {
  std::vector<std::uint64_t> words;
  Grid grid;
};

std::unique_ptr<Map> lay_out(const CorridorCase& c) {
  auto map = std::make_unique<Map>();
  tern::GridSpec spec{};
  spec.cell = kCell;
  const Vec3& upper = c.boundary.upper;
  spec.dims = {static_cast<int>(std::lround(upper.x / kCell)), static_cast<int>(std::lround(upper.y / kCell)),
               static_cast<int>(std::lround(upper.z / kCell))};
  spec.boundary = c.boundary;
  map->words.resize(tern::grid_words(spec.dims));
  map->grid.bind(spec, map->words.data(), map->words.size());
  for (const Box& block : c.blocks) map->grid.mark_box(block);
  return map;
}

/// One figure a segment each, of one family.
struct Samples {
  std::vector<double> microseconds, planes_made, planes, volume, line_volume;
  std::vector<double> checks, checks_without, voxels, voxels_without;
  std::vector<double> overlap;  ///< a joint: the common ball's radius
  double unsafe = 0.0;          ///< cubic metres inside obstacle voxels, all polyhedra
  int failed = 0;
};

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}
double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}
double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (const double v : values) total += v;
  return total;
}

bool on_surface(const Grid& grid, const tern::Voxel& v) {
  return !(grid.obstacle({v.x - 1, v.y, v.z}) && grid.obstacle({v.x + 1, v.y, v.z}) &&
           grid.obstacle({v.x, v.y - 1, v.z}) && grid.obstacle({v.x, v.y + 1, v.z}) &&
           grid.obstacle({v.x, v.y, v.z - 1}) && grid.obstacle({v.x, v.y, v.z + 1}));
}

/// Calls `visit(voxel)` for every obstacle voxel whose cube meets the box.
template <typename Visit>
void for_obstacles(const Grid& grid, const Box& box, Visit visit) {
  const auto low = [](double v) { return std::max(0, static_cast<int>(std::floor(v / kCell))); };
  const auto high = [](double v, int dim) { return std::min(dim, static_cast<int>(std::ceil(v / kCell))); };
  const tern::Voxel& dims = grid.spec().dims;
  for (int z = low(box.lower.z); z < high(box.upper.z, dims.z); ++z) {
    for (int y = low(box.lower.y); y < high(box.upper.y, dims.y); ++y) {
      for (int x = low(box.lower.x); x < high(box.upper.x, dims.x); ++x) {
        if (grid.obstacle({x, y, z})) visit(tern::Voxel{x, y, z});
      }
    }
  }
}

double count_surface(const Grid& grid, const Box& box) {
  int count = 0;
  for_obstacles(grid, box, [&](const tern::Voxel& v) { count += on_surface(grid, v) ? 1 : 0; });
  return count;
}

Box around(const Vec3& a, const Vec3& b, double margin) {
  return {{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin, std::min(a.z, b.z) - margin},
          {std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin, std::max(a.z, b.z) + margin}};
}

bool cut_off(const std::vector<tern::Halfspace>& planes, const Box& cube) {
  return std::any_of(planes.begin(), planes.end(), [&](const tern::Halfspace& h) {
    const double x = std::min(h.normal.x * cube.lower.x, h.normal.x * cube.upper.x);
    const double y = std::min(h.normal.y * cube.lower.y, h.normal.y * cube.upper.y);
    const double z = std::min(h.normal.z * cube.lower.z, h.normal.z * cube.upper.z);
    return x + y + z >= h.offset;
  });
}

/// Cubic metres of the polyhedron inside obstacle voxels, taken as solid cubes.
double unsafe_volume(const Grid& grid, const Polyhedron& polyhedron) {
  const std::vector<tern::Halfspace> planes = tern_bench::bounding_planes(polyhedron);
  double total = 0.0;
  for_obstacles(grid, around(polyhedron.from, polyhedron.to, tern::kLocalMargin), [&](const tern::Voxel& v) {
    const Box cube{{v.x * kCell, v.y * kCell, v.z * kCell}, {(v.x + 1) * kCell, (v.y + 1) * kCell, (v.z + 1) * kCell}};
    if (cut_off(planes, cube)) return;
    std::vector<tern::Halfspace> both = tern_bench::planes_of(cube);
    both.insert(both.end(), planes.begin(), planes.end());
    total += tern_bench::volume(both);
  });
  return total;
}

Status grow_timed(const Grid& grid, const Vec3& from, const Vec3& to, GrowScratch& scratch, Polyhedron& out,
                  double& least) {
  Status status = Status::kOk;
  for (int i = 0; i < kTimings && status == Status::kOk; ++i) {
    reset_counters(scratch);
    const std::uint64_t before = tern_port::ticks(nullptr);
    status = grow_polyhedron(grid, from, to, scratch, out);
    const double taken =
        static_cast<double>(tern_port::ticks(nullptr) - before) * (1e6 / tern_port::ticks_per_second());
    least = i == 0 ? taken : std::min(least, taken);
  }
  return status;
}

/// The same segment with a box as wide as the map: what is looked at where nothing bounds it.
void count_checks(const Grid& grid, const Polyhedron& polyhedron, double map_surface, GrowScratch& scratch,
                  Samples& samples) {
  const auto other = std::make_unique<Polyhedron>();
  samples.checks.push_back(scratch.checks);
  samples.voxels.push_back(count_surface(grid, around(polyhedron.from, polyhedron.to, tern::kLocalMargin)));
  samples.voxels_without.push_back(map_surface);
  reset_counters(scratch);
  scratch.margin = 1e4;
  grow_polyhedron(grid, polyhedron.from, polyhedron.to, scratch, *other);
  samples.checks_without.push_back(scratch.checks);
}

/// Grows one segment and notes all but what belongs to `segment` or `polyline` records alone. False where it fails.
bool measure(const Grid& grid, const Vec3& from, const Vec3& to, GrowScratch& scratch, Polyhedron& out,
             Samples& samples) {
  double least = 0.0;
  if (grow_timed(grid, from, to, scratch, out, least) != Status::kOk) {
    ++samples.failed;
    return false;
  }
  samples.microseconds.push_back(least);
  samples.planes_made.push_back(all_planes(out));
  samples.planes.push_back(out.count);
  samples.unsafe += unsafe_volume(grid, out);
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

void measure_polyline(const Grid& grid, const std::vector<Vec3>& line, GrowScratch& scratch, Samples& samples) {
  const auto polyhedron = std::make_unique<Polyhedron>();
  double room_before = -1.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (!measure(grid, line[i], line[i + 1], scratch, *polyhedron, samples)) return;
    samples.line_volume.push_back(tern_bench::volume(tern_bench::bounding_planes(*polyhedron)));
    if (i > 0) samples.overlap.push_back(std::min(room_before, room_at(*polyhedron, line[i])));
    room_before = room_at(*polyhedron, line[i + 1]);
  }
}

void measure_case(const CorridorCase& c, Samples& samples) {
  const std::unique_ptr<Map> map = lay_out(c);
  const auto scratch = std::make_unique<GrowScratch>();
  const auto polyhedron = std::make_unique<Polyhedron>();
  const double map_surface = count_surface(map->grid, c.boundary);
  for (const auto& segment : c.segments) {
    if (!measure(map->grid, segment[0], segment[1], *scratch, *polyhedron, samples)) continue;
    samples.volume.push_back(tern_bench::volume(tern_bench::bounding_planes(*polyhedron)));
    count_checks(map->grid, *polyhedron, map_surface, *scratch, samples);
  }
  for (const std::vector<Vec3>& line : c.polylines) measure_polyline(map->grid, line, *scratch, samples);
}

/// One line of the tables, to the terminal and to the file.
struct Output {
  std::ofstream csv;

  void row(const std::string& family, const Samples& s) {
    const double least_overlap = s.overlap.empty() ? 0.0 : *std::min_element(s.overlap.begin(), s.overlap.end());
    const double figures[] = {median(s.microseconds),
                              quantile(s.microseconds, 0.99),
                              quantile(s.microseconds, 1.0),
                              median(s.planes_made),
                              median(s.planes),
                              sum(s.planes_made),
                              sum(s.planes),
                              median(s.volume),
                              median(s.line_volume),
                              least_overlap,
                              s.unsafe,
                              median(s.checks),
                              median(s.checks_without),
                              median(s.voxels),
                              median(s.voxels_without)};
    std::printf(
        "%-10s %5.1f %5.1f %6.1f  %3.0f %3.0f (%.2f)  %6.2f %6.2f  %.4f  %.1e  %d  | %5.0f %5.0f  %6.0f %6.0f\n",
        family.c_str(), figures[0], figures[1], figures[2], figures[3], figures[4], figures[6] / figures[5], figures[7],
        figures[8], figures[9], figures[10], s.failed, figures[11], figures[12], figures[13], figures[14]);
    csv << family;
    for (const double figure : figures) csv << ',' << figure;
    csv << ',' << s.failed << '\n';
  }
};

/// Means over all segments: without the local box the paper looks at every obstacle of the map.
void print_savings(const char* what, const std::vector<double>& with, const std::vector<double>& without) {
  std::printf("%s: %.0f a segment with the local box, %.0f without: %.1f %% fewer (the paper: 53.2 %%)\n", what,
              sum(with) / static_cast<double>(with.size()), sum(without) / static_cast<double>(without.size()),
              100.0 * (1.0 - sum(with) / sum(without)));
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

Samples measure_family(const std::string& family) {
  Samples samples;
  for (int m = 0; m < kMapsOfFamily; ++m) {
    CorridorCase c;
    const std::string file = std::string(TERN_SHARED_DIR) + "/cases/corridor/" + family + "_m" + std::to_string(m);
    if (read_corridor_case(file + ".txt", c)) measure_case(c, samples);
  }
  return samples;
}

}  // namespace

int main(int argc, char** argv) {
  Output output;
  const bool to_file = argc == 3 && std::string(argv[1]) == "--csv";
  if (argc != 1 && !to_file) {
    std::fprintf(stderr, "usage: tern_bench_corridor [--csv FILE]\n");
    return 2;
  }
  if (to_file) output.csv.open(argv[2]);
  output.csv << "family,median_us,p99_us,max_us,planes_made,planes,all_planes_made,all_planes,segment_volume_m3,"
                "polyline_volume_m3,least_overlap_m,unsafe_m3,checks,checks_without_box,voxels,voxels_without_box,"
                "failed\n";
  std::printf(
      "family     us a segment         half-spaces     volume m3      least    unsafe    failed | box checks   "
      "voxels\n");
  std::printf(
      "           median p99 max       made kept (all) segm.  polyl.  overlap  m3               | with w/o     "
      "with w/o\n");
  Samples all;
  for (const char* family : {"small_10", "small_30", "medium_10", "medium_30", "large_10", "large_30"}) {
    const Samples samples = measure_family(family);
    if (samples.microseconds.empty()) {
      std::fprintf(stderr, "no cases of %s under %s/cases/corridor\n", family, TERN_SHARED_DIR);
      return 2;
    }
    output.row(family, samples);
    append(all.checks, samples.checks);
    append(all.checks_without, samples.checks_without);
    append(all.voxels, samples.voxels);
    append(all.voxels_without, samples.voxels_without);
  }
  print_savings("obstacle boxes checked", all.checks, all.checks_without);
  print_savings("surface voxels a search", all.voxels, all.voxels_without);
  return 0;
}
