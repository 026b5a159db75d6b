"""The command: documents, their certificates, and the answer for each link."""

import hashlib
import json
import os
import sys
import threading
from pathlib import Path

from .document import Document
from .errors import Rejected, Unreadable
from .evidence import keys, listed, text, unique_keys
from .verdict import check_claim

USAGE = "usage: check_cert.py [--quiet] DOCUMENT CERTIFICATE [DOCUMENT CERTIFICATE]…"


def check_text(source, certificate, report):
    """Checks a certificate (parsed JSON) of a document (bytes); the number of faults."""
    try:
        document = Document(source.decode("utf-8"))
    except UnicodeDecodeError:
        raise Unreadable("the document is not UTF-8") from None
    try:
        kind, program, name, digest, claims = keys(
            certificate, "format", "program", "document", "sha256", "claims"
        )
        if type(kind) is not int or kind != 1:
            raise Unreadable("the certificate has another format")
        text(program), text(name), listed(claims)
    except Rejected as reason:
        raise Unreadable(f"the certificate: {reason}") from None
    if digest != hashlib.sha256(source).hexdigest():
        raise Unreadable("the certificate is one of another text")
    if len(claims) != len(document.claims):
        raise Unreadable("the certificate has not one entry for each claim")
    faults, verdicts = 0, {}
    for claim, entry in zip(document.claims, claims):
        try:
            verdicts[claim.label], good = check_claim(document, claim, entry, verdicts, report)
        except Rejected as reason:
            verdicts[claim.label], good = "undecided", False
            report(f"NO   {claim.label}: {reason}")
        faults += not good
    return faults


def check_pair(document, certificate, report):
    """Checks one pair of files; the exit code."""
    try:
        source = document.read_bytes()
        parsed = json.loads(certificate.read_bytes(), object_pairs_hook=unique_keys)
        faults = check_text(source, parsed, report)
    except (Unreadable, Rejected, OSError, ValueError, RecursionError) as reason:
        report(f"NO   unreadable: {reason}")
        return 2
    report(f"NO   {faults} claims rejected" if faults else "yes  all accepted")
    return 1 if faults else 0


def run(arguments):
    """Runs the command; the exit code, the greatest of those of its pairs."""
    quiet = "--quiet" in arguments
    paths = [Path(argument) for argument in arguments if argument != "--quiet"]
    if not paths or len(paths) % 2:
        print(USAGE, file=sys.stderr)
        return 2

    def show(line):
        print("".join(c if c.isprintable() else "\ufffd" for c in line))

    def report(line):
        if not quiet or line.startswith("NO"):
            show(line)

    code = 0
    for document, certificate in zip(paths[::2], paths[1::2]):
        if len(paths) > 2:
            show(f"{document}:")
        code = max(code, check_pair(document, certificate, report))
    return code


def on_a_large_stack(work):
    """What `work` returns, or None if it fails: proofs are deep trees, and are walked as such."""
    sys.set_int_max_str_digits(0)
    sys.setrecursionlimit(100_000)
    threading.stack_size(512 << 20)
    returned = []
    worker = threading.Thread(target=lambda: returned.append(work()))
    worker.start()
    worker.join()
    return returned[0] if returned else None


def main():
    """The command with the arguments of the command line."""

    def work():
        try:
            return run(sys.argv[1:])
        except BrokenPipeError:  # nobody reads on
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())

    code = on_a_large_stack(work)
    sys.exit(2 if code is None else code)
