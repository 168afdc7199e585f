// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/octomap_file.hpp"

#include "host/map/byte_reader.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr std::uint32_t kRootSize = 1u << kOctomapDepth;
constexpr const char* kBinaryMagic = "# Octomap OcTree binary file";
constexpr const char* kFullMagic = "# Octomap OcTree file";
constexpr int kMaxHeaderLines = 64;

struct Header {
  bool binary = false;
  std::string id;
  std::size_t nodes = 0;
  double resolution = 0.0;
  std::size_t colour_bytes = 0;  ///< after the value of each node
};

std::size_t node_count(const Words& words, const Place& place) {
  const double count = words.size() == 2 ? number(words[1], place) : -1.0;
  if (!(count >= 0.0 && count < 1e10)) throw RecordError(place, "the tree's 'size' is no number of nodes");
  return static_cast<std::size_t>(count);
}

void set_type(Header& header, const Place& place) {
  header.colour_bytes = header.id == "ColorOcTree" ? 3 : 0;
  const bool known = header.id == "OcTree" || (header.id == "ColorOcTree" && !header.binary);
  if (!known) throw RecordError(place, "a tree of type " + quote(header.id) + ": save it as an OcTree");
  if (!(header.resolution > 0.0)) throw RecordError(place, "the tree has no resolution 'res' above 0");
}

/// The lines up to "data".
Header read_header(ByteReader& reader, const Place& place) {
  Header header;
  const std::string magic = reader.line();
  header.binary = magic == kBinaryMagic;
  if (!header.binary && magic != kFullMagic) throw RecordError(place, "not an OctoMap file (.bt or .ot)");
  for (int i = 0; i < kMaxHeaderLines; ++i) {
    const Words words = split_words(reader.line(), false);
    if (words.empty() || words[0][0] == '#') continue;
    if (words[0] == "id" && words.size() == 2) header.id = words[1];
    if (words[0] == "size") header.nodes = node_count(words, place);
    if (words[0] == "res" && words.size() == 2) header.resolution = number(words[1], place);
    if (words[0] != "data") continue;
    set_type(header, place);
    return header;
  }
  throw RecordError(place, "its header has no 'data'");
}

/// Reads nodes in the order of the file: each before its children.
class TreeReader {
 public:
  TreeReader(ByteReader& reader, const Header& header, const Place& place)
      : reader_(reader), header_(header), place_(place) {}

  std::vector<OctomapLeaf> read() {
    if (header_.nodes > 0) push({{0, 0, 0}, kRootSize, false});
    while (!waiting_.empty()) {
      const OctomapLeaf cube = waiting_.back();
      waiting_.pop_back();
      header_.binary ? read_children(cube) : read_node(cube);
    }
    if (count_ != header_.nodes) {
      throw RecordError(
          place_, "broken: it says " + std::to_string(header_.nodes) + " nodes and has " + std::to_string(count_));
    }
    return leaves_;
  }

 private:
  void push(const OctomapLeaf& cube) {
    ++count_;
    waiting_.push_back(cube);
  }
  void add_leaf(OctomapLeaf cube, bool occupied) {
    if (leaves_.size() == kMaxOctomapLeaves) {
      throw RecordError(place_, "more than " + std::to_string(kMaxOctomapLeaves) + " leaves: prune the tree");
    }
    cube.occupied = occupied;
    leaves_.push_back(cube);
  }
  OctomapLeaf child(const OctomapLeaf& cube, int index) const {
    if (cube.size == 1) throw RecordError(place_, "broken: a node below the smallest cubes");
    OctomapLeaf part = cube;
    part.size = cube.size / 2;
    for (int a = 0; a < 3; ++a) part.key[a] += (index >> a & 1) != 0 ? part.size : 0u;
    return part;
  }

  /// Of a `.bt`: two bits a child. 1 free, 2 occupied, 3 it has children.
  void read_children(const OctomapLeaf& cube) {
    const std::uint32_t low = reader_.byte();
    const std::uint32_t kinds = low | static_cast<std::uint32_t>(reader_.byte()) << 8;
    for (int i = 0; i < 8; ++i) {
      const std::uint32_t kind = kinds >> (2 * i) & 3u;
      if (kind != 1 && kind != 2) continue;
      ++count_;
      add_leaf(child(cube, i), kind == 2);
    }
    // The last one goes first, so that the first is taken first.
    for (int i = 7; i >= 0; --i) {
      if ((kinds >> (2 * i) & 3u) == 3) push(child(cube, i));
    }
  }

  /// Of an `.ot`: the logarithm of the odds of being occupied, and one bit a child that is there.
  void read_node(const OctomapLeaf& cube) {
    const double log_odds = reader_.number('F', 4, ByteOrder::kLittle);
    reader_.skip(header_.colour_bytes);
    const std::uint32_t children = reader_.byte();
    if (children == 0) return add_leaf(cube, log_odds >= 0.0);
    for (int i = 7; i >= 0; --i) {
      if ((children >> i & 1u) != 0) push(child(cube, i));
    }
  }

  ByteReader& reader_;
  const Header& header_;
  const Place& place_;
  std::vector<OctomapLeaf> waiting_;
  std::vector<OctomapLeaf> leaves_;
  std::size_t count_ = 0;
};

}  // namespace

tern::Box Octomap::box(const OctomapLeaf& leaf) const {
  const auto at = [this](std::uint32_t key) { return (static_cast<double>(key) - 32768.0) * resolution; };
  return {{at(leaf.key[0]), at(leaf.key[1]), at(leaf.key[2])},
          {at(leaf.key[0] + leaf.size), at(leaf.key[1] + leaf.size), at(leaf.key[2] + leaf.size)}};
}

Octomap parse_octomap(const std::string& bytes, const Place& place) {
  ByteReader reader(bytes, place);
  const Header header = read_header(reader, place);
  Octomap map{header.resolution, {}};
  map.leaves = TreeReader(reader, header, place).read();
  return map;
}

}  // namespace tern_host
