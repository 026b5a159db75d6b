"""What the tests share."""

import json
from pathlib import Path

from check_cert.document import Document
from check_cert.main import check_text


ROOT = Path(__file__).resolve().parents[3]


def document(*lines):
    """A document of one block."""
    return "```kane\n" + "\n".join(lines) + "\n```\n"


def answer(text, certificate):
    """The number of faults, and the lines that say why."""
    lines = []
    source = text.encode()
    faults = check_text(source, json.loads(json.dumps(certificate)), lines.append)
    return faults, [line for line in lines if line.startswith("NO")]


def verdicts(certificate):
    return {claim["label"]: claim["verdict"] for claim in certificate["claims"]}


def expected(text):
    """The verdict that a document expects of each claim."""
    return {claim.label: claim.expect or "proved" for claim in Document(text).claims}
