/* SPDX-License-Identifier: Apache-2.0 */

/* Explores how the two processors of a node may share the dual-ported memory
   (BRD-8). Musashi executes the program exploration_program.adb on both.

     explore ROM SWITCHES whole|divided [BEGINNER [SWITCH ...]] < SCENARIOS

   A scenario has these lines; an order is a hexadecimal word for the program:

     scenario NAME
     before PROCESSOR ORDER...     in order, one processor at a time
     both PROCESSOR ORDER...       for 0 and for 1: at the same time
     after PROCESSOR ORDER...      in order again
     end

   Before each access to the memory, word by word, the other processor may go
   on: all runs with up to SWITCHES such switches are made, from both beginners.
   A processor whose TAS has failed twice in a row lets the other one go on,
   without a count. A visit that only fails to claim changes nothing: switches
   after it are those of the run without it. A TAS is one access, or, when divided, two.

   The results of each run must be those of the same operations one after the
   other, in some order. A line of output is NAME, the runs, the accesses of the longest while
   both run, the different results, and the first wrong run: its beginner and its
   switches. With these as arguments this run alone is made, and each access is a
   line: its number, the processor, its instruction, the address and the value. A
   switch comes before the access with its number.
   Exit status: 0 when none is wrong; 2 for a wrong command or scenario. */

#include <setjmp.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <ucontext.h>

#include "m68k.h"
#include "configuration.h"

enum {
   ROM_SIZE = 160 * 1024,
   RAM_START = 0x100000,
   RAM_SIZE = 0x4800,                 /* variables and stack */
   KEPT_START = 0x114000,
   KEPT_SIZE = 64,
   DUAL_START = 0x200000,
   DUAL_SIZE = 1024,
   LOCK = 4,
   TAKEN = 0x80,

   PROCESSORS = 2,
   ORDERS = 64,
   RESULTS = 512,
   OUTCOMES = 2000,
   ENDS = 64,
   VARIABLES = 0x200,                 /* bytes, at the start of RAM */
   MOST_SWITCHES = 8,
   LIMIT = 4000000,                   /* cycles of a run */
   STACK = 256 * 1024
};

struct orders { uint32_t words[ORDERS]; int count; };

struct step { int processor; struct orders orders; };

struct outcome { uint32_t results[PROCESSORS][RESULTS]; int count[PROCESSORS]; };

/* What the operations leave: their results, the memory and the variables */
struct end {
   struct outcome outcome;
   uint8_t dual[DUAL_SIZE], variables[PROCESSORS][VARIABLES];
};

struct machine {
   uint8_t ram[PROCESSORS][RAM_SIZE], kept[PROCESSORS][KEPT_SIZE];
   uint8_t dual[DUAL_SIZE];
};

extern int m68ki_initial_cycles, m68ki_remaining_cycles;
extern jmp_buf m68ki_aerr_trap;

static uint8_t rom[ROM_SIZE];
static struct machine machine, saved_machine;
static char *processors[PROCESSORS], *saved_processors[PROCESSORS];

static const struct orders *orders[PROCESSORS];
static int next_order[PROCESSORS];
static bool finished[PROCESSORS];
static struct outcome outcome;

/* Of a run with switches */
static bool divided, concurrent;
static int current;
static ucontext_t contexts[PROCESSORS], main_context;
static int cycles[PROCESSORS][2];
static int switches[MOST_SWITCHES], switch_count, most_switches;
static int accesses, next_switch;
static bool has_come, useless, restarted, has_failed[PROCESSORS];
static uint8_t lock_read[PROCESSORS];

/* Of a scenario */
static struct step before[ORDERS], after[ORDERS];
static int before_count, after_count;
static struct orders both[PROCESSORS];
static struct outcome *outcomes;
static int sequential_count, seen_count;
static struct end *ends;              /* of runs that were not wrong */
static int end_count;
static unsigned long runs;
static int longest;
static bool wrong;

static int beginner = -1;             /* of the one run that is made */

static void fail(const char *text, unsigned value)
{
   fprintf(stderr, "explore: %s: %06x, instruction at %06x of processor %d\n",
           text, value, m68k_get_reg(NULL, M68K_REG_PPC), current);
   exit(2);
}

static void refuse(const char *text, int number)
{
   fprintf(stderr, "explore: %s %d\n", text, number);
   exit(2);
}

/* Switches */

static void exchange(int from, int to)
{
   m68k_get_context(processors[from]);
   cycles[from][0] = m68ki_initial_cycles;
   cycles[from][1] = m68ki_remaining_cycles;
   m68k_set_context(processors[to]);
   m68ki_initial_cycles = cycles[to][0];
   m68ki_remaining_cycles = cycles[to][1];
   current = to;
}

static void go_to_other(void)
{
   int from = current;

   if (finished[1 - from])
      return;
   exchange(from, 1 - from);
   swapcontext(&contexts[from], &contexts[1 - from]);
}

/* An access begins. When one processor has ended, there is no choice. */
static void access_memory(void)
{
   if (!concurrent || finished[1 - current])
      return;
   if (next_switch < switch_count && accesses == switches[next_switch]) {
      next_switch++;
      has_come = true;
      go_to_other();
   }
   accesses++;
}

/* The access has happened. */
static void show(const char *kind, unsigned where, unsigned value, int digits)
{
   if (beginner < 0 || !concurrent)
      return;
   if (finished[1 - current])
      printf("     -");
   else
      printf("%6d", accesses - 1);
   printf(" processor %d at %06x %s %06x %0*x\n", current,
          m68k_get_reg(NULL, M68K_REG_PPC), kind, where, digits, value);
}

/* The processor does something else than to claim without success. */
static void change(void)
{
   has_come = has_failed[current] = false;
}

static bool is_tas(void)
{
   return (m68k_get_reg(NULL, M68K_REG_IR) & 0xFFC0) == 0x4AC0;
}

/* Memory */

static uint8_t *local(unsigned where)
{
   if (where - RAM_START < RAM_SIZE)
      return &machine.ram[current][where - RAM_START];
   if (where - KEPT_START < KEPT_SIZE)
      return &machine.kept[current][where - KEPT_START];
   return NULL;
}

static unsigned read_byte(unsigned where)
{
   uint8_t *place = local(where);

   if (where < ROM_SIZE)
      return rom[where];
   if (!place)
      fail("reads nothing at", where);
   return *place;
}

static void write_byte(unsigned where, unsigned value)
{
   uint8_t *place = local(where);

   if (!place)
      fail("writes nothing at", where);
   *place = (uint8_t)value;
}

unsigned int m68k_read_memory_8(unsigned int where)
{
   where &= 0xFFFFFF;
   if (where - DUAL_START >= DUAL_SIZE)
      return read_byte(where);
   access_memory();
   if (where - DUAL_START == LOCK && is_tas())
      lock_read[current] = machine.dual[LOCK];
   else
      change();
   show("reads", where, machine.dual[where - DUAL_START], 2);
   return machine.dual[where - DUAL_START];
}

void m68k_write_memory_8(unsigned int where, unsigned int value)
{
   where &= 0xFFFFFF;
   if (where - DUAL_START >= DUAL_SIZE) {
      write_byte(where, value);
      return;
   }
   if (where - DUAL_START == LOCK && is_tas()) {
      if (divided)
         access_memory();
      machine.dual[LOCK] = (uint8_t)value;
      show("writes", where, value, 2);
      if (lock_read[current] != TAKEN)
         change();
      else if (!has_failed[current])
         has_failed[current] = true;
      else if (concurrent) {
         useless = useless || (has_come && next_switch == switch_count);
         has_come = false;
         go_to_other();
      }
      return;
   }
   access_memory();
   change();
   machine.dual[where - DUAL_START] = (uint8_t)value;
   show("writes", where, value & 0xFF, 2);
}

unsigned int m68k_read_memory_16(unsigned int where)
{
   where &= 0xFFFFFF;
   if (where - DUAL_START < DUAL_SIZE) {
      unsigned value;

      access_memory();
      change();
      value = (unsigned)machine.dual[where - DUAL_START] << 8
         | machine.dual[where - DUAL_START + 1];
      show("reads", where, value, 4);
      return value;
   }
   return read_byte(where) << 8 | read_byte(where + 1);
}

void m68k_write_memory_16(unsigned int where, unsigned int value)
{
   where &= 0xFFFFFF;
   if (where - DUAL_START < DUAL_SIZE) {
      access_memory();
      change();
      machine.dual[where - DUAL_START] = (uint8_t)(value >> 8);
      machine.dual[where - DUAL_START + 1] = (uint8_t)value;
      show("writes", where, value & 0xFFFF, 4);
      return;
   }
   write_byte(where, value >> 8);
   write_byte(where + 1, value & 0xFF);
}

unsigned int m68k_read_memory_32(unsigned int where)
{
   where &= 0xFFFFFF;
   if (where == 0xF30010) {
      if (next_order[current] < orders[current]->count)
         return orders[current]->words[next_order[current]++];
      finished[current] = true;
      m68k_end_timeslice();
      return 0;
   }
   return m68k_read_memory_16(where) << 16 | m68k_read_memory_16(where + 2);
}

void m68k_write_memory_32(unsigned int where, unsigned int value)
{
   where &= 0xFFFFFF;
   if (where == 0xF30014) {
      if (value == 0xFFFFFFFF) {
         restarted = finished[current] = true;
         m68k_end_timeslice();
      }
      if (outcome.count[current] == RESULTS)
         fail("results", RESULTS);
      outcome.results[current][outcome.count[current]++] = value;
      return;
   }
   m68k_write_memory_16(where, value >> 16);
   m68k_write_memory_16(where + 2, value & 0xFFFF);
}

unsigned int m68k_read_disassembler_16(unsigned int where)
{
   return m68k_read_memory_16(where);
}

unsigned int m68k_read_disassembler_32(unsigned int where)
{
   return m68k_read_memory_32(where);
}

int board_acknowledge(int level)
{
   fail("an interrupt", (unsigned)level);
   return 0;
}

void board_reset(void)
{
}

void board_instruction(unsigned int pc)
{
   (void)pc;
}

/* Runs */

static void execute(void)
{
   while (!finished[current]) {
      m68k_execute(LIMIT);
      if (!finished[current])
         fail("a run without end", 0);
   }
}

static void run_alone(int processor, const struct orders *list)
{
   concurrent = false;
   current = processor;
   orders[processor] = list;
   next_order[processor] = 0;
   finished[processor] = false;
   m68k_set_context(processors[processor]);
   execute();
   m68k_get_context(processors[processor]);
}

static void run_one(int processor, uint32_t word)
{
   struct orders one = { { word }, 1 };

   run_alone(processor, &one);
}

static void run_steps(const struct step *steps, int count)
{
   for (int each = 0; each < count; each++)
      run_alone(steps[each].processor, &steps[each].orders);
}

static void coroutine(void)
{
   int self;

   execute();
   self = current;
   if (!finished[1 - self])
      exchange(self, 1 - self);
   else
      m68k_get_context(processors[self]);
}

static void run_both(int first)
{
   static char *stacks[PROCESSORS];

   for (int each = 0; each < PROCESSORS; each++) {
      if (!stacks[each])
         stacks[each] = malloc(STACK);
      getcontext(&contexts[each]);
      contexts[each].uc_stack.ss_sp = stacks[each];
      contexts[each].uc_stack.ss_size = STACK;
      orders[each] = &both[each];
      next_order[each] = 0;
      finished[each] = false;
      cycles[each][0] = cycles[each][1] = 0;
   }
   concurrent = true;
   accesses = next_switch = 0;
   has_come = useless = restarted = has_failed[0] = has_failed[1] = false;
   current = first;
   m68k_set_context(processors[first]);
   /* The one that ends first lets the other one end. */
   for (int each = 0; each < PROCESSORS; each++) {
      contexts[each].uc_link = &main_context;
      makecontext(&contexts[each], coroutine, 0);
   }
   swapcontext(&main_context, &contexts[first]);
   while (!finished[0] || !finished[1])
      swapcontext(&main_context, &contexts[current]);
   concurrent = false;
}

static void save(void)
{
   saved_machine = machine;
   for (int each = 0; each < PROCESSORS; each++)
      memcpy(saved_processors[each], processors[each], m68k_context_size());
}

static void restore(void)
{
   machine = saved_machine;
   for (int each = 0; each < PROCESSORS; each++)
      memcpy(processors[each], saved_processors[each], m68k_context_size());
   memset(&outcome, 0, sizeof outcome);
}

static bool is_known(void)
{
   for (int each = 0; each < seen_count; each++)
      if (memcmp(&outcomes[each], &outcome, sizeof outcome) == 0)
         return true;
   return false;
}

static void add_outcome(void)
{
   if (is_known())
      return;
   if (seen_count == OUTCOMES)
      fail("outcomes", OUTCOMES);
   outcomes[seen_count++] = outcome;
}

static bool has_known_end(void)
{
   struct end *end = &ends[end_count];

   end->outcome = outcome;
   memcpy(end->dual, machine.dual, DUAL_SIZE);
   for (int each = 0; each < PROCESSORS; each++)
      memcpy(end->variables[each], machine.ram[each], VARIABLES);
   for (int each = 0; each < end_count; each++)
      if (memcmp(&ends[each], end, sizeof *end) == 0)
         return true;
   return false;
}

/* All orders of whole operations */
static void explore_sequences(const int *merge, int length)
{
   int next[PROCESSORS + 1][2 * ORDERS], used[PROCESSORS] = { 0, 0 };

   for (int each = 0; each < length; each++)
      used[merge[each]]++;
   if (used[0] == both[0].count && used[1] == both[1].count) {
      int place[PROCESSORS] = { 0, 0 };

      restore();
      for (int each = 0; each < length; each++)
         run_one(merge[each],
                 both[merge[each]].words[place[merge[each]]++]);
      run_steps(after, after_count);
      add_outcome();
      return;
   }
   for (int each = 0; each < PROCESSORS; each++)
      if (used[each] < both[each].count) {
         memcpy(next[0], merge, sizeof(int) * (size_t)length);
         next[0][length] = each;
         explore_sequences(next[0], length + 1);
      }
}

static void explore(int first)
{
   bool may_add, is_new;
   int count, last;

   restore();
   run_both(first);
   count = accesses;
   runs++;
   if (count > longest)
      longest = count;
   may_add = !useless && switch_count < most_switches;
   is_new = !has_known_end();
   if (is_new && !restarted)
      run_steps(after, after_count);
   if (is_new && end_count < ENDS)
      end_count++;
   if (is_new && !is_known()) {
      wrong = true;
      printf(" wrong: begins %d, switches", first);
      for (int each = 0; each < switch_count; each++)
         printf(" %d", switches[each]);
      for (int each = 0; each < PROCESSORS; each++) {
         printf("; results of %d", each);
         for (int place = 0; place < outcome.count[each]; place++)
            printf(" %x", outcome.results[each][place]);
      }
      return;
   }
   if (!may_add || beginner >= 0)
      return;
   last = switch_count > 0 ? switches[switch_count - 1] + 1 : 0;
   for (int each = last; each < count && !wrong; each++) {
      switches[switch_count++] = each;
      explore(first);
      switch_count--;
   }
}

static void explore_scenario(const char *name)
{
   int none[1] = { 0 };

   memset(&machine, 0, sizeof machine);
   for (int each = 0; each < PROCESSORS; each++) {
      current = each;
      m68k_pulse_reset();
      m68k_get_context(processors[each]);
      run_one(each, 0);
   }
   run_steps(before, before_count);
   save();
   seen_count = end_count = 0;
   runs = 0;
   longest = 0;
   explore_sequences(none, 0);
   if (restarted)
      fail("a restart", 0);
   sequential_count = seen_count;
   printf("%s", name);
   wrong = false;
   if (beginner >= 0) {
      printf("\n");
      explore(beginner);
      if (next_switch < switch_count)
         refuse("a switch that does not come:", switches[next_switch]);
      printf("%s%s", wrong ? "\n" : "", name);
   }
   for (int first = 0; first < PROCESSORS && !wrong && beginner < 0; first++) {
      switch_count = 0;
      explore(first);
   }
   printf(" runs %lu accesses %d outcomes %d%s\n", runs, longest,
          sequential_count, wrong ? " WRONG" : "");
   fflush(stdout);
}

/* Scenarios */

static void read_orders(char *text, struct orders *list)
{
   list->count = 0;
   for (char *word = strtok(text, " \n"); word; word = strtok(NULL, " \n")) {
      if (list->count == ORDERS)
         refuse("more orders than", ORDERS);
      list->words[list->count++] = (uint32_t)strtoul(word, NULL, 16);
   }
}

int main(int count, char **arguments)
{
   static char line[4096], name[256];
   FILE *file;
   bool any_wrong = false;

   if (count < 4 || count > 5 + MOST_SWITCHES) {
      fprintf(stderr, "usage: explore ROM SWITCHES whole|divided"
              " [BEGINNER [SWITCH ...]]\n");
      return 2;
   }
   if (!(file = fopen(arguments[1], "rb"))) {
      perror(arguments[1]);
      return 2;
   }
   if (fread(rom, 1, sizeof rom, file) == 0 || fgetc(file) != EOF) {
      fprintf(stderr, "explore: %s: not 1 to %d bytes\n", arguments[1],
              ROM_SIZE);
      return 2;
   }
   fclose(file);
   most_switches = atoi(arguments[2]);
   if (most_switches < 0 || most_switches > MOST_SWITCHES) {
      fprintf(stderr, "explore: %s: 0 to %d switches\n", arguments[2],
              MOST_SWITCHES);
      return 2;
   }
   divided = strcmp(arguments[3], "divided") == 0;
   if (count > 4)
      beginner = atoi(arguments[4]) & 1;
   for (int each = 5; each < count; each++)
      switches[switch_count++] = atoi(arguments[each]);
   outcomes = calloc(OUTCOMES, sizeof *outcomes);
   ends = calloc(ENDS + 1, sizeof *ends);
   m68k_init();
   m68k_set_cpu_type(M68K_CPU_TYPE_68000);
   for (int each = 0; each < PROCESSORS; each++) {
      processors[each] = calloc(1, m68k_context_size());
      saved_processors[each] = calloc(1, m68k_context_size());
   }
   while (fgets(line, sizeof line, stdin)) {
      int processor, used;
      struct step *step;

      if (sscanf(line, "scenario %255s", name) == 1) {
         before_count = after_count = 0;
         both[0].count = both[1].count = 0;
      } else if (sscanf(line, "before %d %n", &processor, &used) == 1) {
         step = &before[before_count++];
         step->processor = processor & 1;
         read_orders(line + used, &step->orders);
      } else if (sscanf(line, "after %d %n", &processor, &used) == 1) {
         step = &after[after_count++];
         step->processor = processor & 1;
         read_orders(line + used, &step->orders);
      } else if (sscanf(line, "both %d %n", &processor, &used) == 1)
         read_orders(line + used, &both[processor & 1]);
      else if (strncmp(line, "end", 3) == 0) {
         explore_scenario(name);
         any_wrong = any_wrong || wrong;
      } else {
         fprintf(stderr, "explore: not a line of a scenario: %s", line);
         return 2;
      }
      if (before_count == ORDERS || after_count == ORDERS)
         refuse("more steps of a scenario than", ORDERS - 1);
   }
   return any_wrong;
}
