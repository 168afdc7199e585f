// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// QGroundControl's plan files: fences, rally points and mission items.
#include <algorithm>
#include <initializer_list>
#include <string>

#include "host/airspace/formats.hpp"

namespace tern_host {
namespace {

// MAVLink's numbers for autopilots, commands and frames.
constexpr int kArduPilot = 3, kPx4 = 12;
constexpr int kWaypoint = 16, kLoiterTime = 19, kReturn = 20, kLand = 21, kTakeOff = 22, kSpline = 82,
              kVtolTakeOff = 84, kVtolLand = 85, kLastNavigation = 95;

class PlanReader {
 public:
  explicit PlanReader(const JsonNode& document) : document_(document) { file_.format = "QGroundControl plan"; }

  AirspaceFile read() {
    if (document_.text_or("fileType", "") != "Plan") document_.refuse("'fileType' must be 'Plan'");
    check_version(document_, {1});
    Itinerary mission;
    if (document_.has("mission")) read_mission(document_.at("mission"), mission);
    if (document_.has("geoFence")) read_fences(document_.at("geoFence"));
    if (document_.has("rallyPoints") && document_.at("rallyPoints").has("points")) {
      for (const JsonNode& point : document_.at("rallyPoints").at("points").items()) {
        const double height = point.at(std::size_t{2}).number();
        mission.rally.push_back({point.latitude_longitude(), {height, HeightReference::kHome}, 0.0, 0.0});
      }
    }
    file_.mission = mission;
    return std::move(file_);
  }

 private:
  /// Other versions have other members.
  static void check_version(const JsonNode& node, std::initializer_list<int> read) {
    if (!node.has("version")) return;
    const int version = node.at("version").whole();
    if (std::find(read.begin(), read.end(), version) == read.end()) {
      node.at("version").refuse("the version " + std::to_string(version) + " of the format is not read");
    }
  }

  // ---- fences ----

  void read_fences(const JsonNode& fence) {
    check_version(fence, {1, 2});
    if (fence.has("polygons")) {
      for (const JsonNode& polygon : fence.at("polygons").items()) {
        ZoneArea area;
        area.ring = ring_of(polygon.at("polygon"), &JsonNode::latitude_longitude);
        add(area, polygon.at("inclusion").flag(), polygon);
      }
    }
    if (fence.has("circles")) {
      for (const JsonNode& node : fence.at("circles").items()) {
        ZoneArea area;
        area.centre = node.at("circle").at("center").latitude_longitude();
        area.radius = node.at("circle").at("radius").number();
        if (!(area.radius > 0.0)) node.at("circle").at("radius").refuse("a radius must be more than 0");
        add(area, node.at("inclusion").flag(), node);
      }
    }
    // The first version of the format had one polygon to stay in.
    if (fence.has("polygon") && fence.at("polygon").size() > 0) {
      ZoneArea area;
      area.ring = ring_of(fence.at("polygon"), &JsonNode::latitude_longitude);
      add(area, true, fence.at("polygon"));
    }
    join_inclusions(fence);
  }

  void add(const ZoneArea& area, bool inclusion, const JsonNode& node) {
    std::vector<Zone>& zones = inclusion ? inclusions_ : file_.zones;
    Zone zone;
    zone.name = (inclusion ? "inclusion " : "exclusion ") + std::to_string(zones.size() + 1);
    zone.type = area.radius > 0.0 ? "circle" : "polygon";
    zone.place = node.place();
    zone.kind = inclusion ? ZoneKind::kKeepIn : ZoneKind::kKeepOut;
    zone.edges = EdgeRule::kDegrees;
    zone.areas.push_back(area);
    zones.push_back(zone);
  }

  /// PX4 lets a vehicle fly where any inclusion is, ArduPilot where all of them are.
  void join_inclusions(const JsonNode& fence) {
    if (inclusions_.size() > 1 && firmware_ != kPx4 && firmware_ != kArduPilot) {
      fence.refuse(
          "there are several inclusions, and 'firmwareType' is neither 12 (PX4: stay in one of them) nor 3 (ArduPilot: "
          "stay in all of them)");
    }
    if (inclusions_.size() > 1 && firmware_ == kPx4) {
      for (std::size_t i = 1; i < inclusions_.size(); ++i) {
        inclusions_[0].areas.push_back(inclusions_[i].areas[0]);
      }
      inclusions_[0].name = "inclusions 1 to " + std::to_string(inclusions_.size());
      inclusions_[0].notes.push_back("PX4's rule: in any of the inclusions");
      inclusions_.resize(1);
    } else if (inclusions_.size() > 1) {
      inclusions_[0].notes.push_back("ArduPilot's rule: in all of the inclusions");
    }
    file_.zones.insert(file_.zones.begin(), inclusions_.begin(), inclusions_.end());
  }

  // ---- mission ----

  void read_mission(const JsonNode& node, Itinerary& mission) {
    check_version(node, {2});
    if (node.has("firmwareType")) firmware_ = node.at("firmwareType").whole();
    if (node.has("plannedHomePosition")) {
      const JsonNode home = node.at("plannedHomePosition");
      mission.home = home.latitude_longitude();
      mission.home_height = home.at(std::size_t{2}).number();
    }
    if (!node.has("items")) return;
    for (const JsonNode& item : node.at("items").items()) read_item(item, mission);
  }

  void read_item(const JsonNode& item, Itinerary& mission) {
    if (item.at("type").text() == "SimpleItem") return read_simple_item(item, mission);
    if (!item.has("TransectStyleComplexItem") || !item.at("TransectStyleComplexItem").has("Items")) {
      item.refuse("only SimpleItem is read, and ComplexItem with the Items of a TransectStyleComplexItem");
    }
    for (const JsonNode& part : item.at("TransectStyleComplexItem").at("Items").items())
      read_simple_item(part, mission);
  }

  void read_simple_item(const JsonNode& item, Itinerary& mission) {
    const int command = item.at("command").whole();
    const JsonNode params = item.at("params");
    if (params.size() != 7) params.refuse("a command has seven parameters");
    if (command >= kLastNavigation || command == kReturn) {
      file_.left_out.push_back("mission command " + std::to_string(command) + ", " + item.place() +
                               (command == kReturn ? ": a return; set the goal yourself" : ": it moves nothing here"));
      return;
    }
    const bool takes_off = command == kTakeOff || command == kVtolTakeOff;
    const bool known = takes_off || command == kWaypoint || command == kSpline || command == kLoiterTime ||
                       command == kLand || command == kVtolLand;
    if (!known) {
      item.at("command").refuse("the command " + std::to_string(command) +
                                " is not read: 16, 19, 20, 21, 22, 82, 84, 85 and those that move nothing (95 and up)");
    }
    mission.points.push_back(point_of(item, command, takes_off, mission));
  }

  /// A parameter; QGroundControl writes null where one has no meaning.
  static double value(const JsonNode& params, std::size_t index) {
    return params.at(index).is_number() ? params.at(index).number() : 0.0;
  }

  static ZoneHeight height_of(const JsonNode& item, const JsonNode& params) {
    const double metres = params.at(std::size_t{6}).number();
    switch (item.at("frame").whole()) {
      case 0:
      case 5:
        return {metres, HeightReference::kSeaLevel};
      case 3:
      case 6:
        return {metres, HeightReference::kHome};
      case 10:
      case 11:
        return {metres, HeightReference::kGround};
      default:
        item.at("frame").refuse("the frame is none of 0, 3, 5, 6, 10 and 11: above the sea, home or the ground");
    }
  }

  static ItineraryPoint point_of(const JsonNode& item, int command, bool takes_off, const Itinerary& mission) {
    const JsonNode params = item.at("params");
    const bool placed = params.at(std::size_t{4}).is_number() && params.at(std::size_t{5}).is_number();
    const bool at_home = takes_off && (!placed || (value(params, 4) == 0.0 && value(params, 5) == 0.0));
    ItineraryPoint point{{value(params, 4), value(params, 5)}, height_of(item, params), 0.0, 0.0};
    if (at_home && !mission.home) item.refuse("a take-off without a place needs a 'plannedHomePosition'");
    if (at_home) point.point = *mission.home;
    if (!placed && !at_home) params.refuse("latitude and longitude, the fifth and sixth, are missing");
    check_point(point.point, params);
    if (command == kWaypoint || command == kSpline || command == kLoiterTime) point.dwell = value(params, 0);
    if (command == kWaypoint) point.tolerance = value(params, 1);
    if (point.dwell < 0.0 || point.tolerance < 0.0) params.refuse("a time or a radius is less than 0");
    return point;
  }

  JsonNode document_;
  AirspaceFile file_;
  std::vector<Zone> inclusions_;
  int firmware_ = 0;
};

}  // namespace

AirspaceFile read_qgc_plan(const JsonNode& document) {
  return PlanReader(document).read();
}

}  // namespace tern_host
