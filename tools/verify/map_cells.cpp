// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What clouds and octrees make of voxels (docs/formats.md): those with a point in them, those that an occupied leaf
// meets, and, where the unknown is solid, those of which no octree says that all is free.
#include <algorithm>
#include <cmath>

#include "verify/solids.hpp"

namespace tern_verify {
namespace {

constexpr double kMostVoxels = 134217728;  // 2^27: a bit and a number of free cubes each

/// A bit for each voxel of the grid.
class Voxels {
 public:
  explicit Voxels(const Lattice& lattice)
      : dims_(lattice.dims), bits_(static_cast<std::size_t>(dims_[0] * dims_[1] * dims_[2]), false) {}

  std::size_t index(long x, long y, long z) const {
    return static_cast<std::size_t>((z * dims_[1] + y) * dims_[0] + x);
  }
  std::size_t size() const { return bits_.size(); }
  bool at(std::size_t i) const { return bits_[i]; }
  void set(std::size_t i) { bits_[i] = true; }
  void set(const Cells& c) {
    each_row(c, [&](std::size_t begin, std::size_t end) {
      std::fill(bits_.begin() + static_cast<long>(begin), bits_.begin() + static_cast<long>(end), true);
      return true;
    });
  }

  /// Takes them all away, as cuboids: each as long as it can be along x, then along y, then along z.
  std::vector<Cells> take() {
    std::vector<Cells> cuboids;
    for (long z = 0; z < dims_[2]; ++z) {
      for (long y = 0; y < dims_[1]; ++y) {
        for (long x = 0; x < dims_[0]; ++x) {
          if (bits_[index(x, y, z)]) cuboids.push_back(take({{x, y, z}, {x + 1, y + 1, z + 1}}));
        }
      }
    }
    return cuboids;
  }

 private:
  /// As long as `visit` says true of the rows of a cuboid.
  template <typename Visit>
  bool each_row(const Cells& c, Visit visit) const {
    for (long z = c.begin[2]; z < c.end[2]; ++z) {
      for (long y = c.begin[1]; y < c.end[1]; ++y) {
        const std::size_t row = index(c.begin[0], y, z);
        if (!visit(row, row + static_cast<std::size_t>(c.end[0] - c.begin[0]))) return false;
      }
    }
    return true;
  }

  Cells take(Cells cuboid) {
    for (std::size_t a = 0; a < 3; ++a) {
      while (cuboid.end[a] < dims_[a]) {
        Cells layer = cuboid;
        layer.begin[a] = cuboid.end[a];
        layer.end[a] = cuboid.end[a] + 1;
        const bool full = each_row(layer, [&](std::size_t begin, std::size_t end) {
          const auto first = bits_.begin() + static_cast<long>(begin);
          return std::find(first, first + static_cast<long>(end - begin), false) ==
                 first + static_cast<long>(end - begin);
        });
        if (!full) break;
        ++cuboid.end[a];
      }
    }
    each_row(cuboid, [&](std::size_t begin, std::size_t end) {
      std::fill(bits_.begin() + static_cast<long>(begin), bits_.begin() + static_cast<long>(end), false);
      return true;
    });
    return cuboid;
  }

  std::array<long, 3> dims_;
  std::vector<bool> bits_;
};

bool meets(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.lower[i] >= b.upper[i] || a.upper[i] <= b.lower[i]) return false;
  }
  return true;
}

Box box_of(const Octree& tree, const Leaf& leaf) {
  Box box;
  for (std::size_t a = 0; a < 3; ++a) {
    box.lower[a] = static_cast<double>(leaf.key[a] - 32768) * tree.resolution;
    box.upper[a] = static_cast<double>(leaf.key[a] + leaf.size - 32768) * tree.resolution;
  }
  return box;
}

/// The voxel of a point, counted from `origin`; its lower faces are part of it, but for 1e-9 of its edge.
Integer voxel_of(double point, const Rational& origin, const Rational& cell) {
  return floor_of((Rational(point) - origin) / cell + decimal(1, 9));
}

/// The box of doubles that holds all of `box`, to leave out most of what is beyond it without exact numbers.
struct Nearby {
  std::array<double, 3> lower, upper;

  explicit Nearby(const Box& box) {
    for (std::size_t a = 0; a < 3; ++a) {
      lower[a] = std::nextafter(box.lower[a].convert_to<double>(), -HUGE_VAL);
      upper[a] = std::nextafter(box.upper[a].convert_to<double>(), HUGE_VAL);
    }
  }
  bool holds(const CloudPoint& p) const {
    for (std::size_t a = 0; a < 3; ++a) {
      if (p[a] < lower[a] || p[a] > upper[a]) return false;
    }
    return true;
  }
};

void mark_points(const Problem& problem, const Lattice& lattice, Voxels& solid) {
  const Nearby nearby(reach_of(problem));
  for (const CloudPoint& p : problem.points) {
    if (!nearby.holds(p)) continue;
    std::array<long, 3> v{};
    bool inside = true;
    for (std::size_t a = 0; a < 3; ++a) {
      const Integer index = voxel_of(p[a], lattice.origin[a], lattice.cell);
      inside = inside && index >= 0 && index < lattice.dims[a];
      if (inside) v[a] = static_cast<long>(index);
    }
    if (inside) solid.set(solid.index(v[0], v[1], v[2]));
  }
}

void mark_leaves(const Problem& problem, const Lattice& lattice, Voxels& solid) {
  const Box reach = reach_of(problem);
  Cells cells{};
  for (const Octree& tree : problem.octrees) {
    for (const Leaf& leaf : tree.leaves) {
      if (!leaf.occupied) continue;
      const Box box = box_of(tree, leaf);
      if (meets(box, reach) && cells_of(box, lattice, cells)) solid.set(cells);
    }
  }
}

/// The tree's smallest cubes that each voxel meets along one axis, but for 1e-6 of a cube.
struct Spans {
  std::vector<std::int64_t> begin, end;

  Spans(const Octree& tree, const Lattice& lattice, std::size_t a) {
    const Rational edge = tree.resolution, slack = decimal(1, 6);
    for (long i = 0; i < lattice.dims[a]; ++i) {
      const Rational lower = (lattice.origin[a] + i * lattice.cell) / edge;
      const Rational upper = (lattice.origin[a] + (i + 1) * lattice.cell) / edge;
      begin.push_back(static_cast<std::int64_t>(floor_of(lower + slack)) + 32768);
      end.push_back(static_cast<std::int64_t>(ceil_of(upper - slack)) + 32768);
    }
  }
  std::uint64_t cubes(long i) const { return static_cast<std::uint64_t>(end[at(i)] - begin[at(i)]); }
  /// Those of them between two keys.
  std::uint64_t shared(long i, std::int64_t first, std::int64_t last) const {
    return static_cast<std::uint64_t>(
        std::max<std::int64_t>(0, std::min(end[at(i)], last) - std::max(begin[at(i)], first)));
  }
  /// The voxels that meet a cube between two keys.
  std::pair<long, long> voxels(std::int64_t first, std::int64_t last) const {
    return {std::upper_bound(end.begin(), end.end(), first) - end.begin(),
            std::lower_bound(begin.begin(), begin.end(), last) - begin.begin()};
  }

 private:
  static std::size_t at(long i) { return static_cast<std::size_t>(i); }
};

/// Free are voxels with as many free cubes as there are in them: no two leaves of a tree share one.
void mark_free(const Octree& tree, const Lattice& lattice, Voxels& free) {
  const std::array<Spans, 3> spans{Spans(tree, lattice, 0), Spans(tree, lattice, 1), Spans(tree, lattice, 2)};
  std::vector<std::uint64_t> counts(free.size(), 0);
  for (const Leaf& leaf : tree.leaves) {
    if (leaf.occupied) continue;
    std::array<std::pair<long, long>, 3> v;
    for (std::size_t a = 0; a < 3; ++a) v[a] = spans[a].voxels(leaf.key[a], leaf.key[a] + leaf.size);
    const auto shared = [&](std::size_t a, long i) { return spans[a].shared(i, leaf.key[a], leaf.key[a] + leaf.size); };
    for (long z = v[2].first; z < v[2].second; ++z) {
      for (long y = v[1].first; y < v[1].second; ++y) {
        const std::uint64_t across = shared(2, z) * shared(1, y);
        for (long x = v[0].first; x < v[0].second; ++x) counts[free.index(x, y, z)] += across * shared(0, x);
      }
    }
  }
  for (long z = 0; z < lattice.dims[2]; ++z) {
    for (long y = 0; y < lattice.dims[1]; ++y) {
      const std::uint64_t across = spans[2].cubes(z) * spans[1].cubes(y);
      for (long x = 0; x < lattice.dims[0]; ++x) {
        const std::size_t i = free.index(x, y, z);
        if (counts[i] == across * spans[0].cubes(x)) free.set(i);
      }
    }
  }
}

void mark_unknown(const Problem& problem, const Lattice& lattice, Voxels& solid) {
  Voxels free(lattice);
  for (const Octree& tree : problem.octrees) mark_free(tree, lattice, free);
  for (std::size_t i = 0; i < solid.size(); ++i) {
    if (!free.at(i)) solid.set(i);
  }
}

}  // namespace

Box reach_of(const Problem& problem) {
  const Rational margin = problem.clearance + 2 * problem.cell;
  Box reach = problem.boundary;
  for (std::size_t a = 0; a < 3; ++a) {
    reach.lower[a] -= margin;
    reach.upper[a] += margin;
  }
  return reach;
}

bool map_sticks_out(const Problem& problem) {
  const Box reach = reach_of(problem);
  const Box& boundary = problem.boundary;
  const auto beyond = [&](std::size_t a, const Rational& lower, const Rational& upper) {
    return lower < boundary.lower[a] || upper > boundary.upper[a];
  };
  const Nearby nearby(reach);
  for (const CloudPoint& p : problem.points) {
    if (!nearby.holds(p)) continue;
    for (std::size_t a = 0; a < 3; ++a) {
      const Rational lower =
          boundary.lower[a] + Rational(voxel_of(p[a], boundary.lower[a], problem.cell)) * problem.cell;
      if (beyond(a, lower, lower + problem.cell)) return true;
    }
  }
  for (const Octree& tree : problem.octrees) {
    for (const Leaf& leaf : tree.leaves) {
      const Box box = leaf.occupied ? box_of(tree, leaf) : Box{};
      if (!leaf.occupied || !meets(box, reach)) continue;
      for (std::size_t a = 0; a < 3; ++a) {
        if (beyond(a, box.lower[a], box.upper[a])) return true;
      }
    }
  }
  return false;
}

std::vector<Cells> map_cells(const Problem& problem, const Lattice& lattice) {
  if (problem.points.empty() && problem.octrees.empty()) return {};
  double voxels = 1;
  for (const long count : lattice.dims) voxels *= static_cast<double>(count);
  if (voxels > kMostVoxels)
    throw InputError(problem.name + ": the grid has too many voxels for map files: 2^27 at most");
  Voxels solid(lattice);
  mark_points(problem, lattice, solid);
  mark_leaves(problem, lattice, solid);
  if (problem.unknown_is_solid) mark_unknown(problem, lattice, solid);
  return solid.take();
}

}  // namespace tern_verify
