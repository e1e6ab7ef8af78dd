# SPDX-License-Identifier: Apache-2.0
"""When the machine paused, and programs were not run in time (EVI-9).

Watchers wait for the next millisecond and do nothing else; a pause is when one
is woken late. Each processor has two of them. One has a priority above every
other program: it is late when the kernel or the hypervisor has the processor.
One has the usual priority: it is late when another program has the processor.
Only root may have the higher.
"""

import bisect
import multiprocessing
import os
import time

PERIOD_US = 1_000

# The shortest pause. Without a pause a program is woken within 0.1 ms.
SHORTEST_US = 500


def now_us():
    """The time of the clock that the partitions use."""
    return time.clock_gettime_ns(time.CLOCK_MONOTONIC) // 1_000


def watch(processor, policy, seconds, pauses):
    """Put into pauses, a list, when this processor paused: from and until."""
    os.sched_setaffinity(0, {processor})
    os.sched_setscheduler(
        0, policy, os.sched_param(os.sched_get_priority_min(policy)))
    found = []
    due = now_us()
    end = due + seconds * 1_000_000
    while due < end:
        due += PERIOD_US
        time.sleep(max(0, due - now_us()) / 1e6)
        woken = now_us()
        if woken - due >= SHORTEST_US:
            found.append((due, woken))
            due = woken
    pauses.extend(found)


class Watchers:
    """Watches all processors, for a number of seconds."""

    def __init__(self, seconds):
        self.manager = multiprocessing.Manager()
        self.pauses = self.manager.list()
        self.processes = [
            multiprocessing.Process(
                target=watch, args=(each, policy, seconds, self.pauses)
            )
            for each in sorted(os.sched_getaffinity(0))
            for policy in (os.SCHED_FIFO, os.SCHED_OTHER)
        ]
        for process in self.processes:
            process.start()

    def result(self):
        """All pauses, in order, or None if it could not be watched."""
        for process in self.processes:
            process.join()
        found = sorted(self.pauses)
        self.manager.shutdown()
        if any(process.exitcode != 0 for process in self.processes):
            return None
        return found


class Pauses:
    """Pauses in the order of their times, to be asked of."""

    def __init__(self, pauses):
        self.pauses = sorted(pauses)
        self.begins = [begin for begin, _ in self.pauses]
        self.longest = max((end - begin for begin, end in pauses), default=0)

    def within(self, begin, end):
        """There was one between two times."""
        place = bisect.bisect_left(self.begins, begin - self.longest)
        while place < len(self.begins) and self.begins[place] <= end:
            if self.pauses[place][1] >= begin:
                return True
            place += 1
        return False
