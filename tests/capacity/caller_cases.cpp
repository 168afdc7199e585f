// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Capacities of what the caller gives: grids, requests, maps, yaws and memory.
#include <memory>

#include "base/math.hpp"
#include "capacity/cases.hpp"
#include "support/owned_map.hpp"
#include "support/world.hpp"
#include "support/yaw_case.hpp"
#include "tern/fleet.hpp"
#include "tern/flight.hpp"
#include "tern/flight_record.hpp"
#include "tern/record.hpp"

namespace tern_capacity {
namespace {

using tern::Status;
using tern::Vec3;
using tern_test::World;

// ---- grids

Status bind_grid(const tern::Voxel& dims, tern::Field expected) {
  std::vector<std::uint64_t> words(100000);
  tern::GridSpec spec{};
  spec.cell = 0.1;
  spec.dims = dims;
  spec.boundary = {{0.0, 0.0, 0.0}, {0.1 * dims.x, 0.1 * dims.y, 0.1 * dims.z}};
  tern::Field field = tern::Field::kNone;
  tern::Grid grid;
  const Status status = grid.bind(spec, words.data(), words.size(), &field);
  return field == expected ? status : kNotThis;
}

Exceeded grid_capacity(const char* name, const tern::Voxel& most, const tern::Voxel& more) {
  return {name, Status::kInvalidArgument, [=] { return bind_grid(most, tern::Field::kNone) == Status::kOk; },
          [=] { return bind_grid(more, tern::Field::kDimensions); }};
}

std::vector<Exceeded> grid_capacities() {
  static_assert(tern::kMaxCells == 32 * 32 * 32 && tern::kMaxDimension == 64, "each is reached without the other");
  return {grid_capacity("TERN_MAX_CELLS", {32, 32, 32}, {33, 32, 32}),
          grid_capacity("TERN_MAX_DIMENSION", {64, 4, 4}, {65, 4, 4})};
}

// ---- what a request has

Status plan_with_fences(int fences, int planes) {
  World world({16, 16, 8}, 0.1, 0.0);
  world.from({0.25, 0.25, 0.25}).to({0.85, 0.85, 0.45});
  const std::vector<tern::Halfspace> faces(static_cast<std::size_t>(planes), {{1.0, 0.0, 0.0}, 1.5});
  const tern::Fence one{faces.data(), planes, tern::FenceKind::kKeepIn};
  const std::vector<tern::Fence> list(static_cast<std::size_t>(fences), one);
  world.request.fences = list.data();
  world.request.fence_count = fences;
  const Status status = world.plan();
  return status == Status::kOk || world.report.field == tern::Field::kFences ? status : kNotThis;
}

/// A grid of so many words, a word a row, with a fence.
Status plan_on_words(int rows) {
  World world({1, 64, rows / 64}, 0.1, 0.0);
  world.from({0.05, 0.25, 0.25}).to({0.05, 0.85, 0.45});
  const tern::Halfspace far{{0.0, 1.0, 0.0}, 5.0};
  const tern::Fence fence{&far, 1, tern::FenceKind::kKeepIn};
  world.request.fences = &fence;
  world.request.fence_count = 1;
  const Status status = world.plan();
  return status == Status::kOk || world.report.field == tern::Field::kFences ? status : kNotThis;
}

Status plan_with_vias(int count) {
  World world = tern_test::open_world();
  std::vector<tern::Via> vias(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    vias[static_cast<std::size_t>(k)].position = world.request.start.position + Vec3{0.5 * (k + 1), 0.1, 0.0};
  }
  world.request.vias = vias.data();
  world.request.via_count = count;
  const Status status = world.plan();
  return status == Status::kOk || world.report.field == tern::Field::kVias ? status : kNotThis;
}

Status plan_among(int count, int pieces) {
  World world = tern_test::open_world();
  const std::vector<tern::TrackPiece> rest(static_cast<std::size_t>(pieces) + 1, tern::TrackPiece{1.0, {}});
  std::vector<tern::Track> tracks(static_cast<std::size_t>(count));
  tracks[0].pieces = rest.data();
  tracks[0].piece_count = pieces;
  world.request.tracks = tracks.data();
  world.request.track_count = count;
  const Status status = world.plan();
  return status == Status::kOk || world.report.field == tern::Field::kTracks ? status : kNotThis;
}

/// Walls across the way, which each segment comes near.
Status plan_across(int count) {
  World world = tern_test::open_world();
  tern::Track wall;
  wall.position = 0.5 * (world.request.start.position + world.request.goal.position);
  wall.shape = tern::TrackShape::kBox;
  wall.half = {1.0, 50.0, 50.0};
  const std::vector<tern::Track> tracks(static_cast<std::size_t>(count), wall);
  world.request.tracks = tracks.data();
  world.request.track_count = count;
  return world.plan();
}

/// A fleet of so many other members.
Status meet(int count) {
  tern::FleetSpec spec;
  spec.incarnation = 1;
  spec.radius = 0.5;
  spec.tick = 1;
  static tern::Fleet fleet;
  Status status = fleet.begin(spec, tern_test::hover(1.0), 0);
  for (int id = 1; id <= count && status == Status::kOk; ++id) status = fleet.add(static_cast<std::uint16_t>(id), 0);
  return status;
}

/// A wall across the way for good, in an empty grid of so many voxels.
Status plan_through(const tern::Voxel& dims, std::uint32_t budget = tern::Budget{}.tracks) {
  World world(dims, 0.1, 0.0);
  world.from({0.05, 0.05, 0.45}).to({0.1 * dims.x - 0.05, 0.1 * dims.y - 0.05, 0.45});
  tern::Track wall;
  wall.position = 0.5 * (world.request.start.position + world.request.goal.position);
  wall.shape = tern::TrackShape::kBox;
  wall.half = {0.01, 50.0, 50.0};
  world.request.tracks = &wall;
  world.request.track_count = 1;
  world.request.budget.tracks = budget;
  return world.plan();
}

std::vector<Exceeded> request_capacities() {
  return {
      {"TERN_MAX_FENCES", Status::kFencesFull, [] { return plan_with_fences(tern::kMaxFences, 1) == Status::kOk; },
       [] { return plan_with_fences(tern::kMaxFences + 1, 1); }},
      {"TERN_MAX_FENCE_PLANES", Status::kFencePlanesFull,
       [] { return plan_with_fences(1, tern::kMaxFencePlanes) != Status::kFencePlanesFull; },
       [] { return plan_with_fences(1, tern::kMaxFencePlanes + 1); }},
      {"TERN_MAX_WORLD_WORDS", Status::kWorldFull, [] { return plan_on_words(tern::kMaxWorldWords) == Status::kOk; },
       [] { return plan_on_words(tern::kMaxWorldWords + 64); }},
      {"TERN_MAX_TRACKS", Status::kTracksFull, [] { return plan_among(tern::kMaxTracks, 0) == Status::kOk; },
       [] { return plan_among(tern::kMaxTracks + 1, 0); }},
      {"TERN_MAX_TRACK_PIECES", Status::kTrackPiecesFull,
       [] { return plan_among(1, tern::kMaxTrackPieces) == Status::kOk; },
       [] { return plan_among(1, tern::kMaxTrackPieces + 1); }},
      {"TERN_MAX_NEIGHBOURS", Status::kNeighboursFull, [] { return meet(tern::kMaxNeighbours) == Status::kOk; },
       [] { return meet(tern::kMaxNeighbours + 1); }},
      {"TERN_MAX_SEPARATIONS", Status::kSeparationsFull, [] { return plan_across(1) == Status::kNoClearTime; },
       [] { return plan_across(tern::kMaxTracks); }},
      {"TERN_MAX_FLOOD_WORDS", Status::kFloodFull,
       [] {
         return plan_through({32, 8, 8}) == Status::kNoClearTime;
       },
       [] {
         return plan_through({64, 64, 8});
       }},
      {"Budget::tracks", Status::kBudgetTracks,
       [] {
         return plan_through({32, 8, 8}, 1000000) == Status::kNoClearTime;
       },
       [] {
         return plan_through({32, 8, 8}, 1);
       }},
      {"TERN_MAX_VIAS", Status::kViasFull, [] { return plan_with_vias(tern::kMaxVias) == Status::kOk; },
       [] { return plan_with_vias(tern::kMaxVias + 1); }}};
}

// ---- maps and yaws

tern::MapSpec map_spec(std::int32_t pixels) {
  tern::MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 8, 8}, 0.1);
  spec.pixels = pixels;
  return spec;
}

Status bind_map(const tern::MapSpec& spec, tern::Field expected) {
  std::vector<std::uint64_t> words(200000);
  tern::RollingMap map;
  tern::Field field = tern::Field::kNone;
  const Status status = map.bind(spec, words.data(), words.size(), &field);
  return field == expected ? status : kNotThis;
}

Status bind_map_with_prior(int count, tern::Field expected) {
  const std::vector<tern::Box> boxes(static_cast<std::size_t>(count), {{0.0, 0.0, 0.0}, {1.0, 0.5, 0.5}});
  tern::MapSpec spec = map_spec(tern::kMaxPixels);
  spec.prior = boxes.data();
  spec.prior_count = count;
  return bind_map(spec, expected);
}

/// An image of so many pixels in a map that takes 256.
Status enter_image(int pixels) {
  tern_test::OwnedMap owned(map_spec(256));
  const tern_test::Image image(16, pixels / 16, 8.0);
  return owned.map.begin_frame(image.view, {{0.5, 0.4, 0.4}, {0.5, -0.5, 0.5, -0.5}}, 1000);
}

/// True where the pieces of a hover's yaw plan last a tenth of a second at most.
bool has_short_pieces(double seconds) {
  static tern::YawPlanner planner;
  tern::YawPlan plan{};
  tern::YawRequest request = tern::yaw_request({1.0, 0.0}, 50.0, 1000.0);
  request.mode = tern::YawMode::kFixed;
  request.heading = {0.0, 1.0};
  const Status status = planner.plan(tern_test::hover(seconds), request, plan);
  return status == Status::kOk && plan.step <= 0.1 && plan.count <= tern::kMaxYawPieces;
}

std::vector<Exceeded> map_capacities() {
  return {{"TERN_MAX_PIXELS", Status::kPixelsFull,
           [] { return bind_map(map_spec(tern::kMaxPixels), tern::Field::kNone) == Status::kOk; },
           [] { return bind_map(map_spec(tern::kMaxPixels + 1), tern::Field::kPixels); }},
          {"MapSpec::pixels", Status::kPixelsFull, [] { return enter_image(256) == Status::kRunning; },
           [] { return enter_image(272); }},
          {"TERN_MAX_PRIOR_BOXES", Status::kPriorFull,
           [] { return bind_map_with_prior(tern::kMaxPriorBoxes, tern::Field::kNone) == Status::kOk; },
           [] { return bind_map_with_prior(tern::kMaxPriorBoxes + 1, tern::Field::kPrior); }},
          {"TERN_MAX_YAW_PIECES", Status::kOk, [] { return has_short_pieces(0.5); },
           [] { return has_short_pieces(60.0) ? kNotThis : Status::kOk; }}};
}

// ---- memory that the caller gives

Status plan_in(std::size_t bytes) {
  World world = tern_test::open_world();
  world.grid.inflate();
  tern::Planner planner(world.memory.get(), bytes);
  const Status status = planner.plan(world.grid, world.request, world.trajectory, world.report);
  return status == Status::kOk || world.report.field == tern::Field::kWorkspace ? status : kNotThis;
}

Status bind_with_words(std::size_t count) {
  const World world = tern_test::open_world();
  std::vector<std::uint64_t> words(count);
  tern::Field field = tern::Field::kNone;
  tern::Grid grid;
  const Status status = grid.bind(world.spec, words.data(), count, &field);
  return status == Status::kOk || field == tern::Field::kStorage ? status : kNotThis;
}

Status bind_map_with_words(std::size_t count) {
  std::vector<std::uint64_t> words(count);
  tern::Field field = tern::Field::kNone;
  tern::RollingMap map;
  const Status status = map.bind(map_spec(256), words.data(), count, &field);
  return status == Status::kOk || field == tern::Field::kStorage ? status : kNotThis;
}

struct Started {
  tern_test::OwnedMap owned{map_spec(256)};
  std::unique_ptr<tern::Workspace> memory{new tern::Workspace};
  tern::Planner planner{memory.get(), sizeof *memory};
  std::vector<std::uint64_t> words;
  tern::Flight flight;
  Status status;

  explicit Started(std::size_t count) : words(count) {
    owned.map.assume_free({3.2, 0.4, 0.4}, 10.0);
    tern::FlightSpec spec = tern::flight_spec({{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}});
    spec.horizon = 3.0;
    status = flight.start(spec, owned.map, planner, words.data(), count, {1.0, 0.4, 0.4}, 0);
  }
};

Status set_mission(int count) {
  Started started(tern::flight_words(map_spec(256).dims));
  std::vector<tern::Via> points(static_cast<std::size_t>(count));
  for (tern::Via& point : points) point.position = {2.0, 0.4, 0.4};
  return started.flight.set_mission(points.data(), count, tern::ViaPolicy::kEnd);
}

/// Records a plan in as much room as it takes, and in so many bytes less.
Status record(std::size_t less) {
  World world = tern_test::open_world();
  world.plan();
  std::vector<std::uint8_t> bytes(tern::plan_record_bytes(world.spec.dims));
  std::size_t used = 0;
  const auto write = [&](std::size_t room) {
    return tern::record_plan(world.grid, world.request, world.report.status, world.trajectory, bytes.data(), room,
                             &used);
  };
  if (write(bytes.size()) != Status::kOk) return kNotThis;
  return write(used - less);
}

Status begin_flight_record(std::size_t room) {
  std::vector<std::uint8_t> bytes(room);
  tern::FlightRecorder recorder;
  return recorder.begin(bytes.data(), room);
}

std::vector<Exceeded> memories() {
  const std::size_t grid = tern::grid_words({40, 40, 20});
  const std::size_t map = tern::map_words(map_spec(256));
  const std::size_t flight = tern::flight_words(map_spec(256).dims);
  const std::size_t workspace = tern::kWorkspaceBytes;
  constexpr Status kRefused = Status::kInvalidArgument;
  return {{"kWorkspaceBytes", kRefused, [=] { return plan_in(workspace) == Status::kOk; },
           [=] { return plan_in(workspace - 1); }},
          {"grid_words()", kRefused, [=] { return bind_with_words(grid) == Status::kOk; },
           [=] { return bind_with_words(grid - 1); }},
          {"map_words()", kRefused, [=] { return bind_map_with_words(map) == Status::kOk; },
           [=] { return bind_map_with_words(map - 1); }},
          {"flight_words()", kRefused, [=] { return Started(flight).status == Status::kOk; },
           [=] { return Started(flight - 1).status; }},
          {"kMaxMissionPoints", Status::kViasFull, [] { return set_mission(tern::kMaxMissionPoints) == Status::kOk; },
           [] { return set_mission(tern::kMaxMissionPoints + 1); }},
          {"room for a plan's record", Status::kRecordFull, [] { return record(0) == Status::kOk; },
           [] { return record(8); }},
          {"kFlightRecordBytes", Status::kRecordFull,
           [] { return begin_flight_record(tern::kFlightRecordBytes) == Status::kOk; },
           [] { return begin_flight_record(tern::kFlightRecordBytes - 1); }}};
}

}  // namespace

std::vector<Exceeded> caller_capacities() {
  return joined({grid_capacities(), request_capacities(), map_capacities(), memories()});
}

}  // namespace tern_capacity
