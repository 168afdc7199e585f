// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "linux-perf/perf_counter.hpp"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace tern_port {
namespace {

int open_counter(PerfCounter::Event event) noexcept {
  perf_event_attr attributes{};
  attributes.type = PERF_TYPE_HARDWARE;
  attributes.size = sizeof attributes;
  attributes.config = event == PerfCounter::Event::kCycles ? PERF_COUNT_HW_CPU_CYCLES : PERF_COUNT_HW_INSTRUCTIONS;
  attributes.exclude_kernel = 1;
  attributes.exclude_hv = 1;
  constexpr int kThisThread = 0;
  constexpr int kAnyProcessor = -1;
  constexpr int kNoGroup = -1;
  return static_cast<int>(syscall(SYS_perf_event_open, &attributes, kThisThread, kAnyProcessor, kNoGroup, 0));
}

}  // namespace

PerfCounter::PerfCounter(Event event) noexcept : file_(open_counter(event)) {}

PerfCounter::~PerfCounter() {
  if (file_ >= 0) close(file_);
}

std::uint64_t PerfCounter::read() const noexcept {
  std::uint64_t value = 0;
  if (file_ < 0 || ::read(file_, &value, sizeof value) != static_cast<ssize_t>(sizeof value)) return 0;
  return value;
}

std::uint64_t perf_ticks(void* counter) noexcept {
  return static_cast<const PerfCounter*>(counter)->read();
}

}  // namespace tern_port
