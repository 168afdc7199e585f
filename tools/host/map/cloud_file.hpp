// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Point clouds: PCD files, and the vertices of PLY files; both as text or binary.
#ifndef TERN_HOST_MAP_CLOUD_FILE_HPP
#define TERN_HOST_MAP_CLOUD_FILE_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "host/text_records.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// Points of a file at most.
constexpr std::size_t kMaxCloudPoints = std::size_t{64} * 1024 * 1024;

/// World frame, metres.
struct Cloud {
  std::vector<tern::Vec3> points;
  std::size_t dropped = 0;     ///< further points, with a coordinate that is not finite
  bool has_viewpoint = false;  ///< that is not the origin; the points are taken as they are
};

/// Reads the whole of a file's content. Points that are not finite are left out and counted: sensors write them where
/// they saw nothing. Throws RecordError: neither PCD nor PLY, a header that is incomplete or contradicts itself, data
/// that do not fit it, words that are no numbers, too many points.
Cloud parse_cloud(const std::string& bytes, const Place& place);

}  // namespace tern_host

#endif
