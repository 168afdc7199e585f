// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_tracker/clusters.hpp"

#include <algorithm>

namespace tern_tracker {
namespace {

constexpr std::int32_t kNone = -1;
constexpr int kKeyBits = 21;  // of each axis, for numbers below 2 kClusterReach
constexpr int kSlotBits = 13;
static_assert(2 * kMaxClusterCells == 1 << kSlotBits, "a slot is kSlotBits of a hash");

/// Cells beside one: half of them, so that each pair is looked at once.
constexpr int kNeighbours = 13;

/// The number of a cell along one axis, 1 and more; 0 where it is too far away.
std::uint64_t number_of(double at, double cell) {
  const double edges = at / cell;
  if (!(edges > -kClusterReach && edges < kClusterReach - 2)) return 0;
  auto whole = static_cast<std::int64_t>(edges);
  if (static_cast<double>(whole) > edges) --whole;
  return static_cast<std::uint64_t>(whole + kClusterReach + 1);
}

std::uint64_t key_of(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return x << 2 * kKeyBits | y << kKeyBits | z;
}

/// The key of neighbour k. A sum cannot carry from one axis to the next: numbers are neither 0 nor the largest.
std::uint64_t neighbour_of(std::uint64_t key, int k) {
  const std::uint64_t one = 1;
  const std::uint64_t steps = key_of(static_cast<std::uint64_t>(k / 9), static_cast<std::uint64_t>(k / 3 % 3),
                                     static_cast<std::uint64_t>(k % 3));
  return key + steps - key_of(one, one, one);
}

/// Makes the box hold another one.
void widen(tern::Vec3& lower, tern::Vec3& upper, const tern::Vec3& low, const tern::Vec3& high) {
  lower = {std::min(lower.x, low.x), std::min(lower.y, low.y), std::min(lower.z, low.z)};
  upper = {std::max(upper.x, high.x), std::max(upper.y, high.y), std::max(upper.z, high.z)};
}

/// Neither comes first only where both are the same.
bool comes_before(const Cluster& a, const Cluster& b) {
  if (a.points != b.points) return a.points > b.points;
  const double of_a[] = {
      a.center.x - a.half.x, a.center.y - a.half.y, a.center.z - a.half.z, a.center.x, a.center.y, a.center.z};
  const double of_b[] = {
      b.center.x - b.half.x, b.center.y - b.half.y, b.center.z - b.half.z, b.center.x, b.center.y, b.center.z};
  for (int k = 0; k < 6; ++k) {
    if (of_a[k] < of_b[k]) return true;
    if (of_b[k] < of_a[k]) return false;
  }
  return false;
}

}  // namespace

ClusterStatus Clusters::begin(const ClusterSettings& settings) {
  is_begun_ = settings.cell >= 0.01 && settings.cell <= 10.0 && settings.points >= 1;
  cells_used_ = count_ = 0;
  if (!is_begun_) return ClusterStatus::kInvalidArgument;
  settings_ = settings;
  for (std::int32_t& slot : slots_) slot = kNone;
  return ClusterStatus::kOk;
}

/// Where the cell of this key is, or would be. At least half of the slots are free, so the search ends.
std::int32_t Clusters::slot_of(std::uint64_t key) const {
  auto slot = static_cast<std::int32_t>(key * 0x9E3779B97F4A7C15u >> (64 - kSlotBits));
  while (slots_[slot] != kNone && cells_[slots_[slot]].key != key) slot = (slot + 1) % kSlots;
  return slot;
}

ClusterStatus Clusters::add(const tern::Vec3& point) {
  if (!is_begun_) return ClusterStatus::kInvalidArgument;
  const std::uint64_t x = number_of(point.x, settings_.cell), y = number_of(point.y, settings_.cell),
                      z = number_of(point.z, settings_.cell);
  if (x == 0 || y == 0 || z == 0) return ClusterStatus::kOutOfReach;
  const std::uint64_t key = key_of(x, y, z);
  const std::int32_t slot = slot_of(key);
  if (slots_[slot] != kNone) {
    Cell& cell = cells_[slots_[slot]];
    widen(cell.lower, cell.upper, point, point);
    ++cell.points;
    return ClusterStatus::kOk;
  }
  if (cells_used_ == kMaxClusterCells) return ClusterStatus::kCellsFull;
  cells_[cells_used_] = {key, point, point, 1, cells_used_};
  slots_[slot] = cells_used_++;
  return ClusterStatus::kOk;
}

/// Parents come before their children, so the walk ends.
std::int32_t Clusters::root_of(std::int32_t cell) {
  while (cells_[cell].parent != cell) {
    cells_[cell].parent = cells_[cells_[cell].parent].parent;
    cell = cells_[cell].parent;
  }
  return cell;
}

void Clusters::unite(std::int32_t a, std::int32_t b) {
  const std::int32_t root_a = root_of(a), root_b = root_of(b);
  if (root_a < root_b) {
    cells_[root_b].parent = root_a;
  } else {
    cells_[root_a].parent = root_b;
  }
}

/// False if a cluster had to be left out for want of room.
bool Clusters::keep(const Cell& root) {
  Cluster cluster;
  cluster.center = {0.5 * (root.lower.x + root.upper.x), 0.5 * (root.lower.y + root.upper.y),
                    0.5 * (root.lower.z + root.upper.z)};
  cluster.half = {0.5 * (root.upper.x - root.lower.x), 0.5 * (root.upper.y - root.lower.y),
                  0.5 * (root.upper.z - root.lower.z)};
  cluster.points = root.points;
  const bool is_full = count_ == kMaxClusters;
  if (is_full && !comes_before(cluster, clusters_[count_ - 1])) return false;
  std::int32_t place = is_full ? count_ - 1 : count_++;
  for (; place > 0 && comes_before(cluster, clusters_[place - 1]); --place) clusters_[place] = clusters_[place - 1];
  clusters_[place] = cluster;
  return !is_full;
}

ClusterStatus Clusters::join() {
  if (!is_begun_) return ClusterStatus::kInvalidArgument;
  is_begun_ = false;
  for (std::int32_t cell = 0; cell < cells_used_; ++cell) {
    for (int k = 0; k < kNeighbours; ++k) {
      const std::int32_t beside = slots_[slot_of(neighbour_of(cells_[cell].key, k))];
      if (beside != kNone) unite(cell, beside);
    }
  }
  for (std::int32_t k = 0; k < cells_used_; ++k) {
    const Cell& cell = cells_[k];
    Cell& root = cells_[root_of(k)];
    if (&root == &cell) continue;
    widen(root.lower, root.upper, cell.lower, cell.upper);
    root.points += cell.points;
  }
  bool has_room = true;
  for (std::int32_t k = 0; k < cells_used_; ++k) {
    if (cells_[k].parent == k && cells_[k].points >= settings_.points) has_room = keep(cells_[k]) && has_room;
  }
  return has_room ? ClusterStatus::kOk : ClusterStatus::kClustersFull;
}

}  // namespace tern_tracker
