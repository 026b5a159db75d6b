"""One document at a time, put to the program and its certificate to the second checker."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

CHECKER = Path(__file__).resolve().parents[1] / "check_cert.py"


class Trial:
    """What the command line `SCRIPT KANE [COUNT [SEED]] [--certificates]` asks for, and what comes of it."""

    def __init__(self, seed):
        arguments = [a for a in sys.argv[1:] if not a.startswith("--")]
        self.kane, count, self.seed = arguments + ["1000", seed][len(arguments) - 1:]
        self.count = int(count)
        self.certificates = "--certificates" in sys.argv
        self.tally, self.wrong, self.rejected, self.judged = {}, [], 0, 0
        self.folder = tempfile.TemporaryDirectory()

    def statements(self, source, budget):
        """The statements of the report on a document; where there is none, the messages."""
        path = Path(self.folder.name) / "d.md"
        path.write_text(source)
        out = self.folder.name + "/out"
        run = subprocess.run(
            [self.kane, "audit", str(path), "--format", "json", "--budget", str(budget), "--out", out],
            capture_output=True, text=True, check=False,
        )
        if run.returncode not in (0, 1):
            return None, run.stderr
        if self.certificates:
            check = subprocess.run(
                [sys.executable, str(CHECKER), "--quiet", str(path), out + "/d.cert.json"],
                capture_output=True, text=True, check=False,
            )
            if check.returncode:
                self.rejected += 1
                self.wrong.append((source, check.stdout + check.stderr))
        return json.loads(run.stdout)["documents"][0]["statements"], ""

    def count_one(self, name):
        self.tally[name] = self.tally.get(name, 0) + 1

    def told(self, beside=""):
        """Prints what was found; the exit code."""
        for name, n in sorted(self.tally.items()):
            print(f"{name}: {n}")
        print(f"{self.judged} claims, {len(self.wrong)} wrong, {self.rejected} certificates rejected{beside}")
        for source, why in self.wrong[:5]:
            print(source, why)
        return 1 if self.wrong else 0
