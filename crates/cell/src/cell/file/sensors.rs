//! Checks of the sensors in a cell file: zones and response times.

use toml::Spanned;

use super::checker::Checker;
use super::format::{CellFile, DetectionZoneTable, SensorTable, ValuesTable};
use crate::cell::CellError;
use crate::cell::sensor::kind::{Key, Zoned};
use crate::cell::sensor::written::Written;
use crate::cell::sensor::zone::heights;
use crate::cell::sensor::{DetectionZone, KINDS, Placing, Sensor, SensorKind, Signal};
use crate::fmi;
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
        let zone = match (s.kind.zone(), &s.zone) {
            (Zoned::InFmu, None) => DetectionZone::InFmu,
            (Zoned::InFmu, Some(zone)) => {
                let message = format!("sensor `{}` is inside the FMU and has no zone here", s.name);
                return Err(self.source.error(zone.span(), "here", message, Some("remove the zone".to_owned())));
            }
            (Zoned::Written(_), None) => {
                let message = format!("sensor `{}` has no zone", s.name);
                let help = Some(
                    "add zone = { polygon_m = [[x, y], ...] }, or line_m for a light curtain or a door".to_owned(),
                );
                return Err(self.source.error(span, "for this sensor", message, help));
            }
            (Zoned::Written(read), Some(zone)) => read(&Zone { checker: self, name: &s.name, zone })?,
        };
        let delay_ms = s.delay_ms.as_ref().map_or(0.0, |d| *d.get_ref());
        self.that(delay_ms == 0.0 || !zone.is_in_fmu(), span.clone(), || {
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
        self.evaluated(s, &zone, file)?;
        let latched = self.latched(s)?;
        let placing = self.placing(s)?;
        Ok((Sensor { name: s.name.clone(), kind: s.kind, zone, signal, delay_steps, latched }, placing))
    }

    /// Whether the input of a sensor is held: of one that the FMU does not evaluate itself, else it knows better.
    fn latched(&self, s: &SensorTable) -> Result<bool, Box<CellError>> {
        let Some(latched) = &s.latched else { return Ok(false) };
        self.belongs(s, ("latched", Key::Latched), &latched.span())?;
        self.that(s.evaluated.is_none() || !*latched.get_ref(), latched.span(), || {
            let message = format!("the FMU evaluates sensor `{}` itself: its input alone cannot be held", s.name);
            (message, "leave `latched` or `evaluated` out".to_owned())
        })?;
        Ok(*latched.get_ref())
    }

    /// Whether the FMU can evaluate a sensor as far as it knows the person's pose: where the feet are, and not how they stand.
    fn evaluated(&self, s: &SensorTable, zone: &DetectionZone, file: &CellFile) -> Result<(), Box<CellError>> {
        let Some(table) = &s.evaluated else { return Ok(()) };
        let span = table.span();
        self.that(s.values.is_none() || table.get_ref().active.is_some(), span.clone(), || {
            let message = format!("which value of `{}` means a person is not said", table.get_ref().variable.get_ref());
            (message, "add active = true or false: that of the sensor is told by numbers".to_owned())
        })?;
        self.belongs(s, ("evaluated", Key::Evaluated), &span)?;
        self.that(!file.pose.is_empty(), span.clone(), || {
            let message = format!("the FMU evaluates sensor `{}` and is not told where the person is", s.name);
            (message, "add [pose] with the inputs that tell it".to_owned())
        })?;
        let own = s.zone.as_ref().and_then(|zone| zone.get_ref().heights_m);
        let low_m = own.or_else(|| zone.walked_through().map(heights)).map_or(0.0, |[low, _]| low);
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
        for (key, name, value, most) in [
            (Key::Resolution, "resolution_mm", &s.resolution_mm, 500.0),
            (Key::OpeningGap, "opening_mm", &s.opening_mm, 10_000.0),
            (Key::OpeningTime, "opening_ms", &s.opening_ms, 60_000.0),
        ] {
            let Some(value) = value else { continue };
            self.belongs(s, (name, key), &value.span())?;
            self.between(s, name, value, most)?;
        }
        if let Some(beams) = &s.beams {
            let noun = s.kind.noun();
            self.belongs(s, ("beams", Key::Beams), &beams.span())?;
            self.that((1..=100).contains(beams.get_ref()), beams.span(), || {
                (format!("{noun} `{}` has {} beams", s.name, beams.get_ref()), "use 1 to 100".to_owned())
            })?;
            self.that(s.resolution_mm.is_none(), beams.span(), || {
                let message = format!("{noun} `{}` has both beams and a resolution", s.name);
                (message, "beams for a row of single ones, resolution_mm for a curtain".to_owned())
            })?;
        }
        if let Some(supplement) = &s.supplement_mm {
            self.that(!s.kind.is_in_fmu(), supplement.span(), || {
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
            height_m: s.zone.as_ref().and_then(|zone| zone.get_ref().height_m),
            line_m: s.zone.as_ref().and_then(|zone| zone.get_ref().line_m),
            opening: Opening { gap_m: thousandth(&s.opening_mm), time_s: thousandth(&s.opening_ms).unwrap_or(0.0) },
            supplement_m: thousandth(&s.supplement_mm).unwrap_or(0.0),
        })
    }

    /// Whether a key is of this kind of sensor.
    fn belongs(
        &self,
        s: &SensorTable,
        (name, key): (&str, Key),
        span: &std::ops::Range<usize>,
    ) -> Result<(), Box<CellError>> {
        self.that(s.kind.has(key), span.clone(), || {
            let of: Vec<String> =
                SensorKind::all_with(KINDS, key).iter().map(|kind| format!("a {}", kind.noun())).collect();
            (format!("sensor `{}` has {name}, which only {} has", s.name, of.join(" or ")), format!("remove {name}"))
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
}

/// The zone of a sensor.
struct Zone<'a> {
    checker: &'a Checker<'a>,
    name: &'a str,
    zone: &'a Spanned<DetectionZoneTable>,
}

impl Written for Zone<'_> {
    fn name(&self) -> &str {
        self.name
    }

    fn polygon_m(&self) -> Result<Vec<[f64; 2]>, Box<CellError>> {
        let (polygon, span) = (self.zone.get_ref().polygon_m.clone().unwrap_or_default(), self.zone.span());
        let what = format!("the zone of sensor `{}`", self.name);
        self.checker.that(polygon.len() >= 3, span.clone(), || {
            (format!("{what} needs at least three corners"), "[[x, y], ...] in m".to_owned())
        })?;
        self.checker.finite(&polygon.concat(), &span, &what)?;
        self.checker.plain_polygon(&polygon, &span, &what)?;
        Ok(polygon)
    }

    fn line_m(&self) -> Option<[[f64; 2]; 2]> {
        self.zone.get_ref().line_m
    }

    fn heights_m(&self) -> Option<[f64; 2]> {
        self.zone.get_ref().heights_m
    }

    fn height_m(&self) -> Option<f64> {
        self.zone.get_ref().height_m
    }

    fn of_a_workshop(&self, lengths_m: &[f64], what: &str) -> Result<(), Box<CellError>> {
        self.checker.of_a_workshop(lengths_m, &self.zone.span(), what)
    }

    fn wrong(&self, message: String, help: &str) -> Box<CellError> {
        self.checker.source.error(self.zone.span(), "here", message, Some(help.to_owned()))
    }
}

/// What people do of which where their feet are says little.
const LOW: [Ability; 3] = [Ability::Kneel, Ability::Crouch, Ability::Crawl];

/// A plane that begins no higher has the legs of everybody in it who stands in it, bent or not, m.
const LEGS_M: f64 = 0.5;

/// Shortest step with a light curtain, a door or a two-hand control, s: in 64 of them a hand gets as far as an arm is long.
const SHORTEST_S: f64 = 0.01;

/// As far as that is, m.
const FOLLOWED_M: f64 = 64.0 * SHORTEST_S * HAND_SPEED_M_S;

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
