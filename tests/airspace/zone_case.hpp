// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A zone with the frame and the settings that it is fitted in, and what its fences allow.
#ifndef TERN_TESTS_AIRSPACE_ZONE_CASE_HPP
#define TERN_TESTS_AIRSPACE_ZONE_CASE_HPP

#include <algorithm>
#include <cmath>

#include "host/airspace/zone_fences.hpp"

namespace tern_test {

using tern_host::FittedFence;
using tern_host::FittedZone;
using tern_host::GeoPoint;
using tern_host::HeightReference;
using tern_host::LocalFrame;
using tern_host::Plan2;
using tern_host::ZoneArea;
using tern_host::ZoneHeights;
using tern_host::ZoneKind;

struct ZoneCase {
  LocalFrame frame;
  ZoneHeights heights;
  tern_host::FitSettings settings;
  tern_host::Zone zone;
};

inline bool within_fence(const FittedFence& fence, const tern::Vec3& p) {
  return std::all_of(fence.planes.begin(), fence.planes.end(), [&p](const tern::Halfspace& h) {
    return h.normal.x * p.x + h.normal.y * p.y + h.normal.z * p.z <= h.offset;
  });
}

/// May a point be there, for all fences?
inline bool allowed(const FittedZone& fitted, const tern::Vec3& p) {
  return std::all_of(fitted.fences.begin(), fitted.fences.end(), [&p](const FittedFence& fence) {
    return within_fence(fence, p) == (fence.kind == tern::FenceKind::kKeepIn);
  });
}

/// A square of 200 m about the origin, at 47 degrees north.
inline ZoneCase square_case(ZoneKind kind, const tern_host::HeightSources& sources, double height = 400.0) {
  const tern_host::GeoPosition origin{{47.0, 8.0}, height};
  ZoneCase c{LocalFrame({origin.point, 0.0}), ZoneHeights(origin, sources), {}, {}};
  c.settings.boundary = {{-500.0, -500.0, 0.0}, {500.0, 500.0, 150.0}};
  c.zone.kind = kind;
  c.zone.edges = tern_host::EdgeRule::kGeodesic;
  ZoneArea area;
  for (const Plan2& p : {Plan2{-100, -100}, Plan2{100, -100}, Plan2{100, 100}, Plan2{-100, 100}})
    area.ring.push_back(c.frame.point(p));
  c.zone.areas.push_back(area);
  return c;
}

}  // namespace tern_test

#endif
