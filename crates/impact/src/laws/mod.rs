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

/// The ids of all laws, in the order of [`laws`](crate::laws()).
#[must_use]
pub fn law_ids() -> Vec<&'static str> {
    crate::laws().iter().map(|law| law.info.id).collect()
}
