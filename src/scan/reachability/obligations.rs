//! What a scan from anywhere knows of everything that its answer needs.

use super::super::accepted_for::fmu_digest;
use super::AnalysisContext;
use super::fields::{Fields, options};
use crate::obligations::{Assumption, Engine, Need, Point, Reply};
use crate::record::figures::grouped;
use crate::scan::speeds::Speeds;

/// A search that has ended.
pub(super) struct FromAnywhere<'a> {
    looking: &'a AnalysisContext<'a>,
    speeds: Option<&'a Speeds>,
}

impl<'a> FromAnywhere<'a> {
    pub(super) fn new(looking: &'a AnalysisContext<'a>, speeds: Option<&'a Speeds>) -> Self {
        options(&looking.effort);
        Self { looking, speeds }
    }

    /// What the search said of this on its way, and how far it came otherwise.
    fn said(&self, need: Need, figure: impl Into<String>) -> Reply {
        Reply::unless(self.points(need), figure)
    }

    fn points(&self, need: Need) -> Vec<Point> {
        let mine = self.looking.said.iter().filter(|(of, _)| *of == need);
        mine.map(|(_, point)| point.clone()).collect()
    }

    fn searched(&self) -> Reply {
        let found = &self.looking.found;
        let mut open = self.points(Need::Searched);
        if let Some(share) = self.looking.effort.answers.share() {
            open.push(Point::open(format!(
                "this is part {share} of a search: what is not found here may be in another part"
            )));
        }
        if found.open > 0 {
            let are = if found.open == 1 {
                "1 cell of the floor is".to_owned()
            } else {
                format!("{} cells of the floor are", found.open)
            };
            open.push(Point::open(format!("{are} open: whether anybody is hit there is not known")));
        }
        if open.is_empty() && found.histories.is_empty() {
            open.push(Point::open("no robot moved that could harm anybody, or no sensor leaves anybody unseen"));
        }
        let instants: usize = found.histories.iter().map(|history| history.instants).sum();
        let figure = format!(
            "{} sets of poses at {} instants of {} histories of what the sensors report",
            grouped(&found.spent.boxes.to_string()),
            grouped(&instants.to_string()),
            found.histories.len()
        );
        Reply::unless(open, figure)
    }

    fn between(&self) -> Reply {
        let between = self.looking.found.between;
        let open = (between > 0).then(|| {
            Point::open(format!(
                "in {between} {} of the floor somebody may be hit between two communication steps, and at none: the robots are as \
                 much nearer then as they may move in half a step{}",
                if between == 1 { "cell" } else { "cells" },
                if self.looking.nearly { ", and as what only nearly stands for all that the FMU may do is off" } else { "" }
            ))
        });
        Reply::unless(
            open.into_iter().collect(),
            "robots are as much nearer between them as they may move in half a step",
        )
    }

    fn confirmed(&self) -> Reply {
        let unconfirmed = self.looking.found.hazards.iter().filter(|place| !place.confirmed).count();
        let open = (unconfirmed > 0).then(|| {
            Point::open(format!(
                "of {unconfirmed} {}, no walk was found that shows {} and begins where people get to unseen",
                if unconfirmed == 1 { "way to be hit" } else { "ways to be hit" },
                if unconfirmed == 1 { "it" } else { "them" }
            ))
        });
        Reply::unless(open.into_iter().collect(), "all that was met")
    }

    fn arm_searches(&self) -> Reply {
        let coverage = &self.looking.rest.coverage;
        let open = (coverage.arm_checks_incomplete > 0).then(|| {
            Point::open(format!("{} arm searches stopped at their work limit", coverage.arm_checks_incomplete))
        });
        Reply::unless(open.into_iter().collect(), format!("{} of them", grouped(&coverage.arm_checks.to_string())))
    }

    fn repeatable(&self) -> Reply {
        let mut open = self.points(Need::Repeatable);
        open.extend(self.looking.prepared.unsteady().map(Point::open));
        let again = grouped(&self.looking.found.spent.run_again.to_string());
        Reply::unless(open, format!("{again} steps run again from the start gave the same outputs"))
    }

    fn changes(&self) -> Reply {
        let open = self.looking.found.changes.map(|changes| {
            let times = if changes == 1 { "once".to_owned() } else { format!("{changes} times") };
            let few = self.looking.not_few.as_ref().map(|why| {
                format!(". Nor is there a number of behaviours that stand for all that the FMU may do: {why}")
            });
            Point::open_until(
                format!(
                    "what the sensors report was followed while it changes at most {times}: whoever comes and goes more often was not \
                     looked at{}",
                    few.unwrap_or_default()
                ),
                "Raise --max-states, or ask for less with --until. A stop that does not restart by itself needs neither",
            )
        });
        let mut all = self.points(Need::Changes);
        all.extend(open);
        Reply::unless(all, "until nothing changes any more what the robots do")
    }

    fn presses(&self) -> Reply {
        let Some(presses) = self.looking.found.presses else { return Reply::NotAsked("no control is worked") };
        if presses == 0 {
            return Reply::Points(vec![Point::open_until("no control was worked", "Say with --presses how often")]);
        }
        let tried = match presses {
            1 => "with one press at any moment".to_owned(),
            more => format!("with {more} presses at any moments"),
        };
        let prepared = self.looking.prepared;
        let (accepted, fmu) = (&prepared.cell.accepted, fmu_digest(&prepared.subject));
        Reply::Points(vec![Point::tried(&Assumption::Presses { at_most: presses }, tried, accepted, &fmu)])
    }

    fn if_asked(asked: bool, none: &'static str, why: &str) -> Reply {
        if asked { Reply::Points(vec![Point::open(why)]) } else { Reply::NotAsked(none) }
    }

    fn hands(&self) -> Reply {
        let coarse = &self.looking.fields.coarse;
        let open = (!coarse.is_empty()).then(|| {
            Point::open(format!(
                "{} may let a hand through by its resolution or beams: it was looked at as if it saw every hand",
                coarse.join(", ")
            ))
        });
        if !self.looking.fields.planes {
            return Reply::NotAsked("there are no light curtains, doors and two-hand controls");
        }
        Reply::unless(open.into_iter().collect(), "each on its way")
    }

    fn abilities(&self) -> Reply {
        let also = &self.looking.fields.also;
        if also.is_empty() {
            return Reply::NotAsked("people walk, bend and reach");
        }
        let no = also.join(", no ");
        Reply::Points(vec![Point::open(format!("from anywhere people walk, bend and reach only: no {no}"))])
    }
}

impl Engine for FromAnywhere<'_> {
    fn reply(&self, need: Need) -> Reply {
        let &Fields { worked, two_hand, doors, pose, reported, by_approach, by_others, .. } = &self.looking.fields;
        match need {
            Need::Searched => self.searched(),
            Need::Finished => {
                self.said(need, format!("{} steps", grouped(&self.looking.found.spent.fmu_steps.to_string())))
            }
            Need::ArmSearches => self.arm_searches(),
            Need::BetweenSteps => self.between(),
            Need::Confirmed => self.confirmed(),
            Need::Repeatable => self.repeatable(),
            Need::Steps => self.looking.prepared.steps(),
            Need::Speeds => {
                let refusal = self.speeds.and_then(Speeds::refusal);
                Reply::unless(refusal.map(Point::open).into_iter().collect(), "at every step")
            }
            Need::Moves => Reply::NotAsked("told with what was looked at"),
            Need::Near => Reply::NotAsked("told with what was looked at"),
            Need::Reported => Reply::NotAsked("people come from where no sensor sees them"),
            Need::Changes => self.changes(),
            Need::Presses => self.presses(),
            Need::HandsOfControls => Self::if_asked(
                worked && two_hand,
                "there is no two-hand control beside another control",
                "who works a control may let go of a two-hand control for that: from anywhere that is not looked at",
            ),
            Need::Doors => Self::if_asked(
                doors,
                "no control opens a door",
                "from anywhere all doors are taken to be open: what a closed one does, was not looked at",
            ),
            Need::Abilities => self.abilities(),
            Need::HandsThroughPlanes => self.hands(),
            Need::Following => Reply::NotAsked("nothing follows the FMU"),
            Need::Approach => Self::if_asked(
                by_approach,
                "the robot's own speed decides",
                "with the speed of approach as criterion, who walks comes to the robot faster than looked at: only people who stand are",
            ),
            Need::Criteria => Self::if_asked(
                by_others,
                "the transient force alone counts",
                "from anywhere the transient force alone is looked at: by the other criteria of the cell file nothing is excluded",
            ),
            Need::Pressure => Reply::NotAsked("told with the criteria"),
            Need::Travel => Reply::NotAsked("told with the criteria"),
            Need::PeopleAlike => self.of_the_fmu(pose, need),
            Need::Heeds => match self.points(need) {
                points if points.is_empty() => Reply::NotAsked("all robots are looked at with all sensors"),
                points => Reply::Points(points),
            },
            Need::ReportsLater => self.of_the_fmu(pose && reported, need),
            Need::ReportsWhileWorked => Self::if_asked(
                worked && pose && self.looking.found.presses != Some(0),
                "no control is worked, or no sensor is inside the FMU",
                "sensors inside the FMU may report something else while a control is worked: that was not asked",
            ),
        }
    }
}

impl FromAnywhere<'_> {
    /// Of sensors inside the FMU. Where the search ended before it asked, that is told with what was looked at.
    fn of_the_fmu(&self, pose: bool, need: Need) -> Reply {
        match self.points(need) {
            _ if !pose => Reply::NotAsked("no sensor is inside the FMU"),
            points if points.is_empty() => Reply::Points(vec![Point::open("this was not tried out")]),
            points => Reply::Points(points),
        }
    }
}
