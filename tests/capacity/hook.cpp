// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "capacity/hook.hpp"

#include <cstring>

#include "base/capacity.hpp"

namespace tern_capacity {
namespace {

struct Hook {
  bool counts;
  std::uint64_t asked;
  std::uint64_t failing;
  Failing how;
  int failed;  ///< index of the site, -1 before it
  int count;
  Site sites[kMostSites];
};

Hook hook{false, 0, 0, Failing::kOnce, -1, 0, {}};

/// The index of a place, the last one for all that have no room.
int index_of(const char* file, int line) noexcept {
  for (int k = 0; k < hook.count; ++k) {
    if (hook.sites[k].line == line && std::strcmp(hook.sites[k].file, file) == 0) return k;
  }
  if (hook.count < kMostSites) hook.sites[hook.count++] = {file, line, 0, 0, 0};
  return hook.count - 1;
}

}  // namespace

void begin(std::uint64_t failing, Failing how) noexcept {
  hook.counts = true;
  hook.asked = 0;
  hook.failing = failing;
  hook.how = how;
  hook.failed = -1;
  for (int k = 0; k < hook.count; ++k) hook.sites[k].asked = 0;
}

void end() noexcept {
  hook.counts = false;
}

std::uint64_t asked() noexcept {
  return hook.asked;
}

int site_count() noexcept {
  return hook.count;
}

Site site(int index) noexcept {
  return hook.sites[index];
}

Site failed_site() noexcept {
  return hook.failed < 0 ? Site{nullptr, 0, 0, 0, 0} : hook.sites[hook.failed];
}

}  // namespace tern_capacity

namespace tern {

bool is_full(bool full, const char* file, int line) noexcept {
  using tern_capacity::hook;
  if (!hook.counts) return full;
  const int index = tern_capacity::index_of(file, line);
  tern_capacity::Site& site = hook.sites[index];
  ++hook.asked;
  if (site.asked++ == 0) site.first = hook.asked;
  site.last = hook.asked;
  if (hook.asked == hook.failing) {
    hook.failed = index;
    return true;
  }
  return full || (hook.how == tern_capacity::Failing::kForGood && hook.failed == index);
}

}  // namespace tern
