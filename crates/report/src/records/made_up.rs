//! Studies that tests tell of.

use kane_impact::Law;
use kane_records::reader::Kind;
use kane_records::rigid::LawFit;
use kane_records::study::{Options, Study, study};

/// The study of a log of ten impacts that lose their slip, of which a test changes what it is about.
pub(super) fn of_a_log() -> Study {
    let head =
        "mass,radius,inertia,mu,restitution,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post";
    let row = "1,1,0.4,0.3,0.5,2,-1,0,1.55,0.5,-1.125";
    study_of(&format!("{head}\n{}", format!("{row}\n").repeat(10)))
}

/// The study of a log.
pub(super) fn study_of(text: &str) -> Study {
    study(text.as_bytes(), Kind::Csv, &Options::new(&[])).expect("it can be read")
}

/// A law that gives so many of ten impacts.
pub(super) fn law_fit(law: &Law, fitted: bool, consistent: usize) -> LawFit {
    let (law, rows, silent, worst_line) = (law.clone(), 10, 0, 0);
    LawFit { law, fitted, rows, silent, consistent, worst: 0.0, median: 0.0, worst_line }
}
