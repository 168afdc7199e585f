// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/facet.hpp"

namespace tern {
namespace {

/// The distance by which a point of the facet lies beyond the cutting plane: a linear function of the facet's
/// coordinates.
struct Excess {
  double constant;
  double along_u;
  double along_v;

  double at(const Vector2& corner) const { return (constant + along_u * corner[0]) + along_v * corner[1]; }
};

/// Corners first .. last in the order around the facet. The run may wrap around the end of the list.
struct Run {
  int first;
  int last;
};

int after(int k, int count) {
  return k + 1 == count ? 0 : k + 1;
}

int before(int k, int count) {
  return k == 0 ? count - 1 : k - 1;
}

/// The run of corners beyond the plane that contains the furthest one. There is a second run only because of rounding,
/// on a very thin polygon. It stays, so that the cut does not remove more than it should.
Run run_about(int furthest, const double* beyond, int count) {
  Run run{furthest, furthest};
  for (int k = 1; k < count && beyond[before(run.first, count)] > 0.0; ++k) run.first = before(run.first, count);
  for (int k = 1; k < count && beyond[after(run.last, count)] > 0.0; ++k) run.last = after(run.last, count);
  return run;
}

bool in_run(const Run& run, int k) {
  return run.first <= run.last ? k >= run.first && k <= run.last : k >= run.first || k <= run.last;
}

/// Removes the run, and adds a corner on each of the two edges that cross the plane.
void keep_within(const double* beyond, const Run& run, Facet& facet) {
  Facet left;
  left.count = 0;
  for (int k = 0; k < facet.count; ++k) {
    const int next = after(k, facet.count);
    if (!in_run(run, k)) left.corner[left.count++] = facet.corner[k];
    if (in_run(run, k) == in_run(run, next)) continue;
    const double share = beyond[k] / (beyond[k] - beyond[next]);
    left.corner[left.count++] = facet.corner[k] + share * (facet.corner[next] - facet.corner[k]);
  }
  facet.count = left.count;
  for (int k = 0; k < left.count; ++k) facet.corner[k] = left.corner[k];
}

}  // namespace

Facet square_on(const Halfspace& plane, double reach) noexcept {
  Facet facet;
  facet.foot = plane.offset * plane.normal;
  facet.u = perpendicular(plane.normal);
  facet.v = cross(plane.normal, facet.u);
  facet.count = 4;
  for (int k = 0; k < 4; ++k) facet.corner[k] = Vector2(k == 0 || k == 3 ? -reach : reach, k < 2 ? -reach : reach);
  return facet;
}

bool cut(const Halfspace& by, Facet& facet, double slack) noexcept {
  const Excess excess{dot(by.normal, facet.foot) - by.offset, dot(by.normal, facet.u), dot(by.normal, facet.v)};
  double beyond[kMaxCuts + 4];
  beyond[0] = excess.at(facet.corner[0]);
  int furthest = 0;
  int nearest = 0;
  for (int k = 1; k < facet.count; ++k) {
    beyond[k] = excess.at(facet.corner[k]);
    if (beyond[k] > beyond[furthest]) furthest = k;
    if (beyond[k] < beyond[nearest]) nearest = k;
  }
  if (!(beyond[furthest] > slack)) return true;
  if (beyond[nearest] > 0.0) return false;
  keep_within(beyond, run_about(furthest, beyond, facet.count), facet);
  return true;
}

}  // namespace tern
