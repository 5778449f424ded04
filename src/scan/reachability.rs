//! Anybody whom no sensor sees at first, anywhere, walking in any way: the FMU is stepped along all histories of what sensors
//! then report, sets of poses are searched for harm, and what is found is shown by a run of its own from a place outside.

mod approximate_behaviours;
mod behaviours;
mod control_walks;
mod demonstrate;
mod early_walks;
mod end;
mod fields;
mod guided_walks;
mod internal_sensors_later;
mod keys;
pub(super) mod map;
mod obligations;
mod preparation;
mod random_walks;
mod record;
mod robot_groups;
mod sensor_dependence;
mod trial_instants;
mod trials;
mod walk_in;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;

use self::behaviours::{Few, Refused};
use self::demonstrate::sensors;
use self::end::{End, not_looked_at};
use self::fields::Fields;
use self::map::Walkable;
use self::obligations::FromAnywhere;
use self::record::Rest;
use self::trials::Kind;
use super::execution::{Doubt, ExecutionMode};
use super::hosting::StateChoice;
use super::options::ScanError;
use super::prepare::Prepared;
use crate::host::audit::{Scope, audit};
use crate::host::{Hosted, PlantError, Recall};
use crate::human::{Floor, Start};
use crate::obligations::verdict::SearchEnd;
use crate::obligations::{Need, Obligations, Point, Verdict};
use crate::reachability::instants::RobotGroup;
use crate::reachability::internal_sensors::sensor_target;
use crate::reachability::machine::Machine;
use crate::reachability::reading_regions::{ReadingRegions, Readings};
use crate::reachability::{
    BODY_TOLERANCE_M, CELL_M, FLOOR_M, Histories, History, MayReport, Means, Moment, ReachabilitySearch as Search,
    told_in,
};
use crate::record::model::SCHEMA_VERSION;
use crate::record::reachability::{Ground, HarmfulPose, HistoryRecord, ReachabilityResult, Spent};
use crate::scan::speeds::Speeds;
use crate::search::tracks::explore;
use crate::sequences::Merge;
use crate::sim::answers::Answers;
use crate::sim::between::STEP_TOLERANCE_M;
use crate::sim::motion::Motion;
use crate::sim::robot::RobotFrame;
use crate::sim::sensors::SensorTarget as Person;
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// So long somebody stays at most of whom the FMU is asked what its sensors report, s: they may tell late.
const LONGEST_TOLD_S: f64 = 0.3;
/// So much floor around what robots reach is looked at, m, where sensors inside the FMU may see people beyond it: they come over its
/// edge, seen just then or long before.
const AROUND_M: f64 = 2.0;
/// So many states of the FMU are looked at before behaviours are.
const FEW_STATES: usize = 60_000;
/// Of what is tried out at random.
const SEED: u64 = 1;

/// What is told while it searches.
#[derive(Clone, Copy, Debug)]
pub enum AnalysisEvent {
    /// States of the FMU so far, of so many at most.
    States(usize, usize),
    /// Behaviours of the FMU so far, of so many at most.
    Behaviours(usize, usize),
    /// The share of the floor of which the FMU was asked what its sensors report there.
    Asked(f64),
    /// Runs of the audit, of so many.
    RunAgain(usize, usize),
    /// The share of the floor that is done, and hazards so far.
    Floor(f64, usize),
}

/// Tells it; what it answers may end the search.
pub type EventSink<'a> = dyn FnMut(AnalysisEvent) -> ControlFlow<()> + 'a;

/// Why nobody can be looked for anywhere in a cell.
#[must_use]
pub fn refusal(prepared: &Prepared) -> Option<String> {
    Fields::of(&prepared.cell, &prepared.binding).refusal
}

/// Said of a floor that is looked at in larger cells than others, because it is so large.
fn coarse(floor: &Floor) -> Option<String> {
    let (low_m, high_m) = floor.bounds();
    let size_m = [0, 1].map(|axis| high_m[axis] - low_m[axis]);
    let is_coarse = floor.cell_m() > FLOOR_M + 1e-9;
    is_coarse.then(|| {
        format!(
            "all that the cell file describes takes {:.0} m by {:.0} m of floor, so it is looked at in cells of {:.0} mm instead of {:.0} mm: \
             people may count as getting through gaps that are a little too narrow for them. Leave out what is far from the robots",
            size_m[0],
            size_m[1],
            1000.0 * floor.cell_m(),
            1000.0 * FLOOR_M
        )
    })
}

/// Sensors that report whoever is *not* at them.
fn two_hand(prepared: &Prepared) -> Vec<usize> {
    let sensors = prepared.cell.sensors.iter().enumerate();
    sensors.filter(|(_, sensor)| sensor.zone.is_post()).map(|(n, _)| n).collect()
}

/// Everything that sensors may report of somebody who is seen by none: hands on the buttons of two-hand controls, or not.
fn unseen(prepared: &Prepared) -> Vec<Vec<bool>> {
    let controls = two_hand(prepared);
    (0..1_usize << controls.len())
        .map(|bits| {
            let mut readings = vec![false; prepared.cell.sensors.len()];
            // Nobody at any of them comes first.
            controls.iter().enumerate().for_each(|(n, sensor)| readings[*sensor] = bits >> n & 1 == 0);
            readings
        })
        .collect()
}

/// When a search ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// So many seconds after the start of the FMU.
    Seconds(f64),
    /// After so many cycles of the robots while nobody comes, and what they do before these.
    Cycles(u32),
}

/// How far and how hard is looked.
#[derive(Clone, Copy, Debug)]
pub struct AnalysisLimits<'a> {
    /// How long after the start of the FMU.
    pub until: Until,
    /// Threads.
    pub workers: usize,
    /// Most states of the FMU.
    pub most_states: usize,
    /// Most presses of controls.
    pub presses: u32,
    /// How the FMU's states are brought back.
    pub state: StateChoice,
    /// What is known from before, and what is kept for later.
    pub answers: &'a Answers,
}

/// What is being put together.
struct AnalysisContext<'a> {
    prepared: &'a Prepared,
    effort: AnalysisLimits<'a>,
    links: Vec<String>,
    found: ReachabilityResult,
    rest: Rest,
    /// What the cell asks.
    fields: Fields,
    /// What was said on the way of what an answer needs.
    said: Vec<(Need, Point)>,
    /// Floor on which people can be.
    walkable: Walkable,
    /// Cells of the floor, as they are told, in which something is open, and in which it is between two instants.
    open: BTreeSet<[i64; 2]>,
    between: BTreeSet<[i64; 2]>,
    /// How far it got.
    end: End,
    /// What was seen of the robots' motion and the speeds that are told of it.
    motion: Option<Motion>,
    /// What poses alone make possible, where somebody can be then, and whether they are unseen.
    met: Vec<(Moment, bool)>,
    /// Whether something stood for histories that is not just the same.
    nearly: bool,
    /// Whether behaviours stood for histories, of all robots, for all time.
    any_time: bool,
    /// Why behaviours did not stand for histories, where they were looked for.
    not_few: Option<String>,
    /// Walks at random that were run, to harms of each region by each link.
    sought: BTreeMap<(u8, usize), usize>,
}

/// The history of a way with steps in so many parts, of robots that are where it says; none where that is not known, or too much.
type TransitionInFractions<'a> = &'a dyn Fn(usize, usize, &dyn Fn(&RobotFrame) -> bool) -> Option<History>;

/// Places and robots that harm is looked for in.
struct Sets<'a> {
    zones: &'a ReadingRegions,
    /// By way: at the instants, and with what is between them.
    histories: &'a [(History, History)],
    /// One of them with steps in so many parts.
    in_parts: TransitionInFractions<'a>,
}

impl<'a> Sets<'a> {
    /// Of behaviours in place of histories.
    fn few(few: &'a Few) -> Self {
        Self { zones: &few.zones, histories: &few.histories, in_parts: &|_, _, _| None }
    }
}

/// What came out.
pub struct AnalysisResult {
    /// Where somebody is hit, and what is not known.
    pub found: ReachabilityResult,
    rest: Rest,
    stopped: bool,
}

impl AnalysisResult {
    /// Whether there is more to look at.
    #[must_use]
    pub fn was_cut_short(&self) -> bool {
        self.stopped
    }
}

/// Looks everywhere.
///
/// # Errors
/// When the FMU cannot be started or fails on its way there.
pub fn analyse(
    prepared: &Prepared,
    effort: AnalysisLimits<'_>,
    tell: &mut EventSink<'_>,
) -> Result<AnalysisResult, ScanError> {
    let cell = &prepared.cell;
    let fields = Fields::of(cell, &prepared.binding);
    let found = ReachabilityResult {
        schema_version: SCHEMA_VERSION,
        tool: format!("fmi-hazard {}", env!("CARGO_PKG_VERSION")),
        // Until it is known what the answer rests on.
        verdict: Verdict::Inconclusive,
        subject: prepared.subject.clone(),
        until_s: 0.0,
        any_time: false,
        cycle_s: None,
        speed_criterion: cell.criteria.speed(),
        cell_m: 2.0 * CELL_M,
        body_tolerance_m: BODY_TOLERANCE_M,
        arm_tolerance_m: 2.0 * cell.arm().hand_tolerance_m(cell.search.reach_tolerance_m),
        step_tolerance_m: STEP_TOLERANCE_M,
        presses: fields.worked.then_some(effort.presses),
        changes: None,
        histories: Vec::new(),
        hazards: Vec::new(),
        span_s: 0.0,
        floor: Vec::new(),
        followed: true,
        ground: Ground::default(),
        open: 0,
        open_m: Vec::new(),
        not_looked_at: 0,
        not_looked_at_m: Vec::new(),
        between: 0,
        between_m: Vec::new(),
        reasons: Vec::new(),
        obligations: Obligations::default(),
        warnings: prepared.warnings(),
        spent: Spent::default(),
    };
    let mut looking = AnalysisContext {
        prepared,
        effort,
        links: cell.links.iter().map(|link| link.name.clone()).collect(),
        found,
        rest: Rest::new(cell.sensors.len()),
        fields,
        said: Vec::new(),
        walkable: Walkable::default(),
        open: BTreeSet::new(),
        between: BTreeSet::new(),
        end: End::Whole,
        motion: None,
        met: Vec::new(),
        nearly: false,
        any_time: true,
        not_few: None,
        sought: BTreeMap::new(),
    };
    let kinds = unseen(prepared);
    match looking.horizon(&kinds[0]) {
        Ok(Some(until_s)) => {
            (looking.found.until_s, looking.found.span_s) = (until_s, map::span_s(until_s, cell.step_s));
        }
        Ok(None) => {
            looking.end = End::Short;
            return Ok(looking.conclude());
        }
        Err(error) if error.stopped => {
            looking.end = End::Stopped;
            return Ok(looking.conclude());
        }
        Err(cause) => return Err(ScanError { cause }),
    }
    for first in kinds {
        let end = match looking.from(&first, tell) {
            Err(error) if error.stopped => End::Stopped,
            outcome => outcome.map_err(|cause| ScanError { cause })?,
        };
        looking.end = looking.end.and(end);
        if end == End::Stopped {
            break;
        }
    }
    Ok(looking.conclude())
}

impl<'a> AnalysisContext<'a> {
    /// Looks from where the sensors report `first`.
    fn from(&mut self, first: &[bool], tell: &mut EventSink<'_>) -> Result<End, PlantError> {
        let prepared = self.prepared;
        let (xy_m, heading) = match self.unseen_start(first)? {
            MayReport::At(xy_m, heading) => (xy_m, heading),
            MayReport::Nowhere => return Ok(End::Whole),
            MayReport::Unknown => return Ok(End::Short),
        };
        let start = Start::new(xy_m[0], xy_m[1], heading.to_degrees());
        let there = prepared.standing(start, 0, 1).map_err(|error| PlantError::of(error.to_string().as_str()))?;
        let unmoved = self.unmoved(&there)?;
        let footing = ExecutionMode::asked(&there, self.effort.state, Merge::Auto);
        let Some((search, told)) = self.ask(&there, footing, (&unmoved, (xy_m, heading)), tell)? else {
            return Ok(self.short(tell));
        };
        if self.found.ground.is_empty() {
            self.found.ground = map::ground(&search, &unmoved, &prepared.stop()).ok_or_else(PlantError::stopped)?;
            self.walkable = map::walkable(&search, &prepared.stop()).ok_or_else(PlantError::stopped)?;
            self.found.warnings.extend(coarse(search.floor()));
        }
        let Some(kinds) = self.kinds(&search, told.as_ref(), first) else { return Ok(End::Stopped) };
        let Some(parts) = self.parts(&there, footing, &kinds)? else { return Ok(self.short(tell)) };
        // What is tried out of people and sensors inside the FMU is so in that time.
        self.any_time &= parts.len() == 1 && !search.is_told() && there.cell.pose.is_empty();
        let (all, mut end) = (parts.len(), End::Whole);
        for (number, part) in parts.iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "a few robots")]
            let mut tell = |told: AnalysisEvent| match told {
                AnalysisEvent::Floor(share, hazards) => {
                    tell(AnalysisEvent::Floor((number as f64 + share) / all as f64, hazards))
                }
                told => tell(told),
            };
            end = end.and(self.part(&there, footing, &search, part, &kinds, &mut tell)?);
            if end == End::Stopped {
                break;
            }
        }
        Ok(end)
    }

    /// Nothing more can be looked at from there: because it was told to end, or for a reason that is told.
    fn short(&self, tell: &mut EventSink<'_>) -> End {
        if self.goes_on(tell) { End::Short } else { End::Stopped }
    }

    fn goes_on(&self, tell: &mut EventSink<'_>) -> bool {
        !self.prepared.stop().is_asked() && tell(AnalysisEvent::Asked(1.0)).is_continue()
    }

    /// Looks at the robots of one part.
    fn part(
        &mut self,
        there: &Prepared,
        footing: ExecutionMode,
        search: &Search<'_>,
        part: &RobotGroup,
        kinds: &[Kind],
        tell: &mut EventSink<'_>,
    ) -> Result<End, PlantError> {
        let cell = &there.cell;
        let presses = self.found.presses.unwrap_or(0);
        let Some(Kind { readings: first, .. }) = kinds.first() else {
            self.open(Need::Searched, "where nobody is seen at the start is not known");
            return Ok(End::Short);
        };
        let way = (WALKING_SPEED_M_S * cell.step_s, self.steps());
        let Some(zones) = ReadingRegions::new(search, first, &part.sensors, way, presses) else {
            return Ok(End::Stopped);
        };
        if zones.ways.is_empty() {
            self.open(Need::Searched, "where nobody is seen at the start is not known");
            return Ok(End::Short);
        }
        // Of those that matter to these robots, what is reported is given; of the others, what is there at first, if that goes together.
        let person = |readings: &Vec<bool>| {
            let is = |kind: &&Kind| {
                let mut matter = kind.readings.iter().zip(readings).zip(&part.sensors);
                matter.all(|((own, wanted), matters)| !matters || own == wanted)
            };
            let exact = kinds.iter().find(|kind| kind.readings == *readings);
            let stance = exact.or_else(|| kinds.iter().find(is)).and_then(|kind| kind.people.first().copied());
            sensor_target(cell, stance.unwrap_or_default())
        };
        let people = zones.readings.iter().map(&person).collect();
        let mut recall = Recall::new(footing.plant(there), footing.policy(there))?;
        recall.ends_at(self.steps());
        if footing.merge == Merge::Auto {
            recall.merge_equal_states()?;
        }
        let mut machine = Machine::new(recall, (cell, &there.binding), (&zones, people), (part, presses));
        let from = (there, footing, search, first.as_slice());
        let (mut end, limit, few) = self.follow(&mut machine, from, (part, &person), tell)?;
        self.found.spent.fmu_steps += machine.recall().steps();
        self.rest.states += machine.recall().states();
        self.rest.did = self.rest.did.and(machine.recall().effort());
        if end == End::Stopped || !self.run_again(there, footing, &machine, tell)? {
            return Ok(End::Stopped);
        }
        self.motion.get_or_insert_default().merge(machine.instants().motion());
        if let (Some(few), Some(_)) = (&few, limit) {
            few.tried.iter().for_each(|tried| self.say(Need::Changes, tried.clone()));
            self.nearly |= few.is_net;
            self.motion.get_or_insert_default().merge(&few.motion);
            let sets = Sets::few(few);
            return self.look(search, first, &sets, Some(few), tell).map(|looked| end.and(looked));
        }
        self.any_time = false;
        if limit == Some(0) {
            let most = self.effort.most_states;
            let why = format!("the FMU has more than {most} states within this time while sensors see somebody once");
            let what_to_do = "Ask for less with --until, or more with --max-states";
            self.said.push((Need::Searched, Point::open_until(why, what_to_do)));
            end = End::Short;
        }
        self.found.changes = [self.found.changes, limit.filter(|changes| *changes > 0)].into_iter().flatten().min();
        let (own, between) = (machine.instants().histories(), machine.instants().histories_between());
        let histories: Vec<(History, History)> = own.into_iter().zip(between).collect();
        let in_parts = |way: usize, parts: usize, near: &dyn Fn(&RobotFrame) -> bool| {
            machine.instants().history_in_parts(way, parts, near)
        };
        let sets = Sets { zones: &zones, histories: &histories, in_parts: &in_parts };
        let looked = end.and(self.look(search, first, &sets, None, tell)?);
        // By behaviours it is known how readings change until then, so that a walk may be found where none was so far.
        let is_met = !self.found.hazards.is_empty() && !self.found.hazards.iter().any(|place| place.confirmed);
        if looked == End::Stopped || limit.is_some() || !is_met {
            return Ok(looked);
        }
        match self.behaviours((there, footing), (search, part, first), &person, tell)? {
            Ok(few) => self.hazards(search, first, &few, tell).map(|end| looked.and(end)),
            Err(Refused::Stopped) => Ok(End::Stopped),
            Err(Refused::Because(_) | Refused::Remembers(_)) => Ok(looked),
        }
    }

    /// Steps the FMU along histories, and looks for the behaviours that stand for them where there are too many: how that ended, with how
    /// many changes, where that is not all, and what stands for all.
    fn follow(
        &mut self,
        machine: &mut Machine<'_, Hosted>,
        (there, footing, search, first): (&Prepared, ExecutionMode, &Search<'_>, &[bool]),
        (part, person): (&RobotGroup, &dyn Fn(&Readings) -> Person),
        tell: &mut EventSink<'_>,
    ) -> Result<(End, Option<usize>, Option<Few>), PlantError> {
        let most = self.effort.most_states;
        // Whose stop restarts by itself has more states than there is ever room for.
        let (end, limit) = self.explore(machine, most.min(FEW_STATES), tell)?;
        if end == End::Stopped || limit.is_none() {
            return Ok((end, limit, None));
        }
        self.soon(search, first, &machine.instants().histories());
        let few = match self.behaviours((there, footing), (search, part, first), person, tell)? {
            Ok(few) => match &few.only_hazards {
                Some(not_all) => {
                    self.not_few.get_or_insert_with(|| not_all.why.clone());
                    if self.hazards(search, first, &few, tell)? == End::Stopped {
                        return Ok((End::Stopped, limit, None));
                    }
                    // What fewer changes lead to is of less interest then.
                    if self.found.hazards.iter().any(|place| place.confirmed) {
                        return Ok((end, limit, None));
                    }
                    None
                }
                None => Some(few),
            },
            Err(Refused::Stopped) => return Ok((End::Stopped, limit, None)),
            Err(Refused::Because(why) | Refused::Remembers(why)) => {
                self.not_few.get_or_insert(why);
                None
            }
        };
        // What nobody has to accept is better.
        if most > FEW_STATES && !few.as_ref().is_some_and(|few| few.is_accepted) {
            let (end, limit) = self.explore(machine, most, tell)?;
            return Ok((end, limit, few));
        }
        Ok((end, limit, few))
    }

    /// Looks for hazards alone where behaviours do not stand for all that the FMU may do: what is not known is of no interest then.
    fn hazards(
        &mut self,
        search: &Search<'_>,
        first: &[bool],
        few: &Few,
        tell: &mut EventSink<'_>,
    ) -> Result<End, PlantError> {
        let known = (self.open.clone(), self.between.clone(), self.found.open, self.found.between);
        let (histories, met, hazards) = (self.found.histories.len(), self.met.len(), self.found.hazards.len());
        let end = self.look(search, first, &Sets::few(few), Some(few), tell)?;
        (self.open, self.between, self.found.open, self.found.between) = known;
        self.found.histories.truncate(histories);
        let new = self.found.hazards.split_off(hazards);
        self.found.hazards.extend(new.into_iter().filter(|place| place.confirmed));
        if self.found.hazards.len() <= hazards {
            self.met.truncate(met);
        }
        Ok(end)
    }

    /// Looks for harm in sets of places.
    fn look(
        &mut self,
        search: &Search<'_>,
        first: &[bool],
        sets: &Sets<'_>,
        few: Option<&Few>,
        tell: &mut EventSink<'_>,
    ) -> Result<End, PlantError> {
        let (prepared, cell) = (self.prepared, &self.prepared.cell);
        let all: usize = sets.histories.iter().map(|(_, between)| between.seen.len()).sum();
        let mut done = 0;
        let each = sets.histories.iter().zip(&sets.zones.ways).enumerate();
        for (number, ((history, between), way)) in each.filter(|(_, ((_, between), _))| !between.seen.is_empty()) {
            #[expect(clippy::cast_precision_loss, reason = "some thousand")]
            let share = |part: f64| (done as f64 + part * between.seen.len() as f64) / all as f64;
            let known = self.found.hazards.iter().filter(|place| place.confirmed).count();
            let AnalysisLimits { workers, answers, .. } = self.effort;
            let (means, span) = (Means { workers, answers }, map::span(self.found.until_s, cell.step_s));
            let mut told = |part| tell(AnalysisEvent::Floor(share(part), known));
            let in_parts = |parts: usize, near: &dyn Fn(&RobotFrame) -> bool| (sets.in_parts)(number, parts, near);
            let histories = Histories { at_instants: history, around: between, in_parts: &in_parts };
            let outcome = search.search(histories, span, means, &mut self.rest.coverage, &mut told);
            self.found.histories.push(HistoryRecord {
                sensors: sensors(prepared, &history.readings),
                unseen: way.unchanged,
                instants: history.seen.len(),
            });
            self.found.spent.boxes += outcome.boxes;
            self.found.open += outcome.open.len();
            self.open.extend(outcome.open.into_iter().map(told_in));
            self.found.between += outcome.between.len();
            self.between.extend(outcome.between.into_iter().map(told_in));
            // What was found is looked at once more, even where the time is up.
            prepared.stop().finishing();
            let harms = outcome.harms.iter().map(|harm| harm.at(history));
            self.met.extend(harms.chain(outcome.moments).map(|moment| (moment, way.unchanged)));
            self.found.followed &= outcome.followed;
            self.show(search, first, (history, way), few.map(|few| (few, number)), outcome.harms);
            if outcome.stopped {
                return Ok(End::Stopped);
            }
            prepared.stop().searching();
            done += between.seen.len();
        }
        Ok(End::Whole)
    }

    /// Communication steps that are looked at.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an hour of small steps at most")]
    fn steps(&self) -> usize {
        (self.found.until_s / self.prepared.cell.step_s).ceil().max(1.0) as usize
    }

    /// Steps the FMU along all histories, with as many changes of what sensors report as its states allow; with how many, where that is
    /// not all: 0 where not even one could be followed.
    fn explore(
        &mut self,
        machine: &mut Machine<'_, Hosted>,
        most: usize,
        tell: &mut EventSink<'_>,
    ) -> Result<(End, Option<usize>), PlantError> {
        let steps = self.steps();
        let mut known: Option<usize> = None;
        let (mut changes, mut told, mut is_last, mut end) = (1, 0, false, End::Whole);
        let limit = loop {
            machine.begin();
            let mut asked = false;
            let outcome = explore(machine, steps, changes, &mut |machine, taken| {
                machine.look(taken);
                told += 1;
                if told % 256 == 0 && tell(AnalysisEvent::States(machine.recall().states(), most)).is_break() {
                    asked = true;
                }
                !asked && (is_last || machine.recall().states() < most)
            })?;
            if asked {
                return Ok((End::Stopped, None));
            }
            if outcome.ended {
                // What fewer changes lead to is known already.
                let Some(before) = known else {
                    break Some(0);
                };
                (changes, is_last) = (before, true);
                continue;
            }
            if outcome.left_out == 0 || is_last {
                break (outcome.left_out > 0).then_some(changes);
            }
            (known, changes) = (Some(changes), changes + 1);
        };
        if let Some(fault) = machine.fault() {
            let why = format!("the FMU could not finish some steps: {fault}");
            self.open(Need::Finished, why);
            end = End::Short;
        }
        Ok((end, limit))
    }

    /// Runs what the FMU did again from the start; `false` if it was told to end.
    fn run_again(
        &mut self,
        there: &Prepared,
        footing: ExecutionMode,
        machine: &Machine<'_, Hosted>,
        tell: &mut EventSink<'_>,
    ) -> Result<bool, PlantError> {
        let steps = footing.least_audit() + machine.recall().steps();
        let scope = Scope { since: 0, runs: usize::MAX, steps, instance: footing.instance() };
        let audited = audit(&mut footing.plain(there), machine.recall(), scope, &mut |done, of| {
            tell(AnalysisEvent::RunAgain(done, of)).is_continue()
        })?;
        if let Some(difference) = audited.difference {
            self.open(Need::Repeatable, Doubt::of_audit(difference).words());
        }
        self.found.spent.run_again += audited.compared;
        Ok(!audited.stopped)
    }

    /// Something that an answer needs is not known.
    fn open(&mut self, need: Need, why: impl Into<String>) {
        self.say(need, Point::open(why));
    }

    /// The same is said once, however often it is met.
    fn say(&mut self, need: Need, point: Point) {
        if !self.said.contains(&(need, point.clone())) {
            self.said.push((need, point));
        }
    }

    /// The verdict, and why.
    fn conclude(mut self) -> AnalysisResult {
        let speeds =
            self.motion.as_ref().map(|motion| Speeds::new(&self.prepared.cell, &self.prepared.binding, motion));
        self.found.warnings.extend(speeds.iter().flat_map(Speeds::sentences));
        let (found, coverage) = (&mut self.found, &self.rest.coverage);
        let step_s = self.prepared.cell.step_s;
        found.floor = map::hazardous(&self.met, map::span(found.until_s, step_s), step_s);
        found.open_m = self.open.iter().copied().map(map::middle).collect();
        found.between_m = self.between.iter().copied().map(map::middle).collect();
        found.spent.arm_checks = coverage.arm_checks;
        found.spent.arm_boxes = coverage.arm_boxes;
        // What was not confirmed one way may have been another.
        let known: Vec<_> = found.hazards.iter().filter(|place| place.confirmed).cloned().collect();
        found.hazards.retain(|place| {
            let same = |other: &HarmfulPose| {
                (other.body_region, &other.robot_link, other.walks_in)
                    == (place.body_region, &place.robot_link, place.walks_in)
            };
            place.confirmed || !known.iter().any(same)
        });
        found.hazards = once_each(std::mem::take(&mut found.hazards));
        found.hazards.sort_by(|a, b| b.confirmed.cmp(&a.confirmed).then(b.ratio.total_cmp(&a.ratio)));
        let is_part = self.effort.answers.share().is_some();
        let left = not_looked_at(found, &self.walkable, if is_part { End::Short.and(self.end) } else { self.end });
        self.said.extend(left.map(|why| (Need::Searched, Point::open(why))));
        if self.end == End::Stopped {
            let when = if self.walkable.is_empty() { ", before any floor was looked at" } else { "" };
            let why = format!("it was stopped, or its time was up{when}");
            self.said.insert(0, (Need::Searched, Point::open_until(why, "Give it more with --time")));
        }
        let obligations = Obligations::of(&FromAnywhere::new(&self, speeds.as_ref()));
        let ended = SearchEnd {
            found: self.found.hazards.iter().any(|hazard| hazard.confirmed),
            failed: false,
            interrupted: self.prepared.stop().is_asked(),
        };
        self.rest.speeds = speeds.map(|speeds| speeds.records).unwrap_or_default();
        self.found.verdict = Verdict::of(ended, &obligations);
        self.found.any_time = self.any_time && self.found.verdict.is_clean();
        self.found.reasons = obligations.reasons();
        self.found.obligations = obligations;
        AnalysisResult { found: self.found, rest: self.rest, stopped: self.end == End::Stopped }
    }
}

/// Each region that is hit by a link somewhere is told once, with the worst of it, however many histories lead there.
fn once_each(places: Vec<HarmfulPose>) -> Vec<HarmfulPose> {
    let mut told: Vec<HarmfulPose> = Vec::new();
    for place in places {
        let same = |known: &&mut HarmfulPose| {
            !known.confirmed
                && !place.confirmed
                && (known.body_region, &known.robot_link, known.walks_in, told_in(known.xy_m))
                    == (place.body_region, &place.robot_link, place.walks_in, told_in(place.xy_m))
        };
        match told.iter_mut().find(same) {
            Some(known) if place.ratio <= known.ratio => known.met_again(&place),
            Some(known) => {
                let before = std::mem::replace(known, place);
                known.met_again(&before);
            }
            None => told.push(place),
        }
    }
    told
}
