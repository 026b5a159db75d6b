//! What is proved: the algebra, what is not unique, coupled contacts, and what follows of it.

use std::path::Path;

use kane::audit::Verdict::{Proved, Refuted};
use kane::impact::compliant::{Compliance, DimensionReduction, Loss, Process as _, SpringDashpot};
use kane::impact::{Alpha, Provenance, laws};
use kane::report::{Report, Summary};

use super::cells::Cells;
use super::claims::Claims;
use super::reality::Reality;
use super::{law_link, signed};
use crate::NotMade;

/// (b) The paper's algebra.
pub(super) fn algebra(root: &Path) -> Result<String, NotMade> {
    let paper = Claims::of(root, "oblique-collision.md", None)?;
    let counts = Summary::of(&Report::new(&paper.audit, "kane audit")).headline();
    let told = |label, verdict| paper.told(label, verdict);
    Ok(format!(
        "## The paper's algebra\n\n`kane audit`, of [the transcription](derivations/oblique-collision.md): {counts}.\n\n\
         - It follows: {}.\n\
         - It does not: {}. {} of the other claims rest on these: each is a slip with a repair beside it, {}, {}, {}.\n\
         - The ansatz in its first form, `{}`, has no solution ({}); the conditions make of it an identity of momentum ({}). What is used is another form, `{}`.\n\
         - That k → −1 in normal collision is assumed: the argument for it does not give it ({}), and the friction law that it argues with does not have that limit ({}).\n\
         - The failure zone, `{}`: there tangential and rotational energy rises ({}), the total need not ({}).\n",
        paper.equations(Proved).join(", "),
        paper.equations(Refuted).join(", "),
        match paper.citing_refuted() {
            0 => "None".to_owned(),
            n => n.to_string(),
        },
        told("(1r)", Proved)?,
        told("(25r)", Proved)?,
        told("(27r)", Proved)?,
        paper.saying("ansatz")?,
        told("literal-none", Proved)?,
        told("degenerate", Proved)?,
        paper.saying("(14)")?,
        told("(10-why)", Proved)?,
        told("W-limit", Refuted)?,
        paper.condition("zone")?,
        told("zone", Proved)?,
        told("zone-total", Refuted)?,
    ))
}

/// (c) Not unique.
pub(super) fn not_unique(root: &Path, cells: Cells<'_>) -> Result<String, NotMade> {
    let labels = [
        "not-unique",
        "b-9",
        "b-energy",
        "b-cone",
        "c-energy",
        "c-cone",
        "smith-10",
        "smith-energy",
        "garwin-10",
        "garwin-energy",
        "linear",
        "paper-less",
        "walton-10-half",
    ];
    let page = Claims::of(root, "answers-to-the-conditions.md", Some(&labels))?;
    let told = |label, verdict| page.told(label, verdict);
    let conditions = ["C1", "C2", "C3", "C4", "cone-sphere", "energy-sphere"];
    let laws: Vec<String> = cells.laws_with(&conditions).into_iter().map(law_link).collect();
    Ok(format!(
        "## Not the only answer\n\nMomentum, the connection conditions (10) to (13), energy and the cone do not determine k ({}). Two families with a parameter meet them all ({}, {}, {}; {}, {}), and of the laws here {} ({}, {}; {}, {}; every cell in [the matrix](figures/matrix.svg)); two of these are older than the paper. What singles the paper's out is that it is linear in k ({}). It is not the one that loses most ({}), and condition (10) is no law of nature: Walton's, made for measured spheres, does not meet it ({}).\n",
        told("not-unique", Proved)?,
        told("b-9", Proved)?,
        told("b-energy", Proved)?,
        told("b-cone", Proved)?,
        told("c-energy", Proved)?,
        told("c-cone", Proved)?,
        laws.join(", "),
        told("smith-10", Proved)?,
        told("smith-energy", Proved)?,
        told("garwin-10", Proved)?,
        told("garwin-energy", Proved)?,
        told("linear", Proved)?,
        told("paper-less", Proved)?,
        told("walton-10-half", Refuted)?,
    ))
}

/// (e) Coupled contacts.
pub(super) fn coupled(root: &Path, cells: Cells<'_>) -> Result<String, NotMade> {
    let labels = [
        "never-rises",
        "cone",
        "cone-k",
        "cone-k-only",
        "poisson-energy",
        "example-rises",
        "path-end",
        "kane-energy",
        "(28-energy)",
        "either",
        "puzzle-times",
    ];
    let page = Claims::of(root, "coupled-collision.md", Some(&labels))?;
    let told = |label, verdict| page.told(label, verdict);
    let energy = cells.cell("wang-su-li", "energy")?.told("proved")?;
    let cone = cells.cell("wang-su-li", "cone")?;
    Ok(format!(
        "## Where the contact couples\n\nKane's pendulum couples, the sphere does not; the paper says that its method \"can be readily applied\". Applied with Newton's restitution:\n\n\
         - energy never rises ({}, {energy}), and of that of Kane's pendulum, at the second e above, `{}` is left ({}), where the puzzle has `{}` ({});\n\
         - but the cone is left ({}, {}): {}. It is kept exactly for `{}` ({}, {});\n\
         - conditions (10) and (11) together hold only where nothing couples ({});\n\
         - with Poisson's restitution energy can rise ({}, by {}), with energetic restitution too ({}), and formula (28) carried over unchanged creates some ({}).\n",
        told("never-rises", Proved)?,
        page.saying("kane-energy")?,
        told("kane-energy", Proved)?,
        page.saying("puzzle-times")?,
        told("puzzle-times", Proved)?,
        told("cone", Refuted)?,
        cone.told("refuted")?,
        cone.reason,
        page.saying("cone-k-only")?,
        told("cone-k", Proved)?,
        told("cone-k-only", Proved)?,
        told("either", Proved)?,
        told("poisson-energy", Refuted)?,
        told("example-rises", Proved)?,
        told("path-end", Proved)?,
        told("(28-energy)", Refuted)?,
    ))
}

/// (f) Which law to take.
pub(super) fn choice(cells: Cells<'_>, reality: &Reality) -> Result<String, NotMade> {
    let everywhere = ["energy", "cone", "exists", "sliding"];
    let safe: Vec<String> = cells.laws_with(&everywhere).into_iter().map(law_link).collect();
    let gains = cells.cell("kane-levinson", "energy")?.told("refuted")?;
    let superball = cells.cell("garwin-capped", "energy-sphere")?.told("proved")?;
    Ok(format!(
        "## Which law to take\n\n| contact | take | why |\n|---|---|---|\n\
         | does not couple, slides all the time: α ≤ {:.3} for these spheres | all of Coulomb's friction, k = 1 − 2α | measured, rms {:.3}; rigid processes stop the slip at α = 1/2 already |\n\
         | does not couple, larger α, elastic bodies | the elastic half-space, `poisson_ratio` of [scenes](scene-format.md) | rms of k {:.3}, with no parameter fitted |\n\
         | the same, measured β₀ | {} | one parameter, its plateau |\n\
         | a superball | {}, at β₀ = 1 | loses nothing that it need not ({superball}) |\n\
         | couples | {} | these alone keep energy, cone, existence and Coulomb's sliding at every planar contact, each proved |\n\
         | couples, in an engine that steps in time | {} is what such engines do; bound its energy | energy rises: {gains} |\n",
        reality.slides,
        reality.sliding,
        reality.half_space,
        law_link("walton"),
        law_link("garwin-capped"),
        safe.join(", "),
        law_link("kane-levinson"),
    ))
}

/// (g) What is open.
pub(super) fn open() -> Result<String, NotMade> {
    let because = |error: &dyn std::fmt::Display| NotMade::because("verdict.md", error);
    let unread = laws().iter().filter(|law| law.info.known_by != Provenance::Original).count();
    let e = kane::figures::experiment::RESTITUTION;
    let (nu, alpha) = (0.3, 1.0);
    let sphere = Compliance::of_poisson(3.5, nu, e).map_err(|error| because(&error))?;
    let asked = Alpha::Finite(alpha);
    let (springs, steps) = (DimensionReduction::SPRINGS, DimensionReduction::STEPS);
    let k = |loss| -> Result<f64, NotMade> {
        let process = DimensionReduction::damped(sphere, loss, springs, steps);
        let outcome = process.and_then(|process| process.outcome(&asked));
        outcome.map(|outcome| outcome.ratios.k).map_err(|error| because(&error))
    };
    let dashpot = SpringDashpot::new(sphere).and_then(|process| process.k(&asked));
    let dashpot = dashpot.map_err(|error| because(&error))?;
    Ok(format!(
        "## What is open\n\n\
         - Of {} laws {unread} are known from abstracts or through others; Kane's own text was not read. [Each says so](laws.md).\n\
         - The measured points are [digitised by others](data/kharaz-2001.md), without error bars; near normal collision k magnifies an error of reading.\n\
         - What e < 1 means for an elastic contact no theory says: at ν = {nu}, α = {alpha}, e = {e} k is {} with a faster restitution, {} with Tsuji's damper, {} with linear springs and a damper ([the choice](scene-format.md#the-file)).\n\
         - Whether a real body that couples follows any of these: no measured points are at hand.\n",
        laws().len(),
        signed(k(Loss::Recoil)?, 3),
        signed(k(Loss::Tsuji)?, 3),
        signed(dashpot, 3),
    ))
}
