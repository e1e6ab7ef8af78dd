| SPDX-License-Identifier: Apache-2.0

| Operations that the compiler calls (BRD-4). A 68000 multiplies 16 by 16 bits and
| divides 32 by 16 bits only. (The compiler's own library has 68020 code.)
| Large numbers of 64 bits are divided in Wide_Arithmetic.

	.text

| 32-bit product, mostly of numbers of 16 bits
	.globl	__mulsi3
__mulsi3:
	move.w	4(%sp), %d0
	or.w	8(%sp), %d0
	jne	1f
	move.w	6(%sp), %d0
	mulu.w	10(%sp), %d0
	rts
1:	move.w	4(%sp), %d0
	mulu.w	10(%sp), %d0
	move.w	6(%sp), %d1
	mulu.w	8(%sp), %d1
	add.w	%d1, %d0
	swap	%d0
	clr.w	%d0
	move.w	6(%sp), %d1
	mulu.w	10(%sp), %d1
	add.l	%d1, %d0
	rts

| d0 / d1: quotient in d0, remainder in d1
urv_divide:
	cmp.l	#0xffff, %d1
	jhi	1f

	| A divisor of 16 bits. With a quotient of 16 bits, too, the processor
	| divides once.
	swap	%d0
	cmp.w	%d1, %d0
	jcc	0f
	swap	%d0
	divu.w	%d1, %d0
	moveq	#0, %d1
	swap	%d0
	move.w	%d0, %d1
	clr.w	%d0
	swap	%d0
	rts

	| Else it divides the high word first.
0:	movem.l	%d2-%d3, -(%sp)
	moveq	#0, %d2
	move.w	%d0, %d2
	divu.w	%d1, %d2
	move.w	%d2, %d3
	swap	%d0
	move.w	%d0, %d2
	divu.w	%d1, %d2
	swap	%d3
	move.w	%d2, %d3
	move.l	%d3, %d0
	clr.w	%d2
	swap	%d2
	move.l	%d2, %d1
	movem.l	(%sp)+, %d2-%d3
	rts

	| A greater one: shift both until the divisor has 16 bits. The quotient
	| is then right or one too large.
1:	movem.l	%d2-%d5, -(%sp)
	move.l	%d0, %d2
	move.l	%d1, %d3
2:	lsr.l	#1, %d2
	lsr.l	#1, %d3
	cmp.l	#0xffff, %d3
	jhi	2b
	divu.w	%d3, %d2
	and.l	#0xffff, %d2
	| The product of quotient and divisor, 33 bits or less.
	move.w	%d1, %d4
	mulu.w	%d2, %d4
	move.l	%d1, %d5
	swap	%d5
	mulu.w	%d2, %d5
	swap	%d5
	move.w	%d5, %d3
	clr.w	%d5
	add.l	%d4, %d5
	jcs	3f
	tst.w	%d3
	jne	3f
	cmp.l	%d0, %d5
	jls	4f
3:	subq.l	#1, %d2
	sub.l	%d1, %d5
4:	sub.l	%d5, %d0
	move.l	%d0, %d1
	move.l	%d2, %d0
	movem.l	(%sp)+, %d2-%d5
	rts

	.globl	__udivsi3
__udivsi3:
	move.l	4(%sp), %d0
	move.l	8(%sp), %d1
	jra	urv_divide

	.globl	__umodsi3
__umodsi3:
	move.l	4(%sp), %d0
	move.l	8(%sp), %d1
	jsr	urv_divide
	move.l	%d1, %d0
	rts

	.globl	__divsi3
__divsi3:
	move.l	4(%sp), %d0
	jpl	5f
	neg.l	%d0
5:	move.l	8(%sp), %d1
	jpl	6f
	neg.l	%d1
6:	jsr	urv_divide
	move.b	4(%sp), %d1
	move.l	%d2, -(%sp)
	move.b	12(%sp), %d2
	eor.b	%d2, %d1
	jpl	7f
	neg.l	%d0
7:	move.l	(%sp)+, %d2
	rts

	.globl	__modsi3
__modsi3:
	move.l	4(%sp), %d0
	jpl	8f
	neg.l	%d0
8:	move.l	8(%sp), %d1
	jpl	9f
	neg.l	%d1
9:	jsr	urv_divide
	move.l	%d1, %d0
	tst.b	4(%sp)
	jpl	10f
	neg.l	%d0
10:	rts

| Divisions of 64-bit numbers. The high words of both are mostly 0; else
| Wide_Arithmetic divides.
	.macro	wide_division name, ada, result
	.globl	\name
\name:
	move.l	4(%sp), %d0
	or.l	12(%sp), %d0
	jne	\ada
	move.l	8(%sp), %d0
	move.l	16(%sp), %d1
	jsr	urv_divide
	.ifnc	\result, %d1
	move.l	\result, %d1
	.endif
	moveq	#0, %d0
	rts
	.endm
	wide_division __udivdi3, urv_quotient, %d0
	wide_division __umoddi3, urv_remainder, %d1
	wide_division __divdi3, urv_signed_quotient, %d0
	wide_division __moddi3, urv_signed_remainder, %d1

| 64-bit shifts: high word in d0, low word in d1. First by 32 and by 16 bits,
| then by one.
	.macro	load_shift
	move.l	%d2, -(%sp)
	move.l	8(%sp), %d0
	move.l	12(%sp), %d1
	move.w	18(%sp), %d2
	btst	#5, %d2
	.endm
	.macro	end_shift operation, more, first, second
	and.w	#15, %d2
	jra	4f
3:	\operation	#1, \first
	\more	#1, \second
4:	dbra	%d2, 3b
	move.l	(%sp)+, %d2
	rts
	.endm

	.globl	__lshrdi3
__lshrdi3:
	load_shift
	jeq	1f
	move.l	%d0, %d1
	moveq	#0, %d0
1:	btst	#4, %d2
	jeq	2f
	move.w	%d0, %d1
	swap	%d1
	clr.w	%d0
	swap	%d0
2:	end_shift lsr.l, roxr.l, %d0, %d1

	.globl	__ashrdi3
__ashrdi3:
	load_shift
	jeq	1f
	move.l	%d0, %d1
	jpl	0f
	moveq	#-1, %d0
	jra	1f
0:	moveq	#0, %d0
1:	btst	#4, %d2
	jeq	2f
	move.w	%d0, %d1
	swap	%d1
	swap	%d0
	ext.l	%d0
2:	end_shift asr.l, roxr.l, %d0, %d1

	.globl	__ashldi3
__ashldi3:
	load_shift
	jeq	1f
	move.l	%d1, %d0
	moveq	#0, %d1
1:	btst	#4, %d2
	jeq	2f
	swap	%d0
	swap	%d1
	move.w	%d1, %d0
	clr.w	%d1
2:	end_shift lsl.l, roxl.l, %d1, %d0

| Copies long words if both addresses are even, else bytes.
	.globl	memcpy
memcpy:
	movea.l	4(%sp), %a1
	movea.l	8(%sp), %a0
	move.l	%a0, %d0
	move.l	%a1, %d1
	or.w	%d1, %d0
	move.l	12(%sp), %d1
	btst	#0, %d0
	jne	5f
	move.l	%d1, %d0
	lsr.l	#5, %d0
	jra	2f
1:	.rept	8
	move.l	(%a0)+, (%a1)+
	.endr
2:	dbra	%d0, 1b
	moveq	#31, %d0
	and.l	%d1, %d0
	lsr.l	#2, %d0
	jra	4f
3:	move.l	(%a0)+, (%a1)+
4:	dbra	%d0, 3b
	moveq	#3, %d0
	and.l	%d0, %d1
5:	jra	7f
6:	move.b	(%a0)+, (%a1)+
7:	dbra	%d1, 6b
	move.l	4(%sp), %d0
	movea.l	%d0, %a0
	rts
