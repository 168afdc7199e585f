// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "record/envelope.hpp"
#include "record/fences.hpp"
#include "record/fields.hpp"
#include "record/obstacles.hpp"
#include "record/tracks.hpp"
#include "tern/record.hpp"

namespace tern {
namespace {

constexpr std::size_t kTrajectoryFields = 5 + kSegmentFields * static_cast<std::size_t>(kMaxSegments);

constexpr std::size_t kRequestFields = 2 * kStateFields + kLimitFields + kSettingFields + kFencesFields + 1 +
                                       kViaFields * static_cast<std::size_t>(kMaxVias) + 1 + kTrajectoryFields +
                                       kTracksFields + 1;
/// The most words of a record without the obstacles. The status and the plan are last of them.
constexpr std::size_t kFields = kEnvelopeWords + kGridFields + kRequestFields + 1 + kTrajectoryFields;

void write_trajectory(const Trajectory& trajectory, WordWriter& words) {
  words(trajectory.count);
  words(trajectory.begin);
  words(trajectory.origin);
  for (int i = 0; i < trajectory.count; ++i) list_segment(words, trajectory.segments[i]);
}

bool trajectory_fits(const Trajectory& trajectory) {
  return trajectory.count >= 0 && trajectory.count <= kMaxSegments;
}

bool can_be_written(const Request& request) {
  return fences_fit(request.fences, request.fence_count) && is_count(request.via_count, kMaxVias, request.vias) &&
         tracks_fit(request.tracks, request.track_count) &&
         (request.previous == nullptr || trajectory_fits(*request.previous));
}

/// What follows the vias: a sum of these.
constexpr std::uint64_t kHasPrevious = 1;
constexpr std::uint64_t kHasTracks = 2;

bool asks_for_tracks(const Request& request) {
  return request.track_count > 0 || request.rest_clear > 0.0;
}

void write_request(const Request& request, WordWriter& words) {
  list_state(words, request.start);
  list_state(words, request.goal);
  list_limits(words, request.limits);
  list_settings(words, request);
  write_fences(request.fences, request.fence_count, words);
  words(request.via_count);
  for (std::int32_t v = 0; v < request.via_count; ++v) list_via(words, request.vias[v]);
  words.word((request.previous != nullptr ? kHasPrevious : 0) + (asks_for_tracks(request) ? kHasTracks : 0));
  if (request.previous != nullptr) write_trajectory(*request.previous, words);
  if (!asks_for_tracks(request)) return;
  words(request.rest_clear);
  write_tracks(request.tracks, request.track_count, words);
}

Status read_trajectory(WordReader& words, Trajectory& trajectory) {
  trajectory = Trajectory{};
  std::int32_t count = 0;
  const Status status = read_count(words, kMaxSegments, Status::kSegmentsFull, count);
  if (status != Status::kOk) return status;
  trajectory.count = count;
  words(trajectory.begin);
  words(trajectory.origin);
  for (int i = 0; i < count; ++i) list_segment(words, trajectory.segments[i]);
  return Status::kOk;
}

Status read_vias(WordReader& words, PlanRecord& record) {
  const Status status = read_count(words, kMaxVias, Status::kViasFull, record.request.via_count);
  if (status != Status::kOk) return status;
  record.request.vias = record.vias;
  for (std::int32_t v = 0; v < record.request.via_count; ++v) list_via(words, record.vias[v]);
  return status;
}

/// The previous plan and the tracks, if there are any.
Status read_rest(WordReader& words, PlanRecord& record) {
  const std::uint64_t follows = words.word();
  if (follows > kHasPrevious + kHasTracks) return Status::kRecordDamaged;
  Status status = Status::kOk;
  Request& request = record.request;
  if ((follows & kHasPrevious) != 0) {
    request.previous = &record.previous;
    status = read_trajectory(words, record.previous);
  }
  if ((follows & kHasTracks) == 0 || status != Status::kOk) return status;
  words(request.rest_clear);
  request.tracks = record.tracks;
  return read_tracks(words, record.tracks, record.track_pieces, request.track_count);
}

Status read_request(WordReader& words, PlanRecord& record) {
  record.request = Request{};
  list_state(words, record.request.start);
  list_state(words, record.request.goal);
  list_limits(words, record.request.limits);
  list_settings(words, record.request);
  record.request.fences = record.fences;
  Status status = read_fences(words, record.fences, record.planes, record.request.fence_count);
  if (status == Status::kOk) status = read_vias(words, record);
  if (status == Status::kOk) status = read_rest(words, record);
  return status;
}

/// Reads everything before the obstacles.
Status read_content(WordReader& words, PlanRecord& record) {
  list_grid(words, record.grid);
  Status status = read_request(words, record);
  if (status != Status::kOk) return status;
  words(record.status);
  status = read_trajectory(words, record.plan);
  return status == Status::kOk && words.past_end() ? Status::kRecordDamaged : status;
}

/// Reads all but the obstacles; `content` then begins with these.
Status open_record(const std::uint8_t* bytes, std::size_t count, PlanRecord& record, WordReader& content) {
  if (bytes == nullptr) return Status::kInvalidArgument;
  const Status status = check_envelope(RecordKind::kPlan, bytes, count, record.configuration);
  if (status != Status::kOk) return status;
  content = content_of(bytes, count);
  return read_content(content, record);
}

}  // namespace

std::size_t plan_record_bytes(const Voxel& dims) noexcept {
  if (grid_words(dims) == 0) return 0;
  const std::size_t layer = static_cast<std::size_t>((dims.x + 63) / 64) * static_cast<std::size_t>(dims.y) *
                            static_cast<std::size_t>(dims.z);
  return kWordBytes * (kFields + most_obstacle_words(layer));
}

Status record_plan(const Grid& grid, const Request& request, Status status, const Trajectory& plan, std::uint8_t* bytes,
                   std::size_t room, std::size_t* used) noexcept {
  if (!grid.bound() || bytes == nullptr || used == nullptr) return Status::kInvalidArgument;
  if (!can_be_written(request) || (status == Status::kOk && !trajectory_fits(plan))) return Status::kInvalidArgument;
  WordWriter words(bytes, room);
  open_envelope(RecordKind::kPlan, words);
  list_grid(words, grid.spec());
  write_request(request, words);
  words(status);
  if (status == Status::kOk) {
    write_trajectory(plan, words);
  } else {
    words(0);
    words(0);
    words(Vec3{});
  }
  write_obstacles(grid, words);
  return close_envelope(bytes, words, *used);
}

Status read_plan_record(const std::uint8_t* bytes, std::size_t count, PlanRecord& record) noexcept {
  WordReader content(nullptr, 0);
  return open_record(bytes, count, record, content);
}

Status read_plan_record(const std::uint8_t* bytes, std::size_t count, PlanRecord& record, Grid& grid,
                        std::uint64_t* words, std::size_t word_count) noexcept {
  WordReader content(nullptr, 0);
  Status status = open_record(bytes, count, record, content);
  if (status == Status::kOk) status = grid.bind(record.grid, words, word_count);
  if (status == Status::kOk) status = read_obstacles(content, grid);
  if (status == Status::kOk) grid.inflate();
  return status;
}

}  // namespace tern
