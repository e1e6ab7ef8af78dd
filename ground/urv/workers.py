# SPDX-License-Identifier: Apache-2.0
"""Jobs on Dask's workers, here or at a scheduler's address (SIM-6).

    for job, result in workers.done(cargo, jobs, count=2):

After the death of a worker its job is tried again: Dask gives it to another
worker, or to the replacement. Results come as they are done.

faults.Failed is raised within PATIENCE_S when the work cannot continue: no
worker, one of another version or without the needs of the cargo, no scheduler.
Results of finished jobs have come by then.
"""

import contextlib
import logging
import queue
import sys
import tempfile
import time
from pathlib import Path

from urv import certificates, faults

# The number of jobs that wait at the scheduler for each worker.
AHEAD = 20

# After this number of dead workers the job is to blame.
DEATHS = 3

# The longest time without a worker, or without a scheduler, in s.
PATIENCE_S = 25

# Both sides need the same versions of these; of Python's the last number may
# differ.
SAME = ("python", "dask", "distributed", "cloudpickle")

# After this number of failed jobs in a row the workers are to blame.
MOST_FAULTS = 20

LOOK_S = 1.0


def task():
    """The function for a worker. A nested function is sent by value."""
    def do_it(name, job):
        from distributed import get_worker
        return get_worker().plugins[name].do(job)
    return do_it


@contextlib.contextmanager
def connected(scheduler, count, security=None):
    """A client of that scheduler, or of local workers, which accept only peers
    with their certificate (SEC-12)."""
    import dask
    import distributed

    dask.config.set({"distributed.scheduler.allowed-failures": DEATHS})
    if scheduler:
        try:
            client = distributed.Client(scheduler, timeout="5s",
                                        security=security)
        except (OSError, ValueError, TypeError) as fault:
            raise faults.Failed(
                f"no scheduler at {faults.quoted(scheduler)}: {fault}"
            ) from fault
        with client:
            yield client
        return
    with tempfile.TemporaryDirectory(prefix="urv-") as place:
        security = certificates.temporary(Path(place))
        with distributed.LocalCluster(
                n_workers=count, threads_per_worker=1, processes=True,
                dashboard_address="127.0.0.1:0", local_directory=place,
                security=security, silence_logs=logging.CRITICAL) as cluster, \
                distributed.Client(cluster, security=security) as client:
            yield client


def done(cargo, jobs, scheduler=None, count=2, security=None):
    """Each job with its result, in the order in which they are done. For the
    security of a scheduler's address see certificates.of."""
    with connected(scheduler, count, security) as client:
        yield from done_by(client, cargo, jobs, scheduler or "here")


def done_by(client, cargo, jobs, where="here"):
    watch = Watch(client, where)
    watch.await_a_worker()
    must_be_the_same(client, where)
    try:
        client.register_plugin(plugin_of(cargo), name=cargo.name)
    except RuntimeError as fault:
        raise faults.Failed(f"a worker of {where} lacks what it needs:"
                            f" {fault}") from fault
    do_it = task()
    waiting = iter(jobs)
    asked = {}
    results = queue.SimpleQueue()

    def ask_more():
        wanted = AHEAD * max(1, watch.workers())
        while len(asked) < wanted:
            job = next(waiting, None)
            if job is None:
                return
            future = client.submit(do_it, cargo.name, job, pure=False)
            asked[future] = job
            future.add_done_callback(results.put)

    try:
        ask_more()
        in_vain = 0
        while asked:
            try:
                future = results.get(timeout=LOOK_S)
            except queue.Empty:
                watch.look()
                continue
            watch.must_be_connected()
            result = answer(future)
            if result.get("cargo", cargo.hash) != cargo.hash:
                raise faults.Failed("a worker had another cargo")
            yield asked.pop(future), result
            in_vain = in_vain + 1 if "fault" in result else 0
            if in_vain == MOST_FAULTS:
                raise faults.Failed(
                    f"the last {in_vain} could not be done, the workers of"
                    f" {where} are to blame: {result['fault']}")
            ask_more()
    finally:
        if client.status == "running":
            with contextlib.suppress(Exception):
                client.unregister_worker_plugin(cargo.name)


class Watch:
    """Watches whether there is a scheduler, and a worker."""

    def __init__(self, client, where):
        self.client = client
        self.where = where
        self.last_seen = time.monotonic()

    def must_be_connected(self):
        if self.client.status != "running":
            raise faults.Failed(
                f"the scheduler of {self.where} has ended or cannot be"
                " reached")

    def workers(self):
        """How many there are; none when the scheduler does not answer."""
        try:
            return len(self.client.nthreads())
        except (OSError, TimeoutError):
            return 0

    def look(self):
        """Raises faults.Failed when there has been none for too long."""
        self.must_be_connected()
        is_there = self.workers() > 0
        self.must_be_connected()
        now = time.monotonic()
        if is_there:
            self.last_seen = now
        elif now - self.last_seen >= PATIENCE_S:
            raise faults.Failed(
                f"no worker of {self.where} for {PATIENCE_S} s; the log of"
                " an earlier worker gives the reason")

    def await_a_worker(self):
        while True:
            self.look()
            if self.workers():
                return
            time.sleep(LOOK_S / 4)


def must_be_the_same(client, where):
    """Code is sent to workers: each side must have the same versions."""
    found = client.get_versions()

    def of(side):
        packages = {**side.get("packages", {})}
        python = str(packages.get("python") or side.get("host", {}).get(
            "python", "unknown"))
        packages["python"] = ".".join(python.split(".")[:2])
        return packages

    here = of(found["client"])
    sides = {"the scheduler": found["scheduler"], **{
        f"the worker {name}": side
        for name, side in found["workers"].items()}}
    for name, side in sides.items():
        there = of(side)
        for package in SAME:
            if there.get(package) != here.get(package):
                raise faults.Failed(
                    f"{name} of {where} has {package} {there.get(package)},"
                    f" here is {here.get(package)}")


def plugin_of(cargo):
    """The cargo in Dask's form: a nested class is sent by value, and so is the
    module that it needs, because no worker can import this package."""
    import cloudpickle
    import distributed

    for thing in (type(cargo), cargo.work):
        cloudpickle.register_pickle_by_value(sys.modules[thing.__module__])

    class Plugin(distributed.WorkerPlugin):
        def setup(self, worker):
            cargo.setup(worker)

        def do(self, job):
            return cargo.do(job)

    return Plugin()


def answer(future):
    """A job's result, or its error."""
    try:
        return future.result()
    except Exception as fault:  # noqa: BLE001 - whatever a worker meets
        return {"fault": " ".join(
            f"{type(fault).__name__}: {fault}".split())[:200]}
