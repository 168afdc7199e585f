// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/map_view.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"
#include "host/picture/colours.hpp"
#include "host/picture/ends.hpp"
#include "host/picture/heading_view.hpp"
#include "host/picture/legend.hpp"
#include "host/picture/merged_blocks.hpp"
#include "host/picture/moving_view.hpp"
#include "host/picture/outline.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr int kTrajectorySamples = 700;

/// One view's mapping from the world to the picture.
class View {
 public:
  View(const Axes& axes, const Projection& projection) : axes_(axes), projection_(projection) {}

  Pixel world(const Vec3& p) const { return project(axes_, projection_, p); }
  Rect box(const tern::Box& box, double margin) const {
    const Pixel a = world(box.lower);
    const Pixel b = world(box.upper);
    const double grow = margin * scale();
    return {std::min(a.x, b.x) - grow, std::min(a.y, b.y) - grow, std::fabs(b.x - a.x) + 2.0 * grow,
            std::fabs(b.y - a.y) + 2.0 * grow};
  }
  /// Pixels a metre, the same along both axes.
  double scale() const { return axes_.frame.width / axes_.horizontal.extent(); }
  int depth() const { return projection_.depth; }

 private:
  Axes axes_;
  Projection projection_;
};

Vec3 sum(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// How much of the map's depth a block fills: what blocks the whole way is drawn dark, a window's frame lighter.
double depth_part(const tern::Box& box, const tern::Box& boundary, int depth) {
  const double lower = std::max(component(box.lower, depth), component(boundary.lower, depth));
  const double upper = std::min(component(box.upper, depth), component(boundary.upper, depth));
  const double all = component(boundary.upper, depth) - component(boundary.lower, depth);
  return all > 0.0 ? std::max(0.0, upper - lower) / all : 1.0;
}

std::string axis_title(int axis) {
  return std::string(1, "xyz"[axis]) + " (m)";
}

std::vector<Pixel> fence_outline(const View& view, const FenceRecord& fence, const tern::Box& boundary) {
  std::vector<Pixel> corners;
  for (const Vec3& v : fence_corners(fence, boundary)) corners.push_back(view.world(v));
  return convex_hull(corners);
}

/// Of one kind; without a style, in that of each fence.
void draw_kind(Canvas& canvas, const View& view, const std::vector<FenceRecord>& fences, const tern::Box& boundary,
               tern::FenceKind kind, const std::string& style = "") {
  for (const FenceRecord& fence : fences) {
    const std::vector<Pixel> outline = fence_outline(view, fence, boundary);
    if (fence.fence.kind != kind || outline.empty()) continue;
    canvas.polygon(outline, style.empty() ? fence_style(fence.fence) : style);
  }
}

/// The space that the radius takes around the keep-outs: a stroke of that width.
void draw_fence_margins(Canvas& canvas, const View& view, const Scenario& scenario) {
  const std::string width = fixed(2.0 * scenario.clearance() * view.scale(), 2);
  draw_kind(canvas, view, scenario.fences, scenario.boundary, tern::FenceKind::kKeepOut,
            "class=\"inflated\" stroke=\"#e9ebef\" stroke-linejoin=\"round\" stroke-width=\"" + width + "\"");
}

std::vector<Pixel> chain(const View& view, const Vec3* local, int count, const Vec3& origin) {
  std::vector<Pixel> points;
  for (int i = 0; i < count; ++i) points.push_back(view.world(sum(local[i], origin)));
  return points;
}

/// Returns where it runs.
std::vector<Pixel> draw_trajectory(Canvas& canvas, const View& view, const PlanResult& result, double speed_scale) {
  if (!result.ok()) return {};
  const double end = (1.0 - 1e-9) * tern::duration(result.trajectory);  // at the end itself the speed is 0
  std::vector<Pixel> points;
  std::vector<int> colours;
  for (int i = 0; i <= kTrajectorySamples; ++i) {
    const tern::Sample sample = tern::evaluate(result.trajectory, end * i / kTrajectorySamples);
    const Vec3& v = sample.velocity;
    const double speed = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    points.push_back(view.world(sample.position));
    colours.push_back(static_cast<int>(std::lround(speed / speed_scale * kColourSteps)));
  }
  canvas.polyline(points, "class=\"halo\"");
  std::vector<Pixel> run{points[0]};
  for (std::size_t i = 1; i < points.size(); ++i) {
    run.push_back(points[i]);
    if (i + 1 < points.size() && colours[i + 1] == colours[i]) continue;
    const double part = static_cast<double>(colours[i]) / kColourSteps;
    canvas.polyline(run, "class=\"trajectory\" stroke=\"" + speed_colour(part) + "\"");
    run = {points[i]};
  }
  return points;
}

void draw_waypoints(Canvas& canvas, const std::vector<Pixel>& waypoints) {
  for (std::size_t i = 1; i + 1 < waypoints.size(); ++i) canvas.circle(waypoints[i], 3.6, "class=\"waypoint\"");
}

/// From so many blocks on, rectangles of their own would make a file too large to show.
constexpr std::size_t kMaxDrawnBlocks = 1000;
constexpr double kFaintest = 0.15;  // opacity of what fills least of the depth
constexpr double kDepthSpan = 0.65;

void draw_blocks(Canvas& canvas, const View& view, const Scenario& scenario) {
  for (const Block& block : scenario.blocks) {
    canvas.rect(view.box(block.box, scenario.clearance()), "class=\"inflated\"", scenario.clearance() * view.scale());
  }
  for (const Block& block : scenario.blocks) {
    const double part = depth_part(block.box, scenario.boundary, view.depth());
    const char* const kind = block.keepout ? "keepout" : "block";
    canvas.rect(view.box(block.box, 0.0),
                std::string("class=\"") + kind + "\" opacity=\"" + fixed(kFaintest + kDepthSpan * part, 2) + "\"");
  }
}

/// A rectangle grown by the radius, its rounded corners by three rectangles inside it.
void add_inflated(MergedBlocks& raster, const View& view, const tern::Box& box, double radius) {
  const Rect core = view.box(box, 0.0);
  const double whole = radius * view.scale();
  for (const double dx : {whole, 0.0, whole * std::sqrt(0.5)}) {
    const double dy = std::sqrt(std::max(0.0, whole * whole - dx * dx));
    raster.add({core.x - dx, core.y - dy, core.width + 2.0 * dx, core.height + 2.0 * dy}, 1.0);
  }
}

void draw_merged_blocks(Canvas& canvas, const Rect& frame, const View& view, const Scenario& scenario) {
  MergedBlocks inflated(frame);
  MergedBlocks matter(frame);
  MergedBlocks keepouts(frame);
  for (const Block& block : scenario.blocks) {
    add_inflated(inflated, view, block.box, scenario.clearance());
    const double part = depth_part(block.box, scenario.boundary, view.depth());
    (block.keepout ? keepouts : matter).add(view.box(block.box, 0.0), part);
  }
  inflated.draw(canvas, "class=\"inflated\"", 0.5, 1.0, 0.0);
  matter.draw(canvas, "class=\"merged-block\"", 1e-4, kFaintest, kDepthSpan);
  keepouts.draw(canvas, "class=\"merged-keepout\"", 1e-4, kFaintest, kDepthSpan);
}

}  // namespace

double component(const Vec3& v, int axis) {
  return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

AxisRange view_range(const PlanResult& result, int axis) {
  const tern::Box& boundary = result.scenario.boundary;
  AxisRange range{component(boundary.lower, axis), component(boundary.upper, axis)};
  if (!(range.extent() > 0.0)) range = {range.low - result.grid.cell, range.high + result.grid.cell};
  return range;
}

std::vector<Vec3> fence_corners(const FenceRecord& fence, const tern::Box& boundary) {
  tern::Halfspace faces[tern::kBoxPlanes];
  tern::box_planes(boundary, faces);
  std::vector<tern::Halfspace> planes(faces, faces + tern::kBoxPlanes);
  for (const tern::Halfspace& h : fence.planes) {
    const double norm = std::sqrt(h.normal.x * h.normal.x + h.normal.y * h.normal.y + h.normal.z * h.normal.z);
    planes.push_back({{h.normal.x / norm, h.normal.y / norm, h.normal.z / norm}, h.offset / norm});
  }
  return vertices(planes);
}

Pixel project(const Axes& axes, const Projection& projection, const Vec3& p) {
  return axes.at(component(p, projection.horizontal), component(p, projection.vertical));
}

void draw_obstacles(Canvas& canvas, const Axes& axes, const Projection& projection, const Scenario& scenario) {
  const View view(axes, projection);
  draw_fence_margins(canvas, view, scenario);
  if (scenario.blocks.size() > kMaxDrawnBlocks) {
    draw_merged_blocks(canvas, axes.frame, view, scenario);
  } else {
    draw_blocks(canvas, view, scenario);
  }
  draw_fences(canvas, axes, projection, scenario.fences, scenario.boundary);
}

void draw_fences(Canvas& canvas, const Axes& axes, const Projection& projection, const std::vector<FenceRecord>& fences,
                 const tern::Box& boundary) {
  const View view(axes, projection);
  draw_kind(canvas, view, fences, boundary, tern::FenceKind::kKeepOut);
  draw_kind(canvas, view, fences, boundary, tern::FenceKind::kKeepIn);
}

void draw_ends(Canvas& canvas, const Axes& axes, const Projection& projection, const Scenario& scenario,
               const std::vector<Pixel>& way) {
  std::vector<Pixel> vias;
  for (const tern::Via& via : scenario.vias) vias.push_back(project(axes, projection, via.position));
  draw_via_marks(canvas, axes.frame, vias);
  draw_end_marks(canvas, axes.frame, project(axes, projection, scenario.start.position),
                 project(axes, projection, scenario.goal.position), way);
}

void draw_corridor(Canvas& canvas, const Axes& axes, const Projection& projection, const PlanResult& result) {
  if (result.corridor == nullptr) return;
  for (int i = 0; i < result.corridor->count; ++i) {
    std::vector<Pixel> corners;
    const tern::Polyhedron& polyhedron = result.corridor->polyhedra[i];
    for (const Vec3& v : vertices({polyhedron.planes, polyhedron.planes + polyhedron.count})) {
      corners.push_back(project(axes, projection, sum(v, result.grid.origin)));
    }
    const std::vector<Pixel> outline = convex_hull(corners);
    if (!outline.empty()) canvas.polygon(outline, "class=\"corridor\"");
  }
}

void draw_map_view(Canvas& canvas, const Axes& axes, const Projection& projection, const PlanResult& result,
                   double speed_scale) {
  const View view(axes, projection);
  const Vec3& origin = result.grid.origin;
  canvas.begin_clipped(axes.frame);
  draw_grid(canvas, axes);
  draw_obstacles(canvas, axes, projection, result.scenario);
  draw_corridor(canvas, axes, projection, result);
  draw_things(canvas, result, [&](const Vec3& p) { return view.world(p); });
  canvas.end_group();
  // Below what may lie on the frame: the boundary belongs to free space.
  draw_frame(canvas, axes, axis_title(projection.horizontal), axis_title(projection.vertical));
  if (result.path != nullptr) {
    canvas.polyline(chain(view, result.path->raw, result.path->raw_count, origin), "class=\"raw\"");
  }
  std::vector<Pixel> way = draw_trajectory(canvas, view, result, speed_scale);
  if (result.path != nullptr) {
    const std::vector<Pixel> waypoints = chain(view, result.path->points, result.path->count, origin);
    canvas.polyline(waypoints, "class=\"shortcut\"");
    draw_waypoints(canvas, waypoints);
    way.insert(way.end(), waypoints.rbegin(), waypoints.rend());  // there and back: one chain
  }
  if (projection.depth == 2) draw_noses(canvas, axes, projection, result);
  draw_ends(canvas, axes, projection, result.scenario, way);
  draw_thing_names(
      canvas, result, [&](const Vec3& p) { return view.world(p); }, axes.frame);
}

}  // namespace tern_host
