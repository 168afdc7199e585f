// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "autopilot/companion_process.hpp"

#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace tern_autopilot {
namespace {

sockaddr_in local(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

int open_socket() {
  const int descriptor = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const sockaddr_in any = local(0);
  if (bind(descriptor, reinterpret_cast<const sockaddr*>(&any), sizeof any) != 0) throw std::runtime_error("no UDP");
  return descriptor;
}

std::uint16_t free_port() {
  const int descriptor = open_socket();
  sockaddr_in got{};
  socklen_t length = sizeof got;
  getsockname(descriptor, reinterpret_cast<sockaddr*>(&got), &length);
  close(descriptor);
  return ntohs(got.sin_port);
}

/// In the child: never comes back.
[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments, int output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // it ends with the simulator
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(program.c_str(), words.data());
  _exit(127);
}

}  // namespace

CompanionProcess::CompanionProcess(const std::string& program, const std::vector<std::string>& arguments) {
  std::string pattern = (std::filesystem::temp_directory_path() / "tern_companion_XXXXXX").string();
  folder_ = mkdtemp(pattern.data());
  depth_path_ = folder_ + "/depth";
  socket_ = open_socket();
  port_ = free_port();
  std::vector<std::string> words{"--link", "udp:" + std::to_string(port_), "--depth", depth_path_};
  words.insert(words.end(), arguments.begin(), arguments.end());
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  process_ = fork();
  if (process_ == 0) become(program, words, ends[1]);
  close(ends[1]);
  output_ = ends[0];
  wait_until_it_says("listens");
}

void CompanionProcess::wait_until_it_says(const std::string& line) {
  while (said_.find(line + "\n") == std::string::npos) {
    read_output(100);
    if (has_ended()) throw std::runtime_error("the companion ended before it said '" + line + "'. It said: " + said());
  }
}

CompanionProcess::~CompanionProcess() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close(socket_);
  close(output_);
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void CompanionProcess::send(const std::vector<std::uint8_t>& bytes) {
  const sockaddr_in to = local(port_);
  sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
}

std::vector<std::uint8_t> CompanionProcess::receive(int milliseconds) {
  std::array<pollfd, 2> files{{{socket_, POLLIN, 0}, {output_, POLLIN, 0}}};
  std::vector<std::uint8_t> bytes;
  poll(files.data(), process_ > 0 ? 2 : 1, milliseconds);
  if (files[1].revents != 0) read_output(0);
  if ((files[0].revents & POLLIN) == 0) return bytes;
  bytes.resize(2048);
  const ssize_t got = recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

void CompanionProcess::read_output(int milliseconds) {
  pollfd file{output_, POLLIN, 0};
  while (poll(&file, 1, milliseconds) > 0) {
    std::array<char, 4096> text;
    const ssize_t got = read(output_, text.data(), text.size());
    if (got <= 0) {  // it has closed its output: it is about to end
      if (process_ > 0) waitpid(process_, &status_, 0);
      process_ = -1;
      return;
    }
    said_.append(text.data(), static_cast<std::size_t>(got));
    milliseconds = 0;
  }
}

void CompanionProcess::interrupt() {
  if (process_ > 0) kill(process_, SIGINT);
}

void CompanionProcess::crash() {
  if (process_ > 0) kill(process_, SIGKILL);
  wait();
}

bool CompanionProcess::has_ended() {
  return process_ < 0;
}

int CompanionProcess::wait() {
  while (process_ > 0) read_output(100);
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

const std::string& CompanionProcess::said() {
  if (process_ > 0) read_output(0);
  return said_;
}

}  // namespace tern_autopilot
