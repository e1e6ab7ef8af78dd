/* SPDX-License-Identifier: Apache-2.0 */

/* Connects the fuzzed program to AFL++. GCC calls __sanitizer_cov_trace_pc
   in every basic block; here it counts the edge in AFL++'s map, as its own
   instrumentation does. Without AFL++'s run-time library the weak names are
   null, and the program runs one input. */

#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <unistd.h>

#define MAP_SIZE 65536u

extern uint8_t *__afl_area_ptr __attribute__ ((weak));
extern int __afl_persistent_loop (unsigned) __attribute__ ((weak));
extern void __afl_manual_init (void) __attribute__ ((weak));

/* afl-fuzz looks for these in the program. */
const char *volatile urv_persistent = "##SIG_AFL_PERSISTENT##";
const char *volatile urv_deferred = "##SIG_AFL_DEFER_FORKSRV##";

static uint32_t previous;

void
__sanitizer_cov_trace_pc (void)
{
  uint32_t here = (uint32_t) (uintptr_t) __builtin_return_address (0);

  here = (here * 2654435761u) >> 16;
  if (&__afl_area_ptr)
    __afl_area_ptr[(here ^ previous) % MAP_SIZE]++;
  previous = here >> 1;
}

/* The next input, and its length; -1 when there is none. */
int
urv_next_input (uint8_t *input, int room)
{
  static int runs;
  int length = 0;
  ssize_t more;

  if (__afl_persistent_loop)
    {
      if (!runs)
        __afl_manual_init ();
      if (!__afl_persistent_loop (10000))
        return -1;
    }
  else if (runs)
    return -1;
  runs = 1;
  previous = 0;
  while (length < room
         && (more = read (0, input + length, room - length)) > 0)
    length += more;
  return length;
}

/* Ends the process so that AFL++ sees a crash: GNAT's own handler would make
   an exception of the signal. */
void
urv_crash (void)
{
  signal (SIGABRT, SIG_DFL);
  abort ();
}
