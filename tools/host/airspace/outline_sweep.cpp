// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/outline_sweep.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace tern_host {
namespace {

/// What is to the right of an edge, and the piece of which the edge is the left side.
struct Beside {
  std::vector<int> windings;
  bool filled = false;
  bool covered = false;  ///< the next edge is at the same place, so nothing is between the two
  bool changed = true;   ///< on this level: then `filled` is not known yet
  std::optional<GrownPiece> piece = std::nullopt;
};

/// From left to right on a level and just above it. Below the level, edges that meet there may be in another order.
struct Order {
  const LevelLine* line;

  bool operator()(const Edge* a, const Edge* b) const {
    const int side = compare(abscissa(*a, *line), abscissa(*b, *line));
    if (side != 0) return side < 0;
    const int slopes = compare_slopes(*a, *b);
    return slopes != 0 ? slopes < 0 : a < b;
  }
};

/// Edges stay in order and keep their windings and pieces while nothing happens to them. Each event changes the edges
/// of its point, and others to their right only as far as a level edge, which is none here, changed what they wind
/// around.
class Sweep {
 public:
  Sweep(const Arrangement& arrangement, std::size_t layers, const Filled& filled)
      : arrangement_(arrangement), outside_(layers, 0), filled_(filled) {}

  std::vector<GrownPiece> run() {
    const auto end = arrangement_.events.end();
    for (auto first = arrangement_.events.begin(); first != end;) {
      const auto last = std::find_if(first, end, [&](const Event& e) { return !(e.level == first->level); });
      line_ = line_of(first->level);
      pass(first, last);
      first = last;
    }
    return std::move(done_);
  }

 private:
  using Edges = std::map<const Edge*, Beside, Order>;
  using Place = Edges::iterator;
  using Events = std::vector<Event>::const_iterator;

  /// All that happens on the line.
  void pass(Events first, Events last) {
    std::vector<const Edge*> touched;
    for (Events event = first; event != last; ++event) touched.push_back(event->edge);
    std::sort(touched.begin(), touched.end(), Order{&line_});
    for (std::size_t i = 0, next = 0; i < touched.size(); i = next) {
      while (next < touched.size() && meet(touched[i], touched[next])) ++next;
      pass_point(
          {touched.begin() + static_cast<std::ptrdiff_t>(i), touched.begin() + static_cast<std::ptrdiff_t>(next)});
    }
    for (const Place& start : starts_) fill(start);
    starts_.clear();
    for (GrownPiece& piece : below_) {
      piece.top = line_.level;
      if (!piece.left.empty()) done_.push_back(std::move(piece));
    }
    below_.clear();
    first_below_ = 0;
  }

  bool meet(const Edge* a, const Edge* b) const { return compare(abscissa(*a, line_), abscissa(*b, line_)) == 0; }

  bool is_on_line(std::int64_t y) const { return *line_.level == Level{Wide(y), Wide(1)}; }

  /// Edges of one point: those that end make way for those that begin, and those that go on are put in order.
  void pass_point(const std::vector<const Edge*>& touched) {
    Place first = edges_.lower_bound(touched.front()), last = first;
    while (first != edges_.begin() && meet(std::prev(first)->first, touched.front())) --first;
    while (last != edges_.end() && meet(last->first, touched.front())) ++last;
    begin_change(first);
    std::vector<const Edge*> go_on;
    for (Place at = first; at != last; ++at) {
      detach(at);
      if (!is_on_line(at->first->high.y)) go_on.push_back(at->first);
    }
    edges_.erase(first, last);
    for (const Edge* edge : touched) {
      if (is_on_line(edge->low.y)) go_on.push_back(edge);
    }
    first = last;
    for (const Edge* edge : go_on) {
      const Place at = edges_.emplace(edge, Beside{}).first;
      if (first == last || Order{&line_}(edge, first->first)) first = at;
    }
    wind(first, last);
  }

  /// Counts anew from `first` on, to `last` and on until nothing changes.
  void wind(Place first, Place last) {
    std::vector<int> windings = first == edges_.begin() ? outside_ : std::prev(first)->second.windings;
    bool is_beyond = false;
    for (Place at = first; at != edges_.end(); ++at) {
      is_beyond = is_beyond || at == last;
      Beside& beside = at->second;
      detach(at);
      beside.changed = true;
      windings[at->first->layer] += at->first->turn;
      if (is_beyond && !beside.covered && windings == beside.windings) return;
      const Place next = std::next(at);
      // Beyond, coincident edges are as before.
      if (!is_beyond) beside.covered = next != last && compare_slopes(*at->first, *next->first) == 0;
      beside.windings = windings;
    }
  }

  /// Before edges from `first` on change: ends the strip to their left, if that is filled, and notes where to fill
  /// anew. What an earlier change on the line reaches is done there.
  void begin_change(Place first) {
    if (first == edges_.begin()) return starts_.push_back(edges_.end());
    Place start = std::prev(first);
    if (start->second.changed) return;
    for (Place at = start; at->second.covered || at->second.filled; --at) {
      if (at->second.changed) return;
      if (!at->second.covered) start = at;
      if (at == edges_.begin()) break;
    }
    detach(start);
    starts_.push_back(start);
  }

  void detach(Place edge) {
    if (edge->second.piece) below_.push_back(std::move(*edge->second.piece));
    edge->second.piece.reset();
  }

  /// Strips from a place on, or from the outermost left, as far as there are changes.
  void fill(Place start) {
    const Place end = edges_.end();
    Place left = end;
    if (start == end) start = edges_.begin();
    for (Place at = start; at != end && (at == start || left != end || at->second.changed); ++at) {
      Beside& beside = at->second;
      if (beside.changed) beside.filled = !beside.covered && filled_(beside.windings);
      beside.changed = false;
      if (beside.covered) continue;
      if (beside.filled && left == end) left = at;
      if (beside.filled || left == end) continue;
      if (!left->second.piece) left->second.piece = piece_of(*left->first, *at->first);
      left = end;
    }
  }

  /// True if a strip between two edges can go on with the piece: they share a whole side, and bend inwards nowhere.
  bool continues(const GrownPiece& piece, const Edge& left, const Edge& right) const {
    const Edge &last_left = *piece.left.back().edge, &last_right = *piece.right.back().edge;
    if (piece.left.size() + piece.right.size() + 4 > kMostSides) return false;
    return compare_slopes(left, last_left) >= 0 && compare_slopes(right, last_right) <= 0 && meet(&last_left, &left) &&
           meet(&last_right, &right);
  }

  /// Pieces below are in order from left to right, as strips are. Those that went on have no links left.
  GrownPiece* find_below(const Edge& left, const Edge& right) {
    for (std::size_t k = first_below_; k < below_.size(); ++k) {
      const bool is_over = below_[k].left.empty();
      if (!is_over && continues(below_[k], left, right)) return &below_[k];
      const int side = is_over ? -1 : compare(abscissa(*below_[k].left.back().edge, line_), abscissa(left, line_));
      if (side > 0) break;
      if (side < 0 && k == first_below_) ++first_below_;
    }
    return nullptr;
  }

  /// What becomes of a strip above the line: a new piece, or more of one below.
  GrownPiece piece_of(const Edge& left, const Edge& right) {
    const Level* const level = line_.level;
    GrownPiece* const found = find_below(left, right);
    if (found == nullptr) return {{{&left, level}}, {{&right, level}}, level, level};
    GrownPiece piece = std::move(*found);
    found->left.clear();
    if (compare_slopes(left, *piece.left.back().edge) != 0) piece.left.push_back({&left, level});
    if (compare_slopes(right, *piece.right.back().edge) != 0) piece.right.push_back({&right, level});
    return piece;
  }

  const Arrangement& arrangement_;
  const std::vector<int> outside_;
  const Filled& filled_;
  LevelLine line_{};
  Edges edges_{Order{&line_}};     // that pass the line
  std::vector<Place> starts_;      // left of each change on the line, or the end, if no edge is
  std::vector<GrownPiece> below_;  // that reach the line at a change, from left to right
  std::size_t first_below_ = 0;    // those before are left of all that is still to come
  std::vector<GrownPiece> done_;
};

}  // namespace

std::vector<GrownPiece> sweep(const Arrangement& arrangement, std::size_t layers, const Filled& filled) {
  return Sweep(arrangement, layers, filled).run();
}

}  // namespace tern_host
