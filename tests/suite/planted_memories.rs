//! Memories that are planted in a drive, one after the other, and whether behaviours are refused for it: the whole decision, from how long
//! readings are held to the last walk. Each memory tells by which test it is found, or why it is not; drives without any pass.

use std::convert::Infallible;
use std::ops::ControlFlow;

use fmi_hazard::search::Rng;
use fmi_hazard::search::behaviours::answers::answered_alike;
use fmi_hazard::search::behaviours::decided::{DecisionLimits, Why, decide};
use fmi_hazard::search::behaviours::walks::{Style, Walked, walk};
use fmi_hazard::search::behaviours::{AllHeld, Begins, Held, Hold, Machine, OutputClass};

/// Eight seconds in steps of 20 ms.
const QUESTION: DecisionLimits = DecisionLimits { step_s: 0.02, steps: 400, most: 25_000, times_held: 1 };
const SECOND: i64 = 50;
const DAY: i64 = 24 * 3600 * SECOND;

/// A drive goes round in `PERIOD` at `FULL` a step: two seconds. It takes in a demand after so many steps, and slows down by one in each.
const PERIOD: i64 = 400;
const FULL: i64 = 4;
const REACTION: i64 = 5;
/// No stop is later by more steps than that.
const LATEST: i64 = 8;

/// What happens in a step. Reading 0 is closed, others are open: of two sensors 1 is the first alone, 2 the second, 3 both.
struct Now {
    reading: usize,
    open: bool,
    opens: bool,
    closes: bool,
    /// For so many steps it has been open, or closed, when the step begins: where it opens or closes, how long it was the other.
    since: i64,
    /// Where the drive is, and whether it stands.
    at: i64,
    stands: bool,
    /// Steps since the start, and the reading before.
    step: i64,
    before: usize,
}

/// What a drive remembers besides, and what that does: it is told in vain, or later, or told to stop where it is closed; and of that it
/// may show something from 0 to 15.
#[derive(Clone, Debug, Default)]
struct Mind {
    n: [i64; 4],
    vain: bool,
    late: i64,
    waits: bool,
    shown: i64,
}

impl Mind {
    /// One of so many numbers, of a generator in the drive.
    const fn drawn(&mut self, of: i64) -> i64 {
        self.n[3] = (self.n[3] * 1_103_515_245 + 12_345) % (1 << 31);
        (self.n[3] >> 12) % of
    }
}

type Remember = fn(&mut Mind, &Now);

#[derive(Clone, Debug)]
struct State {
    at: i64,
    speed: i64,
    told_for: i64,
    reading: usize,
    since: i64,
    step: i64,
    mind: Mind,
}

struct Drive {
    /// By number, readings that are taken for one.
    readings: Vec<Vec<usize>>,
    remember: Remember,
    /// Whether these have numbers of their own.
    apart: bool,
}

impl Drive {
    /// What a reading is taken for, and what is given then.
    fn given(&self, reading: usize) -> (usize, usize) {
        let mut all = self.readings.iter().enumerate().flat_map(|(n, alike)| alike.iter().map(move |own| (n, *own)));
        if self.apart { all.nth(reading).unwrap() } else { (reading, self.readings[reading][0]) }
    }

    fn after(remember: Remember, state: &mut State, reading: usize) {
        let (open, was_open) = (reading > 0, state.reading > 0);
        let now = Now {
            reading,
            open,
            opens: open && !was_open,
            closes: !open && was_open,
            since: state.since,
            at: state.at,
            stands: state.speed == 0,
            step: state.step,
            before: state.reading,
        };
        remember(&mut state.mind, &now);
        state.since = if open == was_open { state.since + 1 } else { 1 };
        (state.reading, state.step) = (reading, state.step + 1);
        let told = (open || state.mind.waits) && !state.mind.vain;
        state.told_for = if told { (state.told_for + 1).min(REACTION + LATEST + 1) } else { 0 };
        let slows = state.told_for > REACTION + state.mind.late;
        state.speed = if slows { (state.speed - 1).max(0) } else { (state.speed + 1).min(FULL) };
        state.at = (state.at + state.speed) % PERIOD;
    }
}

/// Where it is, how fast, and what else it shows.
fn shown(state: &State) -> OutputClass {
    OutputClass::try_from((state.at * (FULL + 1) + state.speed) * 16 + state.mind.shown).unwrap()
}

impl Machine for Drive {
    type State = State;
    type Error = Infallible;

    fn readings(&self) -> usize {
        if self.apart { self.readings.iter().map(Vec::len).sum() } else { self.readings.len() }
    }

    fn tell_apart(&mut self, apart: bool) {
        self.apart = apart;
    }

    fn taken_for(&self, reading: usize) -> usize {
        self.given(reading).0
    }

    fn alike(&self, one: OutputClass, other: OutputClass) -> bool {
        one == other
    }

    fn switches(&self, one: OutputClass, among: [OutputClass; 3]) -> bool {
        let full = OutputClass::try_from(FULL + 1).unwrap();
        let columns = |shown: OutputClass| [shown / 16 / full, shown / 16 % full, shown % 16];
        (0..3).all(|column| among.iter().any(|its| columns(*its)[column] == columns(one)[column]))
    }

    fn begin(&mut self) -> Result<(State, OutputClass), Infallible> {
        let state = State { at: 0, speed: FULL, told_for: 0, reading: 0, since: 0, step: 0, mind: Mind::default() };
        let shown = shown(&state);
        Ok((state, shown))
    }

    fn hold_each(&mut self, holds: &[Hold<'_, State>]) -> Result<AllHeld<State>, Infallible> {
        let mut ended: Vec<Held<State>> = Vec::new();
        for Hold { from, reading, steps, last } in holds {
            let mut state = match from {
                Begins::At(state) => (*state).clone(),
                Begins::After(number) => ended[*number].1.clone(),
            };
            let given = self.given(*reading).1;
            let all = (0..*steps).map(|_| {
                Self::after(self.remember, &mut state, given);
                shown(&state)
            });
            let mut all: Vec<OutputClass> = all.collect();
            all.drain(..if *last { all.len() - 1 } else { 0 });
            ended.push((all, state));
        }
        Ok(Some(ended))
    }
}

/// By what a memory is found, or why it is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Found {
    /// Something shows later than is looked.
    Late,
    /// Its histories hardly ever end where others do.
    Ends,
    /// There are more behaviours than are counted.
    TooMany,
    /// A walk of this kind shows something else.
    Walk(Style),
    /// It is not refused, and need not be: each of its states shows, so behaviours have what it remembers.
    Known(Way),
    /// It is not refused, and this would show it: what walks do not do.
    Passes(Way),
}

/// Readings, each held for some steps, again and again, and what is held after that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Way {
    times: usize,
    round: &'static [(usize, usize)],
    then: &'static [(usize, usize)],
}

const fn way(times: usize, round: &'static [(usize, usize)], then: &'static [(usize, usize)]) -> Way {
    Way { times, round, then }
}

/// Openings that are long enough to stop it.
const STOPS: Way = way(5, &[(0, 70), (1, 30)], &[]);

use Found::{Ends, Known, Late, Passes, TooMany, Walk};

/// What is found, where that is expected, by the whole decision.
fn found(readings: usize, remember: Remember, expected: Found) -> Found {
    let mut drive = Drive { readings: (0..readings).map(|own| vec![own]).collect(), remember, apart: false };
    let decided =
        |drive: &mut Drive| decide(drive, QUESTION, &mut Rng::new(1), &mut |_| ControlFlow::Continue(())).unwrap();
    // Readings that are answered alike first as one, as a scan does.
    let alike = answered_alike(&mut drive, &mut Rng::new(1), (QUESTION.steps, 150), &mut || true).unwrap().unwrap();
    let firsts = (0..readings).filter(|own| alike[*own] == *own);
    let alike = firsts.map(|first| (0..readings).filter(|own| alike[*own] == first).collect()).collect();
    let mut fewer = Drive { readings: alike, remember, apart: false };
    let of_fewer = (fewer.readings.len() < readings).then(|| decided(&mut fewer));
    let decided = match of_fewer {
        Some(Ok(decided)) => {
            drive = fewer;
            Ok(decided)
        }
        Some(Err(why)) if !matches!(why, Why::RemembersMore { .. }) => Err(why),
        _ => decided(&mut drive),
    };
    let decided = match decided {
        Ok(decided) => decided,
        Err(Why::ShowsLate) => return Late,
        Err(Why::HardlyEverSame { .. }) => return Ends,
        Err(Why::TooMany) => return TooMany,
        Err(Why::RemembersMore { style, .. }) => return Walk(style),
        Err(why) => panic!("{why:?}"),
    };
    let way = match expected {
        Known(way) | Passes(way) => way,
        _ => STOPS,
    };
    let walked: Vec<_> = way.round.repeat(way.times).into_iter().chain(way.then.iter().copied()).collect();
    let number = |reading: usize| drive.readings.iter().position(|alike| alike.contains(&reading)).unwrap();
    let walked: Vec<_> = walked.into_iter().map(|(reading, steps)| (number(reading), steps)).collect();
    match walk(&mut drive, &decided.behaviours, &walked).unwrap() {
        Walked::Alike(_) => Known(way),
        Walked::Unlike { .. } => Passes(way),
        Walked::Unfinished => panic!("{walked:?}"),
    }
}

/// A name, how many readings there are, the memory, and by what it is found.
type Planted = (&'static str, usize, Remember, Found);

fn holds(planted: &[Planted]) {
    let found = |(name, readings, remember, expected): &Planted| (*name, found(*readings, *remember, *expected));
    let all: Vec<_> = planted.iter().map(found).collect();
    let expected: Vec<_> = planted.iter().map(|(name, _, _, expected)| (*name, *expected)).collect();
    assert_eq!(all, expected);
}

/// What these remember shows while one reading is held.
const HONEST: &[Planted] = &[
    ("reaction and ramp", 2, |_, _| {}, Known(STOPS)),
    ("two sensors that do the same", 4, |_, _| {}, Known(STOPS)),
    ("one of two sensors is slower", 3, |m, now| m.late = if now.reading == 1 { 0 } else { 3 }, Known(STOPS)),
    (
        "a stop in one part of the programme is late",
        2,
        |m, now| {
            if now.opens {
                m.late = if now.at < 100 { 4 } else { 0 };
            }
        },
        Known(STOPS),
    ),
    ("it starts half a second after it was closed", 2, |m, now| starts(m, now, SECOND / 2), Known(STOPS)),
    ("it starts two seconds after it was closed", 2, |m, now| starts(m, now, 2 * SECOND), Known(STOPS)),
    (
        "a filter of readings, of which an output tells how far it is",
        2,
        |m, now| {
            m.n[0] = (m.n[0] + if now.open { 1 } else { -1 }).clamp(0, 6);
            (m.vain, m.waits, m.shown) = (m.n[0] < 3, m.n[0] >= 3, m.n[0]);
        },
        Known(STOPS),
    ),
    // After one opening it is known whether the next is the second: it is ignored if it comes now.
    ("ignored from the 2nd opening on", 2, |m, now| from(m, now, 2), Known(STOPS)),
];

/// These forget as well, but late, or only a change of readings shows what they remember, or two of them one after the other: states are taken
/// for one that are not, and walks tell. Nothing is wrong with them but that.
const REFUSED_ALL_THE_SAME: &[Planted] = &[
    // A demand counts up while it is there and down while it is not.
    (
        "a filter of readings",
        2,
        |m, now| {
            m.n[0] = (m.n[0] + if now.open { 1 } else { -1 }).clamp(0, 6);
            (m.vain, m.waits) = (m.n[0] < 3, m.n[0] >= 3);
        },
        Walk(Style::EveryStep),
    ),
    // A part of what is missing is made up for in each step.
    (
        "a low pass",
        2,
        |m, now| {
            m.n[0] += (if now.open { 1000 } else { 0 } - m.n[0]) / 4;
            (m.vain, m.waits) = (m.n[0] < 600, m.n[0] >= 600);
        },
        Walk(Style::EveryStep),
    ),
    (
        "a reading is taken in when it has been there for three steps",
        2,
        |m, now| {
            m.n[0] = if now.open == m.waits { 0 } else { m.n[0] + 1 };
            m.waits ^= m.n[0] == 3;
            m.vain = !m.waits;
        },
        Walk(Style::Short),
    ),
    // It is looked three seconds ahead, and nothing is seen to show late then.
    ("it starts eleven seconds after it was closed", 2, |m, now| starts(m, now, 11 * SECOND), Walk(Style::Any)),
    (
        "for half a second after a stop the next one is later",
        2,
        |m, now| {
            if now.opens {
                m.late = if now.since < SECOND / 2 && m.n[0] == 1 { 2 } else { 0 };
                m.n[0] = 1;
            }
        },
        Walk(Style::EveryStep),
    ),
];

const COUNTS: &[Planted] = &[
    ("ignored from the 4th opening on", 2, |m, now| from(m, now, 4), Walk(Style::EveryStep)),
    ("ignored from the 8th opening on", 2, |m, now| from(m, now, 8), Walk(Style::EveryStep)),
    ("ignored from the 20th opening on", 2, |m, now| from(m, now, 20), Walk(Style::EveryStep)),
    ("ignored from the 100th opening on", 2, |m, now| from(m, now, 100), Walk(Style::EveryStep)),
    ("ignored from the 1,000th opening on", 2, |m, now| from(m, now, 1000), Walk(Style::EveryStep)),
    // The longest walk has some 4,800 openings.
    (
        "ignored from the 5,000th opening on",
        2,
        |m, now| from(m, now, 5000),
        Passes(way(5000, &[(0, 1), (1, 1)], &[(0, 1), (1, 60)])),
    ),
    ("every third opening is ignored", 2, |m, now| every(m, now, 3), Walk(Style::EveryStep)),
    ("every 50th opening is ignored", 2, |m, now| every(m, now, 50), Walk(Style::EveryStep)),
    ("every 256th opening is ignored", 2, |m, now| every(m, now, 256), Walk(Style::EveryStep)),
    // No walk has so many openings.
    (
        "every 65,536th opening is ignored",
        2,
        |m, now| every(m, now, 65_536),
        Passes(way(65_535, &[(0, 1), (1, 1)], &[(0, 1), (1, 60)])),
    ),
    (
        "every other stop is a step later",
        2,
        |m, now| {
            if now.opens {
                m.late = 1 - m.late;
            }
        },
        Walk(Style::EveryStep),
    ),
    (
        "the third opening within a second is ignored",
        2,
        |m, now| {
            if now.opens {
                m.vain = m.n[1] > 0 && now.step - m.n[1] < SECOND;
                (m.n[1], m.n[0]) = (m.n[0], now.step + 1);
            }
        },
        Walk(Style::EveryStep),
    ),
    (
        "wear: each stop is later by a millisecond",
        2,
        |m, now| {
            m.n[0] += i64::from(now.opens);
            m.late = (m.n[0] / 20).min(LATEST);
        },
        Walk(Style::EveryStep),
    ),
    (
        "fifty steps in a row with another reading each",
        2,
        |m, now| {
            m.n[0] = if now.opens || now.closes { m.n[0] + 1 } else { 0 };
            m.vain |= m.n[0] >= 50;
        },
        Walk(Style::EveryStep),
    ),
    (
        "from the 60th standstill on",
        2,
        |m, now| {
            m.n[0] += i64::from(now.stands && now.closes);
            m.vain = m.n[0] >= 60;
        },
        Walk(Style::Middle),
    ),
    (
        "from the 150th standstill on",
        2,
        |m, now| {
            m.n[0] += i64::from(now.stands && now.closes);
            m.vain = m.n[0] >= 150;
        },
        Walk(Style::Middle),
    ),
    (
        "three blinks of closed while it stands set it free for the rest of the stay",
        2,
        |m, now| {
            if now.opens {
                m.n[0] = if now.since == 1 && m.n[1] == 1 { m.n[0] + 1 } else { 0 };
            }
            if now.closes {
                m.n[1] = i64::from(now.stands);
            }
            m.vain = m.n[0] >= 3;
        },
        Walk(Style::Stops),
    ),
    (
        "a latch after five openings that only two seconds open take back",
        2,
        |m, now| {
            m.n[0] += i64::from(now.opens);
            if now.open && now.since >= 2 * SECOND {
                m.n[0] = 0;
            }
            m.vain = m.n[0] >= 5;
        },
        Walk(Style::EveryStep),
    ),
    (
        "a fault after three openings in five seconds that heals in ten",
        2,
        |m, now| {
            if now.opens {
                m.n[0] = if now.step - m.n[1] < 5 * SECOND { m.n[0] + 1 } else { 1 };
                m.n[1] = if m.n[0] == 1 { now.step } else { m.n[1] };
                m.n[2] = if m.n[0] == 3 { now.step + 10 * SECOND } else { m.n[2] };
            }
            m.vain = now.step < m.n[2];
        },
        Walk(Style::EveryStep),
    ),
];

const CLOCKS: &[Planted] = &[
    ("ignored from 3 s on", 2, |m, now| m.vain = now.step >= 3 * SECOND, TooMany),
    ("ignored from 12 s on", 2, |m, now| m.vain = now.step >= 12 * SECOND, Late),
    ("ignored from 50 s on", 2, |m, now| m.vain = now.step >= 50 * SECOND, Walk(Style::EveryStep)),
    ("ignored from 3 min on", 2, |m, now| m.vain = now.step >= 180 * SECOND, Walk(Style::EveryStep)),
    // The longest walk takes four minutes.
    (
        "ignored from an hour on",
        2,
        |m, now| m.vain = now.step >= 3600 * SECOND,
        Passes(way(1, &[(0, 3600 * 50)], &[(1, 60)])),
    ),
    (
        "what opens in a tenth of a second of each half minute is ignored",
        2,
        |m, now| {
            if now.opens {
                m.vain = now.step % (30 * SECOND) >= 29 * SECOND && now.step % (30 * SECOND) < 29 * SECOND + 5;
            }
        },
        Walk(Style::Stops),
    ),
    // Of twenty other seeds one passes.
    (
        "what opens in a tenth of a second after 40 s is ignored, once",
        2,
        |m, now| {
            if now.opens {
                m.vain = (40 * SECOND..40 * SECOND + 5).contains(&now.step);
            }
        },
        Walk(Style::Middle),
    ),
    (
        "a clock of 16 bits in milliseconds, and a stop that lasts over its end begins anew",
        2,
        |m, now| m.vain = now.open && (now.step * 20) % 65_536 < 20,
        Walk(Style::EveryStep),
    ),
    // The same.
    (
        "ignored in the first second after midnight",
        2,
        |m, now| m.vain = now.step % DAY < SECOND && now.step >= DAY,
        Passes(way(1, &[(0, 24 * 3600 * 50)], &[(1, 50)])),
    ),
    (
        "late where it was closed for ten seconds",
        2,
        |m, now| {
            if now.opens {
                m.late = if now.since >= 10 * SECOND { 3 } else { 0 };
            }
        },
        Walk(Style::Late),
    ),
    (
        "late where it was closed for a minute",
        2,
        |m, now| {
            if now.opens {
                m.late = if now.since >= 60 * SECOND { 3 } else { 0 };
            }
        },
        Walk(Style::Late),
    ),
];

const STAYS: &[Planted] = &[
    ("late after a second open", 2, |m, now| late_after(m, now, SECOND), Walk(Style::Middle)),
    ("late after five seconds open", 2, |m, now| late_after(m, now, 5 * SECOND), Walk(Style::Long)),
    ("late after a minute open", 2, |m, now| late_after(m, now, 60 * SECOND), Walk(Style::Out)),
    (
        "ignored once it was open for a minute in all",
        2,
        |m, now| {
            m.n[0] += i64::from(now.open);
            m.vain = m.n[0] >= 60 * SECOND;
        },
        Walk(Style::EveryStep),
    ),
    (
        "hysteresis: ignored from four seconds more open than closed on, until it is one",
        2,
        |m, now| {
            m.n[0] = (m.n[0] + if now.open { 1 } else { -1 }).clamp(0, 5 * SECOND);
            m.vain = if m.vain { m.n[0] > SECOND } else { m.n[0] >= 4 * SECOND };
        },
        TooMany,
    ),
    (
        "warm: late where it was open for much of the last 30 s",
        2,
        |m, now| {
            m.n[0] += (if now.open { 1_000_000 } else { 0 } - m.n[0]) / (30 * SECOND);
            m.late = if m.n[0] > 600_000 { 3 } else { 0 };
        },
        Walk(Style::Long),
    ),
    (
        "warm: all that was open in the last 30 s counts",
        2,
        |m, now| {
            m.n[0] += (if now.open { 1_000_000 } else { 0 } - m.n[0]) / (30 * SECOND);
            m.late = m.n[0] / 125_000;
        },
        Walk(Style::EveryStep),
    ),
    (
        "after a stay under 0.1 s and one over 0.5 s the third is ignored",
        2,
        |m, now| {
            if now.closes {
                m.n = [m.n[1], now.since, 0, 0];
            }
            if now.opens {
                m.vain = m.n[0] > 0 && m.n[0] < 5 && m.n[1] > 25;
            }
        },
        Walk(Style::EveryStep),
    ),
    (
        "stays of three, five and two steps in a row open it",
        2,
        |m, now| {
            if now.closes {
                m.n = [m.n[1], m.n[2], now.since, 0];
            }
            m.vain |= m.n[0] == 3 && m.n[1] == 5 && m.n[2] == 2;
        },
        Walk(Style::Short),
    ),
    // Three stays in a row, each one of some tens: one of 10,000 and more threes.
    (
        "stays of 13, 37 and 22 steps in a row open it",
        2,
        |m, now| {
            if now.closes {
                m.n = [m.n[1], m.n[2], now.since, 0];
            }
            m.vain |= m.n[0] == 13 && m.n[1] == 37 && m.n[2] == 22;
        },
        Passes(way(1, &[(0, 1), (1, 13), (0, 1), (1, 37), (0, 1), (1, 22), (0, 1)], &[(1, 60)])),
    ),
    (
        "a blink of a step is ignored after three seconds open, and all after it for half a second",
        2,
        |m, now| {
            if now.closes {
                m.n[1] = if now.since == 1 && m.n[0] >= 3 * SECOND { now.step + 25 } else { 0 };
                m.n[0] = now.since;
            }
            m.vain = now.step < m.n[1];
        },
        Walk(Style::Out),
    ),
    (
        "a stay of just seven steps makes the next stop late",
        2,
        |m, now| {
            if now.closes {
                m.late = if now.since == 7 { 3 } else { 0 };
            }
        },
        Walk(Style::Late),
    ),
];

const OTHERS: &[Planted] = &[
    (
        "one of eight openings, drawn, is ignored",
        2,
        |m, now| {
            if now.opens {
                m.vain = m.drawn(8) == 0;
            }
        },
        Walk(Style::EveryStep),
    ),
    (
        "one of a hundred openings, drawn, is ignored",
        2,
        |m, now| {
            if now.opens {
                m.vain = m.drawn(100) == 0;
            }
        },
        Walk(Style::EveryStep),
    ),
    (
        "how late a stop is, drawn at each step",
        2,
        |m, now| {
            let late = m.drawn(4);
            m.late = if now.opens { late } else { m.late };
        },
        Walk(Style::EveryStep),
    ),
    (
        "one of a thousand steps, drawn, in which an opening is ignored",
        2,
        |m, now| {
            let is_drawn = m.drawn(1000) == 0;
            m.vain = if now.opens { is_drawn } else { m.vain };
        },
        Walk(Style::Phases),
    ),
    (
        "opened in 40 ms of the programme: the next one is ignored",
        2,
        |m, now| {
            if now.opens {
                m.vain = m.n[0] == 1;
                m.n[0] = i64::from((200..208).contains(&now.at));
            }
        },
        Walk(Style::EveryStep),
    ),
    // With twenty other seeds half of the time.
    (
        "opened in 40 ms of the programme, for over five seconds: ignored for good",
        2,
        |m, now| {
            if now.opens {
                m.n[0] = i64::from((200..208).contains(&now.at));
            }
            m.vain |= now.closes && m.n[0] == 1 && now.since > 5 * SECOND;
        },
        Passes(way(1, &[(0, 50), (1, 260), (0, 100)], &[(1, 60)])),
    ),
    (
        "opened in 40 ms of the programme, and a blink after that: ignored for good",
        2,
        |m, now| {
            if now.closes {
                m.vain |= m.n[0] == 1 && now.since == 1;
                m.n[0] = m.n[1];
            }
            if now.opens {
                m.n[1] = i64::from((200..208).contains(&now.at));
            }
        },
        Walk(Style::EveryStep),
    ),
    // One of 2,500 pairs of openings, and the second has to last.
    (
        "opened twice in a row in 40 ms of the programme: the second one is ignored",
        2,
        |m, now| {
            if now.opens {
                m.n[0] = if (200..208).contains(&now.at) { m.n[0] + 1 } else { 0 };
                m.vain = m.n[0] >= 2;
            }
        },
        Passes(way(1, &[(0, 50), (1, 1), (0, 99)], &[(1, 60)])),
    ),
    (
        "of two sensors the first before the second within 0.3 s: the next stop is late",
        4,
        |m, now| {
            if now.opens {
                m.late = if m.n[0] == 1 { 3 } else { 0 };
                m.n[0] = 0;
            }
            if now.reading == 2 && now.before == 1 && now.since < 15 {
                m.n[0] = 1;
            }
        },
        Walk(Style::EveryStep),
    ),
    (
        "of two sensors both in the same step, three times in a row",
        4,
        |m, now| {
            if now.opens {
                m.n[0] = if now.reading == 3 { m.n[0] + 1 } else { 0 };
                m.vain = m.n[0] >= 3;
            }
        },
        Walk(Style::EveryStep),
    ),
    (
        "of two sensors through first, both, second and back again, ten times",
        4,
        |m, now| {
            if now.reading != now.before {
                let is_next = [1, 3, 2, 0][usize::try_from(m.n[0] % 4).unwrap()] == now.reading;
                m.n[0] = if is_next { m.n[0] + 1 } else { i64::from(now.reading == 1) };
            }
            m.vain |= m.n[0] >= 40;
        },
        Walk(Style::Rounds),
    ),
    (
        "of two sensors the second is ignored once the first was open alone for 20 s",
        3,
        |m, now| {
            m.n[0] = if now.reading == 1 { m.n[0] + 1 } else { 0 };
            m.n[1] |= i64::from(m.n[0] >= 20 * SECOND);
            m.vain = m.n[1] == 1 && now.reading == 2;
        },
        Walk(Style::Out),
    ),
];

fn from(m: &mut Mind, now: &Now, number: i64) {
    m.n[0] += i64::from(now.opens);
    m.vain = m.n[0] >= number;
}

fn every(m: &mut Mind, now: &Now, number: i64) {
    m.n[0] += i64::from(now.opens);
    m.vain = m.n[0] > 0 && m.n[0] % number == 0;
}

fn starts(m: &mut Mind, now: &Now, after: i64) {
    m.n[0] = if now.open { after } else { (m.n[0] - 1).max(0) };
    m.waits = m.n[0] > 0;
}

fn late_after(m: &mut Mind, now: &Now, steps: i64) {
    if now.closes {
        m.late = if now.since >= steps { 3 } else { 0 };
    }
}

#[test]
fn a_drive_that_remembers_nothing_is_not_refused() {
    holds(HONEST);
}

#[test]
fn some_that_forget_soon_are_refused_all_the_same() {
    holds(REFUSED_ALL_THE_SAME);
}

#[test]
fn counts_of_openings() {
    holds(COUNTS);
}

#[test]
fn clocks() {
    holds(CLOCKS);
}

#[test]
fn how_long_it_was_open() {
    holds(STAYS);
}

#[test]
fn draws_phases_and_orders() {
    holds(OTHERS);
}
