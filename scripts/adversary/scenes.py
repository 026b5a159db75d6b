#!/usr/bin/env python3
"""Random scenes against an independent simulator.

    python3 scripts/adversary/scenes.py target/release/kane 200 gate
    python3 scripts/adversary/scenes.py target/release/kane 2000 long --family=air
"""

import random
import sys
import time
from decimal import Decimal as D

sys.dont_write_bytecode = True

import tips  # noqa: E402
from simulator import HALF, LAWS, Unfit, follow  # noqa: E402
from spheres import follow_in_space  # noqa: E402
from staging import FAMILIES  # noqa: E402
from trial import Trial  # noqa: E402
from tumbler import CONTACTS, follow_tumbling  # noqa: E402

SLACK = D(10) ** -25  # what 50 digits, and impacts that amplify, may leave
ROUNDED = D(10) ** -14  # a wall at an angle in degrees has a normal of length 1 to a rounding
POINTS = 6  # looked at within an uncertainty


def quantity(key, draft, run):
    name, _, number = key.partition("_of_")
    ball = run.balls[int(number or 1) - 1]
    if name == "kinetic_energy_j":
        return sum(b.energy() for b in run.balls)
    if name == "turned_rad":
        return run.turned
    if name in ("z_m", "v_z_m_s", "omega_x_rad_s", "omega_y_rad_s"):
        return {"z_m": ball.at[2:], "v_z_m_s": ball.v[2:], "omega_x_rad_s": ball.w[:1], "omega_y_rad_s": ball.w[1:2]}[name][0]
    return {
        "time_s": run.time,
        "x_m": ball.at[0],
        "y_m": ball.at[1],
        "v_x_m_s": ball.v[0],
        "v_y_m_s": ball.v[1],
        "omega_rad_s": ball.w[2] if draft.in_space else ball.w,
    }[name]


def law_of(draft, model):
    if draft.tumbler or draft.tip:
        return CONTACTS.get(model) and model
    if model == "reference":
        model = "walton" if "tangential_restitution" in draft.top else "routh-newton"
    return LAWS.get(model)


def answers(draft, model, pick=lambda value, within: value):
    """The simulator's run and its answers; one impact of a tip is no run."""
    if draft.tip:
        return None, tips.answers(draft, model)
    scene = draft.scene(pick)
    kind, limit = draft.until
    until = {"impacts": int(limit)} if kind == "impacts" else {"rest": True} if kind == "rest" else {"duration": D(limit)}
    if draft.tumbler:
        run = follow_tumbling(scene, model, until.get("impacts"), until.get("duration"))
    elif draft.in_space:
        run = follow_in_space(scene, law_of(draft, model), until.get("impacts"), until.get("duration"))
    else:
        run = follow(scene, law_of(draft, model), **until)
    return run, {key: quantity(key, draft, run) for key in draft.ask}


def slack(draft, value):
    degrees = any("angle_deg" in wall for wall in draft.walls)
    return ROUNDED * (1 + abs(value)) if degrees else SLACK


def ulp_half(value):
    return D(2) ** -53 * abs(D(value)) + D(10) ** -320


def compare(draft, report, trial):
    """What is wrong with a report, in words."""
    run, truth = answers(draft, "reference")
    for line in report["asked"]:
        if line["error"] is None or line["value"] is None:
            trial.count_one("answers without an error")
            continue
        trial.judged += 1
        trial.count_one("answers " + line["error_is"])
        off = abs(D(line["value"]) - truth[line["quantity"]])
        # what is shown is the nearest float, and an exact answer the nearest to a fraction
        stated = D(line["error"]) + ulp_half(line["value"]) + slack(draft, truth[line["quantity"]])
        if off > stated:
            yield f"{line['quantity']} is {line['value']} ± {line['error']}, but {truth[line['quantity']]:.20g}"
    yield from models(draft, report, truth, trial)
    if run:
        yield from motion(draft, report, run, trial)
    if not draft.tip and draft.uncertain():
        yield from uncertainty(draft, report, truth, trial)


def models(draft, report, truth, trial):
    """No model is good enough that misses its tolerance, nor has an error beyond the one that is stated."""
    for tried in report["models"]:
        name, _, system = tried["model"].partition("/")
        if law_of(draft, name) is None or system == "f32":
            continue
        try:
            _, own = answers(draft, name)
        except Unfit:
            continue
        for (key, tolerance), error in zip(draft.ask.items(), tried["errors"]):
            miss = abs(own[key] - truth[key])
            # f64 rounds, and impacts amplify that
            least = slack(draft, truth[key])
            noise = least if system in ("rational", "double-double") else D("1e-9") * (1 + abs(truth[key]))
            if tried["good_enough"]:
                trial.count_one("certified " + system)
                if miss > D(tolerance) + noise:
                    yield f"{tried['model']} is good enough, but {key} is off by {miss:.3g}"
            if error is not None and miss > D(error) + noise + least:
                yield f"{tried['model']}: {key} is off by {miss:.17g}, not by {error}"


def motion(draft, report, run, trial):
    """Impacts and their ledger are those of the model that is shown."""
    name, _, system = report["shown"].partition("/")
    impacts = report["impacts"]
    state = {b["id"]: b for b in report["scene"]["bodies"]}
    mass = {b["id"]: (b["mass_kg"], b["inertia_kg_m2"]) for b in report["scene"]["bodies"]}
    rough = 1e-4 if system == "f32" else 1e-9
    squares = lambda s, *keys: sum(s.get(key, 0) ** 2 for key in keys)
    energy = lambda i, s: (
        mass[i][0] * squares(s, "v_x_m_s", "v_y_m_s", "v_z_m_s")
        + mass[i][1] * squares(s, "omega_rad_s", "omega_x_rad_s", "omega_y_rad_s")
    ) / 2
    for n, impact in enumerate(impacts):
        parts = [impact[part] for part in impact if part.endswith("_j")]
        gained = sum(energy(s["id"], s) - energy(s["id"], state[s["id"]]) for s in impact["after"])
        scale = 1 + sum(map(abs, parts)) + sum(energy(s["id"], s) for s in impact["after"])
        if abs(gained - sum(parts)) > rough * scale:
            yield f"impact {n + 1} changes the energy by {gained}, its parts are {parts}"
        state.update({s["id"]: s for s in impact["after"]})
        trial.count_one("ledgers")
    law = law_of(draft, name)
    if law is None or system == "f32":
        return
    try:
        own, _ = answers(draft, name)
    except Unfit:
        return
    for n, (impact, event) in enumerate(zip(impacts, own.events)):
        if n > 8:
            break
        if list(event.who) != impact["who"]:
            yield f"impact {n + 1} is of {impact['who']}, not of {event.who}"
            break
        numbers = {"time_s": event.time, "v_t_before_m_s": event.slip[0], "v_t_after_m_s": event.slip[1]}
        numbers |= {"approach_m_s": event.speeds[0], "separation_m_s": event.speeds[1]}
        numbers |= {"p_t_n_s": event.impulse[0], "p_n_n_s": event.impulse[1]} | event.works
        if draft.tumbler:
            numbers |= {"corner": D(event.corner), "turned_rad": event.turned}
        numbers |= event.axes if draft.in_space else {}
        for key, value in numbers.items():
            if key not in impact:
                yield f"impact {n + 1} has no {key}"
            elif abs(D(impact[key]) - value) > D("1e-7") * (1 + abs(value)):
                yield f"impact {n + 1}: {key} is {impact[key]}, not {value:.12g}"
    trial.count_one("motions")


def uncertainty(draft, report, truth, trial):
    """What the inputs move is within what is enclosed, and the chosen model is good enough all over."""
    rng, seen = random.Random(draft.toml()), []
    chosen = (report["chosen"] or "").partition("/")[0]
    for n in range(POINTS):
        ways = [rng.choice([-1, 1]) if n % 2 else rng.uniform(-1, 1) for _ in range(draft.uncertain())]

        def at_point(ways):
            left = iter(ways)
            return lambda value, within: value + D(next(left)) * within

        try:
            _, there = answers(draft, "reference", at_point(ways))
            mine = answers(draft, chosen, at_point(ways))[1] if law_of(draft, chosen) else None
        except Unfit:
            continue
        seen.append(there)
        for key, tolerance in draft.ask.items():
            if mine and abs(mine[key] - there[key]) > D(tolerance) * (1 + D("1e-6")) + D("1e-12"):
                yield f"{chosen} is chosen, but off by {abs(mine[key] - there[key]):.3g} in {key} within the uncertainty"
    for line in report["asked"]:
        if line["inputs_are"] != "enclosed" or line["inputs_move_it_by"] is None or not seen:
            continue
        trial.count_one("enclosed spreads")
        values = [there[line["quantity"]] for there in seen] + [truth[line["quantity"]]]
        if (max(values) - min(values)) * HALF > D(line["inputs_move_it_by"]) + slack(draft, values[0]):
            yield f"inputs move {line['quantity']} by more than {line['inputs_move_it_by']}"


def main():
    trial = Trial("gate")
    only = [a.partition("=")[2] for a in sys.argv if a.startswith("--family=")]
    kinds = FAMILIES | {"tips": tips.tips}
    families = only or list(kinds)
    picked = [int(a.partition("=")[2]) for a in sys.argv if a.startswith("--only=")]
    index = picked[0] - 1 if picked else 0
    fit = 0
    while fit < trial.count:
        if picked and index >= picked[0]:
            break
        family = families[index % len(families)]
        index += 1
        draft = kinds[family](random.Random(f"{trial.seed}/{family}/{index}"))
        source = tips.toml(draft) if draft.tip else draft.toml()
        if "--show" in sys.argv:
            print(source)
        try:
            answers(draft, "reference")
        except Unfit as why:
            trial.count_one(f"left out: {why}")
            continue
        fit += 1
        began = time.monotonic()
        report, code, messages = trial.scene(source)
        if report is None:
            trial.count_one(f"{family}: no answer")
            if code not in (1, 3):
                trial.wrong.append((source, f"{family} {index}: exit {code}: {messages}"))
            continue
        trial.count_one(f"{family}: {'answered' if report['chosen'] else 'no model certified'}")
        if "--verbose" in sys.argv:
            print(f"{family} {index}: {time.monotonic() - began:.1f} s", flush=True)
        for why in compare(draft, report, trial):
            if "--verbose" in sys.argv:
                print(f"  {why}", flush=True)
            trial.wrong.append((source, f"{family} {index}: {why}"))
    return trial.told(what="answers", beside=f" in {fit} scenes")


if __name__ == "__main__":
    sys.exit(main())
