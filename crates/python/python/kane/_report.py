"""What every report offers."""

from __future__ import annotations


class Report:
    """A report of the program: the same in JSON, and as a page."""

    _json: str
    _html: str

    def json(self) -> str:
        """The report as the program prints it with `--format json`."""
        return self._json

    def html(self) -> str:
        """The report as a page of its own."""
        return self._html
