/* SPDX-License-Identifier: Apache-2.0 */

/* What one would take instead of the flight software's calls, as lines
   "WHAT NANOSECONDS": see urv_bench.adb. */

#define _GNU_SOURCE
#include <mqueue.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { TIMES = 200000, FEWER = 20000, MOST = 1024 };

static uint8_t sent[MOST], got[MOST];

static double now(void)
{
   struct timespec at;
   clock_gettime(CLOCK_MONOTONIC, &at);
   return at.tv_sec * 1e9 + at.tv_nsec;
}

static void say(const char *what, int size, double started, int done)
{
   printf("%s %d %.1f\n", what, size, (now() - started) / done);
}

static void check(int size)
{
   if (memcmp(sent, got, size) != 0)
      abort();
}

/* A mailbox with the same flags, behind a mutex. */

static struct {
   pthread_mutex_t lock;
   uint32_t produced, consumed, missed;
   uint8_t data[MOST];
} box = { .lock = PTHREAD_MUTEX_INITIALIZER };

__attribute__((noinline)) static int send_box(const uint8_t *item, int size)
{
   int success;
   pthread_mutex_lock(&box.lock);
   memcpy(box.data, item, size);
   success = box.produced == box.consumed;
   box.produced += success;
   pthread_mutex_unlock(&box.lock);
   return success;
}

__attribute__((noinline)) static int receive_box(uint8_t *item, int size)
{
   int fresh;
   pthread_mutex_lock(&box.lock);
   memcpy(item, box.data, size);
   fresh = box.produced != box.consumed;
   box.consumed = box.produced;
   box.missed += !fresh;
   pthread_mutex_unlock(&box.lock);
   return fresh;
}

static void mutex_mailbox(int size)
{
   double started = now();
   for (int turn = 0; turn < TIMES; turn++) {
      sent[0] = (uint8_t)turn;
      if (!send_box(sent, size) || !receive_box(got, size))
         abort();
      if (got[0] != sent[0])
         abort();
   }
   say("c_mutex", size, started, TIMES);
   check(size);
}

/* One producer and one consumer: three buffers, of which an atomic exchange
   hands over the newest. */

static uint8_t buffers[3][MOST];
static atomic_uint middle = 1;
static unsigned back = 0, front = 2;
enum { FRESH = 4 };

__attribute__((noinline)) static void send_atomic(const uint8_t *item, int size)
{
   memcpy(buffers[back], item, size);
   back = atomic_exchange_explicit(&middle, back | FRESH,
                                   memory_order_acq_rel) & 3;
}

__attribute__((noinline)) static int receive_atomic(uint8_t *item, int size)
{
   int fresh = 0;
   if (atomic_load_explicit(&middle, memory_order_relaxed) & FRESH) {
      front = atomic_exchange_explicit(&middle, front,
                                       memory_order_acq_rel) & 3;
      fresh = 1;
   }
   memcpy(item, buffers[front], size);
   return fresh;
}

static void atomic_mailbox(int size)
{
   double started = now();
   for (int turn = 0; turn < TIMES; turn++) {
      sent[0] = (uint8_t)turn;
      send_atomic(sent, size);
      if (!receive_atomic(got, size) || got[0] != sent[0])
         abort();
   }
   say("c_atomics", size, started, TIMES);
   check(size);
}

static void posix_queue(int size)
{
   char name[40];
   struct mq_attr as = { .mq_maxmsg = 1, .mq_msgsize = size };
   snprintf(name, sizeof name, "/urv-bench-%d", (int)getpid());
   mqd_t queue = mq_open(name, O_RDWR | O_CREAT | O_EXCL, 0600, &as);
   if (queue == (mqd_t)-1) {
      perror("mq_open");
      exit(1);
   }
   mq_unlink(name);
   double started = now();
   for (int turn = 0; turn < FEWER; turn++) {
      sent[0] = (uint8_t)turn;
      if (mq_send(queue, (char *)sent, size, 0) != 0
          || mq_receive(queue, (char *)got, size, NULL) != size)
         abort();
   }
   say("posix_mq", size, started, FEWER);
   check(size);
   mq_close(queue);
}

static void through_pipe(int size)
{
   int ends[2];
   if (pipe(ends) != 0)
      exit(1);
   double started = now();
   for (int turn = 0; turn < FEWER; turn++) {
      sent[0] = (uint8_t)turn;
      if (write(ends[1], sent, size) != size
          || read(ends[0], got, size) != size)
         abort();
   }
   say("pipe", size, started, FEWER);
   check(size);
   close(ends[0]);
   close(ends[1]);
}

/* Tasks by priority in a binary heap, those that sleep in another: each
   sleeps until the next frame, and is woken and chosen again. */

enum { TASKS = 16 };
typedef struct { uint64_t key; int which; } entry;
typedef struct { entry at[TASKS + 1]; int count; } heap;

static void put(heap *h, entry e)
{
   int i = ++h->count;
   while (i > 1 && h->at[i / 2].key > e.key) {
      h->at[i] = h->at[i / 2];
      i /= 2;
   }
   h->at[i] = e;
}

static entry take(heap *h)
{
   entry first = h->at[1], last = h->at[h->count--];
   int i = 1, child;
   while ((child = 2 * i) <= h->count) {
      if (child < h->count && h->at[child + 1].key < h->at[child].key)
         child++;
      if (last.key <= h->at[child].key)
         break;
      h->at[i] = h->at[child];
      i = child;
   }
   h->at[i] = last;
   return first;
}

static void heap_scheduler(void)
{
   static heap ready, asleep;
   uint64_t time = 0;
   int done = 0;
   for (int i = 0; i < TASKS; i++)
      put(&ready, (entry){ TASKS - i, i });
   double started = now();
   for (int frame = 0; frame < 5000; frame++) {
      while (ready.count > 0) {
         entry e = take(&ready);
         put(&asleep, (entry){ time + 10, e.which });
         done++;
      }
      time += 10;
      while (asleep.count > 0 && asleep.at[1].key <= time) {
         entry e = take(&asleep);
         put(&ready, (entry){ TASKS - e.which, e.which });
      }
   }
   say("c_heap", TASKS, started, done);
}

/* CRC-8/DARC by a table of 256 bytes. */

static void table_checksum(void)
{
   static uint8_t table[256];
   uint8_t sum = 0;
   for (int i = 0; i < 256; i++) {
      uint8_t c = (uint8_t)i;
      for (int bit = 0; bit < 8; bit++)
         c = (uint8_t)(c & 1 ? c >> 1 ^ 0x9C : c >> 1);
      table[i] = c;
   }
   double started = now();
   for (int turn = 0; turn < TIMES; turn++)
      for (int place = 1; place <= 56; place++)
         sum = table[sum ^ place];
   say("c_table", 56, started, TIMES);
   if (sum == 0)
      puts("# 0");
}

static void copy(int size)
{
   double started = now();
   for (int turn = 0; turn < TIMES; turn++) {
      sent[0] = (uint8_t)turn;
      memcpy(got, sent, size);
      __asm__ volatile("" ::: "memory");
   }
   say("memcpy", size, started, TIMES);
}

int main(void)
{
   const int sizes[] = { 28, 66, 1024 };
   memset(sent, 1, sizeof sent);
   for (int i = 0; i < 3; i++) {
      mutex_mailbox(sizes[i]);
      atomic_mailbox(sizes[i]);
      posix_queue(sizes[i]);
      through_pipe(sizes[i]);
   }
   heap_scheduler();
   table_checksum();
   copy(56);
   return 0;
}
