//! What a search from a start knows of everything that its answer needs.

mod fields;
mod keys;

use self::fields::Fields;
use super::accepted_for::fmu_digest;
use super::execution::{Doubt, not_repeatable};
use super::options::{Exhaustive, Method, ScanOptions};
use super::prepare::Prepared;
use super::searched::Searched;
use crate::cell::workcell::Robot;
use crate::obligations::{Assumption, Engine, Need, Point, Reply};
use crate::record::figures::grouped;
use crate::scan::speeds::Speeds;
use crate::sim::coverage::{NoContactReason, RobotCoverage};

/// A search that has ended.
pub(super) struct FromStart<'a> {
    prepared: &'a Prepared,
    searched: &'a Searched,
    speeds: &'a Speeds,
    /// Whether there are hazards.
    found: bool,
    fields: Fields,
    /// Why the FMU is not to be relied on.
    doubts: Vec<String>,
    /// The strategy that chose its sequences, if it was not to look at all of them.
    samples: bool,
    /// What follows the FMU would have done otherwise in runs with an arm.
    strayed: bool,
}

impl<'a> FromStart<'a> {
    pub(super) fn new(
        prepared: &'a Prepared,
        options: ScanOptions,
        searched: &'a Searched,
        doubt: Option<&Doubt>,
        (speeds, found): (&'a Speeds, bool),
    ) -> Self {
        let doubted = doubt.map(|doubt| match searched.interrupted {
            true => format!("{}: it was stopped before that was looked into", doubt.words()),
            false => not_repeatable(doubt),
        });
        let doubts = doubted.into_iter().chain(prepared.unsteady()).collect();
        Self {
            prepared,
            searched,
            speeds,
            found,
            fields: Fields::of(&prepared.cell),
            doubts,
            samples: is_by_samples(options),
            strayed: false,
        }
    }

    /// What follows the FMU would have done otherwise in runs with an arm, and nothing else is unfinished.
    pub(super) fn having_strayed(self) -> Self {
        Self { strayed: true, ..self }
    }

    /// What of all sequences was looked at.
    fn looked_at(&self) -> Reply {
        let mut open = self.gaps(Need::Searched);
        if self.searched.coverage.contact_checks == 0 {
            open.push(Point::open("no action could be evaluated"));
        }
        let Some(certificate) = &self.searched.certificate else {
            let iterations = grouped(&self.searched.iterations.to_string());
            open.push(match self.samples {
                true => Point::open_until(
                    format!("{iterations} sequences were tried, which shows nothing of the others"),
                    "Leave --strategy out to look at all",
                ),
                false => {
                    Point::open(format!("{iterations} sequences were tried, and the search of all of them did not end"))
                }
            });
            return Reply::Points(open);
        };
        let sequences = grouped(&certificate.sequences);
        Reply::unless(open, format!("all {sequences} sequences of {} actions", certificate.horizon))
    }

    /// What the search left open of this.
    fn gaps(&self, need: Need) -> Vec<Point> {
        let mine = self.searched.gaps.iter().filter(|(of, _)| *of == need);
        mine.map(|(_, point)| point.clone()).collect()
    }

    fn finished(&self) -> Reply {
        let mut open = self.gaps(Need::Finished);
        if let Some(error) = &self.searched.broken {
            open.push(Point::open(format!("the FMU failed: {}", error.message)));
        }
        if open.is_empty() && !self.strayed && self.searched.coverage.not_evaluated() {
            open.push(Point::open("the FMU could not finish some actions: what follows from them is not known"));
        }
        Reply::unless(open, format!("{} steps", grouped(&self.searched.fmu_steps.to_string())))
    }

    fn arm_searches(&self) -> Reply {
        let coverage = &self.searched.coverage;
        let open = (coverage.arm_checks_incomplete > 0).then(|| {
            Point::open(format!(
                "{} arm searches stopped at their work limit: an arm contact may be missed there",
                coverage.arm_checks_incomplete
            ))
        });
        Reply::unless(open.into_iter().collect(), format!("{} of them", grouped(&coverage.arm_checks.to_string())))
    }

    fn repeatable(&self) -> Reply {
        let mut open: Vec<Point> = self.doubts.iter().map(Point::open).collect();
        open.extend(self.gaps(Need::Repeatable));
        let again = self.searched.certificate.as_ref().map(|certificate| &certificate.run_again);
        let figure = again.map_or_else(
            || "its self-test gave the same outputs".to_owned(),
            |again| {
                let [compared, of] = [again.compared, again.transitions].map(|n| grouped(&n.to_string()));
                format!("{compared} of {of} actions run again from the start gave the same outputs")
            },
        );
        Reply::unless(open, figure)
    }

    fn hands_through_planes(&self) -> Reply {
        let Fields { room_for_legs, behind_planes, coarse, above, .. } = &self.fields;
        let mut open = Vec::new();
        if !room_for_legs.is_empty() {
            open.push(Point::open(format!(
                "who is low may have a hand below {} before the body is in it: hands are looked at as if they came through",
                room_for_legs.join(", ")
            )));
        }
        if !behind_planes.is_empty() {
            open.push(Point::open(format!(
                "a hand may get to {} through more than one light curtain, door or line of buttons: one of these ways was looked at",
                behind_planes.join(", ")
            )));
        }
        if !coarse.is_empty() {
            open.push(Point::open(format!(
                "{} may let a hand through by its resolution or beams: it was looked at as if it saw every hand",
                coarse.join(", ")
            )));
        }
        if !above.is_empty() {
            open.push(Point::open(format!(
                "who is low may be below {}: it was looked at as if it saw everybody in it",
                above.join(", ")
            )));
        }
        if open.is_empty() && !self.fields.planes {
            return Reply::NotAsked("there are no light curtains, doors and two-hand controls");
        }
        Reply::unless(open, "each on its way")
    }

    fn travel(&self) -> Reply {
        let Some(signal) = &self.fields.travel else { return Reply::NotAsked("it is stated, or does not count") };
        let tried = format!("tried out by `{signal}` at moments 0.1 s apart, with nobody there");
        let cell = &self.prepared.cell;
        let fmu = fmu_digest(&self.prepared.subject);
        Reply::Points(vec![Point::tried(&Assumption::TravelAfterContact, tried, &cell.accepted, &fmu)])
    }

    /// What is known of each robot, where that is not `open` of it.
    fn of_robots(&self, open: impl Fn(NoContactReason) -> bool, figure: impl Fn(&RobotCoverage) -> String) -> Reply {
        let coverage = &self.searched.coverage;
        let several = self.prepared.cell.robots.len() > 1;
        let of = |(number, robot): (usize, &Robot)| {
            let never = coverage.no_contact_reason(number);
            let figures = coverage.robots.get(number).map_or_else(|| "nothing".to_owned(), &figure);
            let point = match never {
                Some(never) if open(never) => Point::open(never.words(&robot.name)),
                Some(never) => Point::shown(never.words(&robot.name)),
                None => Point::shown(figures),
            };
            if several { point.of(robot.name.clone()) } else { point }
        };
        Reply::Points(self.prepared.cell.robots.iter().enumerate().map(of).collect())
    }

    fn moves(&self) -> Reply {
        let open = |never: NoContactReason| matches!(never, NoContactReason::NeverMoved { .. }) && !never.is_shown();
        self.of_robots(open, |robot| format!("up to {:.2} m/s", robot.top_speed_m_s))
    }

    fn near(&self) -> Reply {
        let open = |never: NoContactReason| match never {
            NoContactReason::NotSimulated
            | NoContactReason::TooFar
            | NoContactReason::NeverNear
            | NoContactReason::KeptOut => !never.is_shown(),
            // That is told as such.
            NoContactReason::NeverMoved { .. } => false,
        };
        let times = |robot: &RobotCoverage| grouped(&robot.instants_in_reach.to_string());
        self.of_robots(open, |robot| format!("near enough to touch at {} instants", times(robot)))
    }

    fn reported(&self) -> Reply {
        if !self.fields.sensors {
            return Reply::NotAsked("there are no sensors");
        }
        let actions = &self.searched.coverage.sensor_actions;
        let never = actions.iter().all(|&n| n == 0);
        // Where somebody is hit, it is known that there is something to see.
        let open = (never && !self.found).then(|| Point::open("no sensor ever reported the person"));
        let most = grouped(&actions.iter().sum::<u64>().to_string());
        Reply::unless(open.into_iter().collect(), format!("in {most} actions"))
    }
}

impl Engine for FromStart<'_> {
    fn reply(&self, need: Need) -> Reply {
        match need {
            Need::Searched => self.looked_at(),
            Need::Finished => self.finished(),
            Need::ArmSearches => self.arm_searches(),
            Need::BetweenSteps => {
                Reply::NotAsked("contacts are looked at every communication step, as the result says")
            }
            Need::Confirmed => Reply::unless(self.gaps(need), "all that was met"),
            Need::Repeatable => self.repeatable(),
            Need::Steps => self.prepared.steps(),
            Need::Speeds => {
                Reply::unless(self.speeds.refusal().map(Point::open).into_iter().collect(), "at every step")
            }
            Need::Moves => self.moves(),
            Need::Near => self.near(),
            Need::Reported => self.reported(),
            Need::Changes => Reply::NotAsked("every sequence has its own"),
            Need::Presses => Reply::NotAsked("every sequence has its own"),
            Need::HandsOfControls => Reply::NotAsked("every sequence has its own"),
            Need::Doors => Reply::NotAsked("every sequence has its own"),
            Need::Abilities => Reply::NotAsked("every sequence has its own"),
            Need::HandsThroughPlanes => self.hands_through_planes(),
            Need::Following => match self.fields.follows {
                true => self.following(),
                false => Reply::NotAsked("nothing follows the FMU"),
            },
            Need::Approach => Reply::NotAsked("every contact is judged by its own speed"),
            Need::Criteria => Reply::NotAsked("every contact is judged by all of them"),
            Need::Pressure => self.pressure(),
            Need::Travel => self.travel(),
            Need::PeopleAlike => Reply::NotAsked("every person is looked at"),
            Need::Heeds => Reply::NotAsked("all robots are looked at together"),
            Need::ReportsLater => Reply::NotAsked("the FMU is asked in every sequence"),
            Need::ReportsWhileWorked => Reply::NotAsked("the FMU is asked in every sequence"),
        }
    }
}

impl FromStart<'_> {
    fn following(&self) -> Reply {
        let mut open = self.gaps(Need::Following);
        if self.strayed && open.is_empty() {
            open.push(Point::open(
                "something that follows the FMU would do so otherwise in runs in which a plane tells of an arm: what the arm \
                 meets there was not looked at",
            ));
        }
        Reply::unless(open, "as the FMU had it in every run")
    }

    fn pressure(&self) -> Reply {
        let links = &self.fields.pressure;
        if links.is_empty() {
            return Reply::NotAsked("it does not count, or is known of all links");
        }
        let (says, it) = if links.len() == 1 { ("does not say", "it") } else { ("do not say", "them") };
        Reply::Points(vec![Point::open(format!(
            "{} {says} how small the surface is that touches (contact in the cell file), so no pressure by {it} is excluded",
            links.join(", ")
        ))])
    }
}

/// Whether sequences are samples by these options, each of which says what it does to the answer.
fn is_by_samples(options: ScanOptions) -> bool {
    let ScanOptions {
        method,
        // Of samples.
        seed: _,
        iterations: _,
        posture_sweep: _,
        // Ends with a hazard.
        stop_at_first: _,
        // The result is the same.
        state: _,
    } = options;
    match method {
        Method::Strategy(_) => true,
        // What its budget leaves out is told by the search; threads and the way to merge do not change the result.
        Method::Exhaustive(Exhaustive { budget: _, merge: _, workers: _ })
        | Method::Auto(_, Exhaustive { budget: _, merge: _, workers: _ }) => false,
    }
}
