//! Points in files, as three numbers: `#[serde(with = "coordinates")]`.

use serde::{Deserialize as _, Deserializer, Serialize as _, Serializer};

use super::Vec3;

/// Writes x, y, z.
///
/// # Errors
/// When the file cannot be written.
pub fn serialize<S: Serializer>(point: &Vec3, to: S) -> Result<S::Ok, S::Error> {
    point.to_array().serialize(to)
}

/// Reads x, y, z.
///
/// # Errors
/// When there are no three numbers.
pub fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Vec3, D::Error> {
    <[f64; 3]>::deserialize(from).map(Vec3::from_array)
}
