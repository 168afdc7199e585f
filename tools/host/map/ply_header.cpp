// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/cloud_table.hpp"

namespace tern_host {
namespace {

struct PlyType {
  const char* name;
  char type;
  std::size_t size;
};
constexpr PlyType kPlyTypes[] = {{"char", 'I', 1},  {"int8", 'I', 1},    {"uchar", 'U', 1},  {"uint8", 'U', 1},
                                 {"short", 'I', 2}, {"int16", 'I', 2},   {"ushort", 'U', 2}, {"uint16", 'U', 2},
                                 {"int", 'I', 4},   {"int32", 'I', 4},   {"uint", 'U', 4},   {"uint32", 'U', 4},
                                 {"float", 'F', 4}, {"float32", 'F', 4}, {"double", 'F', 8}, {"float64", 'F', 8}};

const PlyType& type_of(const std::string& name, const Place& place) {
  for (const PlyType& type : kPlyTypes) {
    if (name == type.name) return type;
  }
  throw RecordError(place, "a property of no known type: " + quote(name));
}

/// `property TYPE NAME`, or `property list TYPE TYPE NAME`.
Column column_of(const Words& words, const Place& place) {
  Column column;
  const bool list = words.size() == 5 && words[1] == "list";
  if (!list && words.size() != 3) throw RecordError(place, "a 'property' is not a type and a name");
  const PlyType& type = type_of(words[words.size() - 2], place);
  column.name = words.back();
  column.type = type.type;
  column.size = type.size;
  if (!list) return column;
  const PlyType& length = type_of(words[2], place);
  if (length.type == 'F') throw RecordError(place, "a list whose length is not a whole number");
  column.list_size = length.size;
  return column;
}

Coding coding_of(const Words& words, const Place& place) {
  if (words.size() != 3) throw_count("format", "a coding and a version", words.size() - 1, place);
  if (words[2] != "1.0") throw RecordError(place, "a PLY file of version " + quote(words[2]) + ", not 1.0");
  if (words[1] == "ascii") return Coding::kText;
  if (words[1] == "binary_little_endian") return Coding::kLittle;
  if (words[1] == "binary_big_endian") return Coding::kBig;
  throw RecordError(place, "'format' is " + quote(words[1]) + ": save it as ascii or binary");
}

/// The elements in their order.
class PlyHeader {
 public:
  void add(const Words& words, const Place& place) {
    if (words[0] == "format") return set_format(words, place);
    if (!has_format_) throw RecordError(place, "its second line is not a 'format'");
    if (words[0] == "element") return add_element(words, place);
    if (words[0] == "property") return add_property(words, place);
    throw RecordError(place, "unknown word " + quote(words[0]) + " in its header");
  }

  Table table(const Place& end) const {
    if (elements_.empty()) throw RecordError(end, "its header has no 'element vertex'");
    Table table;
    table.points = elements_.front();
    table.points.name = "point";
    table.others.assign(elements_.begin() + 1, elements_.end());
    table.coding = coding_;
    return table;
  }

 private:
  void set_format(const Words& words, const Place& place) {
    if (has_format_) throw RecordError(place, "'format' is given twice");
    coding_ = coding_of(words, place);
    has_format_ = true;
  }

  /// The vertices must come first.
  void add_element(const Words& words, const Place& place) {
    if (words.size() != 3) throw_count("element", "a name and a number", words.size() - 1, place);
    if (elements_.empty() && words[1] != "vertex") {
      throw RecordError(place, "its first element is " + quote(words[1]) + ", not 'vertex': save it with points first");
    }
    for (const Element& other : elements_) {
      if (other.name == words[1]) throw RecordError(place, "element " + quote(words[1]) + " is given twice");
    }
    elements_.push_back({words[1], point_count(words[2], place), {}});
  }

  void add_property(const Words& words, const Place& place) {
    if (elements_.empty()) throw RecordError(place, "a 'property' before the first 'element'");
    const Column column = column_of(words, place);
    if (elements_.size() == 1 && column.list_size != 0) {
      throw RecordError(place, "property " + quote(column.name) + " of a vertex is a list: save the points without it");
    }
    elements_.back().columns.push_back(column);
  }

  std::vector<Element> elements_;
  Coding coding_ = Coding::kText;
  bool has_format_ = false;
};

}  // namespace

Table read_ply_header(ByteReader& reader) {
  PlyHeader header;
  reader.line();  // ply
  while (!reader.at_end() && reader.line_place().line < kMaxCloudHeaderLines) {
    const Words words = split_words(reader.line(), false);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") return header.table(reader.line_place());
    header.add(words, reader.line_place());
  }
  throw RecordError(reader.line_place(), "its header has no 'end_header'");
}

}  // namespace tern_host
