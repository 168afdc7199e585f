// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/map/octomap_file.hpp"

#include <cmath>
#include <map>

#include "host/map/byte_reader.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr std::uint32_t kRootSize = 1u << kOctomapDepth;
constexpr const char* kBinaryMagic = "# Octomap OcTree binary file";
constexpr const char* kFullMagic = "# Octomap OcTree file";
constexpr int kMaxHeaderLines = 64;

/// Edges of the smallest cubes, metres, that a map may have.
constexpr double kMinResolution = 1e-4;
constexpr double kMaxResolution = 1e4;
constexpr double kMostNodes = 1e10;

struct Header {
  bool binary = false;
  std::string id;
  std::uint64_t nodes = 0;
  double resolution = 0.0;
  std::size_t colour_bytes = 0;  ///< after the value of each node
};

/// One word after each of `id`, `size` and `res`.
using HeaderWords = std::map<std::string, std::string>;

double resolution_of(const std::string& word, const Place& place) {
  const double resolution = number(word, place);
  if (resolution >= kMinResolution && resolution <= kMaxResolution) return resolution;
  throw RecordError(place, "the tree's resolution 'res' is " + brief(resolution) + " m, not within " +
                               brief(kMinResolution) + " to " + brief(kMaxResolution));
}

Header header_of(HeaderWords& words, bool binary, const Place& place) {
  for (const char* const key : {"id", "size", "res"}) {
    if (words.count(key) == 0) throw RecordError(place, std::string("its header has no '") + key + "'");
  }
  Header header;
  header.binary = binary;
  header.id = words["id"];
  header.nodes = whole_number(words["size"], kMostNodes, place);
  header.resolution = resolution_of(words["res"], place);
  header.colour_bytes = header.id == "ColorOcTree" ? 3 : 0;
  const bool known = header.id == "OcTree" || (header.id == "ColorOcTree" && !header.binary);
  if (!known) throw RecordError(place, "a tree of type " + quote(header.id) + ": save it as an OcTree");
  return header;
}

/// The lines up to "data".
Header read_header(ByteReader& reader, const Place& place) {
  const std::string magic = reader.line();
  const bool binary = magic == kBinaryMagic;
  if (!binary && magic != kFullMagic) throw RecordError(place, "not an OctoMap file (.bt or .ot)");
  HeaderWords found;
  while (!reader.at_end() && reader.line_place().line < kMaxHeaderLines) {
    const Words words = split_words(reader.line(), false);
    const Place here = reader.line_place();
    if (words.empty() || words[0][0] == '#') continue;
    if (words.size() == 1 && words[0] == "data") return header_of(found, binary, here);
    const bool known = words[0] == "id" || words[0] == "size" || words[0] == "res";
    if (!known) throw RecordError(here, "unknown word " + quote(words[0]) + " in its header");
    if (words.size() != 2) throw_count(words[0], "1 word", words.size() - 1, here);
    if (!found.insert({words[0], words[1]}).second) throw RecordError(here, "'" + words[0] + "' is given twice");
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
    if (!reader_.at_end()) {
      throw RecordError(place_, "broken: after its " + std::to_string(count_) + " nodes, the file has " +
                                    std::to_string(reader_.left()) + " bytes more");
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
    if (std::isnan(log_odds)) {
      throw RecordError(place_,
                        "broken: a node before byte " + std::to_string(reader_.at()) + " is neither free nor occupied");
    }
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
  std::uint64_t count_ = 0;
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
