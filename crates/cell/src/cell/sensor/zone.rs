//! How a person is detected. Both searches, pictures and advice know these ways and no product: a new kind of sensor that detects people
//! in one of them is known to all at once.

use crate::geometry::{Cuboid, Vec3, rotation_about};

/// Where a sensor detects people, and by what of them.
#[derive(Clone, Debug, PartialEq)]
pub enum DetectionZone {
    /// A polygon on the floor, m: feet, and what else of a person is on the floor.
    Floor(Vec<[f64; 2]>),
    /// An upright plane, as a box without thickness: any part of a person that is in it, arms as well.
    Plane(Cuboid),
    /// The post of somebody whose hands are held: reports unless both feet are at it and both hands where they belong.
    Post {
        /// Polygon on the floor, m, in which its operator's feet are.
        post: Vec<[f64; 2]>,
        /// The upright plane that no hand passes that is held.
        plane: Cuboid,
    },
    /// Inside the FMU, which alone knows.
    InFmu,
}

impl DetectionZone {
    /// The plane that arms do not pass unseen, and for a post, where its operator stands.
    #[must_use]
    pub fn plane(&self) -> Option<(&Cuboid, Option<&[[f64; 2]]>)> {
        match self {
            Self::Plane(plane) => Some((plane, None)),
            Self::Post { post, plane } => Some((plane, Some(post))),
            Self::Floor(_) | Self::InFmu => None,
        }
    }

    /// The plane that nobody walks or reaches through unseen.
    #[must_use]
    pub const fn walked_through(&self) -> Option<&Cuboid> {
        match self {
            Self::Plane(plane) => Some(plane),
            Self::Floor(_) | Self::Post { .. } | Self::InFmu => None,
        }
    }

    /// The floor that nobody steps on unseen.
    #[must_use]
    pub fn stepped_on(&self) -> Option<&[[f64; 2]]> {
        match self {
            Self::Floor(polygon) => Some(polygon),
            Self::Plane(_) | Self::Post { .. } | Self::InFmu => None,
        }
    }

    /// Its corners on the floor, m, where feet matter.
    #[must_use]
    pub fn corners(&self) -> Option<&[[f64; 2]]> {
        match self {
            Self::Floor(polygon) | Self::Post { post: polygon, .. } => Some(polygon),
            Self::Plane(_) | Self::InFmu => None,
        }
    }

    /// Whether it reports whoever is *not* there: nobody who walks in is kept out by it.
    #[must_use]
    pub const fn is_post(&self) -> bool {
        match self {
            Self::Post { .. } => true,
            Self::Floor(_) | Self::Plane(_) | Self::InFmu => false,
        }
    }

    /// Whether only the FMU knows what it reports.
    #[must_use]
    pub const fn is_in_fmu(&self) -> bool {
        match self {
            Self::InFmu => true,
            Self::Floor(_) | Self::Plane(_) | Self::Post { .. } => false,
        }
    }

    /// Whether it is known here to see whoever comes in over it.
    #[must_use]
    pub const fn keeps_out(&self) -> bool {
        match self {
            Self::Floor(_) | Self::Plane(_) => true,
            Self::Post { .. } | Self::InFmu => false,
        }
    }
}

/// An upright plane over a line on the floor, m, as a box without thickness.
#[must_use]
pub(in crate::cell) fn upright([from, to]: [[f64; 2]; 2], [low, high]: [f64; 2]) -> Cuboid {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    Cuboid {
        centre: Vec3::new(0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), 0.5 * (low + high)),
        half: Vec3::new(0.5 * libm::hypot(dx, dy), 0.0, 0.5 * (high - low)),
        rotation: rotation_about(Vec3::Z, libm::atan2(dy, dx)),
    }
}

/// The line of an upright plane from above, m.
#[must_use]
pub fn line(plane: &Cuboid) -> [[f64; 2]; 2] {
    let half = plane.rotation * Vec3::X * plane.half.x;
    [plane.centre - half, plane.centre + half].map(|end| [end.x, end.y])
}

/// From which height to which an upright plane reaches, m.
#[must_use]
pub fn heights(plane: &Cuboid) -> [f64; 2] {
    [plane.centre.z - plane.half.z, plane.centre.z + plane.half.z]
}
