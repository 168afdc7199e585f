// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/page/known_growth.hpp"

#include <algorithm>
#include <cmath>

namespace tern_host {
namespace {

constexpr float kForEver = -1.0F;
constexpr int kWordBits = 64;

/// Voxels whose middles are between two coordinates.
int first_voxel(double coordinate, double origin, double cell) {
  return static_cast<int>(std::ceil((coordinate - origin) / cell - 0.5));
}

bool bit(const std::uint64_t* row, int x) {
  return ((row[x / kWordBits] >> (x % kWordBits)) & 1u) != 0;
}

}  // namespace

void KnownGrowth::lay_out(const tern::GridSpec& window) {
  laid_out_ = true;
  origin_ = window.origin;
  cell_ = window.cell;
  const double lower[] = {bounds_.lower.x, bounds_.lower.y, bounds_.lower.z};
  const double upper[] = {bounds_.upper.x, bounds_.upper.y, bounds_.upper.z};
  const double origin[] = {origin_.x, origin_.y, origin_.z};
  for (int i = 0; i < 3; ++i) {
    range_[i] = {first_voxel(lower[i], origin[i], cell_), first_voxel(upper[i], origin[i], cell_)};
  }
  const int columns = (range_[0].end - range_[0].begin) * (range_[1].end - range_[1].begin);
  seen_.assign(static_cast<std::size_t>(std::max(columns, 0)), kForEver);
}

/// Voxels by which a window has moved since the first one.
KnownGrowth::Place KnownGrowth::shift(const tern::GridSpec& window) const {
  const auto voxels = [this](double now, double first) { return static_cast<int>(std::lround((now - first) / cell_)); };
  return {voxels(window.origin.x, origin_.x), voxels(window.origin.y, origin_.y), voxels(window.origin.z, origin_.z)};
}

/// Calls visit(x, y, z, row y, row z) for the rows of the window within the range: x is the range along them.
template <typename Visit>
void KnownGrowth::visit_rows(const tern::GridSpec& window, const Visit& visit) const {
  const auto [sx, sy, sz] = shift(window);
  const Range x{std::max(range_[0].begin, sx), std::min(range_[0].end, sx + window.dims.x)};
  for (int z = std::max(range_[2].begin, sz); z < std::min(range_[2].end, sz + window.dims.z); ++z) {
    for (int y = std::max(range_[1].begin, sy); y < std::min(range_[1].end, sy + window.dims.y); ++y) {
      visit(x, sx, y, z, y - sy, z - sz);
    }
  }
}

void KnownGrowth::add_obstacles(float t, const tern::Grid& route) {
  visit_rows(route.spec(), [&](const Range& range, int shift_x, int y, int z, int row_y, int row_z) {
    const std::uint64_t* const row = route.obstacle_row(row_y, row_z);
    for (int x = range.begin; x < range.end; ++x) {
      if (bit(row, x - shift_x)) obstacles_.try_emplace({x, y, z}, Life{t, kForEver}).first->second.until = kForEver;
    }
  });
}

/// Obstacles within the window that are none any more: errors of the sensor, which later frames took back.
void KnownGrowth::end_cleared(float t, const tern::Grid& route) {
  const tern::Voxel& dims = route.spec().dims;
  const auto [sx, sy, sz] = shift(route.spec());
  for (auto& [place, life] : obstacles_) {
    const auto [x, y, z] = place;
    if (life.until >= 0.0F || x < sx || x >= sx + dims.x || y < sy || y >= sy + dims.y || z < sz || z >= sz + dims.z) {
      continue;
    }
    if (!bit(route.obstacle_row(y - sy, z - sz), x - sx)) life.until = t;
  }
}

void KnownGrowth::add_seen(float t, const tern::RollingMap& map) {
  const tern::Grid& route = map.route();
  const int width = range_[0].end - range_[0].begin;
  visit_rows(route.spec(), [&](const Range& range, int shift_x, int y, int, int row_y, int row_z) {
    // The rows of seen voxels lie as those of obstacles do.
    const std::uint64_t* const row = map.seen_rows() + (route.obstacle_row(row_y, row_z) - route.obstacle_row(0, 0));
    for (int x = range.begin; x < range.end; ++x) {
      float& first = seen_[static_cast<std::size_t>((y - range_[1].begin) * width + x - range_[0].begin)];
      if (first < 0.0F && bit(row, x - shift_x)) first = t;
    }
  });
}

void KnownGrowth::note(double t, const tern::RollingMap& map) {
  if (map.busy() || !map.route().bound() || (last_ >= 0.0 && t < last_ + kInterval)) return;
  if (!laid_out_) lay_out(map.route().spec());
  last_ = t;
  const auto time = static_cast<float>(t);
  add_obstacles(time, map.route());
  end_cleared(time, map.route());
  add_seen(time, map);
}

/// Upright columns first, then columns of equal height and life that stand side by side along y.
std::vector<KnownGrowth::Block> KnownGrowth::blocks() const {
  std::vector<Block> blocks;
  std::map<std::tuple<int, int, int, float, float>, std::size_t> last;  // block by x, z, height and life
  for (auto first = obstacles_.begin(); first != obstacles_.end();) {
    const auto [x, y, z] = first->first;
    const Life life = first->second;
    int height = 0;
    while (first != obstacles_.end() && first->first == Place{x, y, z + height} && first->second.from == life.from &&
           first->second.until == life.until) {
      ++height;
      ++first;
    }
    const auto [at, is_new] = last.try_emplace({x, z, height, life.from, life.until}, blocks.size());
    if (!is_new && blocks[at->second].y + blocks[at->second].width == y) {
      ++blocks[at->second].width;
    } else {
      at->second = blocks.size();
      blocks.push_back({x, y, z, 1, height, life});
    }
  }
  std::stable_sort(blocks.begin(), blocks.end(),
                   [](const Block& a, const Block& b) { return a.life.from < b.life.from; });
  return blocks;
}

RunJson KnownGrowth::known_json() const {
  RunJson list = RunJson::array();
  for (const Block& b : blocks()) {
    for (const int number : {b.x, b.y, b.z, b.width, b.height}) list.push_back(number);
    for (const float time : {b.life.from, b.life.until}) list.push_back(rounded(static_cast<double>(time), 1));
  }
  return {{"cell", cell_}, {"origin", rounded(origin_)}, {"blocks", list}};
}

RunJson KnownGrowth::seen_json() const {
  RunJson times = RunJson::array();
  for (const float time : seen_) times.push_back(time < 0.0F ? -1 : static_cast<int>(std::lround(10.0F * time)));
  const int nx = range_[0].end - range_[0].begin;
  const int ny = range_[1].end - range_[1].begin;
  return {{"cell", cell_},
          {"origin", {rounded(origin_.x + cell_ * range_[0].begin), rounded(origin_.y + cell_ * range_[1].begin)}},
          {"size", {nx, ny}},
          {"times", times}};
}

}  // namespace tern_host
