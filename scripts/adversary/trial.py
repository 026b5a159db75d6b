"""One document at a time, put to the program and its certificate to the second checker."""

import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

from opinion import second_opinion

#: of so many documents one is written in every form
PRINTED = 20

LONGEST = 60  # seconds that a scene may take


class Trial:
    """What the command line `SCRIPT KANE [COUNT [SEED]] [--certificates] [--keep DIR]` asks for, and what comes of it."""

    def __init__(self, seed):
        self.keep = None
        if "--keep" in sys.argv:
            at = sys.argv.index("--keep")
            self.keep = Path(sys.argv[at + 1])
            del sys.argv[at : at + 2]
        arguments = [a for a in sys.argv[1:] if not a.startswith("--")]
        self.kane, count, self.seed = arguments + ["1000", seed][len(arguments) - 1:]
        self.count = int(count)
        self.certificates = "--certificates" in sys.argv
        self.tally, self.wrong, self.rejected, self.judged, self.audited = {}, [], 0, 0, 0
        self.seconds = 0  # of processor time, that the last document took
        self.folder = tempfile.TemporaryDirectory()

    def statements(self, source, budget):
        """The statements of the report on a document; where there is none, the messages."""
        path = Path(self.folder.name) / "d.md"
        path.write_text(source)
        written = ["--certificates" if self.audited % PRINTED else "--out", self.folder.name + "/out"]
        self.audited += 1
        before = os.times()
        run = subprocess.run(
            [self.kane, "audit", str(path), "--format", "json", "--budget", str(budget), *written],
            capture_output=True, text=True, check=False,
        )
        after = os.times()
        self.seconds = after.children_user + after.children_system - before.children_user - before.children_system
        if run.returncode not in (0, 1):
            return None, run.stderr
        statements = json.loads(run.stdout)["documents"][0]["statements"]
        if self.certificates:
            shown = [s["verdict"] for s in statements if s["kind"] == "claim"]
            refused, _ = second_opinion(source, Path(self.folder.name, "out/d.cert.json"), shown)
            if refused:
                self.rejected += 1
                self.note(source, "\n".join(refused))
        return statements, ""

    def documents(self, make, rng, budget):
        """Documents that `make` writes, with what is known of their claims and the statements of their reports, until as
        many claims are judged as are asked for. One that is not read is a wrong answer, and the last.
        """
        while self.judged < self.count:
            source, known = make(rng)
            statements, messages = self.statements(source, budget)
            if statements is None:
                self.note(source, messages)
                return
            yield source, known, statements

    def scene(self, source):
        """The report on a scene with all of its models; where there is none, the exit code and the messages."""
        path = Path(self.folder.name) / "s.toml"
        path.write_text(source)
        command = [self.kane, "scene", str(path), "--format", "json", "--compare"]
        try:
            run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=LONGEST)
        except subprocess.TimeoutExpired:
            return None, "none", f"no answer in {LONGEST} s"
        return (json.loads(run.stdout) if run.returncode in (0, 1) and run.stdout else None), run.returncode, run.stderr

    def formulas(self, make, batch, *options):
        """Formulas that `make` writes, put to `kane stability` some at a time; a batch is a list of (formula, report,
        source of chance).

        A formula is a tuple that begins with its text; `--out` goes to the folder. A batch that fails is a wrong answer.
        """
        path = Path(self.folder.name) / "f.fpcore"
        for begin in range(0, self.count, batch):
            numbers = range(begin, min(begin + batch, self.count))
            made = [make(random.Random(f"{self.seed}/{i}"), i) for i in numbers]
            path.write_text("\n".join(text for text, *_ in made) + "\n")
            run = subprocess.run(
                [self.kane, "stability", str(path), "--format", "json", *options],
                capture_output=True, text=True, check=False,
            )
            if run.returncode:
                self.wrong.append((path.read_text(), f"exit {run.returncode}: {run.stderr}"))
                continue
            rngs = [random.Random(f"{self.seed}/{i}/points") for i in numbers]
            yield list(zip(made, json.loads(run.stdout)["formulas"], rngs, strict=True))
            done = numbers.stop
            if done % 500 == 0:
                print(f"{done} formulas, {self.judged} judged, {len(self.wrong)} wrong", file=sys.stderr, flush=True)

    def note(self, source, why):
        """A wrong answer, and its document, which is kept where that is asked for."""
        self.wrong.append((source, why))
        if self.keep:
            self.keep.mkdir(parents=True, exist_ok=True)
            (self.keep / f"{self.seed}-{len(self.wrong)}.md").write_text(f"<!-- {why} -->\n\n{source}")

    def count_one(self, name):
        self.tally[name] = self.tally.get(name, 0) + 1

    def told(self, beside="", what="claims"):
        """Prints what was found; the exit code."""
        for name, n in sorted(self.tally.items()):
            print(f"{name}: {n}")
        print(f"{self.judged} {what}, {len(self.wrong)} wrong, {self.rejected} certificates rejected{beside}")
        for source, why in self.wrong[:5]:
            print(source, why)
        return 1 if self.wrong else 0
