//! Checks of the sensors in a cell file: zones and response times.

use toml::Spanned;

use super::checker::Checker;
use super::format::{CellFile, SensorKind, SensorTable, ValuesTable, ZoneTable};
use crate::cell::CellError;
use crate::cell::workcell::{Placing, Sensor, Signal, Zone};
use crate::fmi;
use crate::geometry::{Cuboid, Vec3, rotation_about};
use crate::human::Ability;
use crate::standards::iso_13855::{Detection, HAND_SPEED_M_S, Opening};

/// Longest sensor response in steps: the delay line is one 64-bit word.
const MAX_DELAY_STEPS: usize = 63;

/// What a sensor's variable says: as told, or as its name promises, because signals of safety devices are false on demand.
pub(in crate::cell) fn signal(s: &SensorTable) -> Option<Signal> {
    if let Some(values) = &s.values {
        let ValuesTable { clear, detected } = *values.get_ref();
        return Some(Signal::Number { clear, detected });
    }
    let variable = s.variable.get_ref();
    let last = variable.rsplit(['.', ':', '/']).next().unwrap_or(variable);
    let by_name = || (last.starts_with("S_") || last.to_uppercase().contains("OSSD")).then_some(false);
    s.active.or_else(by_name).map(|active| Signal::Boolean { active })
}

impl Checker<'_> {
    /// All sensors, and what is said of each for its safety distance.
    pub(super) fn sensors(&self, file: &CellFile, step_s: f64) -> (Vec<Sensor>, Vec<Placing>) {
        for (number, s) in file.sensors.iter().enumerate() {
            let alone = file.sensors[..number].iter().all(|other| other.name != s.name);
            let _ = self.problems.keep(self.that(alone, s.variable.span(), || {
                (format!("two sensors are called `{}`", s.name), "give each sensor its own name".to_owned())
            }));
        }
        let all = self.problems.keep_all(file.sensors.iter().map(|s| self.sensor(s, file, step_s)));
        let (sensors, placings): (Vec<Sensor>, Vec<Placing>) = all.into_iter().unzip();
        let planes: Vec<&str> = sensors.iter().filter(|s| s.zone.plane().is_some()).map(|s| s.name.as_str()).collect();
        let held_m = file.human.first.held_m.as_ref().map_or(0.0, |held| *held.get_ref());
        let shortest_s = SHORTEST_S * (1.0 + held_m / FOLLOWED_M);
        let enough = self.that(planes.is_empty() || step_s >= shortest_s, file.time.step_s.span(), || {
            let message = format!("time.step_s is {}, too short for {}", fmi::number(step_s), planes.join(", "));
            let use_ = if held_m > 0.0 { "with what is held use 0.02" } else { "use 0.01 or 0.02" };
            (message, format!("arms behind planes are followed for 64 steps: {use_}"))
        });
        let _ = self.problems.keep(enough);
        if planes.len() > 2 {
            self.warnings.borrow_mut().push(format!(
                "arms that reach through three of {} at once are not looked for: where they are behind one another, scan \
                 once without each of them",
                planes.join(", ")
            ));
        }
        (sensors, placings)
    }

    fn sensor(&self, s: &SensorTable, file: &CellFile, step_s: f64) -> Result<(Sensor, Placing), Box<CellError>> {
        let signal = self.problems.keep(self.signal(s)).unwrap_or(Signal::Boolean { active: false });
        let span = s.zone.as_ref().map_or_else(|| s.variable.span(), Spanned::span);
        let zone = match (s.kind, &s.zone) {
            (SensorKind::Reported, None) => Zone::Reported,
            (SensorKind::Reported, Some(zone)) => {
                let message = format!("sensor `{}` is inside the FMU and has no zone here", s.name);
                return Err(self.source.error(zone.span(), "here", message, Some("remove the zone".to_owned())));
            }
            (_, None) => {
                let message = format!("sensor `{}` has no zone", s.name);
                let help = Some(
                    "add zone = { polygon_m = [[x, y], ...] }, or line_m for a light curtain or a door".to_owned(),
                );
                return Err(self.source.error(span, "for this sensor", message, help));
            }
            (SensorKind::Mat, Some(zone)) => Zone::Mat(self.polygon(s, zone)?),
            (SensorKind::ScannerField, Some(zone)) => {
                let height_m = zone.get_ref().height_m.unwrap_or(FIELD_HEIGHT_M);
                self.that((0.0..=1.0).contains(&height_m), span.clone(), || {
                    (
                        format!("the height of sensor `{}` is {} m", s.name, fmi::number(height_m)),
                        "ISO 13855 allows 0 to 1 m".to_owned(),
                    )
                })?;
                Zone::Field(self.polygon(s, zone)?)
            }
            (SensorKind::LightCurtain, Some(zone)) => Zone::Curtain(self.plane(s, zone, "light curtain")?),
            (SensorKind::InterlockedDoor, Some(zone)) => Zone::Door(self.plane(s, zone, "door")?),
            (SensorKind::TwoHandControl, Some(zone)) => {
                let post = self.polygon(s, zone)?;
                let plane = self.buttons(s, zone, &post)?;
                Zone::TwoHand { post, plane }
            }
        };
        let delay_ms = s.delay_ms.as_ref().map_or(0.0, |d| *d.get_ref());
        self.that(delay_ms == 0.0 || zone != Zone::Reported, span.clone(), || {
            (
                format!("sensor `{}` is inside the FMU, which knows its response time", s.name),
                "remove delay_ms".to_owned(),
            )
        })?;
        self.plausible_delay(s);
        let steps = (delay_ms / 1000.0 / step_s - 1e-9).ceil();
        let delay_span = s.delay_ms.as_ref().map_or(span, Spanned::span);
        #[expect(clippy::cast_precision_loss, reason = "63")]
        self.that(delay_ms >= 0.0 && steps <= MAX_DELAY_STEPS as f64, delay_span, || {
            let most = MAX_DELAY_STEPS as f64 * step_s * 1000.0;
            (format!("delay_ms of sensor `{}` is {}", s.name, fmi::number(delay_ms)), format!("use 0 to {most:.0} ms"))
        })?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked: 0 to 63")]
        let delay_steps = steps.max(0.0) as usize;
        self.evaluated(s, file)?;
        let latched = self.latched(s)?;
        let placing = self.placing(s)?;
        Ok((Sensor { name: s.name.clone(), zone, signal, delay_steps, latched }, placing))
    }

    /// Whether the input of a sensor is held: of one that the FMU does not evaluate itself, else it knows better.
    fn latched(&self, s: &SensorTable) -> Result<bool, Box<CellError>> {
        use SensorKind::{InterlockedDoor, LightCurtain, Mat, ScannerField};
        let Some(latched) = &s.latched else { return Ok(false) };
        self.belongs(s, "latched", &latched.span(), &[Mat, ScannerField, LightCurtain, InterlockedDoor])?;
        self.that(s.evaluated.is_none() || !*latched.get_ref(), latched.span(), || {
            let message = format!("the FMU evaluates sensor `{}` itself: its input alone cannot be held", s.name);
            (message, "leave `latched` or `evaluated` out".to_owned())
        })?;
        Ok(*latched.get_ref())
    }

    /// Whether the FMU can evaluate a sensor as far as it knows the person's pose: where the feet are, and not how they stand.
    fn evaluated(&self, s: &SensorTable, file: &CellFile) -> Result<(), Box<CellError>> {
        let Some(table) = &s.evaluated else { return Ok(()) };
        let span = table.span();
        self.that(s.values.is_none() || table.get_ref().active.is_some(), span.clone(), || {
            let message = format!("which value of `{}` means a person is not said", table.get_ref().variable.get_ref());
            (message, "add active = true or false: that of the sensor is told by numbers".to_owned())
        })?;
        self.belongs(s, "evaluated", &span, &[SensorKind::LightCurtain, SensorKind::InterlockedDoor])?;
        self.that(!file.pose.is_empty(), span.clone(), || {
            let message = format!("the FMU evaluates sensor `{}` and is not told where the person is", s.name);
            (message, "add [pose] with the inputs that tell it".to_owned())
        })?;
        let low_m = s.zone.as_ref().and_then(|zone| zone.get_ref().heights_m).map_or(0.0, |[low, _]| low);
        self.that(low_m <= LEGS_M, span.clone(), || {
            let message = format!(
                "the FMU evaluates sensor `{}`, which begins at {} m, and does not know who bends below it",
                s.name,
                fmi::number(low_m)
            );
            (message, format!("leave `evaluated` out, or have it begin at {LEGS_M} m or lower, where legs are in it"))
        })?;
        let low = file.human.first.also.get_ref().iter().any(|ability| LOW.contains(ability));
        self.that(!low, span, || {
            let message =
                format!("the FMU evaluates sensor `{}` and does not know who crouches, kneels or crawls", s.name);
            (message, "leave `evaluated` out, or those abilities of [human]".to_owned())
        })
    }

    /// What the safety distance alone depends on.
    fn placing(&self, s: &SensorTable) -> Result<Placing, Box<CellError>> {
        use SensorKind::{InterlockedDoor, LightCurtain, Reported, ScannerField};
        let seeing: &[SensorKind] = &[LightCurtain, ScannerField];
        let (beams, doors): (&[SensorKind], &[SensorKind]) = (&[LightCurtain], &[InterlockedDoor]);
        for (key, value, kinds, most) in [
            ("resolution_mm", &s.resolution_mm, seeing, 500.0),
            ("opening_mm", &s.opening_mm, doors, 10_000.0),
            ("opening_ms", &s.opening_ms, doors, 60_000.0),
        ] {
            let Some(value) = value else { continue };
            self.belongs(s, key, &value.span(), kinds)?;
            self.between(s, key, value, most)?;
        }
        if let Some(beams_of) = &s.beams {
            self.belongs(s, "beams", &beams_of.span(), beams)?;
            self.that((1..=100).contains(beams_of.get_ref()), beams_of.span(), || {
                (format!("light curtain `{}` has {} beams", s.name, beams_of.get_ref()), "use 1 to 100".to_owned())
            })?;
            self.that(s.resolution_mm.is_none(), beams_of.span(), || {
                let message = format!("light curtain `{}` has both beams and a resolution", s.name);
                (message, "beams for a row of single ones, resolution_mm for a curtain".to_owned())
            })?;
        }
        if let Some(supplement) = &s.supplement_mm {
            self.that(s.kind != Reported, supplement.span(), || {
                let message = format!("sensor `{}` is inside the FMU: where it begins is not known here", s.name);
                (message, "remove supplement_mm".to_owned())
            })?;
            self.between(s, "supplement_mm", supplement, 10_000.0)?;
        }
        let thousandth = |value: &Option<Spanned<f64>>| value.as_ref().map(|value| *value.get_ref() / 1000.0);
        Ok(Placing {
            detection: Detection {
                resolution_m: thousandth(&s.resolution_mm),
                beams: s.beams.as_ref().map(|beams| *beams.get_ref()),
            },
            height_m: s.zone.as_ref().and_then(|zone| zone.get_ref().height_m).unwrap_or(FIELD_HEIGHT_M),
            opening: Opening { gap_m: thousandth(&s.opening_mm), time_s: thousandth(&s.opening_ms).unwrap_or(0.0) },
            supplement_m: thousandth(&s.supplement_mm).unwrap_or(0.0),
        })
    }

    /// Whether a key is of this kind of sensor.
    fn belongs(
        &self,
        s: &SensorTable,
        key: &str,
        span: &std::ops::Range<usize>,
        kinds: &[SensorKind],
    ) -> Result<(), Box<CellError>> {
        self.that(kinds.contains(&s.kind), span.clone(), || {
            let of = kinds.iter().map(|kind| match kind {
                SensorKind::LightCurtain => "a light curtain",
                SensorKind::ScannerField => "a scanner field",
                SensorKind::InterlockedDoor => "a door",
                SensorKind::Mat => "a mat",
                _ => "another sensor",
            });
            let of: Vec<&str> = of.collect();
            (format!("sensor `{}` has {key}, which only {} has", s.name, of.join(" or ")), format!("remove {key}"))
        })
    }

    fn between(&self, s: &SensorTable, key: &str, value: &Spanned<f64>, most: f64) -> Result<(), Box<CellError>> {
        let number = *value.get_ref();
        self.that(number >= 0.0 && number <= most, value.span(), || {
            (format!("{key} of sensor `{}` is {}", s.name, fmi::number(number)), format!("use 0 to {most}"))
        })
    }

    /// What its variable says.
    fn signal(&self, s: &SensorTable) -> Result<Signal, Box<CellError>> {
        if let Some(values) = &s.values {
            let ValuesTable { clear, detected } = *values.get_ref();
            self.finite(&[clear, detected], &values.span(), &format!("`values` of sensor `{}`", s.name))?;
            self.that((clear - detected).abs() > 0.0, values.span(), || {
                let message = format!("sensor `{}` says the same whether somebody is detected or not", s.name);
                (message, "give `clear` and `detected` different values".to_owned())
            })?;
            self.that(s.active.is_none(), values.span(), || {
                let message = format!("sensor `{}` has both `active` and `values`", s.name);
                (message, "`active` is for a Boolean variable, `values` for a number: remove one of them".to_owned())
            })?;
        }
        signal(s).ok_or_else(|| {
            let message =
                format!("sensor `{}` does not say which value of `{}` means a person", s.name, s.variable.get_ref());
            let help = "add active = false if true means clear, as safety signals have it, or active = true; \
                        `fmi-hazard inspect --run` tries which. Of a number, add values = { clear = 1, detected = 0 }, say"
                .to_owned();
            self.source.error(s.variable.span(), "of this variable", message, Some(help))
        })
    }

    fn polygon(&self, s: &SensorTable, zone: &Spanned<ZoneTable>) -> Result<Vec<[f64; 2]>, Box<CellError>> {
        let polygon = zone.get_ref().polygon_m.clone().unwrap_or_default();
        self.that(polygon.len() >= 3, zone.span(), || {
            (format!("the zone of sensor `{}` needs at least three corners", s.name), "[[x, y], ...] in m".to_owned())
        })?;
        self.finite(&polygon.concat(), &zone.span(), &format!("the zone of sensor `{}`", s.name))?;
        self.plain_polygon(&polygon, &zone.span(), &format!("the zone of sensor `{}`", s.name))?;
        Ok(polygon)
    }

    fn plane(&self, s: &SensorTable, zone: &Spanned<ZoneTable>, what: &str) -> Result<Cuboid, Box<CellError>> {
        let (Some(line), Some([low, high])) = (zone.get_ref().line_m, zone.get_ref().heights_m) else {
            let message = format!("{what} `{}` needs `line_m` and `heights_m`", s.name);
            let help = Some("zone = { line_m = [[-0.5, 0], [0.5, 0]], heights_m = [0, 1.8] }".to_owned());
            return Err(self.source.error(zone.span(), "here", message, help));
        };
        self.of_a_workshop(&line.concat(), &zone.span(), &format!("{what} `{}`", s.name))?;
        let plane = upright(line, [low, high]);
        let sound = plane.half.x.is_finite() && plane.half.x > 0.0 && low >= 0.0 && high > low && high < 10.0;
        self.that(sound, zone.span(), || {
            (format!("the plane of {what} `{}` has no extent", s.name), "two ends, two heights, in m".to_owned())
        })?;
        Ok(plane)
    }

    /// The plane of a two-hand control's buttons: farther to all sides than an arm gets past it.
    fn buttons(&self, s: &SensorTable, zone: &Spanned<ZoneTable>, post: &[[f64; 2]]) -> Result<Cuboid, Box<CellError>> {
        let Some(line) = zone.get_ref().line_m else {
            let message = format!("two-hand control `{}` does not say where its buttons are", s.name);
            let help = "beside polygon_m, where its operator stands, add line_m: two points on the line of the buttons";
            return Err(self.source.error(zone.span(), "here", message, Some(help.to_owned())));
        };
        self.that(zone.get_ref().heights_m.is_none(), zone.span(), || {
            let message = format!("two-hand control `{}` has heights_m, which are not read", s.name);
            (message, "remove them: hands that hold it are nowhere behind it".to_owned())
        })?;
        let narrow = upright(line, [0.0, 2.0 * ASIDE_M]);
        let sound = narrow.half.x.is_finite() && narrow.half.x > 0.0;
        self.that(sound, zone.span(), || {
            (
                format!("the line of two-hand control `{}` has no length", s.name),
                "two different points, in m".to_owned(),
            )
        })?;
        let side = |[x, y]: &[f64; 2]| (narrow.rotation * Vec3::Y).dot(Vec3::new(*x, *y, 0.0) - narrow.centre);
        let one_side = post.iter().all(|p| side(p) > 0.0) || post.iter().all(|p| side(p) < 0.0);
        self.that(one_side, zone.span(), || {
            let message = format!("the line of two-hand control `{}` goes through its operator's post", s.name);
            (
                message,
                "the buttons are in front of the operator: all corners of polygon_m on one side of line_m".to_owned(),
            )
        })?;
        Ok(Cuboid { half: narrow.half.with_x(narrow.half.x + ASIDE_M), ..narrow })
    }
}

/// Height of a scanner field above the floor unless told otherwise, m.
const FIELD_HEIGHT_M: f64 = 0.2;

/// What people do of which where their feet are says little.
const LOW: [Ability; 3] = [Ability::Kneel, Ability::Crouch, Ability::Crawl];

/// A plane that begins no higher has the legs of everybody in it who stands in it, bent or not, m.
const LEGS_M: f64 = 0.5;

/// Shortest step with a light curtain, a door or a two-hand control, s: in 64 of them a hand gets as far as an arm is long.
const SHORTEST_S: f64 = 0.01;

/// As far as that is, m.
const FOLLOWED_M: f64 = 64.0 * SHORTEST_S * HAND_SPEED_M_S;

/// How far the plane of a two-hand control goes on beside its buttons, and half its height, m: more than any arm is long.
const ASIDE_M: f64 = 3.0;

/// An upright plane over a line on the floor, m, as a box without thickness.
fn upright([from, to]: [[f64; 2]; 2], [low, high]: [f64; 2]) -> Cuboid {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    Cuboid {
        centre: Vec3::new(0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), 0.5 * (low + high)),
        half: Vec3::new(0.5 * libm::hypot(dx, dy), 0.0, 0.5 * (high - low)),
        rotation: rotation_about(Vec3::Z, libm::atan2(dy, dx)),
    }
}

#[cfg(test)]
mod tests {
    use crate::cell::error::Source;
    use crate::cell::file::validate::validate;

    /// The response time of a mat, in steps of 20 ms, in a cell file that has it in ms.
    fn delay_steps(delay_ms: &str) -> usize {
        let text = format!(
            "schema = 1\nname = \"t\"\nfmu = \"t.fmu\"\n[time]\nstep_s = 0.02\n[[robot]]\nname = \"r\"\n\
             moving_mass_kg = 40\npayload_kg = 3\n[[robot.joint]]\nname = \"table\"\naxis = [0, 0, 1]\n\
             angle = {{ variable = \"q\", unit = \"rad\" }}\nspeed = {{ variable = \"qd\", unit = \"rad/s\" }}\n\
             [[robot.link]]\nname = \"bar\"\njoint = \"table\"\n\
             capsule = {{ from_m = [0, 0, 1], to_m = [0.8, 0, 1], radius_m = 0.05 }}\n\
             [[sensor]]\nname = \"mat\"\nkind = \"mat\"\nvariable = \"seen\"\nactive = true\n\
             delay_ms = {delay_ms}\nzone = {{ polygon_m = [[-1, -1], [1, -1], [1, 1]] }}\n\
             [human]\nstart = {{ xy_m = [0, -3], heading_deg = 90 }}\n"
        );
        validate(&Source::new("t.toml", &text)).unwrap().sensors[0].delay_steps
    }

    /// A sensor that answers within a step is late by all of it: 24 ms are 1.2 steps and 41 ms are 2.05.
    #[test]
    fn response_times_are_rounded_up_to_whole_steps() {
        for (delay_ms, steps) in [("0", 0), ("1", 1), ("20", 1), ("24", 2), ("40", 2), ("41", 3), ("1260", 63)] {
            assert_eq!(delay_steps(delay_ms), steps, "{delay_ms} ms");
        }
    }
}
