// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "view/projector.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// Relative error of a few roundings in single precision, 2^-20. Each is at most 2^-24.
constexpr double kRounding = 1.0 / 1048576.0;
/// The least depth that is projected, metres.
constexpr float kNearest = 1e-3f;
/// More than the depth of any pixel.
constexpr float kMostUnits = static_cast<float>(kDepthUnits + 1);
/// A scan's view: half its width, its bend, and the sine of the largest angle by which an outline is widened, seen
/// along z.
constexpr float kWidest = static_cast<float>(kFaceTangent);
constexpr float kBend = static_cast<float>(kFaceBend);
constexpr float kMostReach = 0.5f;
/// Of the pixels that footprints have in common, so many are looked at to each side of the middle one.
constexpr std::int32_t kCommon = 2;
static_assert(2 * kCommon < kCloseEntries, "reaches() is exact");
/// sqrt(1 + t^2) <= 1 + kSlant * t for t up to kWidest.
constexpr float kSlant = 0.5352f;
/// 1 - sqrt(1 - r^2) <= kBulge * r for r up to kMostReach.
constexpr float kBulge = 0.27f;

Point to_point(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The inverse of a depth, and of kNearest for depths below it.
Four inverse(Four depth) {
  return 1.0f / larger(depth, all(kNearest));
}

Four distance(Four x, Four y, Four z) {
  return square_root(x * x + y * y + z * z);
}

/// The most by which a tangent differs from t if its direction is a small angle away. `reach` is the angle's sine times
/// the distance of a point at t over its depth. The exact difference is at most r s^2 / (sqrt(s^2 - r^2) - |t| r), with
/// r = reach and s = sqrt(1 + t^2).
Four widening(Four t, Four reach) {
  const Four aside = smaller(absolute(t), all(kWidest));
  return reach * (1.0f + kSlant * aside) / (1.0f - (kBulge + aside) * reach);
}

Four bent(Four t) {
  return t / (1.0f + kBend * absolute(t));
}

FourInts later(const FourInts& x, const FourInts& y) {
  return choose(x < y, y, x);
}
FourInts earlier(const FourInts& x, const FourInts& y) {
  return choose(x < y, x, y);
}
}  // namespace

Projector::Projector(const View& view, double extent) noexcept {
  Vec3 half = kZero;
  for (int a = 0; a < 3; ++a) {
    const Vec3& s = view.steps[a];
    steps_[a] = to_point(s);
    half = half + 0.5 * Vec3{absolute(s.x), absolute(s.y), absolute(s.z)};
  }
  half_ = to_point(half);
  growth_ = static_cast<float>(view.growth + kRounding * extent);
  growth_ahead_ = static_cast<float>(view.growth_ahead);
  reach_ = static_cast<float>(view.reach);
  units_ = static_cast<float>(view.units);
  const bool around = view.reach > 0.0;
  const auto axis = [around](double focal, double center, std::int32_t count) {
    const double rounding = 2.0 * kRounding * (absolute(center) + count);
    const double least = around ? -kFaceTangent : (-0.5 - center - rounding) / focal;
    const double most = around ? kFaceTangent : (count - 0.5 - center + rounding) / focal;
    const double slack = 4.0 * kRounding * (most - least);
    return Axis{static_cast<float>(focal),
                static_cast<float>(center + 0.5 - rounding),
                static_cast<float>(center + 0.5 + rounding),
                static_cast<float>(count),
                static_cast<float>(count) - 0.5f,
                static_cast<float>(least - slack),
                static_cast<float>(most + slack)};
  };
  u_ = axis(view.fx, view.cx, view.width);
  v_ = axis(view.fy, view.cy, view.height);
}

Centers Projector::parts(const Point& center, float size) const noexcept {
  const float h = 0.5f * size;
  const Four along_x = Four{-h, h, -h, h};
  const Four along_y = Four{-h, -h, h, h};
  const auto on = [&](float c, float x, float y, float z, Four(&out)[2]) {
    const Four plane = c + (along_x * x + along_y * y);
    out[0] = plane - h * z;
    out[1] = plane + h * z;
  };
  Centers centers;
  on(center.x, steps_[0].x, steps_[1].x, steps_[2].x, centers.x);
  on(center.y, steps_[0].y, steps_[1].y, steps_[2].y, centers.y);
  on(center.z, steps_[0].z, steps_[1].z, steps_[2].z, centers.z);
  return centers;
}

Centers Projector::row(const Point& center, float size) const noexcept {
  const Four places[2] = {size * Four{-3.5f, -2.5f, -1.5f, -0.5f}, size * Four{0.5f, 1.5f, 2.5f, 3.5f}};
  Centers centers;
  for (int n = 0; n < 2; ++n) {
    centers.x[n] = center.x + places[n] * steps_[0].x;
    centers.y[n] = center.y + places[n] * steps_[0].y;
    centers.z[n] = center.z + places[n] * steps_[0].z;
  }
  return centers;
}

/// The least and the greatest tangent of a box of depths near .. far.
struct Projector::Tangents {
  Four least, most;

  Tangents(Four center, Four half, Four by_near, Four by_far) noexcept {
    const Four lower = center - half;
    const Four upper = center + half;
    least = lower * choose(lower < 0.0f, by_near, by_far);
    most = upper * choose(upper < 0.0f, by_far, by_near);
  }
  void widen(Four reach) noexcept {
    least = least - widening(least, reach);
    most = most + widening(most, reach);
  }
  /// As widen(), for a box that ends before it begins. `least` may become larger than `most`, and each is moved by no
  /// more than any larger tangent, or any smaller one, would be.
  void close(Four reach) noexcept {
    least = least + widening(larger(least, all(0.0f)), reach);
    most = most - widening(smaller(most, all(0.0f)), reach);
  }
};

/// Where a tangent is in the image, in pixels from its middle.
inline Four Projector::place_of(const Axis& axis, Four tangent) const noexcept {
  return axis.focal * (reach_ > 0.0f ? bent(tangent) : tangent);
}

Projector::Image Projector::project(const Axis& axis, const Tangents& t) const noexcept {
  const Four from = place_of(axis, t.least) + axis.from;
  const Four to = place_of(axis, t.most) + axis.to;
  return {whole(clamp(from, 0.0f, axis.last)), whole(clamp(to, 0.0f, axis.last)), (from >= 0.0f) & (to < axis.count)};
}

/// Not 0 if all centres are outside of the image. Each is at most `far` ahead, and perhaps not at all.
FourInts Projector::aside(const Axis& axis, Four center, Four half, Four far) noexcept {
  return (center + half < smaller(axis.least * far, all(0.0f))) | (center - half > larger(axis.most * far, all(0.0f)));
}

bool Projector::misses(const Point& center, const Point& size) const noexcept {
  const auto half = [&](float x, float y, float z) {
    return 0.5f * (size.x * __builtin_fabsf(x) + size.y * __builtin_fabsf(y) + size.z * __builtin_fabsf(z));
  };
  const float far = center.z + half(steps_[0].z, steps_[1].z, steps_[2].z);
  const float aside = half(steps_[0].x, steps_[1].x, steps_[2].x);
  const float below = half(steps_[0].y, steps_[1].y, steps_[2].y);
  const auto outside = [far](const Axis& axis, float middle, float reach) {
    const float least = axis.least * far;
    const float most = axis.most * far;
    return middle + reach < (least < 0.0f ? least : 0.0f) || middle - reach > (most > 0.0f ? most : 0.0f);
  };
  return far <= 0.0f || outside(u_, center.x, aside) || outside(v_, center.y, below);
}

/// All footprints begin before the greatest of `t`, and end behind the least.
Projector::Meeting Projector::meet(const Axis& axis, const Tangents& t) const noexcept {
  const Four end = place_of(axis, t.least) + axis.from;
  const Four begin = place_of(axis, t.most) + axis.to;
  return {whole(clamp(smaller(begin, end), 0.0f, axis.last)), whole(clamp(larger(begin, end), 0.0f, axis.last)),
          begin <= end, (begin < 0.0f) | (end >= axis.count)};
}

inline void Projector::put(PixelBoxes& out, int n, FourInts u0, FourInts u1, FourInts v0, FourInts v1) noexcept {
  out.u0[n] = u0;
  out.u1[n] = u1;
  out.v0[n] = v0;
  out.v1[n] = v1;
}

/// Where only one axis has pixels in common, one of these will do.
inline void Projector::put(Cores& out, int n, const Meeting& u, const Meeting& v) noexcept {
  out.common[n] = u.common & v.common;
  const FourInts across = (u.first + u.last) >> 1;
  const FourInts down = (v.first + v.last) >> 1;
  const auto from = [&](const Meeting& m, FourInts middle) {
    return choose(m.common, choose(out.common[n], later(m.first, middle - kCommon), middle), m.first);
  };
  const auto to = [&](const Meeting& m, FourInts middle) {
    return choose(m.common, choose(out.common[n], earlier(m.last, middle + kCommon), middle), m.last);
  };
  put(out.pixels, n, from(u, across), to(u, across), from(v, down), to(v, down));
}

Footprints Projector::footprints(const Centers& centers, float size) const noexcept {
  if (reach_ > 0.0f) return footprints_around(centers, size);
  Footprints out;
  for (int n = 0; n < 2; ++n) {
    const Four deepest = centers.z[n] + size * half_.z;
    const Four grown = growth_ + growth_ahead_ * deepest;
    const Four far = deepest + grown;
    const Four near = centers.z[n] - size * half_.z - grown;
    const FourInts ahead = near > kNearest;
    const Four by_near = inverse(near);
    const Four by_far = inverse(far);
    const Image u = project(u_, {centers.x[n], size * half_.x + grown, by_near, by_far});
    const Image v = project(v_, {centers.y[n], size * half_.y + grown, by_near, by_far});
    put(out.pixels, n, u.first, u.last, v.first, v.last);
    out.far[n] = whole(clamp(far * units_ + 0.05f, 0.0f, kMostUnits)) + 1;
    out.inside[n] = ahead & u.within & v.within;
  }
  return out;
}

Footprints Projector::footprints_around(const Centers& centers, float size) const noexcept {
  Footprints out;
  for (int n = 0; n < 2; ++n) {
    const Four corner = distance(absolute(centers.x[n]) + size * half_.x, absolute(centers.y[n]) + size * half_.y,
                                 absolute(centers.z[n]) + size * half_.z);
    const Four grown = growth_ + growth_ahead_ * corner;
    const Four farthest = corner + grown;
    const Four near = centers.z[n] - size * half_.z - grown;
    const Four far = centers.z[n] + size * half_.z + grown;
    const FourInts ahead = near > kNearest;
    const Four by_near = inverse(near);
    const Four by_far = inverse(far);
    const Four reach = reach_ * farthest * by_near;
    const Four bounded = smaller(reach, all(kMostReach));
    Tangents x(centers.x[n], size * half_.x + grown, by_near, by_far);
    Tangents y(centers.y[n], size * half_.y + grown, by_near, by_far);
    x.widen(bounded);
    y.widen(bounded);
    const Image u = project(u_, x);
    const Image v = project(v_, y);
    put(out.pixels, n, u.first, u.last, v.first, v.last);
    out.far[n] = whole(clamp(farthest * units_ + 0.05f, 0.0f, kMostUnits)) + 1;
    out.inside[n] = ahead & (reach < kMostReach) & u.within & v.within;
  }
  return out;
}

/// A footprint begins half a voxel and more before its voxel's centre, and ends as far behind it. So each one meets
/// what lies between the first end and the last beginning. No centre is nearer to the sensor than the box around all
/// centres. A voxel's farthest corner is at least half a voxel further away than its centre.
Cores Projector::cores(const Centers& centers, float size) const noexcept {
  Cores out;
  const float between = size - 1.0f;
  const bool around = reach_ > 0.0f;
  const auto least_off = [](Four center, Four half) { return larger(absolute(center) - half, all(0.0f)); };
  for (int n = 0; n < 2; ++n) {
    const Four half[3] = {all(between * half_.x), all(between * half_.y), all(between * half_.z)};
    const Four near = centers.z[n] - half[2];
    const Four far = centers.z[n] + half[2];
    const Four by_near = inverse(near);
    const Four by_far = inverse(far);
    const Four nearest = around ? distance(least_off(centers.x[n], half[0]), least_off(centers.y[n], half[1]),
                                           least_off(centers.z[n], half[2]))
                                : near;
    const Four corner = nearest + half_.z;
    const Four grown = growth_ + growth_ahead_ * corner;
    const Four last = far - half_.z - grown;
    Tangents x(centers.x[n], half[0] - half_.x - grown, by_near, by_far);
    Tangents y(centers.y[n], half[1] - half_.y - grown, by_near, by_far);
    const Four reach = reach_ * corner * inverse(last);
    if (around) {
      x.close(smaller(reach, all(kMostReach)));
      y.close(smaller(reach, all(kMostReach)));
    }
    const Meeting u = meet(u_, x);
    const Meeting v = meet(v_, y);
    const Four units = (corner + grown) * units_;
    out.far[n] = whole(clamp(units, 0.0f, kMostUnits));
    out.ahead[n] = near > kNearest;
    out.beside[n] = (last <= kNearest) | (reach >= kMostReach) | (units >= kMostUnits) |
                    aside(u_, centers.x[n], half[0], far) | aside(v_, centers.y[n], half[1], far) |
                    (out.ahead[n] & (u.beside | v.beside));
    put(out, n, u, v);
  }
  return out;
}

}  // namespace tern
