//! Where on the floor sensors may report what, and how somebody comes from one reading to another.
//!
//! The *readings* of all sensors together change when a person, sampled at each communication step, has gone from a place of
//! one to a place of another in between. Where that happens is a strip of the floor, the same at all times. So how far somebody
//! has come since is a [`DistanceField`] made once for each pair of readings, and the set of places at any instant is where that is no
//! more than the way walked in the time.
//!
//! A control that the person works is a way of its own, on which the readings stay the same: it begins where a hand gets to the
//! control (`controls`), and who has worked it is no farther from there than the way walked since.
//!
//! Every rounding is outwards: a cell belongs to a reading when any pose in it may report it; cells are grown by a step where
//! somebody may have been elsewhere between two samples.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::readings::{may_report, may_stay_clear};
use super::{ReachabilitySearch, headings, internal_sensors};
use crate::cell::{DetectionZone, Sensor};
use crate::geometry::segment_cuboid::point_cuboid;
use crate::human::floor::of_cells;
use crate::human::{BendFraction, DistanceField, Floor, PoseBox, Posture, Presses};
use crate::search::behaviours::stays::Transitions;
use crate::search::behaviours::{Others, any};

/// More than what rounding does to a number of steps.
const ROUNDING: f64 = 1e-9;

/// Where any number of steps is looked at, it is not known of places that are farther than this how much farther they are, m.
const FAR_M: f64 = 4.0;

/// What the sensors report, one after the other.
pub type Readings = Vec<bool>;

/// A way to come to readings.
#[derive(Clone, Debug)]
pub struct ReadingTransition {
    /// The readings before, or none at the very start.
    pub from: Option<usize>,
    /// The readings.
    pub to: usize,
    /// In which part of where these are reported somebody then is, where parts are told apart.
    pub area: usize,
    /// In which part of where those before are reported they were; none if that may have been anywhere they were never seen.
    pub left: Option<usize>,
    /// Whether the readings before are those of the very start, never left.
    pub is_first: bool,
    /// Whether the readings themselves are, and were never left.
    pub unchanged: bool,
    /// Controls that the person begins to work there; the readings stay the same then.
    pub pressed: Presses,
    /// How far somebody has to go at least, from the first sample with these readings on, to be there at the step after a sample
    /// that reports them.
    pub field: Arc<DistanceField>,
}

/// See the top of this file.
#[derive(Clone, Debug)]
pub struct ReadingRegions {
    /// All readings that somebody can come to; of those that count as one, the first.
    pub readings: Vec<Readings>,
    /// What each sensor reports then; nothing where it may be either.
    pub known: Vec<Vec<Option<bool>>>,
    /// The number of each of all readings in these.
    numbers: BTreeMap<Readings, usize>,
    /// The ways to come to them; the first is to be there at the start.
    pub ways: Vec<ReadingTransition>,
    /// Of each way, those that may follow, after so many steps at least.
    next: Vec<Vec<(usize, usize)>>,
    /// Of each way, those on which controls are worked at the very sample at which it was come to.
    at_once: Vec<Vec<usize>>,
    /// How far it is at least from where somebody is at the start.
    origin: Arc<DistanceField>,
}

impl ReadingRegions {
    /// For people of whom the sensors report `first` at the start, who are on `unseen` floor then, and walk as far as `step_m` in
    /// each of so many communication steps. What sensors report that do not `matter` is left at what it is then.
    /// At most so many `presses` by the person are told apart. Nothing, where there is no time for it.
    #[must_use]
    pub fn new(
        of: &ReachabilitySearch<'_>,
        first: &[bool],
        matter: &[bool],
        (step_m, steps): (f64, usize),
        presses: u32,
    ) -> Option<Self> {
        // Nobody gets farther, with the step before the first sample and the one after the last.
        #[expect(clippy::cast_precision_loss, reason = "some thousand steps")]
        let most_m = step_m * (steps + 4) as f64;
        Self::with(of, first, matter, (step_m, most_m), (presses, presses > 0), &|all| (0..all.len()).collect())
    }

    /// The same without presses and for any number of steps, where parts of the floor on which the same is reported are told apart, if
    /// nobody gets from one to another without that something else is: so both sides of a door are. Readings that the FMU is `told` by the
    /// same number count as one.
    #[must_use]
    pub fn by_sides(
        of: &ReachabilitySearch<'_>,
        first: &[bool],
        matter: &[bool],
        step_m: f64,
        told: &dyn Fn(&[Readings]) -> Vec<usize>,
    ) -> Option<Self> {
        Self::with(of, first, matter, (step_m, FAR_M), (0, true), told)
    }

    fn with(
        of: &ReachabilitySearch<'_>,
        first: &[bool],
        matter: &[bool],
        (step_m, most_m): (f64, f64),
        (presses, by_sides): (u32, bool),
        told: &dyn Fn(&[Readings]) -> Vec<usize>,
    ) -> Option<Self> {
        let (ground, stop) = (&of.ground, &of.encounter.stop);
        let free: Vec<bool> = (0..ground.cells()).map(|cell| ground.is_open(cell)).collect();
        let all: &[BTreeSet<Readings>] = of.readings_by_cell()?;
        let as_first = |reading: &Readings| -> Readings {
            reading
                .iter()
                .zip(first)
                .zip(matter)
                .map(|((own, first), matters)| if *matters { *own } else { *first })
                .collect()
        };
        let unseen = |cell: usize| of.unseen[cell] && all[cell].contains(first);
        let unseen: Vec<bool> = (0..ground.cells()).map(unseen).collect();
        let all: Vec<BTreeSet<Readings>> = all.iter().map(|cell| cell.iter().map(as_first).collect()).collect();
        let readings: BTreeSet<&Readings> = all.iter().flatten().collect();
        let mut readings: Vec<Readings> = readings.into_iter().cloned().collect();
        readings.sort_by_key(|reading| (reading != first, reading.clone()));
        let (numbers, known) = as_one(&readings, &told(&readings));
        let mut firsts: Vec<Readings> = Vec::new();
        readings.into_iter().for_each(|one| firsts.extend((numbers[&one] == firsts.len()).then_some(one)));
        let readings = firsts;
        let all: Vec<BTreeSet<&Readings>> =
            all.iter().map(|cell| cell.iter().map(|own| &readings[numbers[own]]).collect()).collect();
        let zone = |reading: &Readings| -> Vec<bool> { all.iter().map(|of_cell| of_cell.contains(reading)).collect() };
        let zones: Vec<Vec<bool>> = readings.iter().map(zone).collect();
        let both = |a: &[bool], b: &[bool]| -> Vec<bool> { a.iter().zip(b).map(|(a, b)| *a && *b).collect() };
        let either = |a: &[bool], b: &[bool]| -> Vec<bool> { a.iter().zip(b).map(|(a, b)| *a || *b).collect() };
        // What is reported of people beyond the floor may change there.
        let entrances = of.entrances();
        let nowhere = Arc::new(DistanceField::at_once(ground, &vec![false; ground.cells()]));
        let mut this = Self {
            readings: readings.clone(),
            known,
            numbers,
            ways: Vec::new(),
            next: Vec::new(),
            at_once: Vec::new(),
            origin: nowhere,
        };
        let in_hand = of.in_hand(presses);
        if this.readings.first().is_none_or(|reading| reading != first) {
            return Some(this);
        }
        // Who presses outside of a field is not inside of it: parts that nobody gets from one to another of unreported are told apart.
        let areas: Vec<(usize, Vec<bool>)> = (0..)
            .zip(&zones)
            .flat_map(|(reading, zone)| {
                let parts = if by_sides { parts(ground, zone, &entrances, step_m) } else { vec![zone.clone()] };
                parts.into_iter().map(move |part| (reading, part))
            })
            .collect();
        let beside: Vec<Vec<bool>> = areas.iter().map(|(_, area)| both(&ground.grown(area, step_m), &free)).collect();
        // Sensors that do not matter may see them later: wherever they get to with those that do still reporting the same.
        let at_first = ground.spread(&both(&zones[0], &either(&unseen, &entrances)), &zones[0]);
        let around = both(&ground.grown(&at_first, step_m), &free);
        this.origin = Arc::new(DistanceField::from(ground, &either(&at_first, &entrances), &free, most_m, stop)?);
        let add = |this: &mut Self, way: ReadingTransition| {
            this.ways.push(way);
            this.ways.len() - 1
        };
        let first = ReadingTransition {
            from: None,
            to: 0,
            area: 0,
            left: None,
            is_first: true,
            unchanged: true,
            pressed: Presses::NONE,
            field: Arc::new(DistanceField::at_once(ground, &around)),
        };
        add(&mut this, first);
        let known = |this: &Self, wanted: &ReadingTransition| {
            let key =
                |way: &ReadingTransition| (way.from, way.left, way.area, way.is_first, way.unchanged, way.pressed);
            this.ways.iter().position(|way| key(way) == key(wanted))
        };
        let mut number = 0;
        while number < this.ways.len() {
            let ReadingTransition { to, area, field, unchanged, pressed: worked, .. } = this.ways[number].clone();
            let (mut follow, mut at_once) = (Vec::new(), Vec::new());
            let leaves = if unchanged { &at_first } else { &areas[area].1 };
            let left = (!unchanged).then_some(area);
            let near = either(&ground.grown(leaves, step_m), &entrances);
            for (other, (reading, cells)) in areas.iter().enumerate().filter(|(_, (reading, _))| *reading != to) {
                let over = [least_at(&field, leaves, &beside[other]), least_at(&field, leaves, &entrances)];
                // In a limited time nobody gets farther; else it is not known how far it is.
                let gets_there = |least: &f64| (by_sides && presses == 0) || *least < most_m;
                let least = over.into_iter().flatten().reduce(f64::min).filter(gets_there);
                let Some(least) = least else { continue };
                let way = ReadingTransition {
                    from: Some(to),
                    to: *reading,
                    area: other,
                    left,
                    is_first: unchanged,
                    unchanged: false,
                    pressed: Presses::NONE,
                    field: Arc::clone(&this.origin),
                };
                let known = match known(&this, &way) {
                    Some(known) => known,
                    None => {
                        let begins = both(cells, &near);
                        let field = Arc::new(DistanceField::from(ground, &begins, &beside[other], most_m, stop)?);
                        add(&mut this, ReadingTransition { field, ..way })
                    }
                };
                follow.push((known, steps_for(least, step_m)));
            }
            for (pressed, hand) in &in_hand {
                // Where it is not known in which part somebody is, they may be in any.
                let here = |other: &usize| areas[*other].0 == to && (unchanged || *other == area);
                for other in (0..areas.len()).filter(here) {
                    let strip = both(&both(leaves, hand), &areas[other].1);
                    let Some(least) = least_at(&field, leaves, &strip).filter(|least| *least < most_m) else {
                        continue;
                    };
                    let way = ReadingTransition {
                        from: Some(to),
                        to,
                        area: other,
                        left,
                        is_first: unchanged,
                        unchanged,
                        pressed: *pressed,
                        field: Arc::clone(&this.origin),
                    };
                    let known = match known(&this, &way) {
                        Some(known) => known,
                        None => {
                            let field = Arc::new(DistanceField::from(ground, &strip, &beside[other], most_m, stop)?);
                            add(&mut this, ReadingTransition { field, ..way })
                        }
                    };
                    // Worked at a sample, and not on the way from one to the next.
                    let steps = steps_for(least, step_m);
                    follow.push((known, steps.saturating_sub(1)));
                    // What two hands do at one sample is one way.
                    if steps == 0 && worked.is_none() {
                        at_once.push(known);
                    }
                }
            }
            this.at_once.push(at_once);
            this.next.push(follow);
            number += 1;
        }
        Some(this)
    }

    /// The number of some readings, if anybody can come to them.
    #[must_use]
    pub fn number(&self, readings: &Readings) -> Option<usize> {
        self.numbers.get(readings).copied()
    }

    /// Which readings may follow each of them, as somebody walks.
    #[must_use]
    pub fn others(&self) -> Others {
        let mut others = any(self.readings.len());
        let follows = |from: usize, to: usize| {
            let ways = self.ways.iter().zip(&self.next).filter(|(way, _)| way.to == from);
            ways.flat_map(|(_, next)| next).any(|(next, _)| self.ways[*next].to == to)
        };
        for (from, others) in others.iter_mut().enumerate() {
            others.retain(|to| follows(from, *to));
        }
        others
    }

    /// How far it is at least from where somebody is at the start.
    #[must_use]
    pub const fn origin(&self) -> &Arc<DistanceField> {
        &self.origin
    }

    /// After so many steps at most everybody is wherever they get to.
    #[must_use]
    pub fn longest(&self, step_m: f64) -> usize {
        let all = self.ways.iter().map(|way| &way.field).chain([&self.origin]);
        let farthest =
            |field: &Arc<DistanceField>| field.all().iter().copied().filter(|at| at.is_finite()).fold(0.0, f64::max);
        steps_for(all.map(farthest).fold(0.0, f64::max), step_m) + 1
    }

    /// What may follow a way, after so many steps at least.
    #[must_use]
    pub fn next(&self, way: usize) -> &[(usize, usize)] {
        &self.next[way]
    }

    /// What may be worked at the sample at which a way was come to.
    #[must_use]
    pub(crate) fn at_once(&self, way: usize) -> &[usize] {
        &self.at_once[way]
    }
}

/// The number of each of some readings where those of which the FMU is told by the same number are one, in the order of the first of them,
/// and what sensors report in all that are one.
fn as_one(all: &[Readings], told: &[usize]) -> (BTreeMap<Readings, usize>, Vec<Vec<Option<bool>>>) {
    let (mut of_told, mut known): (Vec<usize>, Vec<Vec<Option<bool>>>) = (Vec::new(), Vec::new());
    let mut numbers = BTreeMap::new();
    for (readings, told) in all.iter().zip(told) {
        let number = of_told.iter().position(|known| known == told).unwrap_or(of_told.len());
        if number == of_told.len() {
            of_told.push(*told);
            known.push(readings.iter().copied().map(Some).collect());
        }
        let differs = |(known, own): (&mut Option<bool>, &bool)| *known = known.filter(|known| known == own);
        known[number].iter_mut().zip(readings).for_each(differs);
        numbers.insert(readings.clone(), number);
    }
    (numbers, known)
}

/// The parts of some cells between which there is more than a step; who gets to one over an entrance may have left another over one.
fn parts(floor: &Floor, cells: &[bool], entrances: &[bool], step_m: f64) -> Vec<Vec<bool>> {
    let mut left = cells.to_vec();
    let mut parts = Vec::new();
    while let Some(seed) = left.iter().position(|is| *is) {
        let mut part = vec![false; cells.len()];
        part[seed] = true;
        loop {
            part = floor.spread(&part, cells);
            if part.iter().zip(entrances).any(|(own, entrance)| *own && *entrance) {
                let all = part.iter_mut().zip(cells).zip(entrances);
                all.for_each(|((own, is), entrance)| *own |= *is && *entrance);
            }
            let more: Vec<bool> = floor.grown(&part, step_m).iter().zip(cells).map(|(near, is)| *near && *is).collect();
            if more == part {
                break;
            }
            part = more;
        }
        left.iter_mut().zip(&part).for_each(|(left, own)| *left &= !own);
        parts.push(part);
    }
    parts
}

/// Steps that it takes at least to walk so far.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand steps")]
fn steps_for(least_m: f64, step_m: f64) -> usize {
    (least_m / step_m - ROUNDING).ceil().max(0.0) as usize
}

/// The least that is told of cells that are both.
fn least_at(field: &DistanceField, some: &[bool], others: &[bool]) -> Option<f64> {
    let both = (0..some.len()).filter(|cell| some[*cell] && others[*cell]);
    both.map(|cell| field.at(cell)).filter(|least| least.is_finite()).reduce(f64::min)
}

/// Without controls, which are ways of their own.
impl Transitions for ReadingRegions {
    fn begins(&self) -> Vec<usize> {
        vec![0]
    }

    fn ways(&self) -> usize {
        self.ways.len()
    }

    fn reading(&self, way: usize) -> usize {
        self.ways[way].to
    }

    fn next(&self, way: usize) -> &[(usize, usize)] {
        self.next(way)
    }

    fn is_unchanged(&self, way: usize) -> bool {
        self.ways[way].unchanged
    }
}

impl ReachabilitySearch<'_> {
    /// All that the sensors may report together of somebody; nothing, where there is no time for it.
    #[must_use]
    pub fn readings(&self) -> Option<Vec<Readings>> {
        let all: BTreeSet<&Readings> = self.readings_by_cell()?.iter().flatten().collect();
        Some(all.into_iter().cloned().collect())
    }

    /// All that the sensors may report together of somebody in each cell of the floor, with an arm in a plane or without: worked out once.
    fn readings_by_cell(&self) -> Option<&[BTreeSet<Readings>]> {
        if self.by_cell.get().is_none() {
            let of_cell = |cell: usize| self.readings_in(&self.ground, cell);
            let _ = self.by_cell.set(of_cells(self.ground.cells(), &self.encounter.stop, of_cell)?);
        }
        self.by_cell.get().map(Vec::as_slice)
    }

    fn readings_in(&self, ground: &Floor, cell: usize) -> BTreeSet<Readings> {
        let mut all = BTreeSet::new();
        if !ground.is_open(cell) {
            return all;
        }
        for (arc, (heading_rad, half_rad)) in (0..).zip(headings(internal_sensors::ARCS)) {
            let at = PoseBox { xy_m: ground.middle(cell), half_m: 0.5 * ground.cell_m(), heading_rad, half_rad };
            let body = self.placed(&at, Posture::Upright, BendFraction::FULL);
            let mut some = vec![Readings::new()];
            for sensor in &self.cell.sensors {
                let may = |reading: bool| match &sensor.zone {
                    // An arm in a plane is reported as the body is.
                    DetectionZone::Plane(_) if reading => self.is_near_plane(sensor, &at),
                    DetectionZone::Plane(_) => may_stay_clear(sensor, &self.cell.body, &body, &at),
                    DetectionZone::InFmu => !reading,
                    DetectionZone::Floor(_) | DetectionZone::Post { .. } => {
                        may_report(sensor, &self.cell.body, &body, &at).be(reading)
                    }
                };
                let may = [may(false), may(true)];
                let with = |so_far: Readings| {
                    let add = move |reading: bool| so_far.iter().copied().chain([reading]).collect::<Readings>();
                    [false, true].into_iter().filter(|reading| may[usize::from(*reading)]).map(add).collect::<Vec<_>>()
                };
                some = some.into_iter().flat_map(with).collect();
            }
            let Some(told) = &self.told else {
                all.extend(some);
                continue;
            };
            for kind in told.kinds(cell, arc) {
                // What is reported is of sensors inside the FMU only.
                let with = |own: &Readings| own.iter().zip(kind).map(|(own, told)| *own || *told).collect::<Readings>();
                all.extend(some.iter().map(with));
            }
        }
        all
    }

    /// Whether any part of somebody, arms as well, may be in the plane of a sensor.
    fn is_near_plane(&self, sensor: &Sensor, at: &PoseBox) -> bool {
        let (centre, reach_m) = at.around(1.0, self.reach_m);
        let near = |plane| point_cuboid(centre, plane).distance <= reach_m;
        sensor.zone.plane().is_some_and(|(plane, _)| near(plane))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::error::Source;
    use crate::cell::file::validate::validate;
    use crate::stop::Stop;

    const MAT: &str = "schema = 1\nname = \"t\"\nfmu = \"t.fmu\"\n[[robot]]\nname = \"r\"\nmoving_mass_kg = 40\npayload_kg = 3\n\
                       [[robot.joint]]\nname = \"axis\"\naxis = [0, 0, 1]\nangle = { variable = \"q\", unit = \"rad\" }\n\
                       speed = { variable = \"qd\", unit = \"rad/s\" }\n[[robot.link]]\nname = \"bar\"\njoint = \"axis\"\n\
                       capsule = { from_m = [0, 0, 0], to_m = [0.3, 0, 0], radius_m = 0.05 }\n[[sensor]]\nname = \"mat\"\n\
                       kind = \"mat\"\nvariable = \"clear\"\nactive = false\n\
                       zone = { polygon_m = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]] }\n\
                       [human]\nstart = { xy_m = [0, -3], heading_deg = 90 }\n";

    /// Whoever has no time is told nothing, and what was known before that stays.
    #[test]
    fn nothing_half_done_is_told() {
        let cell = validate(&Source::new("t.toml", MAT)).unwrap();
        for asked_before in [true, false] {
            let stop = Stop::default();
            let search = ReachabilitySearch::on_cells_of(0.1, &cell, std::iter::empty(), 0.0, stop.clone()).unwrap();
            let known = (!asked_before).then(|| search.readings().unwrap());
            stop.ask();
            assert_eq!(search.readings(), known);
            // With readings that are known the fields of a floor this small may still be made.
            assert!(!asked_before || ReadingRegions::new(&search, &[false], &[true], (0.3, 10), 0).is_none());
        }
    }

    /// Somebody gets from a mat to one that lies beside it, and not to one that is farther away than a stride and two feet.
    #[test]
    fn what_is_reported_follows_what_is_near() {
        let mat = |at: f64| {
            format!(
                "[[sensor]]\nname = \"at {at}\"\nkind = \"mat\"\nvariable = \"v{at}\"\nactive = false\n\
                 zone = {{ polygon_m = [[{at}, -0.5], [{}, -0.5], [{}, 0.5], [{at}, 0.5]] }}\n[human]\n",
                at + 0.5,
                at + 0.5
            )
        };
        let two = |other: f64| MAT.replace("[human]\n", &mat(other));
        let follows = |other: f64| {
            let cell = validate(&Source::new("t.toml", &two(other))).unwrap();
            let search = ReachabilitySearch::on_cells_of(0.1, &cell, std::iter::empty(), 0.0, Stop::default()).unwrap();
            let zones = ReadingRegions::new(&search, &[false, false], &[true, true], (0.032, 1000), 0).unwrap();
            let [nobody, one, another] =
                [[false, false], [true, false], [false, true]].map(|of| zones.number(&of.to_vec()).unwrap());
            let others = zones.others();
            assert_eq!(nobody, 0);
            assert!(others[0].contains(&one) && others[one].contains(&0), "{others:?}");
            others[one].contains(&another) && others[another].contains(&one)
        };
        assert!(follows(0.55) && !follows(1.5));
    }

    /// With strides of 0.3 m. By hand: who looks along x at (0, -0.55) has a foot 0.09 m to the left, at -0.46, on a mat that begins at
    /// -0.5. At the end of that step they may be at -0.85, where nobody has a foot on it.
    #[test]
    fn who_steps_on_a_mat_may_be_a_stride_beside_it_when_the_step_ends() {
        let cell = validate(&Source::new("t.toml", MAT)).unwrap();
        let search = ReachabilitySearch::on_cells_of(0.1, &cell, std::iter::empty(), 0.0, Stop::default()).unwrap();
        let zones = ReadingRegions::new(&search, &[false], &[true], (0.3, 10), 0).unwrap();
        let onto: Vec<&ReadingTransition> = zones.ways.iter().filter(|way| zones.readings[way.to][0]).collect();
        assert!(!onto.is_empty());
        for way in onto {
            let [at_sample, after] = [[0.0, -0.55], [0.0, -0.85]].map(|at| way.field.least(at, 0.0));
            assert!(at_sample <= 0.0 && after <= 0.3, "{at_sample} {after}");
        }
    }
}
