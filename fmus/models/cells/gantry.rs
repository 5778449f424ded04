//! `gantry`: two slides that move back and forth, and a safety controller that does well or badly, as its parameters
//! say: for tests of what happens behind safeguards whose stop does not last.
//!
//! All of its state is whole numbers: milliseconds, and the pace in millionths. Positions follow from them.

use crate::bytes::{Reader, Writer};
use crate::interface::gantry::{AXES, vr};
use crate::interface::variables::Value;
use crate::model::{Model, Outcome};

/// Full pace.
const FULL: u64 = 1_000_000;
/// Units of programme time in a second: a millisecond at full pace is [`FULL`].
const SECOND: f64 = 1e9;

/// One slide.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Slide {
    stroke: f64,
    speed: f64,
    phase0: f64,
}

impl Slide {
    /// Position and velocity at full pace after so much programme time, in seconds.
    fn at(&self, time: f64) -> (f64, f64) {
        if self.stroke <= 0.0 || self.speed <= 0.0 {
            return (0.0, 0.0);
        }
        let way = (self.speed * (self.phase0 + time)) % (2.0 * self.stroke);
        if way < self.stroke { (way, self.speed) } else { (2.0 * self.stroke - way, -self.speed) }
    }
}

/// Parameters, inputs and state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gantry {
    latched: bool,
    reaction: u64,
    filter: u64,
    ramp: u64,
    muting: [u64; 2],
    fails_until: u64,
    slides: [Slide; AXES],
    curtain_clear: bool,
    door_clear: bool,
    reset: bool,
    gate_state: i32,
    mat_level: f64,
    /// Where the curtain is that sees people itself, how near, and where the person is.
    own: [f64; 3],
    /// Milliseconds since the start.
    tick: u64,
    /// How long the demand has lasted, ms; 0 without one.
    demanded: u64,
    /// Since when a stop is asked for, until it is over.
    stop_since: Option<u64>,
    reset_was_pressed: bool,
    /// 0 to [`FULL`].
    pace: u64,
    /// Sum of the pace over all milliseconds.
    programme: u64,
}

impl Gantry {
    /// The start values of the table; the slides move already.
    pub fn new() -> Self {
        Self {
            latched: true,
            reaction: 40,
            filter: 0,
            ramp: 200,
            muting: [0; 2],
            fails_until: 0,
            slides: [Slide::default(); AXES],
            curtain_clear: true,
            door_clear: true,
            reset: false,
            gate_state: 1,
            mat_level: 0.0,
            own: [0.0, 0.0, -1e3],
            tick: 0,
            demanded: 0,
            stop_since: None,
            reset_was_pressed: false,
            pace: FULL,
            programme: 0,
        }
    }

    /// Reads what `write` wrote.
    pub fn read(input: &mut Reader) -> Option<Self> {
        let mut model = Self::new();
        model.latched = input.bool()?;
        for value in [&mut model.reaction, &mut model.filter, &mut model.ramp].into_iter().chain(&mut model.muting) {
            *value = input.u64()?;
        }
        model.fails_until = input.u64()?;
        for slide in &mut model.slides {
            *slide = Slide { stroke: input.f64()?, speed: input.f64()?, phase0: input.f64()? };
        }
        model.curtain_clear = input.bool()?;
        model.door_clear = input.bool()?;
        model.reset = input.bool()?;
        model.gate_state = i32::try_from(input.u64()?).ok()?;
        model.mat_level = input.f64()?;
        for value in &mut model.own {
            *value = input.f64()?;
        }
        model.tick = input.u64()?;
        model.demanded = input.u64()?;
        let (stops, since) = (input.bool()?, input.u64()?);
        model.stop_since = stops.then_some(since);
        model.reset_was_pressed = input.bool()?;
        model.pace = input.u64()?;
        model.programme = input.u64()?;
        Some(model)
    }

    /// Whether the curtain itself sees the person.
    fn interrupted(&self) -> bool {
        let [at, depth, person] = self.own;
        depth > 0.0 && (person - at).abs() <= depth
    }

    fn millisecond(&mut self) {
        let muted = self.muting[0] <= self.tick && self.tick < self.muting[1];
        let numbers = self.gate_state != 1 || self.mat_level >= 0.5;
        let demand = numbers || !self.door_clear || ((!self.curtain_clear || self.interrupted()) && !muted);
        self.demanded = if demand { self.demanded.saturating_add(1) } else { 0 };
        let pressed = self.reset && !self.reset_was_pressed;
        self.reset_was_pressed = self.reset;
        if self.demanded > self.filter {
            self.stop_since.get_or_insert(self.tick);
        } else if !demand && (!self.latched || pressed) {
            self.stop_since = None;
        }
        let stops = self.stop_since.is_some_and(|since| since.saturating_add(self.reaction) <= self.tick);
        let change = FULL.div_ceil(self.ramp.max(1));
        self.pace = if stops { self.pace.saturating_sub(change) } else { self.pace.saturating_add(change).min(FULL) };
        self.programme = self.programme.saturating_add(self.pace);
        self.tick = self.tick.saturating_add(1);
    }

    /// Position and velocity of the slide.
    #[expect(clippy::cast_precision_loss, reason = "exact below 2^53: 104 days at full pace")]
    fn motion(&self, axis: usize) -> (f64, f64) {
        let (position, velocity) = self.slides[axis].at(self.programme as f64 / SECOND);
        (position, velocity * (self.pace as f64 / FULL as f64))
    }
}

/// Milliseconds of a parameter, which is never negative.
fn milliseconds(value: i32) -> u64 {
    u64::try_from(value).unwrap_or(0)
}

fn integer(value: u64) -> Value {
    Value::Integer(i32::try_from(value).unwrap_or(i32::MAX))
}

impl Model for Gantry {
    fn set(&mut self, variable: usize, value: Value) {
        match (variable, value) {
            (vr::LATCHED, Value::Boolean(x)) => self.latched = x,
            (vr::REACTION, Value::Integer(n)) => self.reaction = milliseconds(n),
            (vr::FILTER, Value::Integer(n)) => self.filter = milliseconds(n),
            (vr::RAMP, Value::Integer(n)) => self.ramp = milliseconds(n),
            (vr::MUTING_FROM, Value::Integer(n)) => self.muting[0] = milliseconds(n),
            (vr::MUTING_TO, Value::Integer(n)) => self.muting[1] = milliseconds(n),
            (vr::FAILS_UNTIL, Value::Integer(n)) => self.fails_until = milliseconds(n),
            (vr::STROKE..vr::SPEED, Value::Real(x)) => self.slides[variable - vr::STROKE].stroke = x,
            (vr::SPEED..vr::PHASE0, Value::Real(x)) => self.slides[variable - vr::SPEED].speed = x,
            (vr::PHASE0..vr::CURTAIN_CLEAR, Value::Real(x)) => self.slides[variable - vr::PHASE0].phase0 = x,
            (vr::CURTAIN_CLEAR, Value::Boolean(x)) => self.curtain_clear = x,
            (vr::DOOR_CLEAR, Value::Boolean(x)) => self.door_clear = x,
            (vr::RESET, Value::Boolean(x)) => self.reset = x,
            (vr::GATE_STATE, Value::Integer(n)) => self.gate_state = n.clamp(0, 2),
            (vr::MAT_LEVEL, Value::Real(x)) => self.mat_level = x,
            (vr::OWN_Y..=vr::PERSON_Y, Value::Real(x)) => self.own[variable - vr::OWN_Y] = x,
            _ => {}
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        values[vr::LATCHED] = Value::Boolean(self.latched);
        values[vr::REACTION] = integer(self.reaction);
        values[vr::FILTER] = integer(self.filter);
        values[vr::RAMP] = integer(self.ramp);
        values[vr::MUTING_FROM] = integer(self.muting[0]);
        values[vr::MUTING_TO] = integer(self.muting[1]);
        values[vr::FAILS_UNTIL] = integer(self.fails_until);
        for (axis, slide) in self.slides.iter().enumerate() {
            let (position, velocity) = self.motion(axis);
            values[vr::STROKE + axis] = Value::Real(slide.stroke);
            values[vr::SPEED + axis] = Value::Real(slide.speed);
            values[vr::PHASE0 + axis] = Value::Real(slide.phase0);
            values[vr::POSITION + axis] = Value::Real(position);
            values[vr::VELOCITY + axis] = Value::Real(velocity);
        }
        values[vr::CURTAIN_CLEAR] = Value::Boolean(self.curtain_clear);
        values[vr::DOOR_CLEAR] = Value::Boolean(self.door_clear);
        values[vr::RESET] = Value::Boolean(self.reset);
        #[expect(clippy::cast_precision_loss, reason = "as above")]
        let (_, towards) = self.slides[0].at(self.programme as f64 / SECOND);
        values[vr::LEG] = Value::Integer(i32::from(towards < 0.0));
        for (place, value) in self.own.into_iter().enumerate() {
            values[vr::OWN_Y + place] = Value::Real(value);
        }
        values[vr::INTERRUPTED] = Value::Boolean(self.interrupted());
        values[vr::GATE_STATE] = Value::Integer(self.gate_state);
        values[vr::MAT_LEVEL] = Value::Real(self.mat_level);
        values[vr::CURTAIN_STATE] = Value::Integer(if self.interrupted() { 4 } else { 7 });
    }

    fn step(&mut self, ticks: u64) -> Outcome {
        if !self.door_clear && self.tick < self.fails_until {
            return Outcome::Failed("the door opened before the controller was ready".to_owned());
        }
        for _ in 0..ticks {
            self.millisecond();
        }
        Outcome::Done
    }

    fn write(&self, out: &mut Writer) {
        out.bool(self.latched);
        for value in [self.reaction, self.filter, self.ramp, self.muting[0], self.muting[1]] {
            out.u64(value);
        }
        out.u64(self.fails_until);
        for slide in &self.slides {
            for value in [slide.stroke, slide.speed, slide.phase0] {
                out.f64(value);
            }
        }
        for value in [self.curtain_clear, self.door_clear, self.reset] {
            out.bool(value);
        }
        out.u64(u64::from(self.gate_state.unsigned_abs()));
        out.f64(self.mat_level);
        for value in self.own {
            out.f64(value);
        }
        out.u64(self.tick);
        out.u64(self.demanded);
        out.bool(self.stop_since.is_some());
        out.u64(self.stop_since.unwrap_or(0));
        out.bool(self.reset_was_pressed);
        out.u64(self.pace);
        out.u64(self.programme);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2 m/s along 3 m; stands 0.04 s + 0.2 s after a demand.
    fn moving() -> Gantry {
        let mut model = Gantry::new();
        model.set(vr::STROKE, Value::Real(3.0));
        model.set(vr::SPEED, Value::Real(2.0));
        model
    }

    #[test]
    fn moves_back_and_forth_by_hand_calculated_amounts() {
        let mut model = moving();
        model.step(1000);
        assert_eq!(model.motion(0), (2.0, 2.0));
        model.step(1000);
        assert_eq!(model.motion(0), (2.0, -2.0));
        assert_eq!(model.motion(1), (0.0, 0.0), "a slide without a stroke stands");
    }

    #[test]
    fn a_stop_takes_reaction_and_ramp_and_lasts_as_long_as_it_is_set_to() {
        for latched in [false, true] {
            let mut model = moving();
            model.set(vr::LATCHED, Value::Boolean(latched));
            model.set(vr::CURTAIN_CLEAR, Value::Boolean(false));
            model.step(40);
            assert_eq!(model.pace, FULL);
            model.step(199);
            assert!(model.pace > 0);
            model.step(1);
            assert_eq!(model.pace, 0);
            // Reaction, and the ramp: the mean of the pace is that of its 200 values 0.995, 0.990 ... 0.
            assert!((model.motion(0).0 - 2.0 * (0.04 + 0.2 * 0.4975)).abs() < 1e-9);
            model.set(vr::CURTAIN_CLEAR, Value::Boolean(true));
            model.step(100);
            assert_eq!(model.pace, if latched { 0 } else { FULL / 2 });
            model.set(vr::RESET, Value::Boolean(true));
            model.step(100);
            assert_eq!(model.pace, if latched { FULL / 2 } else { FULL });
        }
    }

    #[test]
    fn muting_and_the_filter_let_pass_what_is_short() {
        let mut model = moving();
        model.set(vr::MUTING_TO, Value::Integer(500));
        model.set(vr::FILTER, Value::Integer(30));
        model.set(vr::CURTAIN_CLEAR, Value::Boolean(false));
        model.step(530);
        assert_eq!(model.stop_since, None);
        model.step(1);
        assert_eq!(model.stop_since, Some(530));
        let mut model = moving();
        model.set(vr::MUTING_TO, Value::Integer(500));
        model.set(vr::DOOR_CLEAR, Value::Boolean(false));
        model.step(1);
        assert_eq!(model.stop_since, Some(0), "a door is not muted");
    }
}
