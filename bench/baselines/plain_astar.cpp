// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/plain_astar.hpp"

#include <algorithm>
#include <cstdlib>

namespace tern_bench {
namespace {

constexpr std::uint64_t kCosts[] = {0, std::uint64_t{1} << 36, 97184015999, 119025625176};

std::uint64_t octile(const tern::Voxel& a, const tern::Voxel& b) {
  const int x = std::abs(a.x - b.x);
  const int y = std::abs(a.y - b.y);
  const int z = std::abs(a.z - b.z);
  const int low = std::min({x, y, z});
  const int high = std::max({x, y, z});
  const int middle = x + y + z - low - high;
  return static_cast<std::uint64_t>(low) * kCosts[3] + static_cast<std::uint64_t>(middle - low) * kCosts[2] +
         static_cast<std::uint64_t>(high - middle) * kCosts[1];
}

int cell(int dx, int dy, int dz) {
  return (dx + 1) + 3 * (dy + 1) + 9 * (dz + 1);
}

/// Cells of the neighbourhood that a step passes or touches with a corner.
std::uint32_t box_of(const tern::Voxel& s) {
  std::uint32_t box = 0;
  for (int part = 1; part < 8; ++part) {
    box |= 1u << cell((part & 1) != 0 ? s.x : 0, (part & 2) != 0 ? s.y : 0, (part & 4) != 0 ? s.z : 0);
  }
  return box;
}

/// The order of a heap whose top is the first to be expanded: least f, then greatest g, then least index.
struct After {
  template <typename Entry>
  bool operator()(const Entry& a, const Entry& b) const {
    if (a.f != b.f) return a.f > b.f;
    return a.g != b.g ? a.g < b.g : a.index > b.index;
  }
};

}  // namespace

PlainAStar::PlainAStar(const tern::Grid& grid) {
  const tern::Voxel& dims = grid.spec().dims;
  width_ = dims.x + 2;
  slice_ = width_ * (dims.y + 2);
  const auto cells = static_cast<std::size_t>(slice_) * static_cast<std::size_t>(dims.z + 2);
  free_.assign(cells, 0);
  nodes_.assign(cells, {0, 0, -1});
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) free_[static_cast<std::size_t>(index_of({x, y, z}))] = grid.free({x, y, z});
    }
  }
  std::size_t count = 0;
  for (int d = 0; d < 27; ++d) {
    const tern::Voxel step{d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1};
    const int axes = std::abs(step.x) + std::abs(step.y) + std::abs(step.z);
    if (axes == 0) continue;
    moves_[count++] = {step, step.x + width_ * step.y + slice_ * step.z, kCosts[axes], box_of(step)};
  }
}

std::int32_t PlainAStar::index_of(const tern::Voxel& voxel) const {
  return (voxel.x + 1) + width_ * (voxel.y + 1) + slice_ * (voxel.z + 1);
}

tern::Voxel PlainAStar::voxel_of(std::int32_t index) const {
  const std::int32_t in_slice = index % slice_;
  return {in_slice % width_ - 1, in_slice / width_ - 1, index / slice_ - 1};
}

std::uint32_t PlainAStar::free_around(std::int32_t index) const {
  std::uint32_t free = 0;
  int bit = 0;
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dy = -1; dy <= 1; ++dy, bit += 3) {
      const std::uint8_t* row = free_.data() + index + dy * width_ + dz * slice_;
      free |= (row[-1] | static_cast<std::uint32_t>(row[0] << 1) | static_cast<std::uint32_t>(row[1] << 2)) << bit;
    }
  }
  return free;
}

void PlainAStar::push(const Entry& entry) {
  open_.push_back(entry);
  std::push_heap(open_.begin(), open_.end(), After{});
}

PlainAStar::Entry PlainAStar::pop() {
  std::pop_heap(open_.begin(), open_.end(), After{});
  const Entry first = open_.back();
  open_.pop_back();
  return first;
}

void PlainAStar::expand(const Entry& entry, const tern::Voxel& goal) {
  const tern::Voxel at = voxel_of(entry.index);
  const std::uint32_t free = free_around(entry.index);
  for (const Move& move : moves_) {
    if ((free & move.box) != move.box) continue;
    const std::int32_t index = entry.index + move.offset;
    Node& node = nodes_[static_cast<std::size_t>(index)];
    if (node.epoch == epoch_ + 1) continue;
    const std::uint64_t g = entry.g + move.cost;
    if (node.epoch == epoch_ && node.g <= g) continue;
    node = {g, epoch_, entry.index};
    push({g + octile({at.x + move.step.x, at.y + move.step.y, at.z + move.step.z}, goal), g, index});
  }
}

bool PlainAStar::run(const tern::Voxel& start, const tern::Voxel& goal) {
  epoch_ += 2;
  expanded_ = 0;
  open_.clear();
  goal_ = index_of(goal);
  const std::int32_t first = index_of(start);
  nodes_[static_cast<std::size_t>(first)] = {0, epoch_, first};
  push({octile(start, goal), 0, first});
  while (!open_.empty()) {
    const Entry entry = pop();
    Node& node = nodes_[static_cast<std::size_t>(entry.index)];
    if (node.epoch == epoch_ + 1) continue;
    node.epoch = epoch_ + 1;
    ++expanded_;
    cost_ = entry.g;
    if (entry.index == goal_) return true;
    expand(entry, goal);
  }
  goal_ = -1;
  return false;
}

std::vector<tern::Voxel> PlainAStar::path() const {
  std::vector<tern::Voxel> path;
  std::int32_t index = goal_;
  while (index >= 0) {
    path.push_back(voxel_of(index));
    const std::int32_t parent = nodes_[static_cast<std::size_t>(index)].parent;
    index = parent == index ? -1 : parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace tern_bench
