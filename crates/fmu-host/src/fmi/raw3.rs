//! What only FMI 3.0 does its way: instantiation, Event Mode, steps that end early.
#![expect(unsafe_code, reason = "calls the C functions of a loaded FMU")]

use std::ptr;

use super::abi::{self, Plain};
use super::abi3::Functions;
use super::error::Error;
use super::library::{Slave, Table};
use super::log::{Environment, log_message};
use super::raw::{Raw, c_text};
use fmu_self_test::number;

/// Rounds of event iteration before an FMU is taken to have no end.
const EVENT_ROUNDS: usize = 100;
/// `fmi3DoStep` calls for one communication step before an FMU is taken to have no end.
const PARTS: usize = 1000;
/// How far, relative to the communication time, the time an FMU reached may be off and still be the one asked for:
/// FMUs add up their internal steps.
const TIME_TOLERANCE: f64 = 1e-9;
/// What stands where an FMU writes how far it came, until it does: no time.
const NOT_WRITTEN: f64 = f64::MIN;

/// `fmi3InstantiateCoSimulation`.
pub(super) fn instantiate(slave: &Slave, functions: &Functions, name: &str, events: bool) -> Result<Raw, Error> {
    let (name, token) = (c_text(name)?, c_text(slave.guid())?);
    let resources = slave.resources().map(c_text).transpose()?;
    let environment = Box::<Environment>::default();
    // SAFETY: all pointers are valid during the call; the environment lives in a box that the instance keeps until it
    // is freed. No intermediate variables are asked for, as there is no callback for them.
    let component = unsafe {
        (functions.instantiate)(
            name.as_ptr(),
            token.as_ptr(),
            resources.as_ref().map_or(ptr::null(), |r| r.as_ptr()),
            false,
            false,
            events,
            // Without Event Mode nobody would bring an FMU through the event that it ended a step for.
            events,
            ptr::null(),
            0,
            environment.address(),
            log_message,
            ptr::null(),
        )
    };
    Raw::adopt(slave, component, environment, None, events)
}

/// What one `fmi3DoStep` said.
struct DoStepResult {
    reached: f64,
    event: bool,
}

impl Raw {
    /// `fmi3EnterInitializationMode`.
    pub(super) fn enter_initialization3(&mut self, f: &Functions, start: f64, stop: Option<f64>) -> Result<(), Error> {
        // SAFETY: the instance is alive and freshly instantiated or reset.
        let status = unsafe {
            (f.enter_initialization_mode)(self.component, false, 0.0, start, stop.is_some(), stop.unwrap_or(0.0))
        };
        self.now = start;
        self.check("fmi3EnterInitializationMode", status)
    }

    /// `fmi3DoStep`, as often as it takes to reach `time + step`, with the events on the way.
    pub(super) fn do_step3(&mut self, f: &Functions, time: f64, step: f64) -> Result<(), Error> {
        let end = time + step;
        let tolerance = TIME_TOLERANCE * end.abs().max(step);
        let (mut at, mut rest) = (time, step);
        for _ in 0..PARTS {
            self.now = at;
            let to = self
                .next_event
                .filter(|next| self.stops_at_any_time() && (at + tolerance..end - tolerance).contains(next));
            let part = self.part(f, at, to.map_or(rest, |to| to - at))?;
            let aim = to.unwrap_or(end);
            if !(at - tolerance..=aim + tolerance).contains(&part.reached) {
                let message = format!(
                    "the FMU says it reached t = {} s in a step from t = {at} s that was to end at t = {aim} s",
                    number(part.reached)
                );
                return Err(self.misbehaved(message));
            }
            self.now = part.reached;
            let due = self.next_event.is_some_and(|next| next <= part.reached + tolerance);
            if (part.event || due) && self.events {
                self.enter_event_mode()?;
                self.settle()?;
            } else if part.event {
                self.may_go_on_without_event_mode(part.reached >= end - tolerance)?;
            }
            if part.reached >= end - tolerance {
                return Ok(());
            }
            // An event may be found where the step began; without one the next call would be the same again.
            if part.reached <= at && !part.event {
                let message = format!(
                    "the FMU ended the step from t = {at} s to t = {end} s early, at t = {} s, and so makes no progress",
                    part.reached
                );
                return Err(self.misbehaved(message));
            }
            at = part.reached;
            rest = end - at;
        }
        let message =
            format!("the FMU ended the step from t = {time} s to t = {end} s early {PARTS} times and is at t = {at} s");
        Err(self.misbehaved(message))
    }

    /// One `fmi3DoStep`.
    fn part(&mut self, f: &Functions, time: f64, step: f64) -> Result<DoStepResult, Error> {
        let (mut event, mut end, mut early) = (0, 0, 0);
        let mut reached = NOT_WRITTEN;
        // SAFETY: the instance is alive and in Step Mode; the results are written during the call. States from before
        // `time` may be restored later, so the promise not to is never given.
        let status = unsafe {
            (f.do_step)(
                self.component,
                time,
                step,
                false,
                &raw mut event,
                &raw mut end,
                &raw mut early,
                &raw mut reached,
            )
        };
        if status != abi::OK && status != abi::WARNING {
            return Err(self.failure("fmi3DoStep", status, Some(time), None));
        }
        if reached.to_bits() == NOT_WRITTEN.to_bits() {
            if early != 0 {
                let message = format!("the FMU ended the step from t = {time} s early and does not say when");
                return Err(self.misbehaved(message));
            }
            // FMUs that never end a step early are known to forget this one.
            reached = time + step;
        }
        if end != 0 {
            return Err(self.ended(reached));
        }
        Ok(DoStepResult { reached, event: event != 0 })
    }

    /// An FMU wants an event to be handled that was told that no Event Mode is used. One that has none handles its events itself, and
    /// some of these say so at the end of a step all the same; others would go on without the event.
    fn may_go_on_without_event_mode(&self, at_the_end: bool) -> Result<(), Error> {
        let has_event_mode = self.slave.capabilities().has_event_mode;
        if at_the_end && !has_event_mode {
            self.slave.leaves_event(self.now);
            return Ok(());
        }
        let why = match has_event_mode {
            true => "though it was told that Event Mode is not used",
            false => "which its modelDescription.xml does not offer (hasEventMode)",
        };
        let now = number(self.now);
        Err(self.misbehaved(format!(
            "the FMU ended a step at t = {now} s for an event that is to be handled in Event Mode, {why}"
        )))
    }

    /// Whether a step may end wherever the importer likes.
    fn stops_at_any_time(&self) -> bool {
        self.slave.capabilities().can_handle_variable_step
    }

    /// `fmi3EnterEventMode`.
    pub(super) fn enter_event_mode(&mut self) -> Result<(), Error> {
        self.callable()?;
        self.plain("fmi3EnterEventMode", |f| f.enter_event_mode)
    }

    /// In Event Mode: `fmi3UpdateDiscreteStates` until nothing changes, then `fmi3EnterStepMode`. Steps end at the next event that
    /// the FMU announces then, if it can stop there, and at the first point after it, if not.
    pub(super) fn settle(&mut self) -> Result<(), Error> {
        const NAME: &str = "fmi3UpdateDiscreteStates";
        let Table::V3(f) = self.slave.table() else { return Ok(()) };
        let update = f.update_discrete_states.ok_or(Error::MissingFunction(NAME))?;
        for _ in 0..EVENT_ROUNDS {
            let (mut again, mut end, mut nominals, mut values, mut timed, mut next) = (0, 0, 0, 0, 0, 0.0);
            // SAFETY: the instance is alive and in Event Mode; the results are written during the call.
            let status = unsafe {
                update(
                    self.component,
                    &raw mut again,
                    &raw mut end,
                    &raw mut nominals,
                    &raw mut values,
                    &raw mut timed,
                    &raw mut next,
                )
            };
            self.check(NAME, status)?;
            if end != 0 {
                return Err(self.ended(self.now));
            }
            if again == 0 {
                self.next_event = (timed != 0).then_some(next);
                let earliest = self.now - TIME_TOLERANCE * self.now.abs().max(1.0);
                if self.next_event.is_some_and(|next| next.is_nan() || next < earliest) {
                    return Err(self.misbehaved(format!(
                        "the FMU announces its next event for t = {} s, at t = {} s",
                        number(next),
                        number(self.now)
                    )));
                }
                return self.plain("fmi3EnterStepMode", |f| f.enter_step_mode);
            }
        }
        Err(self.misbehaved(format!(
            "the FMU's events at t = {} s do not come to rest: it asks for another round after {EVENT_ROUNDS}",
            self.now
        )))
    }

    fn plain(&mut self, name: &'static str, pick: impl Fn(&Functions) -> Option<Plain>) -> Result<(), Error> {
        let Table::V3(f) = self.slave.table() else { return Ok(()) };
        let function = pick(f).ok_or(Error::MissingFunction(name))?;
        // SAFETY: the instance is alive and in the mode that this call leaves.
        let status = unsafe { function(self.component) };
        self.check(name, status)
    }
}
