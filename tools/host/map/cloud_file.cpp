// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/cloud_file.hpp"

#include <algorithm>

#include "host/map/cloud_table.hpp"

namespace tern_host {
namespace {

/// True if the first line that is neither empty nor a comment is one of a PCD header.
bool is_pcd(const std::string& bytes) {
  std::size_t begin = 0;
  for (int i = 0; i < kMaxCloudHeaderLines && begin < bytes.size(); ++i) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    const Words words = split_words(bytes.substr(begin, end - begin), false);
    if (!words.empty() && words[0][0] != '#') {
      return words[0] == "VERSION" || words[0] == "FIELDS" || words[0] == "COLUMNS";
    }
    begin = end + 1;
  }
  return false;
}

}  // namespace

Cloud parse_cloud(const std::string& bytes, const Place& place) {
  ByteReader reader(bytes, place);
  Cloud cloud;
  const bool ply = bytes.compare(0, 4, "ply\n") == 0 || bytes.compare(0, 5, "ply\r\n") == 0;
  if (!ply && !is_pcd(bytes)) throw RecordError(place, "neither a PCD file nor a PLY file");
  const Table table = ply ? read_ply_header(reader) : read_pcd_header(reader, cloud);
  read_points(reader, table, place, cloud);
  return cloud;
}

}  // namespace tern_host
