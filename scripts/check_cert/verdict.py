"""Which verdict the evidence supports, claim by claim."""

from .errors import Rejected, demand
from .evidence import keys, listed, optional, text
from .functions import Functions
from .goal import Goal, rests_on
from .limits import prove_by_cases
from . import angles, determined, exponentials
from .motion import check_witness
from .point import check_point
from .proof import ANY, Proof

WORST = ("vacuous", "ill-defined", "refuted", "undecided", "proved")
PROVED_BY = {  # form of a claim -> finding -> how it is shown
    "relation": {
        "proved": "proof", "vacuous": "proof", "refuted": "witness", "ill-defined": "witness",
        "consistent": "witness",
    },
    "limit": {"proved": "sides", "vacuous": "proof", "refuted": "witness", "consistent": "witness"},
    "contradiction": {"proved": "proof", "refuted": "witness"},
    "not implied": {
        "proved": "witness", "refuted": "proof", "vacuous": "proof", "consistent": "witness",
    },
}


def asked(document, claim):
    """What each link of a claim asks: a claim and its link, and the same for a witness."""
    if not claim.induction:
        return [((claim, item),) * 2 for item in claim.items or [None]]
    known = document.sequences
    first, step = known.instance(claim, dict([claim.induction])), known.step(claim)
    own = zip(claim.items, step.items)
    return [((first, item),) * 2 for item in first.items] + [
        ((step, further), (claim, item)) for item, further in own
    ]


def check_link(document, aims, link, shown):
    """Checks the evidence of one link; returns what it is found to be.

    `shown` says whether all links before it are proved.
    """
    demand(isinstance(link, dict) and "finding" in link, "a finding is expected")
    if link["finding"] is None:
        keys(link, "finding")
        return "undecided"
    names = ("finding", "premises", "roots", "evidence", *(("at",) if "at" in link else ()))
    finding, premises, roots, evidence, *at = keys(link, *names)
    is_witness = isinstance(evidence, dict) and bool({"point", "functions"} & set(evidence))
    (claim, item), known = aims[is_witness], document.sequences
    demand(not claim.sought, "nothing is named that exists")
    is_step = aims[0][0] is not aims[1][0]
    demand(not is_step or shown or finding != "vacuous", "the first values do not all hold")
    if is_witness and known.all_spoken(claim):
        demand(at, "a point counts where numbers stand in the place of indices")
        place = claim.items.index(item) if item else None
        claim = known.instance(claim, known.named(at[0]))
        item = None if place is None else claim.items[place]
        demand(not known.all_spoken(claim), "an index has no number")
    else:
        demand(not at, "no number stands in the place of an index here")
    form = claim.form
    if form == "relations":
        form = "limit" if item[0] == "->" else "relation"
    shown_by = PROVED_BY[form].get(text(finding))
    demand(shown_by, "there is no such finding for this kind of claim")
    decides = not claim.exists or finding in ("proved", "vacuous", "consistent")
    demand(decides, "that a witness fails does not refute an existence")
    demand(premises in ("cited", "all"), "the premises are the cited ones, or all")
    demand(premises == "cited" or shown_by == "witness", "a proof has no more premises")
    goal = Goal(document, claim, item, finding, premises, [text(r) for r in listed(roots)])
    determined.check(goal, finding)
    proof = Proof(goal)
    if shown_by == "sides":
        prove_by_cases(proof, evidence, claim, *item[1:], claim.variable)
        return finding
    demand(isinstance(evidence, dict) and len(evidence) == 1, "one piece of evidence is expected")
    ((kind, content),) = evidence.items()
    if shown_by == "proof":
        demand(kind == "proof", "a proof is expected")
        refutes = form == "not implied" and finding == "refuted"
        demand(not (refutes and claim.other.limits), "no proof shows that a limit is implied")
        state = goal.state(finding)
        passes = claim.variable if form == "limit" else ANY
        proof.check(content, state.conditions, state.formulas, passes)
    elif kind == "functions":
        check_witness(goal, claim, kind, content, rests_on(document, claim.cited))
        exponentials.check_witness(goal, kind, content, rests_on(document, claim.cited))
        angles.check_witness(goal, kind, content, rests_on(document, claim.cited))
        Functions(goal, content).check(finding)
    else:
        demand(kind == "point", "a witness is expected")
        demand(not goal.has_limits, "a witness by functions is expected")
        state = goal.at_point(finding)
        check_point(goal, content, goal.mentioned, goal.listed_roots, state.conditions, state.formulas)
        check_witness(goal, claim, kind, content, rests_on(document, claim.cited))
        exponentials.check_witness(goal, kind, content, rests_on(document, claim.cited))
        angles.check_witness(goal, kind, content, rests_on(document, claim.cited))
    return "undecided" if finding == "consistent" else finding


def check_claim(document, claim, entry, verdicts, report):
    """Checks an entry for a claim; returns the verdict, and whether all was accepted."""
    entry, witness = optional(entry, "witness", None)
    label, verdict, links = keys(entry, "label", "verdict", "links")
    demand(label == claim.label, f"the label is not `{claim.label}`")
    if witness is not None:
        document.find(claim, witness)
    links_asked = asked(document, claim)
    found, good = [], True
    for number, (aims, link) in enumerate(zip(links_asked, listed(links, len(links_asked))), 1):
        try:
            shown = all(verdict == "proved" for verdict in found)
            found.append(check_link(document, aims, link, shown))
            report(f"yes  {label} link {number}: {found[-1]}")
        except Rejected as reason:
            found.append("undecided")
            good = False
            report(f"NO   {label} link {number}: {reason}")
        except (RecursionError, MemoryError):
            found.append("undecided")
            good = False
            report(f"NO   {label} link {number}: the evidence is too deep or too large")
    supported = min(found, key=WORST.index)
    cites = [s.label for s in claim.cited if s.kind == "claim" and verdicts[s.label] != "proved"]
    if cites:
        supported = "unsupported"
    if verdict != supported:
        good = False
        report(f"NO   {label}: called {verdict}, found {supported}")
    return supported, good
