//! The published impact laws, one file each, and the catalogue of all of them.

mod brach;
mod chatterjee_ruina;
mod chatterjee_ruina_spatial;
mod djerassi;
mod garwin;
mod kane_levinson;
mod keller_printed;
mod routh;
mod saitoh;
mod share;
mod smith;
mod smith_printed;
mod tilted;
mod walton;
mod wang_su_li;
mod whittaker_stop;
mod whittaker_uncapped;

pub use brach::Brach;
pub use chatterjee_ruina::ChatterjeeRuina;
pub use djerassi::{DjerassiNewton, DjerassiPoisson, DjerassiStronge};
pub use garwin::{Garwin, GarwinCapped};
pub use kane_levinson::KaneLevinson;
pub use keller_printed::KellerPrinted;
pub use routh::{Keller1986, RouthNewton, Stronge1990};
pub use saitoh::Saitoh;
pub use smith::Smith1991;
pub use smith_printed::SmithPrinted;
pub use tilted::{KuninakaHayakawa, LougeAdams};
pub use walton::Walton;
pub use wang_su_li::WangSuLi;
pub use whittaker_stop::WhittakerStop;
pub use whittaker_uncapped::WhittakerUncapped;

use crate::ImpactLaw;

/// Something to do with every law, whatever its type.
pub trait LawVisitor {
    /// Is given one law.
    fn visit<L: ImpactLaw>(&mut self, law: &L);
}

/// Shows a visitor every law with its default parameters, in the order of tables and reports: the
/// paper's, then by the year of the idea.
pub fn visit_laws(visitor: &mut impl LawVisitor) {
    visitor.visit(&WangSuLi);
    visitor.visit(&WhittakerUncapped);
    visitor.visit(&WhittakerStop);
    visitor.visit(&RouthNewton);
    visitor.visit(&Garwin);
    visitor.visit(&GarwinCapped);
    visitor.visit(&KaneLevinson);
    visitor.visit(&Brach::default());
    visitor.visit(&Keller1986);
    visitor.visit(&KellerPrinted);
    visitor.visit(&Stronge1990);
    visitor.visit(&Smith1991);
    visitor.visit(&SmithPrinted::default());
    visitor.visit(&Walton::default());
    visitor.visit(&ChatterjeeRuina::default());
    visitor.visit(&LougeAdams::default());
    visitor.visit(&KuninakaHayakawa::default());
    visitor.visit(&DjerassiNewton);
    visitor.visit(&DjerassiPoisson);
    visitor.visit(&DjerassiStronge);
    visitor.visit(&Saitoh::default());
}

/// The ids of all laws, in the order of [`laws`](crate::laws()).
#[must_use]
pub fn law_ids() -> Vec<&'static str> {
    crate::laws().iter().map(|law| law.info.id).collect()
}
