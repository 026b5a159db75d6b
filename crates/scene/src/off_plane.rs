//! What a sphere has out of the plane of x and y.

/// Place, velocity and spin of a sphere out of the plane; SI units, z = x × y.
#[derive(Clone, Debug, PartialEq)]
pub struct OffPlane<N> {
    /// The centre along z, towards who looks at the plane; m.
    pub z: N,
    /// Its velocity along z; m/s.
    pub vz: N,
    /// The spin about x, from y to z; rad/s.
    pub omega_x: N,
    /// The spin about y, from z to x; rad/s.
    pub omega_y: N,
}

impl<N> OffPlane<N> {
    /// The same in another number system.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> OffPlane<M> {
        OffPlane {
            z: to(&self.z),
            vz: to(&self.vz),
            omega_x: to(&self.omega_x),
            omega_y: to(&self.omega_y),
        }
    }
}
