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

int main()
{
   for (const int tasks : {2, 10, 16, 100, 500}) {
      Queue ready, asleep;
      std::uint64_t ticks = 0;
      std::vector<double> took;
      const int frames = 4000 / tasks;
      for (int which = 0; which < tasks; which++)
         ready.push({std::uint64_t(tasks - which), which});
      for (int turn = 0; turn < turns; turn++) {
         const auto began = std::chrono::steady_clock::now();
         for (int number = 0; number < frames; number++)
            frame(ready, asleep, ticks, tasks);
         took.push_back(std::chrono::duration<double, std::nano>(
            std::chrono::steady_clock::now() - began).count());
      }
      std::nth_element(took.begin(), took.begin() + turns / 2, took.end());
      std::printf("cpp_queue %d %.1f\n", tasks,
                  took[turns / 2] / frames / tasks);
   }
   return 0;
}
