//! What a search from anywhere has to know before it can begin: what the robots do while nobody comes, where nobody is seen, and what
//! is reported of people elsewhere, which only the FMU knows of sensors that are inside it.

use super::trials::Kind;
use super::{AROUND_M, AnalysisContext, AnalysisEvent, EventSink, LONGEST_TOLD_S, Until, coarse, two_hand};
use crate::cell::Workcell;
use crate::host::{Hosted, PlantError, Policy};
use crate::human::{Action, Posture, Start, Walk};
use crate::obligations::{Need, Point};
use crate::reachability::internal_sensors::{InternalSensorMap as ToldPeople, InternalSensorProbe, StandingPose};
use crate::reachability::{MayReport, ReachabilitySearch as Search, known};
use crate::scan::cycle::{LONGEST_WATCHED_S, cycle, points};
use crate::scan::execution::ExecutionMode;
use crate::scan::hosting::StateChoice;
use crate::scan::prepare::Prepared;
use crate::sequences::Merge;
use crate::sim::robot::RobotFrame;

impl<'a> AnalysisContext<'a> {
    /// How long after the start of the FMU is looked, s; nothing if that is not known.
    pub(super) fn horizon(&mut self, first: &[bool]) -> Result<Option<f64>, PlantError> {
        let cycles = match self.effort.until {
            Until::Seconds(until_s) => return Ok(Some(until_s)),
            Until::Cycles(cycles) => cycles,
        };
        let MayReport::At(xy_m, heading) = self.unseen_start(first)? else { return Ok(None) };
        let start = Start::new(xy_m[0], xy_m[1], heading.to_degrees());
        let there = self.prepared.standing(start, 0, 1).map_err(|error| PlantError::of(error.to_string().as_str()))?;
        let (mut watched_s, step_s) = (8.0, there.cell.step_s);
        while watched_s <= LONGEST_WATCHED_S {
            let points: Vec<_> = self.watched(&there, watched_s)?.iter().map(points).collect();
            if let Some(found) = cycle(&points) {
                #[expect(clippy::cast_precision_loss, reason = "some thousand steps")]
                let steps = (found.from as f64 + f64::from(cycles) * found.steps).ceil();
                self.found.cycle_s = Some(found.steps * step_s);
                return Ok(Some(steps * step_s));
            }
            watched_s *= 2.0;
        }
        let why = format!(
            "how long a cycle is was not found: within {LONGEST_WATCHED_S:.0} s of the start the robots do not repeat what they do while \
             nobody comes"
        );
        self.said.push((Need::Searched, Point::open_until(why, "Say it in seconds, for instance --until 6s")));
        Ok(None)
    }

    /// The robots while somebody stands there for so long.
    fn watched(&mut self, there: &Prepared, watched_s: f64) -> Result<Vec<RobotFrame>, PlantError> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a minute of small steps")]
        let actions = (watched_s / there.cell.step_s).ceil() as usize / there.cell.steps_per_action + 1;
        let mut simulation = there.simulation(StateChoice::Replay, true)?;
        let watched = simulation.watch(&vec![Action::new(Walk::Stop, Posture::Upright); actions], &[])?;
        self.found.spent.fmu_steps += simulation.recall().steps();
        Ok(watched.instants.into_iter().map(|instant| instant.frame).collect())
    }

    /// What the robots do while somebody stands there.
    pub(super) fn unmoved(&mut self, there: &Prepared) -> Result<Vec<RobotFrame>, PlantError> {
        let cell = &there.cell;
        let mut simulation = there.simulation(StateChoice::Replay, true)?;
        let still = vec![Action::new(Walk::Stop, Posture::Upright); self.steps().div_ceil(cell.steps_per_action)];
        let watched = simulation.watch(&still, &[])?;
        self.found.spent.fmu_steps += simulation.recall().steps();
        self.rest.did = self.rest.did.and(simulation.recall().effort());
        self.motion.get_or_insert_default().merge(simulation.motion());
        let frames: Vec<RobotFrame> = watched.instants.into_iter().map(|instant| instant.frame).collect();
        let found = cycle(&frames.iter().map(points).collect::<Vec<_>>());
        self.found.cycle_s = self.found.cycle_s.or_else(|| found.map(|found| found.steps * cell.step_s));
        Ok(frames)
    }

    /// Where somebody may be of whom the sensors report `first`: decides nothing but where the person stands, as the FMU gets the
    /// same inputs everywhere. Where that is not known, the reasons say so.
    pub(super) fn unseen_start(&mut self, first: &[bool]) -> Result<MayReport, PlantError> {
        let (prepared, cell) = (self.prepared, &*self.prepared.cell);
        let probe = search(cell, &[], 0.0, prepared)?;
        if !cell.pose.is_empty() {
            // Only the FMU knows where nobody is seen: where the cell file says that people start, it may be.
            let starts =
                cell.beginnings.iter().map(|begins| (begins.start.xy_m(), begins.start.heading_deg().to_radians()));
            let may =
                |(xy_m, heading): &StandingPose| probe.is_possible(*xy_m, *heading, Posture::Upright, &known(first));
            for start in starts.filter(may) {
                let mut asking =
                    self.asking(prepared, ExecutionMode::asked(prepared, self.effort.state, Merge::Auto))?;
                if !asking.reports(start)?.last().is_some_and(|last| last.contains(&true)) {
                    return Ok(MayReport::At(start.0, start.1));
                }
            }
            self.open(
                Need::Searched,
                "sensors inside the FMU see whoever is where the cell file has people start: name a start at which nobody is seen",
            );
            return Ok(MayReport::Unknown);
        }
        let somewhere = probe.somewhere(first);
        if somewhere == MayReport::Unknown {
            let words = words(prepared, first);
            self.open(Need::Searched, format!("whether sensors ever report {words} is not known"));
        }
        Ok(somewhere)
    }

    /// Ready to ask the FMU what its sensors report of people.
    fn asking<'b>(
        &self,
        there: &'b Prepared,
        footing: ExecutionMode,
    ) -> Result<InternalSensorProbe<'b, Hosted>, PlantError> {
        let saves = matches!(footing.policy(there), Policy::States { max_checkpoints } if max_checkpoints > 0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some steps")]
        let steps = (LONGEST_TOLD_S / there.cell.step_s).ceil().max(1.0) as usize;
        InternalSensorProbe::new(footing.plant(there), &there.cell, &there.binding, steps, saves)
    }

    /// The search, with what sensors inside the FMU report, if it is told where people are; nothing if it was told to end, or if
    /// that cannot be known.
    pub(super) fn ask(
        &mut self,
        there: &Prepared,
        footing: ExecutionMode,
        (unmoved, nobody): (&[RobotFrame], StandingPose),
        tell: &mut EventSink<'_>,
    ) -> Result<Option<(Search<'a>, Option<ToldPeople>)>, PlantError> {
        // By the cell's own starts: the front of planes is on their side.
        let prepared = self.prepared;
        let cell = &*prepared.cell;
        if cell.pose.is_empty() {
            return Ok(Some((search(cell, unmoved, 0.0, prepared)?, None)));
        }
        let search = search(cell, unmoved, AROUND_M, prepared)?;
        if coarse(search.floor()).is_some() {
            // What an FMU reports is asked at corners of cells: between corners that are farther apart it may report anything.
            let why = "the floor with all that the cell file describes is too large to ask the FMU what its sensors report on it: leave out \
                       what is far from the robots";
            self.open(Need::Searched, why);
            return Ok(None);
        }
        let mut asking = self.asking(there, footing)?;
        if !asking.settle(search.floor(), &mut || tell(AnalysisEvent::Asked(0.0)).is_continue())? {
            return Ok(None);
        }
        let told = ToldPeople::ask(&mut asking, search.floor(), &mut |share| tell(AnalysisEvent::Asked(share)))?;
        let Some(told) = told else {
            if self.goes_on(tell) {
                self.open(Need::Searched, "sensors inside the FMU report too many different things together");
            }
            return Ok(None);
        };
        if !self.asked_later(&mut asking, &told, nobody, tell)? {
            return Ok(None);
        }
        self.found.spent.fmu_steps += asking.taken();
        let search = search.with(told.clone()).ok_or_else(PlantError::stopped)?;
        Ok(Some((search, Some(told))))
    }

    /// Everything that may be reported of somebody, and people of whom it is; `first` first. Nothing, where there is no time for it.
    pub(super) fn kinds(&self, search: &Search<'_>, told: Option<&ToldPeople>, first: &[bool]) -> Option<Vec<Kind>> {
        let sensors = &self.prepared.cell.sensors;
        let people = |readings: &[bool]| match told {
            Some(told) => told.people(readings, |sensor| sensors[sensor].zone.is_in_fmu()).collect(),
            None => vec![StandingPose::default()],
        };
        let mut all = search.readings()?;
        all.sort_by_key(|readings| readings != first);
        let kinds = all.into_iter().map(|readings| Kind { people: people(&readings), readings });
        Some(kinds.filter(|kind| !kind.people.is_empty()).collect())
    }
}

/// Ready to look; an error that says so, where there is no time for it.
fn search<'a>(
    cell: &'a Workcell,
    unmoved: &[RobotFrame],
    around_m: f64,
    prepared: &Prepared,
) -> Result<Search<'a>, PlantError> {
    Search::new(cell, unmoved.iter(), around_m, prepared.stop()).ok_or_else(PlantError::stopped)
}

/// Readings of two-hand controls in words.
fn words(prepared: &Prepared, readings: &[bool]) -> String {
    let of = |n: usize| {
        let hands = if readings[n] { "nobody at" } else { "both hands at" };
        format!("{hands} {}", prepared.cell.sensors[n].name)
    };
    two_hand(prepared).into_iter().map(of).collect::<Vec<_>>().join(" and ")
}
