// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "target/machine.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tern/self_test.hpp"
#include "tern_port/port.hpp"

namespace tern_target {
namespace {

constexpr const char* kUnknown = "unknown";

/// The first line, or text up to a device tree's terminating zero; empty where the file cannot be read.
std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line.substr(0, line.find('\0'));
}

/// The value of the first "key : value" line of /proc/cpuinfo; empty where there is none.
std::string cpuinfo(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos || line.compare(0, key.size(), key) != 0) continue;
    if (line.find_first_not_of(" \t", key.size()) != colon) continue;
    const std::size_t value = line.find_first_not_of(" \t", colon + 1);
    return value == std::string::npos ? "" : line.substr(value);
  }
  return "";
}

std::string or_unknown(const std::string& text) {
  return text.empty() ? kUnknown : text;
}

std::string board() {
  const std::string model = first_line("/proc/device-tree/model");
  if (!model.empty()) return model;
  const std::string vendor = first_line("/sys/class/dmi/id/sys_vendor");
  const std::string product = first_line("/sys/class/dmi/id/product_name");
  return vendor.empty() && product.empty() ? kUnknown : vendor + " " + product;
}

std::string cpu() {
  const std::string model = cpuinfo("model name");
  if (!model.empty()) return model;
  const std::string implementer = cpuinfo("CPU implementer");
  if (implementer.empty()) return kUnknown;
  return "implementer " + implementer + ", part " + cpuinfo("CPU part") + ", revision " + cpuinfo("CPU revision");
}

std::string kernel() {
  utsname name{};
  if (uname(&name) != 0) return kUnknown;
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

/// Kilohertz as the kernel's files give them.
std::string megahertz(const std::string& kilohertz) {
  return kilohertz.empty() ? kUnknown : std::to_string(std::strtol(kilohertz.c_str(), nullptr, 10) / 1000) + " MHz";
}

std::string governor(int processor) {
  const std::string folder =
      "/sys/devices/system/cpu/cpu" + std::to_string(processor < 0 ? 0 : processor) + "/cpufreq/";
  const std::string name = first_line(folder + "scaling_governor");
  if (name.empty())
    return "not told (clock " + (cpuinfo("cpu MHz").empty() ? kUnknown : cpuinfo("cpu MHz") + " MHz") + ")";
  return name + ", " + megahertz(first_line(folder + "scaling_cur_freq")) + " of at most " +
         megahertz(first_line(folder + "cpuinfo_max_freq"));
}

std::string timer() {
  std::ostringstream out;
  out << 1e9 / tern_port::ticks_per_second() << " ns a tick";
  return out.str();
}

std::string build() {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016" PRIx64, tern::configuration_hash());
#if defined(__clang__)
  const std::string compiler = __VERSION__;
#else
  const std::string compiler = "GCC " __VERSION__;
#endif
  return compiler + ", profile " TERN_PROFILE_NAME ", configuration " + hash;
}

/// qemu-user shows the host's /proc/cpuinfo (through QEMU 7) or a processor of no implementer (-cpu max).
bool emulated() {
#if defined(__aarch64__)
  const std::string implementer = cpuinfo("CPU implementer");
  return implementer.empty() || implementer == "0x00";
#else
  return false;
#endif
}

}  // namespace

Machine describe_machine(int processor) {
  Machine out;
  out.emulated = emulated();
  out.virtualised = (" " + cpuinfo("flags") + " ").find(" hypervisor ") != std::string::npos;
  out.board = board();
  out.cpu = or_unknown(cpu());
  out.processors = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  out.kernel = kernel();
  out.governor = governor(processor);
  out.timer = timer();
  out.build = build();
  return out;
}

std::vector<std::string> lines_of(const Machine& machine) {
  std::vector<std::string> out = {
      "board: " + machine.board,   "cpu: " + machine.cpu + ", " + std::to_string(machine.processors) + " online",
      "kernel: " + machine.kernel, "clock scaling: " + machine.governor,
      "timer: " + machine.timer,   "build: " + machine.build};
  if (machine.emulated) out.push_back("EMULATED: no time or cycle below means anything");
  if (machine.virtualised) out.push_back("a virtual machine: the work of others is in the maxima");
  return out;
}

}  // namespace tern_target
