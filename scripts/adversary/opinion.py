"""What the second checker says of a certificate. It shares nothing with the kernel, nor with this folder."""

import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))

from check_cert.evidence import unique_keys  # noqa: E402
from check_cert.main import check_text, on_a_large_stack  # noqa: E402


def second_opinion(source, certificate, shown):
    """What the second checker refuses of a certificate (a path) of a document (its text) whose report has shown these
    verdicts, and how many links it accepts.
    """
    said = []

    def check():
        try:
            parsed = json.loads(certificate.read_bytes(), object_pairs_hook=unique_keys)
            faults = check_text(source.encode("utf-8"), parsed, said.append)
            if faults:
                said.append(f"NO   document: {faults} claims rejected")
            if [c["verdict"] for c in parsed["claims"]] != shown:
                said.append("NO   the certificate has other verdicts than the report")
        except Exception as why:
            said.append(f"NO   document: {why!r}")
        return True

    if not on_a_large_stack(check):
        said.append("NO   document: the checker ended without an answer")
    return [line for line in said if line.startswith("NO")], sum(" link " in line and line.startswith("yes") for line in said)
