// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The Crazyflie's compressed trajectories: int16 control points, millimetres and tenths of a degree, one byte of types
// a piece. Polynomials of degree 0 and 7 are used of the four that there are.
#include "base/math.hpp"
#include "export/yaw_piece.hpp"
#include "tern/export.hpp"
#include "yaw/angle.hpp"

namespace tern {
namespace {

constexpr double kMetre = 1000.0;         // millimetres
constexpr double kRadian = 1800.0 / kPi;  // tenths of a degree
constexpr double kSecond = 1000.0;        // milliseconds
constexpr double kLargest = 32767.0;
constexpr double kLongest = 65535.0;
constexpr int kStartBytes = 8;
constexpr int kPieceHead = 3;  // types and duration
constexpr int kFull = 3;       // type of a polynomial of degree 7
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

double coordinate(const Trajectory& trajectory, const Segment& segment, int a, int i) {
  return axis(segment.points[i], a) + axis(trajectory.origin, a);
}

void put_piece(const Trajectory& trajectory, const YawPlan* yaw, const Segment& segment, double begin, Writer& out) {
  *out.at++ = static_cast<uint8_t>(kAllFull | (yaw != nullptr ? kYawFull : 0));
  out.ok = segment.duration * kSecond >= 1.0 && out.ok;
  out.put(segment.duration * kSecond, kLongest);
  for (int a = 0; a < 3; ++a) {
    for (int i = 1; i < kControlPoints; ++i) out.put(coordinate(trajectory, segment, a, i) * kMetre, kLargest);
  }
  if (yaw == nullptr) return;
  double points[kControlPoints];
  yaw_piece(yaw, begin, segment.duration, points);
  for (int i = 1; i < kControlPoints; ++i) out.put(points[i] * kRadian, kLargest);
}

int32_t read_signed(const uint8_t* at) {
  const int32_t value = at[0] | (at[1] << 8);
  return value < 32768 ? value : value - 65536;
}

/// Bytes of a piece with these types, or 0 where it is none of ours.
int32_t piece_bytes(uint8_t types) {
  if ((types & ~kYawFull) != kAllFull) return 0;
  const bool has_yaw = (types & kYawFull) == kYawFull;
  if (!has_yaw && (types & kYawFull) != 0) return 0;
  return kPieceHead + 2 * kDegree * (has_yaw ? 4 : 3);
}

/// Reads one piece; `last` is where the one before ended, millimetres, and where this one ends afterwards.
void read_piece(const uint8_t* at, int32_t (&last)[3], Segment& segment) {
  segment.duration = (at[1] | (at[2] << 8)) / kSecond;
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

}  // namespace

Status crazyflie_compressed(const Trajectory& trajectory, const YawPlan* yaw, uint8_t* bytes, int32_t room,
                            int32_t& used) noexcept {
  const bool plan = trajectory.count > 0 && trajectory.count <= kMaxSegments;
  if (!plan || bytes == nullptr || room < crazyflie_compressed_bytes(trajectory.count)) return Status::kInvalidArgument;
  Writer out{bytes};
  for (int a = 0; a < 3; ++a) out.put(coordinate(trajectory, trajectory.segments[0], a, 0) * kMetre, kLargest);
  out.put(yaw == nullptr ? 0.0 : evaluate(*yaw, 0.0).angle * kRadian, kLargest);
  double begin = 0.0;
  for (int32_t i = 0; i < trajectory.count && out.ok; ++i) {
    put_piece(trajectory, yaw, trajectory.segments[i], begin, out);
    begin += trajectory.segments[i].duration;
  }
  if (!out.ok) return Status::kInvalidArgument;
  for (int i = 0; i < kPieceHead; ++i) *out.at++ = 0;
  used = static_cast<int32_t>(out.at - bytes);
  return Status::kOk;
}

Status crazyflie_decompressed(const uint8_t* bytes, int32_t count, const Trajectory& original,
                              Trajectory& trajectory) noexcept {
  if (bytes == nullptr || count < kStartBytes + kPieceHead) return Status::kInvalidArgument;
  int32_t last[3] = {read_signed(bytes), read_signed(bytes + 2), read_signed(bytes + 4)};
  trajectory.origin = {0.0, 0.0, 0.0};
  trajectory.count = 0;
  int32_t at = kStartBytes;
  for (int i = 0; i < kMaxSegments; ++i) {
    if (count - at == kPieceHead && bytes[at + 1] == 0 && bytes[at + 2] == 0) break;
    const int32_t size = count > at ? piece_bytes(bytes[at]) : 0;
    if (size == 0 || size > count - at) return Status::kInvalidArgument;
    Segment& segment = trajectory.segments[trajectory.count++];
    read_piece(bytes + at, last, segment);
    segment.polyhedron = i < original.count ? original.segments[i].polyhedron : 0;
    at += size;
  }
  const bool ended = count - at == kPieceHead && bytes[at + 1] == 0 && bytes[at + 2] == 0;
  return ended && trajectory.count > 0 ? Status::kOk : Status::kInvalidArgument;
}

}  // namespace tern
