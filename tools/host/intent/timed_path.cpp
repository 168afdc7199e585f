// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/timed_path.hpp"

#include "host/airspace/json_node.hpp"

namespace tern_host {
namespace {

tern::Vec3 point_of(const JsonNode& node) {
  if (node.size() != 3) node.refuse("a point has three coordinates");
  return {node.at(std::size_t{0}).number(), node.at(std::size_t{1}).number(), node.at(std::size_t{2}).number()};
}

PathPiece piece_of(const JsonNode& segment, double begin) {
  const JsonNode duration = segment.at("duration");
  PathPiece piece{begin, begin + duration.number(), {}};
  if (!(piece.end > begin)) duration.refuse("a duration must be more than 0");
  const JsonNode points = segment.at("control_points");
  if (points.size() != piece.points.size()) points.refuse("a segment has eight control points");
  for (std::size_t i = 0; i < piece.points.size(); ++i) piece.points[i] = point_of(points.at(i));
  return piece;
}

double length_of(const JsonNode& node) {
  const double length = node.number();
  if (!(length >= 0.0)) node.refuse("this must be 0 or more");
  return length;
}

EarthFrame earth_of(const JsonNode& frame) {
  EarthFrame earth;
  if (frame.has("latitude")) earth.origin = EarthOrigin{frame.at("latitude").number(), frame.at("longitude").number()};
  if (frame.has("height")) earth.height = frame.at("height").number();
  if (!frame.has("epoch")) return earth;
  frame.at("epoch").instant();  // refuses what is none
  earth.epoch = frame.at("epoch").text();
  return earth;
}

TimedPath path_of(const JsonNode& plan) {
  if (plan.text_or("format", "") != "tern-plan/1") plan.refuse("its 'format' is not 'tern-plan/1'");
  if (plan.text_or("status", "") != "ok") plan.refuse("it has no trajectory: its 'status' is not 'ok'");
  TimedPath path{"", {}, length_of(plan.at("robot_radius")) + length_of(plan.at("tracking_margin")), {}};
  if (plan.has("rest_clear")) path.rest = length_of(plan.at("rest_clear"));
  if (plan.has("frame")) path.earth = earth_of(plan.at("frame"));
  if (!plan.has("start_time"))
    plan.refuse("it does not say when it begins ('start_time'): an earlier Tern made it; plan again");
  double begin = plan.at("start_time").number();
  for (const JsonNode& segment : plan.at("segments").items()) {
    path.pieces.push_back(piece_of(segment, begin));
    begin = path.pieces.back().end;
  }
  if (path.pieces.empty()) plan.at("segments").refuse("it has no segments");
  return path;
}

}  // namespace

TimedPath parse_timed_path(const std::string& text, const std::string& name) {
  const nlohmann::json json =
      parse_json(text, name, "PLAN is what 'tern plan --json FILE' writes; a scenario goes to --scenario");
  TimedPath path = path_of(JsonNode(json, name));
  path.name = name;
  return path;
}

TimedPath read_timed_path(const std::string& path) {
  return parse_timed_path(read_text(path), path);
}

TimedPath timed_path_of(const PlanResult& result) {
  TimedPath path{
      result.scenario.name, {}, result.scenario.clearance(), result.scenario.earth, result.scenario.rest_clear};
  const tern::Trajectory& trajectory = result.trajectory;
  double begin = result.scenario.start_time;
  for (int i = 0; i < trajectory.count; ++i) {
    const tern::Segment& segment = trajectory.segments[i];
    PathPiece piece{begin, begin + segment.duration, {}};
    for (std::size_t k = 0; k < piece.points.size(); ++k) {
      const tern::Vec3& p = segment.points[k];
      const tern::Vec3& origin = trajectory.origin;
      piece.points[k] = {p.x + origin.x, p.y + origin.y, p.z + origin.z};
    }
    path.pieces.push_back(piece);
    begin = piece.end;
  }
  return path;
}

TimedPath with_rest(TimedPath path, double seconds) {
  const PathPiece& last = path.pieces.back();
  PathPiece rest{last.end, last.end + seconds, {}};
  rest.points.fill(last.points.back());
  path.pieces.push_back(rest);
  return path;
}

}  // namespace tern_host
