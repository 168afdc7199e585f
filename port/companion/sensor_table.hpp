// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_COMPANION_SENSOR_TABLE_HPP
#define TERN_COMPANION_SENSOR_TABLE_HPP

#include <array>
#include <cstdint>
#include <string>

#include "companion/depth_socket.hpp"
#include "tern_onboard/onboard.hpp"

namespace tern_companion {

/// Hands frames of depth to an Onboard, whose sensors it makes as frames of new ones come.
class SensorTable {
 public:
  /// `onboard` must outlive it.
  explicit SensorTable(tern_onboard::Onboard& onboard) : onboard_(onboard) { indices_.fill(kNew); }

  /// Takes a frame whose header is good (depth_header_fault). Empty; or why its lens or its mounting is refused.
  std::string take(const tern_depth_header& header, const std::uint8_t* payload, std::int64_t now);

 private:
  static constexpr int kNew = -1;
  std::string describe(const tern_depth_header& header);

  tern_onboard::Onboard& onboard_;
  std::array<int, kMostSensors> indices_;  // of Onboard
  std::array<tern_depth_header, kMostSensors> headers_{};
};

}  // namespace tern_companion

#endif
