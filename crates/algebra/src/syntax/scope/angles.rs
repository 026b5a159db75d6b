//! Angles, and the cosine and the sine that stand for them.

use kane_kernel::Var;

use super::super::names::latex_name;
use super::{Angle, DeclareError, Scope, spelled};

impl Scope {
    /// Declares a symbol as an angle, with cosine and sine of one of its equal parts; of the variable of a
    /// limit these are functions.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_angle(
        &mut self,
        var: Var,
        parts: u32,
        limited: bool,
    ) -> Result<(usize, Angle), DeclareError> {
        let part = if parts == 1 { var.name.clone() } else { format!("{}/{parts}", var.name) };
        let point = ["cos", "sin"].map(|f| Var {
            name: format!("{f}({part})"),
            of: if limited { Some(self.context.vars.len()) } else { var.of },
            lower: None,
            upper: None,
        });
        for var in &point {
            self.check_free(&spelled(&var.name))?;
        }
        let index = self.declare(var)?;
        let [cos, sin] = point.map(|var| {
            self.typeset.entry(latex_name(&spelled(&var.name))).or_insert_with(|| var.name.clone());
            self.declare(var)
        });
        let angle = Angle { cos: cos?, sin: sin?, parts };
        self.angles.insert(index, angle);
        Ok((index, angle))
    }

    /// Has an angle stand by itself, too, as the number of its radians.
    pub fn declare_measured(&mut self, angle: usize) {
        self.measured.insert(angle);
    }

    /// Whether a symbol is an angle that is known by its direction alone.
    #[must_use]
    pub fn is_unmeasured(&self, symbol: usize) -> bool {
        self.angle(symbol).is_some() && !self.measured.contains(&symbol)
    }

    /// The angles that stand by themselves, with what stands for them.
    pub fn measured(&self) -> impl Iterator<Item = (usize, Angle)> {
        self.measured.iter().filter_map(|v| Some((*v, *self.angle(*v)?)))
    }

    /// All angles with what stands for them, in no particular order.
    pub fn angles(&self) -> impl Iterator<Item = (usize, Angle)> {
        self.angles.iter().map(|(symbol, angle)| (*symbol, *angle))
    }

    /// What stands for a symbol, if it is an angle.
    #[must_use]
    pub fn angle(&self, symbol: usize) -> Option<&Angle> {
        self.angles.get(&symbol)
    }

    /// The angle of which a symbol is the cosine or the sine, and its symbol.
    #[must_use]
    pub fn angle_at(&self, symbol: usize) -> Option<(usize, Angle)> {
        self.angles().find(|(_, angle)| [angle.cos, angle.sin].contains(&symbol))
    }
}
