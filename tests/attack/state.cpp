// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The state file of a run: finished blocks, their tallies and violations, as text.
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "attack/runner.hpp"

namespace tern_attack {
namespace {

/// A hash of the running program, so that a run does not go on from another build's results.
std::uint64_t own_hash() {
  static const std::uint64_t kHash = [] {
    std::ifstream file("/proc/self/exe", std::ios::binary);
    std::uint64_t hash = 0xCBF29CE484222325u;
    char buffer[1 << 16];
    while (file.read(buffer, sizeof buffer) || file.gcount() > 0) {
      for (std::streamsize k = 0; k < file.gcount(); ++k) {
        hash = (hash ^ static_cast<unsigned char>(buffer[k])) * 0x100000001B3u;
      }
    }
    return hash;
  }();
  return kHash;
}

void save_tally(std::ostream& out, const Tally& t) {
  out << "tally " << t.cases << ' ' << t.plans << ' ' << t.replans << ' ' << t.compared << ' ' << t.hover << ' '
      << t.stop_and_go << ' ' << t.optimised << ' ' << t.needed << ' ' << t.followed << ' ' << t.work;
  for (int s = 0; s < 256; ++s) {
    if (t.status[s] != 0) out << ' ' << s << ' ' << t.status[s];
  }
  out << '\n';
}

void load_tally(std::istream& in, Tally& t) {
  in >> t.cases >> t.plans >> t.replans >> t.compared >> t.hover >> t.stop_and_go >> t.optimised >> t.needed >>
      t.followed >> t.work;
  int s = 0;
  std::uint64_t count = 0;
  while (in >> s >> count) t.status[s & 255] = count;
}

void load_line(const std::string& line, std::size_t& family, Progress& progress) {
  std::istringstream in(line);
  std::string word;
  in >> word;
  if (word == "seconds") in >> progress.seconds;
  if (word == "tally" && family < kFamilies) load_tally(in, progress.tallies[family++]);
  if (word == "block") {
    std::uint64_t block = 0;
    in >> block;
    progress.blocks.insert(block);
  }
  if (word == "violation") {
    Violation v;
    in >> v.number >> v.kind;
    std::getline(in >> std::ws, v.detail);
    progress.violations.push_back(v);
  }
}

}  // namespace

std::string state_path(const Options& o) {
  const std::string family = o.family < 0 ? "" : std::string("-") + family_name(static_cast<Family>(o.family));
  const std::string first = o.first == 0 ? "" : "-from" + std::to_string(o.first);
  return o.folder + "/seed" + std::to_string(o.seed) + (o.things ? "-things" : "") + family + first;
}

void save_state(const Options& options, const Progress& progress) {
  if (options.folder.empty()) return;
  const std::string path = state_path(options) + ".state";
  {
    std::ofstream out(path + ".new");
    out << "program " << own_hash() << "\nseconds " << progress.seconds << '\n';
    out << "families";
    for (int f = 0; f < kFamilies; ++f) out << ' ' << family_name(static_cast<Family>(f));
    out << '\n';
    for (const Tally& t : progress.tallies) save_tally(out, t);
    for (const std::uint64_t block : progress.blocks) out << "block " << block << '\n';
    for (const Violation& v : progress.violations)
      out << "violation " << v.number << ' ' << v.kind << ' ' << v.detail << '\n';
  }
  (void)std::rename((path + ".new").c_str(), path.c_str());
}

void load_state(const Options& options, Progress& progress) {
  if (options.folder.empty()) return;
  std::ifstream in(state_path(options) + ".state");
  std::string line;
  if (!std::getline(in, line)) return;
  std::istringstream head(line);
  std::string word;
  std::uint64_t hash = 0;
  head >> word >> hash;
  if (hash != own_hash()) return;
  std::size_t family = 0;
  while (std::getline(in, line)) load_line(line, family, progress);
}

}  // namespace tern_attack
