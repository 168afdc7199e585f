// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_replay.hpp"

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "host/flight/flight_events.hpp"
#include "record/envelope.hpp"
#include "record/fences.hpp"
#include "record/flight_fields.hpp"
#include "record/tracks.hpp"
#include "tern/flight_record.hpp"

namespace tern_host {
namespace {

using tern::FlightEventKind;
using tern::Status;

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

class Player {
 public:
  Player(const std::string& bytes, const OnTick& on_tick)
      : events_(bytes), on_tick_(on_tick), planner_(workspace_.get(), sizeof *workspace_) {
    result_.configuration = events_.configuration();
  }

  FlightReplay play() {
    FlightEvent event;
    while (!stopped_ && events_.next(event)) {
      const Status answer = perform(event);
      // A flight that went another way may refuse what it took, unread: from there on it cannot be flown again.
      if (answer != event.answer) stop(event, answer);
      if (!stopped_) events_.require_end(event);
    }
    return result_;
  }

 private:
  Status perform(FlightEvent& event) {
    switch (event.kind) {
      case FlightEventKind::kBind:
        return bind(event);
      case FlightEventKind::kAssumeFree:
      case FlightEventKind::kAssumeColumn:
      case FlightEventKind::kMarkBox:
      case FlightEventKind::kMarkCylinder:
      case FlightEventKind::kMarkPoints:
        return mark(event);
      case FlightEventKind::kFrame:
        return frame(event);
      case FlightEventKind::kScan:
      case FlightEventKind::kBeams:
        return scan(event);
      case FlightEventKind::kFollow:
        return map_.follow(read<tern::Vec3>(event));
      case FlightEventKind::kStep:
        return map_.step(static_cast<std::uint32_t>(event.words.word()));
      case FlightEventKind::kStart:
        return start(event);
      case FlightEventKind::kGoal:
        goal_ = read<tern::Vec3>(event);
        return flight_.set_goal(goal_);
      case FlightEventKind::kMission:
        return set_mission(event);
      case FlightEventKind::kYaw:
        return set_yaw(event);
      case FlightEventKind::kStop:
        return flight_.stop();
      case FlightEventKind::kTick:
        return tick(event);
      case FlightEventKind::kClock:
        return set_clock(event);
      case FlightEventKind::kLand:
        return land(event);
      case FlightEventKind::kPosition:
        return note_position(event);
      case FlightEventKind::kTrack:
        return update_track(event);
      case FlightEventKind::kForgetTrack:
        return flight_.forget_track(read<std::uint32_t>(event));
      case FlightEventKind::kAnswer:
        return answer(event);
      case FlightEventKind::kClearance:
        return flight_.set_clearance(read<std::int64_t>(event));
    }
    return Status::kRecordDamaged;
  }

  template <typename Value>
  static Value read(FlightEvent& event) {
    Value value{};
    event.words(value);
    return value;
  }

  Status bind(FlightEvent& event) {
    if (map_.bound()) events_.refuse(event, "is a second one");
    tern::MapSpec& spec = map_spec_;
    list_map_spec(event.words, spec);
    prior_.resize(events_.count(event, tern::kMaxPriorBoxes));
    for (tern::Box& box : prior_) list_box(event.words, box);
    spec.prior = prior_.data();
    spec.prior_count = static_cast<std::int32_t>(prior_.size());
    prior_cylinders_.resize(events_.count(event, tern::kMaxPriorBoxes));
    for (tern::Cylinder& cylinder : prior_cylinders_) list_cylinder(event.words, cylinder);
    spec.prior_cylinders = prior_cylinders_.data();
    spec.prior_cylinder_count = static_cast<std::int32_t>(prior_cylinders_.size());
    map_words_.resize(tern::map_words(spec));
    return map_.bind(spec, map_words_.data(), map_words_.size());
  }

  Status mark(FlightEvent& event) {
    if (event.kind == FlightEventKind::kMarkPoints) {
      const std::vector<tern::Vec3> points = events_.points(event);
      return map_.mark_points(points.data(), points.size());
    }
    if (event.kind == FlightEventKind::kMarkBox) {
      tern::Box box{};
      list_box(event.words, box);
      return map_.mark_box(box);
    }
    if (event.kind == FlightEventKind::kMarkCylinder) {
      tern::Cylinder cylinder{};
      list_cylinder(event.words, cylinder);
      return map_.mark_cylinder(cylinder);
    }
    if (event.kind == FlightEventKind::kAssumeColumn) {
      tern::Cylinder column{};
      list_cylinder(event.words, column);
      return map_.assume_column(column);
    }
    const tern::Vec3 center = read<tern::Vec3>(event);
    return map_.assume_free(center, read<double>(event));
  }

  Status frame(FlightEvent& event) {
    // The map reads pixels and points until its job is done.
    if (map_.busy()) return Status::kInvalidArgument;
    const auto t = read<std::int64_t>(event);
    tern::Pose pose{};
    list_pose(event.words, pose);
    ++result_.frames;
    return map_.begin_frame(events_.view(event, pixels_), pose, t);
  }

  Status scan(FlightEvent& event) {
    if (map_.busy()) return Status::kInvalidArgument;
    const auto t = read<std::int64_t>(event);
    const tern::Vec3 origin = read<tern::Vec3>(event);
    ++result_.frames;
    if (event.kind == FlightEventKind::kBeams)
      return map_.begin_scan(events_.beams(event, points_, pixels_.floats), origin, t);
    points_ = events_.points(event);
    return map_.begin_scan(points_.data(), points_.size(), origin, t);
  }

  Status start(FlightEvent& event) {
    if (!fences_.empty() || !words_.empty()) events_.refuse(event, "is a second one");
    const tern::Vec3 position = read<tern::Vec3>(event);
    const auto t = read<std::int64_t>(event);
    tern::FlightSpec& spec = spec_;
    list_flight_spec(event.words, spec);
    fences_.resize(tern::kMaxFences);
    planes_.resize(tern::kMaxFencePlanes);
    if (tern::read_fences(event.words, fences_.data(), planes_.data(), spec.fence_count) != Status::kOk) {
      events_.refuse(event, "has a count that is out of range");
    }
    spec.fences = fences_.data();
    if (!map_.bound()) return Status::kInvalidArgument;
    words_.resize(tern::flight_words(map_.safe().spec().dims));
    return flight_.start(spec, map_, planner_, words_.data(), words_.size(), position, t);
  }

  Status set_mission(FlightEvent& event) {
    const auto policy = read<tern::ViaPolicy>(event);
    std::vector<tern::Via> points(events_.count(event, tern::kMaxMissionPoints));
    for (tern::Via& point : points) list_via(event.words, point);
    if (!points.empty()) goal_ = points.back().position;
    return flight_.set_mission(points.data(), static_cast<std::int32_t>(points.size()), policy);
  }

  Status set_yaw(FlightEvent& event) {
    tern::FlightYaw yaw{};
    list_flight_yaw(event.words, yaw);
    std::vector<tern::Heading> headings(events_.count(event, tern::kMaxMissionPoints));
    for (tern::Heading& heading : headings) list_heading(event.words, heading);
    yaw.headings = headings.data();
    yaw.heading_count = static_cast<std::int32_t>(headings.size());
    return flight_.set_yaw(yaw);
  }

  Status land(FlightEvent& event) {
    goal_ = read<tern::Vec3>(event);
    const auto ground = read<double>(event);
    return flight_.land(goal_, ground, read<double>(event));
  }

  Status note_position(FlightEvent& event) {
    const tern::Vec3 position = read<tern::Vec3>(event);
    return flight_.note_position(position, read<std::int64_t>(event));
  }

  Status update_track(FlightEvent& event) {
    tern::Track track;
    track_pieces_.resize(tern::kMaxTrackPieces);
    if (tern::read_track(event.words, track_pieces_.data(), tern::kMaxTrackPieces, track) != Status::kOk) {
      events_.refuse(event, "has a count that is out of range");
    }
    return flight_.update_track(track);
  }

  Status answer(FlightEvent& event) {
    const auto number = read<std::uint32_t>(event);
    return flight_.answer(number, read<bool>(event));
  }

  /// What was flown until then took as long as the ticks say.
  Status set_clock(FlightEvent& event) {
    const auto t = read<std::int64_t>(event);
    earlier_ = result_.seconds;
    first_ = t;
    return flight_.set_clock(t);
  }

  Status tick(FlightEvent& event) {
    const auto t = read<std::int64_t>(event);
    const std::uint64_t recorded = event.words.word();
    tern::FlightReport report{};
    const Status answer = flight_.tick(t, report);
    const tern::Command command = flight_.command(t);
    if (result_.ticks == 0) first_ = t;
    result_.seconds =
        earlier_ + 1e-9 * static_cast<double>(static_cast<std::uint64_t>(t) - static_cast<std::uint64_t>(first_));
    if (tern::TickHash(command, flight_.yaw(t), report).value() != recorded) note_difference();
    if (static_cast<std::uint64_t>(result_.ticks) % tern::kWholeCommandTicks == 0) {
      tern::Command whole{};
      list_command(event.words, whole);
      if (result_.different_ticks > 0) note_distance(whole, command);
    }
    ++result_.ticks;
    if (on_tick_ && answer == Status::kOk)
      on_tick_({t, report, command, map_spec_, spec_, goal_, map_, flight_, planner_, state()});
    return answer;
  }

  /// A flight's state lies in the first of its words.
  const tern::FlightState& state() const { return *reinterpret_cast<const tern::FlightState*>(words_.data()); }

  void note_difference() {
    if (result_.different_ticks++ > 0) return;
    result_.difference = "tick " + std::to_string(result_.ticks) + ", " + text("%.3f s", result_.seconds) +
                         " after the first, is the first that differs";
  }

  /// How far the first whole command after the difference is off.
  void note_distance(const tern::Command& recorded, const tern::Command& now) {
    if (told_distance_) return;
    told_distance_ = true;
    const tern::Vec3& a = recorded.sample.position;
    const tern::Vec3& b = now.sample.position;
    result_.difference += "; in tick " + std::to_string(result_.ticks) + " the position is " +
                          text("%.3g m off", std::hypot(a.x - b.x, a.y - b.y, a.z - b.z));
  }

  void stop(const FlightEvent& event, Status answer) {
    stopped_ = true;
    if (!result_.difference.empty()) return;
    result_.difference = std::string(event_name(event.kind)) + " after tick " + std::to_string(result_.ticks) +
                         " answered " + tern::status_name(event.answer) + ", now " + tern::status_name(answer);
  }

  FlightEvents events_;
  const OnTick& on_tick_;
  std::unique_ptr<tern::Workspace> workspace_ = std::make_unique<tern::Workspace>();
  tern::Planner planner_;
  tern::RollingMap map_;
  tern::Flight flight_;
  std::vector<std::uint64_t> map_words_, words_;
  tern::MapSpec map_spec_{};
  tern::FlightSpec spec_{};
  tern::Vec3 goal_{};
  std::vector<tern::Box> prior_;
  std::vector<tern::Cylinder> prior_cylinders_;
  std::vector<tern::Fence> fences_;
  std::vector<tern::Halfspace> planes_;
  std::vector<tern::TrackPiece> track_pieces_;
  DepthPixels pixels_;
  std::vector<tern::Vec3> points_;
  FlightReplay result_;
  std::int64_t first_ = 0;  ///< time of the first tick, or what the clock was set to last
  double earlier_ = 0.0;    ///< seconds until then
  bool told_distance_ = false;
  bool stopped_ = false;
};

}  // namespace

bool is_flight_record(const std::string& bytes) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return tern::record_kind(data, bytes.size()) == static_cast<std::uint64_t>(tern::RecordKind::kFlight);
}

FlightReplay replay_flight(const std::string& bytes, const OnTick& on_tick) {
  return Player(bytes, on_tick).play();
}

}  // namespace tern_host
