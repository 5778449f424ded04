//! `faulty`: one slowly turning joint that misbehaves on demand, for tests of importers.
//!
//! Without a fault it is an honest model with a hidden part: the speed also depends on a clock that no variable shows,
//! so an importer that compares only the variables after a restore cannot see whether the clock was restored.

use crate::bytes::{Reader, Writer};
use crate::interface::faulty::vr;
use crate::interface::variables::Value;
use crate::model::{Model, Outcome, Special};
use std::sync::atomic::{AtomicU32, Ordering};

/// Speed of the drive at full pace, rad/s.
const SPEED: f64 = 0.5;
/// How fast the drive changes its speed, rad/s^2.
const ACCELERATION: f64 = 1.0;
/// Period of the hidden clock, ms: the drive runs up to 20 % faster in its middle.
const PERIOD: u64 = 700;

/// The step that faults 18 to 21 count on, ms.
const CYCLE: u64 = 20;

/// How many instances this process has made: what fault 5 depends on.
static INSTANCES: AtomicU32 = AtomicU32::new(0);

/// Parameters, inputs and state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Faulty {
    kind: i32,
    step: i32,
    stop: bool,
    push: f64,
    q: f64,
    qd: f64,
    drive: f64,
    /// Milliseconds; hidden.
    clock: u64,
    steps_made: i32,
    /// Fault 12 and the like: an event waits to be handled.
    event: bool,
    /// Fault 12 and the like: the event was handled, the drive runs at double pace.
    fast: bool,
    instance: u32,
}

impl Faulty {
    /// The start values; the joint already turns.
    pub fn new() -> Self {
        Self::numbered(INSTANCES.fetch_add(1, Ordering::Relaxed).wrapping_add(1))
    }

    fn numbered(instance: u32) -> Self {
        Self {
            kind: 0,
            step: 0,
            stop: false,
            push: 0.0,
            q: 0.0,
            qd: SPEED,
            drive: SPEED,
            clock: 0,
            steps_made: 0,
            event: false,
            fast: false,
            instance,
        }
    }

    /// Whether a lasting fault of this kind is in force.
    fn has(&self, kind: i32) -> bool {
        self.kind == kind && self.steps_made >= self.step
    }

    /// Fault 7.
    pub fn shares_saved_states(&self) -> bool {
        self.has(7)
    }

    /// Back to a saved state; with fault 6 the clock runs on.
    pub fn restore(&mut self, saved: &Self) {
        let clock = if self.has(6) { self.clock } else { saved.clock };
        *self = Self { clock, ..*saved };
    }

    /// Back to the start values; with fault 8 nothing happens.
    pub fn reset(&mut self) {
        if !self.has(8) {
            *self = Self::numbered(self.instance);
        }
    }

    /// Faults 10 to 13, 16 and 17, which concern the step as a whole and thus the importer.
    pub fn special(&self) -> Special {
        match self.kind {
            _ if self.steps_made != self.step => Special::None,
            10 => Special::EarlyReturn,
            11 => Special::Terminate,
            12 => Special::Event,
            13 => Special::WrongTime,
            16 => Special::EventHalfway,
            17 => Special::EventLeft,
            _ => Special::None,
        }
    }

    /// Faults 18 to 20: when their event is, ms: halfway in a step of 20 ms.
    fn event_at(&self) -> u64 {
        u64::from(self.step.unsigned_abs()) * CYCLE + CYCLE / 2
    }

    /// Faults 18 and 20 (with an event mode, or without): the event that is still to come, ms.
    pub fn announced(&self) -> Option<u64> {
        (matches!(self.kind, 18 | 20) && self.clock < self.event_at()).then(|| self.event_at())
    }

    /// Fault 20 forgets its event where no event mode is used.
    pub fn handles_announced(&self) -> bool {
        self.kind == 18
    }

    /// Fault 12 and the like: from now on the drive speeds up.
    pub fn handle_event(&mut self) {
        self.fast |= std::mem::take(&mut self.event);
    }

    /// Reads what `write` wrote.
    pub fn read(input: &mut Reader) -> Option<Self> {
        Some(Self {
            kind: input.i32()?,
            step: input.i32()?,
            stop: input.bool()?,
            push: input.f64()?,
            q: input.f64()?,
            qd: input.f64()?,
            drive: input.f64()?,
            clock: input.u64()?,
            steps_made: input.i32()?,
            event: input.bool()?,
            fast: input.bool()?,
            instance: u32::try_from(input.u64()?).ok()?,
        })
    }

    fn value(&self, variable: usize) -> Value {
        // A fault of step n shows in the outputs after step n: steps_made is n + 1 then.
        let shows = |kind| self.kind == kind && self.steps_made > self.step;
        match variable {
            vr::FAULT_KIND => Value::Integer(self.kind),
            vr::FAULT_STEP => Value::Integer(self.step),
            vr::STOP => Value::Boolean(self.stop),
            vr::PUSH => Value::Real(self.push),
            vr::Q if shows(1) => Value::Real(f64::NAN),
            vr::Q if shows(5) => Value::Real(self.q + 1e-3 * f64::from(self.instance)),
            vr::Q if shows(9) => Value::Real(f64::INFINITY),
            vr::Q | vr::QD if self.kind == 14 && self.steps_made == 0 => Value::Real(0.0),
            vr::Q if self.kind == 14 => Value::Real(self.q + 1.2),
            vr::Q if shows(15) => Value::Real(self.q + 0.5),
            vr::Q => Value::Real(self.q),
            vr::QD => Value::Real(self.qd),
            _ => Value::Real(f64::NAN),
        }
    }

    /// The drive's controller, which takes this time for the one since it was last called, s.
    fn control(&mut self, time: f64) {
        let pace = if self.fast { 2.0 * SPEED } else { SPEED };
        let target = if self.stop { 0.0 } else { pace };
        let change = ACCELERATION * time;
        self.drive += (target - self.drive).clamp(-change, change);
    }

    fn millisecond(&mut self) {
        if self.kind != 21 {
            self.control(1e-3);
        }
        let phase = self.clock % PERIOD;
        let triangle = phase.min(PERIOD - phase);
        #[expect(clippy::cast_precision_loss, reason = "below 350")]
        let swell = 1.0 + 0.2 * triangle as f64 / (PERIOD as f64 / 2.0);
        self.qd = self.drive * swell + self.push;
        self.q += self.qd * 1e-3;
        self.clock = self.clock.wrapping_add(1);
        self.event |= matches!(self.kind, 18 | 20) && self.clock == self.event_at();
    }
}

impl Model for Faulty {
    fn set(&mut self, variable: usize, value: Value) {
        match (variable, value) {
            (vr::FAULT_KIND, Value::Integer(n)) => self.kind = n,
            (vr::FAULT_STEP, Value::Integer(n)) => self.step = n,
            (vr::STOP, Value::Boolean(x)) => self.stop = x,
            (vr::PUSH, Value::Real(x)) => self.push = x,
            _ => {}
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        for (place, value) in values.iter_mut().enumerate() {
            *value = self.value(place);
        }
    }

    fn step(&mut self, ticks: u64) -> Outcome {
        if self.steps_made == self.step {
            match self.kind {
                2 => return Outcome::Failed("the model was asked to fail in this step (fault.kind = 2)".to_owned()),
                3 => return Outcome::Discarded("the model was asked to refuse this step (fault.kind = 3)".to_owned()),
                4 => return Outcome::Fatal("the model was asked to die in this step (fault.kind = 4)".to_owned()),
                _ => {}
            }
        }
        if self.kind == 21 {
            self.control(0.02);
        }
        for _ in 0..ticks {
            self.millisecond();
        }
        // Fault 19 looks for its event where a step ends, and nowhere else.
        self.fast |= self.kind == 19 && self.clock == self.event_at();
        self.event |= matches!(self.special(), Special::Event | Special::EventHalfway | Special::EventLeft);
        self.steps_made = self.steps_made.saturating_add(1);
        Outcome::Done
    }

    fn write(&self, out: &mut Writer) {
        out.i32(self.kind);
        out.i32(self.step);
        out.bool(self.stop);
        for value in [self.push, self.q, self.qd, self.drive] {
            out.f64(value);
        }
        out.u64(self.clock);
        out.i32(self.steps_made);
        out.bool(self.event);
        out.bool(self.fast);
        out.u64(u64::from(self.instance));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_by_hand_calculated_amounts() {
        let mut model = Faulty::new();
        model.step(700);
        // One period of the clock: mean swell 1.1 over 0.7 s at 0.5 rad/s.
        assert!((model.q - 0.5 * 1.1 * 0.7).abs() < 1e-12);
        model.set(vr::STOP, Value::Boolean(true));
        model.step(600);
        assert_eq!(model.qd, 0.0);
        model.set(vr::PUSH, Value::Real(0.25));
        let before = model.q;
        model.step(100);
        assert!((model.q - before - 0.025).abs() < 1e-12);
    }

    #[test]
    fn the_clock_is_hidden_but_matters() {
        let mut honest = Faulty::new();
        honest.step(100);
        let saved = honest;
        honest.step(200);
        let mut forgetful = honest;
        forgetful.kind = 6;
        honest.restore(&saved);
        forgetful.restore(&saved);
        assert_eq!((honest.value(vr::Q), honest.value(vr::QD)), (forgetful.value(vr::Q), forgetful.value(vr::QD)));
        honest.step(20);
        forgetful.step(20);
        assert_ne!(honest.value(vr::Q), forgetful.value(vr::Q));
    }
}
