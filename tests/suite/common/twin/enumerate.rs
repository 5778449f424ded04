//! All sequences of a short horizon, and what a single one meets.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::arm::{HAND, Pose, Question, Touch, Verdict};
use super::body::{Body, NECK_BASE, POSTURES, Place, WALKS, shoulder, walk};
use super::cell::Cell;
use super::force::{Criterion, Forces, Speeds, class};
use super::geometry::{Solid, V3, add, dot, length, nearest, scaled, sub};
use super::planes::{Sample, inputs, samples, too_deep, ways};
use super::robot::{Link, Robot, Runs};

/// An unsafe contact of head, trunk or legs.
#[derive(Debug, Clone, PartialEq)]
pub struct Hit {
    pub class: &'static str,
    pub region: &'static str,
    pub link: String,
    pub point: V3,
    pub forces: Forces,
    pub depth: f64,
}

/// What is met at the end of a step.
#[derive(Debug, Clone)]
pub struct Instant {
    pub place: Place,
    pub posture: usize,
    /// The velocity at which the person walked in this step: none where they stand, or an obstacle stopped them.
    pub walking: V3,
    pub raw: Vec<Sample>,
    pub robot: Rc<Robot>,
    pub body: Option<Hit>,
    /// The arms, where the body meets nothing.
    pub arms: Verdict,
}

/// Sequences that are hazardous: for certain, and at most.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Count {
    pub certain: u64,
    pub at_most: u64,
}

/// What the unsafe instants of an enumeration are like, for people who read a test that failed.
pub type Kinds = BTreeMap<String, u64>;

/// Place, posture, whether the person walks where that counts, arm, robot, and the rows of the planes with their depths.
type Asked = (Place, usize, bool, bool, usize, Vec<(u8, u64)>);

pub struct Twin {
    pub cell: Cell,
    pub runs: Runs,
    bodies: BTreeMap<(Place, usize), Rc<Body>>,
    verdicts: BTreeMap<Asked, Verdict>,
    counts: BTreeMap<(usize, Place, Vec<Sample>), Count>,
    pub kinds: Kinds,
    pub questions: u64,
}

const SIDES: [f64; 2] = [1.0, -1.0];

/// The link's and the body's point of a pair where it overlaps most, the direction from the link out to the body, and the
/// signed distance. The direction is that between the cores: the two points change sides where they overlap, cores do not.
fn pair(core: [V3; 2], radius: f64, link: &Link) -> (V3, V3, V3, f64) {
    let (p, q) = nearest(core, link.core);
    let d = length(sub(q, p));
    let towards = if d > 0.0 { scaled(sub(q, p), 1.0 / d) } else { [0.0; 3] };
    let out = scaled(towards, -1.0);
    (add(q, scaled(out, link.radius)), add(p, scaled(towards, radius)), out, d - radius - link.radius)
}

impl Twin {
    pub fn new(cell: Cell) -> Self {
        let runs = Runs::new(&cell);
        Self {
            cell,
            runs,
            bodies: BTreeMap::new(),
            verdicts: BTreeMap::new(),
            counts: BTreeMap::new(),
            kinds: Kinds::new(),
            questions: 0,
        }
    }

    pub fn body(&mut self, place: Place, posture: usize) -> Rc<Body> {
        let cell = &self.cell;
        self.bodies.entry((place, posture)).or_insert_with(|| Rc::new(Body::new(cell, place, posture))).clone()
    }

    /// Samples before the person begins.
    pub fn before(&mut self) -> Vec<Sample> {
        let body = self.body(Place::START, 0);
        vec![samples(&self.cell, &body, &body, Place::START.xy(&self.cell)); self.cell.lead_in]
    }

    /// The contact of head, trunk and legs that is told, if one is unsafe; and the harmless ones.
    pub fn body_contacts(&self, body: &Body, robot: &Robot, raw: &[Sample], walking: V3) -> Vec<(Hit, bool)> {
        let (criterion, mass) = (self.cell.criterion, robot.effective_mass);
        let mut all = Vec::new();
        // Links first: that is the order in which equals are told.
        for link in &robot.links {
            for part in &body.parts {
                let (point, of_body, out, distance) = pair(part.core, part.radius, link);
                if distance > 0.0 || too_deep(&self.cell, body, raw, point) {
                    continue;
                }
                let region = body.region(part, of_body);
                let towards = dot(sub(link.moves(point), walking), out).max(0.0);
                let speeds = Speeds { own: link.speed(point), towards };
                let forces = Forces::new(region, mass, speeds, criterion);
                let class = class(region, mass, speeds, criterion);
                let link = link.name.clone();
                let unsafe_ = class.is_some();
                let class = class.unwrap_or("harmless");
                all.push((Hit { class, region, link, point, forces, depth: -distance }, unsafe_));
            }
        }
        all
    }

    fn told(hits: &[(Hit, bool)]) -> Option<Hit> {
        let all: Vec<&Hit> = hits.iter().filter(|h| h.1).map(|h| &h.0).collect();
        let deepest = all.iter().map(|h| h.depth).fold(0.0, f64::max);
        let near = all.into_iter().filter(|h| h.depth >= deepest - 0.02);
        // Of equals, to rounding, the first.
        near.reduce(|worst, h| if h.forces.ratio() > worst.forces.ratio() * (1.0 + 1e-12) { h } else { worst }).cloned()
    }

    /// The arms that are available: side and shoulder.
    fn arms(&self, body: &Body) -> Vec<(f64, V3)> {
        let base = body.in_world(NECK_BASE);
        let free = |s: &V3| self.cell.obstacles.iter().all(|o| o.gap([base, *s]) >= -1e-9);
        SIDES.into_iter().map(|side| (side, body.in_world(shoulder(side)))).filter(|(_, s)| free(s)).collect()
    }

    fn arm_verdict(&mut self, place: Place, posture: usize, walking: V3, raw: &[Sample]) -> Verdict {
        let body = self.body(place, posture);
        let criterion = self.cell.criterion;
        let walks = criterion == Criterion::Approach && walking != [0.0; 3];
        let mut best = Verdict::None;
        for (side, shoulder) in self.arms(&body) {
            let mut asked: Vec<(Rc<Robot>, super::planes::Way)> = Vec::new();
            // Deepest first, so that what is less deep at the same robot is left out.
            let mut all = ways(&self.cell, &body, raw, shoulder);
            all.sort_by(|a, b| b.kind.iter().map(|k| k.1).sum::<f64>().total_cmp(&a.kind.iter().map(|k| k.1).sum()));
            for way in all {
                let robot = self.runs.after(&self.cell, &inputs(&self.cell, &way.raw));
                let less = |other: &super::planes::Way| {
                    (way.unsure || !other.unsure)
                        && way.kind.iter().zip(&other.kind).all(|(a, b)| a.0 == b.0 && a.1 <= b.1)
                };
                if asked.iter().any(|(r, other)| r.number == robot.number && less(other)) {
                    continue;
                }
                asked.push((robot, way));
            }
            for (robot, way) in asked {
                if way.unsure && best == Verdict::Uncertain {
                    continue;
                }
                let question = |solids| {
                    // What is held is known to a tenth of its length.
                    let tight = 1.05 * (self.cell.tolerance + 0.1 * self.cell.held);
                    let hand = HAND + self.cell.held;
                    let trunk = body.rotation;
                    Question { shoulder, trunk, side, walking, criterion, robot: &robot, solids, hand, tight }
                };
                if !question(&[]).in_reach() {
                    continue;
                }
                let limits = way.kind.iter().map(|k| (k.0, k.1.to_bits())).collect();
                let key = (place, posture, walks, side > 0.0, robot.number, limits);
                let verdict = match self.verdicts.get(&key) {
                    Some(known) => *known,
                    None => {
                        let solids: Vec<Solid> = self.cell.obstacles.iter().chain(&way.walls).cloned().collect();
                        self.questions += 1;
                        let verdict = question(&solids).verdict();
                        self.verdicts.insert(key, verdict);
                        verdict
                    }
                };
                best = best.max(if way.unsure { verdict.min(Verdict::Uncertain) } else { verdict });
                if best == Verdict::Certain {
                    return best;
                }
            }
        }
        best
    }

    /// An action from a place, after these samples: all its instants up to the first that is certainly unsafe.
    pub fn act(&mut self, from: Place, raw: &[Sample], action: usize) -> (Vec<Instant>, Place, Vec<Sample>) {
        let (walked, posture) = (action / 6, action % 6);
        let places = walk(&self.cell, from, walked);
        let mut before = from.turned(WALKS[walked].1);
        let start = raw.len();
        let mut raw = raw.to_vec();
        let mut walks = Vec::new();
        for place in &places {
            let body = self.body(before, posture);
            let upright = self.body(before, 0);
            raw.push(samples(&self.cell, &body, &upright, before.xy(&self.cell)));
            walks.push(if *place == before { [0.0; 3] } else { place.walking(&self.cell) });
            before = *place;
        }
        let history = inputs(&self.cell, &raw);
        let _ = self.runs.after(&self.cell, &history);
        let mut instants = Vec::new();
        for (i, (place, walking)) in places.iter().zip(walks).enumerate() {
            let now = &raw[..=start + i];
            let robot = self.runs.after(&self.cell, &history[..=start + i]);
            let body = self.body(*place, posture);
            let hit = Self::told(&self.body_contacts(&body, &robot, now, walking));
            let arms = if hit.is_some() { Verdict::None } else { self.arm_verdict(*place, posture, walking, now) };
            let ends = hit.is_some() || arms == Verdict::Certain;
            instants.push(Instant { place: *place, posture, walking, raw: now.to_vec(), robot, body: hit, arms });
            if ends {
                break;
            }
        }
        (instants, before, raw)
    }

    /// All sequences of the cell's horizon.
    pub fn count(&mut self) -> Count {
        let raw = self.before();
        self.below(0, Place::START, &raw)
    }

    fn below(&mut self, depth: usize, place: Place, raw: &[Sample]) -> Count {
        let mut count = Count { certain: 0, at_most: 0 };
        if depth == self.cell.actions {
            return count;
        }
        let key = (depth, place, raw.to_vec());
        if let Some(known) = self.counts.get(&key) {
            return *known;
        }
        let rest = 36_u64.pow(u32::try_from(self.cell.actions - depth - 1).expect("few"));
        for action in 0..36 {
            let (instants, end, after) = self.act(place, raw, action);
            let last = instants.last().expect("an action has steps");
            if let Some(hit) = &last.body {
                *self.kinds.entry(format!("{} {} {}", hit.class, hit.region, hit.link)).or_default() += 1;
            } else if last.arms == Verdict::Certain {
                *self.kinds.entry("arm".to_owned()).or_default() += 1;
            }
            let unsure = instants.iter().any(|i| i.arms == Verdict::Uncertain);
            if last.body.is_some() || last.arms == Verdict::Certain {
                count.certain += rest;
                count.at_most += rest;
            } else {
                let on = self.below(depth + 1, end, &after);
                count.certain += on.certain;
                if unsure {
                    *self.kinds.entry("arm, uncertain".to_owned()).or_default() += 1;
                }
                count.at_most += if unsure { rest } else { on.at_most };
            }
        }
        self.counts.insert(key, count);
        count
    }

    /// All instants of a sequence, written like `left45/bend-forward`, whether unsafe or not.
    pub fn follow(&mut self, actions: &[String], until: usize) -> Vec<Instant> {
        let (mut place, mut raw) = (Place::START, self.before());
        let mut all = Vec::new();
        for action in actions {
            let (walked, posture) = action.split_once('/').expect("a walk and a posture");
            let walked = WALKS.iter().position(|w| w.0 == walked).expect("a walk");
            let posture = POSTURES.iter().position(|p| p.0 == posture).expect("a posture");
            let (instants, end, after) = self.act(place, &raw, 6 * walked + posture);
            all.extend(instants);
            (place, raw) = (end, after);
            if all.len() >= until {
                break;
            }
        }
        all
    }

    /// The contacts above the limit of a pose at an instant, in any run that the planes allow.
    pub fn contacts(&mut self, instant: &Instant, side: f64, pose: &Pose) -> Vec<(Touch, Forces)> {
        let body = self.body(instant.place, instant.posture);
        let Some((_, at)) = self.arms(&body).into_iter().find(|a| a.0 == side) else { return Vec::new() };
        let mut all = Vec::new();
        for way in ways(&self.cell, &body, &instant.raw, at) {
            let robot = self.runs.after(&self.cell, &inputs(&self.cell, &way.raw));
            let solids: Vec<Solid> = self.cell.obstacles.iter().chain(&way.walls).cloned().collect();
            let criterion = self.cell.criterion;
            let question = Question {
                shoulder: at,
                trunk: body.rotation,
                side,
                walking: instant.walking,
                criterion,
                robot: &robot,
                solids: &solids,
                hand: HAND + self.cell.held,
                tight: 0.0,
            };
            for touch in question.contacts(pose) {
                let forces = Forces::new(touch.region, robot.effective_mass, touch.speeds, criterion);
                all.push((touch, forces));
            }
        }
        all
    }
}
