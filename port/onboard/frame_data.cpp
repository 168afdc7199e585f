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

/// What a pixel with "nothing in the way" counts as, in ranges of the map.
constexpr double kFree = 2.0;
constexpr float kNothing = 0.0f;

float float_at(const std::uint8_t* bytes) {
  float number = 0.0f;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

}  // namespace

/// Metres, or kNothing.
float Sensors::depth_of(const Sensor& sensor, const DepthImage& image, std::int32_t u, std::int32_t v) const {
  const auto* bytes = static_cast<const std::uint8_t*>(image.data) + static_cast<std::size_t>(v) * image.row_bytes;
  const SensorSettings& s = sensor.spec.settings;
  if (image.metres) {
    const float depth = float_at(bytes + 4 * static_cast<std::size_t>(u));
    if (std::isinf(depth) && depth > 0.0f && s.inf_is_free) return static_cast<float>(kFree * range_);
    const auto metres = static_cast<double>(depth);
    return metres >= s.least && metres < s.most ? depth : kNothing;
  }
  const std::size_t at = 2 * static_cast<std::size_t>(u);
  const int high = image.big_endian ? bytes[at] : bytes[at + 1];
  const int low = image.big_endian ? bytes[at + 1] : bytes[at];
  const int number = 256 * high + low;
  const double metres = 0.001 * number;
  const bool measured = number != 0 && number != 65535 && metres >= s.least && metres < s.most;
  return measured ? static_cast<float>(metres) : kNothing;
}

void Sensors::read(const Sensor& sensor, const DepthImage& image, Frame& frame) const {
  const std::int32_t b = sensor.binning;
  frame.width = image.width / b;
  frame.height = image.height / b;
  frame.depths.resize(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
  std::size_t pixel = 0;
  for (std::int32_t v = 0; v < frame.height; ++v) {
    for (std::int32_t u = 0; u < frame.width; ++u, ++pixel) {
      // The least depth of the square; kNothing is less than any.
      float least = std::numeric_limits<float>::max();
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
