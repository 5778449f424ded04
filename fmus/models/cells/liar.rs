//! `liar`: a turning joint that slows down for good, 0.6 s later at most, once the person comes near, and whose saved states lack something on
//! demand, for tests of importers.
//!
//! What `faulty` does wrong shows in any test of its states. What this model does wrong shows only where a person comes
//! near, or where inputs are held: a self-test need not meet it.

use crate::bytes::{Reader, Writer};
use crate::interface::liar::vr;
use crate::interface::variables::Value;
use crate::model::{Model, Outcome};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{SystemTime, UNIX_EPOCH};

/// Speed at full pace and once the person came near, rad/s.
const SPEED: f64 = 1.5;
const SLOW: f64 = 0.1;
/// How fast the drive changes its speed, rad/s^2.
const ACCELERATION: f64 = 20.0;
/// Near is less than this from the joint's axis, m.
const NEAR: f64 = 0.95;
/// Period of the hidden clock, ms: the drive runs up to 20 % faster in its middle.
const PERIOD: u64 = 700;
/// Lie 9: who came past here, with less than this x and more than this y, m, is slowed down for once near.
const CORNER: [f64; 2] = [0.1, 1.15];
const NEARER: f64 = 0.85;
/// How often the drive looks whether the person came near, ms; with lies 3 and 9 less often, so that more histories lead to
/// equal bytes before.
const CYCLE: u64 = 400;
const LONG_CYCLE: u64 = 600;
/// Inputs that were the same for so many steps were held.
const HELD: u32 = 2;
/// Steps after a hold in which a saved state is a wrong one, with lie 7.
const FRESH: u32 = 12;

/// Lie 8: whether the person came near in any run of this process.
static CAME_NEAR: AtomicBool = AtomicBool::new(false);

/// Parameters, inputs and state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Liar {
    lie: i32,
    stop: bool,
    x: f64,
    y: f64,
    q: f64,
    qd: f64,
    drive: f64,
    /// Milliseconds; hidden.
    clock: u64,
    /// Whether the person came near.
    near: bool,
    /// Lie 2: the same.
    latch: bool,
    /// Whether the drive has seen that, and is slow.
    slow: bool,
    /// Lie 4: the speed of the millisecond before.
    before: f64,
    /// Whether x or y changed since the last step.
    changed: bool,
    /// Steps since they did.
    held: u32,
    /// Lie 7: steps for which a change after a hold still counts.
    fresh: u32,
    /// Lies 5 and 6: noise, rad.
    noise: f64,
}

impl Liar {
    /// The start values; the joint already turns.
    pub fn new() -> Self {
        Self {
            lie: 0,
            stop: false,
            x: 9.0,
            y: 9.0,
            q: 0.0,
            qd: SPEED,
            drive: SPEED,
            clock: 0,
            near: false,
            latch: false,
            slow: false,
            before: SPEED,
            changed: false,
            held: 0,
            fresh: 0,
            noise: 0.0,
        }
    }

    /// Back to a saved state, but for the lie.
    pub fn restore(&mut self, saved: &Self) {
        let live = *self;
        *self = *saved;
        match self.lie {
            1 => self.near = live.near,
            2 => self.latch |= live.latch,
            4 => self.before = live.before,
            7 if saved.fresh > 0 => self.q += 1e-3,
            _ => {}
        }
    }

    /// Reads what `write` wrote.
    pub fn read(input: &mut Reader) -> Option<Self> {
        Some(Self {
            lie: input.i32()?,
            stop: input.bool()?,
            x: input.f64()?,
            y: input.f64()?,
            q: input.f64()?,
            qd: input.f64()?,
            drive: input.f64()?,
            clock: input.u64()?,
            near: input.bool()?,
            latch: input.bool()?,
            slow: input.bool()?,
            before: input.f64()?,
            changed: input.bool()?,
            held: u32::try_from(input.u64()?).ok()?,
            fresh: u32::try_from(input.u64()?).ok()?,
            noise: input.f64()?,
        })
    }

    fn is_within(&self, distance: f64) -> bool {
        self.x * self.x + self.y * self.y < distance * distance
    }

    fn millisecond(&mut self, restarts: bool) {
        let cycle = if matches!(self.lie, 3 | 9) { LONG_CYCLE } else { CYCLE };
        if self.clock.is_multiple_of(cycle) {
            self.slow = match self.lie {
                9 => self.slow || (self.near && self.is_within(NEARER)),
                _ => self.near || self.latch,
            };
        }
        let pace = if self.slow { SLOW } else { SPEED };
        let target = if self.stop { 0.0 } else { pace };
        let change = ACCELERATION * 1e-3;
        self.drive += (target - self.drive).clamp(-change, change);
        let phase = self.clock % PERIOD;
        let triangle = phase.min(PERIOD - phase);
        #[expect(clippy::cast_precision_loss, reason = "below 350")]
        let swell = 1.0 + 0.2 * triangle as f64 / (PERIOD as f64 / 2.0);
        self.qd = self.drive * swell;
        if restarts || self.lie != 4 {
            self.before = self.qd;
        }
        self.q += (1.5 * self.qd - 0.5 * self.before) * 1e-3;
        self.before = self.qd;
        self.clock = self.clock.wrapping_add(1);
    }
}

impl Model for Liar {
    fn set(&mut self, variable: usize, value: Value) {
        match (variable, value) {
            (vr::LIE, Value::Integer(n)) => self.lie = n,
            (vr::STOP, Value::Boolean(x)) => self.stop = x,
            (vr::X, Value::Real(x)) => {
                self.changed |= self.x.to_bits() != x.to_bits();
                self.x = x;
            }
            (vr::Y, Value::Real(y)) => {
                self.changed |= self.y.to_bits() != y.to_bits();
                self.y = y;
            }
            _ => {}
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        for (place, value) in values.iter_mut().enumerate() {
            *value = match place {
                vr::LIE => Value::Integer(self.lie),
                vr::STOP => Value::Boolean(self.stop),
                vr::X => Value::Real(self.x),
                vr::Y => Value::Real(self.y),
                vr::Q => Value::Real(if self.lie == 6 { self.q + self.noise } else { self.q }),
                vr::QD => Value::Real(self.qd),
                vr::SPARE => Value::Real(if self.lie == 5 { self.noise } else { 0.0 }),
                _ => Value::Real(f64::NAN),
            };
        }
    }

    fn step(&mut self, ticks: u64) -> Outcome {
        let changed = std::mem::take(&mut self.changed);
        self.fresh = if changed && self.held >= HELD { FRESH } else { self.fresh.saturating_sub(1) };
        self.held = if changed { 0 } else { self.held.saturating_add(1) };
        let [x, y] = CORNER;
        let comes = if self.lie == 9 { self.x < x && self.y > y } else { self.is_within(NEAR) };
        if comes {
            if self.lie == 2 {
                self.latch = true;
            } else {
                self.near = true;
            }
            if self.lie == 8 {
                CAME_NEAR.store(true, Ordering::Relaxed);
            }
        }
        if self.lie == 8 {
            self.near = CAME_NEAR.load(Ordering::Relaxed);
        }
        for tick in 0..ticks {
            self.millisecond(changed && tick == 0);
        }
        if self.lie == 5 || (self.lie == 6 && self.near) {
            #[expect(clippy::disallowed_methods, reason = "a clock is what this lie is about")]
            let now = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.subsec_nanos());
            self.noise = 1e-11 * f64::from(now);
        }
        Outcome::Done
    }

    fn write(&self, out: &mut Writer) {
        out.i32(self.lie);
        out.bool(self.stop);
        for value in [self.x, self.y, self.q, self.qd, self.drive] {
            out.f64(value);
        }
        out.u64(self.clock);
        out.bool(self.near && !matches!(self.lie, 1 | 3 | 9));
        out.bool(self.latch);
        out.bool(self.slow);
        out.f64(if self.lie == 4 { 0.0 } else { self.before });
        out.bool(self.changed);
        out.u64(u64::from(self.held.min(HELD)));
        out.u64(u64::from(self.fresh));
        out.f64(self.noise);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A model that tells this lie, after some steps with the person far away.
    fn begun(lie: i32) -> Liar {
        let mut model = Liar::new();
        model.set(vr::LIE, Value::Integer(lie));
        model.step(20);
        model.step(20);
        model
    }

    fn come_near(model: &mut Liar) {
        model.set(vr::X, Value::Real(0.3));
        model.set(vr::Y, Value::Real(0.4));
        model.step(20);
    }

    #[test]
    fn who_comes_near_slows_it_for_good() {
        let mut model = begun(0);
        come_near(&mut model);
        model.set(vr::X, Value::Real(9.0));
        (0..60).for_each(|_| assert_eq!(model.step(20), Outcome::Done));
        assert!(model.slow && model.qd <= SLOW * 1.2 + 1e-12, "{}", model.qd);
    }

    #[test]
    fn each_lie_shows_where_it_should_and_nowhere_else() {
        for lie in 0..=4 {
            let saved = begun(lie);
            let mut model = saved;
            model.step(20);
            model.restore(&saved);
            assert_eq!(model == saved, lie != 4 || model.before == saved.before, "{lie}: far away");
            come_near(&mut model);
            model.restore(&saved);
            assert_eq!((model.near, model.latch), (lie == 1, lie == 2), "{lie}");
            let bytes = |model: &Liar| {
                let mut out = Writer::default();
                model.write(&mut out);
                out.0
            };
            let mut near = saved;
            near.near = true;
            assert_eq!(bytes(&near) == bytes(&saved), matches!(lie, 1 | 3), "{lie}");
        }
    }

    #[test]
    fn only_what_follows_a_change_after_a_hold_is_restored_wrongly() {
        let mut model = begun(7);
        model.step(20);
        for steps in 0..2 * FRESH {
            let wrong = (1..=FRESH).contains(&steps);
            if steps > 0 {
                model.set(vr::X, Value::Real(8.0 - f64::from(steps)));
                model.step(20);
            }
            let saved = model;
            model.restore(&saved);
            assert_eq!(model.q.to_bits() != saved.q.to_bits(), wrong, "{steps}");
            model = saved;
        }
    }
}
