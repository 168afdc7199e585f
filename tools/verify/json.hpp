// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact numbers from JSON.
#ifndef TERN_VERIFY_JSON_HPP
#define TERN_VERIFY_JSON_HPP

#include <cmath>
#include <nlohmann/json.hpp>

#include "verify/plan.hpp"

namespace tern_verify {

using Json = nlohmann::json;

inline Rational number_of(const Json& json) {
  const double value = json.get<double>();
  if (!std::isfinite(value)) throw InputError("a number is not finite");
  return Rational(value);
}

inline Point point_of(const Json& json, std::size_t first = 0) {
  if (json.size() < first + 3) throw InputError("a point has three coordinates");
  return {number_of(json.at(first)), number_of(json.at(first + 1)), number_of(json.at(first + 2))};
}

/// Duration and control points.
inline Segment segment_of(const Json& json) {
  constexpr std::size_t kControlPoints = 8;
  if (!json.contains("relative_points")) {
    throw InputError("a segment has no 'relative_points': write the file anew with this version's `tern`");
  }
  Segment segment{{}, number_of(json.at("duration"))};
  for (const Json& point : json.at("relative_points")) segment.points.push_back(point_of(point));
  if (segment.points.size() != kControlPoints) throw InputError("a segment has eight control points");
  if (segment.duration <= 0) throw InputError("a segment's duration is not above 0");
  return segment;
}

/// `read` of a text's JSON; all that goes wrong names the file.
template <typename Read>
auto read_json(const std::string& text, const std::string& name, const std::string& kind, Read read) {
  try {
    return read(Json::parse(text));
  } catch (const Json::exception& error) {
    throw InputError(name + ": not a " + kind + ": " + error.what());
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
}

}  // namespace tern_verify

#endif
