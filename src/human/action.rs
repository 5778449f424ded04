//! The actions of the virtual human: six ways to walk, each with six postures (Huck et al., ICRA 2021), and beside them the
//! controls of the cell that somebody works meanwhile.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::Presses;

/// Duration of one action, s.
pub const ACTION_S: f64 = 0.2;

/// What the legs do during one action. A turn changes the heading at once, then the way leads straight ahead.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Walk {
    /// Stand still, heading kept.
    Stop,
    /// Straight ahead.
    Forward,
    /// Turn left by 45 degrees, then straight ahead.
    Left45,
    /// Turn left by 90 degrees, then straight ahead.
    Left90,
    /// Turn right by 45 degrees, then straight ahead.
    Right45,
    /// Turn right by 90 degrees, then straight ahead.
    Right90,
}

impl Walk {
    /// Every walk once, in the order of the action index.
    pub const ALL: [Self; 6] = [Self::Stop, Self::Forward, Self::Left45, Self::Left90, Self::Right45, Self::Right90];

    /// The name used in texts.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Stop => "stop",
            Self::Forward => "forward",
            Self::Left45 => "left45",
            Self::Left90 => "left90",
            Self::Right45 => "right45",
            Self::Right90 => "right90",
        }
    }

    /// Turn to the left at the start of the action, in eighths of a full turn.
    #[must_use]
    pub const fn turn_eighths(self) -> i8 {
        match self {
            Self::Stop | Self::Forward => 0,
            Self::Left45 => 1,
            Self::Left90 => 2,
            Self::Right45 => -1,
            Self::Right90 => -2,
        }
    }
}

/// What the upper body does during one action: a bend about the hip. Diagonal postures bend forward and sideways, each
/// by its full angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Posture {
    /// No bend.
    Upright,
    /// Bent forward.
    Forward,
    /// Bent to the left.
    Left,
    /// Bent to the right.
    Right,
    /// Bent forward and to the left.
    ForwardLeft,
    /// Bent forward and to the right.
    ForwardRight,
}

impl Posture {
    /// Every posture once, in the order of the action index; `ALL[p as usize] == p`.
    pub const ALL: [Self; 6] =
        [Self::Upright, Self::Forward, Self::Left, Self::Right, Self::ForwardLeft, Self::ForwardRight];

    /// For people.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Upright => "upright",
            Self::Forward => "bent forward",
            Self::Left => "bent to the left",
            Self::Right => "bent to the right",
            Self::ForwardLeft => "bent forward and to the left",
            Self::ForwardRight => "bent forward and to the right",
        }
    }

    /// The name used in texts.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Upright => "upright",
            Self::Forward => "bend-forward",
            Self::Left => "bend-left",
            Self::Right => "bend-right",
            Self::ForwardLeft => "bend-forward-left",
            Self::ForwardRight => "bend-forward-right",
        }
    }

    /// Share of the forward angle: 0 or 1.
    #[must_use]
    pub const fn forward_share(self) -> f64 {
        match self {
            Self::Upright | Self::Left | Self::Right => 0.0,
            Self::Forward | Self::ForwardLeft | Self::ForwardRight => 1.0,
        }
    }

    /// Share of the lateral angle, to the left positive: -1, 0 or 1.
    #[must_use]
    pub const fn left_share(self) -> f64 {
        match self {
            Self::Upright | Self::Forward => 0.0,
            Self::Left | Self::ForwardLeft => 1.0,
            Self::Right | Self::ForwardRight => -1.0,
        }
    }
}

/// One action: a walk, a posture, and which controls are worked. Its index is `36 * set of controls + 6 * walk + posture`, so
/// without controls it is in 0..36. Its text form (`Display`, `FromStr`, serde) is like `left45/bend-forward`, with
/// `+press1` behind it where the first control of the cell file is worked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Action {
    presses: Presses,
    moves: u8,
}

impl JsonSchema for Action {
    fn schema_name() -> Cow<'static, str> {
        "Action".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let walks = Walk::ALL.map(Walk::id).join("|");
        let postures = Posture::ALL.map(Posture::id).join("|");
        json_schema!({
            "description": "A walk and a posture, for 200 ms, and the controls that are worked meanwhile, by their numbers in the cell file.",
            "type": "string",
            "pattern": format!("^({walks})/({postures})(\\+press[1-{}])*$", Presses::MOST),
        })
    }
}

/// A text that is no action.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` is not an action: write a walk and a posture, such as `left45/bend-forward` or `stop/upright+press1`")]
pub struct UnknownAction(pub String);

impl Action {
    /// Number of actions without a control.
    pub const COUNT: usize = Walk::ALL.len() * Posture::ALL.len();

    /// Every action without a control once; `ALL[i].index() == i`.
    pub const ALL: [Self; Self::COUNT] = {
        let mut all = [Self::REST; Self::COUNT];
        let mut index = 0;
        let mut moves = 0;
        while index < Self::COUNT {
            all[index] = Self { presses: Presses::NONE, moves };
            index += 1;
            moves += 1;
        }
        all
    };

    /// Stand upright and do nothing: the calmest action.
    pub const REST: Self = Self::new(Walk::Stop, Posture::Upright);

    /// The action that joins a walk and a posture.
    #[must_use]
    pub const fn new(walk: Walk, posture: Posture) -> Self {
        Self { presses: Presses::NONE, moves: walk as u8 * 6 + posture as u8 }
    }

    /// The same with these controls worked.
    #[must_use]
    pub const fn pressing(self, presses: Presses) -> Self {
        Self { presses, ..self }
    }

    /// Number of actions in a cell with so many controls.
    #[must_use]
    pub const fn count(controls: usize) -> usize {
        Self::COUNT << controls
    }

    /// The action with this index, if there is one.
    #[must_use]
    pub fn from_index(index: usize) -> Option<Self> {
        let presses = Presses::from_index(index / Self::COUNT)?;
        Some(Self::ALL[index % Self::COUNT].pressing(presses))
    }

    /// The action with an index that was counted up to [`Action::count`].
    ///
    /// # Panics
    /// For an index that no cell has: another action in its place would be looked at twice, and its own never.
    #[must_use]
    pub fn counted(index: usize) -> Self {
        let action = Self::from_index(index);
        assert!(action.is_some(), "there is no action {index}");
        action.unwrap_or(Self::REST)
    }

    /// Its index.
    #[must_use]
    pub const fn index(self) -> usize {
        self.presses.index() * Self::COUNT + self.moves as usize
    }

    /// How far from standing upright it is, to compare sequences of the same length: walking costs 2 and one more for
    /// each 45 degrees of a turn, a bend forward or sideways 1, both 2, each control that is worked 1.
    #[must_use]
    pub const fn effort(self) -> u32 {
        let walk = match self.walk() {
            Walk::Stop => 0,
            Walk::Forward => 2,
            Walk::Left45 | Walk::Right45 => 3,
            Walk::Left90 | Walk::Right90 => 4,
        };
        let bend = match self.posture() {
            Posture::Upright => 0,
            Posture::Forward | Posture::Left | Posture::Right => 1,
            Posture::ForwardLeft | Posture::ForwardRight => 2,
        };
        walk + bend + self.presses.count()
    }

    /// The controls that are worked.
    #[must_use]
    pub const fn presses(self) -> Presses {
        self.presses
    }

    /// What the legs do.
    #[must_use]
    pub const fn walk(self) -> Walk {
        Walk::ALL[self.moves as usize / Posture::ALL.len()]
    }

    /// What the upper body does.
    #[must_use]
    pub const fn posture(self) -> Posture {
        Posture::ALL[self.moves as usize % Posture::ALL.len()]
    }
}

impl fmt::Display for Action {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&String::from(*self))
    }
}

impl From<Action> for String {
    fn from(action: Action) -> Self {
        format!("{}/{}{}", action.walk().id(), action.posture().id(), action.presses)
    }
}

impl FromStr for Action {
    type Err = UnknownAction;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut parts = text.split("+press");
        let moves = parts.next().and_then(|moves| moves.split_once('/')).and_then(|(walk, posture)| {
            let walk = Walk::ALL.into_iter().find(|candidate| candidate.id() == walk)?;
            let posture = Posture::ALL.into_iter().find(|candidate| candidate.id() == posture)?;
            Some(Self::new(walk, posture))
        });
        let named = parts.try_fold(moves, |so_far, number| {
            let control = number.parse::<usize>().ok().filter(|n| (1..=Presses::MOST).contains(n))?;
            Some(so_far.map(|action| action.pressing(action.presses.and(Presses::one(control - 1)))))
        });
        let named = named.flatten().filter(|action| String::from(*action) == text);
        named.ok_or_else(|| UnknownAction(text.to_owned()))
    }
}

impl TryFrom<String> for Action {
    type Error = UnknownAction;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn index_walk_and_posture_name_the_same_action() {
        assert_eq!(Action::COUNT, 36);
        for (index, action) in Action::ALL.into_iter().enumerate() {
            assert_eq!(action.index(), index);
            assert_eq!(Action::from_index(index), Some(action));
            assert_eq!(action.walk() as usize * 6 + action.posture() as usize, index);
            assert_eq!(Action::new(action.walk(), action.posture()), action);
        }
        assert_eq!(Action::REST, Action::ALL[0]);
    }

    #[test]
    fn text_is_stable_and_read_back() {
        let action = Action::new(Walk::Left45, Posture::Forward);
        assert_eq!(action.to_string(), "left45/bend-forward");
        assert_eq!(Action::new(Walk::Right90, Posture::ForwardRight).to_string(), "right90/bend-forward-right");
        assert_eq!(Action::REST.to_string(), "stop/upright");
        let texts: BTreeSet<_> = Action::ALL.iter().map(ToString::to_string).collect();
        assert_eq!(texts.len(), 36);
        for action in (0..).map_while(Action::from_index) {
            assert_eq!(action.to_string().parse(), Ok(action));
            let json = serde_json::to_string(&action).unwrap();
            assert_eq!(json, format!("\"{action}\""));
            assert_eq!(serde_json::from_str::<Action>(&json).unwrap(), action);
        }
    }

    #[test]
    fn other_texts_are_refused_by_name() {
        for text in [
            "stop/upright+press0",
            "stop/upright+press7",
            "stop/upright+press",
            "stop/upright+press2+press1",
            "",
            "stop/upright+press1+press1",
            "stop",
            "stop/",
            "/upright",
            "stop/upright/",
            "Stop/upright",
            "left45 /bend-forward",
            "7",
        ] {
            let error = text.parse::<Action>().unwrap_err();
            assert!(error.to_string().starts_with(&format!("`{text}` is not an action")), "{error}");
            assert!(serde_json::from_str::<Action>(&format!("\"{text}\"")).is_err());
        }
    }

    /// Controls go over and above the 36: what there is without them keeps its index.
    #[test]
    fn controls_double_the_actions() {
        assert_eq!((Action::count(0), Action::count(2)), (36, 144));
        assert_eq!(Action::from_index(Action::count(Presses::MOST)), None);
        let walk = Action::new(Walk::Left45, Posture::Forward);
        let pressing = walk.pressing(Presses::one(1));
        assert_eq!((pressing.walk(), pressing.posture()), (walk.walk(), walk.posture()));
        assert_eq!((pressing.index(), pressing.effort()), (72 + walk.index(), walk.effort() + 1));
        assert_eq!(pressing.to_string(), "left45/bend-forward+press2");
        for index in 0..Action::count(Presses::MOST) {
            assert_eq!(Action::counted(index).index(), index);
        }
    }

    /// Left and right mirror each other, in turns and in bends.
    #[test]
    fn left_mirrors_right() {
        for (left, right) in [(Walk::Left45, Walk::Right45), (Walk::Left90, Walk::Right90)] {
            assert!(left.turn_eighths() > 0);
            assert_eq!(left.turn_eighths(), -right.turn_eighths());
        }
        for (left, right) in [(Posture::Left, Posture::Right), (Posture::ForwardLeft, Posture::ForwardRight)] {
            assert_eq!(left.left_share(), 1.0);
            assert_eq!(right.left_share(), -1.0);
            assert_eq!(left.forward_share(), right.forward_share());
        }
    }
}
