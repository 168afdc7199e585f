// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the cap rows share: each drives one loop of a stage to its configured bound and counts what that takes.
#ifndef TERN_BENCH_TIMING_CAPS_CAP_HPP
#define TERN_BENCH_TIMING_CAPS_CAP_HPP

#include <cstddef>
#include <cstdint>

#include "tern/tern.hpp"

namespace tern_caps {

/// One row of the table. It counts only where `reached` is `capacity`.
struct Cap {
  const char* name;
  const char* stage;       ///< the stage that the loop belongs to
  std::uint64_t count;     ///< instructions
  std::uint64_t reached;   ///< the loop's high-water mark...
  std::uint64_t capacity;  ///< ...and its configured bound
  std::uint64_t units;     ///< of work done, to scale by
  std::uint64_t times;     ///< how often one plan may go through this at most
};

void report(const Cap& cap);

/// Every cap runs in the same grid words and the same planner's memory. Inflate what you mark.
tern::Grid make_grid(const tern::Voxel& dims, double cell, double radius);
void* memory() noexcept;
constexpr std::size_t kMemoryBytes = tern::kWorkspaceBytes + (std::size_t{32} << 20);

/// A stage's state in memory(), with no initial value; `offset` in bytes, a multiple of 64.
template <typename T>
T& state_at(std::size_t offset) noexcept {
  return *reinterpret_cast<T*>(static_cast<unsigned char*>(memory()) + offset);
}

/// Counts the instructions of a call.
std::uint64_t now() noexcept;
template <typename Call>
std::uint64_t count(const Call& call) {
  const std::uint64_t begin = now();
  call();
  return now() - begin;
}

/// Work that no loop here uses up, and the units that were spent of it.
constexpr std::uint32_t kUnlimited = 0xFFFFFFFFu;
inline std::uint64_t units_of(const tern::Work& work) {
  return static_cast<std::uint64_t>((tern::Work{kUnlimited}.operations() - work.operations()) / tern::kUnit);
}

/// A request from rest to rest between two points of the world frame.
tern::Request request_between(const tern::Vec3& start, const tern::Vec3& goal);

// One function a file, each reports its rows.
void grid_caps();
void search_caps();
void guided_caps();
void shortcut_caps();
void corridor_caps();
void programme_caps();
void check_caps();
void map_caps();
void yaw_caps();
void via_caps();
void track_caps();

}  // namespace tern_caps

#endif
