// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_json.hpp"

#include <cinttypes>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host/nanoseconds.hpp"
#include "host/swarm/swarm_intruders.hpp"

namespace tern_host {
namespace {

using Json = nlohmann::ordered_json;

Json point(const tern::Vec3& p) {
  return Json::array({p.x, p.y, p.z});
}

Json links_json(const LinkSettings& links) {
  return {{"loss", links.loss},
          {"burst", links.burst},
          {"delay_min", links.delay_min},
          {"delay", links.delay_max},
          {"repeated", links.repeated},
          {"partition", {links.partition.from, links.partition.until}},
          {"deaf", links.deaf},
          {"silent", links.silent},
          {"silent_from", links.silent_from}};
}

Json members_json(const SwarmResult& result) {
  Json all = Json::array();
  for (const SwarmMember& member : result.members) {
    Json one{{"arrived", member.arrived},
             {"length", member.length},
             {"commits", member.commits},
             {"unasked", member.unasked}};
    if (member.arrived < 0.0) one["state"] = member.state;
    all.push_back(one);
  }
  return all;
}

Json contacts_json(const std::vector<SwarmContact>& contacts) {
  Json all = Json::array();
  for (const SwarmContact& contact : contacts) {
    Json one{{"time", seconds_of(contact.time)}, {"first", contact.first}};
    if (contact.intruder < 0) one["second"] = contact.second;
    if (contact.intruder >= 0) one["intruder"] = contact.intruder;
    one["distance"] = contact.distance;
    all.push_back(one);
  }
  return all;
}

Json intruders_json(const SwarmWorld& world, const SwarmResult& result) {
  Json film = Json::array();
  for (const auto& row : result.intruder_film) {
    Json places = Json::array();
    for (const tern::Vec3& place : row) places.push_back(point(place));
    film.push_back(places);
  }
  return {{"things", lines_of(world.intruders)},
          {"least_gap", result.least_gap},
          {"touched_at_rest", contacts_json(result.touched_at_rest)},
          {"film", film}};
}

}  // namespace

std::string swarm_json(const SwarmWorld& world, const SwarmSettings& settings, const SwarmResult& result) {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016" PRIx64, result.hash);
  Json film = Json::array();
  for (const auto& row : result.film) {
    Json places = Json::array();
    for (const tern::Sample& sample : row) places.push_back(point(sample.position));
    film.push_back(places);
  }
  Json all{{"world", world.name},
           {"links", links_json(settings.links)},
           {"clock_error", settings.clock_error},
           {"restarts", settings.restarts},
           {"send_hz", settings.send_hz},
           {"packet_bytes", settings.packet_bytes},
           {"discover", settings.discover},
           {"seed", settings.seed},
           {"vehicles", result.members.size()},
           {"arrived", result.arrived()},
           {"last_arrival", result.last_arrival()},
           {"mean_travel", result.mean_travel()},
           {"time", result.time},
           {"least_distance", result.least_distance},
           {"least_clearance", result.least_clearance},
           {"body_radius", world.body_radius},
           {"contacts", contacts_json(result.contacts)},
           {"packets", result.packets},
           {"lost", result.lost},
           {"bytes", result.bytes},
           {"disagreed", result.disagreed},
           {"fleet_units", result.most_fleet_units},
           {"untold", result.most_untold},
           {"hash", hash},
           {"members", members_json(result)},
           {"film_step", result.film_step},
           {"film", film}};
  if (!world.intruders.empty()) all["intruders"] = intruders_json(world, result);
  return all.dump() + "\n";
}

}  // namespace tern_host
