| SPDX-License-Identifier: Apache-2.0

| Vectors and start-up of the MC68000 (BRD-2, BRD-4, D-81), for the controller
| and, with the symbol TELEMETRY_BOARD, for the telemetry board (BRD-8, BRD-10). With
| UNTESTED there is no test of RAM (exploration).
|
| The six long words at urv_kept survive a restart:
|    0  "KEPT" once a program has been elaborated: memory is worth keeping
|    4  "STRT" when the processor restarts itself; any other reset is the
|       reset switch, or power up without the first word
|    8  the reason: the exception's vector, or 256 plus a line of Ada
|   12  the number of restarts
|   16  the address of the cell under test, or 0
|   20  the contents of this cell

	kept = 0x4b455054
	restart = 0x53545254

	first_of_boards = 64
	boards = 3

	.macro	stubs from, to
	number = (\from)
	.rept	(\to) - (\from) + 1
	.long	urv_stubs + 4 * number
	number = number + 1
	.endr
	.endm

	.section .vectors, "a"
	.long	urv_stack_top
	.long	urv_reset
	stubs	2, first_of_boards - 1
	.ifdef	TELEMETRY_BOARD
	stubs	first_of_boards, first_of_boards
	.long	urv_on_line
	stubs	first_of_boards + 2, first_of_boards + 2
	.else
	.long	urv_on_converter
	stubs	first_of_boards + 1, first_of_boards + 1
	.long	urv_on_clock
	.endif
	stubs	first_of_boards + boards, 255

	.text

	.globl	urv_reset
urv_reset:
	move.w	#0x2700, %sr
	lea	urv_kept, %a3
	cmp.l	#kept, (%a3)
	jeq	4f

	.ifndef	TELEMETRY_BOARD
	| Power up: take the dual-ported memory from the telemetry board. Any
	| operation of the board ends before the variables have their first values.
	clr.l	urv_board_ready
	.endif

	.ifndef	UNTESTED
	| Test the RAM of the variables and the stack, with a stack elsewhere.
	lea	urv_scratchpad_end, %sp
	pea	urv_stack_top
	pea	urv_data_start
	jsr	urv_test_ram
	lea	urv_stack_top, %sp
	lea	urv_kept, %a3
	.endif

	| Give variables their first values. The test leaves zeros.
	lea	urv_data_load, %a0
	lea	urv_data_start, %a1
	lea	urv_data_end, %a2
	jra	2f
1:	move.l	(%a0)+, (%a1)+
2:	cmp.l	%a2, %a1
	jcs	1b
	.ifdef	UNTESTED
	lea	urv_bss_start, %a1
	lea	urv_bss_end, %a2
	moveq	#0, %d0
	jsr	urv_fill
	.endif
	clr.l	4(%a3)
	clr.l	12(%a3)
	clr.l	16(%a3)

	| Fill the stack with a pattern that shows its depth.
	lea	urv_stack_bottom, %a1
	lea	-4(%sp), %a2
	move.l	#0x5aa55aa5, %d0
	jsr	urv_fill
	.ifndef	TELEMETRY_BOARD
	clr.b	urv_board_lock
	.endif
	jsr	main
	illegal

	| Memory is kept: also the contents of a cell whose test did not end. Condition
| 1 is the reset switch, 2 a restart.
4:	move.l	16(%a3), %d0
	jeq	3f
	move.l	%d0, %a0
	move.l	20(%a3), (%a0)
	clr.l	16(%a3)
3:	moveq	#1, %d0
	cmp.l	#restart, 4(%a3)
	jne	5f
	moveq	#2, %d0
5:	clr.l	4(%a3)
	move.l	%d0, -(%sp)
	jsr	urv_run
	illegal

| Fills from a1 to a2 with d0.
urv_fill:
	jra	7f
6:	move.l	%d0, (%a1)+
7:	cmp.l	%a2, %a1
	jcs	6b
	rts

| An unexpected interrupt or an exception. A 68000 does not stack the vector's
| number, so each vector has its own call.
urv_stubs:
	.rept	256
	bsr.w	urv_unexpected
	.endr

urv_unexpected:
	move.w	#0x2700, %sr
	move.l	(%sp), %d0
	sub.l	#urv_stubs + 4, %d0
	lsr.l	#2, %d0
	jra	8f
	.globl	urv_restart_processor
urv_restart_processor:
	move.w	#0x2700, %sr
	move.l	4(%sp), %d0
8:	lea	urv_kept, %a3
	move.l	%d0, 8(%a3)
	move.l	#restart, 4(%a3)
	addq.l	#1, 12(%a3)
	reset
	lea	urv_stack_top, %sp
	jmp	urv_reset

	.globl	urv_mask_interrupts
urv_mask_interrupts:
	moveq	#0, %d0
	move.w	%sr, %d0
	move.w	#0x2700, %sr
	rts

	.globl	urv_restore_interrupts
urv_restore_interrupts:
	move.w	6(%sp), %sr
	rts

| Takes interrupts until one of them has set a byte. None comes between the look
| at the byte and the sleep.
	.globl	urv_sleep
urv_sleep:
	movea.l	4(%sp), %a0
1:	move.w	#0x2700, %sr
	tst.b	(%a0)
	jne	2f
	stop	#0x2000
	jra	1b
2:	move.w	#0x2000, %sr
	rts

	.ifndef	TELEMETRY_BOARD
| Tests the long word at an address, and gives back its contents; the result is 1
| if it is sound (TST-5). All is in registers, so that the cell may be of the
| stack.
	.macro	march background
	move.l	#\background, %d1
	move.l	%d1, (%a0)
	not.l	%d1
	move.l	%d1, (%a0)
	cmp.l	(%a0), %d1
	jne	1f
	not.l	%d1
	move.l	%d1, (%a0)
	cmp.l	(%a0), %d1
	jne	1f
	.endm
	.globl	urv_march
urv_march:
	move.l	4(%sp), %a0
	lea	urv_kept, %a1
	movem.l	%d2-%d3, -(%sp)
	moveq	#0, %d0
	move.w	%sr, %d3
	move.w	#0x2700, %sr
	move.l	(%a0), %d2
	move.l	%d2, 20(%a1)
	move.l	%a0, 16(%a1)
	march	0x00000000
	march	0x55555555
	march	0x33333333
	march	0x0f0f0f0f
	march	0x00ff00ff
	march	0x0000ffff
	moveq	#1, %d0
1:	move.l	%d2, (%a0)
	cmp.l	(%a0), %d2
	jeq	2f
	moveq	#0, %d0
2:	clr.l	16(%a1)
	move.w	%d3, %sr
	movem.l	(%sp)+, %d2-%d3
	rts
	.endif

| Sleeps for ever, and takes interrupts.
	.globl	urv_serve_interrupts
urv_serve_interrupts:
	stop	#0x2000
	jra	urv_serve_interrupts

| Ada's Test_And_Set: the result is 1 if the byte was free.
	.globl	urv_test_and_set
urv_test_and_set:
	move.l	4(%sp), %a0
	moveq	#0, %d0
	tas	(%a0)
	jne	9f
	moveq	#1, %d0
9:	rts
