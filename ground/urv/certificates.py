# SPDX-License-Identifier: Apache-2.0
"""Certificates of Dask's scheduler, workers and clients (SEC-12).

Any peer of Dask's scheduler, workers or clients can have them run any code.
They therefore use TLS, and each presents a certificate.
"""

import stat
import subprocess
from pathlib import Path

from urv import faults, programs

FILES = ("ca.pem", "cert.pem", "key.pem")
"""The files of a folder: the accepted certificates, the own one, and its
key."""
DAYS = 30
"""Longer than any campaign takes."""
SECURE = "tls://"


def security(authority, certificate, key):
    """Dask's settings: TLS only, with that certificate on each side."""
    from distributed.security import Security

    own = {f"tls_{role}_{what}": str(path)
           for role in ("client", "scheduler", "worker")
           for what, path in (("cert", certificate), ("key", key))}
    return Security(require_encryption=True, tls_ca_file=str(authority), **own)


def temporary(folder):
    """A new certificate, the only accepted one: its key is the secret that the
    processes of one command share. The folder must be the user's alone."""
    openssl = programs.found("openssl")
    if openssl is None:
        raise faults.Failed("the program openssl is missing: scripts/setup.sh"
                            " monte_carlo installs it")
    certificate, key = folder / "cert.pem", folder / "key.pem"
    made = subprocess.run(
        [openssl, "req", "-x509", "-newkey", "ec", "-pkeyopt",
         "ec_paramgen_curve:prime256v1", "-nodes", "-days", str(DAYS),
         "-subj", "/CN=urv workers", "-keyout", key, "-out", certificate],
        stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    if made.returncode:
        raise faults.Failed("openssl makes no certificate: "
                            + " ".join(made.stderr.split())[-200:])
    return security(certificate, certificate, key)


def of(scheduler, folder, insecure):
    """The settings for a scheduler's address, with the certificates of the
    folder; None for workers here, and for an insecure scheduler.

    Raises faults.Refused when an insecure scheduler was not requested, or the
    options contradict each other.
    """
    if scheduler is None:
        if folder is not None or insecure:
            raise faults.Refused("--certificates and --insecure go together"
                                 " with --scheduler")
        return None
    if insecure:
        if folder is not None:
            raise faults.Refused("either --certificates or --insecure, and"
                                 " not both")
        faults.note(f"no program at {faults.quoted(scheduler)} presents a"
                    " certificate: any program that can reach this scheduler"
                    " can run code here")
        return None
    if folder is None:
        raise faults.Refused(
            "--scheduler: give --certificates FOLDER, or --insecure: without"
            " certificates any program that can reach the scheduler can run"
            " code here")
    if not scheduler.startswith(SECURE):
        raise faults.Refused(f"--scheduler {faults.quoted(scheduler)}: with"
                             " certificates it is tls://HOST:PORT")
    return of_folder(Path(folder))


def of_folder(folder):
    """The settings with these certificates."""
    import ssl

    paths = [folder / name for name in FILES]
    for path in paths:
        try:
            mode = path.stat().st_mode
        except OSError as fault:
            raise faults.Refused(
                f"--certificates {faults.quoted(path)}:"
                f" {faults.reason(fault)}; there must be"
                f" {', '.join(FILES)}") from fault
        if not stat.S_ISREG(mode):
            raise faults.Refused(
                f"--certificates {faults.quoted(path)}: is not a file")
    if mode & 0o077:
        raise faults.Refused(f"--certificates {faults.quoted(path)}: others"
                             " may read or change it: chmod 600 makes it"
                             " yours alone")
    try:
        context = ssl.create_default_context(cafile=paths[0])
        # A key with a password would ask for it at the terminal.
        context.load_cert_chain(*paths[1:], password="")
    except (OSError, ValueError) as fault:
        raise faults.Refused(
            f"--certificates {faults.quoted(folder)}: {fault}") from fault
    return security(*paths)
