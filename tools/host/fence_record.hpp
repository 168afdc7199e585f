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
};

/// Of six numbers, the lower corner first. Throws RecordError.
tern::Box box_of(const std::vector<double>& values, const std::string& key, const Place& place);

/// The box of a `block`, whose colour, three further numbers, has no meaning. Throws RecordError.
tern::Box block_box(const Words& words, const Place& place);

bool is_fence(const std::string& key);

/// When a fence holds, ns, and its clock's error, s; all zero: always.
struct FenceTimes {
  std::int64_t from = 0;
  std::int64_t until = 0;
  double clock_error = 0.0;
};

/// Takes `during t0 t1` or `during t0 t1 error` off the end of a record. Throws RecordError.
FenceTimes take_window(const Place& place, Words& words);

/// The most fences of a file. A request takes fewer (TERN_MAX_FENCES): Session::plan() chooses, flights refuse them.
constexpr std::size_t kMostFences = 4096;

/// Appends the fence of a record for which is_fence() holds. Throws RecordError, also beyond kMostFences.
void add_fence(const Words& words, const Place& place, std::vector<FenceRecord>& fences, const FenceTimes& times = {});

/// True if there are more fences or half-spaces than a request takes.
bool exceeds_capacity(const std::vector<FenceRecord>& fences);

/// Throws RecordError where the core would refuse them as empty on a map with this boundary and clearance: a keep-out
/// without any point, or keep-ins without one in common. Also for keep-out half-spaces without a point in the map: a
/// sign is most likely wrong, and nothing would be kept out.
void refuse_empty_fences(const std::vector<FenceRecord>& fences, const tern::Box& boundary, double clearance);

bool has_fence(const std::vector<FenceRecord>& fences, tern::FenceKind kind);

/// The fences as the core takes them: views of these.
std::vector<tern::Fence> fences_of(const std::vector<FenceRecord>& records);

/// As a log of a flight says it (docs/formats.md).
nlohmann::ordered_json fence_json(const FenceRecord& fence);

/// How far the point is inside a keep-in or outside a keep-out, metres; negative where it breaks the fence.
double fence_gap(const FenceRecord& fence, const tern::Vec3& point);

}  // namespace tern_host

#endif
