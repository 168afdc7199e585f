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
  const auto axis = [](double focal, double center, std::int32_t count) {
    const double rounding = 2.0 * kRounding * (absolute(center) + count);
    return Axis{static_cast<float>(focal), static_cast<float>(center + 0.5 - rounding),
                static_cast<float>(center + 0.5 + rounding), static_cast<float>(count),
                static_cast<float>(count) - 0.5f};
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

Projector::Image Projector::image_of(const Axis& axis, Four from, Four to) noexcept {
  return {whole(clamp(from, 0.0f, axis.last)), whole(clamp(to, 0.0f, axis.last)), (to < 0.0f) | (from >= axis.count),
          (from >= 0.0f) & (to < axis.count)};
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
};

Projector::Image Projector::project(const Axis& axis, const Tangents& t) noexcept {
  return image_of(axis, axis.focal * t.least + axis.from, axis.focal * t.most + axis.to);
}

/// Like project(), but for the view of a scan.
Projector::Image Projector::project_bent(const Axis& axis, const Tangents& t) noexcept {
  return image_of(axis, axis.focal * bent(t.least) + axis.from, axis.focal * bent(t.most) + axis.to);
}

inline void Projector::put(PixelBoxes& out, int n, const Image& u, const Image& v) noexcept {
  out.u0[n] = u.first;
  out.u1[n] = u.last;
  out.v0[n] = v.first;
  out.v1[n] = v.last;
}

inline void Projector::put(Cores& out, int n, const Image& u, const Image& v, const Span& span) noexcept {
  put(out.pixels, n, u, v);
  out.far[n] = whole(clamp(span.units, 0.0f, kMostUnits));
  out.ahead[n] = span.near > kNearest;
  out.beside[n] = (span.far <= 0.0f) | (span.units >= kMostUnits) | (out.ahead[n] & (u.beside | v.beside));
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
    put(out.pixels, n, u, v);
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
    const Image u = project_bent(u_, x);
    const Image v = project_bent(v_, y);
    put(out.pixels, n, u, v);
    out.far[n] = whole(clamp(farthest * units_ + 0.05f, 0.0f, kMostUnits)) + 1;
    out.inside[n] = ahead & (reach < kMostReach) & u.within & v.within;
  }
  return out;
}

Cores Projector::cores(const Centers& centers, float size) const noexcept {
  if (reach_ > 0.0f) return cores_around(centers, size);
  Cores out;
  const float between = size - 1.0f;
  for (int n = 0; n < 2; ++n) {
    const Four near = centers.z[n] - between * half_.z;
    const Four far = centers.z[n] + between * half_.z;
    const Four by_near = inverse(near);
    const Four by_far = inverse(far);
    const Image u = project(u_, {centers.x[n], all(between * half_.x), by_near, by_far});
    const Image v = project(v_, {centers.y[n], all(between * half_.y), by_near, by_far});
    const Four deepest = near + half_.z;
    const Four units = (deepest + (growth_ + growth_ahead_ * deepest)) * units_;
    put(out, n, u, v, {near, far, units});
  }
  return out;
}

/// No centre is nearer to the sensor than the box around all centres. A voxel's farthest corner is at least half a
/// voxel further away than its centre.
Cores Projector::cores_around(const Centers& centers, float size) const noexcept {
  Cores out;
  const float between = size - 1.0f;
  const auto least_off = [](Four center, Four half) { return larger(absolute(center) - half, all(0.0f)); };
  for (int n = 0; n < 2; ++n) {
    const Four half_x = all(between * half_.x);
    const Four half_y = all(between * half_.y);
    const Four half_z = all(between * half_.z);
    const Four near = centers.z[n] - half_z;
    const Four far = centers.z[n] + half_z;
    const Four by_near = inverse(near);
    const Four by_far = inverse(far);
    const Image u = project_bent(u_, {centers.x[n], half_x, by_near, by_far});
    const Image v = project_bent(v_, {centers.y[n], half_y, by_near, by_far});
    const Four corner =
        distance(least_off(centers.x[n], half_x), least_off(centers.y[n], half_y), least_off(centers.z[n], half_z)) +
        half_.z;
    const Four units = (corner + (growth_ + growth_ahead_ * corner)) * units_;
    put(out, n, u, v, {near, far, units});
  }
  return out;
}

}  // namespace tern
