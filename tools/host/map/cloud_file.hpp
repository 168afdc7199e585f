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

/// Reads the whole of a file's content; world frame, metres. Points that are not finite are left out: sensors write
/// them where they saw nothing. Throws RecordError: neither PCD nor PLY, no x, y and z, a compressed file, cut off, too
/// many points.
std::vector<tern::Vec3> parse_cloud(const std::string& bytes, const Place& place);

}  // namespace tern_host

#endif
