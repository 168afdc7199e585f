// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds until when a trajectory is proven on a map, for plans that were made on an older map or on another one. For
// example, a plan on a rolling map's route grid is proven on its safe grid. docs/flight.md explains the method.
#ifndef TERN_PROOF_HPP
#define TERN_PROOF_HPP

#include <stdint.h>

#include "tern/fence.hpp"
#include "tern/grid.hpp"
#include "tern/proof_report.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/track_proof.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"
#include "tern/work.hpp"

namespace tern {

struct Allowed;
struct AskedWorld;
struct Excess;
struct Grant;
struct Hints;
struct PlanHints;
struct TurningRule;

/// What a proof assumes of the space beyond the grid's boundary.
enum class Beyond : uint8_t {
  kEmpty,  ///< The centre must stay within the boundary. This is the planner's rule.
  kSolid,  ///< The centre must keep the radius from the boundary too, because nobody has seen what is beyond it.
};

/// Voxels that became solid although they had been seen free. In a world that stands still, such voxels are errors of
/// the sensor.
struct Alarm {
  /// A box around the voxels that became solid, world frame, metres. Voxels whose centres are outside are not part of
  /// it.
  Box box;
  /// A layer of yours with a bit for each voxel that was seen free, in the rows of Grid::obstacle_row(). It must stay
  /// until the proof is done. See RollingMap::seen_rows().
  const uint64_t* seen;
};

/// What a proof may rely on. World frame, metres; copied by Proof::begin(). Null: nothing.
struct ProofGrounds {
  /// The trajectory was proven before, and no obstacle was added since but in this box. Only the parts of the
  /// trajectory near the box are proven again. Fences for a while are not. See RollingMap::take_added().
  const Box* added = nullptr;
  /// A place to get away from, for a vehicle at rest with something within its radius. The trajectory may come as near
  /// to an obstacle as this place is, even if that is less than the radius, but no nearer.
  const Vec3* departed = nullptr;
  /// Obstacles of this alarm do not count.
  const Alarm* alarm = nullptr;
  /// Fences that the trajectory must respect, `fence_count` of them, valid as for a Request. They must stay until the
  /// proof is done.
  const Fence* fences = nullptr;
  int32_t fence_count = 0;
  /// With `departed`: the height of the ground that the vehicle stands on there. Then only the voxels that reach below
  /// it count as left: the trajectory keeps the radius from all others. It is never lower than `departed`.
  const double* ground = nullptr;
  /// Things that move, `track_count` of them, valid as for a Request. They must stay until the proof is done. With
  /// `departed`, the trajectory may also begin nearer to a thing than it should, if it leads away
  /// (TrackGrounds::leaves).
  const Track* tracks = nullptr;
  int32_t track_count = 0;
};

/// A segment is halved at most this many times over. A piece that is not proven then ends the proof.
constexpr int kProofDepth = 18;
/// The most pieces of one segment that a proof looks at, for its position and for each derivative.
constexpr int kProofPieces = 2048;
/// Voxels along each axis that a piece may extend over. A larger one is halved before obstacles are looked at, which
/// bounds the work for a piece.
constexpr int kProofSpan = 8;
/// Metres by which the centre may be nearer to an obstacle than the grid's radius, or parts of a voxel if voxels are
/// larger than a metre. It is a little more than the check grants a plan. Rounding of coordinates comes on top.
constexpr double kProofTolerance = 4e-9;
/// Relative excess over a limit that counts as the limit. Rounding comes on top.
constexpr double kProofExcess = 4e-8;

/// Proves a trajectory from a given time on, piece by piece. Every piece is a Bezier curve, which lies in the hull of
/// its control points. It is proven if a plane separates that hull from each obstacle cube nearby with the grid's
/// radius to spare; otherwise it is halved. So the proof is about the whole curve, not about samples of it. It reads
/// the obstacle layer alone, and shares no code with the stages that make plans.
///
/// The proof of a trajectory ends at the first piece that cannot be proven. That is at most 2^-kProofDepth of a
/// segment's duration earlier than need be, unless the curve keeps the radius by less than rounding.
class Proof {
 public:
  /// Begins. The grid and the trajectory must stay until the proof is done. The grid need not be inflated. Obstacles
  /// that are marked while the proof is at work may be missed: begin again. `from` is in seconds since the trajectory's
  /// beginning; NaN and negative numbers count as 0, and past the end only the final position is proven. `limits` may
  /// be null: then only clearance is proven.
  ///
  /// kRunning; kInvalidArgument if the grid is not bound or has radius 0, or the trajectory is empty. A fence or a
  /// track that a Request may not have gets the same answer as there.
  Status begin(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits, Beyond beyond,
               const ProofGrounds& grounds = {}) noexcept;
  /// As begin(), with fences and tracks that begin(), a plan or a flight accepted before, and that did not change
  /// since. It does not check them again, which takes a look at each corner that three half-spaces may have.
  Status begin_accepted(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits,
                        Beyond beyond, const ProofGrounds& grounds = {}) noexcept;
  /// The planner's check of a plan or of a part of one, with the planner's hints. `from` as in begin(). The curve must
  /// keep off obstacles, keep-outs and what is outside the boundary by `spare` metres more than a plan has to. `limits`
  /// and `world` may be null. AskedWorld and PlanHints are types of the library's own, so no one else can call this.
  void begin_plan(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits,
                  const AskedWorld* world, double spare, PlanHints& hints) noexcept;
  /// Adds tracks to a proof that was begun and not yet gone on with: they were accepted before. The trajectory may come
  /// nearer by `grant` metres.
  void watch(const TrackGrounds& tracks, double grant) noexcept;
  /// Goes on as long as work is left. kRunning: there is more to do. kOk: the report is complete. kInvalidArgument if
  /// no proof was begun.
  ///
  /// A piece of work is a piece of the curve. It takes at most as long as it takes to read the voxels within the radius
  /// of a box of kProofSpan voxels.
  Status step(Work& work) noexcept;
  /// The same with `work` more units. What a call takes beyond them, the next calls take less.
  Status step(uint32_t work) noexcept;
  /// What is known so far.
  const ProofReport& report() const noexcept { return report_; }
  /// The first track that the trajectory begins too near to, and is proven to leave; kNoTrack: none.
  int32_t left() const noexcept { return tracks_.left(); }

 private:
  /// One piece of a curve of degree 7 or less.
  struct Piece {
    Vec3 c[kControlPoints];
    double begin;  // the segment's parameter at the piece's beginning, 0 .. 1
    int depth;
  };
  enum Part : int { kPosition, kVelocity, kAcceleration, kJerk, kTurning };

  void refuse(double from) noexcept;
  void take_grant(const Grid& grid, const Grant& grant, Beyond beyond) noexcept;
  void depart(const ProofGrounds& grounds) noexcept;
  void pardon(const Alarm& alarm) noexcept;
  void enter(const Trajectory& trajectory) noexcept;
  bool sound(const Segment& segment) const noexcept;
  double gap_before(const Segment& segment) const noexcept;
  int part_after(int part) const noexcept;
  void enter_segment() noexcept;
  void enter_part(int part) noexcept;
  Hints hints() const noexcept;
  bool holds(const Piece& piece, int count, Finding& end) noexcept;
  bool keeps_clear(const Piece& piece, Finding& end) noexcept;
  bool keeps_fences(const Piece& piece) noexcept;
  bool is_cut_off(int fence, const Piece& piece) noexcept;
  Allowed allowed() const noexcept;
  TurningRule turning() const noexcept;
  double rounding_of(int derivative) const noexcept;
  double length_of(const Piece& piece) const noexcept;
  Excess excess_at(const Vec3& point, Finding end) const noexcept;
  void note_excess(const Piece& piece, int degree, Finding end) noexcept;
  void look_at_piece() noexcept;
  void lose(double u, Finding end) noexcept;
  void end_part() noexcept;
  void begin_tracks() noexcept;
  void step_tracks() noexcept;

  const Grid* grid_ = nullptr;
  const Trajectory* trajectory_ = nullptr;
  bool running_ = false;
  bool has_limits_ = false;
  Limits limits_{};
  Box boundary_{};         // where the curve may be, local frame
  double distance_ = 0.0;  // the least from obstacles and keep-outs
  double near_ = 0.0;      // the grant: the radius less distance_
  double outside_ = 0.0;   // the most by which the curve may be outside a keep-in
  double excess_ = 0.0;    // granted over a limit, relative
  bool is_cut_ = true;     // the curve's control points are rounded
  PlanHints* hints_ = nullptr;
  bool has_added_ = false;
  Box added_{};  // local frame
  bool has_departed_ = false;
  Vec3 departed_{};      // local frame
  double ground_ = 0.0;  // local frame: what begins there or above it is not left
  const uint64_t* pardoned_ = nullptr;
  Voxel pardon_begin_{};  // voxels whose obstacles need not count
  Voxel pardon_end_{};
  const Fence* fences_ = nullptr;
  int32_t fence_count_ = 0;
  double from_ = 0.0;
  bool is_watching_ = false;  // the curve is proven, and the tracks are looked at
  double track_grant_ = 0.0;
  TrackGrounds watched_{};
  TrackProof tracks_;
  int segment_ = 0;
  double begin_ = 0.0;  // when the segment begins, seconds since the trajectory's beginning
  double first_ = 0.0;  // the segment's parameter where its proof begins
  double lost_ = 1.0;   // the segment's parameter where its proof ends
  int part_ = kPosition;
  int height_ = 0;
  int pieces_ = 0;
  double worst_ = 0.0;  // excess that was seen in this part
  int worst_axis_ = -1;
  Piece stack_[kProofDepth + 1] = {};
  Work* work_ = nullptr;  // the current slice
  Work slice_;            // the work given to step(); a debt between two calls
  int64_t spent_ = 0;     // operations of all pieces so far
  ProofReport report_{};
};

/// A whole proof in one call. Returns the time until which the trajectory is proven, in seconds since its beginning:
/// duration(trajectory) if all of it is, `from` if nothing is or if begin() refuses. `report` may be null.
double clear_until(const Grid& grid, const Trajectory& trajectory, double from, const Limits* limits = nullptr,
                   Beyond beyond = Beyond::kEmpty, ProofReport* report = nullptr) noexcept;

}  // namespace tern

#endif
