// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences as records of files: keepin, keepout, keepin_halfspaces and keepout_halfspaces; and in logs of flights.
#ifndef TERN_HOST_FENCE_RECORD_HPP
#define TERN_HOST_FENCE_RECORD_HPP

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "host/text_records.hpp"
#include "tern/fence.hpp"
#include "tern/vec3.hpp"

namespace tern_host {

/// A convex geofence; world frame, metres.
struct FenceRecord {
  tern::Fence fence;  ///< but for its half-spaces
  std::vector<tern::Halfspace> planes;
  std::string key = "fence";  ///< of its record, for messages
  Place place{};
  std::string zone{};  ///< what it is a fence of, as its record says; empty: nothing said
};

/// Of six numbers, the lower corner first. Throws RecordError.
tern::Box box_of(const std::vector<double>& values, const std::string& key, const Place& place);

/// The box of a `block`, whose colour, three further numbers, has no meaning. Throws RecordError.
tern::Box block_box(const Words& words, const Place& place);

bool is_fence(const std::string& key);

/// What may stand at the end of a fence's record.
struct FenceEnd {
  std::int64_t from = 0;  ///< when it holds, ns, and its clock's error, s; all zero: always
  std::int64_t until = 0;
  double clock_error = 0.0;
  std::string zone;

  bool has_times() const { return from != until; }
};

/// True if a name has `during` before a number: it would swallow the times of a fence, which then held always.
bool hides_times(const Words& name);

/// Takes `during t0 t1` or `during t0 t1 error`, and `zone` with a name to the end of the line, off a record. Throws
/// RecordError.
FenceEnd take_end(const Place& place, Words& words);

/// The most fences of a file. A request takes fewer (TERN_MAX_FENCES): Session::plan() chooses, flights refuse them.
constexpr std::size_t kMostFences = 4096;

/// Appends the fence of a record for which is_fence() holds, without its end. Throws RecordError, also beyond
/// kMostFences.
void add_fence(const Words& words, const Place& place, std::vector<FenceRecord>& fences, const FenceEnd& end = {});

/// " (Old town)" for the fence with this index; empty if it has no name.
std::string zone_text(const std::vector<FenceRecord>& fences, std::int32_t index);

/// True if there are more fences or half-spaces than a request takes.
bool exceeds_capacity(const std::vector<FenceRecord>& fences);

/// Throws RecordError where the core would refuse them as empty on a map with this boundary and clearance: a keep-out
/// without any point, or keep-ins without one in common. Also for keep-out half-spaces without a point in the map: a
/// sign is most likely wrong, and nothing would be kept out.
void refuse_empty_fences(const std::vector<FenceRecord>& fences, const tern::Box& boundary, double clearance);

bool has_fence(const std::vector<FenceRecord>& fences, tern::FenceKind kind);
/// A keep-out that holds for a while, or one that always holds.
bool has_keepout(const std::vector<FenceRecord>& fences, bool for_a_while);

/// When a fence for a while may count, s of its clock: a keep-out for longer by the clock's error at both ends, a
/// keep-in for less.
struct FenceSpan {
  double from;
  double until;
};
FenceSpan span_of(const tern::Fence& fence);

/// The fences as the core takes them: views of these.
std::vector<tern::Fence> fences_of(const std::vector<FenceRecord>& records);

/// As a log of a flight says it (docs/formats.md).
nlohmann::ordered_json fence_json(const FenceRecord& fence);

/// How far the point is beyond the plane that it is farthest beyond, metres; negative where it is behind all.
double beyond_planes(const FenceRecord& fence, const tern::Vec3& point);

/// How far the point is inside a keep-in or outside a keep-out, metres; negative where it breaks the fence.
double fence_gap(const FenceRecord& fence, const tern::Vec3& point);

}  // namespace tern_host

#endif
