// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the header of a point cloud says, and the points after it. A file whose data do not fit its header is refused.
#ifndef TERN_HOST_MAP_CLOUD_TABLE_HPP
#define TERN_HOST_MAP_CLOUD_TABLE_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/map/byte_reader.hpp"
#include "host/map/cloud_file.hpp"

namespace tern_host {

constexpr int kMaxCloudHeaderLines = 256;

/// A field of each point, or a property of an element.
struct Column {
  std::string name;
  char type = 'F';
  std::size_t size = 4;
  std::size_t count = 1;      ///< numbers
  std::size_t list_size = 0;  ///< of the number before a list that says how long it is; 0: no list
};

/// Rows of columns.
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Column> columns;
};

enum class Coding { kText, kLittle, kBig, kPacked };

struct Table {
  Element points;
  std::vector<Element> others;  ///< of a PLY file, after the vertices
  Coding coding = Coding::kText;
  bool padded = false;  ///< zeros may follow, up to the page of memory that PCL writes
};

/// A number of points in a header. Throws RecordError.
std::uint64_t point_count(const std::string& word, const Place& place);

/// The lines up to `DATA` or `end_header`. Throws RecordError.
Table read_pcd_header(ByteReader& reader, Cloud& cloud);
Table read_ply_header(ByteReader& reader);

/// All points, and nothing after them but what the header says. Throws RecordError.
void read_points(ByteReader& reader, const Table& table, const Place& place, Cloud& cloud);

/// Decompresses all of `packed` to `size` bytes by LZF. Throws RecordError; in a build without liblzf always.
std::string unpack(const char* packed, std::size_t packed_size, std::size_t size, const Place& place);

}  // namespace tern_host

#endif
