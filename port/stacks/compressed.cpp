// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The Crazyflie's compressed trajectories: int16 control points, millimetres and tenths of a degree, one byte of types
// a piece. Of the four degrees that the format has, 0 and 7 are used.
#include "base/math.hpp"
#include "bound.hpp"
#include "pieces.hpp"
#include "tern_stacks/stacks.hpp"
#include "yaw/angle.hpp"
#include "yaw_piece.hpp"

namespace tern {
namespace {

constexpr double kMetre = 1000.0;         // millimetres
constexpr double kRadian = 1800.0 / kPi;  // tenths of a degree
constexpr double kSecond = 1000.0;        // milliseconds
constexpr double kLargest = 32767.0;
constexpr double kLongest = 65535.0;
constexpr double kLatest = 2e9;    // milliseconds
constexpr double kShortest = 1.0;  // s: halving makes no shorter piece, because rounding would bend it more
constexpr int kStartBytes = 8;
constexpr int kPieceHead = 3;  // types and duration
constexpr int kMostPieceBytes = crazyflie_compressed_bytes(1) - crazyflie_compressed_bytes(0);
constexpr int kFull = 3;  // type of a polynomial of degree 7
constexpr uint8_t kAllFull = kFull | kFull << 2 | kFull << 4;
constexpr uint8_t kYawFull = kFull << 6;

/// The nearest whole number, halves away from 0; false beyond `most`.
bool rounded(double x, double most, int32_t& out) {
  if (!(absolute(x) <= most)) return false;
  const int32_t whole = static_cast<int32_t>(x);
  const double rest = x - whole;
  out = whole + (rest >= 0.5 ? 1 : 0) - (rest <= -0.5 ? 1 : 0);
  return absolute(out) <= most;
}

/// Writes 16-bit numbers, and remembers whether all of them fitted.
struct Writer {
  uint8_t* at;
  bool ok = true;

  void put(double x, double most) {
    int32_t value = 0;
    ok = rounded(x, most, value) && ok;
    *at++ = static_cast<uint8_t>(value & 0xFF);
    *at++ = static_cast<uint8_t>((value >> 8) & 0xFF);
  }
};

/// Writes one piece, from `first` to `last` ms after the plan's beginning.
void put_piece(const Trajectory& trajectory, const YawPlan* yaw, const Span& span, int32_t first, int32_t last,
               const Vec3& origin, Writer& out) {
  const double begin = first / kSecond;
  const double end = last / kSecond;
  *out.at++ = static_cast<uint8_t>(kAllFull | (yaw != nullptr ? kYawFull : 0));
  out.put(last - first, kLongest);
  Vec3 places[kControlPoints];
  piece_points(trajectory, span, begin, end, origin, places);
  for (int a = 0; a < 3; ++a) {
    for (int i = 1; i < kControlPoints; ++i) out.put(axis(places[i], a) * kMetre, kLargest);
  }
  if (yaw == nullptr) return;
  double points[kControlPoints];
  yaw_piece(yaw, begin, end - begin, points);
  for (int i = 1; i < kControlPoints; ++i) out.put(points[i] * kRadian, kLargest);
}

int32_t read_signed(const uint8_t* at) {
  const int32_t value = at[0] | (at[1] << 8);
  return value < 32768 ? value : value - 65536;
}

/// Bytes of a piece with these types, or 0 if it is none that this file writes.
int32_t piece_bytes(uint8_t types) {
  if ((types & ~kYawFull) != kAllFull) return 0;
  const bool has_yaw = (types & kYawFull) == kYawFull;
  if (!has_yaw && (types & kYawFull) != 0) return 0;
  return kPieceHead + 2 * kDegree * (has_yaw ? 4 : 3);
}

/// Reads one piece; `last`, in millimetres, is the end of the piece before, and afterwards the end of this piece.
void read_piece(const uint8_t* at, int32_t (&last)[3], Segment& segment) {
  segment.duration = (at[1] | (at[2] << 8)) / kSecond;
  segment.polyhedron = 0;
  const uint8_t* next = at + kPieceHead;
  for (int a = 0; a < 3; ++a) {
    for (int i = 0; i < kControlPoints; ++i) {
      if (i > 0) {
        last[a] = read_signed(next);
        next += 2;
      }
      axis(segment.points[i], a) = last[a] / kMetre;
    }
  }
}

/// Reads the yaw of a piece; `last`, in tenths of a degree, as in read_piece(). Without yaw it stays.
void read_yaw(const uint8_t* at, int32_t& last, double (&points)[kControlPoints]) {
  const bool has_yaw = (at[0] & kYawFull) != 0;
  const uint8_t* next = at + kPieceHead + 2 * kDegree * 3;
  for (int i = 0; i < kControlPoints; ++i) {
    if (i > 0 && has_yaw) {
      last = read_signed(next);
      next += 2;
    }
    points[i] = last / kRadian;
  }
}

/// How far the trajectory in the bytes is from the plan.
ExportError judged(const Trajectory& trajectory, const YawPlan* yaw, const Vec3& origin, const uint8_t* bytes,
                   int32_t pieces) {
  ExportError error{};
  int32_t last[3] = {read_signed(bytes), read_signed(bytes + 2), read_signed(bytes + 4)};
  int32_t last_yaw = read_signed(bytes + 6);
  int32_t begin = 0;
  const uint8_t* at = bytes + kStartBytes;
  for (int32_t i = 0; i < pieces; ++i) {
    Segment flown;
    double points[kControlPoints];
    read_piece(at, last, flown);
    read_yaw(at, last_yaw, points);
    widen_by_curve(trajectory, flown, origin, begin / kSecond, error);
    widen_by_yaw(yaw, points, begin / kSecond, flown.duration, error);
    begin += at[1] | (at[2] << 8);
    at += piece_bytes(at[0]);
  }
  return error;
}

}  // namespace

Status crazyflie_compressed(const Trajectory& trajectory, const YawPlan* yaw, const Vec3& origin, uint8_t* bytes,
                            int32_t room, int32_t& used, ExportError& error) noexcept {
  Spans spans;
  const int32_t fit = (room - crazyflie_compressed_bytes(0)) / kMostPieceBytes;
  const int32_t most = fit < kMaxSegments ? fit : kMaxSegments;
  if (bytes == nullptr || !cut_spans(trajectory, yaw, most, kShortest, spans)) return Status::kInvalidArgument;
  Writer out{bytes};
  const Vec3 start = trajectory.origin + trajectory.segments[0].points[0] - origin;
  for (int a = 0; a < 3; ++a) out.put(axis(start, a) * kMetre, kLargest);
  out.put(yaw == nullptr ? 0.0 : evaluate(*yaw, 0.0).angle * kRadian, kLargest);
  int32_t begin = 0;
  for (int32_t i = 0; i < spans.count && out.ok; ++i) {
    int32_t end = 0;
    // Times since the beginning are rounded instead of durations, so no piece is more than half a millisecond late.
    out.ok = rounded(spans.at[i].end * kSecond, kLatest, end) && end > begin;
    if (out.ok) put_piece(trajectory, yaw, spans.at[i], begin, end, origin, out);
    begin = end;
  }
  if (!out.ok) return Status::kInvalidArgument;
  for (int i = 0; i < kPieceHead; ++i) *out.at++ = 0;
  used = static_cast<int32_t>(out.at - bytes);
  error = judged(trajectory, yaw, origin, bytes, spans.count);
  return Status::kOk;
}

Status crazyflie_decompressed(const uint8_t* bytes, int32_t count, const Vec3& origin,
                              Trajectory& trajectory) noexcept {
  if (bytes == nullptr || count < kStartBytes + kPieceHead) return Status::kInvalidArgument;
  int32_t last[3] = {read_signed(bytes), read_signed(bytes + 2), read_signed(bytes + 4)};
  trajectory.origin = origin;
  trajectory.count = 0;
  int32_t at = kStartBytes;
  for (int i = 0; i < kMaxSegments; ++i) {
    if (count - at == kPieceHead && bytes[at + 1] == 0 && bytes[at + 2] == 0) break;
    const int32_t size = count > at ? piece_bytes(bytes[at]) : 0;
    if (size == 0 || size > count - at) return Status::kInvalidArgument;
    read_piece(bytes + at, last, trajectory.segments[trajectory.count++]);
    at += size;
  }
  const bool ended = count - at == kPieceHead && bytes[at + 1] == 0 && bytes[at + 2] == 0;
  return ended && trajectory.count > 0 ? Status::kOk : Status::kInvalidArgument;
}

}  // namespace tern
