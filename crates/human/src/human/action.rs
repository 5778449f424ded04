//! The actions of the virtual human: six ways to walk, each with six postures (Huck et al., ICRA 2021), more of both where
//! the cell file asks for them, and beside them the controls of the cell that somebody works meanwhile.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{Presses, Who};

/// Duration of one action, s.
pub const ACTION_S: f64 = 0.2;

/// What the legs do during one action. A turn changes the heading at once, then the way leads straight ahead.
///
/// The first six are those of the paper; which of the others there are, a [`Repertoire`](super::Repertoire) says.
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
    /// Straight back, heading kept.
    Back,
    /// Straight ahead, faster than anybody walks.
    Run,
}

impl Walk {
    /// Those that everybody does, in the order of the action index.
    pub const USUAL: [Self; 6] = [Self::Stop, Self::Forward, Self::Left45, Self::Left90, Self::Right45, Self::Right90];
    /// Every walk once.
    pub(crate) const ALL: [Self; 8] =
        [Self::Stop, Self::Forward, Self::Left45, Self::Left90, Self::Right45, Self::Right90, Self::Back, Self::Run];

    /// The name used in texts.
    #[must_use]
    pub(crate) const fn id(self) -> &'static str {
        match self {
            Self::Stop => "stop",
            Self::Forward => "forward",
            Self::Left45 => "left45",
            Self::Left90 => "left90",
            Self::Right45 => "right45",
            Self::Right90 => "right90",
            Self::Back => "back",
            Self::Run => "run",
        }
    }

    /// For people.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Stop => "stands",
            Self::Forward => "walks straight ahead",
            Self::Left45 => "turns left by 45 degrees and walks on",
            Self::Left90 => "turns left by 90 degrees and walks on",
            Self::Right45 => "turns right by 45 degrees and walks on",
            Self::Right90 => "turns right by 90 degrees and walks on",
            Self::Back => "steps back",
            Self::Run => "runs straight ahead",
        }
    }

    /// Turn to the left at the start of the action, in eighths of a full turn.
    #[must_use]
    pub const fn turn_eighths(self) -> i8 {
        match self {
            Self::Stop | Self::Forward | Self::Back | Self::Run => 0,
            Self::Left45 => 1,
            Self::Left90 => 2,
            Self::Right45 => -1,
            Self::Right90 => -2,
        }
    }
}

/// What the body does during one action: a bend about the hip, or one of the low postures in which the legs are bent too.
/// Diagonal postures bend forward and sideways, each by its full angle.
///
/// The first six are those of the paper; which of the low ones there are, a [`Repertoire`](super::Repertoire) says.
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
    /// Both knees on the floor, trunk upright.
    Kneeling,
    /// On the feet, knees bent as far as they go, the trunk over them.
    Crouching,
    /// On hands and knees.
    Crawling,
}

impl Posture {
    /// Those of who stands, in the order of the action index; `USUAL[p as usize] == p`.
    pub const USUAL: [Self; 6] =
        [Self::Upright, Self::Forward, Self::Left, Self::Right, Self::ForwardLeft, Self::ForwardRight];
    /// The others, from the highest to the lowest.
    pub(crate) const LOW: [Self; 3] = [Self::Kneeling, Self::Crouching, Self::Crawling];
    /// Every posture once; `ALL[p as usize] == p`.
    pub const ALL: [Self; 9] = [
        Self::Upright,
        Self::Forward,
        Self::Left,
        Self::Right,
        Self::ForwardLeft,
        Self::ForwardRight,
        Self::Kneeling,
        Self::Crouching,
        Self::Crawling,
    ];

    /// Whether the legs are bent too.
    #[must_use]
    pub const fn is_low(self) -> bool {
        matches!(self, Self::Kneeling | Self::Crouching | Self::Crawling)
    }

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
            Self::Kneeling => "kneeling",
            Self::Crouching => "crouching",
            Self::Crawling => "crawling",
        }
    }

    /// The name used in texts.
    #[must_use]
    pub(crate) const fn id(self) -> &'static str {
        match self {
            Self::Upright => "upright",
            Self::Forward => "bend-forward",
            Self::Left => "bend-left",
            Self::Right => "bend-right",
            Self::ForwardLeft => "bend-forward-left",
            Self::ForwardRight => "bend-forward-right",
            Self::Kneeling => "kneel",
            Self::Crouching => "crouch",
            Self::Crawling => "crawl",
        }
    }

    /// Share of the forward angle: 0 or 1. Low postures have angles of their own.
    #[must_use]
    pub(crate) const fn forward_share(self) -> f64 {
        match self {
            Self::Forward | Self::ForwardLeft | Self::ForwardRight => 1.0,
            _ => 0.0,
        }
    }

    /// Share of the lateral angle, to the left positive: -1, 0 or 1.
    #[must_use]
    pub(crate) const fn left_share(self) -> f64 {
        match self {
            Self::Left | Self::ForwardLeft => 1.0,
            Self::Right | Self::ForwardRight => -1.0,
            _ => 0.0,
        }
    }
}

/// One action: a walk, a posture, and which controls are worked; where there are two people, what both of them do. Its text form
/// (`Display`, `FromStr`, serde) is like `left45/bend-forward`, with `&stop/upright` behind it for a second person who stands, and
/// then `+press1` where the first control of the cell file is worked. How actions are counted, a
/// [`Repertoire`](super::Repertoire) says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Action {
    presses: Presses,
    walk: Walk,
    posture: Posture,
    /// What the second person does, where there is one.
    second: Option<(Walk, Posture)>,
}

impl JsonSchema for Action {
    fn schema_name() -> Cow<'static, str> {
        "Action".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let walks = Walk::ALL.map(Walk::id).join("|");
        let postures = Posture::ALL.map(Posture::id).join("|");
        json_schema!({
            "description": "A walk and a posture, for 200 ms, those of the second person behind them where there is one, and the controls that are worked meanwhile, by their numbers in the cell file.",
            "type": "string",
            "pattern": format!("^({walks})/({postures})(&({walks})/({postures}))?(\\+press[1-{}])*$", Presses::MOST),
        })
    }
}

/// A text that is no action.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` is not an action: write a walk and a posture, such as `left45/bend-forward` or `stop/upright+press1`")]
pub struct UnknownAction(pub String);

impl Action {
    /// Stand upright and do nothing: the calmest action, and the first of every repertoire.
    pub const REST: Self = Self::new(Walk::Stop, Posture::Upright);

    /// The action that joins a walk and a posture.
    #[must_use]
    pub const fn new(walk: Walk, posture: Posture) -> Self {
        Self { presses: Presses::NONE, walk, posture, second: None }
    }

    /// The same with these controls worked.
    #[must_use]
    pub const fn pressing(self, presses: Presses) -> Self {
        Self { presses, ..self }
    }

    /// The same in another posture.
    #[must_use]
    pub const fn in_posture(self, posture: Posture) -> Self {
        Self { posture, ..self }
    }

    /// The same while a second person does what `other` says.
    #[must_use]
    pub const fn beside(self, other: Self) -> Self {
        Self { second: Some((other.walk, other.posture)), ..self }
    }

    /// What one of the people does, and the controls that are worked, by whomever; where there is no second one, they stand
    /// upright.
    #[must_use]
    pub const fn of(self, who: Who) -> Self {
        match (who, self.second) {
            (Who::First, _) => Self { second: None, ..self },
            (Who::Second, None) => Self::REST.pressing(self.presses),
            (Who::Second, Some((walk, posture))) => Self::new(walk, posture).pressing(self.presses),
        }
    }

    /// The same but for what one of the people does.
    #[must_use]
    pub const fn with(self, who: Who, does: Self) -> Self {
        match who {
            Who::First => Self { walk: does.walk, posture: does.posture, ..self },
            Who::Second => self.beside(does),
        }
    }

    /// Whether it says what a second person does.
    #[must_use]
    pub const fn is_of_two(self) -> bool {
        self.second.is_some()
    }

    /// How far from standing upright it is, to compare sequences of the same length: walking costs 2 and one more for
    /// each 45 degrees of a turn, backwards or when running, a bend forward or sideways 1, both 2, a low posture 3, each control
    /// that is worked 1. Two people make the efforts of both.
    #[must_use]
    pub const fn effort(self) -> u32 {
        let second = match self.second {
            Some((walk, posture)) => Self::new(walk, posture).effort(),
            None => 0,
        };
        let walk = match self.walk() {
            Walk::Stop => 0,
            Walk::Forward => 2,
            Walk::Left45 | Walk::Right45 | Walk::Back | Walk::Run => 3,
            Walk::Left90 | Walk::Right90 => 4,
        };
        let bend = match self.posture() {
            Posture::Upright => 0,
            Posture::Forward | Posture::Left | Posture::Right => 1,
            Posture::ForwardLeft | Posture::ForwardRight => 2,
            Posture::Kneeling | Posture::Crouching | Posture::Crawling => 3,
        };
        walk + bend + self.presses.count() + second
    }

    /// The controls that are worked.
    #[must_use]
    pub const fn presses(self) -> Presses {
        self.presses
    }

    /// What the legs do.
    #[must_use]
    pub const fn walk(self) -> Walk {
        self.walk
    }

    /// What the upper body does.
    #[must_use]
    pub const fn posture(self) -> Posture {
        self.posture
    }
}

impl fmt::Display for Action {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&String::from(*self))
    }
}

impl From<Action> for String {
    fn from(action: Action) -> Self {
        let moves = |(walk, posture): (Walk, Posture)| format!("{}/{}", walk.id(), posture.id());
        let second = action.second.map(|second| format!("&{}", moves(second))).unwrap_or_default();
        format!("{}{second}{}", moves((action.walk, action.posture)), action.presses)
    }
}

impl FromStr for Action {
    type Err = UnknownAction;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut parts = text.split("+press");
        let one = |moves: &str| {
            let (walk, posture) = moves.split_once('/')?;
            let walk = Walk::ALL.into_iter().find(|candidate| candidate.id() == walk)?;
            let posture = Posture::ALL.into_iter().find(|candidate| candidate.id() == posture)?;
            Some(Self::new(walk, posture))
        };
        let moves = parts.next().and_then(|moves| match moves.split_once('&') {
            Some((first, second)) => Some(one(first)?.beside(one(second)?)),
            None => one(moves),
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
    fn text_is_stable_and_read_back() {
        let action = Action::new(Walk::Left45, Posture::Forward);
        assert_eq!(action.to_string(), "left45/bend-forward");
        assert_eq!(Action::new(Walk::Right90, Posture::ForwardRight).to_string(), "right90/bend-forward-right");
        assert_eq!(Action::REST.to_string(), "stop/upright");
        assert_eq!(
            Action::new(Walk::Back, Posture::Crawling).pressing(Presses::one(1)).to_string(),
            "back/crawl+press2"
        );
        let moves = || Walk::ALL.into_iter().flat_map(|walk| Posture::ALL.map(|posture| Action::new(walk, posture)));
        let all = || Presses::all(Presses::MOST).flat_map(|set| moves().map(move |action| action.pressing(set)));
        let texts: BTreeSet<_> = all().map(|action| action.to_string()).collect();
        assert_eq!(texts.len(), 8 * 9 * 64);
        let of_two =
            moves().flat_map(|first| moves().map(move |second| first.beside(second).pressing(Presses::one(3))));
        for action in all().chain(of_two) {
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
            "stop/upright&",
            "stop/upright&stop",
            "stop/upright+press1&stop/upright",
            "stop/upright&stop/upright&stop/upright",
            "7",
        ] {
            let error = text.parse::<Action>().unwrap_err();
            assert!(error.to_string().starts_with(&format!("`{text}` is not an action")), "{error}");
            assert!(serde_json::from_str::<Action>(&format!("\"{text}\"")).is_err());
        }
    }

    /// Of two people each does what is said of it, and both work the controls.
    #[test]
    fn two_people_do_what_is_said_of_each() {
        let (a, b) = (Action::new(Walk::Left45, Posture::Forward), Action::new(Walk::Stop, Posture::Crouching));
        let both = a.beside(b).pressing(Presses::one(0));
        assert_eq!(both.to_string(), "left45/bend-forward&stop/crouch+press1");
        assert_eq!([Who::First, Who::Second].map(|who| both.of(who).pressing(Presses::NONE)), [a, b]);
        assert_eq!(both.of(Who::Second).presses(), Presses::one(0));
        assert_eq!(both.with(Who::First, b).with(Who::Second, a), b.beside(a).pressing(Presses::one(0)));
        assert_eq!(both.effort(), a.effort() + b.effort() + 1);
        assert_eq!((a.of(Who::First), a.of(Who::Second)), (a, Action::REST));
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
