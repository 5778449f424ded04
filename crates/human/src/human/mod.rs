//! The virtual human: what it can do, where it stands, what space its body takes.
//!
//! The way through this floor, once for each 200 ms action: an [`Action`] is a [`Walk`] and a [`Posture`];
//! [`walk::Walker`] turns the walk into ten exact [`Place`]s, stopping at obstacles; [`posture::cut_back`] says how far
//! the bend gets at each of them; [`Body::placed`] gives the capsules there; [`shoulder::is_available`] says which arm
//! may be searched for a contact.
//!
//! Knows obstacles as boxes, and nothing of robots, sensors or FMUs. World frame: z up, floor at z = 0. Frames of the
//! body: x forward, y left, z up. Metres and radians inside.

pub mod action;
pub mod arm;
pub(crate) mod arrangement;
mod bend;
pub mod body;
mod control;
pub(crate) mod distance_field;
pub mod floor;
pub mod inwards;
pub mod low;
mod obstacles;
pub(crate) mod part;
pub(crate) mod place;
pub(crate) mod placed;
pub(crate) mod pose_box;
pub mod posture;
pub(crate) mod presses;
pub mod reach;
pub(crate) mod repertoire;
pub mod shoulder;
pub mod walk;
pub(crate) mod who;

pub use action::{Action, Posture, Walk};
pub use arrangement::Arrangement;
pub use bend::BendFraction;
pub use body::{Anthropometry, Body, Radii};
pub use control::{ControlKind, ControlledBy};
pub use distance_field::DistanceField;
pub use floor::{Floor, has_room_throughout, is_without_room};
pub use inwards::Inwards;
pub use obstacles::{capsule_hits, is_kept_from};
pub use part::{BodyPart, Side};
pub use place::{Place, Start};
pub use placed::PlacedBody;
pub use pose_box::PoseBox;
pub use presses::Presses;
pub use repertoire::{Ability, Repertoire};
pub use who::Who;
