//! What people may come to while an FMU shows its behaviours, in place of all histories: the robots at each, and for how long somebody may
//! have been where.

use super::instants::{Instant, Instants};
use super::reading_regions::ReadingRegions;
use crate::search::behaviours::stays::Stays;
use crate::search::behaviours::{Behaviours, Number};
use crate::stop::Stop;

/// So many behaviours are gone through from one look at the clock to the next.
const LOOK_AFTER: Number = 64;

/// Takes in all that people may come to, by the outputs that each behaviour shows; nothing, where there is no time for it. Told speeds are
/// compared with the motion where `compares`: what only nearly stands for something says nothing of that.
pub fn seen_by<'o>(
    instants: &mut Instants<'_>,
    found: &Behaviours,
    (stays, zones): (&Stays, &ReadingRegions),
    (outputs, compares): (&dyn Fn(Number) -> &'o [f64], bool),
    stop: &Stop,
) -> Option<()> {
    let rows = instants.compared_rows();
    #[expect(clippy::cast_possible_truncation, reason = "fewer than are allowed")]
    for number in 0..found.count() as Number {
        if number.is_multiple_of(LOOK_AFTER) && stop.is_due() {
            return None;
        }
        let before = outputs(number);
        let step = found.depth(number) + 1;
        for reading in 0..found.readings() {
            let Some(next) = found.next(number, reading) else { continue };
            let after = outputs(next);
            let mut is_first = true;
            let all = zones.ways.iter().enumerate().filter(|(_, way)| way.to == reading);
            for (way, of) in all {
                let Some(stay) = stays.of(number, way) else { continue };
                if std::mem::take(&mut is_first) && compares {
                    let told = rows_before((outputs, found), number, after, rows.min(step + 1).max(2));
                    instants.compare_speeds(&told.0, told.1, step);
                }
                let lasting = stay.lasting(of.unchanged);
                instants.look(
                    before,
                    after,
                    &Instant { step, way, lasting, story: Default::default(), came: Some(number) },
                );
            }
        }
    }
    Some(())
}

/// The last so many rows of outputs on the way to a behaviour, and then these.
fn rows_before<'o>(
    (outputs, found): (&dyn Fn(Number) -> &'o [f64], &Behaviours),
    mut number: Number,
    then: &'o [f64],
    count: usize,
) -> (Vec<f64>, usize) {
    let mut rows = vec![then];
    while rows.len() < count {
        rows.push(outputs(number));
        let Some(before) = found.before(number) else { break };
        number = before;
    }
    (rows.iter().rev().flat_map(|row| row.iter().copied()).collect(), rows.len())
}
