//! The `zone` of a sensor as a cell file has it, for the kind that reads it: what is read is checked, and a mistake is shown where it
//! stands.

use super::DetectionZone;
use super::zone::upright;
use crate::cell::CellError;
use crate::geometry::Cuboid;

type Result<T> = std::result::Result<T, Box<CellError>>;

/// A zone table.
pub trait Written {
    /// Name of the sensor.
    fn name(&self) -> &str;

    /// `polygon_m`: at least three corners in a workshop, whose edges do not cross.
    ///
    /// # Errors
    /// Where it is none.
    fn polygon_m(&self) -> Result<Vec<[f64; 2]>>;

    /// `line_m`.
    fn line_m(&self) -> Option<[[f64; 2]; 2]>;

    /// `heights_m`.
    fn heights_m(&self) -> Option<[f64; 2]>;

    /// `height_m`.
    fn height_m(&self) -> Option<f64>;

    /// Lengths and coordinates are those of a workshop.
    ///
    /// # Errors
    /// Where one is not.
    fn of_a_workshop(&self, lengths_m: &[f64], what: &str) -> Result<()>;

    /// What is wrong, and what to do.
    fn wrong(&self, message: String, help: &str) -> Box<CellError>;
}

/// The polygon on the floor.
pub(super) fn floor(zone: &dyn Written) -> Result<DetectionZone> {
    Ok(DetectionZone::Floor(zone.polygon_m()?))
}

/// The upright plane of what is called `what`: `line_m` and `heights_m`.
pub(super) fn plane(zone: &dyn Written, what: &str) -> Result<Cuboid> {
    let what = format!("{what} `{}`", zone.name());
    let (Some(line), Some([low, high])) = (zone.line_m(), zone.heights_m()) else {
        return Err(zone.wrong(
            format!("{what} needs `line_m` and `heights_m`"),
            "zone = { line_m = [[-0.5, 0], [0.5, 0]], heights_m = [0, 1.8] }",
        ));
    };
    zone.of_a_workshop(&line.concat(), &what)?;
    let plane = upright(line, [low, high]);
    let sound = plane.half.x.is_finite() && plane.half.x > 0.0 && low >= 0.0 && high > low && high < 10.0;
    if !sound {
        return Err(zone.wrong(format!("the plane of {what} has no extent"), "two ends, two heights, in m"));
    }
    Ok(plane)
}
