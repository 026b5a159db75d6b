"""A copy of the workspace in which the mutants of one crate stand behind switches, built until the compiler is content.

What the compiler refuses in a mutant takes that mutant out; what it refuses in the switch around a place makes the place
take the next form of its switch, and in the end takes its mutants out. The reason is kept: `type` says that the value of
a function does not have its type; of `constant` and `switch` it is not known yet whether the mutant itself compiles.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from switch import Choices, Mutant, Source

HERE = Path(__file__).resolve().parent
#: how many forms a switch has, at most
FORMS = 3
#: lints that would end a build because of what only a mutant does
LINTS = "#![allow(warnings, arithmetic_overflow, unconditional_panic, clippy::all)] "


def listed(root: Path, package: str, files: list[str], config: bool = True) -> list[dict]:
    """What `cargo mutants` would do to a package, without what `.cargo/mutants.toml` leaves out."""
    command = ["cargo", "mutants", "--package", package, "--list", "--json", *([] if config else ["--no-config"])]
    for name in files:
        command += ["--file", name]
    return json.loads(subprocess.run(command, cwd=root, check=True, capture_output=True, text=True).stdout)


def write(path: Path, text: str) -> None:
    """Writes what is new: what has not changed is not built again."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def without_lints(manifest: str) -> str:
    return manifest.replace("[lints]\nworkspace = true\n", "")


class Copy:
    """The copied workspace."""

    def __init__(self, root: Path, where: Path, package: str, entries: list[dict]):
        self.root, self.where, self.package = root, where, package
        # of its own: programs of two checkouts of a workspace have one name
        self.environment = {**os.environ, "CARGO_TARGET_DIR": str(where / "target"), "CARGO_INCREMENTAL": "0"}
        self.mutants = {n: Mutant.read(n, e) for n, e in enumerate(entries, 1)}
        self.choices = Choices()
        by_file: dict[str, list[Mutant]] = {}
        for m in self.mutants.values():
            by_file.setdefault(m.file, []).append(m)
        tracked = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                                 cwd=root, check=True, capture_output=True, text=True).stdout
        for name in filter(None, tracked.split("\0")):
            if (root / name).is_file() and not (name in by_file and (where / name).exists()):
                target = where / name
                target.parent.mkdir(parents=True, exist_ok=True)
                old, new = target.exists() and target.read_bytes(), (root / name).read_bytes()
                if target.name == "Cargo.toml" and old == without_lints(new.decode()).encode():
                    continue
                if old != new:
                    shutil.copy2(root / name, target)
        self.sources = {f: Source((root / f).read_text(), ms) for f, ms in by_file.items()}
        self.places = {}
        for source in self.sources.values():
            self.choices.out.update((m.number, "switch") for m in source.lost)
            self.places.update((ms[0].number, ms) for ms in source.places.values())
        self.learnt = where / "learnt.json"
        self.recall()
        crate = self.crate()
        library = crate / "src" / "lib.rs"
        file = str(library.relative_to(where))
        self.library = file
        write(crate / "src" / "mutant.rs", (HERE / "mutant.rs").read_text())
        if file not in self.sources:
            self.sources[file] = Source((root / file).read_text(), [])
        manifest = crate / "Cargo.toml"
        write(manifest, without_lints(manifest.read_text()))

    def recall(self) -> None:
        """What an earlier run in this directory learnt of the mutants that are still the same."""
        if not self.learnt.exists():
            return
        numbers = {m.name: n for n, m in self.mutants.items()}
        old = json.loads(self.learnt.read_text())
        self.choices.constant |= set(old["constant"])
        self.choices.out.update((numbers[name], why) for name, why in old["out"].items() if name in numbers)
        self.choices.form.update((numbers[name], n) for name, n in old["form"].items() if name in numbers)

    def keep(self) -> None:
        names = {n: m.name for n, m in self.mutants.items()}
        self.learnt.write_text(json.dumps({
            "constant": sorted(self.choices.constant),
            "out": {names[n]: why for n, why in self.choices.out.items()},
            "form": {names[n]: form for n, form in self.choices.form.items()}}))

    def crate(self) -> Path:
        told = subprocess.run(["cargo", "metadata", "--no-deps", "--format-version=1"], cwd=self.where, check=True,
                              capture_output=True, text=True).stdout
        for package in json.loads(told)["packages"]:
            if package["name"] == self.package:
                return Path(package["manifest_path"]).parent
        raise SystemExit(f"no package {self.package}")

    def write(self) -> None:
        for name, source in self.sources.items():
            text = source.written(self.choices)
            if name == self.library:
                text = f"{LINTS}{text}\nmod mutant;\n"
            write(self.where / name, text)

    def build(self, arguments: list[str]) -> list[dict]:
        """Builds until nothing is refused; what cargo says of the last build."""
        for _ in range(60):
            self.write()
            run = subprocess.run(["cargo", *arguments, "--message-format=json"], cwd=self.where, text=True,
                                 env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            messages = [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]
            if run.returncode == 0:
                self.keep()
                return messages
            errors = [m["message"] for m in messages
                      if m["reason"] == "compiler-message" and m["message"]["level"] == "error"]
            before = len(self.choices.out), len(self.choices.constant), sum(self.choices.form.values())
            unknown = [e for e in errors if not self.learn(e)]
            after = len(self.choices.out), len(self.choices.constant), sum(self.choices.form.values())
            print(f"  {len(errors)} errors; out {after[0]}, constant {after[1]}, other forms {after[2]}", flush=True)
            if before == after:
                for e in unknown[:5]:
                    print(e["rendered"], file=sys.stderr)
                raise SystemExit(run.stderr[-2000:] if not unknown else "errors that belong to no mutant")
        raise SystemExit("no end of errors")

    def learn(self, error: dict) -> bool:
        """Takes out what an error is about; false if that is not known."""
        code = (error.get("code") or {}).get("code", "")
        if code == "E0015":
            named = re.search(r"non-const .*?`(.+?)` in", error["message"])
            if named:
                name = re.sub(r"<.*?>", "", named[1]).split("::")[-1]
                if name in self.constants() and name not in self.choices.constant:
                    self.choices.constant.add(name)
                    return True
        if code == "E0004":
            return self.uncovered(next(s for s in error["spans"] if s["is_primary"]))
        spans = sorted(error["spans"], key=lambda s: not s["is_primary"])
        for span in spans:
            if (found := self.inside(span)) is not None and found[0] == "<":
                return self.drop(found[1])
        for span in spans:
            if (found := self.inside(span)) is not None:
                return self.turn(found[1])
        for span in spans:
            # all of a function that says `impl Trait`: its outermost switch stands first
            if span["file_name"] in self.sources:
                text = (self.where / span["file_name"]).read_bytes()[span["byte_start"] : span["byte_end"]]
                if (mark := re.search(rb"/\*<(\d+)\*/", text)) is not None:
                    return self.drop(int(mark[1]))
        return False

    def constants(self) -> set[str]:
        found = set()
        for source in self.sources.values():
            found |= set(re.findall(r"\bconst fn (\w+)", source.bytes.decode()))
        return found

    def drop(self, number: int) -> bool:
        self.choices.out.setdefault(number, "type" if self.mutants[number].genre == "FnValue" else "switch")
        return True

    def turn(self, place: int) -> bool:
        form = self.choices.form.get(place, 0) + 1
        mutants = self.places[place]
        self.choices.form[place] = form
        if form >= FORMS or mutants[0].genre not in ("BinaryOperator", "UnaryOperator"):
            for m in mutants:
                self.choices.out.setdefault(m.number, "switch")
        return True

    def uncovered(self, span: dict) -> bool:
        """A match that says not all since its arms have switches: the last of them goes without."""
        text = (self.where / span["file_name"]).read_bytes().decode(errors="replace")
        begin = at = text.index("{", len((self.where / span["file_name"]).read_bytes()[: span["byte_end"]].decode()))
        depth = 0
        for at in range(begin, len(text)):
            depth += {"{": 1, "}": -1}.get(text[at], 0)
            if depth == 0:
                break
        arms = [m for place in re.findall(r"/\*\[(\d+)\*/", text[begin:at]) for m in self.places[int(place)]
                if m.genre == "MatchArm" and m.number not in self.choices.out]
        if arms:
            self.choices.out[arms[-1].number] = "switch"
        return bool(arms)

    def inside(self, span: dict) -> tuple[str, int] | None:
        """The innermost mark around a place: `<` and a mutant, or `[` and a place."""
        while span is not None and span["file_name"] not in self.sources:
            span = (span.get("expansion") or {}).get("span")
        if span is None:
            return None
        text = (self.where / span["file_name"]).read_bytes()
        open_marks: list[tuple[str, int]] = []
        for mark in re.finditer(rb"/\*(?:([<\[])(\d+)|[>\]])\*/", text[: span["byte_start"]]):
            if mark[1]:
                open_marks.append((mark[1].decode(), int(mark[2])))
            else:
                open_marks.pop()
        if not open_marks:
            return None
        return open_marks[-1]


def tests(messages: list[dict]) -> list[tuple[str, Path, Path]]:
    """The programs of tests that a build made: name, program, and directory to run it in."""
    return [(f"{m['target']['name']}", Path(m["executable"]), Path(m["manifest_path"]).parent)
            for m in messages if m["reason"] == "compiler-artifact" and m.get("executable") and m["profile"]["test"]]


def environment() -> dict[str, str]:
    return {**os.environ, "INSTA_UPDATE": "no", "INSTA_FORCE_PASS": "0"}
