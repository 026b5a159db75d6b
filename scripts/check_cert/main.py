"""The command: a document, a certificate, and the answer for each link."""

import hashlib
import json
import sys
import threading
from pathlib import Path

from .document import Document
from .errors import Rejected, Unreadable
from .evidence import keys, listed, text, unique_keys
from .verdict import check_claim

USAGE = "usage: check_cert.py [--quiet] DOCUMENT CERTIFICATE"


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


def run(arguments):
    """Runs the command; the exit code."""
    quiet = "--quiet" in arguments
    paths = [Path(argument) for argument in arguments if argument != "--quiet"]
    if len(paths) != 2:
        print(USAGE, file=sys.stderr)
        return 2

    def report(line):
        if not quiet or line.startswith("NO"):
            print("".join(c if c.isprintable() else "\ufffd" for c in line))

    try:
        source = paths[0].read_bytes()
        certificate = json.loads(paths[1].read_bytes(), object_pairs_hook=unique_keys)
        faults = check_text(source, certificate, report)
    except (Unreadable, Rejected, OSError, ValueError, RecursionError) as reason:
        report(f"NO   unreadable: {reason}")
        return 2
    report(f"NO   {faults} claims rejected" if faults else "yes  all accepted")
    return 1 if faults else 0


def main():
    """Proofs are deep trees, so they are walked with a large stack."""
    sys.set_int_max_str_digits(0)
    sys.setrecursionlimit(100_000)
    threading.stack_size(512 << 20)
    code = []
    worker = threading.Thread(target=lambda: code.append(run(sys.argv[1:])))
    worker.start()
    worker.join()
    sys.exit(code[0] if code else 2)
