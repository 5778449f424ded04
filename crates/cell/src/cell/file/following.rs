//! Checks of what follows the FMU's outputs in a cell file: obstacles that stand or move, sensors that count, controls that can be worked.

use toml::Spanned;

use super::checker::Checker;
use super::format::{CellFile, Literal, MovesTable, ObstacleTable, SensorTable, WhileTable};
use crate::cell::CellError;
use crate::cell::following::{Band, Follower, Following, Moves};
use crate::cell::sensor::kind::Key;
use crate::cell::sensor::{KINDS, Sensor, SensorKind};
use crate::fmi::number;
use crate::geometry::Vec3;
use crate::human::{Arrangement, Presses};

type Result<T> = std::result::Result<T, Box<CellError>>;

/// Most positions of an obstacle that moves.
const MOST_POSITIONS: f64 = 1000.0;

/// Most ways in which doors and obstacles that follow the FMU may stand together: the search has each ready.
const MOST_TOGETHER: usize = 1024;

/// Most boxes in all those ways together, some hundred bytes each.
const MOST_BOXES: usize = 500_000;

impl Checker<'_> {
    /// What follows the FMU, and for each obstacle of the file its number there. Nothing, if that cannot be said.
    pub(super) fn following(
        &self,
        file: &CellFile,
        sensors: &[Sensor],
        controls: usize,
    ) -> Option<(Following, Vec<Option<usize>>)> {
        // In the order in which the outputs are read.
        let mut reading = 0;
        let mut all = Vec::new();
        let mut numbers = Vec::with_capacity(file.obstacles.len());
        for table in &file.obstacles {
            let follower = self.problems.keep(self.of_obstacle(file, table, &mut reading))?;
            numbers.push(follower.is_some().then_some(all.len()));
            all.extend(follower);
        }
        for table in &file.sensors {
            let Some(counts) = &table.counts_while else { continue };
            let band = self.problems.keep(self.of_sensor(table, counts, sensors, &mut reading))?;
            let number = sensors.iter().position(|sensor| sensor.name == table.name)?;
            all.push(Follower::Sensor(number, band));
        }
        for (number, table) in file.controls.iter().enumerate() {
            let Some(works) = &table.works_while else { continue };
            all.push(Follower::Control(number, self.problems.keep(self.band(works, &mut reading))?));
        }
        let doors = if file.obstacles.iter().any(|table| table.opened_by.is_some()) { controls } else { 0 };
        let together = |following: &Following| following.of_obstacles() * Presses::all(doors).count();
        let following = Following::new(all).filter(|following| together(following) <= MOST_TOGETHER);
        if following.is_none() {
            let moving = file.obstacles.iter().find_map(|table| Some(table.moves_with.as_ref()?.span()));
            let standing = || file.obstacles.iter().find_map(|table| Some(table.stands_while.as_ref()?.span()));
            let counting = || file.sensors.iter().find_map(|table| Some(table.counts_while.as_ref()?.span()));
            let working = || file.controls.iter().find_map(|table| Some(table.works_while.as_ref()?.span()));
            let span = moving.or_else(standing).or_else(counting).or_else(working).unwrap_or(0..0);
            let message = format!(
                "obstacles that follow the FMU stand in more than {MOST_TOGETHER} ways (each control doubles them in a cell \
                 with doors), or with the sensors and controls in more than {}",
                Arrangement::MOST
            );
            let help = "a larger every_m, a shorter way, or fewer obstacles and sensors that follow the FMU".to_owned();
            self.problems.tell(self.source.error(span, "here", message, Some(help)));
        }
        Some((following?, numbers))
    }

    /// Whether so many boxes stand in so few ways that all can be kept ready.
    pub(super) fn kept_ready(&self, file: &CellFile, following: &Following, boxes: usize) {
        let ways = following.of_obstacles();
        let meshes = file.obstacles.iter().find(|table| table.mesh.is_some());
        let span = meshes.map_or(0..0, |table| table.name.span());
        let _ = self.problems.keep(self.that(ways <= 1 || ways * boxes <= MOST_BOXES, span, || {
            let message = format!("{boxes} boxes of obstacles in {ways} ways are more than can be kept ready");
            (message, "a larger every_m; or boxes instead of meshes, or a larger resolution_m".to_owned())
        }));
    }

    fn of_obstacle(&self, file: &CellFile, table: &ObstacleTable, reading: &mut usize) -> Result<Option<Follower>> {
        if table.stands_while.is_none() && table.moves_with.is_none() {
            return Ok(None);
        }
        let (name, span) = (table.name.get_ref(), table.name.span());
        self.that(table.opened_by.is_none(), span.clone(), || {
            let help = "remove opened_by, or stands_while and moves_with".to_owned();
            (format!("obstacle `{name}` is the leaf of a door, and follows the FMU"), help)
        })?;
        let low = std::iter::once(&file.human.first.also).chain(file.human.second.as_ref().map(|second| &second.also));
        let lies_low = low.flat_map(|also| also.get_ref()).any(|ability| ability.posture().is_some());
        self.that(!lies_low, span, || {
            let help = "scan once without kneel, crouch and crawl, and once without what follows the FMU".to_owned();
            (format!("obstacle `{name}` follows the FMU, and the person crouches or crawls"), help)
        })?;
        let stands = table.stands_while.as_ref().map(|table| self.band(table, reading)).transpose()?;
        let moves = table.moves_with.as_ref().map(|table| self.moves(name, table, reading)).transpose()?;
        Ok(Some(Follower::Obstacle { stands, moves }))
    }

    fn of_sensor(
        &self,
        table: &SensorTable,
        counts: &Spanned<WhileTable>,
        sensors: &[Sensor],
        reading: &mut usize,
    ) -> Result<Band> {
        let known = sensors.iter().find(|sensor| sensor.name == table.name);
        self.that(known.is_none_or(|sensor| sensor.kind.has(Key::CountsWhile)), counts.span(), || {
            let some = SensorKind::all_with(KINDS, Key::CountsWhile);
            let no: Vec<String> = some.iter().map(|kind| format!("no {}", kind.noun())).collect();
            let message = format!("sensor `{}` is {}, so it always counts", table.name, no.join(" and "));
            let help = "remove counts_while: an FMU that mutes a safeguard is told what that sees, and mutes it itself";
            (message, help.to_owned())
        })?;
        self.band(counts, reading)
    }

    fn band(&self, table: &Spanned<WhileTable>, reading: &mut usize) -> Result<Band> {
        let (span, table) = (table.span(), table.get_ref());
        let is_range = table.from.is_some() || table.to.is_some();
        self.that(!is_range || table.is.is_none(), span.clone(), || {
            ("`is` and a range are given".to_owned(), "keep one: is = 2, or from = 2 and to = 3".to_owned())
        })?;
        let [from, to] = match table.is {
            _ if is_range => [table.from.unwrap_or(f64::NEG_INFINITY), table.to.unwrap_or(f64::INFINITY)],
            None | Some(Literal::Bool(true)) => [1.0; 2],
            Some(Literal::Bool(false)) => [0.0; 2],
            Some(Literal::Number(value)) => [value; 2],
        };
        self.that(from <= to, span, || {
            (format!("nothing is from {} to {}", number(from), number(to)), "exchange the two".to_owned())
        })?;
        *reading += 1;
        Ok(Band { reading: *reading - 1, from, to })
    }

    fn moves(&self, name: &str, table: &Spanned<MovesTable>, reading: &mut usize) -> Result<Moves> {
        let (span, table) = (table.span(), table.get_ref());
        let MovesTable { direction, from_m, to_m, every_m, .. } = *table;
        self.finite(&[direction.as_slice(), &[from_m, to_m, every_m]].concat(), &span, "where an obstacle moves")?;
        self.positive(every_m, &span, &format!("every_m of obstacle `{name}`"))?;
        let direction = Vec3::from_array(direction);
        self.that(direction.length() > 1e-9, span.clone(), || {
            (format!("obstacle `{name}` moves in no direction"), "direction = [1, 0, 0] is along x".to_owned())
        })?;
        self.that(from_m < to_m, span.clone(), || {
            let message = format!("obstacle `{name}` moves from {} to {} m", number(from_m), number(to_m));
            (message, "from_m is the smaller one; turn `direction` round for the other way".to_owned())
        })?;
        let positions = ((to_m - from_m) / every_m - 1e-9).ceil().max(1.0) + 1.0;
        self.that(positions <= MOST_POSITIONS, span, || {
            let message = format!("obstacle `{name}` has {positions:.0} positions, {MOST_POSITIONS:.0} at most");
            (message, "a larger every_m, or a shorter way".to_owned())
        })?;
        *reading += 1;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked: a thousand at most")]
        let positions = positions as u16;
        // As many as it takes for no two to be farther apart.
        let step_m = (to_m - from_m) / f64::from(positions - 1);
        Ok(Moves { reading: *reading - 1, direction: direction.normalize(), from: from_m, step_m, positions })
    }
}
