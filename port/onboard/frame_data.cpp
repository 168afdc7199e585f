// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reading images and scans out of messages.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "tern_onboard/sensors.hpp"

namespace tern_onboard {
namespace {

/// A pixel of which nothing is known, for the map and here.
constexpr float kUnknown = -1.0f;
/// One that nothing came back to, if SensorSettings::no_return says something of it.
constexpr float kNoReturn = std::numeric_limits<float>::infinity();

float float_at(const std::uint8_t* bytes) {
  float number = 0.0f;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

}  // namespace

/// Metres, kUnknown or kNoReturn.
float Sensors::depth_of(const Sensor& sensor, const DepthImage& image, std::int32_t u, std::int32_t v) const {
  const auto* bytes = static_cast<const std::uint8_t*>(image.data) + static_cast<std::size_t>(v) * image.row_bytes;
  const SensorSettings& s = sensor.spec.settings;
  const float nothing_back = s.no_return > 0.0 ? kNoReturn : kUnknown;
  if (image.metres) {
    const float depth = float_at(bytes + 4 * static_cast<std::size_t>(u));
    const auto metres = static_cast<double>(depth);
    if (metres == 0.0 || (std::isinf(metres) && metres > 0.0)) return nothing_back;
    return metres >= s.least && metres < s.most ? depth : kUnknown;
  }
  const std::size_t at = 2 * static_cast<std::size_t>(u);
  const int high = image.big_endian ? bytes[at] : bytes[at + 1];
  const int low = image.big_endian ? bytes[at + 1] : bytes[at];
  const int number = 256 * high + low;
  if (number == 0) return nothing_back;
  const double metres = 0.001 * number;
  return number != 65535 && metres >= s.least && metres < s.most ? static_cast<float>(metres) : kUnknown;
}

void Sensors::read(const Sensor& sensor, const DepthImage& image, Frame& frame) const {
  const std::int32_t b = sensor.binning;
  frame.width = image.width / b;
  frame.height = image.height / b;
  frame.depths.resize(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
  std::size_t pixel = 0;
  for (std::int32_t v = 0; v < frame.height; ++v) {
    for (std::int32_t u = 0; u < frame.width; ++u, ++pixel) {
      // The least depth of the square: kUnknown is less than any, kNoReturn is more.
      float least = kNoReturn;
      for (std::int32_t y = v * b; y < (v + 1) * b; ++y) {
        for (std::int32_t x = u * b; x < (u + 1) * b; ++x) least = std::min(least, depth_of(sensor, image, x, y));
      }
      frame.depths[pixel] = least;
    }
  }
}

void Sensors::read(const PointScan& scan, Frame& frame) {
  frame.points.clear();
  frame.points.reserve(3 * scan.width * scan.height);
  const auto* bytes = static_cast<const std::uint8_t*>(scan.data);
  for (std::size_t row = 0; row < scan.height; ++row) {
    const std::uint8_t* point = bytes + row * scan.row_bytes;
    for (std::size_t k = 0; k < scan.width; ++k, point += scan.point_bytes) {
      const float p[3] = {float_at(point + scan.x), float_at(point + scan.y), float_at(point + scan.z)};
      if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) {
        frame.points.insert(frame.points.end(), p, p + 3);
      }
    }
  }
}

}  // namespace tern_onboard
