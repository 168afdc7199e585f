// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/facet.hpp"

namespace tern {
namespace {

/// Beyond `by` by so much, in the facet's coordinates: linear in them.
struct Excess {
  double constant;
  double along_u;
  double along_v;

  double at(const Facet& facet, int k) const { return (constant + along_u * facet.at_u[k]) + along_v * facet.at_v[k]; }
};

}  // namespace

Facet square_on(const Halfspace& plane, double reach) noexcept {
  Facet facet;
  facet.foot = plane.offset * plane.normal;
  facet.u = perpendicular(plane.normal);
  facet.v = cross(plane.normal, facet.u);
  facet.count = 4;
  for (int k = 0; k < 4; ++k) {
    facet.at_u[k] = k == 0 || k == 3 ? -reach : reach;
    facet.at_v[k] = k < 2 ? -reach : reach;
  }
  return facet;
}

bool cut(const Halfspace& by, Facet& facet) noexcept {
  const Excess excess{dot(by.normal, facet.foot) - by.offset, dot(by.normal, facet.u), dot(by.normal, facet.v)};
  double beyond[kMaxCuts + 4];
  int outside = 0;
  for (int k = 0; k < facet.count; ++k) {
    beyond[k] = excess.at(facet, k);
    if (beyond[k] > 0.0) ++outside;
  }
  if (outside == 0) return true;
  if (outside == facet.count) return false;
  Facet left;
  left.count = 0;
  int crossings = 0;  // rounding may make a hair's breadth of a polygon cross more often: two are enough
  for (int k = 0; k < facet.count; ++k) {
    const int next = k + 1 == facet.count ? 0 : k + 1;
    if (beyond[k] <= 0.0) {
      left.at_u[left.count] = facet.at_u[k];
      left.at_v[left.count++] = facet.at_v[k];
    }
    if ((beyond[k] > 0.0) == (beyond[next] > 0.0) || ++crossings > 2) continue;
    const double share = beyond[k] / (beyond[k] - beyond[next]);
    left.at_u[left.count] = facet.at_u[k] + share * (facet.at_u[next] - facet.at_u[k]);
    left.at_v[left.count++] = facet.at_v[k] + share * (facet.at_v[next] - facet.at_v[k]);
  }
  facet.count = left.count;
  for (int k = 0; k < left.count; ++k) {
    facet.at_u[k] = left.at_u[k];
    facet.at_v[k] = left.at_v[k];
  }
  return true;
}

}  // namespace tern
