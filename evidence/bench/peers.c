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

enum { MOST = 1024, TURNS = 31 };

static uint8_t sent[MOST], got[MOST];

static double now(void)
{
   struct timespec at;
   clock_gettime(CLOCK_MONOTONIC, &at);
   return at.tv_sec * 1e9 + at.tv_nsec;
}

static int by_size(const void *left, const void *right)
{
   double one = *(const double *)left, other = *(const double *)right;
   return (one > other) - (one < other);
}

/* The median of many turns of so many calls, each of which does so much: what
   else the machine does hardly matters. */
static void measure(const char *what, int size, void (*call)(int, int),
                    int calls, int each)
{
   double took[TURNS];
   for (int turn = 0; turn < TURNS; turn++) {
      double started = now();
      for (int number = 0; number < calls; number++)
         call(number, size);
      took[turn] = now() - started;
   }
   qsort(took, TURNS, sizeof *took, by_size);
   printf("%s %d %.1f\n", what, size, took[TURNS / 2] / calls / each);
   fflush(stdout);
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

static void mutex_mailbox(int turn, int size)
{
   sent[0] = (uint8_t)turn;
   if (!send_box(sent, size) || !receive_box(got, size) || got[0] != sent[0])
      abort();
}

static void lock_and_unlock(int turn, int size)
{
   (void)turn, (void)size;
   pthread_mutex_lock(&box.lock);
   pthread_mutex_unlock(&box.lock);
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

static void atomic_mailbox(int turn, int size)
{
   sent[0] = (uint8_t)turn;
   send_atomic(sent, size);
   if (!receive_atomic(got, size) || got[0] != sent[0])
      abort();
}

static mqd_t queue;

static void open_queue(int size)
{
   char name[40];
   struct mq_attr as = { .mq_maxmsg = 1, .mq_msgsize = size };
   snprintf(name, sizeof name, "/urv-bench-%d", (int)getpid());
   queue = mq_open(name, O_RDWR | O_CREAT | O_EXCL, 0600, &as);
   if (queue == (mqd_t)-1) {
      perror("mq_open");
      exit(1);
   }
   mq_unlink(name);
}

static void posix_queue(int turn, int size)
{
   sent[0] = (uint8_t)turn;
   if (mq_send(queue, (char *)sent, size, 0) != 0
       || mq_receive(queue, (char *)got, size, NULL) != size)
      abort();
}

static int ends[2];

static void through_pipe(int turn, int size)
{
   sent[0] = (uint8_t)turn;
   if (write(ends[1], sent, size) != size || read(ends[0], got, size) != size)
      abort();
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

static heap ready, asleep;
static uint64_t ticks;

static void fill_heap(int tasks)
{
   ready.count = asleep.count = 0;
   for (int i = 0; i < tasks; i++)
      put(&ready, (entry){ tasks - i, i });
}

static void heap_frame(int turn, int tasks)
{
   (void)turn;
   while (ready.count > 0) {
      entry e = take(&ready);
      put(&asleep, (entry){ ticks + 10, e.which });
   }
   ticks += 10;
   while (asleep.count > 0 && asleep.at[1].key <= ticks) {
      entry e = take(&asleep);
      put(&ready, (entry){ tasks - e.which, e.which });
   }
}

/* CRC-8/DARC by a table of 256 bytes. */

static uint8_t table[256], sum;

static void fill_table(void)
{
   for (int i = 0; i < 256; i++) {
      uint8_t c = (uint8_t)i;
      for (int bit = 0; bit < 8; bit++)
         c = (uint8_t)(c & 1 ? c >> 1 ^ 0x9C : c >> 1);
      table[i] = c;
   }
}

static void table_checksum(int turn, int size)
{
   (void)turn;
   for (int place = 1; place <= size; place++)
      sum = table[sum ^ place];
}

static void copy(int turn, int size)
{
   sent[0] = (uint8_t)turn;
   memcpy(got, sent, size);
   __asm__ volatile("" ::: "memory");
}

/* Two threads that hand over to each other by a condition variable. */

static struct {
   pthread_mutex_t lock;
   pthread_cond_t changed;
   int there;
} net = { PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, 0 };

static void hand_over(int from)
{
   pthread_mutex_lock(&net.lock);
   while (net.there != from)
      pthread_cond_wait(&net.changed, &net.lock);
   net.there = !from;
   pthread_cond_signal(&net.changed);
   pthread_mutex_unlock(&net.lock);
}

static void *other_side(void *unused)
{
   for (;;)
      hand_over(1);
   return unused;
}

static void there_and_back(int turn, int size)
{
   (void)turn, (void)size;
   hand_over(0);
   pthread_mutex_lock(&net.lock);
   while (net.there != 0)
      pthread_cond_wait(&net.changed, &net.lock);
   pthread_mutex_unlock(&net.lock);
}

int main(void)
{
   const int sizes[] = { 28, 66, 1024 }, tasks[] = { 2, 10, 16 };
   pthread_t other;

   /* A mailbox is between threads. Where there is but one, the C library
      spares itself what a lock costs. */
   if (pthread_create(&other, NULL, other_side, NULL) != 0 || pipe(ends) != 0)
      exit(1);
   memset(sent, 1, sizeof sent);
   for (int i = 0; i < 3; i++) {
      measure("c_mutex", sizes[i], mutex_mailbox, 4000, 1);
      check(sizes[i]);
      measure("c_atomics", sizes[i], atomic_mailbox, 4000, 1);
      check(sizes[i]);
      open_queue(sizes[i]);
      measure("posix_mq", sizes[i], posix_queue, 400, 1);
      check(sizes[i]);
      mq_close(queue);
      measure("pipe", sizes[i], through_pipe, 400, 1);
      check(sizes[i]);
   }
   measure("c_lock", 1, lock_and_unlock, 4000, 1);
   for (int i = 0; i < 3; i++) {
      fill_heap(tasks[i]);
      measure("c_heap", tasks[i], heap_frame, 4000 / tasks[i], tasks[i]);
   }
   fill_table();
   measure("c_table", 56, table_checksum, 1000, 1);
   measure("memcpy", 56, copy, 4000, 1);
   measure("c_switch", 2, there_and_back, 500, 2);
   if (sum == 0)
      puts("# 0");
   return 0;
}
