// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reset: reach EL1, give it a stack, the FPU, vectors, memory attributes and caches, then run C++.

.equ SCTLR_EL1_RESET, 0x30D00800    // the bits that ARMv8.0 reserves as one; EL0 and EL1 little-endian
.equ SCTLR_MMU_AND_CACHES, 0x1005   // M, C, I
.equ CPACR_FPEN, 3 << 20            // else the first FP or SIMD instruction traps, class 0x07
.equ MAIR_NORMAL, 0xFF              // attribute 0: normal memory, write-back, read and write allocate
// 4 KB granule, 32-bit addresses through TTBR0, walks in inner-shareable write-back memory, no TTBR1.
.equ TCR_FLAT_4GB, 32 | (1 << 8) | (1 << 10) | (3 << 12) | (1 << 23)

.section .text.start, "ax"
.global _start
_start:
    mrs     x0, CurrentEL
    cmp     x0, #(2 << 2)
    b.ne    at_el1

    // From a boot loader that stays in EL2: EL1 is 64-bit, may use timers, FPU and counters, and nothing traps.
    mov     x0, #(1 << 31)
    msr     hcr_el2, x0
    mov     x0, #3
    msr     cnthctl_el2, x0
    msr     cntvoff_el2, xzr
    mov     x0, #0x33FF
    msr     cptr_el2, x0
    mrs     x0, pmcr_el0
    ubfx    x0, x0, #11, #5         // every event counter belongs to EL1
    msr     mdcr_el2, x0
    mov     x0, #0x3C5              // EL1 with its own stack pointer, interrupts masked
    msr     spsr_el2, x0
    adr     x0, at_el1
    msr     elr_el2, x0
    ldr     x0, =SCTLR_EL1_RESET
    msr     sctlr_el1, x0
    eret

at_el1:
    ldr     x0, =__stack_top
    mov     sp, x0
    mov     x0, #CPACR_FPEN
    msr     cpacr_el1, x0
    ldr     x0, =tern_board_vectors
    msr     vbar_el1, x0

    ldr     x0, =MAIR_NORMAL
    msr     mair_el1, x0
    ldr     x0, =TCR_FLAT_4GB
    msr     tcr_el1, x0
    ldr     x0, =tern_board_level1
    msr     ttbr0_el1, x0
    tlbi    vmalle1
    ic      iallu
    dsb     sy
    isb
    ldr     x0, =(SCTLR_EL1_RESET | SCTLR_MMU_AND_CACHES)
    msr     sctlr_el1, x0
    isb

    msr     fpcr, xzr               // round to nearest, no flush to zero: what self_test() asks for
    mov     x29, xzr
    mov     x30, xzr
    bl      tern_board_run
    b       .
