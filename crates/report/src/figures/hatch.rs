//! Hatching: what tells zones apart without colour.

use super::pixels::{Pixel, Window};

/// Which way the lines go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hatch {
    Rising,
    Falling,
}

impl Hatch {
    /// Diagonal lines over the part of a window where `is_inside` holds.
    pub(super) fn lines(
        self,
        window: &Window,
        spacing: i32,
        is_inside: impl Fn(Pixel) -> bool,
    ) -> Vec<[Pixel; 2]> {
        let (width, height) = (window.right - window.left, window.bottom - window.top);
        let Ok(step) = usize::try_from(spacing) else { return Vec::new() };
        let mut lines = Vec::new();
        for start in (-height..width).step_by(step.max(1)) {
            let mut run: Option<[Pixel; 2]> = None;
            for t in 0..=height {
                let y = match self {
                    Self::Falling => window.top + t,
                    Self::Rising => window.bottom - t,
                };
                let at = (window.left + start + t, y);
                if window.holds(at) && is_inside(at) {
                    let first = run.map_or(at, |[first, _]| first);
                    run = Some([first, at]);
                } else {
                    lines.extend(run.take());
                }
            }
            lines.extend(run);
        }
        lines.retain(|[from, to]| from != to);
        lines
    }
}
