// SPDX-License-Identifier: Apache-2.0

// What peers.c does with binary heaps, with std::priority_queue.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <queue>
#include <utility>
#include <vector>

using Entry = std::pair<std::uint64_t, int>;
using Queue = std::priority_queue<Entry, std::vector<Entry>,
                                  std::greater<Entry>>;

static constexpr int turns = 31;

// All tasks sleep until the next frame, and are woken and chosen again.
static void frame(Queue &ready, Queue &asleep, std::uint64_t &ticks, int tasks)
{
   while (!ready.empty()) {
      asleep.push({ticks + 10, ready.top().second});
      ready.pop();
   }
   ticks += 10;
   while (!asleep.empty() && asleep.top().first <= ticks) {
      const int which = asleep.top().second;
      asleep.pop();
      ready.push({std::uint64_t(tasks - which), which});
   }
}

template <typename Turn>
static void measure(const char *what, int tasks, Turn turn)
{
   Queue ready, asleep;
   std::uint64_t ticks = 0;
   std::vector<double> took;
   const int times = 4000 / tasks;
   for (int which = 0; which < tasks; which++)
      ready.push({std::uint64_t(tasks - which), which});
   for (int number = 0; number < turns; number++) {
      const auto began = std::chrono::steady_clock::now();
      for (int time = 0; time < times; time++)
         turn(ready, asleep, ticks, tasks);
      took.push_back(std::chrono::duration<double, std::nano>(
         std::chrono::steady_clock::now() - began).count());
   }
   std::nth_element(took.begin(), took.begin() + turns / 2, took.end());
   std::printf("%s %d %.1f\n", what, tasks, took[turns / 2] / times / tasks);
}

int main()
{
   for (const int tasks : {2, 10, 16})
      measure("cpp_queue", tasks, frame);
   return 0;
}
