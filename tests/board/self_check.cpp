// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Does the board itself work, before anything of the planner is believed: memory functions, floating point, counters,
// the painted stack, fault reports.
//   board_self_check              every check; exit status 0 where all hold
//   board_self_check --fault null|undefined|stack|execute    provoke a fault: its report, exit status 70
#include <cstdint>
#include <cstring>

#include "baremetal/board.hpp"
#include "tern/self_test.hpp"
#include "tern_port/port.hpp"

namespace {

using tern_board::hex;
using tern_board::print;

int failures = 0;

void expect(bool holds, const char* what) {
  print(holds ? "ok    " : "FAILS ", what, "\n");
  if (!holds) ++failures;
}

struct ByConstructor {
  ByConstructor() : value(failures + 41) {}
  int value;
};
ByConstructor constructed;
volatile int initialised = 7;
std::uint64_t cleared[4];
TERN_BOARD_LARGE unsigned char large[1024 * 1024];

void check_start_up() {
  expect(initialised == 7 && constructed.value == 41, "initialised data and constructors");
  expect((cleared[0] | cleared[1] | cleared[2] | cleared[3]) == 0, "cleared data");
  large[0] = 1;
  large[sizeof large - 1] = 2;
  expect(large[0] + large[sizeof large - 1] == 3, "the large memory");
}

/// Every offset and length up to a few bursts, against byte loops.
bool memory_functions_hold() {
  constexpr int kSize = 160;
  static unsigned char expected[kSize];
  static unsigned char actual[kSize];
  for (int to = 0; to < 9; ++to) {
    for (int from = 0; from < 9; ++from) {
      for (int count = 0; count < 80; ++count) {
        for (int i = 0; i < kSize; ++i) actual[i] = static_cast<unsigned char>(i * 7 + 1);
        for (int i = 0; i < kSize; ++i) expected[i] = actual[i];
        for (int i = 0; i < count; ++i) expected[to + i] = static_cast<unsigned char>((from + i) * 7 + 1);
        std::memmove(actual + to, actual + from, static_cast<std::size_t>(count));
        if (std::memcmp(actual, expected, kSize) != 0) return false;
        std::memset(actual + to, 0x5A, static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) expected[to + i] = 0x5A;
        std::memcpy(actual + 100, expected + from, 40);
        for (int i = 0; i < 40; ++i) expected[100 + i] = expected[from + i];
        for (int i = 0; i < kSize; ++i) {
          if (actual[i] != expected[i]) return false;
        }
      }
    }
  }
  return true;
}

/// A section whose result nobody can know before it runs.
__attribute__((noinline)) std::uint64_t section(int turns) {
  const std::uint64_t before = tern_board::counter();
  volatile double x = 1.0;
  for (int i = 0; i < turns; ++i) x = __builtin_sqrt(x + 1.0) * 0.75 + x / 3.0;
  return tern_board::counter() - before;
}

void check_counters() {
  const std::uint64_t a = tern_board::counter();
  const std::uint64_t b = tern_board::counter();
  const std::uint64_t c = tern_board::counter();
  print("      an empty section counts ", b - a, " and ", c - b, " ", tern_board::counter_unit(), "\n");
  const std::uint64_t first = section(1000);
  const std::uint64_t second = section(1000);
  const std::uint64_t twice = section(2000);
  print("      1000 turns count ", first, " and ", second, ", 2000 turns ", twice, "\n");
  expect(first > 1000 && twice > first && twice < 3 * first, "the counter counts");
#if defined(__aarch64__)
  expect(b - a == c - b && first == second && twice - first == section(3000) - twice, "the counter is exact");
#endif
  const std::uint64_t early = tern_port::monotonic_nanoseconds();
  section(1000);
  expect(tern_port::monotonic_nanoseconds() > early, "the clock moves on");
}

__attribute__((noinline)) void use_stack() {
  volatile unsigned char frame[3000];
  frame[0] = 1;
  frame[sizeof frame - 1] = 1;
}

void check_stack() {
  tern_board::paint_stack();
  const std::size_t before = tern_board::stack_used();
  use_stack();
  const std::size_t used = tern_board::stack_used();
  print("      stack ", tern_board::stack_size(), " bytes; high water ", before, ", then ", used, "\n");
  expect(before < 256 && used >= 3000 && used < 3300, "the painted stack");
}

/// Never returns: each turn's frame lies below the last one's.
__attribute__((noinline)) int overflow_stack(int depth) {
  volatile unsigned char frame[1024];
  frame[0] = static_cast<unsigned char>(depth);
  return depth > 1000000 ? frame[0] : overflow_stack(depth + 1) + frame[0];
}

bool equal(const char* a, const char* b) {
  while (*a != '\0' && *a == *b) ++a, ++b;
  return *a == *b;
}

/// An address where neither board has anything.
constexpr std::uintptr_t kNowhere = 0x3F000010;

int provoke(const char* fault) {
  print("provoking: ", fault, "\n");
  if (equal(fault, "address")) *reinterpret_cast<volatile int*>(kNowhere) = 1;
  if (equal(fault, "undefined")) asm volatile("udf #0");
  if (equal(fault, "stack")) return overflow_stack(0);
#if defined(__aarch64__)
  if (equal(fault, "execute")) reinterpret_cast<void (*)()>(reinterpret_cast<std::uintptr_t>(large))();
#endif
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && equal(argv[1], "--fault")) return provoke(argv[2]);
  print(tern_board::name(), "\n");
  check_start_up();
  expect(memory_functions_hold(), "memcpy, memmove, memset, memcmp");
  std::uint32_t faults = 0;
  const bool healthy = tern::self_test(tern::configuration_hash(), &faults) == tern::Status::kOk;
  print("      the core's self-test: faults 0x", hex(faults, 2), "\n");
  expect(healthy, "floating point");
  check_counters();
  check_stack();
  print(failures == 0 ? "self-check passed\n" : "self-check FAILED\n");
  return failures == 0 ? 0 : 1;
}
