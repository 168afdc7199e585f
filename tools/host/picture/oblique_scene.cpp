// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/oblique_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "host/picture/axes.hpp"
#include "host/picture/legend.hpp"
#include "host/picture/map_view.hpp"
#include "host/picture/outline.hpp"

namespace tern_host {
namespace {

using tern::Box;
using tern::Vec3;

constexpr double kGroundLines = 12.0;

/// The part of a box within another; its lower corner is above its upper one where there is none.
Box common_part(const Box& a, const Box& b) {
  return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y), std::max(a.lower.z, b.lower.z)},
          {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y), std::min(a.upper.z, b.upper.z)}};
}

bool is_box(const Box& box) {
  return box.lower.x < box.upper.x && box.lower.y < box.upper.y && box.lower.z < box.upper.z;
}

/// The size of a box to a factor of two, so that boxes of one size are equals whatever their rounding.
int size_class(const Box& box) {
  return std::ilogb((box.upper.x - box.lower.x) * (box.upper.y - box.lower.y) * (box.upper.z - box.lower.z));
}

/// Where a block stands among those of its size: spread evenly over the file's order.
std::uint32_t spread(std::size_t index) {
  return static_cast<std::uint32_t>(index) * 2654435761u;
}

std::vector<Block> blocks_within(const Scenario& scenario) {
  std::vector<Block> blocks;
  for (const Block& block : scenario.blocks) {
    const Box box = common_part(block.box, scenario.boundary);
    if (is_box(box)) blocks.push_back({box, block.keepout});
  }
  return blocks;
}

/// The blocks to draw: all, or the largest.
std::vector<Block> drawn_blocks(const Scenario& scenario) {
  const std::vector<Block> blocks = blocks_within(scenario);
  std::vector<std::pair<int, std::uint32_t>> ranks;  // ascending: what to draw first
  for (std::size_t i = 0; i < blocks.size(); ++i) ranks.push_back({-size_class(blocks[i].box), spread(i)});
  std::vector<std::size_t> order(blocks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ranks[a] < ranks[b]; });
  if (order.size() > kMaxObliqueBlocks) order.resize(kMaxObliqueBlocks);
  std::vector<Block> drawn;
  for (const std::size_t i : order) drawn.push_back(blocks[i]);
  return drawn;
}

}  // namespace

ObliqueScene::ObliqueScene(const Scenario& scenario, const ObliqueCamera& camera)
    : scenario_(scenario), camera_(camera) {
  for (const Block& block : drawn_blocks(scenario)) {
    boxes_.push_back(camera.turned(block.box));
    keepout_.push_back(block.keepout);
  }
}

void ObliqueScene::draw_ground(Canvas& canvas) const {
  const Vec3& lo = scenario_.boundary.lower;
  const Vec3& hi = scenario_.boundary.upper;
  const auto ground = [&](double x, double y) { return camera_.project({x, y, lo.z}); };
  canvas.polygon({ground(lo.x, lo.y), ground(hi.x, lo.y), ground(hi.x, hi.y), ground(lo.x, hi.y)}, "class=\"ground\"");
  const double longer = std::max(hi.x - lo.x, hi.y - lo.y);
  const auto lines = [&](double low, double high) {
    return ticks({low, high}, kGroundLines * (high - low) / std::max(longer, 1e-9));
  };
  for (const double x : lines(lo.x, hi.x)) canvas.line(ground(x, lo.y), ground(x, hi.y), "class=\"ground-line\"");
  for (const double y : lines(lo.y, hi.y)) canvas.line(ground(lo.x, y), ground(hi.x, y), "class=\"ground-line\"");
}

void ObliqueScene::draw_blocks(Canvas& canvas) const {
  for (const std::size_t i : back_to_front(boxes_)) {
    const Vec3& a = boxes_[i].lower;
    const Vec3& b = boxes_[i].upper;
    const auto face = [&](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, const char* name) {
      canvas.polygon(
          {camera_.project_turned(p), camera_.project_turned(q), camera_.project_turned(r), camera_.project_turned(s)},
          std::string("class=\"") + (keepout_[i] ? "keepout-" : "block-") + name + "\"");
    };
    face({a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}, "front");
    face({b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}, "side");
    face({a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}, "top");
  }
}

void ObliqueScene::draw_fences(Canvas& canvas, tern::FenceKind kind) const {
  for (const FenceRecord& fence : scenario_.fences) {
    if (fence.fence.kind != kind) continue;
    std::vector<Pixel> corners;
    for (const Vec3& v : fence_corners(fence, scenario_.boundary)) corners.push_back(camera_.project(v));
    const std::vector<Pixel> outline = convex_hull(corners);
    if (!outline.empty()) canvas.polygon(outline, fence_style(fence.fence));
  }
}

bool ObliqueScene::hidden(const Vec3& world) const {
  const Vec3 point = camera_.turned(world);
  return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& box) { return ObliqueCamera::hides(box, point); });
}

}  // namespace tern_host
