// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vectors and reset. The program runs on the process stack, exceptions on the main stack, so that a stack overflow of
// the program can still be reported.
.syntax unified
.thumb

.equ CPACR, 0xE000ED88
.equ CPACR_FPU, 0xF << 20
.equ SHCSR, 0xE000ED24
.equ SHCSR_FAULTS, 7 << 16          // usage, bus and memory faults by name instead of all as a hard fault
.equ MPU_CTRL, 0xE000ED94           // control, then region number, base and attributes
.equ MPU_ON, 5                      // enabled; what no region covers keeps its default access
.equ MPU_NO_ACCESS_8K, 1 | (12 << 1) | (1 << 28)

.section .vectors, "a"
.global tern_board_vectors
tern_board_vectors:
    .word   __fault_stack_top       // the main stack
    .word   _start                  // 1 reset
    .word   fault                   // 2 non-maskable interrupt
    .word   fault                   // 3 hard fault
    .word   fault                   // 4 memory management
    .word   fault                   // 5 bus
    .word   fault                   // 6 usage
    .word   0, 0, 0, 0
    .word   fault                   // 11 supervisor call
    .word   fault                   // 12 debug monitor
    .word   0
    .word   fault                   // 14 pending supervisor call
    .word   tern_board_systick      // 15 SysTick
    .rept   32
    .word   fault                   // external interrupts: none is enabled
    .endr

.section .text.start, "ax"
.global _start
.type _start, %function
.thumb_func
_start:
    ldr     r0, =__stack_top
    msr     psp, r0
    movs    r0, #2                  // privileged, process stack
    msr     control, r0
    isb
    ldr     r0, =CPACR
    ldr     r1, [r0]
    orr     r1, r1, #CPACR_FPU
    str     r1, [r0]
    ldr     r0, =SHCSR
    ldr     r1, [r0]
    orr     r1, r1, #SHCSR_FAULTS
    str     r1, [r0]
    ldr     r0, =MPU_CTRL
    movs    r1, #0
    ldr     r2, =__guard
    ldr     r3, =MPU_NO_ACCESS_8K
    str     r1, [r0, #4]
    str     r2, [r0, #8]
    str     r3, [r0, #12]
    movs    r1, #MPU_ON
    str     r1, [r0]
    dsb
    isb
    movs    r0, #0
    vmsr    fpscr, r0               // round to nearest, no flush to zero: what self_test() asks for
    bl      tern_board_run
    b       .

.type fault, %function
.thumb_func
fault:
    mrs     r0, ipsr
    tst     lr, #4                  // EXC_RETURN: which stack the registers were pushed on
    ite     eq
    mrseq   r1, msp
    mrsne   r1, psp
    b       tern_board_fault
