//! Column names of engines and papers that say something else by themselves, or nothing.
//!
//! Most names are understood as they are (`linvel.x before`, `omega'`). A preset is for those that depend on whose log
//! it is: that `qvel[1]` is a velocity along y, that a paper's `V_n` without a prime is before the impact.

use crate::spelling::tokens;

/// The names of one engine, or of papers. `*` stands for `pre` or `post`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// what it is called
    pub name: &'static str,
    /// whose names these are
    pub of: &'static str,
    /// names of the schema, and theirs without a mark of the time
    pub columns: &'static [(&'static str, &'static str)],
    /// whether a motion without a mark of the time is that before
    unmarked_is_before: bool,
}

const VX: &str = "vx1_*_m_s";
const VY: &str = "vy1_*_m_s";
const SPIN: &str = "omega1_*_rad_s";

/// All of them, by name.
pub const PRESETS: [Preset; 7] = [
    Preset {
        name: "box2d",
        of: "Box2D: contact impulses along the normal and across it",
        columns: &[
            ("impulse_y_n_s", "normalImpulse"),
            ("impulse_x_n_s", "tangentImpulse"),
            ("normal_x", "worldManifold.normal.x"),
            ("normal_y", "worldManifold.normal.y"),
            ("inertia1_kg_m2", "massData.I"),
            ("mass1_kg", "massData.mass"),
        ],
        unmarked_is_before: false,
    },
    Preset {
        name: "bullet",
        of: "Bullet and PyBullet: components by their index, y up",
        columns: &[
            (VX, "linearVelocity[0]"),
            (VY, "linearVelocity[1]"),
            (SPIN, "angularVelocity[2]"),
            ("inertia1_kg_m2", "localInertiaDiagonal[2]"),
            ("mu", "lateralFriction"),
            ("normal_x", "contactNormalOnB[0]"),
            ("normal_y", "contactNormalOnB[1]"),
            ("impulse_y_n_s", "appliedImpulse"),
        ],
        unmarked_is_before: false,
    },
    Preset {
        name: "mujoco",
        of: "MuJoCo: a body on joints slide x, slide y, hinge z, in this order",
        columns: &[
            (VX, "qvel[0]"),
            (VY, "qvel[1]"),
            (SPIN, "qvel[2]"),
            ("mass1_kg", "body_mass"),
            ("inertia1_kg_m2", "body_inertia[2]"),
            ("radius1_m", "geom_size[0]"),
            ("mu", "geom_friction[0]"),
            ("dt_s", "opt.timestep"),
            ("gravity_x_m_s2", "opt.gravity[0]"),
            ("gravity_y_m_s2", "opt.gravity[1]"),
        ],
        unmarked_is_before: false,
    },
    Preset {
        name: "papers",
        of: "papers on impacts of particles: V_n, V_t and omega before, primed after",
        columns: &[
            (VX, "V_t"),
            (VY, "V_n"),
            (SPIN, "omega"),
            ("radius1_m", "R"),
            ("mass1_kg", "m"),
            ("e", "e_n"),
            ("mu", "f"),
        ],
        unmarked_is_before: true,
    },
    Preset {
        name: "pymunk",
        of: "Pymunk and Chipmunk",
        columns: &[
            ("inertia1_kg_m2", "moment"),
            ("e", "elasticity"),
            ("impulse_x_n_s", "total_impulse.x"),
            ("impulse_y_n_s", "total_impulse.y"),
        ],
        unmarked_is_before: false,
    },
    Preset {
        name: "rapier",
        of: "Rapier",
        columns: &[
            ("inertia1_kg_m2", "principal_inertia"),
            ("dt_s", "integration_parameters.dt"),
            ("normal_x", "manifold.normal.x"),
            ("normal_y", "manifold.normal.y"),
        ],
        unmarked_is_before: false,
    },
    Preset {
        name: "unity",
        of: "Unity and PhysX",
        columns: &[
            (SPIN, "angularVelocity.z"),
            ("inertia1_kg_m2", "inertiaTensor.z"),
            ("mu", "dynamicFriction"),
            ("dt_s", "fixedDeltaTime"),
            ("normal_x", "contact.normal.x"),
            ("normal_y", "contact.normal.y"),
            ("impulse_x_n_s", "collision.impulse.x"),
            ("impulse_y_n_s", "collision.impulse.y"),
        ],
        unmarked_is_before: false,
    },
];

impl Preset {
    /// The preset of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.name == name)
    }

    /// What the names of a file mean by this preset: pairs of a name of the schema and one of the file, for
    /// [`Options::map`](crate::study::Options::map). Names that it does not know are left out.
    #[must_use]
    pub fn map(&self, names: &[String]) -> Vec<(String, String)> {
        let one = |name: &String| {
            let (words, when) = timed(name);
            let (ours, _) = self.columns.iter().find(|(_, theirs)| tokens(theirs) == words)?;
            let when = match (ours.contains('*'), when) {
                (true, None) if self.unmarked_is_before => "pre",
                (true, Some(when)) => when,
                (false, None) => "",
                _ => return None,
            };
            Some((ours.replace('*', when), name.clone()))
        };
        names.iter().filter_map(one).collect()
    }
}

/// The words of a name, and the time that it is marked with at its end or its beginning.
fn timed(name: &str) -> (Vec<String>, Option<&'static str>) {
    let mut words = tokens(name);
    // `0` and `in` are marks elsewhere; here they are indices and units
    let mark = |word: Option<&String>| match word.map(String::as_str) {
        Some("pre" | "before" | "old" | "initial") => Some("pre"),
        Some("post" | "after" | "new" | "final") => Some("post"),
        _ => None,
    };
    if let Some(when) = mark(words.last()) {
        words.pop();
        return (words, Some(when));
    }
    match mark(words.first()) {
        Some(when) => {
            words.remove(0);
            (words, Some(when))
        }
        None => (words, None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::header::Header;

    fn of(preset: &str, names: &[&str]) -> Vec<(String, String)> {
        let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
        Preset::named(preset).expect("there is one").map(&names)
    }

    /// Every name of every preset is taken, and what it is taken for is a column of the schema.
    #[test]
    fn every_name_of_a_preset_is_a_column() {
        for preset in PRESETS {
            let mut names = Vec::new();
            for (ours, theirs) in preset.columns {
                if ours.contains('*') {
                    names.extend([format!("{theirs}_before"), format!("after {theirs}")]);
                } else {
                    names.push((*theirs).to_owned());
                }
            }
            let map = preset.map(&names);
            assert_eq!(map.len(), names.len(), "{}: {map:?}", preset.name);
            let has = |ours: &str| map.iter().any(|(known, _)| known == ours);
            // what it calls as everyone does
            let others = [
                ("mass1_kg", "mass"),
                ("inertia1_kg_m2", "inertia"),
                ("radius1_m", "radius"),
                ("vx1_pre_m_s", "vx_pre"),
                ("vx1_post_m_s", "vx_post"),
                ("vy1_pre_m_s", "vy_pre"),
                ("vy1_post_m_s", "vy_post"),
                ("omega1_pre_rad_s", "omega_pre"),
                ("omega1_post_rad_s", "omega_post"),
            ];
            let others = others.iter().filter(|(ours, _)| !has(ours));
            names.extend(others.map(|(_, name)| (*name).to_owned()));
            let header =
                Header::of(&names, &map).unwrap_or_else(|fault| panic!("{}: {fault}", preset.name));
            assert!(header.unread.is_empty(), "{}: {:?}", preset.name, header.unread);
        }
    }

    #[test]
    fn a_name_without_a_mark_is_before_in_papers_alone() {
        assert_eq!(
            of("papers", &["V_n", "V_n'", "V_t", "omega'", "x"]),
            [
                ("vy1_pre_m_s", "V_n"),
                ("vy1_post_m_s", "V_n'"),
                ("vx1_pre_m_s", "V_t"),
                ("omega1_post_rad_s", "omega'")
            ]
            .map(|(ours, theirs)| (ours.to_owned(), theirs.to_owned()))
        );
        assert_eq!(of("mujoco", &["qvel[0]"]), []);
        assert_eq!(of("mujoco", &["pre.qvel0"]), []);
    }
}
