// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/sensor_table.hpp"

#include <algorithm>
#include <iterator>

namespace tern_companion {
namespace {

/// Lens, mounting and size are those of the frame before.
bool is_as_before(const tern_depth_header& a, const tern_depth_header& b) {
  return a.width == b.width && a.height == b.height && a.fx == b.fx && a.fy == b.fy && a.cx == b.cx && a.cy == b.cy &&
         std::equal(std::begin(a.position), std::end(a.position), std::begin(b.position)) &&
         std::equal(std::begin(a.attitude), std::end(a.attitude), std::begin(b.attitude));
}

}  // namespace

/// Tells Onboard what the header says of the sensor.
std::string SensorTable::describe(const tern_depth_header& header) {
  const bool is_points = header.format == TERN_DEPTH_POINTS;
  const std::string name = "sensor " + std::to_string(header.sensor);
  int& index = indices_[header.sensor];
  if (index == kNew) {
    tern_onboard::SensorSpec spec;
    spec.name = name;
    spec.kind = is_points ? tern_onboard::SensorKind::kPoints : tern_onboard::SensorKind::kDepth;
    spec.settings.least = header.least;
    spec.settings.most = header.most;
    index = onboard_.add_sensor(spec);
  }
  headers_[header.sensor] = header;
  const double* const p = header.position;
  const double* const q = header.attitude;
  const tern_onboard::Answer mounted = onboard_.set_mounting(index, {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}});
  if (!mounted.ok) return name + ": " + mounted.text;
  if (is_points) return "";
  const tern_onboard::Lens lens{static_cast<std::int32_t>(header.width),
                                static_cast<std::int32_t>(header.height),
                                header.fx,
                                header.fy,
                                header.cx,
                                header.cy};
  const tern_onboard::Answer taken = onboard_.set_lens(index, lens);
  return taken.ok ? "" : name + ": " + taken.text;
}

std::string SensorTable::take(const tern_depth_header& header, const std::uint8_t* payload, std::int64_t now) {
  const bool is_known = indices_[header.sensor] != kNew && is_as_before(header, headers_[header.sensor]);
  const std::string fault = is_known ? "" : describe(header);
  const int sensor = indices_[header.sensor];
  if (header.format == TERN_DEPTH_POINTS) {
    tern_onboard::PointScan scan{};
    scan.stamp = header.stamp_ns;
    scan.data = payload;
    scan.bytes = header.payload_bytes;
    scan.width = header.width;
    scan.height = header.height;
    scan.point_bytes = 3 * sizeof(float);
    scan.row_bytes = scan.point_bytes * header.width;
    scan.y = sizeof(float);
    scan.z = 2 * sizeof(float);
    onboard_.add_frame(sensor, scan, now);
    return fault;
  }
  tern_onboard::DepthImage image{};
  image.stamp = header.stamp_ns;
  image.data = payload;
  image.bytes = header.payload_bytes;
  image.width = static_cast<std::int32_t>(header.width);
  image.height = static_cast<std::int32_t>(header.height);
  image.metres = header.format == TERN_DEPTH_METRES;
  image.row_bytes = (image.metres ? sizeof(float) : sizeof(std::uint16_t)) * header.width;
  onboard_.add_frame(sensor, image, now);
  return fault;
}

}  // namespace tern_companion
