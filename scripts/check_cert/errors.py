"""What can go wrong: with the document, and with the evidence."""


class Unreadable(Exception):
    """The document or the certificate cannot be read, so nothing is judged."""


class Rejected(Exception):
    """A piece of evidence does not show what it should."""


def demand(condition, reason):
    """Rejects evidence that does not meet a condition."""
    if not condition:
        raise Rejected(reason)
