// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A value of a JSON document that knows where it is, so that errors say so: "zones.json: at /features/3/geometry: ...".
#ifndef TERN_HOST_AIRSPACE_JSON_NODE_HPP
#define TERN_HOST_AIRSPACE_JSON_NODE_HPP

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/airspace/zone.hpp"

namespace tern_host {

/// The document. Throws RecordError with the line and column where it goes wrong. `advice`: what to give instead, for
/// the end of the message.
nlohmann::json parse_json(const std::string& bytes, const std::string& file, const std::string& advice = {});

/// A view: the document outlives it. All functions throw RecordError where the value is of another kind.
class JsonNode {
 public:
  JsonNode(const nlohmann::json& value, std::string file, std::string path = "")
      : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

  /// True for an object that has the key, with a value other than null.
  bool has(const char* key) const;
  JsonNode at(const char* key) const;
  std::size_t size() const;  ///< of an array
  JsonNode at(std::size_t index) const;
  std::vector<JsonNode> items() const;  ///< of an array

  bool is_object() const { return value_->is_object(); }
  bool is_array() const { return value_->is_array(); }
  bool is_text() const { return value_->is_string(); }
  bool is_number() const { return value_->is_number(); }
  double number() const;          ///< finite
  double number_or_text() const;  ///< likewise, or the text of one: some files have them in quotes
  int whole() const;              ///< within +- 1e9
  bool flag() const;
  const std::string& text() const;
  /// The text of a member, or `otherwise` where there is none or it is null.
  std::string text_or(const char* key, const std::string& otherwise) const;
  Instant instant() const;
  Instant day_time() const;
  /// Latitude and longitude of an array that begins with them, in this order or the other.
  GeoPoint latitude_longitude() const;
  GeoPoint longitude_latitude() const;

  /// The file and the place in it.
  std::string place() const { return file_ + " at " + (path_.empty() ? "/" : path_); }
  [[noreturn]] void refuse(const std::string& reason) const;

 private:
  const nlohmann::json* value_;
  std::string file_;
  std::string path_;
};

/// The corners of an array of positions; a last one equal to the first is dropped. Throws RecordError where there are
/// fewer than three.
std::vector<GeoPoint> ring_of(const JsonNode& positions, GeoPoint (JsonNode::*order)() const);

/// A point whose numbers are within range; `place` is called for the place if they are not.
void check_point(const GeoPoint& point, const JsonNode& place);

}  // namespace tern_host

#endif
