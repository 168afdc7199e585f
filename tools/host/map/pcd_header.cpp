// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The header of a PCD file: https://pointclouds.org/documentation/tutorials/pcd_file_format.html
#include <algorithm>
#include <cmath>
#include <map>

#include "host/map/cloud_table.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr double kMaxCount = 4096.0;  // numbers of one field of a point
constexpr double kUnitTolerance = 1e-3;
/// What a viewpoint may differ from the origin and count as it.
constexpr double kSameViewpoint = 1e-6;
const char* const kKeys[] = {"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                             "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
const char* const kVersions[] = {"0.7", ".7", "0.6", ".6", "0.5", ".5"};

struct Line {
  Words words;
  Place place;
};

template <typename List>
bool is_in(const std::string& word, const List& list) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

/// The lines by their first words.
class PcdHeader {
 public:
  explicit PcdHeader(ByteReader& reader) {
    while (!has("DATA")) {
      if (reader.at_end() || reader.line_place().line == kMaxCloudHeaderLines) {
        throw RecordError(reader.line_place(), "its header has no 'DATA'");
      }
      Words words = split_words(reader.line(), false);
      if (words.empty() || words[0][0] == '#') continue;
      if (words[0] == "COLUMNS") words[0] = "FIELDS";  // the name of older files
      add({words, reader.line_place()});
    }
    end_ = reader.line_place();
  }

  bool has(const std::string& key) const { return lines_.count(key) != 0; }
  const Line& line(const std::string& key) const {
    const auto found = lines_.find(key);
    if (found == lines_.end()) throw RecordError(end_, "its header has no '" + key + "'");
    return found->second;
  }
  /// The one word after a key.
  const std::string& word(const std::string& key) const {
    const Line& found = line(key);
    if (found.words.size() != 2) throw_count(key, "1 word", found.words.size() - 1, found.place);
    return found.words[1];
  }
  std::uint64_t points(const std::string& key) const { return point_count(word(key), line(key).place); }

 private:
  void add(const Line& found) {
    const std::string& key = found.words[0];
    if (!is_in(key, kKeys)) throw RecordError(found.place, "unknown word " + quote(key) + " in its header");
    if (!lines_.insert({key, found}).second) throw RecordError(found.place, "'" + key + "' is given twice");
  }

  std::map<std::string, Line> lines_;
  Place end_;
};

/// The words of a line that has one for each field.
const Line& line_of_fields(const PcdHeader& header, const std::string& key) {
  const std::size_t fields = header.line("FIELDS").words.size() - 1;
  const Line& line = header.line(key);
  if (line.words.size() - 1 != fields) {
    throw RecordError(line.place, "'" + key + "' is for " + std::to_string(line.words.size() - 1) +
                                      " fields, 'FIELDS' names " + std::to_string(fields));
  }
  return line;
}

std::vector<Column> columns_of(const PcdHeader& header) {
  const Line& names = header.line("FIELDS");
  const Line& sizes = line_of_fields(header, "SIZE");
  const Line& types = line_of_fields(header, "TYPE");
  std::vector<Column> columns;
  for (std::size_t i = 1; i < names.words.size(); ++i) {
    Column column;
    column.name = names.words[i];
    column.size = whole_number(sizes.words[i], 8.0, sizes.place);
    if (types.words[i].size() != 1) throw RecordError(types.place, quote(types.words[i]) + " is not a type: F, I or U");
    column.type = types.words[i][0];
    if (header.has("COUNT")) {
      const Line& counts = line_of_fields(header, "COUNT");
      column.count = whole_number(counts.words[i], kMaxCount, counts.place);
      if (column.count == 0) throw RecordError(counts.place, "field " + quote(column.name) + " has a count of 0");
    }
    columns.push_back(column);
  }
  return columns;
}

/// WIDTH times HEIGHT must be POINTS.
std::uint64_t points_of(const PcdHeader& header) {
  const bool has_width = header.has("WIDTH");
  const std::uint64_t width = has_width ? header.points("WIDTH") : 0;
  const std::uint64_t height = header.has("HEIGHT") ? header.points("HEIGHT") : 1;
  const std::string size = "'WIDTH' " + std::to_string(width) + " x 'HEIGHT' " + std::to_string(height);
  if (header.has("HEIGHT") && !has_width) throw RecordError(header.line("HEIGHT").place, "'HEIGHT' without 'WIDTH'");
  if (!header.has("POINTS")) {
    const std::string says = has_width ? "; " + size + " would be " + std::to_string(width * height) : "";
    throw RecordError(header.line("DATA").place, "its header has no 'POINTS'" + says + ": write it again");
  }
  const std::uint64_t points = header.points("POINTS");
  if (has_width && width * height != points) {
    throw RecordError(header.line("POINTS").place, "'POINTS' is " + std::to_string(points) + ", but " + size + " is " +
                                                       std::to_string(width * height) + ": write the file again");
  }
  return points;
}

Coding coding_of(const PcdHeader& header) {
  const std::string& word = header.word("DATA");
  if (word == "ascii") return Coding::kText;
  if (word == "binary") return Coding::kLittle;
  if (word == "binary_compressed") return Coding::kPacked;
  throw RecordError(header.line("DATA").place, "'DATA' is " + quote(word) + ": save it as binary or ascii");
}

/// Where the sensor was: a position and a quaternion, w first. True if that is not the origin, looking along its axes.
bool has_viewpoint(const PcdHeader& header) {
  if (!header.has("VIEWPOINT")) return false;
  const Line& line = header.line("VIEWPOINT");
  const std::vector<double> v = numbers(line.words, line.place);
  if (v.size() != 7) throw_count("VIEWPOINT", "7 numbers", v.size(), line.place);
  const double norm = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
  if (!(std::fabs(norm - 1.0) < kUnitTolerance)) {
    throw RecordError(line.place, "the quaternion of 'VIEWPOINT' has the length " + brief(norm) + ", not 1");
  }
  const double off =
      std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2]), std::fabs(v[4]), std::fabs(v[5]), std::fabs(v[6])});
  return off > kSameViewpoint;
}

}  // namespace

Table read_pcd_header(ByteReader& reader, Cloud& cloud) {
  const PcdHeader header(reader);
  if (header.has("VERSION") && !is_in(header.word("VERSION"), kVersions)) {
    throw RecordError(header.line("VERSION").place,
                      "a PCD file of version " + quote(header.word("VERSION")) + ": save it as version 0.7");
  }
  Table table;
  table.points = {"point", points_of(header), columns_of(header)};
  table.coding = coding_of(header);
  table.padded = true;
  cloud.has_viewpoint = has_viewpoint(header);
  return table;
}

}  // namespace tern_host
