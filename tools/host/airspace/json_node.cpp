// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/json_node.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "host/number.hpp"
#include "host/text_records.hpp"

namespace tern_host {

namespace {

/// Where and what, of a text that is wrong at a byte, counted from 1.
[[noreturn]] void refuse_text(const std::string& text, std::size_t byte, const std::string& file,
                              const std::string& advice) {
  const std::string end = advice.empty() ? "" : ". " + advice;
  const std::size_t at = byte > 0 ? byte - 1 : 0;
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw RecordError({file, 0}, "the file is empty" + end);
  const std::string_view before = std::string_view(text).substr(0, at);
  const auto line = static_cast<int>(1 + std::count(before.begin(), before.end(), '\n'));
  if (at >= text.size()) {
    throw RecordError({file, line}, "not JSON: the file ends before it is complete (byte " + std::to_string(byte) +
                                        "): it may be cut off" + end);
  }
  const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  std::string near;
  for (std::size_t i = at; i < text.size() && i < at + 20 && text[i] != '\n'; ++i) {
    near += text[i] >= 0x20 && text[i] < 0x7F ? text[i] : '?';
  }
  throw RecordError({file, line},
                    "not JSON: wrong at column " + std::to_string(at - begin + 1) + ", '" + near + "'" + end);
}

/// How many characters must be added, dropped or replaced to make one of the other.
std::size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

/// "; is 'identifer' meant?" for a key that is nearly the one that is missing.
std::string misspelt_text(const nlohmann::json& object, const std::string& key) {
  constexpr std::size_t kLongestKey = 40, kMostEdits = 2;
  for (const auto& member : object.items()) {
    const bool alike = member.key().size() <= kLongestKey && edits_between(member.key(), key) <= kMostEdits;
    if (alike) return "; is " + quote(member.key()) + " meant for it?";
  }
  return "";
}

}  // namespace

nlohmann::json parse_json(const std::string& bytes, const std::string& file, const std::string& advice) {
  try {
    return nlohmann::json::parse(bytes);
  } catch (const nlohmann::json::parse_error& error) {
    refuse_text(bytes, error.byte, file, advice);
  } catch (const nlohmann::json::exception&) {
    throw RecordError({file, 0}, "not JSON: a number is beyond all ranges");
  }
}

void JsonNode::refuse(const std::string& reason) const {
  std::string where;
  for (const char c : path_.substr(0, 200)) where += c >= 0x20 && c < 0x7F ? c : '?';
  throw RecordError({file_, 0}, "at " + (where.empty() ? "/" : where) + ": " + reason);
}

bool JsonNode::has(const char* key) const {
  return value_->is_object() && value_->contains(key) && !(*value_)[key].is_null();
}

JsonNode JsonNode::at(const char* key) const {
  if (!value_->is_object()) refuse("this is no object, so it has no '" + std::string(key) + "'");
  if (value_->contains(key) && !has(key)) refuse("'" + std::string(key) + "' is null: it needs a value");
  if (!has(key)) refuse("'" + std::string(key) + "' is missing" + misspelt_text(*value_, key));
  return {(*value_)[key], file_, path_ + "/" + key};
}

std::size_t JsonNode::size() const {
  if (!value_->is_array()) refuse("this must be an array");
  return value_->size();
}

JsonNode JsonNode::at(std::size_t index) const {
  if (index >= size()) refuse("the array has only " + std::to_string(size()) + " elements");
  return {(*value_)[index], file_, path_ + "/" + std::to_string(index)};
}

std::vector<JsonNode> JsonNode::items() const {
  std::vector<JsonNode> out;
  for (std::size_t i = 0; i < size(); ++i) out.push_back(at(i));
  return out;
}

double JsonNode::number_or_text() const {
  double value = 0.0;
  if (value_->is_string() && parse_number(value_->get<std::string>(), value) == NumberError::kNone) return value;
  return number();
}

double JsonNode::number() const {
  if (!value_->is_number()) refuse("this must be a number");
  const double value = value_->get<double>();
  if (!std::isfinite(value)) refuse("this must be a finite number");
  return value;
}

int JsonNode::whole() const {
  const double value = number();
  if (!(std::fabs(value) <= 1e9) || std::floor(value) != value) refuse("this must be a whole number");
  return static_cast<int>(value);
}

bool JsonNode::flag() const {
  if (!value_->is_boolean()) refuse("this must be true or false");
  return value_->get<bool>();
}

const std::string& JsonNode::text() const {
  if (!value_->is_string()) refuse("this must be a text");
  return value_->get_ref<const std::string&>();
}

std::string JsonNode::text_or(const char* key, const std::string& otherwise) const {
  return has(key) ? at(key).text() : otherwise;
}

Instant JsonNode::instant() const {
  const std::optional<Instant> parsed = parse_instant(text());
  if (!parsed) refuse(quote(text()) + " is no date and time with a time zone, such as 2026-03-01T09:30:00Z");
  return *parsed;
}

Instant JsonNode::day_time() const {
  const std::optional<Instant> parsed = parse_day_time(text());
  if (!parsed) refuse(quote(text()) + " is no time of the day with a time zone, such as 09:30:00Z");
  return *parsed;
}

GeoPoint JsonNode::latitude_longitude() const {
  if (size() < 2) refuse("a position needs a latitude and a longitude");
  const GeoPoint point{at(std::size_t{0}).number(), at(std::size_t{1}).number()};
  check_point(point, *this);
  return point;
}

GeoPoint JsonNode::longitude_latitude() const {
  if (size() < 2) refuse("a position needs a longitude and a latitude");
  const GeoPoint point{at(std::size_t{1}).number(), at(std::size_t{0}).number()};
  check_point(point, *this);
  return point;
}

void check_point(const GeoPoint& point, const JsonNode& place) {
  if (!(std::fabs(point.latitude) <= 90.0)) {
    place.refuse("the latitude " + brief(point.latitude) + " is beyond 90 degrees; is it the longitude?");
  }
  if (!(std::fabs(point.longitude) <= 360.0)) {
    place.refuse("the longitude " + brief(point.longitude) + " is beyond 360 degrees");
  }
}

std::vector<GeoPoint> ring_of(const JsonNode& positions, GeoPoint (JsonNode::*order)() const) {
  std::vector<GeoPoint> ring;
  for (const JsonNode& position : positions.items()) ring.push_back((position.*order)());
  const bool closed = ring.size() > 1 && ring.front().latitude == ring.back().latitude &&
                      ring.front().longitude == ring.back().longitude;
  if (closed) ring.pop_back();
  if (ring.size() < 3) positions.refuse("an outline needs three corners or more");
  return ring;
}

}  // namespace tern_host
