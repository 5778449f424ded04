//! What an answer rests on. Whatever "nobody is hit" needs is shown, assumed or open, and a clean verdict is made here alone, from a
//! list with nothing open.
//!
//! - [`need`]: what answers need, a closed list
//! - [`assumption`]: what can only be tried out, and counts once the cell file accepts it
//! - [`readings`]: how those that are answered alike are named
//! - [`verdict`]: the verdict, clean ones by obligations only
//!
//! Each engine replies to every need ([`Engine`]) and takes the cell and its options apart field by field to do so: a new need, key,
//! sensor kind or option does not compile before both engines say what they do with it.

pub(crate) mod assumption;
pub(crate) mod need;
pub mod readings;
pub mod verdict;

use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use self::assumption::{Acceptance, Assumption};
pub use self::need::Need;
pub use self::verdict::{Clean, Verdict};

/// Something that an answer needs, and what is known of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Obligation {
    /// What is needed.
    pub need: Need,
    /// The same in words.
    pub says: String,
    /// Of which robot, sensor or control, where there are several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<String>,
    /// What is known of it.
    #[serde(flatten)]
    pub standing: Standing,
}

/// What is known of something that an answer needs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "standing", rename_all = "snake_case")]
pub enum Standing {
    /// It is so.
    Shown {
        /// How far that was looked at, in words with a figure.
        figure: String,
    },
    /// It was only tried out, and the cell file accepts it.
    Assumed {
        /// Who does.
        by: String,
        /// Why.
        because: String,
        /// How far it was tried out.
        tried: String,
    },
    /// It is not known.
    Open {
        /// Why, and where.
        why: String,
        /// What to do about it, as a sentence.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        what_to_do: Option<String>,
        /// Lines for the cell file that accept it, where that can be accepted.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        accept: Option<String>,
    },
}

/// What an engine says of one robot, sensor or control, or of all.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Of which.
    pub about: Option<String>,
    /// What is known.
    pub standing: Standing,
}

impl Point {
    /// It is so.
    #[must_use]
    pub fn shown(figure: impl Into<String>) -> Self {
        Self { about: None, standing: Standing::Shown { figure: figure.into() } }
    }

    /// It is not known.
    #[must_use]
    pub fn open(why: impl Into<String>) -> Self {
        Self { about: None, standing: Standing::Open { why: why.into(), what_to_do: None, accept: None } }
    }

    /// It is not known, and this is to be done about it, a sentence without its full stop.
    #[must_use]
    pub fn open_until(why: impl Into<String>, what_to_do: impl Into<String>) -> Self {
        let standing = Standing::Open { why: why.into(), what_to_do: Some(what_to_do.into()), accept: None };
        Self { about: None, standing }
    }

    /// Of this one.
    #[must_use]
    pub fn of(self, about: impl Into<String>) -> Self {
        Self { about: Some(about.into()), ..self }
    }

    /// Tried out so far: assumed if one of these accepts it.
    #[must_use]
    pub fn tried(assumption: &Assumption, tried: impl Into<String>, accepted: &[Acceptance], fmu: &str) -> Self {
        let tried = tried.into();
        let standing = match accepted.iter().find(|one| one.assumption.covers(assumption)) {
            Some(Acceptance { by, because, .. }) => {
                Standing::Assumed { by: by.clone(), because: because.clone(), tried }
            }
            None => Standing::Open {
                why: format!("{}: {tried}, which does not show it", assumption.words()),
                what_to_do: None,
                accept: Some(assumption.lines(fmu)),
            },
        };
        Self { about: None, standing }
    }
}

/// What an engine replies to a need.
#[derive(Clone, Debug)]
pub enum Reply {
    /// The question has nothing of the kind, and why.
    NotAsked(&'static str),
    /// What is known. Nothing at all is not an answer, and counts as open.
    Points(Vec<Point>),
}

impl Reply {
    /// It is so if nothing is against it.
    #[must_use]
    pub fn unless(against: Vec<Point>, figure: impl Into<String>) -> Self {
        Self::Points(if against.is_empty() { vec![Point::shown(figure)] } else { against })
    }
}

/// A way to search. It replies to every need, by one `match` without a wildcard.
pub trait Engine {
    /// What is known of this.
    fn reply(&self, need: Need) -> Reply;
}

/// All that an answer needs.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct Obligations {
    all: Vec<Obligation>,
}

impl Obligations {
    /// By asking an engine for every need there is.
    #[must_use]
    pub fn of(engine: &impl Engine) -> Self {
        let points = |need: Need| match engine.reply(need) {
            Reply::NotAsked(_) => Vec::new(),
            Reply::Points(points) if points.is_empty() => vec![Point::open("nothing is known of it")],
            Reply::Points(points) => points,
        };
        let of = |need: Need| {
            let obligation =
                move |Point { about, standing }| Obligation { need, says: need.words().to_owned(), about, standing };
            points(need).into_iter().map(obligation)
        };
        Self { all: Need::ALL.into_iter().flat_map(of).collect() }
    }

    /// All of them, in the order of the needs.
    #[must_use]
    pub fn all(&self) -> &[Obligation] {
        &self.all
    }

    /// Those that are open.
    pub fn open(&self) -> impl Iterator<Item = &Obligation> {
        self.all.iter().filter(|one| one.is_open())
    }

    /// Why each that is open is so.
    #[must_use]
    pub fn reasons(&self) -> Vec<String> {
        self.open().filter_map(Obligation::why).map(str::to_owned).collect()
    }

    /// That a clean word may be said: nothing is open. Of no obligations at all nothing clean is said.
    #[must_use]
    pub fn clean(&self) -> Option<Clean> {
        (!self.all.is_empty() && self.open().next().is_none()).then(Clean::earned)
    }

    /// Lines that the cell file needs so that all that was only tried out counts, in the order of the needs; nothing if there are none.
    #[must_use]
    pub fn lines_to_accept(&self) -> Option<String> {
        let lines = self.all.iter().filter_map(|one| match &one.standing {
            Standing::Open { accept: Some(lines), .. } => Some(lines.as_str()),
            _ => None,
        });
        let lines: Vec<&str> = lines.collect();
        (!lines.is_empty()).then(|| lines.join("\n"))
    }

    /// Why nothing clean is said, in half a sentence: the first that is open, and how many more.
    #[must_use]
    pub fn first_reason(&self) -> Option<String> {
        let mut open = self.open().filter_map(Obligation::why);
        let mut words = open.next()?.to_owned();
        match open.count() {
            0 => {}
            1 => words += ", and for one other reason",
            more => {
                let _ = write!(words, ", and for {more} other reasons");
            }
        }
        Some(words)
    }
}

impl Obligation {
    /// Whether it is open.
    #[must_use]
    pub(crate) const fn is_open(&self) -> bool {
        matches!(self.standing, Standing::Open { .. })
    }

    /// Why it is open, if it is.
    #[must_use]
    pub(crate) fn why(&self) -> Option<&str> {
        match &self.standing {
            Standing::Open { why, .. } => Some(why),
            Standing::Shown { .. } | Standing::Assumed { .. } => None,
        }
    }

    /// In words: what is needed, and what is known of it.
    #[must_use]
    pub fn words(&self) -> String {
        let of = self.about.as_ref().map_or_else(String::new, |about| format!(" ({about})"));
        let known = match &self.standing {
            Standing::Shown { figure } => figure.clone(),
            Standing::Assumed { by, because, tried } => format!("accepted by {by}: {because} ({tried})"),
            Standing::Open { why, what_to_do: Some(what_to_do), .. } => format!("{why}. {what_to_do}"),
            Standing::Open { why, what_to_do: None, .. } => why.clone(),
        };
        format!("{}{of}: {known}", self.says)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Everything is shown but what is given.
    struct All<'a>(&'a dyn Fn(Need) -> Option<Reply>);

    impl Engine for All<'_> {
        fn reply(&self, need: Need) -> Reply {
            (self.0)(need).unwrap_or_else(|| Reply::Points(vec![Point::shown("all of it")]))
        }
    }

    #[test]
    fn nothing_clean_is_said_while_anything_is_open() {
        assert!(Obligations::of(&All(&|_| None)).clean().is_some());
        for open in Need::ALL {
            for points in [vec![Point::open("not looked at")], Vec::new(), vec![Point::shown("a"), Point::open("b")]] {
                let reply = |need: Need| (need == open).then(|| Reply::Points(points.clone()));
                let obligations = Obligations::of(&All(&reply));
                assert!(obligations.clean().is_none(), "{open:?}");
                assert_eq!(obligations.open().count(), 1);
            }
        }
        assert!(Obligations::default().clean().is_none());
        assert!(Obligations::of(&All(&|_| Some(Reply::NotAsked("nothing")))).clean().is_none());
    }

    #[test]
    fn what_is_tried_out_counts_once_it_is_accepted() {
        let ignores = |sensor: &str| Assumption::RobotIgnoresSensor { robot: "R2".into(), sensor: sensor.into() };
        let accepted = [Acceptance { assumption: ignores("B"), by: "A. B.".into(), because: "wired so".into() }];
        let of = |assumption: &Assumption| Point::tried(assumption, "in 20 runs", &accepted, "ab12").standing;
        assert!(matches!(of(&ignores("B")), Standing::Assumed { by, .. } if by == "A. B."));
        let Standing::Open { accept: Some(lines), .. } = of(&ignores("C")) else { panic!("it is not accepted") };
        assert!(lines.contains("sensor = \"C\"") && lines.contains("fmu = \"ab12\""), "{lines}");
    }
}
