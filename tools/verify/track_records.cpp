// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/track_records.hpp"

#include <algorithm>
#include <filesystem>

#include "verify/fence_records.hpp"
#include "verify/plan.hpp"

namespace tern_verify {
namespace {

/// The words of a record, one after the other.
struct Reader {
  const Record& record;
  std::size_t next = 1;
  std::string of = "track";  ///< the last keyword, for messages

  bool empty() const { return next >= record.words.size(); }
  const std::string& word() {
    if (empty()) record.refuse("the record ends where something of '" + of + "' is missing");
    return record.words[next++];
  }
  Rational number() {
    const std::size_t at = next;
    if (!is_number(word())) record.refuse("'" + record.words[at] + "' is no number, as '" + of + "' needs");
    return Record{record.file, record.line, {record.words[at]}}.numbers(0).front();
  }
  Rational size() {
    const Rational value = number();
    if (value < 0) record.refuse("a size or an error is negative");
    return value;
  }
  Point point() {
    const Rational x = number();
    const Rational y = number();
    return {x, y, number()};
  }
};

void read_shape(Reader& reader, Thing& thing) {
  const std::string shape = reader.word();
  if (shape == "ball") {
    thing.radius = reader.size();
  } else if (shape == "cylinder") {
    thing.shape = ThingShape::kCylinder;
    thing.radius = reader.size();
    thing.half[2] = reader.size() / 2;
  } else if (shape == "box") {
    thing.shape = ThingShape::kBox;
    const Rational x = reader.size();
    const Rational y = reader.size();
    thing.half = {x, y, reader.size()};
  } else {
    reader.record.refuse("unknown shape '" + shape + "'");
  }
}

void read_end(Reader& reader, Thing& thing) {
  thing.until = whole_nanoseconds(reader.number());
  const std::string end = reader.word();
  if (end != "gone" && end != "stays" && end != "reach") {
    reader.record.refuse("'" + end + "' is not 'gone', 'stays' or 'reach', one of which follows the time of 'until'");
  }
  thing.end = end == "gone" ? ThingEnd::kGone : end == "stays" ? ThingEnd::kStays : ThingEnd::kReach;
}

void read_plan(const Record& record, const std::string& file, Thing& thing) {
  const std::string path = (std::filesystem::path(record.file).parent_path() / file).string();
  Plan plan;
  try {
    plan = parse_plan(read_file(path), path);
  } catch (const InputError& error) {
    record.refuse("the plan of track '" + thing.name + "': " + error.what());
  }
  for (const Segment& segment : plan.segments) {
    thing.pieces.push_back({segment.points, segment.duration});
    for (Point& point : thing.pieces.back().points) point = point + plan.origin;
  }
}

void read_word(Reader& reader, Thing& thing) {
  const std::string word = reader.of = reader.word();
  if (word == "at") {
    thing.position = reader.point();
  } else if (word == "velocity") {
    thing.velocity = reader.point();
  } else if (word == "error") {
    thing.error = reader.size();
    thing.error_speed = reader.size();
    thing.error_growth = reader.size();
  } else if (word == "reach") {
    thing.reach = reader.size();
  } else if (word == "from") {
    thing.from = whole_nanoseconds(reader.number());
    thing.has_from = true;
  } else if (word == "until") {
    read_end(reader, thing);
  } else if (word == "plan") {
    read_plan(reader.record, reader.word(), thing);
  } else {
    reader.record.refuse("unknown word '" + word + "'");
  }
}

Thing track_from(const Record& record) {
  Reader reader{record};
  Thing thing;
  thing.name = reader.word();
  read_shape(reader, thing);
  while (!reader.empty()) read_word(reader, thing);
  return thing;
}

void add_piece(const Record& record, std::vector<Thing>& things) {
  Reader reader{record};
  const std::string name = reader.word();
  TimedCurve piece{{}, reader.number()};
  if (!(piece.duration > 0)) record.refuse("a piece must last longer than 0");
  while (!reader.empty()) piece.points.push_back(reader.point());
  if (piece.points.size() != 8) record.refuse("a piece has eight control points");
  for (Thing& thing : things) {
    if (thing.name == name) return thing.pieces.push_back(piece);
  }
  record.refuse("there is no track '" + name + "'");
}

Thing keep_out_from(const Record& record, std::size_t number) {
  Record box = record;
  const std::string zone = take_zone(box);
  const Window window = *take_window(box);
  const Box lies = box_from(record, box.numbers(1, 6));
  Thing thing;
  thing.name = with_zone("keepout " + std::to_string(number), zone);
  thing.shape = ThingShape::kBox;
  thing.position = Rational(1) / 2 * (lies.lower + lies.upper);
  thing.half = Rational(1) / 2 * (lies.upper - lies.lower);
  thing.from = window.from - window.clock_error;
  thing.has_from = true;
  thing.until = window.until + window.clock_error;
  thing.end = ThingEnd::kGone;
  return thing;
}

bool has_window(const Record& record) {
  Record box = record;
  take_zone(box);  // the name may have the word, too
  return take_window(box).has_value();
}

}  // namespace

bool is_track_record(const Record& record) {
  return record.key() == "track" || record.key() == "track_piece" || (record.key() == "keepout" && has_window(record));
}

void add_track_record(const Record& record, std::size_t keepouts, std::vector<Thing>& things) {
  if (record.key() == "track_piece") return add_piece(record, things);
  things.push_back(record.key() == "track" ? track_from(record) : keep_out_from(record, keepouts));
}

}  // namespace tern_verify
