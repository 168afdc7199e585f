// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PAGE_KNOWN_GROWTH_HPP
#define TERN_HOST_PAGE_KNOWN_GROWTH_HPP

#include <map>
#include <tuple>
#include <vector>

#include "host/page/run_json.hpp"
#include "tern/map.hpp"

namespace tern_host {

/// What a rolling map learned of a world, and when: obstacles, and columns of which something was seen free. What
/// leaves the map's window stays.
class KnownGrowth {
 public:
  /// Looks at no more than the voxels within `bounds`, world frame, metres.
  explicit KnownGrowth(const tern::Box& bounds) : bounds_(bounds) {}

  /// Takes down what the map holds now, `t` seconds after the beginning; not while it does a job. At most once in
  /// kInterval.
  void note(double t, const tern::RollingMap& map);

  /// Obstacles as blocks of voxels, in the order in which they became known: x, y, z, width along y, height, from,
  /// until; seconds, -1 for ever.
  RunJson known_json() const;
  /// The floor: for each column the tenths of seconds after which something of it was seen, -1 for never.
  RunJson seen_json() const;

  static constexpr double kInterval = 0.2;  ///< seconds

 private:
  using Place =
      std::tuple<int, int, int>;  ///< x, y, z in voxels from the first window's origin, on which windows agree
  struct Life {
    float from, until;
  };
  struct Block {
    int x, y, z, width, height;
    Life life;
  };
  /// A half-open range of voxels.
  struct Range {
    int begin, end;
  };

  std::vector<Block> blocks() const;
  void lay_out(const tern::GridSpec& window);
  Place shift(const tern::GridSpec& window) const;
  void add_obstacles(float t, const tern::Grid& route);
  void end_cleared(float t, const tern::Grid& route);
  void add_seen(float t, const tern::RollingMap& map);
  template <typename Visit>
  void visit_rows(const tern::GridSpec& window, const Visit& visit) const;

  tern::Box bounds_;
  bool laid_out_ = false;
  tern::Vec3 origin_{};
  double cell_ = 0.0;
  Range range_[3]{};
  double last_ = -1.0;
  std::map<Place, Life> obstacles_;
  std::vector<float> seen_;  ///< by columns within the range, x first; negative: never
};

}  // namespace tern_host

#endif
