// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/atomic_file.hpp"

#include <fcntl.h>
#include <limits.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace tern_host {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw std::runtime_error(path + ": " + what + ": " + std::strerror(errno));
}

/// A link stays a link: what it points at is replaced.
std::string resolve(const std::string& path) {
  char buffer[PATH_MAX];
  return realpath(path.c_str(), buffer) != nullptr ? std::string(buffer) : path;
}

bool exists_as_other_than_file(const std::string& path) {
  struct stat info {};
  return stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode);
}

bool write_all(int file, const std::string& content) {
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t n = write(file, content.data() + done, content.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

/// Where files named "-" go.
int standard_output = STDOUT_FILENO;

bool is_standard_output(const std::string& path) {
  return path == "-";
}

void write_to_standard_output(const std::string& content) {
  if (!write_all(standard_output, content)) fail("standard output", "cannot be written");
}

void write_directly(const std::string& path, const std::string& content) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) fail(path, "cannot be opened");
  const bool written = write_all(file, content);
  if (close(file) != 0 || !written) fail(path, "cannot be written");
}

/// Permissions of the file to be replaced, else those that open() would give.
mode_t mode_of(const std::string& path) {
  struct stat info {};
  if (stat(path.c_str(), &info) == 0) return info.st_mode & 07777;
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

/// A complete temporary file beside the one whose place it is to take; gone again unless it does.
class Staged {
 public:
  Staged(const std::string& path, const std::string& content)
      : path_(path), target_(resolve(path)), temporary_(target_ + ".XXXXXX") {
    const int file = mkstemp(&temporary_[0]);
    if (file < 0) fail(path, "cannot be created");
    const bool written = write_all(file, content) && fchmod(file, mode_of(target_)) == 0 && fsync(file) == 0;
    if (close(file) == 0 && written) return;
    discard();
    fail(path, "cannot be written");
  }
  Staged(const Staged&) = delete;
  Staged& operator=(const Staged&) = delete;
  ~Staged() {
    if (!placed_) discard();
  }

  void place() {
    placed_ = rename(temporary_.c_str(), target_.c_str()) == 0;
    if (!placed_) fail(path_, "cannot be written");
  }

 private:
  void discard() const {
    const int reason = errno;
    unlink(temporary_.c_str());
    errno = reason;
  }

  std::string path_;
  std::string target_;
  std::string temporary_;
  bool placed_ = false;
};

}  // namespace

void write_files(const std::vector<Output>& outputs) {
  std::vector<std::unique_ptr<Staged>> staged;
  for (const Output& output : outputs) {
    if (!is_standard_output(output.path) && !exists_as_other_than_file(output.path)) {
      staged.push_back(std::make_unique<Staged>(output.path, output.content));
    }
  }
  for (const Output& output : outputs) {
    if (is_standard_output(output.path)) {
      write_to_standard_output(output.content);
    } else if (exists_as_other_than_file(output.path)) {
      write_directly(output.path, output.content);
    }
  }
  for (const std::unique_ptr<Staged>& file : staged) file->place();
}

void keep_standard_output_for_files() {
  const int kept = dup(STDOUT_FILENO);
  if (kept < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) fail("standard output", "cannot be kept");
  standard_output = kept;
}

void write_file(const std::string& path, const std::string& content) {
  write_files({{path, content}});
}

}  // namespace tern_host
