// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// OctoMap files: each node before its children, the first child first.
#include <cmath>
#include <map>

#include "verify/bytes.hpp"
#include "verify/map_files.hpp"

namespace tern_verify {
namespace {

constexpr std::int64_t kTreeSize = 65536;

class Reader {
 public:
  Reader(Bytes& bytes, bool binary, std::size_t colour, std::vector<Leaf>& leaves)
      : bytes_(bytes), binary_(binary), colour_(colour), leaves_(leaves) {}

  void read(const Leaf& cube) {
    ++nodes_;
    if (cube.size < 1) bytes_.refuse("a node below the smallest cubes");
    binary_ ? read_pairs(cube) : read_value(cube);
  }
  std::uint64_t nodes() const { return nodes_; }

 private:
  static Leaf child(const Leaf& cube, int index) {
    Leaf part = cube;
    part.size = cube.size / 2;
    for (std::size_t a = 0; a < 3; ++a) part.key[a] += (index >> a & 1) * part.size;
    return part;
  }

  /// Two bits a child: 0 unknown, 1 free, 2 occupied, 3 with children of its own.
  void read_pairs(const Leaf& cube) {
    const int low = bytes_.byte();
    const int pairs = low + 256 * bytes_.byte();
    const auto kind = [pairs](int i) { return pairs >> (2 * i) & 3; };
    for (int i = 0; i < 8; ++i) {
      if (kind(i) != 1 && kind(i) != 2) continue;
      if (cube.size < 2) bytes_.refuse("a node below the smallest cubes");
      Leaf leaf = child(cube, i);
      leaf.occupied = kind(i) == 2;
      leaves_.push_back(leaf);
      ++nodes_;
    }
    for (int i = 0; i < 8; ++i) {
      if (kind(i) == 3) read(child(cube, i));
    }
  }

  /// The logarithm of the odds, and a bit a child.
  void read_value(const Leaf& cube) {
    const double odds = value_of(bytes_.take(4), 'F');
    bytes_.take(colour_);
    const int children = bytes_.byte();
    if (std::isnan(odds)) bytes_.refuse("a node that is neither free nor occupied");
    if (children == 0) {
      leaves_.push_back(cube);
      leaves_.back().occupied = odds >= 0;
    }
    for (int i = 0; i < 8; ++i) {
      if ((children >> i & 1) != 0) read(child(cube, i));
    }
  }

  Bytes& bytes_;
  bool binary_;
  std::size_t colour_;
  std::vector<Leaf>& leaves_;
  std::uint64_t nodes_ = 0;
};

}  // namespace

Octree read_octree(const std::string& content, const std::string& name) {
  Bytes bytes(content, name);
  const std::vector<std::string> first = bytes.words();
  const bool binary = first == std::vector<std::string>{"#", "Octomap", "OcTree", "binary", "file"};
  if (!binary && first != std::vector<std::string>{"#", "Octomap", "OcTree", "file"}) bytes.refuse("no OctoMap");
  std::map<std::string, std::string> head;
  for (std::vector<std::string> words = bytes.words(); words.empty() || words[0] != "data"; words = bytes.words()) {
    if (words.size() == 2) head[words[0]] = words[1];
  }
  const bool coloured = head["id"] == "ColorOcTree" && !binary;
  if (head["id"] != "OcTree" && !coloured) bytes.refuse("a tree of type '" + head["id"] + "'");
  Octree tree{head["res"].empty() ? 0.0 : word_value(head["res"], bytes), {}};
  const double nodes = head["size"].empty() ? -1.0 : word_value(head["size"], bytes);
  if (!(tree.resolution > 0) || !(nodes >= 0)) bytes.refuse("no 'res' above 0, or no 'size'");
  Reader reader(bytes, binary, coloured ? 3 : 0, tree.leaves);
  if (nodes > 0) reader.read({{0, 0, 0}, kTreeSize, false});
  if (static_cast<double>(reader.nodes()) != nodes || !bytes.at_end()) bytes.refuse("the tree is not of its 'size'");
  return tree;
}

}  // namespace tern_verify
