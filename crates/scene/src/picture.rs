//! What a scene shows of itself: its motion, or where nothing flies, the impact from within.

use crate::choose::{Model, chain_of};
use crate::impulse_plane::ImpulsePlane;
use crate::scene::{Scene, Setup};
use crate::simulate::{ContactTime, watch_chain};
use crate::strobe::Strobe;
use kane_impact::Law;
use kane_number::Lane as _;

/// The picture that belongs to a scene under a model.
#[derive(Clone, Debug, PartialEq)]
pub enum Picture {
    /// What flies, at equal intervals.
    Motion(Strobe),
    /// The impact of a tip in the plane of its impulse.
    ImpulsePlane(ImpulsePlane),
    /// Spheres that touch at once: velocities and forces over the time of contact.
    ContactTime(ContactTime),
}

/// Steps of a chain to the time of one bounce, for a picture.
const STEPS: u32 = 128;

impl Picture {
    /// In floats; `None` where the model has no such picture.
    pub(crate) fn of(scene: &Scene, model: Model, laws: &[Law]) -> Option<Self> {
        match &scene.setup {
            Setup::Tip(_) => {
                ImpulsePlane::of(scene, model.mechanics, laws).ok().map(Self::ImpulsePlane)
            }
            Setup::Bodies(_) => match Strobe::of(scene, model) {
                Some(strobe) => Some(Self::Motion(strobe)),
                None => {
                    let chain = chain_of(scene, &scene.nominal())?;
                    watch_chain(&chain, STEPS).ok().map(Self::ContactTime)
                }
            },
        }
    }
}

/// A tip's contact in floats.
pub(crate) fn contact_of(scene: &Scene) -> Option<kane_impact::Contact<f64>> {
    match scene.nominal() {
        Setup::Tip(tip) => Some(tip.map(|x| x.to_f64()).contact().ok()?.0),
        Setup::Bodies(_) => None,
    }
}
