//! `guarded`: a bar that turns at a constant speed, and a safety controller with a filter, muting, a field and a protective
//! distance.
//!
//! Mat and field demand a stop, latched; a demand counts once it has lasted for `filter.tau`, and not while it is muted.
//! Nearer than `ssm.distance` the bar stands as long as that lasts.

use crate::bytes::{Reader, Writer};
use crate::drive::{Demands, Drive, Settings};
use crate::interface::guarded::{interface, vr};
use crate::interface::variables::Value;
use crate::model::{Model, Outcome};

/// How long the burst lasts, s.
const BURST_S: f64 = 0.01;

/// How many real parameters and inputs there are: their places in the table below the outputs.
const REALS: usize = vr::Q;

/// Parameters, inputs and state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guarded {
    /// By place; those of truth values are not used.
    reals: [f64; REALS],
    muting: bool,
    clear: bool,
    drive: Drive,
    /// Milliseconds since the start, and for how many of the last a stop was demanded.
    tick: u64,
    lasting: u64,
    /// Demands so far.
    demands: u64,
}

impl Guarded {
    /// All start values of the table.
    pub fn new() -> Self {
        let mut model = Self {
            reals: [0.0; REALS],
            muting: false,
            clear: true,
            drive: Drive::running(),
            tick: 0,
            lasting: 0,
            demands: 0,
        };
        for (place, variable) in interface().variables.iter().enumerate().take(REALS) {
            model.set(place, variable.kind.start());
        }
        model
    }

    fn settings(&self) -> Settings {
        Settings { t_react: self.reals[vr::T_REACT], t_ramp: self.reals[vr::T_RAMP], reduced: 0.0 }
    }

    fn distance(&self) -> f64 {
        (self.reals[vr::PERSON_X].powi(2) + self.reals[vr::PERSON_Y].powi(2)).sqrt()
    }

    fn occupied(&self) -> bool {
        let later = self.now_s() >= self.reals[vr::FIELD_UNTIL];
        self.distance() < self.reals[if later { vr::FIELD_LATER } else { vr::FIELD_RADIUS }]
    }

    /// Whether a demand has lasted for as long as it has to.
    fn counts(&self) -> bool {
        #[expect(clippy::cast_precision_loss, reason = "some seconds")]
        let lasting = self.lasting as f64;
        lasting > milliseconds(self.reals[vr::TAU])
    }

    /// Whether something is wrong with it.
    fn has(&self, fault: usize) -> bool {
        self.reals[fault] != 0.0
    }

    /// How much of the burst is over, s.
    fn burst_s(&self) -> f64 {
        (self.now_s() - self.reals[vr::BURST_AT]).clamp(0.0, BURST_S)
    }

    #[expect(clippy::cast_precision_loss, reason = "some seconds")]
    fn now_s(&self) -> f64 {
        self.tick as f64 / 1000.0
    }

    /// Reads what `write` wrote.
    pub fn read(input: &mut Reader) -> Option<Self> {
        let mut model = Self::new();
        for value in &mut model.reals {
            *value = input.f64()?;
        }
        model.muting = input.bool()?;
        model.clear = input.bool()?;
        model.tick = input.u64()?;
        model.lasting = input.u64()?;
        model.demands = input.u64()?;
        model.drive = Drive::read(input)?;
        Some(model)
    }

    fn value(&self, place: usize) -> Value {
        match place {
            vr::MUTING => Value::Boolean(self.muting),
            vr::CLEAR => Value::Boolean(self.clear),
            vr::OCCUPIED => Value::Boolean(self.occupied()),
            vr::COUNTS => Value::Boolean(self.counts()),
            vr::Q => Value::Real(
                self.reals[vr::SPEED] * self.drive.programme_time() + self.reals[vr::BURST_BY] * self.burst_s(),
            ),
            vr::QD => {
                let is_in_burst = self.burst_s() > 0.0 && self.burst_s() < BURST_S;
                let speed = self.reals[vr::SPEED] * self.drive.pace();
                let share = if self.lasting > 0 { self.reals[vr::TOLD_SHARE] } else { 1.0 };
                Value::Real(share * speed + if is_in_burst { self.reals[vr::BURST_BY] } else { 0.0 })
            }
            real => Value::Real(self.reals[real]),
        }
    }

    fn millisecond(&mut self) {
        let demanded = !self.clear || self.occupied();
        if demanded && self.lasting == 0 {
            self.demands = self.demands.saturating_add(1);
        }
        self.lasting = if demanded { self.lasting.saturating_add(1) } else { 0 };
        #[expect(clippy::cast_precision_loss, reason = "some seconds")]
        let now = self.tick as f64;
        let muted = self.muting && now < milliseconds(self.reals[vr::HOLD_TIME]);
        let stop = demanded && !muted && self.counts() && !(self.has(vr::ONCE) && self.demands > 1);
        let slow = self.now_s() >= self.reals[vr::SSM_FROM] && self.distance() < self.reals[vr::SSM_DISTANCE];
        self.drive.advance(1, Demands { stop, slow, reset: false }, &self.settings());
        self.tick = self.tick.saturating_add(1);
    }
}

/// A little less, so that whole milliseconds are.
fn milliseconds(seconds: f64) -> f64 {
    seconds * 1000.0 - 1e-9
}

impl Model for Guarded {
    fn set(&mut self, variable: usize, value: Value) {
        match (variable, value) {
            (vr::MUTING, Value::Boolean(x)) => self.muting = x,
            (vr::CLEAR, Value::Boolean(x)) => self.clear = x,
            (place, Value::Real(x)) if place < REALS => self.reals[place] = x,
            _ => {}
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        for (place, value) in values.iter_mut().enumerate() {
            *value = if place == 0 { Value::Real(f64::NAN) } else { self.value(place) };
        }
    }

    fn step(&mut self, ticks: u64) -> Outcome {
        (0..ticks).for_each(|_| self.millisecond());
        Outcome::Done
    }

    fn write(&self, out: &mut Writer) {
        for value in self.reals {
            out.f64(value);
        }
        out.bool(self.muting);
        out.bool(self.clear);
        out.u64(self.tick);
        out.u64(if self.has(vr::FORGETS) { 0 } else { self.lasting });
        out.u64(self.demands);
        self.drive.write(out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// When the bar stands, ms, after the mat was stepped on at 100 ms.
    fn stands(set: &[(usize, Value)]) -> Option<u64> {
        let mut model = Guarded::new();
        set.iter().for_each(|(place, value)| model.set(*place, *value));
        (1..3000).find(|tick| {
            model.set(vr::CLEAR, Value::Boolean(*tick <= 100));
            model.step(1);
            model.value(vr::QD) == Value::Real(0.0)
        })
    }

    #[test]
    fn filter_and_muting_delay_a_stop_by_their_times() {
        // Reaction 50 ms, ramp 300 ms.
        let plain = stands(&[]).unwrap();
        assert!((450..=452).contains(&plain), "{plain}");
        // The millisecond in which it begins counts.
        assert_eq!(stands(&[(vr::TAU, Value::Real(0.2))]), Some(plain + 199));
        let muted = [(vr::HOLD_TIME, Value::Real(1.1)), (vr::MUTING, Value::Boolean(true))];
        assert_eq!(stands(&muted), Some(plain + 1000));
        assert_eq!(stands(&muted[..1]), Some(plain));
    }

    #[test]
    fn the_distance_stops_it_as_long_as_it_lasts() {
        let mut model = Guarded::new();
        model.set(vr::SSM_DISTANCE, Value::Real(2.0));
        model.set(vr::PERSON_Y, Value::Real(-1.9));
        model.step(1000);
        assert_eq!((model.value(vr::QD), model.value(vr::OCCUPIED)), (Value::Real(0.0), Value::Boolean(false)));
        model.set(vr::PERSON_Y, Value::Real(-2.1));
        model.step(1000);
        assert_eq!(model.value(vr::QD), Value::Real(1.0));
    }
}
