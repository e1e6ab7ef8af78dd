/* SPDX-License-Identifier: Apache-2.0 */

/* Musashi's settings: a plain 68000 that traps odd words and long words, with
   vectored interrupts, the reset line, and a call before each instruction. */

#ifndef CONFIGURATION_H
#define CONFIGURATION_H

#define OPT_OFF 0
#define OPT_ON 1
#define OPT_SPECIFY_HANDLER 2

#define M68K_EMULATE_010 OPT_OFF
#define M68K_EMULATE_EC020 OPT_OFF
#define M68K_EMULATE_020 OPT_OFF
#define M68K_EMULATE_030 OPT_OFF
#define M68K_EMULATE_040 OPT_OFF
#define M68K_SEPARATE_READS OPT_OFF
#define M68K_SIMULATE_PD_WRITES OPT_OFF
#define M68K_EMULATE_INT_ACK OPT_SPECIFY_HANDLER
#define M68K_INT_ACK_CALLBACK(level) board_acknowledge(level)
#define M68K_EMULATE_BKPT_ACK OPT_OFF
#define M68K_EMULATE_TRACE OPT_OFF
#define M68K_EMULATE_RESET OPT_SPECIFY_HANDLER
#define M68K_RESET_CALLBACK() board_reset()
#define M68K_CMPILD_HAS_CALLBACK OPT_OFF
#define M68K_RTE_HAS_CALLBACK OPT_OFF
#define M68K_TAS_HAS_CALLBACK OPT_OFF
#define M68K_ILLG_HAS_CALLBACK OPT_OFF
#define M68K_EMULATE_FC OPT_OFF
#define M68K_MONITOR_PC OPT_OFF
#define M68K_INSTRUCTION_HOOK OPT_SPECIFY_HANDLER
#define M68K_INSTRUCTION_CALLBACK(pc) board_instruction(pc)
#define M68K_EMULATE_PREFETCH OPT_OFF
#define M68K_EMULATE_ADDRESS_ERROR OPT_ON
#define M68K_ALINE_HOOK OPT_OFF
#define M68K_LOG_ENABLE OPT_OFF
#define M68K_LOG_1010_1111 OPT_OFF
#define M68K_EMULATE_PMMU OPT_OFF
#define M68K_USE_64_BIT OPT_ON

int board_acknowledge(int level);
void board_reset(void);
void board_instruction(unsigned int pc);

#endif
