#!/usr/bin/env python3
"""Hostile input, put to every verb that reads a file: nothing panics, nothing runs on, nothing differs.

usage: hostile.py KANE [COUNT [SEED]] [--only VERB] [--seconds N] [--keep DIR]

Files that are shipped are mutated, by bytes and by the words of their grammar, and files are made up from such words.
Each is put to its verb with 10 s of processor time, or N, and 500 MB to it. What must hold: the exit code is from 0 to 3,
standard error has no panic, a run that is bad input prints nothing on standard output, and every tenth input gives the
same output twice. What breaks this is printed, and kept in DIR. Nothing is asked about verdicts: see the other scripts.
"""

import os
import random
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BYTES = 500 * 1024 * 1024

#: by verb: the arguments before the file, the ending, the files that are mutated, and words of the grammar
KINDS = {
    "audit": (["audit"], ".md", "docs/derivations/*.md",
              "var let given claim from when as by expect using exists contradiction not implied d(x,t) sin(theta) "
              "cases { } sqrt( abs( ( ) [ ] , ; : := = < <= > >= != + - * / ^ ^2 ^-1 ^999 oo -> 0+ x y t theta pi "
              "n in N for n >= 0 by induction x^n x^(n+1) let s(0) := 1, s(n + 1) := s(n)+1 pow(x,n) s(64) "
              "sum( prod( sum(k^2 for k in 1..n) sum(x^k for k in 0..9) for k in 1..n .. exp(x) log(x) exp(x/2) var 0 < y < x, "
              "and or implies iff dot(a,b) cross(a,b) in R^3 R^2x2 [kg] [m/s] $\\frac{x}{y}$ $ # 1e400 0.1 10^40 `"),
    "draft": (["draft"], ".tex", "tests/drafts/*.tex",
              "\\begin{equation} \\end{equation} \\begin{align} \\end{align} & \\\\ \\frac \\sqrt { } ^ _ \\alpha \\dot "
              "\\lim_{x\\to 0} = \\le \\text{if} \\newcommand{\\a}{\\a} \\a \\tag{1} \\label{x} \\eqref{x} $ $$ \\[ \\] % "
              "\\sum_{k=1}^{n} \\prod_{k=0}^3 \\exp \\ln \\log \\begin{cases} \\end{cases} \\mathbf{v} \\left( \\right. | x t 1 \\section{ \\caption{ ```kane"),
    "scene": (["scene"], ".toml", "docs/scenes/*.toml",
              "[[sphere]] [plane] = 1e300 -1 0 nan inf \"1/0\" 1e-300 99999999999999999999 [ ] { } \" , true "
              "gravity_m_s2 mass_kg radius_m friction restitution velocity_m_s tolerance until_s"),
    "collide": (["collide"], ".toml", "docs/collisions/*.toml",
                "[sphere] [contact] = 1e300 -1 0 nan \"1/3\" \"1/0\" 12345678901234567890.12345678901234567890 [ ] , \" "
                "mass_kg radius_m friction restitution velocity_m_s spin_rad_s mobility_ratio"),
    "check": (["check"], ".csv", "crates/records/tests/data/*.csv",
              ", \" ; nan inf -1 0 1e308 1e-320 m_kg mu e normal_x \n\n \t '=cmd() 1,2,3"),
    "stability": (["stability"], ".fpcore", "docs/examples/*.fpcore",
                  "(FPCore ( ) x :pre :precision binary64 (< 0 x 1) (+ (- (* (/ (sqrt (fma (if (let ((y (let* 1e400 0 "
                  "-1 x y infinity nan \" ; #| :name \"n\" (<= ) )) "),
}


def run(command, most):
    """How a command ends: its code, what it prints, its processor seconds and its peak of memory."""

    def limits():
        resource.setrlimit(resource.RLIMIT_CPU, (most, most + 1))
        resource.setrlimit(resource.RLIMIT_AS, (4 * BYTES, 4 * BYTES))

    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        process = subprocess.Popen(command, stdout=out, stderr=err, stdin=subprocess.DEVNULL, preexec_fn=limits)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        seconds = used.ru_utime + used.ru_stime
        return process.returncode, out.read(), err.read(), seconds, used.ru_maxrss * 1024


def mutated(chance, seeds, words):
    """A shipped file with some of its bytes, words and lines changed, or a file made up from words."""
    if not seeds or chance.random() < 0.15:
        made = [chance.choice(words) for _ in range(chance.randrange(1, 60))]
        return chance.choice([" ", "\n", ""]).join(made).encode()
    text = bytearray(chance.choice(seeds))
    if len(text) > 4000 and chance.random() < 0.8:
        # a part of a long file, so that most of the time goes into many inputs
        start = chance.randrange(len(text) - 2000)
        text = text[start:start + chance.randrange(200, 2000)]
    for _ in range(chance.choice([1, 1, 2, 3, 5, 10, 30])):
        at = chance.randrange(len(text) + 1)
        end = min(len(text), at + chance.choice([0, 1, 1, 2, 5, 20, 100]))
        way = chance.randrange(7)
        if way == 0:
            text[at:end] = b""
        elif way == 1:
            text[at:end] = chance.choice(words).encode()
        elif way == 2:
            text[at:at] = chance.choice(words).encode() + b" "
        elif way == 3:
            text[at:at] = bytes(text[at:end]) * chance.choice([1, 2, 10, 200])
        elif way == 4:
            text[at:at] = bytes([chance.randrange(256)])
        elif way == 5 and end > at:
            text[at] ^= 1 << chance.randrange(8)
        else:
            other = chance.choice(seeds)
            start = chance.randrange(len(other) + 1)
            text[at:end] = other[start:start + chance.randrange(100)]
        del text[200_000:]
    return bytes(text)


NUMBER = re.compile(rb"(?<![A-Za-z_0-9.])-?[0-9]+(?:\.[0-9]+)?(?:/[0-9]+)?(?:e-?[0-9]+)?")
TOKEN = re.compile(rb"[A-Za-z_][A-Za-z_0-9']*|[0-9]+(?:\.[0-9]+)?|[-+*/^=<>]=?")


def number(chance):
    """A number that suits, or just does not."""
    digits = chance.choice([1, 1, 1, 2, 2, 5, 17, 20, 40])
    whole = str(chance.randrange(10**digits))
    way = chance.randrange(8)
    if way < 3:
        return whole[:3]
    if way < 5:
        return f"{whole[:1]}.{whole}"
    if way == 5:
        return f"-{whole[:2]}.{whole[:3]}"
    return f"{whole[:1]}e{chance.choice([-300, -20, -9, -3, 2, 9, 20, 308])}" if way == 6 else f"0.{'0' * digits}1"


def valued(chance, seeds):
    """A shipped file with other numbers, or other words of its own in their place: mostly still well formed."""
    text = chance.choice(seeds)
    places = list(NUMBER.finditer(text)) if chance.random() < 0.7 else []
    put = [number(chance).encode() for _ in range(5)]
    if not places:
        places = list(TOKEN.finditer(text))
        put = [chance.choice(places).group() for _ in range(5)] if places else []
    for place in sorted(chance.sample(places, min(len(places), len(put), chance.randrange(1, 5))), key=lambda m: -m.start()):
        text = text[:place.start()] + chance.choice(put) + text[place.end():]
    return text


def document(chance, seeds, words):
    """A derivation document whose statements are mutated, so that its block stays one."""
    if chance.random() < 0.5:
        # the declarations of a shipped document and its first statements, so that what they cite is there
        lines = re.findall(rb"^(?:var|let|given|claim)[^\n]*(?:\n[ \t]+[^\n]*)*", valued(chance, seeds), re.M)
        declared = [line for line in lines if line.startswith(b"var")]
        others = [line for line in lines if not line.startswith(b"var")]
        kept = declared + others[:chance.randrange(1, 60)]
        return b"# T\n\n```kane\n" + b"\n".join(kept) + b"\n```\n"
    text = mutated(chance, seeds, words)
    if chance.random() < 0.5:
        return text
    return b"# T\n\n```kane\nvar x, y > 0, t, theta, f(t)\n" + text.replace(b"```", b"") + b"\n```\n"


def faults(command, number, most):
    """What is wrong with how a command ends."""
    code, out, err, seconds, memory = run(command, most)
    found = []
    if code not in (0, 1, 2, 3):
        found.append(f"exit code {code} after {seconds:.1f} s")
    if b"panicked" in err or b"overflowed its stack" in err:
        found.append("a panic")
    if seconds > most - 0.5:
        found.append(f"{seconds:.1f} s")
    if memory > BYTES:
        found.append(f"{memory // 1024 // 1024} MB")
    if code == 2 and out.strip():
        found.append("bad input with a report")
    if not found and number % 10 == 0:
        if run(command, most)[:3] != (code, out, err):
            found.append("two runs differ")
    return found, code, seconds, memory


def main():
    arguments, options = sys.argv[1:], {}
    for option in ("--only", "--seconds", "--keep"):
        if option in arguments:
            at = arguments.index(option)
            options[option] = arguments[at + 1]
            del arguments[at:at + 2]
    kane, count, seed = arguments + ["1000", "hostile"][len(arguments) - 1:]
    kinds = [kind for kind in KINDS if options.get("--only", kind) == kind]
    most = int(options.get("--seconds", 10))
    keep = Path(options["--keep"]) if "--keep" in options else None
    tally, worst, broken = {}, {}, []
    done = 0
    try:
        with tempfile.TemporaryDirectory() as folder:
            for number in range(int(count)):
                kind = kinds[number % len(kinds)]
                before, ending, globs, grammar = KINDS[kind]
                chance = random.Random(f"{seed}/{number}")
                seeds = [p.read_bytes() for glob in globs.split() for p in sorted(ROOT.glob(glob))]
                words = grammar.split(" ")
                if kind == "stability":
                    # the bound of seconds is one for a formula
                    seeds = [b"(FPCore" + core for text in seeds for core in text.split(b"(FPCore")[1:]]
                if kind == "audit":
                    text = document(chance, seeds, words)
                elif chance.random() < 0.6:
                    text = valued(chance, seeds)
                else:
                    text = mutated(chance, seeds, words)
                path = Path(folder) / f"input{ending}"
                path.write_bytes(text)
                found, code, seconds, memory = faults([kane, *before, str(path)], number, most)
                tally[kind, code] = tally.get((kind, code), 0) + 1
                worst[kind] = max(worst.get(kind, (0, 0)), (seconds, memory))
                if found:
                    broken.append((kind, number, found))
                    print(f"{kind} {number}: {', '.join(found)}", flush=True)
                    if keep:
                        keep.mkdir(parents=True, exist_ok=True)
                        (keep / f"{kind}-{seed}-{number}{ending}").write_bytes(text)
                done += 1
    except KeyboardInterrupt:
        print(f"ended before {count} inputs were tried")
    for (kind, code), n in sorted(tally.items()):
        print(f"{kind}: {n} ended with {code}")
    for kind, (seconds, memory) in sorted(worst.items()):
        print(f"{kind}: the longest took {seconds:.2f} s of the processor, and {memory // 1024 // 1024} MB")
    print(f"{done} inputs, {len(broken)} faults")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
