// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bezier curves in exact numbers. A curve lies in the hull of its control points, and begins and ends at the outer
// ones.
#ifndef TERN_VERIFY_BEZIER_HPP
#define TERN_VERIFY_BEZIER_HPP

#include <cstddef>
#include <vector>

#include "verify/exact.hpp"

namespace tern_verify {

/// The control points of a curve over u in [0, 1].
template <std::size_t N>
using Polygon = std::vector<Vector<N>>;

template <typename V>
struct HalvesOf {
  std::vector<V> left, right;
};
template <std::size_t N>
using Halves = HalvesOf<Vector<N>>;

/// de Casteljau at 1/2. The points may be of any numbers.
template <typename V>
HalvesOf<V> halves_of(std::vector<V> curve) {
  static const typename V::value_type kHalf = 0.5;
  const std::size_t degree = curve.size() - 1;
  HalvesOf<V> halves{{curve.front()}, std::vector<V>(curve.size())};
  halves.right[degree] = curve[degree];
  for (std::size_t last = degree; last > 0; --last) {
    for (std::size_t i = 0; i < last; ++i) curve[i] = kHalf * (curve[i] + curve[i + 1]);
    halves.left.push_back(curve[0]);
    halves.right[last - 1] = curve[last - 1];
  }
  return halves;
}

/// The derivative with respect to time of a curve that lasts `duration` seconds.
template <std::size_t N>
Polygon<N> hodograph(const Polygon<N>& curve, const Rational& duration) {
  const std::size_t degree = curve.size() - 1;
  const Rational factor = Rational(degree) / duration;
  Polygon<N> derivative(degree);
  for (std::size_t i = 0; i < degree; ++i) derivative[i] = factor * (curve[i + 1] - curve[i]);
  return derivative;
}

/// The point at `u`: de Casteljau.
template <typename V>
V point_at(std::vector<V> curve, const typename V::value_type& u) {
  for (std::size_t last = curve.size() - 1; last > 0; --last) {
    for (std::size_t i = 0; i < last; ++i) curve[i] = curve[i] + u * (curve[i + 1] - curve[i]);
  }
  return curve.front();
}

/// The part of a curve between two parameters, 0 <= from < to <= 1: de Casteljau twice.
template <typename V, typename Number = typename V::value_type>
std::vector<V> part_of(std::vector<V> curve, const Number& from, const Number& to) {
  const std::size_t degree = curve.size() - 1;
  std::vector<V> kept = curve;
  for (std::size_t level = 0; level <= degree; ++level) {
    kept[level] = curve[0];
    for (std::size_t i = 0; i + level < degree; ++i) curve[i] = curve[i] + to * (curve[i + 1] - curve[i]);
  }
  const Number u = from / to;
  curve = kept;
  for (std::size_t level = 0; level <= degree; ++level) {
    kept[degree - level] = curve[degree - level];
    for (std::size_t i = 0; i + level < degree; ++i) curve[i] = curve[i] + u * (curve[i + 1] - curve[i]);
  }
  return kept;
}

}  // namespace tern_verify

#endif
