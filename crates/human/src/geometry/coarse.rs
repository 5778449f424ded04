//! A polyhedron of few corners for one of many: corners of fillets and rounded edges, of which meshes have thousands, are left out.
//!
//! What is left out is no farther from the rest than told: whoever grows that by as much has everything of the polyhedron.

use std::collections::BTreeSet;

use super::Vec3;
use super::polyhedron::Polyhedron;

/// The hull of some corners of a polyhedron, of which no other is farther than `within_m`; nothing if that is no volume.
///
/// It begins with corners that reach far along axes and diagonals; as long as there is one that is farther, the farthest beyond each face
/// comes in.
pub(super) fn coarse(whole: &Polyhedron, within_m: f64) -> Option<Polyhedron> {
    let corners = whole.corners();
    let signs = [-1.0, 0.0, 1.0];
    let directions =
        signs.into_iter().flat_map(|x| signs.into_iter().flat_map(move |y| signs.map(|z| Vec3::new(x, y, z))));
    let mut taken: BTreeSet<usize> = directions.map(|direction| whole.outermost(direction)).collect();
    loop {
        let rest = Polyhedron::around(&taken.iter().map(|number| corners[*number]).collect::<Vec<_>>())?;
        let mut missing: BTreeSet<usize> = rest
            .faces()
            .filter_map(|(normal, reach)| {
                let number = whole.outermost(normal);
                (corners[number].dot(normal) - reach > within_m).then_some(number)
            })
            .collect();
        if missing.is_empty() {
            // Beyond a sharp edge a corner may be farther from the rest than from each of its faces.
            let is_far =
                |corner: Vec3| rest.outside(corner).is_some_and(|nearest| (nearest - corner).length() > within_m);
            missing.extend((0..corners.len()).filter(|number| is_far(corners[*number])));
        }
        let before = taken.len();
        taken.extend(missing);
        if taken.len() == before {
            return Some(rest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A drum with rounded edges and an egg: few corners are left, none of those left out is farther than told, and the farthest nearly is.
    #[test]
    fn what_is_left_out_is_no_farther_than_told() {
        let turns =
            |count: u32| (0..count).map(move |n| libm::sincos(f64::from(n) * std::f64::consts::TAU / f64::from(count)));
        let egg: Vec<Vec3> = turns(80)
            .flat_map(|(s, c)| turns(80).map(move |(y, x)| Vec3::new(0.3 * c, 0.1 * s * x, 0.1 * s * y)))
            .collect();
        let drum: Vec<Vec3> = turns(100)
            .flat_map(|(y, x)| {
                turns(40).map(move |(s, c)| {
                    Vec3::new((0.2 + 0.02 * c) * x, (0.2 + 0.02 * c) * y, 0.02 * s + 0.1 * s.signum())
                })
            })
            .collect();
        for points in [egg, drum] {
            let whole = Polyhedron::around(&points).unwrap();
            for (within_m, fewer) in [(0.0005, 1), (0.002, 4)] {
                let few = coarse(&whole, within_m).unwrap();
                assert!(fewer * few.corners().len() < whole.corners().len(), "{}", few.corners().len());
                let far = |point: &Vec3| few.outside(*point).map_or(0.0, |nearest| (nearest - *point).length());
                let most = points.iter().map(far).fold(0.0, f64::max);
                assert!((0.3 * within_m..=within_m).contains(&most), "{most} {within_m}");
            }
        }
    }
}
