// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The far level of a map of two levels. A coarse grid of the whole world knows what was known before the flight. A
// FarWay finds the way through it, and gives a Flight near goals on that way, one after the other. So the vehicle does
// not fly into dead ends that are larger than its rolling map. docs/far_way.md has the rules.
#ifndef TERN_FAR_WAY_HPP
#define TERN_FAR_WAY_HPP

#include <stdint.h>

#include "tern/flight_report.hpp"
#include "tern/grid.hpp"
#include "tern/map.hpp"
#include "tern/planner.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"
#include "tern/work.hpp"

namespace tern {

/// How far ahead a far way must look at least, in cells of the coarse grid. With less, a vehicle could arrive at a near
/// goal before there is a new one.
constexpr double kLeastAhead = 3.0;
/// And at most. One look along the way is one piece of work, which grows with the square of this. So it takes no more
/// than a flight's tick.
constexpr double kMostAhead = 256.0;

/// How a far way leads.
struct FarWaySpec {
  /// How far ahead a near goal is at most, metres along the way: kLeastAhead to kMostAhead coarse cells. Choose a
  /// little less than half the shorter level side of the rolling map's window.
  double ahead;
  /// Nanoseconds without getting a coarse cell further along the way until the way counts as doubtful, > 0.
  int64_t patience = 10000000000;
};

/// What a far way is doing.
enum class FarState : uint8_t {
  kNoGoal = 0,  ///< no goal was set
  kSearching,   ///< looks for a way; near_goal() stays as it was
  kLeads,       ///< near_goal() lies on a way through the coarse grid, or is the goal
  kNoWay,       ///< the coarse grid has no way from where the vehicle is: near_goal() is the goal
};

/// The way through a coarse grid. Guides and never proves: a Flight proves each plan on its own map, whatever its goal
/// is. It spends counted work alone, so the same calls have the same answers on every machine.
///
/// The coarse grid is an ordinary grid with large cells: bind it with radius 0, mark everything that is known, and
/// inflate it. With boxes, a cell is free only if nothing known reaches into it, and each passage that is two cells
/// wide stays open; with Grid::mark_grid, one that is one cell wide. A narrower one may be lost. Coarse grid and
/// planner must outlive this object, at the same addresses, and nobody else may plan with this planner. It must not be
/// the one of the Flight.
class FarWay {
 public:
  /// kOk; kNonFiniteInput; kInvalidArgument: a spec out of range, `ahead` of less than kLeastAhead cells or more than
  /// kMostAhead, or a coarse grid that is not inflated. A refused call changes nothing.
  Status start(const FarWaySpec& spec, Grid& coarse, Planner& planner) noexcept;
  /// Sets the goal, world frame, and looks for a way to it. Call it again after you marked or cleared voxels of the
  /// coarse grid. kNonFiniteInput; kInvalidArgument before start(). A refused call changes nothing.
  Status set_goal(const Vec3& goal) noexcept;
  /// Does one tick's work, at most `work` units and one piece of work more; nothing before an earlier piece is paid.
  /// Pieces: those of the search, a look along the way for a near goal, a look around for a free cell to begin in, a
  /// cell of the window, the walk to the cell ahead that is marked, and those of the inflation. Call it before each
  /// Flight::tick(), with the vehicle's position, world frame; with the report of the last Flight::tick(), which says
  /// whether the flight gave up the near goal (zeros before the first one); with the flight's map; and with the time of
  /// the tick. True: call Flight::set_goal(near_goal()) now. It may be the same near goal as before: then the flight
  /// gave up for a reason that may have passed.
  bool tick(const Vec3& position, const FlightReport& flight, const RollingMap& map, int64_t t, uint32_t work) noexcept;

  /// Where the flight should fly now, world frame. The goal itself before the first way was found.
  const Vec3& near_goal() const noexcept { return near_goal_; }
  /// True if the near goal is the goal.
  bool is_last() const noexcept { return is_last_; }
  FarState state() const noexcept { return state_; }
  /// Metres from the vehicle along the way to its end; 0 unless state() is kLeads.
  double left() const noexcept;
  /// How many ways were searched for, and how many cells of the coarse grid were marked because the near map has
  /// something there.
  int32_t searches() const noexcept { return searches_; }
  int32_t marked() const noexcept { return marked_; }

 private:
  enum class Job : uint8_t { kBegin, kSearch, kFollow, kLearn, kInflate };

  /// A point of the way.
  struct Point {
    Vec3 place;  ///< coarse grid's frame
    double way;  ///< metres along the path
    bool is_end;
  };

  const Path& path() const noexcept;
  void choose_start(const RollingMap& map) noexcept;
  void begin_search() noexcept;
  bool search() noexcept;
  bool end_search() noexcept;
  bool lead_to_goal(FarState state) noexcept;
  bool follow(const FlightReport& flight, const RollingMap& map, int64_t t) noexcept;
  void get_on(int64_t t) noexcept;
  Point furthest_in_sight() noexcept;
  bool choose_near_goal() noexcept;
  void begin_learning(const RollingMap& map) noexcept;
  void mark(const Voxel& cell) noexcept;
  void learn(const RollingMap& map) noexcept;
  bool end_learning() noexcept;
  void mark_ahead() noexcept;
  void inflate() noexcept;

  FarWaySpec spec_{};
  Grid* coarse_ = nullptr;
  Planner* planner_ = nullptr;
  Vec3 goal_{};
  Vec3 position_{};  ///< of the vehicle at the last tick, world frame
  Vec3 near_goal_{};
  bool is_last_ = true;
  FarState state_ = FarState::kNoGoal;
  Job job_ = Job::kFollow;
  Work work_;
  int32_t searches_ = 0;
  int32_t marked_ = 0;

  // The search: from the vehicle or, if its cell is not free, from the nearest free cell that the rolling map shows the
  // way to. If there is none, from the free cell nearest to it.
  Vec3 from_{};
  bool is_moved_ = false;

  // How far the vehicle has come.
  double length_ = 0.0;   ///< of the path, metres
  int32_t leg_ = 0;       ///< the leg of the raw path,
  Vec3 place_{};          ///< the point of that leg, coarse grid's frame,
  double done_ = 0.0;     ///< metres along the path to that point,
  double near_at_ = 0.0;  ///< to the near goal; 0 before the first one,
  double looked_ = 0.0;   ///< to where the vehicle was when a near goal was chosen last,
  double noted_ = 0.0;    ///< and to where the vehicle was at `since_`
  int64_t since_ = 0;

  // What is learned of the near map.
  bool gave_up_ = false;  ///< the flight gave up the near goal for good,
  bool waits_ = false;    ///< or for a reason that may pass
  Voxel begin_{};         ///< the coarse cells that the window meets, and the next one
  Voxel end_{};
  Voxel cell_{};
  int32_t found_ = 0;  ///< cells marked by this job
  int32_t piece_ = 0;  ///< of the inflation
};

}  // namespace tern

#endif
