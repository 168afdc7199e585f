// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tern_companion: waits for bytes and for the next tick, and hands both to the Companion. README.md says how to fly it.
#include <poll.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include "companion/companion.hpp"
#include "companion/depth_socket.hpp"
#include "companion/options.hpp"
#include "companion/transport.hpp"

namespace {

using namespace tern_companion;

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int /*number*/) {
  interrupted = 1;
}

std::int64_t monotonic() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1000000000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec;
}

void say(const std::string& text) {
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
}

class Program {
 public:
  explicit Program(const Options& options)
      : lockstep_(options.lockstep),
        link_(open_transport(options.link)),
        companion_(options.companion, {[this](const std::vector<std::uint8_t>& bytes) { link_->send(bytes); }, say}),
        depth_(
            options.depth,
            [this](const tern_depth_header& header, const std::uint8_t* payload) { take(header, payload); }, say) {}

  int run() {
    say("listens");
    say(phase_text(companion_.phase()));
    while (!companion_.outcome()) {
      wait();
      if (interrupted != 0) companion_.end();
      read_link();
      depth_.read();
      if (!lockstep_) companion_.tick(now());
    }
    companion_.save();
    say(companion_.summary(now()));
    return *companion_.outcome();
  }

 private:
  std::int64_t now() const { return lockstep_ ? stepped_ : monotonic(); }

  void wait() {
    std::vector<pollfd> files{{link_->descriptor(), POLLIN, 0}};
    for (const int descriptor : depth_.descriptors()) files.push_back({descriptor, POLLIN, 0});
    const std::int64_t left = lockstep_ ? 100000000 : companion_.next_tick(now()) - now();
    const std::int64_t whole = left < 0 ? 0 : left;
    const timespec most{whole / 1000000000, whole % 1000000000};
    ppoll(files.data(), files.size(), &most, nullptr);
  }

  /// In lockstep, frames wait for the step that they belong to. They are read before, because a sender with a frame
  /// that is larger than the socket's buffer waits, too.
  void take(const tern_depth_header& header, const std::uint8_t* payload) {
    if (!lockstep_) return companion_.take_depth(header, payload, now());
    frames_.emplace_back(header, std::vector<std::uint8_t>(payload, payload + header.payload_bytes));
  }

  /// In lockstep, a request of time is the step to that time. The answer, which says that the step is done, goes out
  /// after it.
  void read_link() {
    std::array<std::uint8_t, 4096> bytes;
    while (const std::size_t count = link_->receive(bytes.data(), bytes.size())) {
      if (companion_.read(bytes.data(), count, now())) link_->keep_peer();
      if (!companion_.time_request()) continue;
      if (lockstep_) {
        stepped_ = companion_.time_request()->ts1;
        depth_.read();
        for (const auto& [header, payload] : frames_) companion_.take_depth(header, payload.data(), now());
        frames_.clear();
        companion_.tick(now());
        if (companion_.outcome()) return;
      }
      companion_.answer_time(now());
    }
  }

  bool lockstep_;
  std::int64_t stepped_ = 0;
  std::unique_ptr<Transport> link_;
  Companion companion_;
  DepthSocket depth_;
  std::vector<std::pair<tern_depth_header, std::vector<std::uint8_t>>> frames_;
};

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    Options options;
    int status = 0;
    if (!read_options(argc, argv, options, status)) return status;
    return std::make_unique<Program>(options)->run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
