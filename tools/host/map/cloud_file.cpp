// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/cloud_file.hpp"

#include <algorithm>
#include <cmath>

#include "host/map/byte_reader.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr int kMaxHeaderLines = 256;
constexpr double kMaxCount = 4096.0;  // numbers of one field of a point

/// A field of each point.
struct Column {
  std::string name;
  char type = 'F';
  std::size_t size = 4;
  std::size_t count = 1;  ///< numbers
};

enum class Coding { kText, kLittle, kBig };

/// What a header says: so many points, each a row of columns.
struct Table {
  std::vector<Column> columns;
  std::size_t points = 0;
  Coding coding = Coding::kText;
};

std::size_t whole(const std::string& word, double most, const Place& place) {
  const double value = number(word, place);
  if (!(value >= 0.0 && value <= most && std::floor(value) == value)) {
    throw RecordError(place, quote(word) + " in its header is not a whole number up to " + brief(most));
  }
  return static_cast<std::size_t>(value);
}

std::size_t point_count(const std::string& word, const Place& place) {
  return whole(word, static_cast<double>(kMaxCloudPoints), place);
}

bool can_read(const Column& column) {
  const std::size_t s = column.size;
  const bool size = s == 4 || s == 8 || (column.type != 'F' && (s == 1 || s == 2));
  return size && (column.type == 'F' || column.type == 'I' || column.type == 'U');
}

/// One line of a PCD header about all columns: FIELDS, SIZE, TYPE or COUNT.
void read_columns(const Words& words, Table& table, const Place& place) {
  if (words[0] == "FIELDS") table.columns.resize(words.size() - 1);
  if (table.columns.size() != words.size() - 1) throw RecordError(place, "'" + words[0] + "' does not fit 'FIELDS'");
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    Column& column = table.columns[i];
    const std::string& word = words[i + 1];
    if (words[0] == "FIELDS") column.name = word;
    if (words[0] == "SIZE") column.size = whole(word, 8.0, place);
    if (words[0] == "TYPE") column.type = word[0];
    if (words[0] == "COUNT") column.count = whole(word, kMaxCount, place);
  }
}

Coding pcd_coding(const std::string& word, const Place& place) {
  if (word == "ascii") return Coding::kText;
  if (word == "binary") return Coding::kLittle;
  throw RecordError(place, "'DATA' is " + quote(word) + ": save it as binary or ascii");
}

Table read_pcd_header(ByteReader& reader, const Place& place) {
  Table table;
  for (int i = 0; i < kMaxHeaderLines; ++i) {
    const Words words = split_words(reader.line(), false);
    if (words.size() < 2 || words[0][0] == '#') continue;
    if (words[0] == "FIELDS" || words[0] == "SIZE" || words[0] == "TYPE" || words[0] == "COUNT") {
      read_columns(words, table, place);
    }
    if (words[0] == "POINTS") table.points = point_count(words[1], place);
    if (words[0] != "DATA") continue;
    table.coding = pcd_coding(words[1], place);
    return table;
  }
  throw RecordError(place, "its header has no 'DATA'");
}

struct PlyType {
  const char* name;
  char type;
  std::size_t size;
};
constexpr PlyType kPlyTypes[] = {{"char", 'I', 1},  {"int8", 'I', 1},    {"uchar", 'U', 1},  {"uint8", 'U', 1},
                                 {"short", 'I', 2}, {"int16", 'I', 2},   {"ushort", 'U', 2}, {"uint16", 'U', 2},
                                 {"int", 'I', 4},   {"int32", 'I', 4},   {"uint", 'U', 4},   {"uint32", 'U', 4},
                                 {"float", 'F', 4}, {"float32", 'F', 4}, {"double", 'F', 8}, {"float64", 'F', 8}};

Column ply_column(const Words& words, const Place& place) {
  for (const PlyType& type : kPlyTypes) {
    if (words.size() == 3 && words[1] == type.name) return {words[2], type.type, type.size, 1};
  }
  throw RecordError(place, "a vertex has a property that is a list, or of no known type");
}

Coding ply_coding(const Words& words, const Place& place) {
  if (words[1] == "ascii") return Coding::kText;
  if (words[1] == "binary_little_endian") return Coding::kLittle;
  if (words[1] == "binary_big_endian") return Coding::kBig;
  throw RecordError(place, "'format' is " + quote(words[1]) + ": save it as ascii or binary");
}

/// The vertices must come first; what follows them is not read.
Table read_ply_header(ByteReader& reader, const Place& place) {
  Table table;
  int elements = 0;
  for (int i = 0; i < kMaxHeaderLines; ++i) {
    const Words words = split_words(reader.line(), false);
    if (words.empty()) continue;
    if (words[0] == "end_header") return table;
    if (words.size() < 3) continue;
    if (words[0] == "format") table.coding = ply_coding(words, place);
    if (words[0] == "element" && ++elements == 1) {
      if (words[1] != "vertex") throw RecordError(place, "its first element is " + quote(words[1]) + ", not 'vertex'");
      table.points = point_count(words[2], place);
    }
    if (words[0] == "property" && elements == 1) table.columns.push_back(ply_column(words, place));
  }
  throw RecordError(place, "its header has no 'end_header'");
}

/// Where the numbers of x, y and z stand in a row.
struct Places {
  std::size_t xyz[3];
  std::size_t numbers = 0;
  std::size_t bytes = 0;
};

Places find_places(const Table& table, const Place& place) {
  Places places;
  bool found[3] = {false, false, false};
  for (const Column& column : table.columns) {
    if (!can_read(column)) throw RecordError(place, "field " + quote(column.name) + " has a type that no number has");
    for (int a = 0; a < 3; ++a) {
      if (column.name != std::string(1, "xyz"[a]) || column.count != 1) continue;
      found[a] = true;
      places.xyz[a] = places.numbers;
    }
    places.numbers += column.count;
    places.bytes += column.count * column.size;
  }
  if (!found[0] || !found[1] || !found[2]) throw RecordError(place, "its points have no x, y and z");
  return places;
}

/// What a word of a text row says; not finite where it is no number, such as "nan".
double text_number(const std::string& word) {
  double value = 0.0;
  return parse_number(word, value) == NumberError::kNone ? value : std::nan("");
}

std::vector<double> read_row(ByteReader& reader, const Table& table, const Places& places, const Place& place) {
  std::vector<double> row;
  if (table.coding == Coding::kText) {
    const Words words = split_words(reader.line(), false);
    if (words.size() < places.numbers) throw RecordError(place, "a point has fewer numbers than the header says");
    for (const std::string& word : words) row.push_back(text_number(word));
    return row;
  }
  const ByteOrder order = table.coding == Coding::kLittle ? ByteOrder::kLittle : ByteOrder::kBig;
  for (const Column& column : table.columns) {
    for (std::size_t i = 0; i < column.count; ++i) row.push_back(reader.number(column.type, column.size, order));
  }
  return row;
}

std::vector<tern::Vec3> read_points(ByteReader& reader, const Table& table, const Place& place) {
  const Places places = find_places(table, place);
  if (table.coding != Coding::kText && reader.left() / places.bytes < table.points) reader.skip(reader.left() + 1);
  std::vector<tern::Vec3> points;
  for (std::size_t i = 0; i < table.points; ++i) {
    const std::vector<double> row = read_row(reader, table, places, place);
    const tern::Vec3 p{row[places.xyz[0]], row[places.xyz[1]], row[places.xyz[2]]};
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) points.push_back(p);
  }
  return points;
}

/// True if the first line that is neither empty nor a comment is one of a PCD header.
bool is_pcd(const std::string& bytes) {
  std::size_t begin = 0;
  for (int i = 0; i < kMaxHeaderLines && begin < bytes.size(); ++i) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    const Words words = split_words(bytes.substr(begin, end - begin), false);
    if (!words.empty() && words[0][0] != '#') return words[0] == "VERSION" || words[0] == "FIELDS";
    begin = end + 1;
  }
  return false;
}

}  // namespace

std::vector<tern::Vec3> parse_cloud(const std::string& bytes, const Place& place) {
  ByteReader reader(bytes, place);
  if (bytes.compare(0, 3, "ply") == 0) {
    reader.line();
    return read_points(reader, read_ply_header(reader, place), place);
  }
  if (!is_pcd(bytes)) throw RecordError(place, "neither a PCD file nor a PLY file");
  return read_points(reader, read_pcd_header(reader, place), place);
}

}  // namespace tern_host
