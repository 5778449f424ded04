//! Checks of what `explain` may change: the names are there, and what is said of them fits. FMU parameters are looked up
//! where variables are bound.

use std::ops::Range;

use super::checker::Checker;
use super::format::CellFile;
use crate::cell::CellError;
use crate::cell::error::nearest;
use crate::fmi::number;

impl Checker<'_> {
    /// All of `[explain]`.
    pub(super) fn limits(&self, file: &CellFile) {
        let explain = &file.explain;
        for (name, limits) in &explain.parameters {
            let (span, limits) = (limits.span(), limits.get_ref());
            let told = self.numbers(&[("least", limits.least), ("most", limits.most)], f64::NEG_INFINITY, &span);
            let _ = self.problems.keep(told);
            let order = limits.least.zip(limits.most).is_none_or(|(least, most)| least <= most);
            let _ = self.problems.keep(self.that(order, span.clone(), || {
                let message = format!("`least` of parameter `{name}` is above `most`");
                (message, "exchange the two".to_owned())
            }));
            let others = limits.least.is_some() || limits.most.is_some() || limits.never_smaller || limits.never_larger;
            let _ = self.problems.keep(self.fixed_alone(limits.fixed, others, &span));
        }
        for (name, limits) in &explain.sensor {
            let (span, limits) = (limits.span(), limits.get_ref());
            let names = file.sensors.iter().map(|sensor| sensor.name.as_str());
            let Some(()) = self.problems.keep(self.named("sensor", name, names, &span)) else { continue };
            let lengths = [
                ("most_wider_m", limits.most_wider_m),
                ("most_top_m", limits.most_top_m),
                ("most_farther_m", limits.most_farther_m),
            ];
            let _ = self.problems.keep(self.numbers(&lengths, 0.0, &span));
            let others = lengths.iter().any(|(_, length)| length.is_some());
            let _ = self.problems.keep(self.fixed_alone(limits.fixed, others, &span));
            let sensor = file.sensors.iter().find(|sensor| sensor.name == *name);
            let changes = sensor.map_or(&[][..], |sensor| sensor.kind.changes());
            let takes: Vec<&str> = changes.iter().filter_map(|change| change.limit()).collect();
            for (key, _) in lengths.iter().filter(|(key, length)| length.is_some() && !takes.contains(key)) {
                let help = match takes[..] {
                    [] => "`explain` never changes it: remove this".to_owned(),
                    _ => format!("for this kind of sensor there is {}", takes.join(" and ")),
                };
                let message = format!("{key} does not fit sensor `{name}`");
                self.problems.tell(self.source.error(span.clone(), "here", message, Some(help)));
            }
        }
        for (name, limits) in &explain.obstacle {
            let (span, limits) = (limits.span(), limits.get_ref());
            let names = file.obstacles.iter().map(|obstacle| obstacle.name.get_ref().as_str());
            let Some(()) = self.problems.keep(self.named("obstacle", name, names, &span)) else { continue };
            let lengths = [("most_top_m", limits.most_top_m), ("least_underside_m", limits.least_underside_m)];
            let _ = self.problems.keep(self.numbers(&lengths, 0.0, &span));
            let others = lengths.iter().any(|(_, length)| length.is_some());
            let _ = self.problems.keep(self.fixed_alone(limits.fixed, others, &span));
            let mesh = file.obstacles.iter().any(|obstacle| obstacle.name.get_ref() == name && obstacle.mesh.is_some());
            let _ = self.problems.keep(self.that(!mesh || !others, span, || {
                let message = format!("obstacle `{name}` is a mesh, whose height `explain` never changes");
                (message, "remove this".to_owned())
            }));
        }
        for (name, limits) in &explain.robot {
            let (span, limits) = (limits.span(), limits.get_ref());
            let names = file.robots.iter().map(|robot| robot.get_ref().name.as_str());
            let Some(()) = self.problems.keep(self.named("robot", name, names, &span)) else { continue };
            let _ = self.problems.keep(self.numbers(&[("most_farther_m", limits.most_farther_m)], 0.0, &span));
            let _ = self.problems.keep(self.fixed_alone(limits.fixed, limits.most_farther_m.is_some(), &span));
        }
    }

    fn named<'n>(
        &self,
        what: &str,
        name: &str,
        names: impl Iterator<Item = &'n str> + Clone,
        span: &Range<usize>,
    ) -> Result<(), Box<CellError>> {
        self.that(names.clone().any(|known| known == name), span.clone(), || {
            let help = match nearest(name, names.clone()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!("the cell has {}", names.collect::<Vec<_>>().join(", ")),
            };
            (format!("the cell has no {what} `{name}` that `explain` could change"), help)
        })
    }

    fn numbers(&self, all: &[(&str, Option<f64>)], least: f64, span: &Range<usize>) -> Result<(), Box<CellError>> {
        for (key, value) in all.iter().filter_map(|(key, value)| Some((key, (*value)?))) {
            self.that(value.is_finite() && value >= least, span.clone(), || {
                (format!("{key} is {}", number(value)), "use a plain number, for lengths zero or more".to_owned())
            })?;
        }
        Ok(())
    }

    fn fixed_alone(&self, fixed: bool, others: bool, span: &Range<usize>) -> Result<(), Box<CellError>> {
        self.that(!fixed || !others, span.clone(), || {
            ("what is fixed has no range".to_owned(), "remove `fixed` or the others".to_owned())
        })
    }
}
