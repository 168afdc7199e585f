// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The identity map as constant tables: no code runs with the MMU off but the reset's few lines. 2 MB blocks of RAM:
// code read-only, data never executed; everything else, address 0 and the block below the stack included, faults.
// Device registers need entries of their own with a device attribute; semihosting needs none.

.equ BLOCK, 1 | (3 << 8) | (1 << 10)            // a block, inner shareable, accessed, attribute 0
.equ CODE, BLOCK | (2 << 6) | (1 << 54)         // read-only, not executable by EL0
.equ DATA, BLOCK | (3 << 53)                    // read-write, not executable
.equ TABLE, 3
.equ RAM, 0x40000000
.equ SIZE, 0x200000

.section .rodata.memory_map, "a"
.balign 4096
.global tern_board_level1
tern_board_level1:                              // one entry a gigabyte
    .quad   0
    .quad   tern_board_level2 + TABLE
    .quad   0, 0

.balign 4096
tern_board_level2:                              // the gigabyte of RAM; virt.ld places the image to fit
    .quad   0                                   // 0x40000000  device tree, not used
    .quad   RAM + 1 * SIZE + CODE               // 0x40200000  code and constants
    .quad   0                                   // 0x40400000  guard: a stack overflow faults here
    .quad   RAM + 3 * SIZE + DATA               // 0x40600000  stack
    .set    i, 4
    .rept   508                                 // 0x40800000  data, to the end of 1 GB
    .quad   RAM + i * SIZE + DATA
    .set    i, i + 1
    .endr
