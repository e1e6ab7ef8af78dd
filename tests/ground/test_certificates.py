# SPDX-License-Identifier: Apache-2.0
"""SEC-12: Dask's workers, scheduler and clients take nobody without the
certificate."""

import asyncio
import json
import logging
import os
import ssl
import subprocess
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import ROOT, TIME_LIMIT_S
from station_rig import until

from urv import certificates, faults, workers

distributed = pytest.importorskip("distributed")

# Long enough for one that is let in.
REFUSED_S = 20

# The first byte of an alert of TLS.
ALERT = b"\x15"


@pytest.fixture
def quiet():
    """The scheduler's log of those who were refused is none of a test's."""
    log = logging.getLogger("distributed")
    before, log.level = log.level, logging.CRITICAL
    yield
    log.level = before


def folder(path):
    """Certificates for one cluster: ca.pem, cert.pem, key.pem."""
    path.mkdir()
    certificates.temporary(path)
    (path / "ca.pem").write_bytes((path / "cert.pem").read_bytes())
    return path


def addresses(client):
    """The certificates of the scheduler and its workers."""
    information = client.scheduler_info()
    return [client.scheduler.address, *information["workers"]]


def is_let_in(address, context):
    """True if a stranger's bytes are taken at the address: the other side
    ends the connection at once when its certificate is not taken."""
    host, _, port = address.partition("://")[2].rpartition(":")

    async def ask():
        try:
            reader, writer = await asyncio.open_connection(
                host, int(port), ssl=context)
        except OSError:
            return False
        try:
            # Without a word from here a server of TLS waits. It answers one
            # that is not TLS with an alert.
            writer.write(b"hello\r\n")
            first = await asyncio.wait_for(reader.read(1), REFUSED_S)
            return first not in (b"", ALERT)
        except OSError:
            return False
        finally:
            writer.close()

    # A browser of another test may have left this thread a running loop.
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(lambda: asyncio.run(ask())).result()


def context_of(path=None):
    """The connection of a stranger, who takes any certificate and shows one or
    none."""
    context = ssl.create_default_context()
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    if path is not None:
        context.load_cert_chain(path / "cert.pem", path / "key.pem")
    return context


def test_sec12_workers_here_take_nobody_without_their_certificate(
        tmp_path, quiet):
    foreign = folder(tmp_path / "foreign")
    with workers.connected(None, 1) as client:
        assert client.submit(abs, -7).result() == 7
        found = addresses(client)
        assert len(found) == 2
        for address in found:
            assert address.startswith("tls://127.0.0.1:")
            for context in (None, context_of(), context_of(foreign)):
                assert not is_let_in(address, context), address
        for address, security in (
                (found[0], certificates.of_folder(foreign)),
                (found[0].replace("tls", "tcp"), None)):
            with pytest.raises((OSError, TypeError)):
                distributed.Client(address, security=security, timeout="3s")
    # Two commands have two secrets.
    made = [certificates.temporary(make(tmp_path / name)) for name in "ab"]
    keys = [open(each.tls_client_key).read() for each in made]
    assert keys[0] != keys[1]
    assert os.stat(made[0].tls_client_key).st_mode & 0o077 == 0


def make(path):
    path.mkdir()
    return path


def test_sec12_a_scheduler_takes_those_of_its_certificates(
        tmp_path, urv, quiet):
    own, foreign = folder(tmp_path / "own"), folder(tmp_path / "foreign")
    options = ("--tls-ca-file", own / "ca.pem", "--tls-cert",
               own / "cert.pem", "--tls-key", own / "key.pem")
    place = tmp_path / "scheduler"
    with workers_at(place, options) as address:
        assert address.startswith("tls://")
        result = urv("monte-carlo", "--flights", 1, "--pilot", "level",
                     "--seconds", 10, "--scheduler", address,
                     "--certificates", own, "-o", "out")
        assert (result.returncode, result.stderr) == (0, "")
        result = urv("monte-carlo", "--flights", 1, "--pilot", "level",
                     "--seconds", 10, "--scheduler", address,
                     "--certificates", foreign, "-o", "out")
        assert result.returncode == 1
        assert result.stderr.startswith(f'urv: no scheduler at "{address}"')
        assert len(result.stderr.splitlines()) == 1


class workers_at:
    """A scheduler with a worker, with those options."""

    def __init__(self, place, options):
        self.place, self.options, self.running = make(place), options, []

    def start(self, name, *arguments):
        self.running.append(subprocess.Popen(
            [ROOT / ".venv/bin/python", "-m", f"distributed.cli.dask_{name}",
             *map(str, arguments), *map(str, self.options)], cwd=self.place,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))

    def __enter__(self):
        file = self.place / "scheduler.json"
        self.start("scheduler", "--protocol", "tls", "--host", "127.0.0.1",
                   "--port", "0", "--no-dashboard", "--scheduler-file", file)

        def address():
            try:
                return json.loads(file.read_text("utf-8"))["address"]
            except (OSError, ValueError):
                return None

        found = until(address, "a scheduler")
        self.start("worker", found, "--nthreads", "1", "--no-nanny",
                   "--no-dashboard", "--local-directory", ".")
        return found

    def __exit__(self, *_):
        for process in self.running:
            process.kill()
            process.wait(TIME_LIMIT_S)


@pytest.mark.parametrize("options, said", [
    (("--scheduler", "tcp://127.0.0.1:1"),
     "--scheduler: give --certificates FOLDER, or --insecure: without"
     " certificates any program that can reach the scheduler can run code"
     " here"),
    (("--scheduler", "tcp://127.0.0.1:1", "--certificates", "own"),
     '--scheduler "tcp://127.0.0.1:1": with certificates it is'
     " tls://HOST:PORT"),
    (("--scheduler", "tls://127.0.0.1:1", "--certificates", "nowhere"),
     '--certificates "nowhere/ca.pem": No such file or directory; there must'
     " be ca.pem, cert.pem, key.pem"),
    (("--scheduler", "tls://127.0.0.1:1", "--certificates", "open"),
     '--certificates "open/key.pem": others may read or change it: chmod 600'
     " makes it yours alone"),
    (("--scheduler", "tls://127.0.0.1:1", "--certificates", "mixed"),
     '--certificates "mixed": '),
    (("--scheduler", "tls://127.0.0.1:1", "--certificates", "own",
      "--insecure"), "either --certificates or --insecure, and not both"),
    (("--insecure",),
     "--certificates and --insecure go together with --scheduler")])
def test_sec12_without_certificates_only_what_is_asked_for(
        tmp_path, urv, options, said):
    own, other = folder(tmp_path / "own"), folder(tmp_path / "mixed")
    (folder(tmp_path / "open") / "key.pem").chmod(0o644)
    (other / "cert.pem").write_bytes((own / "cert.pem").read_bytes())
    result = urv("monte-carlo", "--flights", 1, *options)
    assert result.returncode == 2, result.stderr
    assert said in result.stderr.splitlines()[-1]


def test_sec12_insecure_is_reported(urv):
    result = urv("monte-carlo", "--flights", 1, "--scheduler",
                 "tcp://127.0.0.1:1", "--insecure")
    assert result.returncode == 1
    assert "can run code here" in result.stderr.splitlines()[0]


def test_sec12_without_openssl_a_line_says_so(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(faults.Failed, match="openssl is missing"):
        certificates.temporary(tmp_path)
