// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <memory>
#include <vector>

#include "fuzz/fuzz_checks.hpp"
#include "tern/record.hpp"

namespace tern_fuzz {
namespace {

constexpr std::size_t kMostGridWords = 1u << 16;

bool same_plan(const tern::Trajectory& a, const tern::Trajectory& b) {
  if (a.count != b.count || a.begin != b.begin || std::memcmp(&a.origin, &b.origin, sizeof a.origin) != 0) return false;
  for (int k = 0; k < a.count; ++k) {
    const tern::Segment& p = a.segments[k];
    const tern::Segment& q = b.segments[k];
    const bool same = std::memcmp(&p.duration, &q.duration, sizeof p.duration) == 0 &&
                      std::memcmp(p.points, q.points, sizeof p.points) == 0 && p.polyhedron == q.polyhedron;
    if (!same) return false;
  }
  return true;
}

std::string check_bytes(const std::vector<std::uint8_t>& bytes) {
  static tern::PlanRecord record;
  if (tern::read_plan_record(bytes.data(), bytes.size(), record) != tern::Status::kOk) return "";
  const std::size_t count = tern::grid_words(record.grid.dims);
  if (count == 0 || count > kMostGridWords) return "";
  std::vector<std::uint64_t> words(count);
  tern::Grid grid;
  if (tern::read_plan_record(bytes.data(), bytes.size(), record, grid, words.data(), count) != tern::Status::kOk) {
    return "";
  }
  std::vector<std::uint8_t> again(tern::plan_record_bytes(record.grid.dims));
  std::size_t used = 0;
  const tern::Status status =
      tern::record_plan(grid, record.request, record.status, record.plan, again.data(), again.size(), &used);
  if (status != tern::Status::kOk) return "what was read cannot be recorded";
  again.resize(used);
  // A record may say the same in more runs than needed, so what is compared is a second reading.
  const auto other = std::make_unique<tern::PlanRecord>();
  if (tern::read_plan_record(again.data(), again.size(), *other) != tern::Status::kOk)
    return "what was recorded is damaged";
  // A plan belongs to an answer that is one.
  if (record.status == tern::Status::kOk && !same_plan(record.plan, other->plan))
    return "the plan differs when it is read again";
  const bool same = other->status == record.status && other->request.fence_count == record.request.fence_count &&
                    other->request.via_count == record.request.via_count;
  return same ? "" : "the request differs when it is read again";
}

void put(std::vector<std::uint8_t>& bytes, std::size_t word, std::uint64_t value) {
  for (std::size_t k = 0; k < 8; ++k) bytes[8 * word + k] = static_cast<std::uint8_t>(value >> (8 * k));
}

}  // namespace

std::string check_record(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> bytes(data, data + size);
  const std::string wrong = check_bytes(bytes);
  const std::size_t words = size / 8;
  if (!wrong.empty() || words < 8) return wrong;
  bytes.resize(8 * words);
  put(bytes, 3, words);
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (std::size_t k = 0; k < 8 * (words - 1); ++k) hash = (hash ^ bytes[k]) * 0x100000001B3u;
  put(bytes, words - 1, hash);
  return check_bytes(bytes);
}

}  // namespace tern_fuzz
