// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/cloud_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/number.hpp"

namespace tern_host {
namespace {

/// LZF makes three bytes of 264 at best.
constexpr std::uint64_t kMostPacked = 88;
/// PCL leaves the header's page of memory at the end of what it writes.
constexpr std::size_t kPageBytes = 4096;
constexpr std::size_t kMostPageBytes = 65536;

bool can_read(const Column& column) {
  const std::size_t s = column.size;
  const bool size = s == 4 || s == 8 || (column.type != 'F' && (s == 1 || s == 2));
  return size && (column.type == 'F' || column.type == 'I' || column.type == 'U');
}

/// Where x, y and z stand in a row.
struct Layout {
  std::size_t numbers = 0;
  std::uint64_t bytes = 0;
  std::size_t column[3];  ///< the fields
  std::size_t number[3];  ///< their place among the numbers
  std::size_t offset[3];  ///< and among the bytes
};

Layout layout_of(const Element& points, const Place& place) {
  Layout layout;
  int found[3] = {0, 0, 0};
  for (std::size_t c = 0; c < points.columns.size(); ++c) {
    const Column& column = points.columns[c];
    if (!can_read(column)) {
      throw RecordError(place, "field " + quote(column.name) +
                                   " has a type that no number has: " + quote(std::string(1, column.type)) + " of " +
                                   std::to_string(column.size) + " bytes");
    }
    for (std::size_t a = 0; a < 3; ++a) {
      if (column.name != std::string(1, "xyz"[a])) continue;
      if (column.count != 1) throw RecordError(place, "field " + quote(column.name) + " has more than one number");
      if (++found[a] > 1) throw RecordError(place, "field " + quote(column.name) + " is given twice");
      layout.column[a] = c;
      layout.number[a] = layout.numbers;
      layout.offset[a] = static_cast<std::size_t>(layout.bytes);
    }
    layout.numbers += column.count;
    layout.bytes += column.count * column.size;
  }
  if (found[0] + found[1] + found[2] != 3) throw RecordError(place, "its points have no x, y and z");
  return layout;
}

void add_point(const tern::Vec3& p, Cloud& cloud) {
  if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) {
    cloud.points.push_back(p);
  } else {
    ++cloud.dropped;
  }
}

/// What a word of a row says. Only a word that names it is not finite: a sensor saw nothing there.
double number_in(const std::string& word, bool whole, const Place& place) {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (!whole && names_a_non_finite(word)) return value;
  if (parse_number(word, value) != NumberError::kNone) {
    throw RecordError(place, quote(word) + " is not a number: they are decimal with a point, or 'nan' or 'inf'");
  }
  if (whole && std::floor(value) != value) {
    throw RecordError(place, quote(word) + " is not a whole number, as the header says of its field");
  }
  return value;
}

void read_text_row(ByteReader& reader, const Table& table, const Layout& layout, Cloud& cloud) {
  const Words words = split_words(reader.line(), false);
  if (words.empty()) return;
  if (words.size() != layout.numbers) {
    throw RecordError(reader.line_place(), "a point has " + std::to_string(words.size()) +
                                               " numbers, the header says " + std::to_string(layout.numbers));
  }
  std::vector<double> row;
  for (const Column& column : table.points.columns) {
    for (std::size_t i = 0; i < column.count; ++i) {
      row.push_back(number_in(words[row.size()], column.type != 'F', reader.line_place()));
    }
  }
  add_point({row[layout.number[0]], row[layout.number[1]], row[layout.number[2]]}, cloud);
}

/// All lines that are not blank are rows: those of the points, then those of the other elements.
void read_text(ByteReader& reader, const Table& table, const Layout& layout, Cloud& cloud) {
  const std::uint64_t wanted = table.points.count;
  const auto found = [&] { return cloud.points.size() + cloud.dropped; };
  while (found() < wanted && !reader.at_end()) read_text_row(reader, table, layout, cloud);
  std::uint64_t others = 0;
  for (const Element& element : table.others) others += element.count;
  std::uint64_t rows = 0;
  while (!reader.at_end()) rows += reader.skip_line() ? 1 : 0;
  if (found() == wanted && rows == others) return;
  throw RecordError(reader.line_place(), "the header says " + std::to_string(wanted) + " points" +
                                             (others > 0 ? " and " + std::to_string(others) + " other rows" : "") +
                                             ", the file has " + std::to_string(found()) + " and " +
                                             std::to_string(rows) + (others > 0 ? "" : " more lines") +
                                             ": copy it again, or write its header again");
}

ByteOrder order_of(const Table& table) {
  return table.coding == Coding::kBig ? ByteOrder::kBig : ByteOrder::kLittle;
}

/// Refuses a file with too few bytes before there is memory for its points.
void expect_bytes(std::uint64_t wanted, std::size_t found, const Element& points, const Place& place) {
  if (wanted <= found) return;
  throw RecordError(place, "the header says " + std::to_string(points.count) + " points, " + std::to_string(wanted) +
                               " bytes, the file has " + std::to_string(found) + ": it is cut off, copy it again");
}

void read_binary(ByteReader& reader, const Table& table, const Layout& layout, const Place& place, Cloud& cloud) {
  expect_bytes(table.points.count * layout.bytes, reader.left(), table.points, place);
  cloud.points.reserve(static_cast<std::size_t>(table.points.count));
  for (std::uint64_t i = 0; i < table.points.count; ++i) {
    const char* const row = reader.peek(static_cast<std::size_t>(layout.bytes));
    double xyz[3];
    for (std::size_t a = 0; a < 3; ++a) {
      const Column& column = table.points.columns[layout.column[a]];
      xyz[a] = number_at(row + layout.offset[a], column.type, column.size, order_of(table));
    }
    reader.skip(static_cast<std::size_t>(layout.bytes));
    add_point({xyz[0], xyz[1], xyz[2]}, cloud);
  }
}

/// Compressed: field after field, each with its numbers of all points.
void read_packed(ByteReader& reader, const Table& table, const Layout& layout, const Place& place, Cloud& cloud) {
  const auto packed = static_cast<std::uint64_t>(reader.number('U', 4, ByteOrder::kLittle));
  const auto size = static_cast<std::uint64_t>(reader.number('U', 4, ByteOrder::kLittle));
  const std::uint64_t wanted = table.points.count * layout.bytes;
  if (size != wanted || size > packed * kMostPacked) {
    throw RecordError(place, "the header says " + std::to_string(table.points.count) + " points, " +
                                 std::to_string(wanted) + " bytes, its compressed data " + std::to_string(size) +
                                 " bytes in " + std::to_string(packed) + ": write the file again");
  }
  expect_bytes(packed, reader.left(), table.points, place);
  const auto count = static_cast<std::size_t>(table.points.count);
  const auto packed_size = static_cast<std::size_t>(packed);
  const std::string bytes = unpack(reader.peek(packed_size), packed_size, static_cast<std::size_t>(size), place);
  reader.skip(packed_size);
  cloud.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    double xyz[3];
    for (std::size_t a = 0; a < 3; ++a) {
      const Column& column = table.points.columns[layout.column[a]];
      const std::size_t at = layout.offset[a] * count + i * column.size;
      xyz[a] = number_at(bytes.data() + at, column.type, column.size, ByteOrder::kLittle);
    }
    add_point({xyz[0], xyz[1], xyz[2]}, cloud);
  }
}

void skip_rows(ByteReader& reader, const Element& element, ByteOrder order) {
  if (element.columns.empty()) return;
  for (std::uint64_t row = 0; row < element.count; ++row) {
    for (const Column& column : element.columns) {
      const double numbers = column.list_size > 0 ? reader.number('U', column.list_size, order) : 1.0;
      if (numbers * static_cast<double>(column.size) > static_cast<double>(reader.left())) {
        reader.skip(reader.left() + 1);
      }
      reader.skip(static_cast<std::size_t>(numbers) * column.size);
    }
  }
}

/// Nothing may follow but the zeros of a page, and the line ends that some programs close a PLY file with.
void expect_end(ByteReader& reader, const Table& table, std::size_t header, const Place& place) {
  const std::size_t left = reader.left();
  if (left == 0) return;
  const std::string rest(reader.peek(left), left);
  const bool page = table.padded && (header + left) % kPageBytes == 0 && header + left <= kMostPageBytes;
  if (page && rest.find_first_not_of('\0') == std::string::npos) return;
  if (!table.padded && rest.find_first_not_of("\r\n") == std::string::npos) return;
  throw RecordError(place, "after the " + std::to_string(table.points.count) + " points of its header, the file has " +
                               std::to_string(left) + " bytes more, from byte " + std::to_string(reader.at()) +
                               " on: write it again");
}

}  // namespace

std::uint64_t point_count(const std::string& word, const Place& place) {
  return whole_number(word, static_cast<double>(kMaxCloudPoints), place);
}

void read_points(ByteReader& reader, const Table& table, const Place& place, Cloud& cloud) {
  const Layout layout = layout_of(table.points, place);
  const std::size_t header = reader.at();
  if (table.coding == Coding::kText) return read_text(reader, table, layout, cloud);
  if (table.coding == Coding::kPacked) {
    read_packed(reader, table, layout, place, cloud);
  } else {
    read_binary(reader, table, layout, place, cloud);
  }
  for (const Element& element : table.others) skip_rows(reader, element, order_of(table));
  expect_end(reader, table, header, place);
}

}  // namespace tern_host
