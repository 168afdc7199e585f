// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/paper_search.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <queue>
#include <tuple>

namespace tern_bench {
namespace {

using tern::Voxel;

Voxel operator+(const Voxel& a, const Voxel& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Voxel operator-(const Voxel& a, const Voxel& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
bool operator==(const Voxel& a, const Voxel& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
bool before(const Voxel& a, const Voxel& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

int axes_of(const Voxel& d) {
  return std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
}
int manhattan(const Voxel& a, const Voxel& b) {
  return axes_of(a - b);
}
double euclid(const Voxel& a, const Voxel& b) {
  return std::sqrt(
      static_cast<double>((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z)));
}

/// The unit steps that a move is made of, in the order of the axes.
std::vector<Voxel> parts_along_one_axis(const Voxel& d) {
  std::vector<Voxel> parts;
  if (d.x != 0) parts.push_back({d.x, 0, 0});
  if (d.y != 0) parts.push_back({0, d.y, 0});
  if (d.z != 0) parts.push_back({0, 0, d.z});
  return parts;
}

std::vector<Voxel> parts_along_two_axes(const Voxel& d) {
  return {{0, d.y, d.z}, {d.x, 0, d.z}, {d.x, d.y, 0}};
}

/// The moves worth following from where a jump along `d` may stop. An obstacle beside the way with free space behind it
/// forces one.
class ForcedMoves {
 public:
  ForcedMoves(const PaperMap& map, const Voxel& at, const Voxel& d) : map_(map), at_(at) {
    if (!map.inside(at + d)) return;
    if (axes_of(d) == 1) straight(d);
    if (axes_of(d) == 2) plane_diagonal(d);
    if (axes_of(d) == 3) space_diagonal(d);
  }

  const std::vector<Voxel>& moves() const { return moves_; }

 private:
  void look(const Voxel& beside, const Voxel& ahead, const Voxel& move) {
    if (map_.obstacle(at_ + beside) && map_.free(at_ + beside + ahead)) moves_.push_back(move);
  }

  void straight(const Voxel& d) {
    if (map_.obstacle(at_ + d)) return;
    const Voxel next{std::abs(d.z), std::abs(d.x), std::abs(d.y)};
    const Voxel after{std::abs(d.y), std::abs(d.z), std::abs(d.x)};
    const Voxel none{0, 0, 0};
    for (const Voxel& side :
         {next, none - next, after, none - after, next + after, none - next - after, next - after, after - next}) {
      look(side, d, side + d);
    }
  }

  void plane_diagonal(const Voxel& d) {
    for (const Voxel& part : parts_along_one_axis(d)) look(Voxel{0, 0, 0} - part, d - part, d - part - part);
    const Voxel normal{1 - std::abs(d.x), 1 - std::abs(d.y), 1 - std::abs(d.z)};
    look(Voxel{0, 0, 0} - normal, d, d - normal);
    look(normal, d, d + normal);
  }

  void space_diagonal(const Voxel& d) {
    for (const Voxel& part : parts_along_two_axes(d)) {
      if (map_.inside(at_ + part)) plane_diagonal(part);
    }
    std::sort(moves_.begin(), moves_.end(), before);
    const auto equal = [](const Voxel& a, const Voxel& b) { return a == b; };
    moves_.erase(std::unique(moves_.begin(), moves_.end(), equal), moves_.end());
    moves_.erase(std::remove_if(moves_.begin(), moves_.end(), [&](const Voxel& m) { return m == d; }), moves_.end());
  }

  const PaperMap& map_;
  Voxel at_;
  std::vector<Voxel> moves_;
};

/// Where a jump ends, and the moves to follow from there.
struct Landing {
  bool found = false;
  Voxel at{};
  std::vector<Voxel> moves;
};

Landing jump(const PaperMap& map, const Voxel& goal, Voxel from, const Voxel& d) {
  const int axes = axes_of(d);
  if (axes == 0) return {};
  std::vector<Voxel> parts;
  if (axes == 3) parts = parts_along_two_axes(d);
  for (const Voxel& part : parts_along_one_axis(d)) {
    if (axes > 1) parts.push_back(part);
  }
  for (Voxel at = from + d;; from = at, at = at + d) {
    if (!map.free(at)) return {};
    if (at == goal) return {true, at, {}};
    if (axes == 2 && map.obstacle(from + parts[0]) && map.obstacle(from + parts[1])) return {};
    const ForcedMoves forced(map, at, d);
    if (!forced.moves().empty()) return {true, at, forced.moves()};
    std::vector<Voxel> moves;
    for (const Voxel& part : parts) {
      if (jump(map, goal, at, part).found) moves.push_back(part);
    }
    if (moves.empty()) continue;
    moves.insert(moves.begin(), d);
    return {true, at, moves};
  }
}

struct Node {
  Voxel at;
  int parent;
  std::vector<Voxel> moves;
};

/// Least f first, of equals the one that was generated first.
using Entry = std::pair<double, int>;
using OpenList = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

std::vector<Voxel> all_moves() {
  std::vector<Voxel> moves;
  for (int d = 0; d < 27; ++d) {
    if (d != 13) moves.push_back({d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1});
  }
  return moves;
}

/// From the last node to the start, turned around, between the exact ends.
std::vector<tern::Vec3> trace(const PaperMap& map, const std::vector<Node>& nodes, const tern::Vec3& start,
                              const tern::Vec3& goal) {
  std::vector<tern::Vec3> points{goal};
  for (int i = static_cast<int>(nodes.size()) - 1; i > 0; i = nodes[static_cast<std::size_t>(i)].parent) {
    points.push_back(map.center(nodes[static_cast<std::size_t>(i)].at));
  }
  points.push_back(start);
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace

Route greedy_jump_search(const PaperMap& map, const tern::Vec3& start, const tern::Vec3& goal) {
  Route route;
  const Voxel target = map.voxel_of(goal);
  std::vector<Node> nodes{{map.voxel_of(start), 0, all_moves()}};
  std::vector<bool> generated(map.cells(), false);
  generated[map.index(nodes[0].at)] = true;
  OpenList open;
  open.push({0.0, 0});
  while (!open.empty() && !route.found) {
    const int index = open.top().second;
    open.pop();
    ++route.expanded;
    const Node node = nodes[static_cast<std::size_t>(index)];
    for (const Voxel& d : node.moves) {
      const Landing landing = jump(map, target, node.at, d);
      if (!landing.found || generated[map.index(landing.at)]) continue;
      generated[map.index(landing.at)] = true;
      open.push({manhattan(target, landing.at) + euclid(node.at, landing.at), static_cast<int>(nodes.size())});
      nodes.push_back({landing.at, index, landing.moves});
      route.found = landing.at == target;
      if (route.found) break;
    }
  }
  if (route.found) route.points = trace(map, nodes, start, goal);
  return route;
}

std::vector<tern::Vec3> shorten_by_sight(const PaperMap& map, const std::vector<tern::Vec3>& points) {
  if (points.size() < 3) return points;
  std::vector<tern::Vec3> kept{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (sampled_sight(map, kept.back(), points[i]) && !sampled_sight(map, kept.back(), points[i + 1])) {
      kept.push_back(points[i]);
    }
  }
  kept.push_back(points.back());
  return kept;
}

Route six_neighbour_astar(const PaperMap& map, const tern::Vec3& start, const tern::Vec3& goal) {
  constexpr std::array<Voxel, 6> kMoves{{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}}};
  Route route;
  const Voxel from = map.voxel_of(start);
  const Voxel target = map.voxel_of(goal);
  std::vector<int> cost(map.cells(), -1);
  std::vector<Node> nodes{{from, 0, {}}};
  std::vector<bool> closed(map.cells(), false);
  // Least f, then the greater cost so far, then the first generated.
  std::priority_queue<std::tuple<int, int, int>, std::vector<std::tuple<int, int, int>>, std::greater<>> open;
  cost[map.index(from)] = 0;
  open.push({manhattan(from, target), 0, 0});
  while (!open.empty()) {
    const int index = std::get<2>(open.top());
    open.pop();
    const Voxel at = nodes[static_cast<std::size_t>(index)].at;
    if (closed[map.index(at)]) continue;
    closed[map.index(at)] = true;
    ++route.expanded;
    if (at == target) {
      route.found = true;
      nodes.push_back(nodes[static_cast<std::size_t>(index)]);
      route.points = trace(map, nodes, start, goal);
      return route;
    }
    for (const Voxel& move : kMoves) {
      const Voxel next = at + move;
      if (!map.free(next) || closed[map.index(next)]) continue;
      const int g = cost[map.index(at)] + 1;
      if (cost[map.index(next)] >= 0 && cost[map.index(next)] <= g) continue;
      cost[map.index(next)] = g;
      open.push({g + manhattan(next, target), -g, static_cast<int>(nodes.size())});
      nodes.push_back({next, index, {}});
    }
  }
  return route;
}

}  // namespace tern_bench
