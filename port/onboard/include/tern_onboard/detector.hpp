// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_ONBOARD_DETECTOR_HPP
#define TERN_ONBOARD_DETECTOR_HPP

#include <cstdint>
#include <vector>

#include "tern/map.hpp"
#include "tern_onboard/sighting.hpp"

namespace tern_onboard {

/// What moves in a frame.
struct Seen {
  std::vector<Sighting> things;  ///< in the map's frame, with the frame's stamp, and a name each
  bool is_all = true;            ///< false: some were left out for want of room
};

/// Finds what moves in the frames of Onboard's sensors; that of port/tracker is one. Onboard calls it from tick(), with
/// each frame that is about to enter the map, once the map does nothing else. It must not call Onboard.
class Detector {
 public:
  virtual ~Detector() = default;
  /// `map`: as it was before the frame. `eye`: the sensor's pose at the frame's `stamp`, in the map's frame, as the map
  /// gets it. The stamps of one sensor grow; those of several may be equal, or come in any order. Names are the
  /// sensor's own: Onboard puts the sensor's number before them. It adds the errors that MapSpec states of the pose and
  /// of depths, too.
  virtual Seen see(int sensor, const tern::RollingMap& map, const tern::DepthView& view, const tern::Pose& eye,
                   std::int64_t stamp) = 0;
  virtual Seen see(int sensor, const tern::RollingMap& map, const tern::Beams& beams, const tern::Vec3& origin,
                   std::int64_t stamp) = 0;
  /// The clock or the map's frame is a new one: nothing goes on. No name may come again.
  virtual void restart() = 0;
};

}  // namespace tern_onboard

#endif
