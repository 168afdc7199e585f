// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstring>

#include "capacity/hop.hpp"
#include "capacity/subject.hpp"
#include "support/owned_map.hpp"
#include "support/world.hpp"
#include "support/yaw_case.hpp"
#include "tern/flight.hpp"
#include "tern/flight_record.hpp"
#include "tern/proof.hpp"
#include "tern/record.hpp"

namespace tern_capacity {
namespace {

using tern::Status;

std::string bits_of(const void* data, std::size_t bytes) {
  return std::string(static_cast<const char*>(data), bytes);
}

tern::MapSpec small_map() {
  tern::MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 16, 16}, 0.2);
  spec.pixels = 2048;
  return spec;
}

class MapSubject : public Subject {
 public:
  Outcome run() override {
    const tern::MapSpec spec = small_map();
    std::vector<std::uint64_t> words(100000);
    tern::RollingMap map;
    const Status status = map.bind(spec, words.data(), words.size());
    return {status, "", (status == Status::kOk) == map.bound() ? "" : "bound though refused"};
  }
};

/// A frame that is refused leaves the map as it was.
class FrameSubject : public Subject {
 public:
  FrameSubject() : map_(small_map()), image_(32, 24, 16.0) {
    for (float& z : image_.z) z = 2.0f;
  }
  Outcome run() override {
    const tern::Pose pose{{0.5, 0.8, 0.8}, {0.5, -0.5, 0.5, -0.5}};
    const std::string before = grid();
    Status status = map_.map.begin_frame(image_.view, pose, time_ += 1000);
    if (status != Status::kRunning) {
      return {status, "", map_.map.busy() || grid() != before ? "a frame that was refused left something" : ""};
    }
    for (int k = 0; k < 100000 && status == Status::kRunning; ++k) status = map_.map.step(64);
    return {status, "", ""};
  }

 private:
  std::string grid() const {
    std::string bits;
    for (int z = 0; z < 16; ++z) {
      for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 64; ++x) bits += map_.map.safe().obstacle({x, y, z}) ? '1' : '0';
      }
    }
    return bits;
  }

  tern_test::OwnedMap map_;
  tern_test::Image image_;
  std::int64_t time_ = 0;
};

/// A yaw plan has fewer pieces or fewer iterations, and is within the limits all the same.
class YawSubject : public Subject {
 public:
  Outcome run() override {
    tern_test::Random random(5);
    const tern::Trajectory plan = tern_test::tangle(random);
    tern::YawRequest request = tern::yaw_request({1.0, 0.0}, 2.0, 8.0);
    request.mode = tern::YawMode::kAlongMotion;
    tern::YawPlan yaw{};
    const Status status = planner_.plan(plan, request, yaw);
    std::string wrong;
    for (double t = 0.0; status == Status::kOk && t < tern::duration(yaw); t += 0.01) {
      const tern::YawSample sample = tern::evaluate(yaw, t);
      if (std::fabs(sample.yaw.rate) > 2.0 + 1e-9) wrong = "too fast";
      if (std::fabs(sample.acceleration) > 8.0 + 1e-9) wrong = "too sharp";
    }
    return {status, bits_of(yaw.points, sizeof yaw.points), wrong};
  }

 private:
  tern::YawPlanner planner_;
};

tern_test::World recorded_world() {
  tern_test::World world({32, 20, 8}, 0.1, 0.2);
  world.block({1.4, 0.0, 0.0}, {1.5, 0.4, 0.8}).from({0.55, 0.55, 0.45}).to({2.65, 0.55, 0.45});
  return world;
}

/// Whether it is written or not, the bytes used stay within the room.
class RecordSubject : public Subject {
 public:
  RecordSubject() : world_(recorded_world()) {
    world_.plan();
    planes_[0] = {{1.0, 0.0, 0.0}, 9.0};
    fence_ = {planes_, 1, tern::FenceKind::kKeepIn};
    world_.request.fences = &fence_;
    world_.request.fence_count = 1;
    via_.position = {1.0, 1.0, 0.4};
    world_.request.vias = &via_;
    world_.request.via_count = 1;
  }
  Outcome run() override {
    std::vector<std::uint8_t> bytes(tern::plan_record_bytes(world_.spec.dims));
    constexpr std::size_t kUntouched = 12345;
    std::size_t used = kUntouched;
    Status status = tern::record_plan(world_.grid, world_.request, world_.report.status, world_.trajectory,
                                      bytes.data(), bytes.size(), &used);
    if (status != Status::kOk) return {status, "", used == kUntouched ? "" : "a number of bytes that are none"};
    const auto record = std::make_unique<tern::PlanRecord>();
    std::vector<std::uint64_t> words(world_.words.size());
    tern::Grid grid;
    status = tern::read_plan_record(bytes.data(), used, *record, grid, words.data(), words.size());
    return {status, bits_of(bytes.data(), used), ""};
  }

 private:
  tern_test::World world_;
  tern::Halfspace planes_[1];
  tern::Fence fence_;
  tern::Via via_{};
};

/// After it was full once, a flight's record takes nothing more, and can be closed.
class FlightRecordSubject : public Subject {
 public:
  FlightRecordSubject() : map_(small_map()) {}
  Outcome run() override {
    std::vector<std::uint8_t> bytes(4096);
    tern::FlightRecorder recorder;
    Status status = recorder.begin(bytes.data(), bytes.size());
    if (status != Status::kOk) return {status, "", ""};
    std::string wrong;
    const auto note = [&](Status answer) {
      if (status == Status::kRecordFull && answer != Status::kRecordFull) wrong = "it goes on with a gap";
      if (status == Status::kOk) status = answer;
    };
    note(recorder.bind(small_map(), Status::kOk));
    for (int k = 0; k < 4; ++k) note(recorder.assume_free({1.0, 1.0, 1.0}, 0.5, Status::kOk));
    std::size_t used = 0;
    const Status closed = recorder.close(&used);
    if (closed != Status::kOk && closed != Status::kRecordFull) wrong = "it cannot be closed";
    return {status == Status::kOk ? closed : status, closed == Status::kOk ? bits_of(bytes.data(), used) : "", wrong};
  }

 private:
  tern_test::OwnedMap map_;
};

class MissionSubject : public Subject {
 public:
  MissionSubject() : map_(small_map()), memory_(new tern::Workspace), planner_(memory_.get(), sizeof *memory_) {
    map_.map.assume_free({3.2, 0.8, 0.8}, 10.0);
    words_.resize(tern::flight_words(small_map().dims));
    tern::FlightSpec spec = tern::flight_spec({{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}});
    spec.horizon = 3.0;
    started_ = flight_.start(spec, map_.map, planner_, words_.data(), words_.size(), {1.0, 0.8, 0.8}, 0);
  }
  Outcome run() override {
    tern::Via points[2] = {};
    points[0].position = {2.0, 0.8, 0.8};
    points[1].position = {3.0, 0.8, 0.8};
    const Status status = flight_.set_mission(points, 2, tern::ViaPolicy::kEnd);
    return {status, "", started_ == Status::kOk ? "" : "the flight did not start"};
  }

 private:
  tern_test::OwnedMap map_;
  std::unique_ptr<tern::Workspace> memory_;
  tern::Planner planner_;
  std::vector<std::uint64_t> words_;
  tern::Flight flight_;
  Status started_;
};

/// A proof that ends early proves less, never more.
class ProofSubject : public Subject {
 public:
  ProofSubject() : world_(recorded_world()), planned_(world_.plan()) {}
  Outcome run() override {
    const double until = tern::clear_until(world_.grid, world_.trajectory, 0.0, &world_.request.limits);
    const bool wrong = !(until >= 0.0 && until <= tern::duration(world_.trajectory));
    return {planned_, bits_of(&until, sizeof until), wrong ? "more is proven than there is" : ""};
  }

 private:
  tern_test::World world_;
  Status planned_;
};

/// Another vehicle's plan as a track, and a proof beside it.
class TrackSubject : public Subject {
 public:
  TrackSubject() : world_(recorded_world()), planned_(world_.plan()) {}
  Outcome run() override {
    tern::TrackPiece pieces[tern::kMaxTrackPieces];
    tern::Track track;
    tern::Trajectory other = world_.trajectory;
    other.count = 2;
    other.origin.y += 0.7;
    const Status status = tern::track_of(other, 0.2, pieces, tern::kMaxTrackPieces, track);
    if (status != Status::kOk) return {status, "", track.pieces == nullptr ? "" : "written though refused"};
    tern::TrackGrounds grounds;
    grounds.tracks = &track;
    grounds.count = 1;
    grounds.radius = 0.2;
    tern::Halfspace planes[tern::kBoxPlanes];
    const tern::Vec3& at = world_.request.goal.position;
    tern::box_planes({{at.x - 0.1, at.y - 0.1, at.z - 0.1}, {at.x + 0.1, at.y + 0.1, at.z + 0.1}}, planes);
    const tern::Fence fence{planes, tern::kBoxPlanes, tern::FenceKind::kKeepOut, 0, std::int64_t{1} << 40};
    grounds.fences = &fence;
    grounds.fence_count = 1;
    tern::TrackProof proof;
    const Status begun = proof.begin(world_.trajectory, 0.0, grounds);
    if (begun != Status::kRunning) return {begun, "", ""};
    const double until = tern::clear_until(world_.trajectory, 0.0, grounds);
    const bool wrong = !(until >= 0.0 && until <= tern::duration(world_.trajectory) + 1e-9);
    return {planned_, bits_of(&until, sizeof until), wrong ? "more is proven than there is" : ""};
  }

 private:
  tern_test::World world_;
  Status planned_;
};

class FlightSubject : public Subject {
 public:
  explicit FlightSubject(Surprise surprise) : surprise_(surprise) {}
  Outcome run() override {
    Hop hop(surprise_);
    if (hop.started() != Status::kOk) return {hop.started(), "", ""};
    const std::string wrong = hop.fly();
    const std::uint64_t hash = hop.commands_hash();
    return {Status::kOk, bits_of(&hash, sizeof hash), wrong};
  }

 private:
  Surprise surprise_;
};

}  // namespace

std::vector<std::unique_ptr<Subject>> flight_subjects() {
  std::vector<std::unique_ptr<Subject>> subjects;
  for (const Surprise surprise : {Surprise::kNone, Surprise::kNear}) {
    subjects.push_back(std::make_unique<FlightSubject>(surprise));
  }
  return subjects;
}

std::vector<std::unique_ptr<Subject>> other_subjects() {
  std::vector<std::unique_ptr<Subject>> subjects;
  subjects.push_back(std::make_unique<MapSubject>());
  subjects.push_back(std::make_unique<FrameSubject>());
  subjects.push_back(std::make_unique<YawSubject>());
  subjects.push_back(std::make_unique<RecordSubject>());
  subjects.push_back(std::make_unique<FlightRecordSubject>());
  subjects.push_back(std::make_unique<MissionSubject>());
  subjects.push_back(std::make_unique<ProofSubject>());
  subjects.push_back(std::make_unique<TrackSubject>());
  subjects.push_back(fleet_subject());
  return subjects;
}

}  // namespace tern_capacity
