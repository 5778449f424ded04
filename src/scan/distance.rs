//! How far a cell's safeguards stand from its robots, and how far they have to by ISO 13855: the stop time is measured from the
//! FMU, and so is what the robots reach while nobody is detected.
//!
//! The ways past a safeguard, and what is asked for each, its kind says (`cell::sensor::rules`). What is measured here: the horizontal
//! distance from where somebody gets into a zone on the floor unseen until then (`entry`), or from a line such as that of a plane or of
//! buttons, to the nearest point of any link that moves (`swept`). What is not known makes the verdict not known, never passed; and too
//! near where not even the least that S can be is kept.

mod entry;
mod swept;

use self::entry::Entrances;
use self::swept::{Near, Swept};
use super::prepare::Prepared;
use super::probe::{Effect, Probe, Reaction, probe_for, run_s};
use crate::cell::binding::SensorBinding;
use crate::cell::sensor::Placing;
use crate::cell::sensor::kind::Key;
use crate::cell::sensor::rules::{Approach, Asks, From, Rules, Standing};
use crate::host::PlantError;
use crate::human::Arrangement;
use crate::report::distance::{ApproachPath, Distances, Placed, Safeguard, Stopped, asked_mm, formula, there_mm};
use crate::standards::iso_13855::{Detection, Edition, Required};
use crate::standards::tables::distance_tables;

/// What is asked.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Asked {
    /// By which edition.
    pub edition: Edition,
    /// Resolution of light curtains and fields of which the cell file says none, m.
    pub resolution_m: Option<f64>,
    /// How long each run is, s; as long as those of `probe` if nothing is said.
    pub run_s: Option<f64>,
}

/// Measures all safeguards of a cell.
///
/// # Errors
/// When the FMU fails.
pub(crate) fn distances(prepared: &Prepared, asked: &Asked) -> Result<Distances, PlantError> {
    let cell = &prepared.cell;
    let found = probe_for(prepared, asked.run_s.unwrap_or_else(|| run_s(prepared)))?;
    let measured = Measured { prepared, asked, swept: Swept::new(prepared, &found.rows), found: &found };
    let mut warnings = prepared.warnings();
    warnings.extend(found.warnings.iter().chain(&found.idle_sensors).cloned());
    Ok(Distances {
        cell: cell.name.clone(),
        edition: asked.edition,
        run_s: found.run_s,
        fastest_m_s: found.fastest_m_s,
        safeguards: (0..cell.sensors.len()).map(|sensor| measured.safeguard(sensor)).collect(),
        warnings,
        tables: distance_tables().collect(),
    })
}

/// What was found out from the FMU.
struct Measured<'a> {
    prepared: &'a Prepared,
    asked: &'a Asked,
    found: &'a Probe,
    swept: Swept,
}

/// A way past a safeguard: how, from where, and what is asked if the robots' stop time is known.
struct Past {
    how: &'static str,
    near: Near,
    required: Option<Required>,
}

impl Measured<'_> {
    fn safeguard(&self, number: usize) -> Safeguard {
        let cell = &self.prepared.cell;
        let sensor = &cell.sensors[number];
        #[expect(clippy::cast_precision_loss, reason = "63 at most")]
        let delay_s = sensor.delay_steps as f64 * cell.step_s;
        let mut safeguard = Safeguard {
            sensor: sensor.name.clone(),
            kind: sensor.kind.name().to_owned(),
            placed: Placed::NotKnown,
            stop_s: None,
            moments: Vec::new(),
            delay_s,
            t_s: None,
            ways: Vec::new(),
            margin_mm: None,
            not_known: Vec::new(),
            notes: Vec::new(),
        };
        if sensor.zone.is_in_fmu() {
            safeguard.not_known.push(
                "the FMU simulates it: where it begins to see somebody is not known here. Write its field as a sensor with a zone, or \
                 measure it on the real cell"
                    .to_owned(),
            );
            return safeguard;
        }
        if let SensorBinding::Both { .. } = self.prepared.binding.sensors[number] {
            safeguard.not_known.push(
                "the FMU evaluates it: how long that takes until it reports somebody is not measured here. Measure it in a cell file without \
                 evaluated, whose variable stops the robots as the whole signal does"
                    .to_owned(),
            );
            return safeguard;
        }
        if cell.following.has_sensor(number) {
            safeguard.not_known.push(
                "it counts only while the FMU says so, and when that is, is not asked here. Measure it in a cell file without counts_while \
                 that holds the robots in the part of the programme in which it counts"
                    .to_owned(),
            );
            return safeguard;
        }
        match self.stop(number) {
            Ok(moments) => {
                safeguard.stop_s = moments.iter().filter_map(|moment| moment.still_after_s).reduce(f64::max);
                safeguard.t_s = safeguard.stop_s.map(|stop_s| stop_s + delay_s);
                safeguard.moments = moments;
            }
            Err((moments, reason)) => {
                safeguard.not_known.push(reason);
                safeguard.moments = moments;
            }
        }
        let placing = self.placing(number, &mut safeguard.notes);
        let obstacles = cell.standing(cell.doors(), Arrangement::NONE);
        let standing = Standing { edition: self.asked.edition, placing, zone: &sensor.zone, obstacles: &obstacles };
        let Rules { ways, not_known, notes } = sensor.kind.rules(&standing);
        safeguard.notes.extend(notes);
        safeguard.not_known.extend(not_known);
        let past = ways.iter().filter_map(|way| self.past(number, way, safeguard.t_s, &mut safeguard.not_known));
        for Past { how, near, required } in past.collect::<Vec<_>>() {
            for reason in required.iter().flat_map(|required| &required.not_known) {
                if !safeguard.not_known.contains(reason) {
                    safeguard.not_known.push(reason.clone());
                }
            }
            let (s_mm, stands_mm) =
                (required.as_ref().map(|r| asked_mm(r.separation.s_m())), there_mm(near.distance_m));
            safeguard.ways.push(ApproachPath {
                how: how.to_owned(),
                clause: required.as_ref().map(|required| required.clause.to_owned()),
                formula: required.as_ref().map(|required| formula(self.asked.edition, required)),
                s_mm,
                stands_mm,
                margin_mm: s_mm.map(|s_mm| stands_mm - s_mm),
                known: required.is_some_and(|required| required.not_known.is_empty()),
                edge_m: near.edge_m,
                link: cell.links[near.link].name.clone(),
                at_s: near.at_s,
            });
        }
        safeguard.ways.sort_by_key(|way| way.margin_mm);
        safeguard.margin_mm = safeguard.ways.first().and_then(|way| way.margin_mm);
        safeguard.placed = match safeguard.margin_mm {
            Some(..0) => Placed::TooNear,
            Some(_) if safeguard.not_known.is_empty() => Placed::FarEnough,
            _ => Placed::NotKnown,
        };
        safeguard
    }

    /// The reaction to the input that a sensor drives.
    fn reaction(&self, number: usize) -> Option<&Reaction> {
        let (cell, bound) = (&self.prepared.cell, &self.prepared.binding.sensors);
        let first = (0..cell.sensors.len()).find(|other| bound[*other] == bound[number])?;
        self.found.reactions.iter().find(|reaction| reaction.input == cell.sensors[first].name)
    }

    /// How long robots take to stand at each moment that was tried, if they do at all of them; else why there is no stop time.
    fn stop(&self, number: usize) -> Result<Vec<Stopped>, (Vec<Stopped>, String)> {
        let Some(reaction) = self.reaction(number) else {
            return Err((Vec::new(), "what it does was not tried".to_owned()));
        };
        let all = std::iter::once((reaction.at_s, reaction.effect, reaction.still_after_s))
            .chain(reaction.at_other_moments.iter().map(|moment| (moment.at_s, moment.effect, moment.still_after_s)));
        let stopped = all.clone().map(|(at_s, _, still_after_s)| Stopped { at_s, still_after_s }).collect();
        if !self.swept.moves() {
            let run_s = crate::fmi::number(self.found.run_s);
            return Err((stopped, format!("no robot moves in {run_s} s while nobody is detected")));
        }
        let Some((at_s, effect, _)) = all.clone().find(|(_, effect, _)| *effect != Effect::Stops) else {
            return Ok(stopped);
        };
        let does = match effect {
            Effect::Stops => "stops it",
            Effect::Slows => "slows it",
            Effect::Starts => "starts it",
            Effect::SpeedsUp => "makes it faster",
            Effect::Changes => "changes something, not how fast it is",
            Effect::Nothing => "changes nothing",
        };
        Err((
            stopped,
            format!("it does not stop the robot: when it begins to report at {at_s:.2} s it {does}. So S has no value"),
        ))
    }

    /// What the cell file says of it, with what was said besides.
    fn placing(&self, number: usize, notes: &mut Vec<String>) -> Placing {
        let cell = &self.prepared.cell;
        let (sensor, mut placing) = (&cell.sensors[number], cell.placings[number]);
        let Detection { resolution_m, beams } = &mut placing.detection;
        let finely = sensor.kind.has(Key::Resolution);
        if finely && resolution_m.is_none() && beams.is_none() {
            *resolution_m = self.asked.resolution_m;
            if let Some(d) = self.asked.resolution_m {
                notes
                    .push(format!("its resolution, {} mm, is that of --resolution-mm", crate::fmi::number(d * 1000.0)));
            }
        }
        if finely && resolution_m.is_none() && beams.is_none() {
            notes.push("say its resolution with resolution_mm in the cell file, or with --resolution-mm".to_owned());
        }
        placing
    }

    /// A way past a safeguard; what is not known of it besides is added.
    fn past(&self, number: usize, way: &Approach, t_s: Option<f64>, not_known: &mut Vec<String>) -> Option<Past> {
        let how = way.how;
        let of = |near: Near, asks: &Asks| Past { how, near, required: t_s.map(asks) };
        match &way.from {
            From::Edge { least_depth_m, asks } => Some(of(self.over_edge(number, *least_depth_m, not_known)?, asks)),
            From::Line { line_m, asks } => Some(of(self.swept.nearest_to(&[*line_m])?, asks)),
            From::Bands { line_m, bands_m, asks } => {
                let reached = |heights_m: &[f64; 2]| {
                    let near = self.swept.nearest_between(&[*line_m], *heights_m)?;
                    Some(Past { how, near, required: Some(asks(t_s?, *heights_m)?) })
                };
                let room = |past: &Past| {
                    let s_m = past.required.as_ref().map_or(0.0, |required| required.separation.s_m());
                    past.near.distance_m - s_m
                };
                bands_m.iter().filter_map(reached).min_by(|a, b| room(a).total_cmp(&room(b)))
            }
        }
    }

    /// From where people get into a zone on the floor.
    fn over_edge(&self, number: usize, least_depth_m: Option<f64>, not_known: &mut Vec<String>) -> Option<Near> {
        let cell = &self.prepared.cell;
        let polygon = cell.sensors[number].zone.stepped_on()?;
        let stop = self.prepared.stop();
        let Some(entrances) = Entrances::new(cell, &self.with(number), polygon, least_depth_m, &stop) else {
            not_known.push("it was stopped before it was known where people get onto it".to_owned());
            return None;
        };
        let near = self.swept.nearest_to(&entrances.pieces);
        if near.is_none() && self.swept.moves() {
            not_known.push("nobody gets onto it from where people come: obstacles are all around it".to_owned());
        }
        if let (Some(least_m), Some(depth_m)) = (least_depth_m, entrances.stepped_over_m) {
            not_known.push(format!(
                "it can be stepped over: it is {} mm deep in one place where somebody may be behind it, and has to be {} mm",
                there_mm(depth_m),
                there_mm(least_m)
            ));
        }
        near
    }

    /// The mats and fields that tell the FMU the same as one of them, which is the first.
    fn with(&self, number: usize) -> Vec<&[[f64; 2]]> {
        let (sensors, bound) = (&self.prepared.cell.sensors, &self.prepared.binding.sensors);
        // One that counts at times only tells nothing at others.
        let always = |other: usize| !self.prepared.cell.following.has_sensor(other);
        let same = |other: &usize| {
            *other != number
                && always(*other)
                && matches!(bound[*other], SensorBinding::Input(_))
                && bound[*other] == bound[number]
        };
        let polygon = |other: usize| sensors[other].zone.stepped_on();
        polygon(number).into_iter().chain((0..sensors.len()).filter(same).filter_map(polygon)).collect()
    }
}
