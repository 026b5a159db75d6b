//! Routh's diagram of an impact, with the ends of laws.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::{Event, ImpulsePlane, PlaneLine};

use super::{WIDTH, brief, notes_of};
use crate::picture::{
    Anchor, Axis, Callout, Canvas, Frame, Ink, Key, Panel, Pen, Point, Shape, WORDS, broken,
    callouts, legend, mark,
};

const HEIGHT: f64 = 520.0;
const PATH: Pen = Pen::new(Ink::VERMILION, 3.0);
const ENERGY: Pen = Pen::new(Ink::Text, 1.5);
/// Ids of laws in a line.
const COLUMNS: usize = 34;

const fn look(line: PlaneLine) -> (Key, &'static str) {
    match line {
        PlaneLine::Cone => (Key::Line(Pen::new(Ink::GREY, 2.0)), "friction cone"),
        PlaneLine::Stick => (Key::Line(Pen::new(Ink::GREEN, 2.0).dashed("8 4")), "no slip"),
        PlaneLine::Compression => {
            (Key::Line(Pen::new(Ink::BLUE, 2.0).dashed("3 4")), "greatest compression")
        }
    }
}

const fn words(event: Event) -> &'static str {
    match event {
        // it is the origin
        Event::Start => "",
        Event::Stick => "sticks",
        Event::Reverse => "slides back",
        Event::Compressed => "compression ends",
        Event::End => "impulse",
    }
}

/// The impact in the plane of its impulse, as SVG.
pub(crate) fn drawn_impulse(title: &str, command: &str, plane: &ImpulsePlane) -> String {
    let [low, high] = plane.frame;
    let is_inside = |end: &[f64; 2]| (0..2).all(|k| (low[k]..=high[k]).contains(&end[k]));
    let (inside, outside): (Vec<_>, Vec<_>) =
        plane.ends.iter().partition(|(_, end)| is_inside(end));
    let beyond: Vec<&str> = outside.iter().flat_map(|(ids, _)| ids.iter().copied()).collect();
    let note = match beyond[..] {
        [] => String::new(),
        _ => format!("Outside of the sheet: {}.", beyond.join(", ")),
    };
    let mut canvas =
        Canvas::new((WIDTH, HEIGHT), &format!("{title}: its impulse"), &notes_of(command, &note));
    let lines = [PlaneLine::Cone, PlaneLine::Stick, PlaneLine::Compression].map(look);
    let mut keys = lines.to_vec();
    keys.push((Key::Line(ENERGY), "equal energy: inside it is lost"));
    if !plane.path.is_empty() {
        keys.push((Key::Line(PATH), "the impulse as it grows"));
    }
    if !inside.is_empty() {
        keys.push((Key::Mark(Shape::Ring, Ink::Text), "where laws end"));
    }
    let top = legend(&mut canvas, (66.0, 0.0), WIDTH - 66.0, &keys);
    let axes = (
        Axis::linear("tangential impulse p_t, N·s", (low[0], high[0]), brief),
        Axis::linear("normal impulse p_n, N·s", (low[1], high[1]), brief),
    );
    let frame = Frame { at: (0.0, top), size: (WIDTH, HEIGHT - top), head: 10.0, beside: 14.0 };
    let panel = Panel::new(&mut canvas, frame, axes, "");
    let pair = |[x, y]: [f64; 2]| (x, y);
    let curve: Vec<Point> = plane.equal_energy.iter().map(|point| pair(*point)).collect();
    panel.line(&mut canvas, curve.iter().copied(), ENERGY);
    for (line, ends) in &plane.lines {
        if let (Key::Line(pen), _) = look(*line) {
            panel.line(&mut canvas, ends.map(pair), pen);
        }
    }
    let points: Vec<Point> = plane.path.iter().map(|(_, point)| pair(*point)).collect();
    panel.line(&mut canvas, points.iter().copied(), PATH);
    let mut taken = vec![panel.places(curve), panel.places(points)];
    let mut places: Vec<Point> = Vec::new();
    for (event, [x, y]) in &plane.path {
        let Some(at) = panel.at((*x, *y)) else { continue };
        canvas.dot(at, 4.0, PATH.ink);
        // beside the point, away from the axis of the cone
        let (beside, anchor) =
            if *x < 0.0 { (at.0 - 12.0, Anchor::End) } else { (at.0 + 12.0, Anchor::Start) };
        canvas.words((beside, at.1), words(*event), WORDS, anchor);
        let way = if *x < 0.0 { -1.0 } else { 1.0 };
        let end = beside + way * crate::picture::length(words(*event), WORDS);
        taken.push(vec![(beside, at.1), (end, at.1)]);
        places.push(at);
    }
    let named = |(ids, end): &&(Vec<&'static str>, [f64; 2])| {
        let lines = broken(&ids.join(", "), COLUMNS);
        Some(Callout { at: panel.at(pair(*end))?, lines, ink: Ink::Text })
    };
    let named: Vec<Callout> = inside.iter().filter_map(named).collect();
    places.extend(named.iter().map(|callout| callout.at));
    taken.extend(plane.lines.iter().map(|(_, ends)| panel.places(ends.map(pair))));
    callouts(&mut canvas, &panel.window, (&places, &taken), &named);
    for callout in &named {
        mark(&mut canvas, callout.at, Shape::Ring, Ink::Text);
    }
    canvas.finish()
}
