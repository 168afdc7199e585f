// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/things_json.hpp"

namespace tern_host {

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
  return {{"count", world.things.size()},
          {"most_known", totals.detector.most_known},
          {"measured", totals.detector.measured},
          {"left_out", totals.detector.left_out},
          {"touched_in_motion", totals.in_motion()},
          {"touched_at_rest", totals.at_rest()},
          {"contacts", contacts}};
}

}  // namespace tern_host
