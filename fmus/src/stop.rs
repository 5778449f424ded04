//! The protective stop of a safety controller, and its effect on the pace of the robot's programme.
//!
//! Stop category 1 (IEC 60204-1; drive function SS1-t): a demand is latched; after the reaction time the override
//! falls linearly from where it is, reaching 0 from 1 in the ramp time; the path is kept; then power is removed. The
//! robot stays stopped until the reset button is pressed (rising edge) while the guard is closed; then the override
//! rises again at the same rate. A press during the stop, or with the guard open, does nothing, and holding the
//! button is not a press.
//!
//! Time is counted in whole milliseconds. Between two events the override is a clamped straight line, and the
//! programme time its integral, both evaluated in closed form: the result does not depend on the size of the steps.

use crate::bytes::{Reader, Writer};

/// What the controller is set to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StopSettings {
    /// Reaction time, s; rounded up to a whole millisecond.
    pub t_react: f64,
    /// Time of the full ramp, s; greater than 0.
    pub t_ramp: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// The override rises to 1 or is there.
    Running,
    /// The demand is latched; the robot does not yet slow down.
    Reacting,
    /// The override falls to 0 or is there.
    Braking,
}

/// The state of the controller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProtectiveStop {
    /// Milliseconds since the start.
    tick: u64,
    phase: Phase,
    /// When the demand was latched.
    demanded_at: u64,
    /// When the present straight line of the override began, and the override and programme time there.
    line_start: u64,
    line_override: f64,
    line_time: f64,
    reset_was_pressed: bool,
}

/// `plc.stop_state`: no demand.
pub const RUNNING: i32 = 0;
/// `plc.stop_state`: demand latched, the robot still moves (or has not been asked to slow down yet).
pub const STOPPING: i32 = 2;
/// `plc.stop_state`: standing, power removed.
pub const STOPPED: i32 = 3;

impl ProtectiveStop {
    /// At full pace at programme time 0.
    pub fn running() -> Self {
        Self {
            tick: 0,
            phase: Phase::Running,
            demanded_at: 0,
            line_start: 0,
            line_override: 1.0,
            line_time: 0.0,
            reset_was_pressed: false,
        }
    }

    /// Lets `ticks` milliseconds pass with the inputs held.
    pub fn advance(&mut self, ticks: u64, guard_closed: bool, reset: bool, settings: &StopSettings) {
        let pressed = reset && !self.reset_was_pressed;
        self.reset_was_pressed = reset;
        if !guard_closed && self.phase == Phase::Running {
            self.phase = Phase::Reacting;
            self.demanded_at = self.tick;
        } else if guard_closed && pressed && self.state(settings) == STOPPED {
            self.start_line(self.tick, Phase::Running, settings);
        }
        let end = self.tick.saturating_add(ticks);
        let brake_at = self.demanded_at.saturating_add(whole_ticks_up(settings.t_react));
        if self.phase == Phase::Reacting && brake_at <= end {
            self.start_line(brake_at, Phase::Braking, settings);
        }
        self.tick = end;
    }

    fn start_line(&mut self, tick: u64, phase: Phase, settings: &StopSettings) {
        (self.line_override, self.line_time) = self.at(tick, settings);
        self.line_start = tick;
        self.phase = phase;
    }

    /// Override and programme time at a tick of the present line.
    fn at(&self, tick: u64, settings: &StopSettings) -> (f64, f64) {
        let (from, elapsed) = (self.line_override, seconds(tick.saturating_sub(self.line_start)));
        let (until_clamped, slope, end) = match self.phase {
            Phase::Running | Phase::Reacting => ((1.0 - from) * settings.t_ramp, 1.0 / settings.t_ramp, 1.0),
            Phase::Braking => (from * settings.t_ramp, -1.0 / settings.t_ramp, 0.0),
        };
        if elapsed >= until_clamped {
            let on_the_slope = until_clamped * (from + end) / 2.0;
            (end, self.line_time + on_the_slope + (elapsed - until_clamped) * end)
        } else {
            (from + slope * elapsed, self.line_time + from * elapsed + slope * elapsed * elapsed / 2.0)
        }
    }

    /// The override, 0 to 1.
    pub fn pace(&self, settings: &StopSettings) -> f64 {
        self.at(self.tick, settings).0
    }

    /// The integral of the override since the start, s.
    pub fn programme_time(&self, settings: &StopSettings) -> f64 {
        self.at(self.tick, settings).1
    }

    /// `plc.stop_state`.
    pub fn state(&self, settings: &StopSettings) -> i32 {
        match self.phase {
            Phase::Running => RUNNING,
            Phase::Reacting => STOPPING,
            Phase::Braking if self.pace(settings) > 0.0 => STOPPING,
            Phase::Braking => STOPPED,
        }
    }

    /// Writes all fields.
    pub fn write(&self, out: &mut Writer) {
        out.u64(self.tick);
        out.u64(match self.phase {
            Phase::Running => 0,
            Phase::Reacting => 1,
            Phase::Braking => 2,
        });
        out.u64(self.demanded_at);
        out.u64(self.line_start);
        out.f64(self.line_override);
        out.f64(self.line_time);
        out.bool(self.reset_was_pressed);
    }

    /// Reads what `write` wrote; None if the bytes are no such state.
    pub fn read(input: &mut Reader) -> Option<Self> {
        Some(Self {
            tick: input.u64()?,
            phase: match input.u64()? {
                0 => Phase::Running,
                1 => Phase::Reacting,
                2 => Phase::Braking,
                _ => return None,
            },
            demanded_at: input.u64()?,
            line_start: input.u64()?,
            line_override: input.f64()?,
            line_time: input.f64()?,
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

    const SETTINGS: StopSettings = StopSettings { t_react: 0.05, t_ramp: 0.30 };

    fn stopped() -> ProtectiveStop {
        let mut plc = ProtectiveStop::running();
        plc.advance(1, false, false, &SETTINGS);
        plc.advance(999, true, false, &SETTINGS);
        assert_eq!(plc.state(&SETTINGS), STOPPED);
        plc
    }

    #[test]
    fn stands_exactly_after_reaction_and_ramp_time() {
        let mut plc = ProtectiveStop::running();
        plc.advance(100, true, false, &SETTINGS);
        plc.advance(50, false, false, &SETTINGS);
        assert_eq!((plc.state(&SETTINGS), plc.pace(&SETTINGS)), (STOPPING, 1.0));
        plc.advance(150, false, false, &SETTINGS);
        assert!((plc.pace(&SETTINGS) - 0.5).abs() < 1e-12);
        plc.advance(149, false, false, &SETTINGS);
        assert_eq!(plc.state(&SETTINGS), STOPPING);
        plc.advance(1, false, false, &SETTINGS);
        assert_eq!((plc.state(&SETTINGS), plc.pace(&SETTINGS)), (STOPPED, 0.0));
        // Travel of a stop from full pace: reaction time plus half the ramp time.
        assert!((plc.programme_time(&SETTINGS) - (0.1 + 0.05 + 0.15)).abs() < 1e-12);
    }

    #[test]
    fn a_short_demand_is_latched() {
        let plc = stopped();
        assert!((plc.programme_time(&SETTINGS) - 0.2).abs() < 1e-12);
    }

    #[test]
    fn the_size_of_the_steps_does_not_matter() {
        for step in [1, 7, 20, 50] {
            let mut plc = ProtectiveStop::running();
            let mut whole = plc;
            plc.advance(350, true, false, &SETTINGS);
            whole.advance(350, true, false, &SETTINGS);
            whole.advance(700, false, false, &SETTINGS);
            let mut left = 700;
            while left > 0 {
                let now = left.min(step);
                plc.advance(now, false, false, &SETTINGS);
                left -= now;
            }
            assert_eq!(plc, whole);
        }
    }

    #[test]
    fn only_a_press_with_the_guard_closed_restarts() {
        let mut plc = stopped();
        plc.advance(20, false, true, &SETTINGS);
        assert_eq!(plc.state(&SETTINGS), STOPPED, "guard open");
        plc.advance(20, true, true, &SETTINGS);
        assert_eq!(plc.state(&SETTINGS), STOPPED, "held, not pressed");
        plc.advance(20, true, false, &SETTINGS);
        assert_eq!(plc.state(&SETTINGS), STOPPED, "closing the guard alone");
        plc.advance(150, true, true, &SETTINGS);
        assert_eq!(plc.state(&SETTINGS), RUNNING);
        assert!((plc.pace(&SETTINGS) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_press_while_braking_is_lost() {
        let mut plc = ProtectiveStop::running();
        plc.advance(20, false, false, &SETTINGS);
        plc.advance(100, true, true, &SETTINGS);
        plc.advance(900, true, true, &SETTINGS);
        assert_eq!(plc.state(&SETTINGS), STOPPED);
    }

    #[test]
    fn programme_time_is_the_integral_of_the_override() {
        // Demand, stop, restart, second demand while the override still rises; trapezoids as the independent sum.
        let mut plc = ProtectiveStop::running();
        let mut sum = 0.0;
        for tick in 0..2000_u32 {
            let guard = !(100..120).contains(&tick) && !(900..1000).contains(&tick);
            let before = plc.pace(&SETTINGS);
            plc.advance(1, guard, tick == 800, &SETTINGS);
            sum += (before + plc.pace(&SETTINGS)) / 2000.0;
            assert!((plc.programme_time(&SETTINGS) - sum).abs() < 1e-9, "tick {tick}");
        }
        assert_eq!(plc.state(&SETTINGS), STOPPED);
    }
}
