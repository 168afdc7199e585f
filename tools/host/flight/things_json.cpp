// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/things_json.hpp"

namespace tern_host {
namespace {

nlohmann::ordered_json tracking_json(const TrackingFigures& f) {
  return {{"scans", f.scans},
          {"in_view", f.in_view},
          {"missed", f.missed},
          {"entries", f.entries},
          {"births", f.births},
          {"late_s", f.late},
          {"latest_s", f.latest},
          {"told", f.told},
          {"of_nothing", f.of_nothing},
          {"outside", f.outside},
          {"false_tracks", f.false_tracks}};
}

}  // namespace

nlohmann::ordered_json things_json(const FlightWorld& world, const FlightResult& result) {
  const ThingTotals& totals = result.things;
  nlohmann::ordered_json contacts = nlohmann::ordered_json::array();
  for (const ThingContact& contact : totals.contacts) {
    contacts.push_back({{"thing", world.things[contact.thing].name},
                        {"time_s", contact.time},
                        {"speed", contact.speed},
                        {"in_motion", contact.in_motion},
                        {"in_tube", contact.in_tube}});
  }
  nlohmann::ordered_json json = {{"count", world.things.size()},
                                 {"most_known", totals.detector.most_known},
                                 {"measured", totals.detector.measured},
                                 {"left_out", totals.detector.left_out},
                                 {"touched_in_motion", totals.in_motion()},
                                 {"touched_at_rest", totals.at_rest()},
                                 {"contacts", contacts}};
  if (world.settings.detection_source == "clusters") json["tracking"] = tracking_json(totals.tracking);
  return json;
}

}  // namespace tern_host
