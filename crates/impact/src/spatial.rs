//! The inverse inertia at a contact in space.

use kane_number::{Number, Ordered};

use crate::InvalidInput;
use crate::arithmetic::difference_of_products;
use crate::invalid::{finite, positive};

/// A symmetric 3×3 matrix by its six entries, in the axes x, y, z.
#[derive(Clone, Debug, PartialEq)]
pub struct Symmetric<N> {
    /// The entry of x and x.
    pub xx: N,
    /// The entry of y and y.
    pub yy: N,
    /// The entry of z and z.
    pub zz: N,
    /// The entry of x and y.
    pub xy: N,
    /// The entry of x and z.
    pub xz: N,
    /// The entry of y and z.
    pub yz: N,
}

impl<N: Number> Symmetric<N> {
    /// The matrix with the given diagonal, and zero beside it.
    #[must_use]
    pub fn diagonal([xx, yy, zz]: [N; 3]) -> Self {
        Self { xx, yy, zz, xy: N::zero(), xz: N::zero(), yz: N::zero() }
    }

    /// The matrix times a vector. Exact in exact numbers, three roundings an entry in floats.
    #[must_use]
    pub fn times(&self, [x, y, z]: &[N; 3]) -> [N; 3] {
        let row = |a: &N, b: &N, c: &N| a.clone() * x + b.clone() * y + c.clone() * z;
        [
            row(&self.xx, &self.xy, &self.xz),
            row(&self.xy, &self.yy, &self.yz),
            row(&self.xz, &self.yz, &self.zz),
        ]
    }

    /// The determinant, by the first row and the adjugate.
    pub(crate) fn determinant(&self, adjugate: &Self) -> N {
        let [determinant, _, _] =
            self.times(&[adjugate.xx.clone(), adjugate.xy.clone(), adjugate.xz.clone()]);
        determinant
    }

    /// The same matrix in another number system.
    fn map<M>(&self, to: impl Fn(&N) -> M) -> Symmetric<M> {
        Symmetric {
            xx: to(&self.xx),
            yy: to(&self.yy),
            zz: to(&self.zz),
            xy: to(&self.xy),
            xz: to(&self.xz),
            yz: to(&self.yz),
        }
    }

    /// The determinant times the inverse.
    pub(crate) fn adjugate(&self) -> Self {
        let minor = difference_of_products::<N>;
        Self {
            xx: minor(&self.yy, &self.zz, &self.yz, &self.yz),
            yy: minor(&self.xx, &self.zz, &self.xz, &self.xz),
            zz: minor(&self.xx, &self.yy, &self.xy, &self.xy),
            xy: minor(&self.xz, &self.yz, &self.xy, &self.zz),
            xz: minor(&self.xy, &self.yz, &self.xz, &self.yy),
            yz: minor(&self.xy, &self.xz, &self.yz, &self.xx),
        }
    }
}

/// a × b
fn cross<N: Number>([a, b, c]: &[N; 3], [x, y, z]: &[N; 3]) -> [N; 3] {
    let entry = difference_of_products::<N>;
    [entry(b, z, c, y), entry(c, x, a, z), entry(a, y, b, x)]
}

/// The Delassus operator of one rigid body in space, a symmetric positive definite 3×3 matrix; 1/kg.
///
/// It maps an impulse at the contact, N·s, to the change of the velocity of the contact point, m/s:
///
/// ```text
/// W = 1/m·1 − [c]×·J⁻¹·[c]×      W·p = p/m + (J⁻¹·(c × p)) × c
/// ```
///
/// with the mass m, the inertia tensor J about the centre of mass, and the lever c from the centre
/// of mass to the contact point. x and z are tangents, y is the normal, out of the obstacle and into
/// the body, and z = x × y; so the entries of x and y are the planar [`Delassus`](crate::Delassus)
/// of a body that moves in that plane. Of a homogeneous sphere W is diagonal, (1/m + r²/J, 1/m,
/// 1/m + r²/J): why its collision is planar is told in `docs/derivations/spatial-sphere.md`.
#[derive(Clone, Debug, PartialEq)]
pub struct SpatialDelassus<N> {
    entries: Symmetric<N>,
}

impl<N: Ordered> SpatialDelassus<N> {
    /// Forms W from m > 0 (kg), a positive definite J (kg·m²) and c (m).
    ///
    /// Exact in exact numbers. Heuristic in floats: the entries of J⁻¹ may cancel.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first condition that does not certainly hold. That J is positive
    /// definite is asked of its leading minors; that no principal moment exceeds the sum of the
    /// others is not asked.
    pub fn of_body(
        mass: N,
        inertia: &Symmetric<N>,
        lever: &[N; 3],
    ) -> Result<Self, InvalidInput<N>> {
        let mass = positive("the mass", mass)?;
        for c in lever {
            finite("the lever", c.clone())?;
        }
        positive("the moment of inertia about x", inertia.xx.clone())?;
        let adjugate = inertia.adjugate();
        positive("the minor of the inertia tensor in x and y", adjugate.zz.clone())?;
        let determinant = inertia.determinant(&adjugate);
        let determinant = positive("the determinant of the inertia tensor", determinant)?;
        let column = |p: [N; 3]| {
            let [x, y, z] = adjugate.times(&cross(lever, &p));
            let spin = [x / &determinant, y / &determinant, z / &determinant];
            let [a, b, c] = cross(&spin, lever);
            let [x, y, z] = p.map(|p| p / &mass);
            [a + x, b + y, c + z]
        };
        let (one, zero) = (N::one, N::zero);
        let [xx, xy, xz] = column([one(), zero(), zero()]);
        let [_, yy, yz] = column([zero(), one(), zero()]);
        let [_, _, zz] = column([zero(), zero(), one()]);
        Ok(Self { entries: Symmetric { xx, yy, zz, xy, xz, yz } })
    }
}

impl<N: Number> SpatialDelassus<N> {
    /// The entries; 1/kg.
    #[must_use]
    pub const fn entries(&self) -> &Symmetric<N> {
        &self.entries
    }

    /// The change of the velocity of the contact point by an impulse (N·s) there; m/s.
    #[must_use]
    pub fn change(&self, impulse: &[N; 3]) -> [N; 3] {
        self.entries.times(impulse)
    }

    /// The same operator in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> SpatialDelassus<M> {
        SpatialDelassus { entries: self.entries.map(to) }
    }
}
