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
/// More than any pixel measures.
constexpr float kMostUnits = static_cast<float>(kDepthUnits + 1);

Point to_point(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
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

Projector::Image Projector::project_axis(const Axis& axis, Four center, Four half, Four by_near, Four by_far) noexcept {
  const Four lower = center - half;
  const Four upper = center + half;
  const Four from = axis.focal * (lower * (lower < 0.0f ? by_near : by_far)) + axis.from;
  const Four to = axis.focal * (upper * (upper < 0.0f ? by_far : by_near)) + axis.to;
  return {whole(clamp(from, 0.0f, axis.last)), whole(clamp(to, 0.0f, axis.last)), (to < 0.0f) | (from >= axis.count),
          (from >= 0.0f) & (to < axis.count)};
}

Footprints Projector::footprints(const Centers& centers, float size) const noexcept {
  Footprints out;
  for (int n = 0; n < 2; ++n) {
    const Four deepest = centers.z[n] + size * half_.z;
    const Four grown = growth_ + growth_ahead_ * deepest;
    const Four far = deepest + grown;
    const Four near = centers.z[n] - size * half_.z - grown;
    const FourInts ahead = near > kNearest;
    const Four by_near = 1.0f / (near > kNearest ? near : all(kNearest));
    const Four by_far = 1.0f / (far > kNearest ? far : all(kNearest));
    const Image u = project_axis(u_, centers.x[n], size * half_.x + grown, by_near, by_far);
    const Image v = project_axis(v_, centers.y[n], size * half_.y + grown, by_near, by_far);
    out.pixels.u0[n] = u.first;
    out.pixels.u1[n] = u.last;
    out.pixels.v0[n] = v.first;
    out.pixels.v1[n] = v.last;
    out.far[n] = whole(clamp(far * units_ + 0.05f, 0.0f, kMostUnits)) + 1;
    out.inside[n] = ahead & u.within & v.within;
  }
  return out;
}

Cores Projector::cores(const Centers& centers, float size) const noexcept {
  Cores out;
  const float between = size - 1.0f;
  for (int n = 0; n < 2; ++n) {
    const Four near = centers.z[n] - between * half_.z;
    const Four far = centers.z[n] + between * half_.z;
    const Four by_near = 1.0f / (near > kNearest ? near : all(kNearest));
    const Four by_far = 1.0f / (far > kNearest ? far : all(kNearest));
    const Image u = project_axis(u_, centers.x[n], all(between * half_.x), by_near, by_far);
    const Image v = project_axis(v_, centers.y[n], all(between * half_.y), by_near, by_far);
    const Four deepest = near + half_.z;
    const Four units = (deepest + (growth_ + growth_ahead_ * deepest)) * units_;
    out.pixels.u0[n] = u.first;
    out.pixels.u1[n] = u.last;
    out.pixels.v0[n] = v.first;
    out.pixels.v1[n] = v.last;
    out.far[n] = whole(clamp(units, 0.0f, kMostUnits));
    out.ahead[n] = near > kNearest;
    out.beside[n] = (far <= 0.0f) | (units >= kMostUnits) | (out.ahead[n] & (u.beside | v.beside));
  }
  return out;
}

}  // namespace tern
