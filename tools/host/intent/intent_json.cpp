// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/intent_json.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

namespace tern_host {
namespace {

using Json = nlohmann::ordered_json;

/// Stands for a subscription until the DSS names one.
constexpr const char* kNoSubscription = "00000000-0000-4000-8000-000000000000";

Json time_json(Instant instant) {
  return {{"value", instant_text(instant)}, {"format", "RFC3339"}};
}

Json height_json(double metres) {
  return {{"value", metres}, {"reference", "W84"}, {"units", "M"}};
}

Json point_json(const GeoPoint& point) {
  return {{"lat", point.latitude}, {"lng", point.longitude}};
}

Json volume_json(const Zone& zone) {
  Json volume;
  const ZoneArea& area = zone.areas[0];
  if (area.radius > 0.0) {
    volume["outline_circle"] = {{"center", point_json(area.centre)},
                                {"radius", {{"value", area.radius}, {"units", "M"}}}};
  } else {
    Json& vertices = volume["outline_polygon"]["vertices"];
    for (const GeoPoint& corner : area.ring) vertices.push_back(point_json(corner));
  }
  volume["altitude_lower"] = height_json(zone.lower->metres);
  volume["altitude_upper"] = height_json(zone.upper->metres);
  const TimeSpan span = span_of(zone);
  return {{"volume", volume}, {"time_start", time_json(span.from)}, {"time_end", time_json(span.until)}};
}

}  // namespace

bool is_entity_id(const std::string& id) {
  const std::string form = "xxxxxxxx-xxxx-4xxx-yxxx-xxxxxxxxxxxx";
  if (id.size() != form.size()) return false;
  for (std::size_t i = 0; i < id.size(); ++i) {
    const bool digit = std::isxdigit(static_cast<unsigned char>(id[i])) != 0;
    if (form[i] == 'x'   ? !digit
        : form[i] == 'y' ? std::string("89abAB").find(id[i]) == std::string::npos
                         : id[i] != form[i]) {
      return false;
    }
  }
  return true;
}

std::string intent_json(const UtmEntity& intent) {
  TimeSpan all = span_of(intent.volumes.front());
  Json volumes = Json::array();
  for (const Zone& zone : intent.volumes) {
    const TimeSpan span = span_of(zone);
    all = {std::min(all.from, span.from), std::max(all.until, span.until)};
    volumes.push_back(volume_json(zone));
  }
  Json reference = {{"id", intent.id},
                    {"manager", intent.manager},
                    {"uss_availability", "Unknown"},
                    {"version", intent.version},
                    {"state", intent.state}};
  if (!intent.ovn.empty()) reference["ovn"] = intent.ovn;
  reference["time_start"] = time_json(all.from);
  reference["time_end"] = time_json(all.until);
  reference["uss_base_url"] = intent.base_url;
  reference["subscription_id"] = kNoSubscription;
  const Json details = {{"volumes", volumes}, {"off_nominal_volumes", Json::array()}, {"priority", intent.priority}};
  const Json document = {{"operational_intent", {{"reference", reference}, {"details", details}}}};
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tern_host
