//! The report for programs. The schema is documented in `docs/scene-format.md`.

use kane_number::System;
use kane_scene::{Answer, Known, Plane, Restitution, Round, Setup, Shown, Side, Terms, TipBody};
use serde::ser::SerializeMap as _;
use serde::{Serialize, Serializer};

use super::{SceneReport, body_id, ids, verdict};
use crate::envelope::{Schema, enveloped};

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    title: &'a str,
    headline: String,
    chosen: Option<String>,
    shown: String,
    asked: Vec<Asked<'a>>,
    reasons: &'a [String],
    models: Vec<Tried>,
    scene: Stated<'a>,
    kinetic_energy_at_start_j: f64,
    impacts: Vec<Impact<'a>>,
    end: Option<End<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Asked<'a> {
    quantity: String,
    unit: &'static str,
    value: f64,
    exact: Option<&'a str>,
    error: Option<f64>,
    error_is: Option<&'static str>,
    tolerance: f64,
    inputs_move_it_by: Option<f64>,
    inputs_are: Option<&'static str>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Tried {
    model: String,
    cost: u64,
    cost_is: &'static str,
    errors: Vec<Option<f64>>,
    errors_are: Option<&'static str>,
    error_by_tolerance: Option<f64>,
    good_enough: bool,
    verdict: String,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Impact<'a> {
    who: Vec<String>,
    regime: &'a str,
    /// which one struck, from 1, of a body that has corners
    #[serde(skip_serializing_if = "Option::is_none")]
    corner: Option<usize>,
    #[serde(flatten)]
    numbers: Numbers<'a>,
    after: Vec<State<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct State<'a> {
    id: String,
    #[serde(flatten)]
    numbers: Numbers<'a>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct End<'a> {
    impacts: u64,
    #[serde(flatten)]
    numbers: Numbers<'a>,
    bodies: Vec<State<'a>>,
}

/// What the scene states, at its nominal values.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Stated<'a> {
    sha256: &'a str,
    #[serde(flatten)]
    coefficients: Numbers<'a>,
    walls: Vec<Wall<'a>>,
    /// only where something is stated of single contacts
    #[serde(skip_serializing_if = "Vec::is_empty")]
    contacts: Vec<Contact<'a>>,
    /// of a body that is not round, from its centre of mass at the start
    #[serde(skip_serializing_if = "Vec::is_empty")]
    corners: Vec<Numbers<'a>>,
    bodies: Vec<State<'a>>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Contact<'a> {
    between: Option<Vec<String>>,
    #[serde(flatten)]
    numbers: Numbers<'a>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    by_speed: Vec<Numbers<'a>>,
}

impl<'a> Contact<'a> {
    fn of(terms: &'a Terms<Shown>) -> Self {
        let mut pairs: Vec<_> = terms.friction.iter().map(|mu| ("friction", mu)).collect();
        let mut by_speed = Vec::new();
        match &terms.restitution {
            None => {}
            Some(Restitution::Constant(e)) => pairs.push(("restitution", e)),
            Some(Restitution::QuarterPower { speed, value }) => {
                pairs.extend([("restitution", value), ("restitution_at_m_s", speed)]);
            }
            Some(Restitution::Table(points)) => {
                by_speed = points
                    .iter()
                    .map(|[speed, e]| Numbers {
                        pairs: vec![("speed_m_s", speed), ("restitution", e)],
                        exact: true,
                    })
                    .collect();
            }
        }
        let numbers = Numbers { pairs, exact: true };
        Self { between: terms.between.map(ids), numbers, by_speed }
    }
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Wall<'a> {
    id: &'static str,
    #[serde(flatten)]
    numbers: Numbers<'a>,
}

/// Numbers by their names, and beside them, where the model's are exact, the same as fractions.
struct Numbers<'a> {
    pairs: Vec<(&'static str, &'a Shown)>,
    exact: bool,
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Numbers<'_> {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Numbers".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "type": "object",
            "properties": {
                "exact": { "type": "object", "additionalProperties": { "type": "string" } }
            },
            "additionalProperties": { "type": ["number", "null"] }
        })
    }
}

impl Serialize for Numbers<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (name, number) in &self.pairs {
            // zero has no sign here
            let value = if number.value == 0.0 { 0.0 } else { number.value };
            map.serialize_entry(name, &value)?;
        }
        if self.exact {
            let exact: Vec<_> =
                self.pairs.iter().map(|(name, number)| (*name, number.text.as_str())).collect();
            map.serialize_entry("exact", &Texts(exact))?;
        }
        map.end()
    }
}

struct Texts<'a>(Vec<(&'static str, &'a str)>);

impl Serialize for Texts<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}

/// The numbers of a body in motion.
fn motion(body: &Round<Shown>) -> Vec<(&'static str, &Shown)> {
    let ([x, y], after) = (&body.position, &body.motion);
    let mut numbers = vec![
        ("x_m", x),
        ("y_m", y),
        ("v_x_m_s", &after.vx),
        ("v_y_m_s", &after.vy),
        ("omega_rad_s", &after.omega),
    ];
    numbers.extend(body.off_plane.iter().flat_map(|off| {
        [
            ("z_m", &off.z),
            ("v_z_m_s", &off.vz),
            ("omega_x_rad_s", &off.omega_x),
            ("omega_y_rad_s", &off.omega_y),
        ]
    }));
    numbers
}

fn state(index: usize, body: &Round<Shown>, exact: bool) -> State<'_> {
    State { id: body_id(index), numbers: Numbers { pairs: motion(body), exact } }
}

/// What the scene states, number by number: of what, its name with its unit, and the number.
pub(super) fn stated_rows(answer: &Answer) -> Vec<(String, &'static str, f64)> {
    let stated = stated(answer);
    let mut rows = Vec::new();
    let mut add = |of: &str, numbers: &Numbers<'_>| {
        rows.extend(numbers.pairs.iter().map(|(name, shown)| (of.to_owned(), *name, shown.value)));
    };
    add("all", &stated.coefficients);
    for wall in &stated.walls {
        add(wall.id, &wall.numbers);
    }
    for contact in &stated.contacts {
        let of = contact.between.as_ref().map_or_else(|| "all".to_owned(), |ids| ids.join(", "));
        add(&of, &contact.numbers);
        for numbers in &contact.by_speed {
            add(&of, numbers);
        }
    }
    for (number, corner) in (1..).zip(&stated.corners) {
        add(&format!("corner-{number}"), corner);
    }
    for body in &stated.bodies {
        add(&body.id, &body.numbers);
    }
    rows
}

fn stated<'a>(answer: &'a Answer) -> Stated<'a> {
    // what is stated is exact, whatever the model makes of it
    let of = |pairs| Numbers { pairs, exact: true };
    let mut stated = Stated {
        sha256: &answer.sha256,
        coefficients: of(vec![]),
        walls: Vec::new(),
        contacts: Vec::new(),
        corners: Vec::new(),
        bodies: Vec::new(),
    };
    let body = |index: usize, pairs| State { id: body_id(index), numbers: of(pairs) };
    match &answer.stated {
        Setup::Bodies(world) => {
            stated.coefficients = of(vec![
                ("friction", &world.friction),
                ("restitution", &world.restitution),
                ("gravity_m_s2", &world.gravity),
            ]);
            if world.rolling.value != 0.0 {
                stated.coefficients.pairs.push(("rolling_resistance", &world.rolling));
            }
            if let Some(air) = &world.air {
                stated.coefficients.pairs.extend([
                    ("density_kg_m3", &air.density),
                    ("drag_coefficient", &air.drag),
                    ("lift_coefficient", &air.lift),
                ]);
            }
            let walls = world.walls.iter();
            stated.walls = walls
                .map(|wall| Wall { id: wall.side.id(), numbers: of(vec![("at_m", &wall.at)]) })
                .collect();
            for (plane, number) in world.planes.iter().zip(0..) {
                let Plane { normal: [nx, ny], through: [x, y], velocity: [along, out] } = plane;
                let numbers = of(vec![
                    ("normal_x", nx),
                    ("normal_y", ny),
                    ("through_x_m", x),
                    ("through_y_m", y),
                    ("sliding_m_s", along),
                    ("advancing_m_s", out),
                ]);
                stated.walls.push(Wall { id: Side::Plane(number).id(), numbers });
            }
            stated.contacts = world.terms.iter().map(Contact::of).collect();
            let bodies = world.bodies.iter().enumerate();
            stated.bodies = bodies
                .map(|(index, round)| {
                    let Round { mass, inertia, radius, .. } = round;
                    let mut pairs = vec![("mass_kg", mass), ("inertia_kg_m2", inertia)];
                    if world.corners.is_none() {
                        pairs.insert(1, ("radius_m", radius));
                    }
                    pairs.extend(motion(round));
                    body(index, pairs)
                })
                .collect();
            let corners = world.corners.iter().flat_map(|corners| &corners.0);
            stated.corners = corners.map(|[x, y]| of(vec![("x_m", x), ("y_m", y)])).collect();
        }
        Setup::Tip(tip) => {
            stated.coefficients =
                of(vec![("friction", &tip.friction), ("restitution", &tip.restitution)]);
            let pairs = match &tip.body {
                TipBody::Rod { mass, length, motion, .. } => vec![
                    ("mass_kg", mass),
                    ("length_m", length),
                    ("v_x_m_s", &motion.vx),
                    ("v_y_m_s", &motion.vy),
                    ("omega_rad_s", &motion.omega),
                ],
                TipBody::Pendulum { mass, length, speeds: [first, second], .. } => vec![
                    ("mass_kg", mass),
                    ("length_m", length),
                    ("u1_rad_s", first),
                    ("u2_rad_s", second),
                ],
            };
            stated.bodies = vec![body(0, pairs)];
        }
    }
    stated
}

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> serde_json::Value {
    crate::envelope::schema_enveloped::<File<'static>>("kane scene")
}

/// The report as JSON, ended by a line feed. Numbers are numbers; where the model's are exact, fractions
/// stand beside them.
#[must_use]
pub fn json(report: &SceneReport<'_>) -> String {
    let answer = report.answer;
    let exact = answer.shown.system == System::Rational;
    let of = |pairs| Numbers { pairs, exact };
    let known = answer.known.map(Known::id);
    let file = File {
        title: &report.title,
        headline: report.headline(),
        chosen: answer.chosen.map(|model| model.to_string()),
        shown: answer.shown.to_string(),
        asked: answer
            .lines
            .iter()
            .map(|line| Asked {
                quantity: line.quantity.to_string(),
                unit: line.quantity.unit(),
                value: line.value,
                exact: line.exact.as_deref(),
                error: line.error,
                error_is: known,
                tolerance: line.tolerance,
                inputs_move_it_by: line.spread.map(|spread| spread.by),
                inputs_are: line
                    .spread
                    .map(|spread| if spread.enclosed { "enclosed" } else { "at corners" }),
            })
            .collect(),
        reasons: &answer.reasons,
        models: answer
            .judged
            .iter()
            .map(|judged| Tried {
                model: judged.model.to_string(),
                cost: judged.cost,
                cost_is: if judged.model.mechanics.is_counted() { "counted" } else { "estimated" },
                errors: judged.errors.clone(),
                errors_are: judged.ratio.and(known),
                error_by_tolerance: judged.ratio,
                good_enough: judged.verdict == kane_scene::Verdict::Meets,
                verdict: verdict(&judged.verdict, answer.known),
            })
            .collect(),
        scene: stated(answer),
        kinetic_energy_at_start_j: answer.start_energy,
        impacts: answer
            .bounces
            .iter()
            .map(|bounce| {
                let who = ids(bounce.encounter);
                let struck = std::iter::once(&bounce.after.0).chain(&bounce.after.1);
                let mut numbers = of(vec![
                    ("time_s", &bounce.time),
                    ("v_t_before_m_s", &bounce.slip[0]),
                    ("v_t_after_m_s", &bounce.slip[1]),
                    ("approach_m_s", &bounce.approach),
                    ("separation_m_s", &bounce.separation),
                    ("p_t_n_s", &bounce.impulse.tangential),
                    ("p_n_n_s", &bounce.impulse.normal),
                    ("normal_j", &bounce.ledger.normal),
                    ("tangential_j", &bounce.ledger.tangential),
                    ("rotational_j", &bounce.ledger.rotational),
                    ("gravity_j", &bounce.gravity),
                ]);
                numbers.pairs.extend(bounce.air.iter().map(|air| ("air_j", air)));
                let turned = bounce.corner.iter().map(|(_, angle)| ("turned_rad", angle));
                numbers.pairs.extend(turned);
                numbers.pairs.extend(bounce.axes.iter().flat_map(|axes| {
                    let [[tx, ty, tz], [nx, ny, nz]] = axes;
                    [
                        ("tangent_x", tx),
                        ("tangent_y", ty),
                        ("tangent_z", tz),
                        ("normal_x", nx),
                        ("normal_y", ny),
                        ("normal_z", nz),
                    ]
                }));
                Impact {
                    regime: bounce.regime,
                    corner: bounce.corner.as_ref().map(|(corner, _)| corner + 1),
                    numbers,
                    after: bounce
                        .bodies()
                        .zip(struck)
                        .map(|(index, body)| state(index, body, exact))
                        .collect(),
                    who,
                }
            })
            .collect(),
        end: answer.end.as_ref().map(|end| End {
            impacts: end.impacts,
            numbers: of(std::iter::once(("time_s", &end.time))
                .chain(end.turned.iter().map(|angle| ("turned_rad", angle)))
                .collect()),
            bodies: end
                .bodies
                .iter()
                .enumerate()
                .map(|(index, body)| state(index, body, exact))
                .collect(),
        }),
    };
    enveloped(Schema { name: "kane-scene", version: 2 }, &report.command, file)
}
