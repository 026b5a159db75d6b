//! Scenes: what collides, what is asked of it, and the least model that answers.
//!
//! A [`Scene`] is read [from TOML](read::scene). [`simulate`] follows it event by event, in any
//! number system; [`answer`] chooses the cheapest model that is good enough, says why, and returns
//! the values with their errors, the energy ledger and the motion.
//!
//! ```
//! use kane_impact::laws;
//! use kane_scene::{Effort, answer, read};
//!
//! let text = r#"
//! title = "A ball drops"
//! friction = 0
//! restitution = "1/2"
//! gravity_m_s2 = 10
//! floor_m = 0
//!
//! [[body]]
//! mass_kg = 1
//! radius_m = 0.1
//! position_m = [0, 1.35]
//! velocity_m_s = [0, 0]
//!
//! [until]
//! rest = true
//!
//! [ask]
//! time_s = 0
//! "#;
//! let scene = read::scene("ball.toml", text).expect("the scene is well formed");
//! let answer = answer(&scene, laws(), None, Effort::Chosen, &mut |_, _| {}).expect("there is an answer");
//! // it falls for 1/2 s and bounces for 2·5/2/(10·(1 − 1/2)) s, infinitely many times
//! assert_eq!((answer.lines[0].value, answer.lines[0].error), (1.5, Some(0.0)));
//! // and as every number on the way is a float of single precision, those are enough
//! assert_eq!(answer.shown.to_string(), "normal-only/f32");
//! ```

mod air;
mod choose;
pub mod collide;
mod coordinate;
mod corners;
mod encounter;
mod impulse_plane;
mod off_plane;
mod picture;
mod plane;
mod quantity;
pub mod read;
mod resolver;
mod rotation;
mod round;
pub mod rounded;
mod scene;
mod side;
pub mod simulate;
pub mod stress;
mod strobe;
mod terms;
mod tip;
mod vector;
mod world;

pub use air::Air;
pub use choose::{
    Answer, Bounced, Effort, Judged, Known, Line, Mechanics, Model, NoAnswer, Place, Shown, Spread,
    UnknownModel, Verdict, answer, model_names,
};
pub use coordinate::Coordinate;
pub use corners::{Corners, NotConvex};
pub use impulse_plane::{ImpulsePlane, PlaneLine};
pub use kane_impact::oracle::Event;
pub use off_plane::OffPlane;
pub use picture::Picture;
pub use plane::Plane;
pub use quantity::{Kind, Quantity};
pub use resolver::{Elastic, Lasting, NormalOnly, Process, Resolver};
pub use round::Round;
pub use scene::{Asked, MOST_UNCERTAIN, Scene, Setup, Tangential};
pub use side::{MOST_PLANES, Side};
pub use strobe::{Frame, Strobe};
pub use terms::{Restitution, Terms};
pub use tip::{Tip, TipBody};
pub use world::{Wall, World};
