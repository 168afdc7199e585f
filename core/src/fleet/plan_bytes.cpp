// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/plan_bytes.hpp"

#include "base/math.hpp"
#include "fleet/bytes.hpp"

namespace tern {
namespace {

/// Units are powers of two: from 61 um, with which a plan may reach 2 m from its origin, to 4 m.
constexpr int kFinest = -14;
constexpr int kCoarsest = 2;
constexpr double kMostUnits = 32767.0;
/// Half a cube's diagonal in its edges, and 10 nm of the finest unit for joints whose two points are not the same.
constexpr double kErrorUnits = kHalfDiagonal + 1.7e-4;
/// m and s: beyond these, sums could lose what they need.
constexpr double kFarthest = 1e9;
constexpr double kShortest = 1e-6;
constexpr double kLongest = 1e6;
/// m: the last control points of a plan that ends at rest are this near to each other.
constexpr double kRestTolerance = 1e-6;

struct Head {
  PlanName name;
  std::int64_t begin;
  Vec3 origin;
  std::int8_t exponent;
  std::uint16_t count;
};

double unit_of(int exponent) {
  double unit = 1.0;
  for (int k = exponent; k < 0; ++k) unit *= 0.5;
  for (int k = 0; k < exponent; ++k) unit *= 2.0;
  return unit;
}

template <typename Bytes, typename PlanHead>
void list_head(Bytes& bytes, PlanHead& head) {
  bytes(head.name.id, head.name.incarnation, head.name.number, head.name.takeover, head.begin, head.origin.x,
        head.origin.y, head.origin.z, head.exponent, head.count);
}

Head read_head(ByteReader& in) {
  Head head{};
  in.skip(1);
  list_head(in, head);
  return head;
}

bool has_times(std::int64_t begin, std::int64_t takeover) {
  return begin >= -kLatest && begin <= takeover && takeover <= kLatest;
}

bool is_duration(double duration) {
  return duration >= kShortest && duration <= kLongest;
}

bool ends_at_rest(const Segment& last) {
  return distance(last.points[kDegree], last.points[kDegree - 1]) <= kRestTolerance &&
         distance(last.points[kDegree - 1], last.points[kDegree - 2]) <= kRestTolerance;
}

/// True for a plan that can be written; `reach` gets its largest coordinate.
bool measure(const Trajectory& plan, double& reach) {
  if (plan.count < 1 || plan.count > kMaxSegments || !is_place(plan.origin)) return false;
  reach = 0.0;
  for (int s = 0; s < plan.count; ++s) {
    if (!is_duration(plan.segments[s].duration)) return false;
    for (const Vec3& point : plan.segments[s].points) {
      if (!is_place(point)) return false;
      for (int a = 0; a < 3; ++a) reach = larger(reach, absolute(axis(point, a)));
    }
  }
  return ends_at_rest(plan.segments[plan.count - 1]);
}

std::int16_t rounded(double units) {
  return static_cast<std::int16_t>(units < 0.0 ? units - 0.5 : units + 0.5);
}

void put_point(const Vec3& point, double unit, ByteWriter& out) {
  for (int a = 0; a < 3; ++a) out.put(rounded(axis(point, a) / unit));
}

void put_points(const Trajectory& plan, double unit, ByteWriter& out) {
  put_point(plan.segments[0].points[0], unit, out);
  for (int s = 0; s < plan.count; ++s) {
    for (int k = 1; k < kControlPoints; ++k) put_point(plan.segments[s].points[k], unit, out);
  }
}

/// True if the segments meet so exactly that the one point that is sent for two is right for both.
bool is_joined(const Trajectory& plan, double unit) {
  for (int s = 1; s < plan.count; ++s) {
    const double apart = distance(plan.segments[s - 1].points[kDegree], plan.segments[s].points[0]);
    if (!(apart <= (kErrorUnits - kHalfDiagonal) * unit)) return false;
  }
  return true;
}

/// The finest unit that suits a plan; beyond kCoarsest if none does.
int exponent_for(const Trajectory& plan) {
  double reach = 0.0;
  if (!measure(plan, reach)) return kCoarsest + 1;
  int exponent = kFinest;
  for (; exponent <= kCoarsest; ++exponent) {
    const double unit = unit_of(exponent);
    if (reach <= kMostUnits * unit && is_joined(plan, unit)) break;
  }
  return exponent;
}

/// m/s: no part of the curve is faster, because its hodograph lies in the hull of these points.
double largest_speed(const TrackPiece& piece) {
  double most = 0.0;
  for (int k = 0; k < kDegree; ++k) most = larger(most, distance(piece.points[k + 1], piece.points[k]));
  return most * (kDegree / piece.duration);
}

}  // namespace

bool is_place(const Vec3& place) noexcept {
  return absolute(place.x) <= kFarthest && absolute(place.y) <= kFarthest && absolute(place.z) <= kFarthest;
}

bool is_sendable(const Trajectory& plan, std::int64_t takeover) noexcept {
  return has_times(plan.begin, takeover) && exponent_for(plan) <= kCoarsest;
}

std::int32_t write_plan(const Trajectory& plan, const PlanName& name, std::uint8_t* bytes) noexcept {
  if (!is_sendable(plan, name.takeover)) return 0;
  const int exponent = exponent_for(plan);
  ByteWriter out(bytes);
  const Head head{name, plan.begin, plan.origin, static_cast<std::int8_t>(exponent),
                  static_cast<std::uint16_t>(plan.count)};
  out.put(form_of(MessageKind::kPlan));
  list_head(out, head);
  for (int s = 0; s < plan.count; ++s) out.put(plan.segments[s].duration);
  put_points(plan, unit_of(exponent), out);
  return out.size();
}

bool is_plan(const std::uint8_t* bytes, std::int32_t size) noexcept {
  if (size < plan_bytes(1) || bytes[0] != form_of(MessageKind::kPlan)) return false;
  ByteReader in(bytes, size);
  const Head head = read_head(in);
  if (head.count < 1 || head.count > kMaxSegments || size != plan_bytes(head.count)) return false;
  bool sound = is_place(head.origin) && has_times(head.begin, head.name.takeover) && head.name.number > 0 &&
               head.exponent >= kFinest && head.exponent <= kCoarsest;
  for (int s = 0; s < head.count; ++s) {
    double duration = 0.0;
    in.get(duration);
    sound = sound && is_duration(duration);
  }
  return sound;
}

PlanName read_name(const std::uint8_t* bytes, std::int32_t size) noexcept {
  ByteReader in(bytes, size);
  return read_head(in).name;
}

std::int32_t read_piece_count(const std::uint8_t* bytes, std::int32_t size) noexcept {
  ByteReader in(bytes, size);
  return read_head(in).count;
}

void read_plan(const std::uint8_t* bytes, std::int32_t size, std::int64_t clock_error, TrackPiece* pieces,
               Track& track) noexcept {
  ByteReader durations(bytes, size);
  const Head head = read_head(durations);
  ByteReader points(bytes, size);
  points.skip(kPlanHeadBytes + 8 * head.count);
  const double unit = unit_of(head.exponent);
  const std::int32_t waits = clock_error > 0 ? 1 : 0;
  double speed = 0.0;
  Vec3 point{};
  for (int s = 0; s < head.count; ++s) {
    TrackPiece& piece = pieces[waits + s];
    durations.get(piece.duration);
    for (int k = 0; k < kControlPoints; ++k) {
      for (int a = 0; (s == 0 || k > 0) && a < 3; ++a) {
        std::int16_t units = 0;
        points.get(units);
        axis(point, a) = unit * units;
      }
      piece.points[k] = point;
    }
    speed = larger(speed, largest_speed(piece));
  }
  const double wait = 1e-9 * static_cast<double>(clock_error);
  if (waits > 0) {
    pieces[0].duration = wait;
    for (Vec3& at : pieces[0].points) at = pieces[1].points[0];
  }
  track = Track{};
  track.measured = head.begin - clock_error;
  track.position = head.origin;
  track.pieces = pieces;
  track.piece_count = waits + head.count;
  track.id = head.name.id;
  track.error = kErrorUnits * unit + speed * wait;
}

}  // namespace tern
