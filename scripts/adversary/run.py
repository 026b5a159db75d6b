#!/usr/bin/env python3
"""Random derivation documents against oracles that share nothing with the program.

    python3 scripts/adversary/run.py --kane target/release/kane --found
    python3 scripts/adversary/run.py --kane target/release/kane --claims 10000
    python3 scripts/adversary/run.py --kane target/release/kane --claims 1000000 --jobs 2 --certificates --state long.json

Ends with 0 if no verdict was wrong and the program never failed, else with 1. With `--state` the run
can be stopped and goes on where it was.
"""

import argparse
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import chains  # noqa: E402
import limits  # noqa: E402
import scalar  # noqa: E402
import slopes  # noqa: E402
import solver  # noqa: E402
from opinion import second_opinion  # noqa: E402
from oracle import Judge  # noqa: E402

FAMILIES = {
    "identities": scalar.identities,
    "inequalities": scalar.inequalities,
    "piecewise": scalar.piecewise,
    "roots": scalar.roots,
    "contradictions": scalar.contradictions,
    "traps": scalar.traps,
    "slopes": slopes.slopes,
    "limits": limits.limits,
    "premised": chains.premised,
    "chains": chains.chains,
}
# What a round consists of. The program takes much longer for functions and limits than for points, so
# the gate has fewer of them, and the long run more.
MIXES = {
    "gate": ["identities"] * 10 + ["inequalities"] * 8 + ["piecewise"] * 10 + ["roots"] + ["contradictions"] * 10
    + ["traps"] * 10 + ["slopes"] * 8 + ["limits"] * 2 + ["premised"] + ["chains"] * 3,
    "long": ["identities"] * 3 + ["inequalities"] * 3 + ["piecewise"] * 4 + ["roots"] + ["contradictions"] * 4
    + ["traps"] * 5 + ["slopes"] * 6 + ["limits"] * 2 + ["premised"] * 2 + ["chains"] * 4,
    "points": ["identities"] * 4 + ["inequalities"] * 3 + ["piecewise"] * 4 + ["contradictions"] * 4 + ["traps"] * 4
    + ["slopes"] * 3 + ["roots"],
    "far": ["limits"] * 3 + ["premised"] * 2 + ["chains"] * 4 + ["slopes"] * 2,
}  # fmt: skip
MIXES |= {name: [name] for name in FAMILIES}
BATCH = 30  # documents a call of the program
SLOW = 10.0  # seconds that no document may take


def generate(seed, index, mix):
    """The document of this number, its source of chance, and its text."""
    round_ = MIXES[mix]
    # the order in a round is mixed, so that a short run has something of everything
    family = round_[index * 37 % len(round_)]
    rng = random.Random(f"{seed}/{family}/{index}")
    document = FAMILIES[family](rng)
    return document, rng, document.text(f"{family} {seed}/{index}")


def used():
    """Processor time of all programs that were started and have ended."""
    times = os.times()
    return times.children_user + times.children_system


def run_kane(kane, files, out=None):
    """(exit code, parsed report or None, messages, seconds of processor time)"""
    before = used()
    command = [*kane, *files, "--format", "json"] + (["--certificates", out] if out else [])
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=3600)
    except subprocess.TimeoutExpired:
        return "timeout", None, "", used() - before
    seconds = used() - before
    try:
        report = json.loads(done.stdout)["documents"] if done.returncode in (0, 1) else None
    except (ValueError, KeyError):
        report = None
    return done.returncode, report, done.stderr, seconds


class Tally:
    """What a batch found, in a form that can be added and kept in a file."""

    def __init__(self):
        self.claims = 0
        self.documents = 0
        self.verdicts = Counter()  # "family verdict"
        self.notes = Counter()  # "kind" of what was not judged
        self.wrong = []  # [kind, family, seed, index, label, message]
        self.failures = []  # [what, family, seed, index]
        self.slow = []  # [seconds, family, seed, index]
        self.seconds = Counter()

    def add(self, other):
        self.claims += other.claims
        self.documents += other.documents
        for name in ("verdicts", "notes", "seconds"):
            getattr(self, name).update(getattr(other, name))
        self.wrong += other.wrong
        self.failures += other.failures
        self.slow += other.slow

    def as_json(self):
        return dict(self.__dict__, **{n: dict(getattr(self, n)) for n in ("verdicts", "notes", "seconds")})

    @classmethod
    def from_json(cls, kept):
        out = cls()
        out.__dict__.update(kept)
        for n in ("verdicts", "notes", "seconds"):
            setattr(out, n, Counter(kept[n]))
        return out


def judge_batch(job):
    """Generates, runs and judges the documents of one batch."""
    kane, seed, indices, mix, ask_every, effort, certificates = job
    tally = Tally()
    began = time.process_time()
    made = [(i, *generate(seed, i, mix)) for i in indices]
    tally.seconds["generating"] += time.process_time() - began
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for i, _, _, text in made:
            path = os.path.join(folder, f"{i}.md")
            Path(path).write_text(text, encoding="utf-8")
            files.append(path)
        out = os.path.join(folder, "out") if certificates else None
        code, reports, messages, seconds = run_kane(kane, files, out)
        if code not in (0, 1) or reports is None:
            reports = one_by_one(kane, files, made, tally, seed, out)
        else:
            tally.seconds["kane"] += seconds
            if seconds > SLOW:
                tally.slow.append([round(seconds), "a batch", seed, indices[0]])
        if certificates:
            began = time.process_time()
            second_opinions(tally, seed, made, reports, out)
            tally.seconds["second checker"] += time.process_time() - began
    questions = []
    for (i, document, rng, text), report in zip(made, reports):
        if report is None:
            continue
        judge_document(tally, seed, i, document, rng, report, effort)
        if ask_every and document.family not in ("slopes", "limits"):
            questions += to_solver(document, report, rng, ask_every, i)
    if questions:
        began = time.monotonic()
        for (i, family, label, verdict, _), answer in zip(questions, solver.ask([q[4] for q in questions])):
            tally.notes[f"z3 {answer if answer in ('sat', 'unsat', 'unknown') else 'error'}"] += 1
            if answer == "sat":
                tally.wrong.append(["z3", family, seed, i, label, f"{verdict}, and the solver has a counterexample"])
        tally.seconds["solver"] += time.monotonic() - began
    return indices[-1], tally


def second_opinions(tally, seed, made, reports, out):
    """Puts the certificates to the checker that shares nothing with the kernel, nor with this folder."""
    for (i, document, _, text), report in zip(made, reports):
        if report is None:
            continue
        shown = [s["verdict"] for s in report["statements"] if s["kind"] == "claim"]
        refused, accepted = second_opinion(text, Path(out, f"{i}.cert.json"), shown)
        tally.notes["links that the second checker accepts"] += accepted
        for line in refused:
            words = line.split()
            tally.wrong.append(["second checker", document.family, seed, i, words[1].rstrip(":"), line[5:]])


def one_by_one(kane, files, made, tally, seed, written):
    """After something went wrong with a batch: which document it was."""
    out = []
    for path, (i, document, _, _) in zip(files, made):
        code, report, messages, seconds = run_kane(kane, [path], written)
        tally.seconds["kane"] += seconds
        if seconds > SLOW:
            # what a build without optimisation takes is no fault of the program, so this is only told
            tally.slow.append([round(seconds), document.family, seed, i])
        if code == 2:
            tally.notes["rejected: " + messages.split("\n")[0][:60]] += 1
        elif code not in (0, 1) or report is None:
            tally.failures.append([f"exit {code}: {messages[:200]}", document.family, seed, i])
        out.append(report[0] if report else None)
    return out


def judge_document(tally, seed, i, document, rng, report, effort):
    began = time.process_time()
    tally.documents += 1
    judge = Judge(document, rng, effort)
    found = judge.judge(report)
    for s in report["statements"]:
        if s["kind"] == "claim":
            tally.claims += 1
            tally.verdicts[f"{document.family} {s['verdict']}"] += 1
    tally.notes["witnesses and structures checked"] += judge.judged
    tally.notes["lines of witnesses held against values"] += judge.lines
    for f in found:
        if f.grave:
            tally.wrong.append([f.kind, document.family, seed, i, f.label, f.message])
        else:
            tally.notes[f.kind] += 1
    tally.seconds[f"judging {document.family}"] += time.process_time() - began


def to_solver(document, report, rng, every, i):
    """A sample of the proved and vacuous links as questions."""
    shown = {s["label"]: s for s in report["statements"]}
    out = []
    for claim in document.claims():
        for k, link in enumerate(shown[claim.label]["links"]):
            if rng.random() * every < 1:
                q = solver.question(document, claim, k, link["verdict"])
                if q:
                    out.append((i, document.family, claim.label, link["verdict"], q))
    return out


def small_document(document, label, text):
    """The lines of a document on which one claim depends, for a report of what is wrong."""
    keep, todo = set(), [label]
    while todo:
        n = todo.pop()
        if n not in keep:
            keep.add(n)
            s = document.find(n)
            todo += s.cites + ([s.about] if s.about else [])
    lines = []
    for line in text.split("\n"):
        words = line.split(" ")
        if words[0] in ("given", "claim") and words[1].rstrip(":") not in keep:
            continue
        lines.append(line)
    return "\n".join(lines)


def keep_wrong(folder, wrong, mix):
    """Writes each wrong document, whole and cut down to what the claim depends on."""
    os.makedirs(folder, exist_ok=True)
    for kind, family, seed, i, label, message in wrong:
        document, _, text = generate(seed, i, mix)
        name = f"{family}-{seed}-{i}-{label}"
        Path(folder, name + ".md").write_text(text, encoding="utf-8")
        known = any(claim.label == label for claim in document.claims())
        small = small_document(document, label, text) if known else text
        Path(folder, name + "-small.md").write_text(f"<!-- {kind}: {message} -->\n\n" + small, encoding="utf-8")


def blind(tally):
    """Whether what is not read of witnesses is more than what is rare."""
    unread = tally.notes["unreadable witness"] + tally.notes["no witness in words"]
    return 100 * unread > tally.notes["witnesses and structures checked"] + 100


def summary(tally, out=sys.stdout):
    families = sorted({k.split(" ", 1)[0] for k in tally.verdicts})
    verdicts = ["proved", "refuted", "ill-defined", "vacuous", "undecided", "unsupported"]
    print(f"{tally.claims} claims in {tally.documents} documents", file=out)
    print(f"{'':15}" + "".join(f"{v:>12}" for v in verdicts), file=out)
    for f in families:
        print(f"{f:15}" + "".join(f"{tally.verdicts[f'{f} {v}']:12}" for v in verdicts), file=out)
    for note, n in sorted(tally.notes.items()):
        print(f"  {note}: {n}", file=out)
    print("  seconds: " + ", ".join(f"{k} {v:.1f}" for k, v in sorted(tally.seconds.items())), file=out)
    kinds = Counter((w[0], w[1]) for w in tally.wrong)
    if blind(tally):
        print("the oracle is blind: more than one witness in a hundred was not read", file=out)
    print(f"wrong: {len(tally.wrong)}", file=out)
    for (kind, family), n in kinds.most_common():
        first = next(w for w in tally.wrong if w[0] == kind and w[1] == family)
        print(f"  {n:5} {family}: {kind}, first {first[2]}/{first[3]} {first[4]}: {first[5][:300]}", file=out)
    print(f"calls that took more than {SLOW:.0f} s: {len(tally.slow)}", file=out)
    for f in tally.slow[:20]:
        print("  " + " ".join(map(str, f)), file=out)
    print(f"failures of the program: {len(tally.failures)}", file=out)
    for f in tally.failures[:20]:
        print("  " + " ".join(map(str, f)), file=out)


def jobs_of(args, done):
    """Batches from where the run was, without end; about 20 claims a document."""
    index = done
    while True:
        yield (args.kane, args.seed, list(range(index, index + BATCH)), args.mix, args.ask_every, args.effort, args.certificates)
        index += BATCH


def found(kane):
    """Documents of which a wrong verdict was found: each says in its first line what must not come back."""
    bad = 0
    for path in sorted(Path(__file__).resolve().parent.glob("found/*.md")):
        first = path.read_text(encoding="utf-8").split("\n")[0]
        forbidden = [part.split() for part in first.removeprefix("<!-- not:").removesuffix("-->").split(",")]
        code, report, messages, _ = run_kane(kane, [str(path)])
        if report is None:
            print(f"{path.name}: exit {code}: {messages}")
            bad += 1
            continue
        verdicts = {s["label"]: s["verdict"] for s in report[0]["statements"]}
        for label, verdict in forbidden:
            if verdicts[label] == verdict:
                print(f"{path.name}: {label} is {verdict}")
                bad += 1
    print(f"wrong verdicts of old that came back: {bad}")
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kane", required=True, help="the program")
    parser.add_argument("--claims", type=int, default=10000)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--mix", choices=sorted(MIXES), default="gate", help="which families, or only one")
    parser.add_argument("--ask-every", type=int, default=10, help="put one of so many links to z3; 0 for none")
    parser.add_argument("--certificates", action="store_true", help="put each certificate to scripts/check_cert.py too")
    parser.add_argument("--budget", type=int, help="coefficient operations of a search; else what the program takes")
    parser.add_argument("--effort", type=int, default=1, help="how many points are tried")
    parser.add_argument("--state", help="a file in which a long run keeps where it is")
    parser.add_argument("--keep", help="a folder for documents with wrong verdicts")
    parser.add_argument("--found", action="store_true", help="only the documents in which a verdict was wrong once")
    parser.add_argument("--show", type=int, help="print the document of this number and stop")
    args = parser.parse_args()
    if args.show is not None:
        print(generate(args.seed, args.show, args.mix)[2])
        return 0
    if args.found:
        return found([args.kane, "audit"])
    args.kane = [args.kane, "audit"] + (["--budget", str(args.budget)] if args.budget else [])
    if args.ask_every and not solver.available():
        print("skipped: z3 is not installed, so nothing is put to it")
        args.ask_every = 0
    tally, done = Tally(), 0
    if args.state and os.path.exists(args.state):
        kept = json.loads(Path(args.state).read_text())
        if kept["seed"] != args.seed or kept["mix"] != args.mix:
            sys.exit(f"{args.state} is of another run")
        tally, done = Tally.from_json(kept["tally"]), kept["done"]
    began, before = time.monotonic(), tally.claims
    jobs = jobs_of(args, done)

    def finished(tallied, last):
        tally.add(tallied)
        if args.keep and tallied.wrong:
            keep_wrong(args.keep, tallied.wrong, args.mix)
        if args.state:
            text = json.dumps({"seed": args.seed, "mix": args.mix, "done": last + 1, "tally": tally.as_json()})
            Path(args.state + ".new").write_text(text)
            os.replace(args.state + ".new", args.state)
            speed = (tally.claims - before) / (time.monotonic() - began)
            print(f"{tally.claims} claims, {speed:.0f} a second, {len(tally.wrong)} wrong, {len(tally.failures)} failures", flush=True)

    if args.jobs == 1:
        while tally.claims < args.claims:
            last, tallied = judge_batch(next(jobs))
            finished(tallied, last)
    else:
        with ProcessPoolExecutor(args.jobs) as pool:
            while tally.claims < args.claims:
                for last, tallied in pool.map(judge_batch, [next(jobs) for _ in range(8 * args.jobs)]):
                    finished(tallied, last)
    summary(tally)
    print(f"{time.monotonic() - began:.0f} s")
    return 1 if tally.wrong or tally.failures or blind(tally) else 0


if __name__ == "__main__":
    sys.exit(main())
