//! What a wall is called.

/// A world has no more planes.
pub const MOST_PLANES: usize = 8;

/// The side on which a wall bounds the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// below
    Floor,
    /// above
    Ceiling,
    /// at the least x
    Left,
    /// at the greatest x
    Right,
    /// at the least z
    Back,
    /// at the greatest z
    Front,
    /// a [`Plane`](crate::Plane), by its index
    Plane(u8),
}

/// The ids of planes.
const PLANES: [&str; 8] =
    ["wall-1", "wall-2", "wall-3", "wall-4", "wall-5", "wall-6", "wall-7", "wall-8"];
/// In words.
const PLANES_IN_WORDS: [&str; 8] =
    ["wall 1", "wall 2", "wall 3", "wall 4", "wall 5", "wall 6", "wall 7", "wall 8"];

impl Side {
    /// Its id in files for programs.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Floor => "floor",
            Self::Ceiling => "ceiling",
            Self::Left => "left",
            Self::Right => "right",
            Self::Back => "back",
            Self::Front => "front",
            Self::Plane(index) => PLANES[(index as usize) % MOST_PLANES],
        }
    }

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Floor => "floor",
            Self::Ceiling => "ceiling",
            Self::Left => "left wall",
            Self::Right => "right wall",
            Self::Back => "back wall",
            Self::Front => "front wall",
            Self::Plane(index) => PLANES_IN_WORDS[(index as usize) % MOST_PLANES],
        }
    }
}
