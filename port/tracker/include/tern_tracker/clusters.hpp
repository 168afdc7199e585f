// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points that belong together: detections for those who have no detector. No heap, and every loop has a bound.
#ifndef TERN_TRACKER_CLUSTERS_HPP
#define TERN_TRACKER_CLUSTERS_HPP

#include <cstdint>

#include "tern/vec3.hpp"

namespace tern_tracker {

/// Cells with points. One more takes 72 bytes; too many: kCellsFull.
constexpr std::int32_t kMaxClusterCells = 4096;
/// Clusters that are told. One more takes 56 bytes; too many: kClustersFull.
constexpr std::int32_t kMaxClusters = 64;
/// Cells are at most so many edges from the origin, along each axis. Farther points: kOutOfReach.
constexpr std::int32_t kClusterReach = 1 << 20;

enum class ClusterStatus {
  kOk,
  kInvalidArgument,  ///< settings out of range
  kOutOfReach,       ///< a point is not finite or too far away: it was left out
  kCellsFull,        ///< points in further cells were left out
  kClustersFull,     ///< the clusters with the fewest points were left out
};

struct ClusterSettings {
  /// Edge of a cell, m, within [0.01, 10]. Points whose cells touch, if only at a corner, belong together. So do all
  /// that are at most an edge apart along each axis; two clusters are more than that apart along some axis.
  double cell = 0.25;
  /// A cluster of fewer points is left out, >= 1.
  std::int32_t points = 4;
};

/// A box around points that belong together, world frame, m.
struct Cluster {
  tern::Vec3 center{};
  tern::Vec3 half{};
  std::int32_t points = 0;
};

/// Connected components of cells with points. begin(), then add() for each point, then join(). The clusters do not
/// depend on the order of the points, unless cells are full. An object takes 330,000 bytes: make it static.
class Clusters {
 public:
  ClusterStatus begin(const ClusterSettings& settings);
  /// World frame, m. kOk, kOutOfReach or kCellsFull; kInvalidArgument before begin() was answered with kOk.
  ClusterStatus add(const tern::Vec3& point);
  /// Makes the clusters, those with the most points first; of equal ones, that with the lower corner, by x, y and z.
  /// kOk, kClustersFull or kInvalidArgument.
  ClusterStatus join();
  std::int32_t size() const { return count_; }
  /// k < size().
  const Cluster& operator[](std::int32_t k) const { return clusters_[k]; }

 private:
  struct Cell {
    std::uint64_t key;
    tern::Vec3 lower, upper;  ///< of its points; of a root, of all points of its cluster
    std::int32_t points;
    std::int32_t parent;  ///< an earlier cell of the same cluster, or itself
  };
  static constexpr std::int32_t kSlots = 2 * kMaxClusterCells;

  std::int32_t slot_of(std::uint64_t key) const;
  std::int32_t root_of(std::int32_t cell);
  void unite(std::int32_t a, std::int32_t b);
  bool keep(const Cell& root);

  ClusterSettings settings_;
  bool is_begun_ = false;
  std::int32_t cells_used_ = 0;
  std::int32_t count_ = 0;
  Cell cells_[kMaxClusterCells];
  std::int32_t slots_[kSlots];  ///< cells by their keys, or kNone
  Cluster clusters_[kMaxClusters];
};

}  // namespace tern_tracker

#endif
