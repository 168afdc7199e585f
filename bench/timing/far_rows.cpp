// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A far way through a city of 5 x 5 x 0.15 km, 59 million cells of 4 m, from corner to corner: the whole search, and
// the longest ticks of a vehicle that follows it, gives up before a wall that the city did not have, and learns.
#include "timing/far_rows.hpp"

#include <cstddef>
#include <cstdint>

#include "baremetal/board.hpp"
#include "city.hpp"
#include "tern/far_way.hpp"

namespace tern_timing {
namespace {

using tern::FarState;
using tern::Vec3;

constexpr tern_bench::City kCity{15.0, 150.0, 60.0};
constexpr double kCell = 4.0;
constexpr std::size_t kGridWords = 2 << 20;
constexpr std::size_t kMapWords = 1 << 19;
constexpr Vec3 kStart{5.0, 5.0, 10.0};
constexpr Vec3 kGoal{4995.0, 4995.0, 10.0};
/// Half the window of the map is 20 m; the longest look is the worst.
constexpr double kAhead = tern::kMostAhead * kCell;
constexpr std::uint32_t kTickWork = 1000;
constexpr int kMostTicks = 1000000;

TERN_BOARD_LARGE std::uint64_t grid_words[kGridWords];
TERN_BOARD_LARGE std::uint64_t map_words[kMapWords];

struct Cost {
  std::uint64_t way = 0;  ///< of the ticks up to the first way
  std::uint32_t way_work = 0;
  std::uint64_t longest = 0;  ///< of all ticks
  std::uint32_t ticks = 0;
};

class Journey {
 public:
  Journey(tern::Workspace& workspace, std::uint32_t work) : planner_(&workspace, sizeof workspace), work_(work) {}

  bool start() {
    tern::MapSpec near = tern::map_spec({-20.0, -20.0, 6.0}, 0.2, {200, 200, 40}, 0.3);
    const bool bound = grid_.bind(tern_bench::city_spec(kCity, kCell), grid_words, kGridWords) == tern::Status::kOk &&
                       map_.bind(near, map_words, kMapWords) == tern::Status::kOk;
    if (!bound) return false;
    tern_bench::build_city(kCity, grid_);
    map_.mark_box({{kStart.x + 6.0, -20.0, 6.0}, {kStart.x + 6.4, 20.0, 14.0}});
    return far_.start({kAhead}, grid_, planner_) == tern::Status::kOk && far_.set_goal(kGoal) == tern::Status::kOk;
  }

  /// To the way, through the doubt, and along the new way.
  bool run(Cost& cost) {
    const bool found = search(cost);
    cost.way = spent_;
    cost.way_work = cost.ticks * work_;
    for (int k = 0; k < kMostTicks && far_.searches() < 2; ++k) tick(kStart, tern::FlightReason::kNoProgress, cost);
    const bool found_again = search(cost) && far_.marked() > 0;
    for (int k = 0; k < kMostTicks && !far_.is_last(); ++k) tick(far_.near_goal(), tern::FlightReason::kNone, cost);
    return found && found_again && far_.is_last();
  }

 private:
  bool search(Cost& cost) {
    for (int k = 0; k < kMostTicks && far_.state() == FarState::kSearching; ++k) {
      tick(kStart, tern::FlightReason::kNone, cost);
    }
    return far_.state() == FarState::kLeads;
  }
  void tick(const Vec3& at, tern::FlightReason reason, Cost& cost) {
    tern::FlightReport report{};
    report.reason = reason;
    const std::uint64_t before = tern_board::counter();
    far_.tick(at, report, map_, 0, work_);
    const std::uint64_t count = tern_board::counter() - before;
    spent_ += count;
    ++cost.ticks;
    if (count > cost.longest) cost.longest = count;
  }

  tern::Grid grid_;
  tern::RollingMap map_;
  tern::Planner planner_;
  tern::FarWay far_;
  std::uint32_t work_;
  std::uint64_t spent_ = 0;
};

void print_row(const char* stage, std::uint64_t count, std::uint32_t work) {
  tern_board::print("far_city,", stage, ",", count, ",", work, ",0\n");
}

}  // namespace

bool print_far_rows(tern::Workspace& workspace) {
  Cost tick;
  Journey in_ticks(workspace, kTickWork);
  const bool led = in_ticks.start() && in_ticks.run(tick);
  Cost unit;
  Journey in_units(workspace, 1);
  const bool led_too = in_units.start() && in_units.run(unit);
  print_row("far way", unit.way, unit.way_work);
  print_row("far tick", tick.longest, kTickWork);
  print_row("far unit", unit.longest, 1);
  return led && led_too;
}

}  // namespace tern_timing
