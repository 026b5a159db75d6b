"""`kane.testing`: what fails says why, and nothing that is not checked passes."""

from pathlib import Path

import kane.testing
import pytest

EXAMPLE = Path(__file__).parents[3] / "docs/examples/as-a-test"


def test_the_example_holds():
    kane.testing.document(EXAMPLE / "derivation.md")
    kane.testing.scene(EXAMPLE / "bounce.toml")
    kane.testing.log(EXAMPLE / "impacts.csv")


def test_what_fails_says_why():
    with pytest.raises(AssertionError, match=r"broken.md:\d+: sign is refuted: false under all that was assumed, at "):
        kane.testing.document(EXAMPLE / "broken.md")
    with pytest.raises(AssertionError, match="no claim"):
        kane.testing.document(EXAMPLE / "empty.md")
    with pytest.raises(OSError):
        kane.testing.document(EXAMPLE / "none.md")
