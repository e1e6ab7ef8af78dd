# SPDX-License-Identifier: Apache-2.0
"""Jobs on Dask's workers, here or at a scheduler's address (SIM-6).

    for job, result in workers.done(cargo, jobs, count=2):

A worker that dies costs its job a second try: Dask gives it to another one, or
to the one that is started in its place. Results come as they are done.
"""

import contextlib
import logging
import sys
import tempfile

from urv import faults

# So many jobs wait at the scheduler for each worker.
AHEAD = 20

# How often a job's worker may die before the job is to blame.
DEATHS = 3


def task():
    """What a worker is asked to do. A nested function travels by value."""
    def do_it(name, job):
        from distributed import get_worker
        return get_worker().plugins[name].do(job)
    return do_it


@contextlib.contextmanager
def connected(scheduler, count):
    """A client of that scheduler, or of workers of our own."""
    import dask
    import distributed

    dask.config.set({"distributed.scheduler.allowed-failures": DEATHS})
    if scheduler:
        try:
            client = distributed.Client(scheduler, timeout="5s")
        except (OSError, ValueError, TypeError) as fault:
            raise faults.Failed(
                f"no scheduler at {faults.quoted(scheduler)}: {fault}"
            ) from fault
        with client:
            yield client
        return
    with tempfile.TemporaryDirectory(prefix="urv-") as place, \
            distributed.LocalCluster(
                n_workers=count, threads_per_worker=1, processes=True,
                dashboard_address="127.0.0.1:0", local_directory=place,
                silence_logs=logging.CRITICAL) as cluster, \
            distributed.Client(cluster) as client:
        yield client


def done(cargo, jobs, scheduler=None, count=2):
    """Each job with its result, in the order in which they are done."""
    with connected(scheduler, count) as client:
        yield from done_by(client, cargo, jobs)


def done_by(client, cargo, jobs):
    import distributed

    client.register_plugin(plugin_of(cargo), name=cargo.name)
    do_it = task()
    waiting = iter(jobs)
    asked = {}
    results = distributed.as_completed()

    def ask_more():
        wanted = AHEAD * max(1, len(client.nthreads()))
        while len(asked) < wanted:
            job = next(waiting, None)
            if job is None:
                return
            future = client.submit(do_it, cargo.name, job, pure=False)
            asked[future] = job
            results.add(future)

    try:
        ask_more()
        for future in results:
            job = asked.pop(future)
            result = answer(future)
            if result.get("cargo", cargo.hash) != cargo.hash:
                raise faults.Failed("a worker had another cargo")
            yield job, result
            ask_more()
    finally:
        client.unregister_worker_plugin(cargo.name)


def plugin_of(cargo):
    """The cargo as Dask takes it: a nested class travels by value, and so
    does the module that it needs, for no worker can import this package."""
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
    """A job's result, or what became of it."""
    try:
        return future.result()
    except Exception as fault:  # noqa: BLE001 - whatever a worker meets
        return {"fault": f"{type(fault).__name__}: {fault}"[:200]}
