// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/runner.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>

namespace tern_attack {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What a worker tells the parent even if it crashes. Shared memory, all zero at first.
struct Slot {
  volatile std::uint64_t next;  ///< index of the case under way
  Tally tallies[kFamilies];     ///< of the part of the block that is done
};

struct Worker {
  Slot* slot = nullptr;
  pid_t pid = -1;
  int pipe = -1;
  std::string text;  ///< of a line that has not ended yet
  std::uint64_t block = 0;
  std::uint64_t last = 0;  ///< index of the case seen last, and since when
  double since = 0.0;
  bool ended = false;  ///< by the parent, because its case took too long
  std::vector<Violation> violations;
};

Bench& bench() {
  static Bench instance;
  return instance;
}

std::uint64_t block_end(const Options& o, std::uint64_t block) {
  return std::min(o.cases, (block + 1) * kBlock);
}

/// The child: all cases from `from` to the block's end, a line a violation, "done" at the end.
[[noreturn]] void work(const Options& options, std::uint64_t from, std::uint64_t end, Slot& slot, int out) {
  bench().things = options.things;
  for (std::uint64_t i = from; i < end; ++i) {
    slot.next = i;
    Findings findings;
    const std::uint64_t number = case_at(options, i);
    if (options.before_case != nullptr) options.before_case(number);
    run_case(bench(), options.seed, number, false, slot.tallies, findings);
    for (const Finding& f : findings) {
      const std::string line = std::to_string(number) + " " + f.kind + " " + f.detail + "\n";
      if (write(out, line.data(), line.size()) < 0) _exit(2);
    }
  }
  (void)!write(out, "done\n", 5);
  _exit(0);
}

void start(const Options& options, Worker& w, std::uint64_t from) {
  int ends[2];
  std::fflush(stdout);
  if (pipe(ends) != 0) _exit(2);
  w.slot->next = from;
  w.last = from;
  w.since = now();
  w.ended = false;
  w.pid = fork();
  if (w.pid == 0) {
    close(ends[0]);
    work(options, from, block_end(options, w.block), *w.slot, ends[1]);
  }
  close(ends[1]);
  w.pipe = ends[0];
}

class Run {
 public:
  Run(const Options& options, Progress& progress) : options_(options), progress_(progress) {
    blocks_ = (options.cases + kBlock - 1) / kBlock;
    began_ = now() - progress.seconds;
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    const int jobs = options.jobs > 0 ? options.jobs : static_cast<int>(cores > 0 ? cores : 1);
    void* memory = mmap(nullptr, sizeof(Slot) * static_cast<std::size_t>(jobs), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) _exit(2);
    workers_.resize(static_cast<std::size_t>(jobs));
    for (std::size_t k = 0; k < workers_.size(); ++k) workers_[k].slot = static_cast<Slot*>(memory) + k;
  }

  void all() {
    for (Worker& w : workers_) next_block(w);
    while (busy() > 0) {
      std::vector<pollfd> waits;
      for (const Worker& w : workers_) waits.push_back({w.pipe, POLLIN, 0});
      (void)poll(waits.data(), waits.size(), 500);
      for (std::size_t k = 0; k < workers_.size(); ++k) {
        if (workers_[k].pipe >= 0 && waits[k].revents != 0) read_from(workers_[k]);
        if (workers_[k].pipe >= 0) watch(workers_[k]);
      }
      show(false);
    }
    progress_.seconds = now() - began_;
    show(true);
  }

 private:
  int busy() const {
    int count = 0;
    for (const Worker& w : workers_) count += w.pipe >= 0;
    return count;
  }

  void next_block(Worker& w) {
    while (next_ < blocks_ && progress_.blocks.count(next_) != 0) ++next_;
    if (next_ >= blocks_) return;
    w.block = next_++;
    std::memset(w.slot->tallies, 0, sizeof w.slot->tallies);
    w.violations.clear();
    start(options_, w, w.block * kBlock);
  }

  void note(Worker& w, const Violation& violation) {
    if (!options_.quiet) std::fprintf(stderr, "\r%78s\r", "");
    std::printf("%s\n", violation_line(options_, violation).c_str());
    w.violations.push_back(violation);
  }

  void read_from(Worker& w) {
    char buffer[4096];
    const ssize_t got = read(w.pipe, buffer, sizeof buffer);
    if (got <= 0) return ended(w);
    w.text.append(buffer, static_cast<std::size_t>(got));
    for (std::size_t end = w.text.find('\n'); end != std::string::npos; end = w.text.find('\n')) {
      const std::string line = w.text.substr(0, end);
      w.text.erase(0, end + 1);
      if (line != "done") take_line(w, line);
    }
  }

  void take_line(Worker& w, const std::string& line) {
    const std::size_t first = line.find(' ');
    const std::size_t second = line.find(' ', first + 1);
    note(w, {std::stoull(line.substr(0, first)), line.substr(first + 1, second - first - 1), line.substr(second + 1)});
  }

  /// The child is gone: it finished its block, or the case in its slot ended it.
  void ended(Worker& w) {
    close(w.pipe);
    w.pipe = -1;
    w.text.clear();
    int how = 0;
    waitpid(w.pid, &how, 0);
    if (WIFEXITED(how) && WEXITSTATUS(how) == 0) return finish_block(w);
    const std::uint64_t at = w.slot->next;
    const std::string what = WIFSIGNALED(how) ? strsignal(WTERMSIG(how)) : "exit " + std::to_string(WEXITSTATUS(how));
    note(w, {case_at(options_, at), w.ended ? "too_long" : "crash", what});
    if (at + 1 < block_end(options_, w.block)) return start(options_, w, at + 1);
    finish_block(w);
  }

  void finish_block(Worker& w) {
    Tallies part{};
    std::memcpy(part.data(), w.slot->tallies, sizeof w.slot->tallies);
    add(part, progress_.tallies);
    progress_.blocks.insert(w.block);
    for (Violation& v : w.violations) progress_.violations.push_back(std::move(v));
    progress_.seconds = now() - began_;
    save_state(options_, progress_);
    next_block(w);
  }

  /// Ends a child whose case takes too long.
  void watch(Worker& w) {
    const std::uint64_t at = w.slot->next;
    if (at != w.last) {
      w.last = at;
      w.since = now();
    } else if (now() - w.since > options_.seconds_a_case) {
      w.ended = kill(w.pid, SIGKILL) == 0;
      w.since = now();
    }
  }

  void show(bool last) {
    if (options_.quiet || (!last && now() - shown_ < 1.0)) return;
    shown_ = now();
    std::uint64_t done = 0;
    for (const Tally& t : progress_.tallies) done += t.cases;
    std::fprintf(stderr, "\r%llu of %llu cases, %.0f s, %.0f cases/s, %zu violations%s",
                 static_cast<unsigned long long>(done), static_cast<unsigned long long>(options_.cases), now() - began_,
                 static_cast<double>(done) / std::max(1e-3, now() - began_), progress_.violations.size(),
                 last ? "\n" : "");
  }

  const Options& options_;
  Progress& progress_;
  std::vector<Worker> workers_;
  std::uint64_t blocks_ = 0;
  std::uint64_t next_ = 0;
  double began_ = 0.0;
  double shown_ = 0.0;
};

}  // namespace

std::uint64_t case_at(const Options& options, std::uint64_t index) {
  index += options.first;
  return options.family < 0 ? index : index * kFamilies + static_cast<std::uint64_t>(options.family);
}

void add(const Tallies& part, Tallies& sum) {
  for (std::size_t f = 0; f < kFamilies; ++f) {
    sum[f].cases += part[f].cases;
    sum[f].plans += part[f].plans;
    sum[f].replans += part[f].replans;
    sum[f].needed += part[f].needed;
    sum[f].followed += part[f].followed;
    sum[f].compared += part[f].compared;
    sum[f].hover += part[f].hover;
    sum[f].stop_and_go += part[f].stop_and_go;
    sum[f].optimised += part[f].optimised;
    sum[f].work += part[f].work;
    for (int s = 0; s < 256; ++s) sum[f].status[s] += part[f].status[s];
  }
}

std::string violation_line(const Options& options, const Violation& v) {
  return "violation " + v.kind + " " + family_name(family_of(v.number)) + " --seed " + std::to_string(options.seed) +
         " --case " + std::to_string(v.number) + (options.things ? " --things: " : ": ") + v.detail;
}

void run_all(const Options& options, Progress& progress) {
  Run(options, progress).all();
}

}  // namespace tern_attack
