/* SPDX-License-Identifier: Apache-2.0 */

/* One or two nodes, in step (BRD-4, BRD-8, D-83). Each has two boards with an
   MC68000: the controller and the telemetry board. Musashi executes the
   instructions and counts their cycles; everything else is here.

     board MHZ OUTPUT NODE ROM TELEMETRY_ROM TAPE [NODE ROM TELEMETRY_ROM TAPE]

   With a file OUTPUT/NODE.places, each line "hexadecimal address name", it also
   counts the cycles of the calls of these subprograms, without the interrupts
   and the other subprograms of the file that they contain. With a file
   OUTPUT/NODE.stuck, "address bits", both hexadecimal, these bits of a byte in
   the controller's RAM always read as 0; with OUTPUT/NODE_board.stuck those in
   the telemetry board's RAM. A tape can make bits of the controller stick later,
   or follow another bit.

   While the controller tests a cell of its RAM in flight, the fifth long word of
   the kept ones has the cell's address. When the test ends, the cell must have
   the contents that it had before, and no interrupt may come meanwhile (TST-5).

   Memory of a board:

     000000  160 KiB of ROM
     100000   80 KiB of RAM, and 64 bytes more
     200000    1 KiB of dual-ported memory, the same on both boards of a node
     F00001  MC68681: console on channel B; on the telemetry board the line on
             A, and its timer gives the character times. Level 6. X1 is 4 MHz,
             and inputs 3 and 4 are 2 MHz, for 125 kbaud.
     F00021  MC68681: its timer gives the ticks. Level 4.
     F10000  converter: channel (a write starts), data, vector, enable.
             Level 5, 16 us after the start.
     F20000  servos, 16 words
     F40000  watchdog: each write of a word begins its 100 ms. At their end it
             interrupts with level 7, which cannot be masked, by autovector 31.
             It is off until the first write, and after RESET (BRD-7).
     F30000  settings from the tape: flags, line delay in us; 1 when the flight
             is over (long words); F3000C: 1 stops the time, 0 lets it go on, and
             a read gives 1 from each tenth tick served until time has stopped and
             goes on, plus 2 when the flight is over; F3000E ends the run

   Elsewhere nothing answers, nor does the ROM to a write: a bus error, vector 2.
   A processor that meets one while it stacks an exception would halt; that ends
   the emulator.

   A node's time begins when its controller first starts the second timer; a lag
   of n ticks in its tape lets the timer start later. A character needs 96 us for
   the line, so each node runs 48 us ahead of the other at most: the nodes need
   no other synchronisation, and the flight is the same on every machine. Of a
   node's two processors, each runs a few instructions ahead of the other at
   most, unless the other sleeps. The read and the write of a TAS are one cycle
   of the bus. A controller that writes its record stops the node's time.

   The console of each node goes to OUTPUT/NODE.txt, that of its telemetry board
   to OUTPUT/NODE_board.txt. The last lines have the cycles by tick, by major
   frame, by character time and by interrupt, and those for which a processor
   held the lock of the dual-ported memory. */

#include <inttypes.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "m68kcpu.h"

enum {
   ROM_SIZE = 160 * 1024,
   RAM_START = 0x100000,
   RAM_SIZE = 80 * 1024 + 64,
   DUAL_START = 0x200000,
   DUAL_SIZE = 1024,
   CELL_UNDER_TEST = 0x114010,
   LOCK = 4,
   TAKEN = 0x80,

   CHARACTER_US = 96,
   CONVERSION_US = 16,
   TICK_US = 2000,
   WATCHDOG_US = 100000,
   WATCHDOG_VECTOR = 31,
   UNUSED_VECTOR = 200,
   TICKS_PER_FRAME = 10,
   SLICE_US = 48,
   AHEAD_CYCLES = 64,                 /* of the node's other processor */

   CHANNELS = 32,
   TAPE_HEAD = 24,
   ENTRY_SIZE = 8 + 2 * CHANNELS,     /* of a tape */
   SERVOS = 16,
   NODES = 2,
   PROCESSORS = 2 * NODES,
   FIFO = 3,
   ON_LINE = 16,
   HANDLERS = 8,
   PLACES = 40,
   CALLS = 16,

   BUS_ERROR_VECTOR = 2 * 4,          /* their addresses */
   ADDRESS_ERROR_VECTOR = 3 * 4,

   STOP = 0x4E72,
   RETURN_FROM_EXCEPTION = 0x4E73,
   STOP_CYCLES = 4,
   RETURN_CYCLES = 20,
   INTERRUPT_CYCLES = 44,
   FIRST_USER_VECTOR = 64,
   USER_VECTOR_CYCLES = 4             /* what Musashi counts for one of these */
};

enum event {
   WORDS, ILLEGAL_INSTRUCTION, UNEXPECTED_INTERRUPT, ODD_ADDRESS,
   PARITY_ERROR, FRAMING_ERROR, LOST_CHARACTER, ENDLESS_LOOP, LOST_TIMER,
   ILLEGAL_WITH_LOCK, LOOP_WITH_LOCK, STUCK_BITS, ILLEGAL_IN_RAM_TEST,
   INTERRUPT_IN_RAM_TEST, RESET_SWITCH, ILLEGAL_IN_START, NO_DEVICE,

   ON_TELEMETRY_BOARD = 32            /* is added to an event of that board */
};

/* Status of a DUART's channel and interrupts */
enum {
   RECEIVED = 1, FIFO_FULL = 2, SENDER_READY = 4, SENDER_EMPTY = 8,
   OVERRUN = 16, WRONG_PARITY = 32, WRONG_FRAME = 64,
   COUNTER_READY = 8, RECEIVED_A = 2
};

struct duart {
   uint8_t mode[2][2], place[2], clock[2], auxiliary, mask, vector, state;
   uint16_t preload;
   bool receives[2], sends[2], runs;
   uint64_t next, period;             /* the timer's, in cycles */
   struct received { uint8_t data, errors; } fifo[FIFO + 1];
   int held;                          /* the last one in the shift register */
   bool overrun;
   uint64_t sender_free;
};

struct converter {
   uint8_t vector;
   uint16_t channel, data;
   bool enabled, converting, ready;
   uint64_t done;
};

struct character {
   uint64_t time;
   uint8_t data, format;
};

/* Cycles in units of a tick or of a major frame */
struct figure {
   uint64_t now, most, all, count;
};

struct handler {
   int vector;
   uint64_t begun;
};

/* A subprogram whose cycles are counted, by minor frame, and its calls */
struct place {
   unsigned start;
   char name[64];
   uint64_t now, most[TICKS_PER_FRAME], all[TICKS_PER_FRAME];
};

struct call {
   struct place *place;
   uint64_t begun, without;
   unsigned back, stack;
};

/* A processor with its board */
struct node {
   char name[64];
   bool is_telemetry_board;
   unsigned stuck_at;                 /* bits of a byte in RAM, and their value */
   uint8_t stuck_bits, stuck_value;
   unsigned follows;                  /* 0: none; else they read as the bit with
                                         this number, from 1, of the long word */
   unsigned cell, contents;           /* under test, and before the test */
   enum event in_test;                /* an event in the next one */
   bool fails_in_start;               /* after it has read its settings */
   struct node *partner;              /* the node's other one */
   uint8_t *dual;                     /* the memory of both */
   FILE *console;
   void *processor;
   bool ended, halted;

   uint8_t rom[ROM_SIZE], ram[RAM_SIZE];
   struct duart line, clock;
   struct converter converter;
   uint16_t servos[SERVOS];
   bool watched, bites;
   uint64_t watchdog;                 /* the end of its time */

   struct character coming[ON_LINE];  /* sorted by time */
   int characters;

   const uint8_t *tape, *entry, *words;
   uint32_t lag, flags, delay_us, length, entries;

   uint64_t time;                     /* cycles, of the begun instructions */
   uint64_t held_at;
   bool begun, held;
   bool row_is_due;                   /* until a row has been written */
   uint64_t start;                    /* the time when the clock began */
   uint32_t ticks, served;            /* the clock's, and its interrupts */
   int unexpected_interrupt;
   bool requested;                    /* an interrupt */
   uint8_t next_errors;               /* of the next character received */
   const uint16_t *planted;           /* words in place of instructions */
   const uint16_t *planted_with_lock; /* the same, when it next claims */
   unsigned planted_at, planted_words;

   /* Measurement */
   bool stopped;
   uint64_t stopped_at, cut;
   uint64_t tick_start, idle;
   unsigned lost_times;               /* a timer's interrupt was still pending */
   struct figure tick, frame, character_time, claim, ram_test;
   uint64_t claimed_at, test_begun;
   uint64_t due;                      /* of the clock's interrupt */
   struct figure late_clock, late_converter;
   uint64_t worked_until;             /* the last time when it did not sleep */
   struct figure ahead;               /* of its partner, while both work */
   bool claims;                       /* it holds the lock */
   struct handler handlers[HANDLERS];
   int depth;
   struct figure by_vector[256];
   struct place places[PLACES];
   int place_count;
   bool is_start[ROM_SIZE / 2];
   struct call calls[CALLS];
   int call_depth;
};

static struct node *nodes[PROCESSORS], *node, *loaded;
static int node_count;
static unsigned mhz;
static bool executing;
static bool may_fault;                /* Musashi has set its trap */
static bool has_bus_error;            /* until its vector is read */

static const uint16_t illegal_words[] = { 0x4AFC };
static const uint16_t odd_words[] = { 0x3038, 0x0001 };   /* move.w 1.w,d0 */
static const uint16_t loop_words[] = { 0x60FE };          /* bra to itself */
static const uint16_t no_device_words[] =                 /* move.w 400000,d0 */
   { 0x3039, 0x0040, 0x0000 };

static void fail(const char *text, unsigned where)
{
   fprintf(stderr, "board: %s: %s %06x, instruction at %06x\n", node->name,
           text, where, m68k_get_reg(NULL, M68K_REG_PPC));
   exit(2);
}

/* Nothing answers. Musashi's own bus error stacks the frame of an MC68010. Its
   address error has the frame and the time that both have on an MC68000. */
static void bus_error(unsigned where, unsigned mode)
{
   if (!may_fault || CPU_RUN_MODE == RUN_MODE_BERR_AERR_RESET_WSF)
      fail("halted: a fault while an exception is stacked, at", where);
   m68ki_aerr_address = where;
   m68ki_aerr_write_mode = mode;
   m68ki_aerr_fc = FLAG_S | FUNCTION_CODE_USER_DATA;
   has_bus_error = true;
   longjmp(m68ki_aerr_trap, 1);
}

static uint64_t cycles(unsigned microseconds)
{
   return (uint64_t)microseconds * mhz;
}

static uint64_t now(void)
{
   if (node->held)
      return node->held_at;
   return node->time + (executing ? (uint64_t)m68k_cycles_run() : 0);
}

static void look_again(void)
{
   if (executing)
      m68k_end_timeslice();
}

/* The cycles that the processor still has in this call of Musashi. */
extern int m68ki_remaining_cycles;

/* Interrupts */

static bool wants(const struct duart *duart)
{
   uint8_t state = duart->state;

   if (duart->held > 0)
      state |= RECEIVED_A;
   return state & duart->mask;
}

static void request(void)
{
   int level = 0;

   if (wants(&node->clock))
      level = 4;
   if (node->converter.ready && node->converter.enabled)
      level = 5;
   if (wants(&node->line))
      level = 6;
   if (node->unexpected_interrupt)
      level = 6;
   if (node->bites)
      level = 7;
   node->requested = level > 0;
   m68k_set_irq((unsigned)level);
}

static bool is_asleep(const struct node *processor)
{
   return processor->ended || (processor->stopped && !processor->requested);
}

static void add(struct figure *figure)
{
   if (figure->now > figure->most)
      figure->most = figure->now;
   figure->all += figure->now;
   figure->count++;
   figure->now = 0;
}

int board_acknowledge(int level)
{
   int vector;
   uint64_t begun = now();

   if (node->cell != 0)
      fail("an interrupt while a cell is tested", node->cell);
   if (level == 7) {
      vector = WATCHDOG_VECTOR;
      node->bites = false;
   } else if (node->unexpected_interrupt) {
      vector = node->unexpected_interrupt;
      node->unexpected_interrupt = 0;
   } else if (level == 6)
      vector = node->line.vector;
   else if (level == 5)
      vector = node->converter.vector;
   else {
      vector = node->clock.vector;
      if (++node->served % TICKS_PER_FRAME == 0)
         node->row_is_due = true;
   }
   if (node->stopped) {
      node->stopped = false;
      if (now() < node->stopped_at) {
         /* It was pending: Musashi gives up the rest of the time. */
         begun = node->stopped_at;
         node->cut = begun + INTERRUPT_CYCLES;
      } else
         node->idle += now() - node->stopped_at;
   }
   if (level == 4 && node->begun) {
      node->late_clock.now = now() - node->due;
      add(&node->late_clock);
   } else if (level == 5 && node->begun) {
      node->late_converter.now = now() - node->converter.done;
      add(&node->late_converter);
   }
   if (node->depth < HANDLERS)
      node->handlers[node->depth++] = (struct handler){ vector, begun };
   /* An MC68000 takes the same time for an interrupt of each vector. */
   if (vector >= FIRST_USER_VECTOR)
      m68ki_remaining_cycles -= INTERRUPT_CYCLES - USER_VECTOR_CYCLES;
   return vector;
}

/* The stack is in RAM. */
static unsigned ram_long(unsigned where)
{
   const uint8_t *from = &node->ram[where - RAM_START];

   if (where - RAM_START > RAM_SIZE - 4)
      return 0;
   return (unsigned)from[0] << 24 | (unsigned)from[1] << 16
      | (unsigned)from[2] << 8 | from[3];
}

static void end_call(void)
{
   struct call *call = &node->calls[--node->call_depth];
   uint64_t spent = now() - call->begun;

   call->place->now += spent - call->without;
   if (node->call_depth > 0)
      node->calls[node->call_depth - 1].without += spent;
}

static void follow_calls(unsigned pc)
{
   unsigned stack;

   if (node->call_depth > 0
       && pc == node->calls[node->call_depth - 1].back) {
      stack = m68k_get_reg(NULL, M68K_REG_SP);
      while (node->call_depth > 0
             && pc == node->calls[node->call_depth - 1].back
             && stack > node->calls[node->call_depth - 1].stack)
         end_call();
   }
   if (!node->is_start[pc / 2] || node->call_depth == CALLS)
      return;
   for (int each = 0; each < node->place_count; each++)
      if (node->places[each].start == pc) {
         stack = m68k_get_reg(NULL, M68K_REG_SP);
         node->calls[node->call_depth++] = (struct call){
            &node->places[each], now(), 0, ram_long(stack), stack };
      }
}

static void count_places(void)
{
   unsigned minor = (node->ticks - 1) % TICKS_PER_FRAME;

   for (int each = 0; each < node->place_count; each++) {
      struct place *place = &node->places[each];

      if (node->ticks > TICKS_PER_FRAME + 1) {
         if (place->now > place->most[minor])
            place->most[minor] = place->now;
         place->all[minor] += place->now;
      }
      place->now = 0;
   }
}

static void read_places(const char *output)
{
   char path[4096];
   FILE *file;

   snprintf(path, sizeof path, "%s/%s.places", output, node->name);
   file = fopen(path, "r");
   while (file && node->place_count < PLACES) {
      struct place *place = &node->places[node->place_count];

      if (fscanf(file, "%x %63s", &place->start, place->name) != 2)
         break;
      if (place->start < ROM_SIZE) {
         node->is_start[place->start / 2] = true;
         node->place_count++;
      }
   }
   if (file)
      fclose(file);
}

static void read_stuck_bits(const char *output)
{
   char path[4096];
   FILE *file;
   unsigned bits;

   snprintf(path, sizeof path, "%s/%s.stuck", output, node->name);
   file = fopen(path, "r");
   if (!file)
      return;
   if (fscanf(file, "%x %x", &node->stuck_at, &bits) != 2)
      fail("wrong bits to be stuck at", node->stuck_at);
   node->stuck_bits = (uint8_t)bits;
   fclose(file);
}

static void print_places(void)
{
   uint64_t frames = node->frame.count ? node->frame.count : 1;

   for (int each = 0; each < node->place_count; each++) {
      const struct place *place = &node->places[each];

      for (int minor = 0; minor < TICKS_PER_FRAME; minor++)
         if (place->all[minor] > 0)
            fprintf(node->console,
                    "place %s minor %d worst %" PRIu64 " mean %" PRIu64 "\n",
                    place->name, minor, place->most[minor],
                    place->all[minor] / frames);
   }
}

void board_instruction(unsigned int pc)
{
   unsigned code;

   may_fault = true;
   if (pc >= ROM_SIZE - 1)
      return;
   if (node->place_count > 0)
      follow_calls(pc);
   code = (unsigned)node->rom[pc] << 8 | node->rom[pc + 1];
   if (code == STOP) {
      node->stopped = true;
      node->stopped_at = now() + STOP_CYCLES;
   } else if (code == RETURN_FROM_EXCEPTION && node->depth > 0) {
      struct handler *ended = &node->handlers[--node->depth];
      uint64_t spent = now() + RETURN_CYCLES - ended->begun;

      if (node->begun) {
         node->by_vector[ended->vector].now = spent;
         add(&node->by_vector[ended->vector]);
      }
      /* An interrupt before the first instruction of another handler. */
      if (node->depth > 0)
         node->handlers[node->depth - 1].begun += spent;
      else if (node->call_depth > 0)
         node->calls[node->call_depth - 1].without += spent;
   }
   if (node->planted && node->planted_at == 0)
      node->planted_at = pc;
}

/* MC68681 */

static void reset_duart(struct duart *duart)
{
   memset(duart, 0, sizeof *duart);
   duart->vector = 15;
}

static uint8_t status(const struct duart *duart, int channel)
{
   if (channel == 1)
      return duart->sends[1] ? SENDER_READY | SENDER_EMPTY : 0;
   return (duart->held > 0 ? RECEIVED : 0)
      | (duart->held >= FIFO ? FIFO_FULL : 0)
      | (duart->sends[0] && now() + cycles(CHARACTER_US) >= duart->sender_free
         ? SENDER_READY : 0)
      | (now() >= duart->sender_free ? SENDER_EMPTY : 0)
      | (duart->overrun ? OVERRUN : 0)
      | (duart->held > 0 ? duart->fifo[0].errors : 0);
}

static uint8_t format(const struct duart *duart)
{
   return (uint8_t)((duart->mode[0][0] & 0x1F) << 3
                    ^ (duart->mode[0][1] & 0x0F) ^ duart->clock[0] << 1);
}

static void play_tape(void);

static void start_timer(struct duart *duart)
{
   /* Mode 6: X1 itself; a period has two times the preloaded count. */
   if ((duart->auxiliary & 0x70) != 0x60)
      fail("a timer mode that is not emulated", duart->auxiliary);
   duart->period = (uint64_t)2 * duart->preload * mhz / 4;
   duart->next = now() + duart->period;
   duart->runs = true;
   if (duart == &node->clock && !node->begun) {
      node->begun = true;
      node->start = now();
      node->tick_start = now();
      node->idle = 0;
      memset(node->by_vector, 0, sizeof node->by_vector);
      node->partner->begun = true;
      node->partner->start = node->start;
      memset(node->partner->by_vector, 0, sizeof node->by_vector);
      duart->next += (uint64_t)node->lag * cycles(TICK_US);
      play_tape();
   }
   look_again();
}

static uint8_t read_duart(struct duart *duart, unsigned place)
{
   int channel = place >= 8 && place < 12;
   uint8_t value;

   switch (place) {
   case 0: case 8:
      value = duart->mode[channel][duart->place[channel]];
      duart->place[channel] = 1;
      return value;
   case 1: case 9:
      return status(duart, channel);
   case 3:
      value = duart->fifo[0].data;
      if (duart->held > 0)
         memmove(duart->fifo, duart->fifo + 1,
                 (size_t)--duart->held * sizeof duart->fifo[0]);
      break;
   case 5:
      return (uint8_t)(duart->state | (duart->held > 0 ? RECEIVED_A : 0));
   case 12:
      return duart->vector;
   case 14:
      start_timer(duart);
      return 0xFF;
   case 15:
      duart->state &= (uint8_t)~COUNTER_READY;
      value = 0xFF;
      break;
   default:
      return 0xFF;
   }
   request();
   return value;
}

static void send_character(struct duart *duart, uint8_t data)
{
   struct node *other = node_count <= 2 ? NULL : node == nodes[1]
      ? nodes[3] : nodes[1];
   uint64_t begin = now() > duart->sender_free ? now() : duart->sender_free;

   if (!duart->sends[0] || !node->is_telemetry_board)
      return;
   duart->sender_free = begin + cycles(CHARACTER_US);
   if (!other || !node->begun || !other->begun || other->ended)
      return;
   if (other->characters == ON_LINE)
      fail("characters on the line", ON_LINE);
   other->coming[other->characters++] = (struct character){
      duart->sender_free - node->start + other->start, data, format(duart) };
}

static void command(struct duart *duart, int channel, uint8_t value)
{
   switch (value >> 4 & 7) {
   case 1: duart->place[channel] = 0; break;
   case 2:
      duart->receives[channel] = false;
      if (channel == 0)
         duart->held = 0;
      break;
   case 3: duart->sends[channel] = false; break;
   case 4:                            /* also those of the oldest character */
      if (channel == 0) {
         duart->overrun = false;
         duart->fifo[0].errors = 0;
      }
      break;
   default: break;
   }
   if (value & 1) duart->receives[channel] = true;
   if (value & 2) duart->receives[channel] = false;
   if (value & 4) duart->sends[channel] = true;
   if (value & 8) duart->sends[channel] = false;
}

static void write_duart(struct duart *duart, unsigned place, uint8_t value)
{
   int channel = place >= 8 && place < 12;

   switch (place) {
   case 0: case 8:
      duart->mode[channel][duart->place[channel]] = value;
      duart->place[channel] = 1;
      break;
   case 1: case 9: duart->clock[channel] = value; break;
   case 2: case 10: command(duart, channel, value); break;
   case 3: send_character(duart, value); break;
   case 4: duart->auxiliary = value; break;
   case 5: duart->mask = value; break;
   case 6:
      duart->preload = (uint16_t)(value << 8 | (duart->preload & 0xFF));
      break;
   case 7: duart->preload = (uint16_t)((duart->preload & 0xFF00) | value); break;
   case 11:
      if (duart == &node->line && duart->sends[1])
         putc(value, node->console);
      break;
   case 12: duart->vector = value; break;
   default: break;
   }
   request();
   look_again();
}

static void receive(struct duart *duart, const struct character *character)
{
   struct received received = { character->data, 0 };

   if (!duart->receives[0])
      return;
   if (character->format != format(duart))
      received.errors |= WRONG_FRAME;
   received.errors |= node->next_errors & (WRONG_PARITY | WRONG_FRAME);
   if (node->next_errors & OVERRUN)
      duart->overrun = true;
   else {
      /* A fifth one replaces that in the shift register. */
      if (duart->held == FIFO + 1) {
         duart->overrun = true;
         duart->held--;
      }
      duart->fifo[duart->held++] = received;
   }
   node->next_errors = 0;
}

/* Converter */

static uint16_t number(const uint8_t *from, int bytes)
{
   (void)bytes;
   return (uint16_t)(from[0] | from[1] << 8);
}

static uint32_t long_number(const uint8_t *from)
{
   return number(from, 2) | (uint32_t)number(from + 2, 2) << 16;
}

static uint16_t read_converter(unsigned place)
{
   switch (place) {
   case 0: return node->converter.channel;
   case 2:
      node->converter.ready = false;
      request();
      return node->converter.data;
   default: return 0xFFFF;
   }
}

static void write_converter(unsigned place, uint16_t value)
{
   struct converter *converter = &node->converter;

   switch (place) {
   case 0:
      converter->channel = value % CHANNELS;
      converter->converting = true;
      converter->ready = false;
      converter->done = now() + cycles(CONVERSION_US);
      break;
   case 4: converter->vector = (uint8_t)value; break;
   case 6: converter->enabled = value & 1; break;
   default: break;
   }
   request();
   look_again();
}

/* Settings and the end */

static void plant(const uint16_t *words)
{
   node->planted = words;
   node->planted_at = node->planted_words = 0;
}

static uint32_t setting(unsigned place)
{
   switch (place) {
   case 0:
      if (node->fails_in_start)
         plant(illegal_words);
      node->fails_in_start = false;
      return node->flags;
   case 4: return node->delay_us;
   case 8:
      if (node->is_telemetry_board)
         return node->partner->ended;
      return now() - node->start >= node->length * cycles(CHARACTER_US);
   default: return 0xFFFFFFFF;
   }
}

/* What is due at a tick */
static unsigned due(void)
{
   return (node->row_is_due ? 1 : 0) | (setting(8) ? 2 : 0);
}

static void print_figure(const char *name, const struct figure *figure)
{
   uint64_t count = figure->count ? figure->count : 1;

   fprintf(node->console, " %s_worst %" PRIu64 " %s_mean %" PRIu64, name,
           figure->most, name, figure->all / count);
}

static void end_run(void)
{
   fprintf(node->console, "cycles mhz %u characters %u lost_times %u", mhz,
           node->length, node->lost_times);
   if (node->is_telemetry_board)
      print_figure("character", &node->character_time);
   else {
      print_figure("tick", &node->tick);
      print_figure("frame", &node->frame);
   }
   print_figure("claim", &node->claim);
   print_figure("ahead", &node->ahead);
   if (!node->is_telemetry_board) {
      print_figure("ram_test", &node->ram_test);
      print_figure("late_clock", &node->late_clock);
      print_figure("late_converter", &node->late_converter);
   }
   for (int vector = 0; vector < 256; vector++)
      if (node->by_vector[vector].count) {
         char name[8];

         sprintf(name, "int%d", vector);
         print_figure(name, &node->by_vector[vector]);
         fprintf(node->console, " %s_count %" PRIu64, name,
                 node->by_vector[vector].count);
      }
   fprintf(node->console, " start %" PRIu64 "\n", node->start);
   print_places();
   node->ended = true;
   look_again();
}

static void control(unsigned place, uint16_t value)
{
   switch (place) {
   case 0xC:
      if (value && !node->held) {
         node->held_at = now();
         node->held = true;
      } else if (!value && node->held) {
         node->time = node->held_at - (uint64_t)m68k_cycles_run();
         node->held = node->row_is_due = false;
      }
      break;
   case 0xE: end_run(); break;
   default: break;
   }
}

void board_reset(void)
{
   struct converter none = { 0 };

   reset_duart(&node->line);
   reset_duart(&node->clock);
   node->converter = none;
   node->watched = node->bites = false;
   node->planted = node->planted_with_lock = NULL;
   node->in_test = WORDS;
   node->depth = 0;
   node->call_depth = 0;
   request();
}

/* Memory */

static struct duart *duart_at(unsigned where)
{
   return where >> 5 & 1 ? &node->clock : &node->line;
}

/* Two processors with one claim each are an error of this program or of TAS.
   A processor may release a claim of its time before a restart. */
static void write_lock(uint8_t before, uint8_t value)
{
   if (value == TAKEN && before == 0) {
      if (node->partner->claims)
         fail("both processors have claimed", LOCK);
      node->claims = true;
      node->claimed_at = now();
      if (node->planted_with_lock) {
         plant(node->planted_with_lock);
         node->planted_with_lock = NULL;
      }
   } else if (value == 0 && node->claims) {
      node->claims = false;
      node->claim.now = now() - node->claimed_at;
      add(&node->claim);
   }
}

static unsigned stuck_byte(unsigned where)
{
   unsigned value = node->stuck_value;

   if (node->follows)
      value = ram_long(where & ~3U) >> (node->follows - 1) & 1
         ? node->stuck_bits : 0;
   return (node->ram[where - RAM_START] & ~node->stuck_bits) | value;
}

unsigned int m68k_read_memory_8(unsigned int where)
{
   where &= 0xFFFFFF;
   if (where < ROM_SIZE)
      return node->rom[where];
   if (where - RAM_START < RAM_SIZE)
      return where == node->stuck_at ? stuck_byte(where)
         : node->ram[where - RAM_START];
   if (where - DUAL_START < DUAL_SIZE)
      return node->dual[where - DUAL_START];
   if (where >> 6 == 0xF00000 >> 6)
      return where & 1 ? read_duart(duart_at(where), where >> 1 & 15) : 0xFF;
   bus_error(where, MODE_READ);
   return 0;
}

unsigned int m68k_read_memory_16(unsigned int where)
{
   where &= 0xFFFFFF;
   if (node->planted && node->planted_at != 0
       && where == node->planted_at + 2 * node->planted_words)
   {
      unsigned word = node->planted[node->planted_words++];

      if (node->planted == loop_words)
         node->planted_words = 0;
      else if (node->planted_words == (node->planted == illegal_words ? 1
                                       : node->planted == odd_words ? 2 : 3))
         node->planted = NULL;
      return word;
   }
   if (where >> 4 == 0xF10000 >> 4)
      return read_converter(where & 15);
   if (where - 0xF20000 < 2 * SERVOS)
      return node->servos[(where - 0xF20000) / 2];
   if (where == 0xF3000C)
      return due();
   return m68k_read_memory_8(where) << 8 | m68k_read_memory_8(where + 1);
}

unsigned int m68k_read_memory_32(unsigned int where)
{
   where &= 0xFFFFFF;
   if (where >> 4 == 0xF30000 >> 4)
      return setting(where & 15);
   if (has_bus_error && where == ADDRESS_ERROR_VECTOR) {
      has_bus_error = false;
      where = BUS_ERROR_VECTOR;
   }
   return m68k_read_memory_16(where) << 16 | m68k_read_memory_16(where + 2);
}

void m68k_write_memory_8(unsigned int where, unsigned int value)
{
   where &= 0xFFFFFF;
   if (where - RAM_START < RAM_SIZE)
      node->ram[where - RAM_START] = (uint8_t)value;
   else if (where - DUAL_START < DUAL_SIZE) {
      if (where - DUAL_START == LOCK)
         write_lock(node->dual[LOCK], (uint8_t)value);
      node->dual[where - DUAL_START] = (uint8_t)value;
   } else if (where >> 6 == 0xF00000 >> 6) {
      if (where & 1)
         write_duart(duart_at(where), where >> 1 & 15, (uint8_t)value);
   } else
      bus_error(where, MODE_WRITE);
}

void m68k_write_memory_16(unsigned int where, unsigned int value)
{
   where &= 0xFFFFFF;
   if (where >> 4 == 0xF10000 >> 4)
      write_converter(where & 15, (uint16_t)value);
   else if (where - 0xF20000 < 2 * SERVOS)
      node->servos[(where - 0xF20000) / 2] = (uint16_t)value;
   else if (where >> 4 == 0xF30000 >> 4)
      control(where & 15, (uint16_t)value);
   else if (where == 0xF40000) {
      node->watched = true;
      node->watchdog = now() + cycles(WATCHDOG_US);
      look_again();
   } else {
      m68k_write_memory_8(where, value >> 8 & 0xFF);
      m68k_write_memory_8(where + 1, value & 0xFF);
   }
}

static void look_at_test(unsigned where)
{
   unsigned contents;

   if (where != 0 && node->cell == 0) {
      node->cell = where;
      node->contents = m68k_read_memory_32(where);
      node->test_begun = now();
   } else if (where == 0 && node->cell != 0) {
      contents = m68k_read_memory_32(node->cell);
      if (contents != node->contents)
         fail("a test has changed the cell", node->cell);
      node->cell = 0;
      node->ram_test.now = now() - node->test_begun;
      add(&node->ram_test);
   } else if (where != 0)
      fail("a test did not end at", node->cell);
}

/* The cell under test has another word than before. */
static void happen_in_test(void)
{
   if (node->in_test == ILLEGAL_IN_RAM_TEST)
      plant(illegal_words);
   else if (node->in_test == INTERRUPT_IN_RAM_TEST) {
      node->unexpected_interrupt = UNUSED_VECTOR;
      request();
      look_again();
   }
   node->in_test = WORDS;
}

void m68k_write_memory_32(unsigned int where, unsigned int value)
{
   if (node->cell != 0 && (where & 0xFFFFFF) == node->cell
       && value != node->contents)
      happen_in_test();
   if ((where & 0xFFFFFF) == CELL_UNDER_TEST && !node->is_telemetry_board)
      look_at_test(value);
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

/* Time */

static void happen(uint32_t event, const uint8_t *words)
{
   switch (event) {
   case WORDS: node->words = words; break;
   case ILLEGAL_INSTRUCTION: plant(illegal_words); break;
   case UNEXPECTED_INTERRUPT: node->unexpected_interrupt = UNUSED_VECTOR; break;
   case ODD_ADDRESS: plant(odd_words); break;
   case NO_DEVICE: plant(no_device_words); break;
   case PARITY_ERROR: node->next_errors = WRONG_PARITY; break;
   case FRAMING_ERROR: node->next_errors = WRONG_FRAME; break;
   case LOST_CHARACTER: node->next_errors = OVERRUN; break;
   case ENDLESS_LOOP: plant(loop_words); break;
   case LOST_TIMER: node->clock.runs = node->line.runs = false; break;
   case ILLEGAL_WITH_LOCK: node->planted_with_lock = illegal_words; break;
   case LOOP_WITH_LOCK: node->planted_with_lock = loop_words; break;
   case STUCK_BITS:
      node->stuck_at = long_number(words);
      node->stuck_bits = (uint8_t)number(words + 4, 2);
      node->stuck_value = (uint8_t)number(words + 6, 2);
      node->follows = number(words + 8, 2);
      break;
   case ILLEGAL_IN_RAM_TEST: case INTERRUPT_IN_RAM_TEST:
      node->in_test = event;
      break;
   case ILLEGAL_IN_START: break;      /* it came before the clock began */
   case RESET_SWITCH:
      board_reset();
      node->stopped = false;
      m68k_pulse_reset();
      break;
   default: fail("an event that is not emulated", event);
   }
}

static void play_tape(void)
{
   struct node *controller = node;

   while (node->entries > 0 && long_number(node->entry) <= node->ticks) {
      uint32_t event = long_number(node->entry + 4);

      if (event >= ON_TELEMETRY_BOARD)
         node = controller->partner;
      happen(event % ON_TELEMETRY_BOARD, controller->entry + 8);
      node = controller;
      node->entry += ENTRY_SIZE;
      node->entries--;
   }
}

static uint64_t idle_cycles(void)
{
   uint64_t idle = node->idle;

   if (node->stopped) {
      idle += now() - node->stopped_at;
      node->stopped_at = now();
   }
   node->idle = 0;
   return idle;
}

/* Not the first one, which has no beginning. */
static void count_character_time(void)
{
   uint64_t idle = idle_cycles();

   node->character_time.now = now() - node->tick_start - idle;
   if (node->ticks++ > 0)
      add(&node->character_time);
   node->tick_start = now();
}

static void count_tick(void)
{
   uint64_t idle = idle_cycles();

   count_places();

   /* Not the frame in which the run begins. */
   if (node->ticks > TICKS_PER_FRAME) {
      node->tick.now = now() - node->tick_start - idle;
      node->frame.now += node->tick.now;
      add(&node->tick);
      if (node->ticks % TICKS_PER_FRAME == 0)
         add(&node->frame);
   }
   node->tick_start = now();
}

static void run_timer(struct duart *duart)
{
   if (!duart->runs || node->held || duart->next > now())
      return;
   duart->next += duart->period;
   if (duart->state & COUNTER_READY)
      node->lost_times++;
   duart->state |= COUNTER_READY;
   if (duart == &node->clock)
      node->due = now();
   if (duart == &node->line && node->begun)
      count_character_time();
   if (duart == &node->clock) {
      node->ticks++;
      count_tick();
      play_tape();
   }
}

static void run_devices(void)
{
   struct converter *converter = &node->converter;

   run_timer(&node->line);
   run_timer(&node->clock);
   if (converter->converting && converter->done <= now()) {
      converter->converting = false;
      converter->ready = true;
      converter->data =
         number(node->words + 2 * converter->channel, 2) & 0xFFF;
   }
   if (node->watched && !node->held && node->watchdog <= now()) {
      node->watched = false;
      node->bites = true;
   }
   while (node->characters > 0 && node->coming[0].time <= now()) {
      receive(&node->line, &node->coming[0]);
      memmove(node->coming, node->coming + 1,
              (size_t)--node->characters * sizeof node->coming[0]);
   }
   request();
}

static void sooner(uint64_t *time, bool when, uint64_t candidate)
{
   if (when && candidate < *time)
      *time = candidate;
}

static uint64_t next_event(const struct node *of, uint64_t until)
{
   uint64_t next = until;

   sooner(&next, of->line.runs, of->line.next);
   sooner(&next, of->clock.runs, of->clock.next);
   sooner(&next, of->converter.converting, of->converter.done);
   sooner(&next, of->characters > 0, of->coming[0].time);
   sooner(&next, of->watched, of->watchdog);
   return next > of->time ? next : of->time + 1;
}

/* This processor works on from now, which its partner may have passed. */
static void measure_ahead(void)
{
   struct node *partner = node->partner;

   if (partner->ended || partner->held || node->held
       || partner->worked_until < node->time)
      return;
   partner->ahead.now = partner->worked_until - node->time;
   add(&partner->ahead);
}

static void run(uint64_t until)
{
   if (loaded != node) {
      if (loaded)
         m68k_get_context(loaded->processor);
      m68k_set_context(node->processor);
      loaded = node;
   }
   while (!node->ended && node->time < until) {
      uint64_t next = next_event(node, until);
      bool works = !is_asleep(node);
      int used;

      if (works)
         measure_ahead();
      executing = true;
      may_fault = has_bus_error = false;
      node->cut = 0;
      used = m68k_execute((int)(next - node->time));
      executing = false;
      if (node->held)
         node->time = node->held_at;
      else
         node->time = node->cut ? node->cut : node->time + (uint64_t)used;
      if (works)
         node->worked_until = node->stopped ? node->stopped_at : node->time;
      run_devices();
   }
}

/* Both processors of a node, the earlier one first. */
static void run_node(struct node *controller, uint64_t until)
{
   struct node *board = controller->partner;

   for (;;) {
      uint64_t end = until;

      node = board->ended
         || (!controller->ended && controller->time <= board->time)
         ? controller : board;
      if (node->ended || node->time >= until)
         break;
      if (is_asleep(node))
         end = next_event(node, until);
      else if (!is_asleep(node->partner))
         sooner(&end, true, node->partner->time + AHEAD_CYCLES);
      else if (!node->partner->ended)
         /* It may wake. */
         end = next_event(node->partner, until);
      run(end);
   }
}


static uint8_t *contents(const char *path, size_t *length)
{
   static uint8_t buffer[1 << 22];
   FILE *file = fopen(path, "rb");
   uint8_t *data;

   if (!file) {
      perror(path);
      exit(2);
   }
   *length = fread(buffer, 1, sizeof buffer, file);
   fclose(file);
   data = malloc(*length + 1);
   if (!data)
      exit(2);
   memcpy(data, buffer, *length);
   return data;
}

static struct node *power_up(const char *output, const char *name,
                             const char *rom_path)
{
   static uint8_t neutral[2 * CHANNELS];
   char path[4096];
   size_t length;
   uint8_t *rom = contents(rom_path, &length);

   if (length > ROM_SIZE) {
      fprintf(stderr, "board: %s: more than the %d bytes of the ROM\n",
              rom_path, ROM_SIZE);
      exit(2);
   }
   node = calloc(1, sizeof *node);
   if (!node)
      exit(2);
   memcpy(node->rom, rom, length);
   snprintf(node->name, sizeof node->name, "%s", name);
   snprintf(path, sizeof path, "%s/%s.txt", output, node->name);
   node->console = fopen(path, "w");
   if (!node->console) {
      perror(path);
      exit(2);
   }
   node->words = neutral;
   node->processor = calloc(1, m68k_context_size());
   m68k_set_cpu_type(M68K_CPU_TYPE_68000);
   board_reset();
   m68k_pulse_reset();
   m68k_get_context(node->processor);
   return node;
}

static void power_up_node(const char *output, char **arguments)
{
   struct node *controller = power_up(output, arguments[0], arguments[1]);
   char name[64];
   size_t length;

   read_places(output);
   read_stuck_bits(output);
   node->tape = contents(arguments[3], &length);
   if (length < TAPE_HEAD
       || length < TAPE_HEAD
          + (size_t)ENTRY_SIZE * long_number(node->tape + 20)) {
      fprintf(stderr, "board: %s: a tape without its end\n", arguments[3]);
      exit(2);
   }
   node->lag = long_number(node->tape);
   node->delay_us = long_number(node->tape + 8);
   node->flags = long_number(node->tape + 12);
   node->length = long_number(node->tape + 16);
   node->entries = long_number(node->tape + 20);
   node->entry = node->tape + TAPE_HEAD;
   for (uint32_t each = 0; each < node->entries; each++)
      if (long_number(node->entry + each * ENTRY_SIZE + 4) == ILLEGAL_IN_START)
         node->fails_in_start = true;

   snprintf(name, sizeof name, "%.50s_board", arguments[0]);
   power_up(output, name, arguments[2]);
   node->is_telemetry_board = true;
   node->length = controller->length;
   node->partner = controller;
   controller->partner = node;
   node->dual = controller->dual = malloc(DUAL_SIZE);
   if (!node->dual)
      exit(2);
   read_stuck_bits(output);
   /* Its contents at power up are random, but the same in each run. */
   for (unsigned each = 0; each < DUAL_SIZE; each++)
      node->dual[each] = (uint8_t)(each * 151 + 77);
   nodes[node_count++] = controller;
   nodes[node_count++] = node;
}

int main(int count, char **arguments)
{
   uint64_t time = 0;

   if (count != 7 && count != 11) {
      fprintf(stderr, "usage: board MHZ OUTPUT NODE ROM TELEMETRY_ROM TAPE"
              " [NODE ROM TELEMETRY_ROM TAPE]\n");
      return 2;
   }
   mhz = (unsigned)atoi(arguments[1]);
   if (mhz < 4 || mhz > 400) {
      fprintf(stderr, "board: %s: not 4 to 400 MHz\n", arguments[1]);
      return 2;
   }
   m68k_init();
   for (int each = 3; each < count; each += 4)
      power_up_node(arguments[2], arguments + each);

   /* Up to the time when the clocks begin. */
   for (int each = 0; each < node_count; each += 2)
      for (uint64_t begin = 0;
           !nodes[each]->begun && !nodes[each]->ended;
           begin += AHEAD_CYCLES)
         run_node(nodes[each], begin);
   for (bool all = false; !all; time += cycles(SLICE_US)) {
      all = true;
      for (int each = 0; each < node_count; each += 2) {
         run_node(nodes[each], nodes[each]->start + time);
         /* A board waits for ever for a controller that does not start. */
         all = all && nodes[each]->ended
            && (nodes[each + 1]->ended || !nodes[each]->begun);
      }
   }
   for (int each = 0; each < node_count; each++)
      fclose(nodes[each]->console);
   return 0;
}
