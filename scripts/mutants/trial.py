"""Each mutant is a run of the tests that reach it, the quick ones first, until one fails."""

import concurrent.futures
import math
import os
import resource
import signal
import subprocess
import tempfile
import threading
from dataclasses import dataclass, field
from pathlib import Path

#: bytes that a test may take: a mutant that asks for all memory is told by its end, not by that of the machine
BYTES = 6 * 1024**3


@dataclass
class Test:
    """A test of a program, the seconds that it takes, and the mutants that it reaches."""

    program: Path
    directory: Path
    name: str
    seconds: float = 0.0
    reached: set[int] = field(default_factory=set)


def run(command: list[str], directory: Path, environment: dict[str, str], seconds: float) -> tuple[int | None, float]:
    """The exit code, or nothing if the time was over, and the seconds of processor time.

    The limit is one of processor time, so that what else the machine does ends no test; who only waits has ten times as
    much. What the command started ends with it.
    """
    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(seconds), math.ceil(seconds) + 1))

    child = subprocess.Popen(command, cwd=directory, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL, preexec_fn=limit, start_new_session=True)
    killer = threading.Timer(10 * seconds + 60, os.killpg, (child.pid, signal.SIGKILL))
    killer.start()
    _, status, used = os.wait4(child.pid, 0)
    killer.cancel()
    child.returncode = os.waitstatus_to_exitcode(status)
    over = child.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
    return None if over else child.returncode, used.ru_utime + used.ru_stime


def of(programs: list[tuple[str, Path, Path]], environment: dict[str, str], only: list[str], within: float,
       jobs: int) -> tuple[list[Test], list[Test]]:
    """All tests that run without being asked for, each run once alone, the quick ones first; and those that take more
    processor time than is given them. What fails without a mutant is told, and left out."""
    found = []
    for _, program, directory in programs:
        def names(*more: str) -> set[str]:
            told = subprocess.run([program, "--list", "--format=terse", *more], cwd=directory, capture_output=True,
                                  text=True, check=True, env=environment).stdout
            return {line.removesuffix(": test") for line in told.splitlines() if line.endswith(": test")}

        chosen = sorted(names() - names("--ignored"))
        found += [Test(program, directory, n) for n in chosen if not only or any(word in n for word in only)]

    def once(test: Test) -> int | None:
        with tempfile.NamedTemporaryFile("r") as reached:
            code, test.seconds = run([str(test.program), "--exact", test.name, "--test-threads=1"], test.directory,
                                     {**environment, "KANE_MUTANTS_REACHED": reached.name}, within)
            test.reached = {int(line) for line in reached.read().split()}
        if code not in (0, None):
            print(f"  {test.program.name}: {test.name} fails without a mutant: left out", flush=True)
        return code

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        codes = list(pool.map(once, found))
    quick = [t for t, code in zip(found, codes) if code == 0]
    return sorted(quick, key=lambda t: t.seconds), [t for t, code in zip(found, codes) if code is None]


def batches(tests: list[Test]) -> list[list[Test]]:
    """Tests of one program each, at first few and quick, then more at a time."""
    out: list[list[Test]] = []
    room = 0.2
    for test in tests:
        last = out[-1] if out else None
        if last and last[0].program == test.program and sum(t.seconds for t in last) + test.seconds <= room:
            last.append(test)
        else:
            room = room * 2 if out else room
            out.append([test])
    return out


def tried(number: int, tests: list[Test], environment: dict[str, str]) -> tuple[str, str]:
    """How a mutant fares: `caught`, `timed out` or `missed`, and by what or by how many tests."""
    reaching = [t for t in tests if number in t.reached]
    for batch in batches(reaching):
        seconds = 5 * sum(t.seconds for t in batch) + 1
        code, _ = run([str(batch[0].program), "--exact", "--test-threads=1", *(t.name for t in batch)],
                   batch[0].directory, {**environment, "KANE_MUTANT": str(number)}, seconds)
        if code is None:
            return "timed out", batch[0].name
        if code != 0:
            return "caught", batch[0].name if len(batch) == 1 else f"{batch[0].name} and {len(batch) - 1} more"
    return "missed", f"{len(reaching)} tests reach it"
