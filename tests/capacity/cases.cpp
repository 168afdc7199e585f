// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capacity/cases.hpp"

#include <cmath>
#include <memory>

#include "base/math.hpp"
#include "capacity/requests.hpp"
#include "support/owned_map.hpp"
#include "support/qp_random.hpp"
#include "support/world.hpp"
#include "support/yaw_case.hpp"
#include "tern/flight.hpp"
#include "tern/flight_record.hpp"
#include "tern/record.hpp"

namespace tern_capacity {
namespace {

using tern::HighWater;
using tern::Status;
using tern::Vec3;
using tern_test::World;

/// What a case answers that is at fault itself: no call does.
constexpr Status kNotThis = Status::kRunning;

using Mark = std::int32_t HighWater::*;

struct MarkedCapacity {
  Mark mark;
  std::int32_t capacity;
};
constexpr MarkedCapacity kMarked[] = {{&HighWater::nodes, tern::kMaxNodes},
                                      {&HighWater::open, tern::kMaxOpen},
                                      {&HighWater::jump_points, tern::kMaxJumpPoints},
                                      {&HighWater::segments, tern::kMaxSegments},
                                      {&HighWater::planes, tern::kMaxPlanes},
                                      {&HighWater::local_boxes, tern::kMaxLocalBoxes},
                                      {&HighWater::active, tern::kMaxActive},
                                      {&HighWater::qp_iterations, tern::kMaxQpIterations},
                                      {&HighWater::qp_solves, tern::kMaxQpSolves}};

/// True where the plan used all of one capacity, and some of each other one was left.
bool only_full(const tern::Report& report, Mark mark) {
  for (const MarkedCapacity& each : kMarked) {
    const std::int32_t used = report.high_water.*each.mark;
    if (used > each.capacity || (used == each.capacity) != (each.mark == mark)) return false;
  }
  return true;
}

/// The answer, if the plan used up this capacity alone and left the output as it was.
Status only(const World& world, Mark mark) {
  return only_full(world.report, mark) && world.trajectory_untouched() ? world.report.status : kNotThis;
}

/// The same of the first random request that ends with a status.
Status of_random_request(Status status, Mark mark) {
  constexpr std::uint64_t kMost = 20000;
  for (std::uint64_t seed = 0; seed < kMost; ++seed) {
    const auto asked = random_request(seed);
    if (asked->world.replan() == status && only_full(asked->world.report, mark)) return only(asked->world, mark);
  }
  return kNotThis;
}

bool some_random_plan_has(Mark mark, std::int32_t least) {
  constexpr std::uint64_t kMost = 20000;
  for (std::uint64_t seed = 0; seed < kMost; ++seed) {
    const auto asked = random_request(seed);
    if (asked->world.replan() == Status::kOk && asked->world.report.high_water.*mark >= least) return true;
  }
  return false;
}

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

// ---- the search and the path

/// Walls across y with doors at alternating ends, one voxel high.
World slalom(int walls) {
  World world({4 * walls + 4, 12, 1}, 0.25, 0.0);
  for (int i = 0; i < walls; ++i) {
    const double x = 1.0 * (i + 1);
    world.block({x, i % 2 == 0 ? 0.0 : 0.5, 0.0}, {x + 0.25, i % 2 == 0 ? 2.5 : 3.0, 0.25});
  }
  world.from({0.375, 0.375, 0.125}).to({walls + 0.625, 0.375, 0.125});
  return world;
}

Status plan_slalom(int walls) {
  World world = slalom(walls);
  world.plan();
  return world.report.status == Status::kOk ? Status::kOk : only(world, &HighWater::segments);
}

std::vector<Exceeded> path_capacities() {
  const auto has = [](Mark mark, std::int32_t least) { return [=] { return some_random_plan_has(mark, least); }; };
  const auto full = [](Status status, Mark mark) { return [=] { return of_random_request(status, mark); }; };
  return {{"TERN_MAX_NODES", Status::kNodesFull, has(&HighWater::nodes, tern::kMaxNodes - 8),
           full(Status::kNodesFull, &HighWater::nodes)},
          {"TERN_MAX_OPEN", Status::kOpenFull, has(&HighWater::open, tern::kMaxOpen - 1),
           full(Status::kOpenFull, &HighWater::open)},
          {"TERN_MAX_JUMP_POINTS", Status::kJumpPointsFull, has(&HighWater::jump_points, tern::kMaxJumpPoints - 1),
           full(Status::kJumpPointsFull, &HighWater::jump_points)},
          {"TERN_MAX_SEGMENTS", Status::kSegmentsFull, [] { return plan_slalom(2) == Status::kOk; },
           [] { return plan_slalom(3); }}};
}

// ---- the corridor

/// So short a way that its polyhedron cannot be halved, in a keep-in of so many faces, each as near as the others.
Status plan_in_pipe(int faces) {
  World world({40, 40, 20}, 0.05, 0.0);
  world.from({1.025, 1.025, 0.525}).to({1.025 + 1e-7, 1.025, 0.525});
  std::vector<tern::Halfspace> planes;
  for (int k = 0; k < faces; ++k) {
    const double turn = 2.0 * 3.14159265358979 * k / faces;
    const Vec3 normal{0.0, std::cos(turn), std::sin(turn)};
    planes.push_back({normal, tern::dot(normal, {0.0, 1.025, 0.525}) + 0.045});
  }
  const tern::Fence fence{planes.data(), faces, tern::FenceKind::kKeepIn};
  world.request.fences = &fence;
  world.request.fence_count = 1;
  const Status status = world.plan();
  return status == Status::kOk ? status : only(world, &HighWater::planes);
}

/// A checkerboard in space around a point's own voxel, as near as the radius: every voxel is a box of its own.
Status plan_in_checkerboard(int thickness) {
  World world({16, 16, 16}, 0.1, 0.3);
  for (int z = 0; z < 16; ++z) {
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        const int away = std::max({std::abs(x - 8), std::abs(y - 8), std::abs(z - 8)});
        if ((x + y + z) % 2 == 0 && away >= 4 && away < 4 + thickness) world.grid.mark_voxel({x, y, z});
      }
    }
  }
  world.from({0.85, 0.85, 0.85}).to({0.85 + 1e-7, 0.85, 0.85});
  const Status status = world.plan();
  return status == Status::kOk ? status : only(world, &HighWater::local_boxes);
}

std::vector<Exceeded> corridor_capacities() {
  return {{"TERN_MAX_PLANES", Status::kPlanesFull, [] { return plan_in_pipe(3) == Status::kOk; },
           [] { return plan_in_pipe(tern::kMaxPlanes); }},
          {"TERN_MAX_LOCAL_BOXES", Status::kObstaclesFull, [] { return plan_in_checkerboard(0) == Status::kOk; },
           [] { return plan_in_checkerboard(1); }}};
}

// ---- the optimiser

/// Six points, each beyond so many planes of its own: as many rows are active.
Status solve_with_rows(int planes) {
  static_assert(tern::kMaxActive == 12, "six points, two planes");
  tern_test::QpBench bench;
  bench.start({1.0, 1.0, 1.0, 1.0, 1.0, 1.0});
  for (int i = 0; i < 6; ++i) bench.add_point({0.0, 0.0, 0.0}, i, {1.0});
  for (int a = 0; a < planes; ++a) {
    Vec3 normal{0.0, 0.0, 0.0};
    tern::axis(normal, a) = -1.0;
    bench.add_plane(normal, -1.0);
  }
  bench.add_group(0, 6, 0, planes);
  return bench.solve();
}

/// Random programmes of many tight rows, from a warm start that helps none: the first one to end so.
Status solve_until(Status status) {
  tern_test::Random random(31);
  tern_test::QpBench bench;
  for (int n = 0; n < 200; ++n) {
    tern_test::QpRecipe recipe;
    recipe.unknowns = 4;
    recipe.groups = 4;
    recipe.points = 9;
    recipe.planes = 10;
    recipe.room = 0.02;
    random_programme(random, recipe, bench);
    std::vector<tern::QpRow> rows;
    for (int j = 0; j < tern::kMaxActive; ++j) {
      const int point = random.integer(0, bench.problem->point_count - 1);
      rows.push_back({point, random.integer(0, bench.problem->plane_count - 1)});
    }
    if (bench.solve_from(rows) == status) return status;
  }
  return kNotThis;
}

/// The first random request whose plan is the best of so many programmes.
Status plan_of_solves(int solves) {
  constexpr std::uint64_t kMost = 1000;
  for (std::uint64_t seed = 0; seed < kMost; ++seed) {
    const auto asked = random_request(seed);
    const Status status = asked->world.replan();
    if (status == Status::kOk && asked->world.report.high_water.qp_solves == solves) return status;
  }
  return kNotThis;
}

std::vector<Exceeded> optimiser_capacities() {
  return {{"TERN_MAX_ACTIVE", Status::kWorkingSetFull, [] { return solve_with_rows(2) == Status::kOk; },
           [] { return solve_with_rows(3); }},
          {"TERN_MAX_QP_ITERATIONS", Status::kIterationLimit, [] { return solve_until(Status::kOk) == Status::kOk; },
           [] { return solve_until(Status::kIterationLimit); }},
          {"TERN_MAX_QP_SOLVES", Status::kOk, [] { return plan_of_solves(tern::kMaxQpSolves - 1) == Status::kOk; },
           [] { return plan_of_solves(tern::kMaxQpSolves); }}};
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

std::vector<Exceeded> request_capacities() {
  return {{"TERN_MAX_FENCES", Status::kFencesFull, [] { return plan_with_fences(tern::kMaxFences, 1) == Status::kOk; },
           [] { return plan_with_fences(tern::kMaxFences + 1, 1); }},
          {"TERN_MAX_FENCE_PLANES", Status::kFencePlanesFull,
           [] { return plan_with_fences(1, tern::kMaxFencePlanes) != Status::kFencePlanesFull; },
           [] { return plan_with_fences(1, tern::kMaxFencePlanes + 1); }},
          {"TERN_MAX_FENCE_WORDS", Status::kFenceLayerFull,
           [] { return plan_on_words(tern::kMaxFenceWords) == Status::kOk; },
           [] { return plan_on_words(tern::kMaxFenceWords + 64); }},
          {"TERN_MAX_VIAS", Status::kViasFull, [] { return plan_with_vias(tern::kMaxVias) == Status::kOk; },
           [] { return plan_with_vias(tern::kMaxVias + 1); }}};
}

/// The answer to a plan with a share of the work that it needs in a stage: all of it, or a unit less.
Status plan_within(std::uint32_t tern::Budget::*budget, tern::Stage stage, std::uint32_t less) {
  World world = slalom(1);
  if (world.plan() != Status::kOk) return kNotThis;
  world.request.budget.*budget = world.report.stages[static_cast<int>(stage)].work - less;
  const Status status = world.replan();
  return status == Status::kOk ? world.report.optimiser : status;
}

Exceeded budget(const char* name, std::uint32_t tern::Budget::*member, tern::Stage stage, Status status) {
  return {name, status, [=] { return plan_within(member, stage, 0) == Status::kOk; },
          [=] { return plan_within(member, stage, 1); }};
}

std::vector<Exceeded> budgets() {
  return {budget("Budget::expansions", &tern::Budget::expansions, tern::Stage::kSearch, Status::kBudgetSearch),
          budget("Budget::sight_lines", &tern::Budget::sight_lines, tern::Stage::kShortcut, Status::kBudgetShortcut),
          budget("Budget::planes", &tern::Budget::planes, tern::Stage::kCorridor, Status::kBudgetCorridor),
          budget("Budget::iterations", &tern::Budget::iterations, tern::Stage::kTrajectory, Status::kBudgetOptimise)};
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

std::vector<Exceeded> exceeded_capacities() {
  std::vector<Exceeded> all;
  for (const auto& more : {grid_capacities(), path_capacities(), corridor_capacities(), optimiser_capacities(),
                           request_capacities(), budgets(), map_capacities(), memories()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace tern_capacity
