// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/map_picture.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"
#include "host/picture/colours.hpp"
#include "host/picture/layout.hpp"
#include "host/picture/legend.hpp"
#include "host/picture/lettering.hpp"
#include "host/picture/merged_blocks.hpp"
#include "host/picture/oblique_scene.hpp"

namespace tern_host {
namespace {

using tern::Voxel;

constexpr double kMaxView = 520.0;   // height of the oblique view
constexpr double kMaxSlice = 420.0;  // height of a slice
constexpr double kGap = 28.0;
constexpr int kSlices = 4;
constexpr int kColumns = 2;       // of slices
constexpr int kGroundTiles = 64;  // along the longer side
constexpr const char* kUnknownStyle = "class=\"unknown\" fill=\"#b9a7d3\"";

/// How much of the columns of voxels over a tile of the ground is unknown.
double unknown_part(const GridMap& map, const Voxel& from, const Voxel& to) {
  std::int64_t unknown = 0;
  std::int64_t all = 0;
  for (int z = map.begin.z; z < map.end.z; ++z) {
    for (int y = from.y; y < to.y; ++y) {
      for (int x = from.x; x < to.x; ++x, ++all) unknown += map.is_unknown({x, y, z}) ? 1 : 0;
    }
  }
  return all > 0 ? static_cast<double>(unknown) / static_cast<double>(all) : 0.0;
}

void draw_unknown_ground(Canvas& canvas, const GridMap& map, const ObliqueCamera& camera, const tern::Box& boundary) {
  const tern::GridSpec& spec = map.grid.spec();
  const int step = std::max(1, (std::max(spec.dims.x, spec.dims.y) + kGroundTiles - 1) / kGroundTiles);
  const auto ground = [&](int x, int y) {
    return camera.project({std::clamp(spec.origin.x + spec.cell * x, boundary.lower.x, boundary.upper.x),
                           std::clamp(spec.origin.y + spec.cell * y, boundary.lower.y, boundary.upper.y),
                           boundary.lower.z});
  };
  for (int y = map.begin.y; y < map.end.y; y += step) {
    for (int x = map.begin.x; x < map.end.x; x += step) {
      const int x1 = std::min(x + step, map.end.x);
      const int y1 = std::min(y + step, map.end.y);
      const double part = unknown_part(map, {x, y, 0}, {x1, y1, 0});
      if (part <= 0.0) continue;
      canvas.polygon({ground(x, y), ground(x1, y), ground(x1, y1), ground(x, y1)},
                     std::string(kUnknownStyle) + " opacity=\"" + fixed(0.15 + 0.75 * part, 2) + "\"");
    }
  }
}

/// Draws the voxels of a slice for which `holds`, as rectangles of runs along x.
template <typename Holds>
void draw_voxels(Canvas& canvas, const Rect& frame, const Voxel& dims, const std::string& style, Holds holds) {
  MergedBlocks merged(frame);
  const double cell = frame.width / dims.x;
  for (int y = 0; y < dims.y; ++y) {
    for (int x = 0; x < dims.x; ++x) {
      if (!holds(x, y)) continue;
      const int first = x;
      while (x < dims.x && holds(x, y)) ++x;
      merged.add({frame.x + cell * first, frame.bottom() - cell * (y + 1), cell * (x - first), cell}, 1.0);
    }
  }
  merged.draw(canvas, style, 0.3, 0.0, 1.0);
}

void draw_slice(Canvas& canvas, const GridMap& map, int z, const Rect& frame) {
  const tern::GridSpec& spec = map.grid.spec();
  const double height = spec.origin.z + spec.cell * (z + 0.5);
  canvas.text({frame.x, frame.y - 8.0}, "Slice at z = " + fixed(height, 2) + " m", "class=\"label\"");
  canvas.rect(frame, "class=\"paper\"");
  const auto solid = [&](int x, int y) { return map.grid.obstacle({x, y, z}); };
  const auto unknown = [&](int x, int y) { return map.is_unknown({x, y, z}); };
  draw_voxels(canvas, frame, spec.dims, "class=\"inflated\"", [&](int x, int y) {
    return !map.grid.free({x, y, z}) && !solid(x, y) && !unknown(x, y);
  });
  draw_voxels(canvas, frame, spec.dims, kUnknownStyle, unknown);
  draw_voxels(canvas, frame, spec.dims, "class=\"merged-block\"",
              [&](int x, int y) { return solid(x, y) && !unknown(x, y); });
  canvas.rect(frame, "class=\"frame\"");
}

/// Returns where they end.
double draw_slices(Canvas& canvas, const GridMap& map, double y) {
  const Voxel& dims = map.grid.spec().dims;
  const double column = (kContentWidth - (kColumns - 1) * kGap) / kColumns;
  const double cell = std::min(column / dims.x, kMaxSlice / dims.y);
  const int slices = std::min(kSlices, dims.z);
  for (int k = 0; k < slices; ++k) {
    const Rect frame{kPageMargin + (k % kColumns) * (column + kGap), y + kGap, cell * dims.x, cell * dims.y};
    draw_slice(canvas, map, (2 * k + 1) * dims.z / (2 * slices), frame);
    if (k % kColumns == kColumns - 1 || k == slices - 1) y = frame.bottom();
  }
  return y;
}

std::vector<LegendEntry> entries(const GridMap& map) {
  std::vector<LegendEntry> list{area_entry("obstacle", "class=\"merged-block\""),
                                area_entry("too near to one for the robot's centre", "class=\"inflated\"")};
  if (map.unknown_count > 0) list.push_back(area_entry("unknown; on the ground, all that stands above", kUnknownStyle));
  return list;
}

}  // namespace

std::string map_svg(const Scenario& scenario, const GridMap& map) {
  Canvas page;
  const std::string name = fit_text(scenario.name, kHeading, kContentWidth);
  page.text({kPageMargin, 40.0}, name, "class=\"heading\"");
  const std::vector<LegendEntry> legend = entries(map);
  draw_legend(page, legend, {kPageMargin, 56.0}, kContentWidth);
  const double top = 68.0 + kLegendRow * legend_rows(legend, kContentWidth);
  ObliqueCamera camera(scenario.boundary);
  camera.fit({kPageMargin, top, kContentWidth, kMaxView});
  const ObliqueScene scene(scenario, camera);
  scene.draw_ground(page);
  draw_unknown_ground(page, map, camera, scenario.boundary);
  scene.draw_blocks(page);
  const double height = draw_slices(page, map, camera.bottom() + kGap) + kPageMargin;
  Canvas canvas;
  canvas.rect({0.0, 0.0, kPageWidth, height}, "fill=\"#ffffff\"");
  canvas.raw(page.body());
  return canvas.document(kPageWidth, height, style_sheet());
}

}  // namespace tern_host
