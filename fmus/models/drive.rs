//! What a safety controller does to the pace of a robot's programme: protective stop and reduced speed.
//!
//! A demand to stop is latched (stop category 1, IEC 60204-1; drive function SS1-t): after the reaction time the
//! override falls linearly to 0, full pace in the ramp time; the path is kept. The robot stays stopped until the reset
//! button is pressed (rising edge) while the demand is gone; then the override rises at the same rate. A press while
//! it still moves, or with the demand there, does nothing, and holding the button is not a press. A demand for reduced
//! speed (SLS) acts after the same reaction time, lasts as long as the signal, and is over at once when the signal is.
//!
//! Time is counted in whole milliseconds. Between two events the override is a clamped straight line, and the
//! programme time its integral, both evaluated in closed form: the result does not depend on the size of the steps.

use crate::bytes::{Reader, Writer};

/// What the controller is set to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Reaction time, s; rounded up to a whole millisecond.
    pub t_react: f64,
    /// Time of the ramp between standstill and full pace, s; greater than 0.
    pub t_ramp: f64,
    /// Override of reduced speed, 0 to 1.
    pub reduced: f64,
}

/// The signals of one step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Demands {
    /// Protective stop, latched.
    pub stop: bool,
    /// Reduced speed, while it lasts.
    pub slow: bool,
    /// The reset button is down.
    pub reset: bool,
}

/// The state of the controller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// Milliseconds since the start.
    tick: u64,
    /// When a stop was demanded, until it is reset.
    stop_since: Option<u64>,
    /// When the present demand for reduced speed began.
    slow_since: Option<u64>,
    /// When the present straight line of the override began, the override and programme time there, and where it goes.
    line_start: u64,
    line_override: f64,
    line_time: f64,
    line_target: f64,
    /// The ramp time along it, s: that of when it began.
    line_ramp: f64,
    reset_was_pressed: bool,
}

/// `plc.stop_state`: no demand.
pub const RUNNING: i32 = 0;
/// `plc.stop_state`: reduced speed is demanded.
pub const REDUCED: i32 = 1;
/// `plc.stop_state`: a stop is latched, the robot still moves (or has not been asked to slow down yet).
pub const STOPPING: i32 = 2;
/// `plc.stop_state`: standing, power removed.
pub const STOPPED: i32 = 3;

impl Drive {
    /// At full pace at programme time 0.
    pub fn running() -> Self {
        Self {
            tick: 0,
            stop_since: None,
            slow_since: None,
            line_start: 0,
            line_override: 1.0,
            line_time: 0.0,
            line_target: 1.0,
            line_ramp: 0.0,
            reset_was_pressed: false,
        }
    }

    /// Lets `ticks` milliseconds pass with the demands held.
    pub fn advance(&mut self, ticks: u64, demands: Demands, settings: &Settings) {
        let pressed = demands.reset && !self.reset_was_pressed;
        self.reset_was_pressed = demands.reset;
        if demands.stop {
            self.stop_since.get_or_insert(self.tick);
        } else if pressed && self.state() == STOPPED {
            self.stop_since = None;
        }
        if demands.slow {
            self.slow_since.get_or_insert(self.tick);
        } else {
            self.slow_since = None;
        }
        self.aim(self.tick, settings);
        let end = self.tick.saturating_add(ticks);
        let reaction = whole_ticks_up(settings.t_react);
        let mut due = [self.stop_since, self.slow_since].map(|since| since.map(|tick| tick.saturating_add(reaction)));
        due.sort_unstable();
        let begin = self.tick;
        for tick in due.into_iter().flatten().filter(|&tick| begin < tick && tick <= end) {
            self.aim(tick, settings);
        }
        self.tick = end;
    }

    /// Starts a new line at `tick` if the override is to go elsewhere from there on.
    fn aim(&mut self, tick: u64, settings: &Settings) {
        let reaction = whole_ticks_up(settings.t_react);
        let acts = |since: Option<u64>| since.is_some_and(|since| since.saturating_add(reaction) <= tick);
        let target = if acts(self.stop_since) {
            0.0
        } else if acts(self.slow_since) {
            settings.reduced
        } else {
            1.0
        };
        if target != self.line_target {
            (self.line_override, self.line_time) = self.at(tick);
            self.line_start = tick;
            self.line_target = target;
            self.line_ramp = settings.t_ramp;
        }
    }

    /// Override and programme time at a tick of the present line.
    fn at(&self, tick: u64) -> (f64, f64) {
        let (from, to) = (self.line_override, self.line_target);
        let elapsed = seconds(tick.saturating_sub(self.line_start));
        let until_clamped = (to - from).abs() * self.line_ramp;
        if elapsed >= until_clamped {
            let on_the_slope = until_clamped * (from + to) / 2.0;
            (to, self.line_time + on_the_slope + (elapsed - until_clamped) * to)
        } else {
            let slope = if to > from { 1.0 / self.line_ramp } else { -1.0 / self.line_ramp };
            (from + slope * elapsed, self.line_time + from * elapsed + slope * elapsed * elapsed / 2.0)
        }
    }

    /// The override, 0 to 1.
    pub fn pace(&self) -> f64 {
        self.at(self.tick).0
    }

    /// The integral of the override since the start, s.
    pub fn programme_time(&self) -> f64 {
        self.at(self.tick).1
    }

    /// `plc.stop_state`.
    pub fn state(&self) -> i32 {
        if self.stop_since.is_some() {
            // Standing counts only once the stop acts: reduced speed may be standstill as well.
            if self.line_target == 0.0 && self.pace() == 0.0 { STOPPED } else { STOPPING }
        } else if self.slow_since.is_some() {
            REDUCED
        } else {
            RUNNING
        }
    }

    /// Whether a latched stop acts: its reaction time is over.
    pub fn stop_acts(&self, settings: &Settings) -> bool {
        self.stop_since.is_some_and(|since| since.saturating_add(whole_ticks_up(settings.t_react)) <= self.tick)
    }

    /// Takes over another's latch: what a faulty restore does.
    pub fn with_latch_of(self, other: &Self) -> Self {
        let line_ramp = self.line_ramp.max(other.line_ramp);
        Self { stop_since: other.stop_since, line_target: other.line_target, line_ramp, ..self }
    }

    /// Writes all fields.
    pub fn write(&self, out: &mut Writer) {
        out.u64(self.tick);
        for since in [self.stop_since, self.slow_since] {
            out.bool(since.is_some());
            out.u64(since.unwrap_or(0));
        }
        out.u64(self.line_start);
        out.f64(self.line_override);
        out.f64(self.line_time);
        out.f64(self.line_target);
        out.f64(self.line_ramp);
        out.bool(self.reset_was_pressed);
    }

    /// Reads what `write` wrote; None if the bytes are no such state.
    pub fn read(input: &mut Reader) -> Option<Self> {
        let tick = input.u64()?;
        let mut since = || {
            let there = input.bool()?;
            let tick = input.u64()?;
            Some(there.then_some(tick))
        };
        let (stop_since, slow_since) = (since()?, since()?);
        Some(Self {
            tick,
            stop_since,
            slow_since,
            line_start: input.u64()?,
            line_override: input.f64()?,
            line_time: input.f64()?,
            line_target: input.f64()?,
            line_ramp: input.f64()?,
            reset_was_pressed: input.bool()?,
        })
    }
}

/// Milliseconds to seconds. Ticks of a session stay far below 2^53.
#[expect(clippy::cast_precision_loss, reason = "exact below 2^53 ms, which is 285 000 years")]
fn seconds(ticks: u64) -> f64 {
    ticks as f64 / 1000.0
}

/// Seconds to milliseconds, up to the next whole one; forgives rounding errors of a millionth of a millisecond.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded by the parameter's range, 0..5 s")]
fn whole_ticks_up(seconds: f64) -> u64 {
    (seconds * 1000.0 - 1e-6).ceil().max(0.0) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    const SETTINGS: Settings = Settings { t_react: 0.05, t_ramp: 0.30, reduced: 0.25 };

    fn demand(stop: bool, reset: bool) -> Demands {
        Demands { stop, slow: false, reset }
    }

    fn stopped() -> Drive {
        let mut drive = Drive::running();
        drive.advance(1, demand(true, false), &SETTINGS);
        drive.advance(999, demand(false, false), &SETTINGS);
        assert_eq!(drive.state(), STOPPED);
        drive
    }

    #[test]
    fn stands_exactly_after_reaction_and_ramp_time() {
        let mut drive = Drive::running();
        drive.advance(100, demand(false, false), &SETTINGS);
        drive.advance(50, demand(true, false), &SETTINGS);
        assert_eq!((drive.state(), drive.pace()), (STOPPING, 1.0));
        drive.advance(150, demand(true, false), &SETTINGS);
        assert!((drive.pace() - 0.5).abs() < 1e-12);
        drive.advance(149, demand(true, false), &SETTINGS);
        assert_eq!(drive.state(), STOPPING);
        drive.advance(1, demand(true, false), &SETTINGS);
        assert_eq!((drive.state(), drive.pace()), (STOPPED, 0.0));
        // Travel of a stop from full pace: reaction time plus half the ramp time.
        assert!((drive.programme_time() - (0.1 + 0.05 + 0.15)).abs() < 1e-12);
    }

    #[test]
    fn a_short_demand_is_latched() {
        let drive = stopped();
        assert!((drive.programme_time() - 0.2).abs() < 1e-12);
    }

    #[test]
    fn reduced_speed_comes_after_the_reaction_time_and_goes_at_once() {
        let slow = Demands { slow: true, ..Demands::default() };
        let mut drive = Drive::running();
        drive.advance(50, slow, &SETTINGS);
        assert_eq!((drive.state(), drive.pace()), (REDUCED, 1.0));
        // From 1 to 0.25 takes 0.75 of the ramp.
        drive.advance(225, slow, &SETTINGS);
        assert!((drive.pace() - 0.25).abs() < 1e-12);
        drive.advance(500, slow, &SETTINGS);
        assert!((drive.pace() - 0.25).abs() < 1e-12);
        drive.advance(30, Demands::default(), &SETTINGS);
        assert!((drive.pace() - 0.35).abs() < 1e-12);
        // A short demand is forgotten before it acts.
        drive.advance(300, Demands::default(), &SETTINGS);
        drive.advance(40, slow, &SETTINGS);
        drive.advance(300, Demands::default(), &SETTINGS);
        assert_eq!((drive.state(), drive.pace()), (RUNNING, 1.0));
    }

    #[test]
    fn a_stop_overrules_reduced_speed_and_reduced_standstill_is_no_stop() {
        let mut drive = Drive::running();
        let both = Demands { stop: true, slow: true, reset: false };
        drive.advance(1000, Demands { slow: true, ..Demands::default() }, &SETTINGS);
        drive.advance(50 + 75, both, &SETTINGS);
        assert_eq!((drive.state(), drive.pace()), (STOPPED, 0.0));
        let standstill = Settings { reduced: 0.0, ..SETTINGS };
        let mut drive = Drive::running();
        drive.advance(1000, Demands { slow: true, ..Demands::default() }, &standstill);
        assert_eq!((drive.state(), drive.pace()), (REDUCED, 0.0));
        drive.advance(20, Demands { stop: true, slow: true, reset: false }, &standstill);
        assert_eq!(drive.state(), STOPPED);
    }

    #[test]
    fn the_size_of_the_steps_does_not_matter() {
        for step in [1, 7, 20, 50] {
            let mut drive = Drive::running();
            let mut whole = drive;
            drive.advance(350, demand(false, false), &SETTINGS);
            whole.advance(350, demand(false, false), &SETTINGS);
            whole.advance(700, demand(true, false), &SETTINGS);
            let mut left = 700;
            while left > 0 {
                let now = left.min(step);
                drive.advance(now, demand(true, false), &SETTINGS);
                left -= now;
            }
            assert_eq!(drive, whole);
        }
    }

    #[test]
    fn only_a_press_without_a_demand_restarts() {
        let mut drive = stopped();
        drive.advance(20, demand(true, true), &SETTINGS);
        assert_eq!(drive.state(), STOPPED, "demand there");
        drive.advance(20, demand(false, true), &SETTINGS);
        assert_eq!(drive.state(), STOPPED, "held, not pressed");
        drive.advance(20, demand(false, false), &SETTINGS);
        assert_eq!(drive.state(), STOPPED, "the end of the demand alone");
        drive.advance(150, demand(false, true), &SETTINGS);
        assert_eq!(drive.state(), RUNNING);
        assert!((drive.pace() - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_press_while_braking_is_lost() {
        let mut drive = Drive::running();
        drive.advance(20, demand(true, false), &SETTINGS);
        drive.advance(100, demand(false, true), &SETTINGS);
        drive.advance(900, demand(false, true), &SETTINGS);
        assert_eq!(drive.state(), STOPPED);
    }

    #[test]
    fn programme_time_is_the_integral_of_the_override() {
        // Demand, stop, restart, reduced speed, second demand; trapezoids as the independent sum.
        let mut drive = Drive::running();
        let mut sum = 0.0;
        for tick in 0..3000_u32 {
            let demands = Demands {
                stop: (100..120).contains(&tick) || (1900..2000).contains(&tick),
                slow: (1300..1500).contains(&tick),
                reset: tick == 800,
            };
            let before = drive.pace();
            drive.advance(1, demands, &SETTINGS);
            sum += (before + drive.pace()) / 2000.0;
            assert!((drive.programme_time() - sum).abs() < 1e-9, "tick {tick}");
        }
        assert_eq!(drive.state(), STOPPED);
    }
}
