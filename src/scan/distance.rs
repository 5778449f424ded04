//! How far a cell's safeguards stand from its robots, and how far they have to by ISO 13855: the stop time is measured from the
//! FMU, and so is what the robots reach while nobody is detected.
//!
//! What is measured: the horizontal distance from where somebody gets into a mat or field unseen until then (`entry`), or from the
//! plane of a curtain or a door, or from the buttons, to the nearest point of any link that moves (`swept`). What is not known
//! makes the verdict not known, never passed; and too near where not even the least that S can be is kept.

mod entry;
mod swept;

use self::entry::Entrances;
use self::swept::{Near, Swept};
use super::prepare::Prepared;
use super::probe::{Effect, Probe, Reaction, probe_for, run_s};
use crate::cell::Zone;
use crate::cell::binding::SensorBinding;
use crate::cell::workcell::Placing;
use crate::geometry::{Cuboid, Vec3};
use crate::host::PlantError;
use crate::human::Arrangement;
use crate::report::distance::{Distances, Placed, Safeguard, Stopped, Way, asked_mm, formula, there_mm};
use crate::standards::iso_13855::{
    self as iso, DRAFT_ASKS_LESS_FROM_M, Detection, Edition, FINE_M, MAT_DEPTH_M, Required,
};
use crate::standards::tables::distance_tables;

/// Pieces of guarding this far apart close what is between them, m: less than a hand.
const GAP_M: f64 = 0.03;

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
            kind: kind(&sensor.zone).to_owned(),
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
        if sensor.zone == Zone::Reported {
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
        let past = self.past(number, &placing, safeguard.t_s, &mut safeguard.not_known);
        for Past { how, near, required } in past {
            for reason in required.iter().flat_map(|required| &required.not_known) {
                if !safeguard.not_known.contains(reason) {
                    safeguard.not_known.push(reason.clone());
                }
            }
            let (s_mm, stands_mm) =
                (required.as_ref().map(|r| asked_mm(r.separation.s_m())), there_mm(near.distance_m));
            safeguard.ways.push(Way {
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
        let finely = matches!(sensor.zone, Zone::Curtain(_) | Zone::Field(_));
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
        if self.asked.edition == Edition::Of2024 && matches!(sensor.zone, Zone::Curtain(_)) {
            notes.push("--edition 2010 has a table for reaching over".to_owned());
        }
        if matches!(sensor.zone, Zone::Door(_)) && placing.opening.gap_m.is_none() {
            notes.push("say how wide it is open when its switch tells with opening_mm in the cell file".to_owned());
        }
        let new_formula = |d: f64| d > DRAFT_ASKS_LESS_FROM_M + 1e-9 && d <= FINE_M + 1e-9;
        if self.asked.edition == Edition::Of2024
            && matches!(sensor.zone, Zone::Curtain(_))
            && resolution_m.is_some_and(new_formula)
        {
            notes.push(
                "D_DS = 8 (d - 14) is that of 2010; the edition of 2024 may ask for less between 20 and 40 mm"
                    .to_owned(),
            );
        }
        placing
    }

    /// The ways past a safeguard; what is not known of it besides is added.
    fn past(&self, number: usize, placing: &Placing, t_s: Option<f64>, not_known: &mut Vec<String>) -> Vec<Past> {
        let (edition, z_m) = (self.asked.edition, placing.supplement_m);
        let sensor = &self.prepared.cell.sensors[number];
        let of = |how, near: Option<Near>, required: &dyn Fn(f64) -> Required| {
            near.map(|near| Past { how, near, required: t_s.map(required) })
        };
        match &sensor.zone {
            Zone::Mat(polygon) | Zone::Field(polygon) => {
                let is_mat = matches!(sensor.zone, Zone::Mat(_));
                let stop = self.prepared.stop();
                let Some(entrances) = Entrances::new(&self.prepared.cell, &self.with(number), polygon, &stop) else {
                    not_known.push("it was stopped before it was known where people get onto it".to_owned());
                    return Vec::new();
                };
                let near = self.swept.nearest_to(&entrances.pieces);
                if near.is_none() && self.swept.moves() {
                    not_known
                        .push("nobody gets onto it from where people come: obstacles are all around it".to_owned());
                }
                if is_mat && let Some(depth_m) = entrances.stepped_over_m {
                    not_known.push(format!(
                        "it can be stepped over: it is {} mm deep in one place where somebody may be behind it, and has to be {} mm",
                        there_mm(depth_m),
                        there_mm(MAT_DEPTH_M)
                    ));
                }
                let Placing { detection, height_m, .. } = placing;
                let required = |t_s| match is_mat {
                    true => iso::mat(edition, t_s, z_m, 0.0),
                    false => iso::along(edition, t_s, z_m, *height_m, detection.resolution_m),
                };
                of("into it", near, &required).into_iter().collect()
            }
            Zone::Curtain(plane) => self.past_curtain(plane, placing, t_s, not_known),
            Zone::Door(plane) => {
                let required = |t_s| iso::door(edition, t_s, z_m, &placing.opening);
                of("through", self.swept.nearest_to(&[line(plane)]), &required).into_iter().collect()
            }
            Zone::TwoHand { plane, .. } => {
                let near = self.swept.nearest_to(&[self.buttons(number).unwrap_or_else(|| line(plane))]);
                of("from it", near, &|t_s| iso::two_hand(edition, t_s, z_m)).into_iter().collect()
            }
            Zone::Reported => Vec::new(),
        }
    }

    fn past_curtain(
        &self,
        plane: &Cuboid,
        placing: &Placing,
        t_s: Option<f64>,
        not_known: &mut Vec<String>,
    ) -> Vec<Past> {
        let (edition, z_m, detection) = (self.asked.edition, placing.supplement_m, &placing.detection);
        let line = line(plane);
        let through = self.swept.nearest_to(&[line]).map(|near| Past {
            how: "through",
            near,
            required: t_s.map(|t_s| iso::through(edition, t_s, z_m, detection)),
        });
        let own = [plane.centre.z - plane.half.z, plane.centre.z + plane.half.z];
        // Doors are taken to be open.
        let boxes = self.prepared.cell.standing(self.prepared.cell.doors(), Arrangement::NONE);
        let [low_m, high_m] = closed(plane, &boxes.iter().collect::<Vec<_>>());
        // What guards it below is in nobody's way to be seen.
        not_known.extend(if low_m > GAP_M { iso::under(edition, low_m, detection) } else { None });
        not_known.extend(detection.beams.and_then(|beams| iso::beam_heights(beams, own)));
        let reached_over = |heights_m: [f64; 2]| {
            let near = self.swept.nearest_between(&[line], heights_m)?;
            let t_s = t_s?;
            let required = iso::over(edition, t_s, z_m, detection, (heights_m, high_m))?;
            Some(Past { how: "over", near, required: Some(required) })
        };
        let over = match edition {
            // Higher or lower parts of the robots may be farther away, and be asked for more.
            Edition::Of2010 => {
                let all = iso::heights_for_reaching_over().filter_map(reached_over);
                let room = |past: &Past| {
                    let s_m = past.required.as_ref().map_or(0.0, |required| required.separation.s_m());
                    past.near.distance_m - s_m
                };
                all.min_by(|a, b| room(a).total_cmp(&room(b)))
            }
            Edition::Of2024 => reached_over([0.0, 2.7]),
        };
        through.into_iter().chain(over).collect()
    }

    /// The line of a two-hand control's buttons.
    fn buttons(&self, number: usize) -> Option<[[f64; 2]; 2]> {
        let cell = &self.prepared.cell;
        let table = cell.file().sensors.iter().find(|table| table.name == cell.sensors[number].name)?;
        table.zone.as_ref()?.get_ref().line_m
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
        let polygon = |other: usize| match &sensors[other].zone {
            Zone::Mat(polygon) | Zone::Field(polygon) => Some(polygon.as_slice()),
            _ => None,
        };
        polygon(number).into_iter().chain((0..sensors.len()).filter(same).filter_map(polygon)).collect()
    }
}

const fn kind(zone: &Zone) -> &'static str {
    match zone {
        Zone::Mat(_) => "pressure-sensitive mat",
        Zone::Field(_) => "scanner field",
        Zone::Curtain(_) => "light curtain",
        Zone::Door(_) => "guard door without locking",
        Zone::TwoHand { .. } => "two-hand control",
        Zone::Reported => "sensor inside the FMU",
    }
}

/// An upright plane from above.
fn line(plane: &Cuboid) -> [[f64; 2]; 2] {
    let half = plane.rotation * Vec3::X * plane.half.x;
    [plane.centre - half, plane.centre + half].map(|end| [end.x, end.y])
}

/// From which height to which an upright plane is closed, with upright boxes right below and above it that are as wide, m.
fn closed(plane: &Cuboid, boxes: &[&Cuboid]) -> [f64; 2] {
    let (mut low, mut high) = (plane.centre.z - plane.half.z, plane.centre.z + plane.half.z);
    let spans: Vec<[f64; 2]> = boxes.iter().filter_map(|cuboid| beside(plane, cuboid)).collect();
    for _ in 0..spans.len() {
        for [from, to] in &spans {
            if *from <= high + GAP_M && *to > high {
                high = *to;
            }
            if *to >= low - GAP_M && *from < low {
                low = from.max(0.0);
            }
        }
    }
    [low, high]
}

/// From which height to which a box closes all of the width of an upright plane, if it does.
fn beside(plane: &Cuboid, cuboid: &Cuboid) -> Option<[f64; 2]> {
    let plane_from_world = plane.rotation.inverse();
    let turned = plane_from_world * cuboid.rotation;
    // Turned by quarters only, so that all of its faces are along the plane's axes.
    let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| (turned * axis).abs());
    if axes.iter().any(|axis| axis.max_element() < 1.0 - 1e-6) {
        return None;
    }
    let centre = plane_from_world * (cuboid.centre - plane.centre);
    let half = axes[0] * cuboid.half.x + axes[1] * cuboid.half.y + axes[2] * cuboid.half.z;
    let wide = centre.x - half.x <= -plane.half.x + GAP_M && centre.x + half.x >= plane.half.x - GAP_M;
    let in_plane = centre.y.abs() <= half.y + GAP_M;
    (wide && in_plane).then_some([cuboid.centre.z - half.z, cuboid.centre.z + half.z])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::rotation_about;

    fn boxed(centre: [f64; 3], size: [f64; 3], yaw_deg: f64) -> Cuboid {
        Cuboid {
            centre: Vec3::from_array(centre),
            half: Vec3::from_array(size) * 0.5,
            rotation: rotation_about(Vec3::Z, yaw_deg.to_radians()),
        }
    }

    #[test]
    fn boxes_close_what_is_below_and_above_a_curtain_only_where_they_are_as_wide() {
        let plane = boxed([1.0, 0.0, 1.2], [1.0, 0.0, 1.2], 90.0);
        let of = |boxes: &[Cuboid]| closed(&plane, &boxes.iter().collect::<Vec<_>>());
        let is = |found: [f64; 2], low: f64, high: f64| {
            assert!((found[0] - low).abs() < 1e-9 && (found[1] - high).abs() < 1e-9, "{found:?}");
        };
        is(of(&[]), 0.6, 1.8);
        let (sill, panel) =
            (boxed([1.0, 0.0, 0.3], [0.1, 1.0, 0.6], 0.0), boxed([1.0, 0.0, 2.2], [0.1, 1.2, 0.8], 0.0));
        let more = boxed([1.0, 0.0, 2.7], [1.2, 0.1, 0.2], 90.0);
        is(of(&[more, sill, panel]), 0.0, 2.8);
        // Too narrow, beside the plane, turned, with a gap.
        is(of(&[boxed([1.0, 0.0, 2.2], [0.1, 0.8, 0.8], 0.0)]), 0.6, 1.8);
        is(of(&[boxed([1.2, 0.0, 2.2], [0.1, 1.2, 0.8], 0.0)]), 0.6, 1.8);
        is(of(&[boxed([1.0, 0.0, 2.2], [0.1, 1.2, 0.8], 20.0)]), 0.6, 1.8);
        is(of(&[boxed([1.0, 0.0, 2.3], [0.1, 1.2, 0.9], 0.0)]), 0.6, 1.8);
    }
}
