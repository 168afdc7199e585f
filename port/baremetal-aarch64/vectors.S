// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every exception is a fault here: nothing enables an interrupt. Each of the sixteen entries reports which one it was,
// on a stack of its own, since the fault may be the stack's.

.macro entry index
    .balign 128
    mov     x0, #\index
    b       fault
.endm

.section .text.vectors, "ax"
.balign 2048
.global tern_board_vectors
tern_board_vectors:
    .irp    index, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
    entry   \index
    .endr

fault:
    mov     x1, sp
    mov     x2, x30
    ldr     x3, =__fault_stack_top
    mov     sp, x3
    b       tern_board_fault
