// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/matching.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/successive_shortest_path_nonnegative_weights.hpp>
#include <cmath>

namespace tern_tracker {
namespace {

// Gains as whole numbers: then no cost of the search is below zero by rounding. They are doubles, because the search
// adds up the largest numbers where no path leads, which overflows in integers.
constexpr double kUnits = 1e6;

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
struct Edge {
  double cost = 0.0;
  int capacity = 0, residual = 0;
  Traits::edge_descriptor reverse;
};
using Network = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, Edge>;

void connect(Network& network, std::size_t from, std::size_t to, double cost) {
  const auto there = boost::add_edge(from, to, network).first, back = boost::add_edge(to, from, network).first;
  network[there] = {cost, 1, 0, back};
  network[back] = {-cost, 0, 0, there};
}

}  // namespace

/// A flow of least cost: one unit goes from a source through each row, and then through a column or past all of them.
std::vector<std::size_t> best_matching(std::size_t rows, std::size_t columns, const std::vector<Pair>& pairs) {
  std::vector<std::size_t> column_of(rows, kNoColumn);
  if (pairs.empty()) return column_of;
  const auto whole = [](double gain) { return std::round(kUnits * gain); };
  double most = 0.0;
  for (const Pair& pair : pairs) most = std::max(most, whole(pair.gain));
  const std::size_t source = rows + columns, sink = source + 1;
  Network network(sink + 1);
  for (std::size_t row = 0; row < rows; ++row) {
    connect(network, source, row, 0.0);
    connect(network, row, sink, most);
  }
  for (std::size_t column = 0; column < columns; ++column) connect(network, rows + column, sink, 0.0);
  for (const Pair& pair : pairs) connect(network, pair.row, rows + pair.column, most - whole(pair.gain));
  boost::successive_shortest_path_nonnegative_weights(network, source, sink,
                                                      boost::capacity_map(boost::get(&Edge::capacity, network))
                                                          .residual_capacity_map(boost::get(&Edge::residual, network))
                                                          .reverse_edge_map(boost::get(&Edge::reverse, network))
                                                          .weight_map(boost::get(&Edge::cost, network)));
  for (const Pair& pair : pairs) {
    const auto edge = boost::edge(pair.row, rows + pair.column, network).first;
    if (network[edge].residual == 0) column_of[pair.row] = pair.column;
  }
  return column_of;
}

}  // namespace tern_tracker
