//! What follows outputs of the FMU: obstacles that stand while one says so or move with one, sensors that count and controls that can be
//! worked while one says so.
//!
//! Each has few states, so all of them together are one number, an [`Arrangement`]. State 0 of an obstacle: it is not there. State 0 of a
//! sensor: it counts. State 0 of a control: it can be worked.

use crate::geometry::Vec3;
use crate::human::Arrangement;

/// An output while it is in a range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Band {
    /// Number of the output among those that are followed.
    pub reading: usize,
    /// The least value in it.
    pub from: f64,
    /// The largest value in it.
    pub to: f64,
}

impl Band {
    fn holds(&self, value: f64) -> bool {
        (self.from..=self.to).contains(&value)
    }
}

/// A straight way that an obstacle goes with an output, taken in steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moves {
    /// Number of the output among those that are followed.
    pub reading: usize,
    /// Which way, of length 1.
    pub direction: Vec3,
    /// The output at the beginning of the way, m.
    pub from: f64,
    /// Length of a step, m.
    pub step_m: f64,
    /// How many positions there are.
    pub positions: u16,
}

impl Moves {
    /// The position, from 0, nearest to what the output says; at an end for what is beyond it.
    fn position(&self, value: f64) -> u16 {
        let last = f64::from(self.positions.saturating_sub(1));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the last")]
        let position = ((value - self.from) / self.step_m).round().clamp(0.0, last) as u16;
        position
    }

    /// How far it is there from where the cell file says it is, m.
    fn offset(&self, position: u16) -> Vec3 {
        self.direction * (self.from + f64::from(position) * self.step_m)
    }
}

/// What follows.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Follower {
    /// An obstacle: when it is there, and where.
    Obstacle {
        /// It is not there when the output is not in this range; always, without one.
        stands: Option<Band>,
        /// Where it goes.
        moves: Option<Moves>,
    },
    /// The sensor with this number counts while the output is in the range.
    Sensor(usize, Band),
    /// The control with this number can be worked while the output is in the range.
    Control(usize, Band),
}

impl Follower {
    fn states(&self) -> usize {
        match self {
            Self::Obstacle { moves, .. } => 1 + moves.as_ref().map_or(1, |moves| usize::from(moves.positions)),
            Self::Sensor(..) | Self::Control(..) => 2,
        }
    }

    /// Its state by what the outputs read. What no number says is in no range.
    fn state(&self, read: &impl Fn(usize) -> f64) -> u16 {
        let holds = |band: &Band| band.holds(read(band.reading));
        match self {
            Self::Obstacle { stands, .. } if !stands.as_ref().is_none_or(holds) => 0,
            Self::Obstacle { moves: None, .. } => 1,
            Self::Obstacle { moves: Some(moves), .. } => match read(moves.reading) {
                value if value.is_nan() => 0,
                value => 1 + moves.position(value),
            },
            Self::Sensor(_, band) | Self::Control(_, band) => u16::from(!holds(band)),
        }
    }
}

/// All that follows: obstacles first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Following {
    /// Each with what its states are multiplied by in the number of an arrangement.
    all: Vec<(Follower, usize)>,
}

impl Following {
    /// Obstacles, then sensors and controls; nothing if they have too many states together.
    #[must_use]
    pub(crate) fn new(all: Vec<Follower>) -> Option<Self> {
        let mut stride = 1_usize;
        let mut placed = Vec::with_capacity(all.len());
        for follower in all {
            let states = follower.states();
            placed.push((follower, stride));
            stride = stride.checked_mul(states).filter(|all| *all <= Arrangement::MOST)?;
        }
        Some(Self { all: placed })
    }

    /// Whether nothing does.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// In how many ways the obstacles may stand.
    #[must_use]
    pub fn of_obstacles(&self) -> usize {
        let obstacles = self.all.iter().filter(|(follower, _)| matches!(follower, Follower::Obstacle { .. }));
        obstacles.map(|(follower, _)| follower.states()).product()
    }

    /// The arrangement with this number among those of the obstacles: every sensor counts.
    #[must_use]
    pub fn standing(&self, arrangement: Arrangement) -> usize {
        usize::from(arrangement.number()) % self.of_obstacles()
    }

    /// The arrangement by what the outputs read, each by its number.
    #[must_use]
    pub fn arrangement(&self, read: impl Fn(usize) -> f64) -> Arrangement {
        let number = self.all.iter().map(|(follower, stride)| usize::from(follower.state(&read)) * stride).sum();
        Self::numbered(number)
    }

    /// That with a number.
    #[must_use]
    pub fn numbered(number: usize) -> Arrangement {
        Arrangement::new(u16::try_from(number).unwrap_or_default())
    }

    fn state(&self, number: usize, arrangement: Arrangement) -> u16 {
        let Some((follower, stride)) = self.all.get(number) else { return 0 };
        u16::try_from(usize::from(arrangement.number()) / stride % follower.states()).unwrap_or_default()
    }

    /// How far an obstacle is from where the cell file says it is, m; nothing if it is not there.
    #[must_use]
    pub(crate) fn offset(&self, number: usize, arrangement: Arrangement) -> Option<Vec3> {
        let position = self.state(number, arrangement).checked_sub(1)?;
        match &self.all.get(number)?.0 {
            Follower::Obstacle { moves: Some(moves), .. } => Some(moves.offset(position)),
            _ => Some(Vec3::ZERO),
        }
    }

    /// The same arrangement without an obstacle.
    #[must_use]
    pub fn without(&self, number: usize, arrangement: Arrangement) -> Arrangement {
        let state = usize::from(self.state(number, arrangement));
        let stride = self.all.get(number).map_or(0, |(_, stride)| *stride);
        Self::numbered(usize::from(arrangement.number()) - state * stride)
    }

    /// The number of a sensor, if there are times at which it does not count.
    fn of_sensor(&self, sensor: usize) -> Option<usize> {
        self.all.iter().position(|(follower, _)| matches!(follower, Follower::Sensor(of, _) if *of == sensor))
    }

    /// Whether there are times at which a sensor does not count.
    #[must_use]
    pub fn has_sensor(&self, sensor: usize) -> bool {
        self.of_sensor(sensor).is_some()
    }

    /// Whether a sensor counts.
    #[must_use]
    pub fn counts(&self, sensor: usize, arrangement: Arrangement) -> bool {
        self.of_sensor(sensor).is_none_or(|number| self.state(number, arrangement) == 0)
    }

    /// Whether a control can be worked.
    #[must_use]
    pub fn lets_work(&self, control: usize, arrangement: Arrangement) -> bool {
        let number =
            self.all.iter().position(|(follower, _)| matches!(follower, Follower::Control(of, _) if *of == control));
        number.is_none_or(|number| self.state(number, arrangement) == 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pallet that goes from 0.2 m to 1.0 m in steps of 0.4 m while it is there, a lid, a zone, a door that is locked with it.
    fn following() -> Following {
        let band = |reading| Band { reading, from: 0.5, to: 1.5 };
        let moves = Moves { reading: 1, direction: Vec3::Y, from: 0.2, step_m: 0.4, positions: 3 };
        let pallet = Follower::Obstacle { stands: Some(band(0)), moves: Some(moves) };
        let lid = Follower::Obstacle { stands: Some(band(2)), moves: None };
        Following::new(vec![pallet, lid, Follower::Sensor(7, band(3)), Follower::Control(2, band(3))]).unwrap()
    }

    /// Every combination of readings against what each means by itself.
    #[test]
    fn arrangements_are_what_the_outputs_say() {
        let following = following();
        assert_eq!(following.of_obstacles(), 8);
        let positions = [(-3.0, 0.2), (0.2, 0.2), (0.39, 0.2), (0.41, 0.6), (0.79, 0.6), (0.81, 1.0), (9.0, 1.0)];
        let mut seen = std::collections::BTreeSet::new();
        for there in [0.0, 0.5, 1.0, 1.5, 2.0, f64::NAN] {
            for (at, expected) in positions {
                for lid in [0.0, 1.0] {
                    for zone in [0.0, 1.0] {
                        let arrangement = following.arrangement(|reading| [there, at, lid, zone][reading]);
                        seen.insert(arrangement);
                        let stands = (0.5..=1.5).contains(&there);
                        let offset = following.offset(0, arrangement);
                        assert_eq!(offset.is_some(), stands);
                        assert!(offset.is_none_or(|offset| (offset - Vec3::Y * expected).length() < 1e-12));
                        assert_eq!(following.offset(1, arrangement).is_some(), lid == 1.0);
                        assert_eq!(following.counts(7, arrangement), zone == 1.0);
                        assert_eq!(following.lets_work(2, arrangement), zone == 1.0);
                        assert!(following.lets_work(1, arrangement));
                        assert!(
                            following.counts(6, arrangement) && !following.has_sensor(6) && following.has_sensor(7)
                        );
                        let without = following.without(0, arrangement);
                        assert_eq!(following.offset(0, without), None);
                        assert_eq!(following.offset(1, without), following.offset(1, arrangement));
                        assert_eq!(following.counts(7, without), zone == 1.0);
                        assert_eq!(following.standing(arrangement), usize::from(arrangement.number()) % 8);
                    }
                }
            }
        }
        assert_eq!(seen.len(), 16);
        assert_eq!(following.arrangement(|_| f64::NAN), following.arrangement(|_| 0.0));
    }

    #[test]
    fn too_many_states_are_refused() {
        let band = Band { reading: 0, from: 1.0, to: 1.0 };
        assert!(Following::new(vec![Follower::Sensor(0, band); 16]).is_some());
        assert!(Following::new(vec![Follower::Sensor(0, band); 17]).is_none());
    }
}
