//! How far apart robots are that stand and move nearly alike: in widths, of which one is so many metres for any point of a link that is
//! looked at, or so much speed, whichever is more. What else is read of the FMU is the same or it is not.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::cell::{Binding, Workcell};
use crate::geometry::{Solid, Vec3};
use crate::search::behaviours::OutputClass;
use crate::search::behaviours::net::{apart, cell};
use crate::sim::robot::RobotFrame;

/// Numbers that have to be the same are so if they differ by less, in their own units.
const SAME: f64 = 1e-6;
/// Robots that are no faster are at rest, in widths.
const REST: f32 = 1e-6;
/// Rows are numbered that are farther apart than this, in widths.
const PART: f32 = 0.25;
/// They are kept by place in cells of this size, in widths.
const CELL: f32 = 0.5;

/// One width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Width {
    /// By place, m.
    pub place_m: f64,
    /// By speed, m/s.
    pub speed_m_s: f64,
}

/// See the top of this file.
#[derive(Clone, Debug)]
pub(crate) struct Widths {
    width: Width,
    /// Which links count.
    links: Arc<[bool]>,
    /// Columns that are the same or not.
    same: Vec<usize>,
    /// Traits that tell best where a row is.
    best: [usize; 3],
}

impl Widths {
    /// By these links, of rows that have so many outputs and then what is on its way.
    #[must_use]
    pub(crate) fn new(
        (cell, binding): (&Workcell, &Binding),
        width: Width,
        links: &Arc<[bool]>,
        outputs: usize,
        rows: &[Vec<f64>],
    ) -> Self {
        let moves = binding.moves();
        let matter = binding.matters().into_iter().enumerate();
        let same = matter.filter(|(column, matters)| *matters && !moves[*column]).map(|(column, _)| column);
        let mut this = Self { width, links: Arc::clone(links), same: same.chain([outputs]).collect(), best: [0; 3] };
        let traits = rows.iter().map(|row| this.traits((cell, binding), &[&row[..outputs], &[0.0]].concat()));
        this.best = telling(traits.collect());
        this
    }

    /// What tells robots apart by a row: no two rows are farther apart than by the greatest difference.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "a few metres, in widths")]
    pub(crate) fn traits(&self, (cell, binding): (&Workcell, &Binding), row: &[f64]) -> Vec<f32> {
        let frame = RobotFrame::new(cell, binding, &row[..binding.outputs.len()]);
        let mut traits: Vec<f32> = self.same.iter().map(|column| (row[*column] / SAME) as f32).collect();
        for link in (0..frame.links.len()).filter(|link| self.links[*link]) {
            for point in points(&frame.links[link]) {
                let velocity = frame.velocity(link, point);
                traits.extend([point.x, point.y, point.z].map(|at| (at / self.width.place_m) as f32));
                traits.extend([velocity.x, velocity.y, velocity.z].map(|speed| (speed / self.width.speed_m_s) as f32));
            }
        }
        traits
    }

    /// Where a row is by its traits: no two are farther apart in any of these than they are.
    #[must_use]
    pub(crate) fn place(&self, traits: &[f32]) -> [f32; 3] {
        self.best.map(|best| traits[best])
    }

    /// Whether no link moves.
    fn rests(&self, traits: &[f32]) -> bool {
        traits[self.same.len()..].chunks(6).all(|point| point[3..].iter().all(|speed| speed.abs() < REST))
    }

    /// How far robots with these traits are from those with others, in widths, and by how much they are faster.
    fn beyond(&self, one: &[f32], other: &[f32]) -> [f32; 2] {
        let same = self.same.len();
        let mut most = [0.0_f32; 2];
        for (one, other) in one[same..].chunks(6).zip(other[same..].chunks(6)) {
            let square: f32 = other[3..].iter().map(|speed| speed * speed).sum();
            let product: f32 = one[3..].iter().zip(&other[3..]).map(|(one, other)| one * other).sum();
            let share = if square > 0.0 { (product / square).clamp(0.0, 1.0) } else { 0.0 };
            let faster =
                one[3..].iter().zip(&other[3..]).map(|(one, other)| (one - share * other).powi(2)).sum::<f32>();
            let apart = one[..3].iter().zip(&other[..3]).map(|(one, other)| (one - other).powi(2)).sum::<f32>();
            most = [most[0].max(apart.sqrt()), most[1].max(faster.sqrt())];
        }
        most
    }

    /// The greatest speed of the links that count, m/s.
    #[must_use]
    pub(crate) fn fastest(&self, frame: &RobotFrame) -> f64 {
        frame.fastest_of(&self.links)
    }

    /// How far links are apart by place, m, and by how much any is faster than in the other, m/s; nothing if they do not strike alike.
    #[must_use]
    pub(crate) fn between(&self, one: &RobotFrame, other: &RobotFrame) -> Option<[f64; 2]> {
        let mut most = [0.0_f64; 2];
        for link in (0..one.links.len()).filter(|link| self.links[*link]) {
            if !one.strikes_as(other, link) {
                return None;
            }
            most[0] = most[0].max(one.moved_from(other, link));
            most[1] = most[1].max(one.faster_than(other, link));
        }
        Some(most)
    }
}

/// Points that tell where all of a link is.
fn points(link: &Solid) -> Vec<Vec3> {
    let turned = |pose: crate::geometry::Pose| {
        let (centre, radius) = link.bounding_sphere();
        [Vec3::ZERO, Vec3::X, Vec3::Y].map(|axis| centre + pose.rotation * (axis * radius)).to_vec()
    };
    match link {
        Solid::Capsule(capsule) => vec![capsule.a, capsule.b],
        Solid::Hull(hull) => turned(hull.pose()),
        Solid::Mesh(mesh) => turned(mesh.pose()),
    }
}

/// Three traits in which rows differ most, each beyond what those before it tell.
fn telling(mut rows: Vec<Vec<f32>>) -> [usize; 3] {
    let columns = rows.first().map_or(0, Vec::len);
    #[expect(clippy::cast_precision_loss, reason = "a few rows")]
    let mean = |rows: &[Vec<f32>], column: usize| rows.iter().map(|row| row[column]).sum::<f32>() / rows.len() as f32;
    for column in 0..columns {
        let mean = mean(&rows, column);
        rows.iter_mut().for_each(|row| row[column] -= mean);
    }
    let product =
        |rows: &[Vec<f32>], one: usize, other: usize| rows.iter().map(|row| row[one] * row[other]).sum::<f32>();
    std::array::from_fn(|_| {
        let squares: Vec<f32> = (0..columns).map(|column| product(&rows, column, column)).collect();
        let best = (0..columns).max_by(|a, b| squares[*a].total_cmp(&squares[*b])).unwrap_or_default();
        if squares.get(best).is_some_and(|square| *square > 0.0) {
            let shares: Vec<f32> = (0..columns).map(|column| product(&rows, column, best) / squares[best]).collect();
            for row in &mut rows {
                let told = row[best];
                row.iter_mut().zip(&shares).for_each(|(value, share)| *value -= share * told);
            }
        }
        best
    })
}

/// What tells robots apart.
type Traits = Box<[f32]>;

/// Rows that stand for others.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rows {
    /// Each with its traits.
    all: Vec<(Box<[f64]>, Traits)>,
    places: BTreeMap<[i64; 3], Vec<OutputClass>>,
}

impl Rows {
    /// A row by its number.
    #[must_use]
    pub(crate) fn row(&self, shown: OutputClass) -> &[f64] {
        &self.all[shown as usize].0
    }

    /// The number of a row, or of another that is nearly there.
    #[expect(clippy::cast_possible_truncation, reason = "as many as memory holds")]
    pub fn number(&mut self, row: &[f64], traits: &[f32], widths: &Widths) -> OutputClass {
        if let Some((known, _)) = self.nearest(traits, PART, widths) {
            return known;
        }
        let number = self.all.len() as OutputClass;
        self.all.push((row.into(), traits.into()));
        self.places.entry(cell(widths.place(traits), CELL)).or_default().push(number);
        number
    }

    /// Of those that count and are no farther away than so, in widths, the one that is nearest and least slower.
    pub(crate) fn least_beyond(
        &self,
        traits: &[f32],
        most: f32,
        widths: &Widths,
        counts: impl Fn(OutputClass) -> bool,
    ) -> Option<(OutputClass, f32)> {
        let mut least: Option<(f32, OutputClass)> = None;
        self.near(traits, most, widths, &mut |known, its| {
            // What is at rest harms nobody, so it stands only for what is.
            if counts(known) && apart(traits, its, most).is_some() && (widths.rests(traits) || !widths.rests(its)) {
                let [apart, faster] = widths.beyond(traits, its);
                let beyond = apart.max(faster);
                if least.is_none_or(|least| (beyond, known) < least) {
                    least = Some((beyond, known));
                }
            }
        });
        least.map(|(beyond, known)| (known, beyond))
    }

    fn near<'a>(&'a self, traits: &[f32], most: f32, widths: &Widths, tell: &mut dyn FnMut(OutputClass, &'a [f32])) {
        let [low, high] = [-most, most].map(|by| cell(widths.place(traits).map(|at| at + by), CELL));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for known in self.places.range([x, y, low[2]]..=[x, y, high[2]]).flat_map(|(_, known)| known) {
                    tell(*known, &self.all[*known as usize].1);
                }
            }
        }
    }

    /// The nearest, and how far it is, no farther away than so, in widths.
    fn nearest(&self, traits: &[f32], most: f32, widths: &Widths) -> Option<(OutputClass, f32)> {
        let mut nearest: Option<(OutputClass, f32)> = None;
        self.near(traits, most, widths, &mut |known, its| {
            let most = nearest.map_or(most, |(_, apart)| apart);
            if let Some(apart) = apart(traits, its, most)
                && widths.rests(its) == widths.rests(traits)
                && nearest.is_none_or(|(least, its)| apart < its || (apart <= its && known < least))
            {
                nearest = Some((known, apart));
            }
        });
        nearest
    }
}
