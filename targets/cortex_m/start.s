@ SPDX-License-Identifier: Apache-2.0

@ Vectors and start-up of the Cortex-M4 (BRD-2, D-81).
@
@ The six words at urv_kept survive a reset:
@    0  "KEPT" once a program has been elaborated: memory is worth keeping
@    4  "STRT" when the processor restarts itself; any other reset is the
@       reset switch, or power up without the first word
@    8  the reason: the exception's number, or 256 plus a line of Ada
@   12  the number of restarts
@   16  the address of the cell under test, or 0
@   20  the contents of this cell

	.syntax unified
	.thumb

	.equ	kept, 0x5450454b
	.equ	restart, 0x54525453

	.section .vectors, "a"
	.word	urv_stack_top
	.word	urv_reset + 1
	.rept	13
	.word	urv_unexpected + 1
	.endr
	.word	urv_systick + 1
	.rept	82
	.word	urv_unexpected + 1
	.endr

	.text
	.globl	urv_reset
	.thumb_func
urv_reset:
	cpsid	i
	ldr	r4, =urv_kept
	ldr	r0, [r4]
	ldr	r1, =kept
	cmp	r0, r1
	beq	4f

	@ Power up: test the RAM of the variables and the stack, with a stack
	@ elsewhere.
	ldr	r0, =urv_scratchpad_end
	mov	sp, r0
	ldr	r0, =urv_data_start
	ldr	r1, =urv_stack_top
	bl	urv_test_ram
	ldr	r0, =urv_stack_top
	mov	sp, r0

	@ Give variables their first values.
	ldr	r0, =urv_data_load
	ldr	r1, =urv_data_start
	ldr	r2, =urv_data_end
1:	cmp	r1, r2
	ittt	lo
	ldrlo	r3, [r0], #4
	strlo	r3, [r1], #4
	blo	1b
	ldr	r1, =urv_bss_start
	ldr	r2, =urv_bss_end
	movs	r3, #0
2:	cmp	r1, r2
	itt	lo
	strlo	r3, [r1], #4
	blo	2b
	str	r3, [r4, #4]
	str	r3, [r4, #12]
	str	r3, [r4, #16]

	@ Fill the stack with a pattern that shows its depth.
	ldr	r1, =urv_stack_bottom
	mov	r2, sp
	ldr	r3, =0x5aa55aa5
3:	cmp	r1, r2
	itt	lo
	strlo	r3, [r1], #4
	blo	3b
	bl	main
	b	urv_unexpected

	@ Memory is kept: also the contents of a cell whose test did not end.
	@ Condition 1 is the reset switch, 2 a restart.
4:	ldrd	r0, r1, [r4, #16]
	movs	r3, #0
	cbz	r0, 5f
	str	r1, [r0]
	str	r3, [r4, #16]
5:	ldr	r0, [r4, #4]
	ldr	r1, =restart
	cmp	r0, r1
	ite	eq
	moveq	r0, #2
	movne	r0, #1
	str	r3, [r4, #4]
	bl	urv_run
	b	urv_unexpected

@ An unexpected interrupt or an exception.
	.globl	urv_unexpected
	.thumb_func
urv_unexpected:
	mrs	r0, ipsr
	.globl	urv_restart_processor
	.thumb_func
urv_restart_processor:
	cpsid	i
	ldr	r4, =urv_kept
	str	r0, [r4, #8]
	ldr	r1, =restart
	str	r1, [r4, #4]
	ldr	r0, [r4, #12]
	adds	r0, #1
	str	r0, [r4, #12]
	dsb
	ldr	r0, =0xe000ed0c		@ AIRCR: the system starts again
	ldr	r1, =0x05fa0004
	str	r1, [r0]
	dsb
5:	b	5b

	.globl	urv_mask_interrupts
	.thumb_func
urv_mask_interrupts:
	mrs	r0, primask
	cpsid	i
	bx	lr

	.globl	urv_restore_interrupts
	.thumb_func
urv_restore_interrupts:
	msr	primask, r0
	bx	lr

	.globl	urv_wait
	.thumb_func
urv_wait:
	wfi
	bx	lr

@ Tests the word at r0, and gives back its contents; the result is 1 if it is
@ sound (TST-5). All is in registers, so that the cell may be of the stack.
	.macro	march background
	ldr	r1, =\background
	str	r1, [r0]
	mvns	r1, r1
	str	r1, [r0]
	ldr	r5, [r0]
	cmp	r5, r1
	bne	1f
	mvns	r1, r1
	str	r1, [r0]
	ldr	r5, [r0]
	cmp	r5, r1
	bne	1f
	.endm
	.globl	urv_march
	.thumb_func
urv_march:
	push	{r4, r5}
	mrs	r3, primask
	ldr	r4, =urv_kept
	mov	r12, #0
	cpsid	i
	ldr	r2, [r0]
	str	r2, [r4, #20]
	str	r0, [r4, #16]
	march	0x00000000
	march	0x55555555
	march	0x33333333
	march	0x0f0f0f0f
	march	0x00ff00ff
	march	0x0000ffff
	mov	r12, #1
1:	str	r2, [r0]
	ldr	r5, [r0]
	cmp	r5, r2
	it	ne
	movne	r12, #0
	movs	r5, #0
	str	r5, [r4, #16]
	msr	primask, r3
	mov	r0, r12
	pop	{r4, r5}
	bx	lr

@ Ada's Test_And_Set. r0 is the byte; the result is 1 if it was free.
	.globl	urv_test_and_set
	.thumb_func
urv_test_and_set:
	movs	r3, #1
6:	ldrexb	r1, [r0]
	strexb	r2, r3, [r0]
	cmp	r2, #0
	bne	6b
	cmp	r1, #0
	ite	eq
	moveq	r0, #1
	movne	r0, #0
	bx	lr

@ 64-bit divisions for the compiler: quotient in r0 and r1, remainder in r2 and
@ r3. Wide_Division has the algorithm.
	.macro	division name, ada
	.globl	\name
	.thumb_func
\name:
	push	{r4, lr}
	sub	sp, #24
	add	r4, sp, #8
	str	r4, [sp]
	bl	\ada
	ldrd	r0, r1, [sp, #8]
	ldrd	r2, r3, [sp, #16]
	add	sp, #24
	pop	{r4, pc}
	.endm
	division __aeabi_uldivmod, urv_divide_64
	division __aeabi_ldivmod, urv_divide_64_signed

@ Copies word by word: the Cortex-M4 accesses words at any address.
	.globl	memcpy
	.thumb_func
memcpy:
	mov	r12, r0
	subs	r2, #16
	blo	8f
7:
	.rept	4
	ldr	r3, [r1], #4
	str	r3, [r12], #4
	.endr
	subs	r2, #16
	bhs	7b
8:	adds	r2, #12
	bmi	10f
9:	ldr	r3, [r1], #4
	str	r3, [r12], #4
	subs	r2, #4
	bpl	9b
10:	adds	r2, #4
	beq	12f
11:	ldrb	r3, [r1], #1
	strb	r3, [r12], #1
	subs	r2, #1
	bne	11b
12:	bx	lr
	.pool

	.section .note.GNU-stack, "", %progbits
