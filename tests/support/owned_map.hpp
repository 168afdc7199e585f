// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_OWNED_MAP_HPP
#define TERN_TESTS_SUPPORT_OWNED_MAP_HPP

#include <cstdint>
#include <vector>

#include "support/map_noise.hpp"
#include "tern/map.hpp"

namespace tern_test {

/// A map with words of its own, filled with noise before it is bound.
struct OwnedMap {
  explicit OwnedMap(const tern::MapSpec& spec)
      : words(tern::map_words(spec), 0xA5A5A5A5A5A5A5A5u), status(map.bind(spec, words.data(), words.size())) {}

  tern::RollingMap map;
  std::vector<std::uint64_t> words;
  tern::Status status;
};

/// A depth image with its numbers, in metres.
struct Image {
  std::vector<float> z;
  tern::DepthView view;

  Image(int width, int height, double focal)
      : z(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
        view{nullptr,           z.data(),           width, height, width, focal, focal,
             0.5 * (width - 1), 0.5 * (height - 1), 1.0,   0.1,    50.0,  0.0} {}
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  float& at(int u, int v) { return z[static_cast<std::size_t>(v * view.width + u)]; }
};

inline void fill_randomly(Random& random, Image& image, double range) {
  fill_randomly(random, image.z.data(), image.view.width, image.view.height, range);
}

}  // namespace tern_test

#endif
