// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/track_record.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/track_fault.hpp"
#include "host/fence_record.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"
#include "host/word_queue.hpp"
#include "tern/config.hpp"
#include "tern/status.hpp"

namespace tern_host {
namespace {

using tern::Track;
using tern::TrackEnd;
using tern::TrackShape;
using tern::Vec3;

void read_end(WordQueue& queue, const Place& place, Track& track) {
  track.until = queue.nanoseconds("the time of 'until'");
  const std::string end = queue.word("what holds after 'until' ('gone', 'stays' or 'reach')");
  if (end == "gone") {
    track.end = TrackEnd::kGone;
  } else if (end == "stays") {
    track.end = TrackEnd::kStays;
  } else if (end == "reach") {
    track.end = TrackEnd::kReach;
  } else {
    throw RecordError(
        place, "after the time of 'until' comes what holds then: 'gone', 'stays' or 'reach'; found " + quote(end));
  }
}

void read_word(const std::string& word, WordQueue& queue, const Place& place, TrackRecord& record) {
  Track& track = record.track;
  if (word == "at") {
    track.position = queue.vector("its place, three numbers after 'at',");
    record.has_place = true;
  } else if (word == "velocity") {
    track.velocity = queue.vector("its velocity, three numbers,");
  } else if (word == "error") {
    track.error = queue.size("e0, the first of the three numbers of 'error',");
    track.error_speed = queue.size("e1, the second of the three numbers of 'error',");
    track.error_growth = queue.size("e2, the third of the three numbers of 'error',");
  } else if (word == "reach") {
    track.reach = queue.size("its reach");
  } else if (word == "from") {
    track.measured = queue.nanoseconds("the time of 'from'");
    record.has_from = true;
  } else if (word == "until") {
    read_end(queue, place, track);
  } else if (word == "plan") {
    record.plan = queue.word("the file of its plan");
  } else {
    throw RecordError(place, "unknown word " + quote(word) +
                                 " of a track, which takes at, velocity, error, reach, from, until and plan");
  }
}

TrackRecord* find_track(const std::string& id, std::vector<TrackRecord>& tracks) {
  for (TrackRecord& record : tracks) {
    if (record.id == id) return &record;
  }
  return nullptr;
}

/// The text of a file that a record names.
std::string read_named(const std::string& path, const TrackRecord& record) {
  try {
    return read_text(path);
  } catch (const RecordError& error) {
    throw RecordError(record.place, "the plan of track " + quote(record.id) + ": " + error.what());
  }
}

/// A plan's segments, relative to its origin.
void read_plan(const nlohmann::json& plan, TrackRecord& record) {
  const std::string status = plan.value("status", "ok");
  if (status != "ok") {
    throw RecordError(record.place, quote(record.plan) + " has no plan: its 'status' is " + quote(status));
  }
  const auto point = [](const nlohmann::json& v) {
    return Vec3{v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
  };
  record.track.position = point(plan.at("origin"));
  for (const nlohmann::json& segment : plan.at("segments")) {
    tern::TrackPiece piece{};
    piece.duration = segment.at("duration").get<double>();
    for (std::size_t i = 0; i < tern::kControlPoints; ++i) piece.points[i] = point(segment.at("relative_points").at(i));
    record.pieces.push_back(piece);
  }
}

/// Where another frame is the plan's, its points are elsewhere.
void check_frame(const nlohmann::json& plan, const EarthFrame& earth, const std::string& path, const Place& place) {
  if (!plan.contains("frame")) return;
  const nlohmann::json& frame = plan.at("frame");
  if (frame.contains("latitude") && earth.origin) {
    const EarthOrigin origin{frame.at("latitude").get<double>(), frame.at("longitude").get<double>()};
    if (!are_same(origin, *earth.origin)) {
      throw RecordError(place, "the origin of " + quote(path) + " is " + origin_text(origin) + ", not " +
                                   origin_text(*earth.origin) + " as the scenario's");
    }
  }
  if (!frame.contains("height") || !earth.height) return;
  const double height = frame.at("height").get<double>();
  if (are_same_heights(height, *earth.height)) return;
  throw RecordError(place, "the origin of " + quote(path) + " is at a height of " + shortest(height) + " m, not " +
                               shortest(*earth.height) + " m as the scenario's");
}

/// It points into the record.
Track with_pieces(const TrackRecord& record) {
  Track track = record.track;
  track.pieces = record.pieces.empty() ? nullptr : record.pieces.data();
  track.piece_count = static_cast<std::int32_t>(record.pieces.size());
  return track;
}

/// What the planner would refuse.
void check_track(const TrackRecord& record) {
  const bool is_late = record.track.end != TrackEnd::kGoesOn && record.track.until < record.track.measured;
  if (is_late) throw RecordError(record.place, "track " + quote(record.id) + " ends before it was measured");
  if (record.track.end == TrackEnd::kReach && !(record.track.reach > 0.0)) {
    throw RecordError(record.place, "track " + quote(record.id) +
                                        " ends with 'reach' and has no 'reach v': its error " +
                                        "would not grow. Say how fast it may be, or end it with 'stays'");
  }
  const Track track = with_pieces(record);
  const tern::Status status = tern::find_track_fault(&track, 1).status;
  if (status == tern::Status::kOk) return;
  throw RecordError(record.place, "track " + quote(record.id) + ": " + tern::status_meaning(status));
}

}  // namespace

void read_shape(WordQueue& queue, Track& track) {
  const std::string shape = queue.word("its shape");
  if (shape == "ball") {
    track.shape = TrackShape::kBall;
    track.radius = queue.size("the radius");
  } else if (shape == "cylinder") {
    track.shape = TrackShape::kCylinder;
    track.radius = queue.size("the radius");
    track.half.z = 0.5 * queue.size("the height");
  } else if (shape == "box") {
    track.shape = TrackShape::kBox;
    const double x = queue.size("half an edge");
    const double y = queue.size("half an edge");
    track.half = {x, y, queue.size("half an edge")};
  } else {
    queue.refuse("a " + queue.record() + " is a 'ball', a 'cylinder' or a 'box', found " + quote(shape));
  }
}

TrackRecord read_track(const Words& words, const Place& place) {
  TrackRecord record;
  record.place = place;
  WordQueue queue(words, place);
  record.id = queue.word("its name");
  read_shape(queue, record.track);
  Words before;
  while (!queue.empty()) {
    const std::string word = queue.word("a word");
    if (std::find(before.begin(), before.end(), word) != before.end()) {
      throw RecordError(place, quote(word) + " stands twice in track " + quote(record.id));
    }
    before.push_back(word);
    read_word(word, queue, place, record);
  }
  return record;
}

void add_track_piece(const Words& words, const Place& place, std::vector<TrackRecord>& tracks) {
  constexpr std::size_t kWords = 3 + 3 * tern::kControlPoints;
  if (words.size() != kWords) {
    throw RecordError(place, "'track_piece' needs a name, a duration and 24 numbers");
  }
  TrackRecord* const record = find_track(words[1], tracks);
  if (record == nullptr) throw RecordError(place, "no 'track' " + quote(words[1]) + " stands before its piece");
  tern::TrackPiece piece{};
  piece.duration = number(words[2], place);
  if (!(piece.duration > 0.0)) throw RecordError(place, "a piece must last longer than 0");
  for (std::size_t i = 0; i < tern::kControlPoints; ++i) {
    piece.points[i] = {number(words[3 + 3 * i], place), number(words[4 + 3 * i], place),
                       number(words[5 + 3 * i], place)};
  }
  record->pieces.push_back(piece);
}

std::string keepout_name(std::size_t number, const std::string& zone) {
  return "keepout " + std::to_string(number) + (zone.empty() ? "" : " (" + zone + ")");
}

TrackRecord read_timed_keepout(const Words& words, const FenceEnd& end, const std::string& name, const Place& place) {
  const tern::Box box = box_of(numbers(words, place), "keepout", place);
  TrackRecord record;
  record.id = name;
  record.is_fence = record.has_place = record.has_from = true;
  record.place = place;
  Track& track = record.track;
  track.shape = TrackShape::kBox;
  track.position = {0.5 * (box.lower.x + box.upper.x), 0.5 * (box.lower.y + box.upper.y),
                    0.5 * (box.lower.z + box.upper.z)};
  // Rounding moves no face inwards.
  const auto half = [](double lower, double middle, double upper) {
    return std::nextafter(std::fmax(upper - middle, middle - lower), HUGE_VAL);
  };
  track.half = {half(box.lower.x, track.position.x, box.upper.x), half(box.lower.y, track.position.y, box.upper.y),
                half(box.lower.z, track.position.z, box.upper.z)};
  const auto off = static_cast<std::int64_t>(std::ceil(end.clock_error * 1e9));
  track.measured = end.from - off;
  track.until = end.until + off;
  track.end = TrackEnd::kGone;
  return record;
}

namespace {

/// What says where the thing is: one of three.
void check_curve(const TrackRecord& record) {
  const int curves = (record.has_place ? 1 : 0) + (record.pieces.empty() ? 0 : 1) + (record.plan.empty() ? 0 : 1);
  if (curves == 1) return;
  throw RecordError(record.place, "track " + quote(record.id) + " needs either 'at', pieces or a 'plan'" +
                                      (curves == 0 ? "" : ", and has more than one of them"));
}

}  // namespace

void complete_tracks(double start, std::vector<TrackRecord>& tracks) {
  std::size_t pieces = 0;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    TrackRecord& record = tracks[i];
    if (i == std::size_t{tern::kMaxTracks}) {
      throw RecordError(record.place, "more than " + std::to_string(tern::kMaxTracks) + " tracks");
    }
    if (find_track(record.id, tracks) != &record) {
      throw RecordError(record.place, "track " + quote(record.id) + " is given twice");
    }
    if (!record.has_from) record.track.measured = nanoseconds(start);
    check_curve(record);
    record.track.id = static_cast<std::uint32_t>(i);
    pieces += record.pieces.size();
    if (pieces > std::size_t{tern::kMaxTrackPieces}) {
      throw RecordError(record.place, "more than " + std::to_string(tern::kMaxTrackPieces) + " pieces of tracks");
    }
    if (record.plan.empty()) check_track(record);
  }
}

void load_plans(const std::string& folder, const EarthFrame& earth, std::vector<TrackRecord>& tracks) {
  for (TrackRecord& record : tracks) {
    if (record.plan.empty()) continue;
    const std::string path = folder + record.plan;
    try {
      const nlohmann::json plan = nlohmann::json::parse(read_named(path, record));
      check_frame(plan, earth, path, record.place);
      read_plan(plan, record);
    } catch (const nlohmann::json::exception&) {
      throw RecordError(record.place, quote(path) + " is no plan file as `tern plan --json` writes it");
    }
    check_track(record);
  }
}

std::vector<Track> tracks_of(const std::vector<TrackRecord>& records) {
  std::vector<Track> tracks;
  for (const TrackRecord& record : records) tracks.push_back(with_pieces(record));
  return tracks;
}

}  // namespace tern_host
