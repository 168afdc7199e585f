// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the machine's start-up code to main: the C++ part of start-up, the same on every board.
#include <cstdint>

#include "baremetal/board.hpp"

extern "C" {
// Of the linker script; byte ranges in whole words.
extern std::uint32_t __data_load[];
extern std::uint32_t __data_start[];
extern std::uint32_t __data_end[];
extern std::uint32_t __bss_start[];
extern std::uint32_t __bss_end[];
using Constructor = void (*)();
extern Constructor __init_array_start[];
extern Constructor __init_array_end[];
}

// The image's main under its assembler name: C++ does not let main be called.
int image_main(int argc, char** argv) asm("main");

namespace {

constexpr int kCommandLineBytes = 1024;
constexpr int kMaxArguments = 16;

char command_text[kCommandLineBytes];
char* arguments[kMaxArguments + 1];

void initialise_memory() {
  const std::uint32_t* from = __data_load;
  if (from != __data_start) {
    for (std::uint32_t* word = __data_start; word < __data_end; ++word) *word = *from++;
  }
  for (std::uint32_t* word = __bss_start; word < __bss_end; ++word) *word = 0;
}

/// Cuts the text at blanks, in place; what is beyond kMaxArguments stays part of the last one.
int split(char* text) {
  int count = 0;
  while (count < kMaxArguments) {
    while (*text == ' ') ++text;
    if (*text == '\0') break;
    arguments[count++] = text;
    while (*text != ' ' && *text != '\0') ++text;
    if (*text == ' ' && count < kMaxArguments) *text++ = '\0';
  }
  return count;
}

}  // namespace

/// Called by the start-up code with a stack, the FPU, and data memory that can be read and written.
extern "C" [[noreturn]] void tern_board_run() {
  initialise_memory();
  for (Constructor* constructor = __init_array_start; constructor < __init_array_end; ++constructor) (*constructor)();
  tern_board::start_counters();
  const int count = tern_board::command_line(command_text, kCommandLineBytes) ? split(command_text) : 0;
  tern_board::leave(image_main(count, arguments));
}
