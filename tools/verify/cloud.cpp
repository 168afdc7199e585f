// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// PCD and PLY files. A header is a list of fields and a number of rows; the rest is those rows.
#include <algorithm>
#include <cmath>
#include <map>

#include "verify/bytes.hpp"
#include "verify/map_files.hpp"

namespace tern_verify {
namespace {

using Words = std::vector<std::string>;

struct Field {
  std::string name;
  char type;
  std::size_t size;   ///< bytes of a number
  std::size_t count;  ///< numbers
};

struct Layout {
  std::vector<Field> fields;
  std::uint64_t rows = 0;
  std::string coding;  ///< as the file calls it

  std::size_t row_bytes() const {
    std::size_t sum = 0;
    for (const Field& field : fields) sum += field.size * field.count;
    return sum;
  }
};

std::uint64_t count_of(const std::string& word, const Bytes& bytes) {
  const double count = word_value(word, bytes);
  if (!(count >= 0 && count < 1e9 && count == std::floor(count))) bytes.refuse("'" + word + "' is no count");
  return static_cast<std::uint64_t>(count);
}

Layout pcd_layout(Bytes& bytes) {
  std::map<std::string, Words> lines;
  while (lines.count("DATA") == 0) {
    const Words words = bytes.words();
    if (!words.empty() && words[0][0] != '#') lines[words[0] == "COLUMNS" ? "FIELDS" : words[0]] = words;
  }
  const std::size_t fields = lines["FIELDS"].size();
  if (lines.count("COUNT") == 0) lines["COUNT"] = Words(fields, "1");
  for (const char* const key : {"FIELDS", "SIZE", "TYPE", "COUNT"}) {
    if (fields < 2 || lines[key].size() != fields) bytes.refuse(std::string("'") + key + "' does not fit 'FIELDS'");
  }
  if (lines["POINTS"].size() != 2 || lines["DATA"].size() != 2) bytes.refuse("there is no 'POINTS', or no 'DATA'");
  Layout layout;
  for (std::size_t f = 1; f < fields; ++f) {
    layout.fields.push_back({lines["FIELDS"][f], lines["TYPE"][f][0], count_of(lines["SIZE"][f], bytes),
                             count_of(lines["COUNT"][f], bytes)});
  }
  layout.rows = count_of(lines["POINTS"][1], bytes);
  layout.coding = lines["DATA"][1];
  return layout;
}

Field property_of(const Words& words, const Bytes& bytes) {
  static const std::map<std::string, std::pair<char, std::size_t>> kTypes = {
      {"char", {'I', 1}},  {"int8", {'I', 1}},    {"uchar", {'U', 1}},  {"uint8", {'U', 1}},
      {"short", {'I', 2}}, {"int16", {'I', 2}},   {"ushort", {'U', 2}}, {"uint16", {'U', 2}},
      {"int", {'I', 4}},   {"int32", {'I', 4}},   {"uint", {'U', 4}},   {"uint32", {'U', 4}},
      {"float", {'F', 4}}, {"float32", {'F', 4}}, {"double", {'F', 8}}, {"float64", {'F', 8}}};
  const auto type = words.size() == 3 ? kTypes.find(words[1]) : kTypes.end();
  if (type == kTypes.end()) bytes.refuse("a property of a vertex that is no number");
  return {words[2], type->second.first, type->second.second, 1};
}

Layout ply_layout(Bytes& bytes) {
  Layout layout;
  int elements = 0;
  bytes.words();
  for (Words words = bytes.words(); words.empty() || words[0] != "end_header"; words = bytes.words()) {
    if (words.empty()) continue;
    if (words[0] == "format" && words.size() == 3) layout.coding = words[1];
    if (words[0] == "element" && ++elements == 1) {
      if (words.size() != 3 || words[1] != "vertex") bytes.refuse("the first element is no vertex");
      layout.rows = count_of(words[2], bytes);
    }
    if (words[0] == "property" && elements == 1) layout.fields.push_back(property_of(words, bytes));
  }
  return layout;
}

/// LZF: runs of bytes as they are, and repetitions of what went before.
std::string unpacked(const std::string& packed, std::size_t size, const Bytes& bytes) {
  std::string out;
  std::size_t i = 0;
  const auto next = [&] {
    if (i == packed.size()) bytes.refuse("the compressed data are broken");
    return static_cast<std::size_t>(static_cast<std::uint8_t>(packed[i++]));
  };
  while (i < packed.size()) {
    const std::size_t control = next();
    if (control < 32) {
      for (std::size_t k = 0; k <= control; ++k) out += static_cast<char>(next());
    } else {
      const std::size_t length = control >> 5 == 7 ? 7 + next() : control >> 5;
      const std::size_t back = ((control & 31) << 8 | next()) + 1;
      if (back > out.size()) bytes.refuse("the compressed data are broken");
      for (std::size_t k = 0; k < length + 2; ++k) out += out[out.size() - back];
    }
    if (out.size() > size) bytes.refuse("the compressed data are broken");
  }
  if (out.size() != size) bytes.refuse("the compressed data are broken");
  return out;
}

/// Where x, y and z stand: their field, and their first byte and their number in a row.
struct Axis {
  Field field;
  std::size_t byte, number;
};

std::array<Axis, 3> axes_of(const Layout& layout, const Bytes& bytes) {
  std::array<Axis, 3> axes;
  int found = 0;
  std::size_t at = 0, number = 0;
  for (const Field& field : layout.fields) {
    const std::size_t axis = std::string("xyz").find(field.name);
    if (field.name.size() == 1 && axis != std::string::npos && field.count == 1) {
      axes[axis] = {field, at, number};
      found += 1 << (2 * axis);
    }
    const bool sized = field.size == 1 || field.size == 2 || field.size == 4 || field.size == 8;
    const bool typed = field.type == 'I' || field.type == 'U' || (field.type == 'F' && field.size >= 4);
    if (!sized || !typed) bytes.refuse("a field that is no number");
    at += field.size * field.count;
    number += field.count;
  }
  if (found != 1 + 4 + 16) bytes.refuse("the points have not one x, y and z each");
  return axes;
}

void add(const CloudPoint& point, std::vector<CloudPoint>& points) {
  if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2])) points.push_back(point);
}

void read_text(Bytes& bytes, const Layout& layout, const std::array<Axis, 3>& axes, std::vector<CloudPoint>& points) {
  std::size_t numbers = 0;
  for (const Field& field : layout.fields) numbers += field.count;
  for (std::uint64_t row = 0; row < layout.rows;) {
    const Words words = bytes.words();
    if (words.empty()) continue;
    if (words.size() != numbers) bytes.refuse("a point has not as many numbers as the header says");
    add({word_value(words[axes[0].number], bytes), word_value(words[axes[1].number], bytes),
         word_value(words[axes[2].number], bytes)},
        points);
    ++row;
  }
}

void read_rows(Bytes& bytes, const Layout& layout, const std::array<Axis, 3>& axes, std::vector<CloudPoint>& points) {
  const bool big = layout.coding == "binary_big_endian";
  for (std::uint64_t row = 0; row < layout.rows; ++row) {
    const std::string text = bytes.take(layout.row_bytes());
    CloudPoint point;
    for (std::size_t a = 0; a < 3; ++a) {
      std::string number = text.substr(axes[a].byte, axes[a].field.size);
      if (big) std::reverse(number.begin(), number.end());
      point[a] = value_of(number, axes[a].field.type);
    }
    add(point, points);
  }
}

/// Compressed, fields come one after the other, each of all points.
void read_fields(Bytes& bytes, const Layout& layout, const std::array<Axis, 3>& axes, std::vector<CloudPoint>& points) {
  const auto packed = static_cast<std::uint64_t>(value_of(bytes.take(4), 'U'));
  const double size = value_of(bytes.take(4), 'U');
  const double wanted = static_cast<double>(layout.rows) * static_cast<double>(layout.row_bytes());
  if (size != wanted) bytes.refuse("the compressed data are not of as many points as the header says");
  const std::string text = unpacked(bytes.take(packed), static_cast<std::size_t>(size), bytes);
  for (std::size_t row = 0; row < layout.rows; ++row) {
    CloudPoint point;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t width = axes[a].field.size;
      point[a] = value_of(text.substr(axes[a].byte * layout.rows + row * width, width), axes[a].field.type);
    }
    add(point, points);
  }
}

}  // namespace

std::vector<CloudPoint> read_cloud(const std::string& content, const std::string& name) {
  Bytes bytes(content, name);
  const Layout layout = content.compare(0, 3, "ply") == 0 ? ply_layout(bytes) : pcd_layout(bytes);
  const std::array<Axis, 3> axes = axes_of(layout, bytes);
  std::vector<CloudPoint> points;
  if (layout.coding == "ascii") {
    read_text(bytes, layout, axes, points);
  } else if (layout.coding == "binary_compressed") {
    read_fields(bytes, layout, axes, points);
  } else if (layout.coding.compare(0, 6, "binary") == 0) {
    read_rows(bytes, layout, axes, points);
  } else {
    bytes.refuse("'" + layout.coding + "' is no coding of points");
  }
  return points;
}

}  // namespace tern_verify
