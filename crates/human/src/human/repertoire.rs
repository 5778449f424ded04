//! What the person in a cell can do, as actions that are counted: the 36 of the paper, more where the cell file asks for it, and
//! each with every set of controls.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Action, Posture, Presses, Walk, Who};
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// Something that a person does only where the cell file says so: each makes the search larger, and no standard counts on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Ability {
    /// Kneel on both knees, the trunk upright: 1.31 m high.
    Kneel,
    /// Crouch on the feet, the trunk over the knees: 0.84 m high.
    Crouch,
    /// Crawl on hands and knees: 0.65 m high.
    Crawl,
    /// Step back without turning.
    StepBack,
    /// Run straight ahead, at a whole multiple of the walking speed.
    Run,
}

impl Ability {
    /// Every one once.
    pub(crate) const ALL: [Self; 5] = [Self::Kneel, Self::Crouch, Self::Crawl, Self::StepBack, Self::Run];

    /// For people: what somebody does who does it.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Kneel => "kneeling",
            Self::Crouch => "crouching",
            Self::Crawl => "crawling",
            Self::StepBack => "steps back",
            Self::Run => "running",
        }
    }

    /// The walk that it is, if it is one.
    const fn walk(self) -> Option<Walk> {
        match self {
            Self::StepBack => Some(Walk::Back),
            Self::Run => Some(Walk::Run),
            Self::Kneel | Self::Crouch | Self::Crawl => None,
        }
    }

    /// The posture that it is, if it is one.
    pub const fn posture(self) -> Option<Posture> {
        match self {
            Self::Kneel => Some(Posture::Kneeling),
            Self::Crouch => Some(Posture::Crouching),
            Self::Crawl => Some(Posture::Crawling),
            Self::StepBack | Self::Run => None,
        }
    }
}

/// The actions of a cell's person. The index of one is `(set of controls * walks + walk) * postures + posture`, walks and postures
/// by their places in the lists, so what everybody does comes first. Where there is a second person, it is that times the number of
/// what the second one does, and then its own index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repertoire {
    walks: Vec<Walk>,
    postures: Vec<Posture>,
    abilities: Vec<Ability>,
    controls: usize,
    strides: u8,
    /// What the second person does beside them, without controls.
    second: Option<Box<Self>>,
}

impl Repertoire {
    /// Times the walking speed that somebody runs at most.
    pub const FASTEST: u8 = 4;

    /// What everybody does in a cell with so many controls, and these abilities; who runs does so at `strides` times the walking
    /// speed.
    #[must_use]
    pub fn new(abilities: &[Ability], strides: u8, controls: usize) -> Self {
        let abilities: Vec<Ability> = Ability::ALL.into_iter().filter(|ability| abilities.contains(ability)).collect();
        let walks = Walk::USUAL.into_iter().chain(abilities.iter().filter_map(|ability| ability.walk())).collect();
        let low = abilities.iter().filter_map(|ability| ability.posture());
        let postures = Posture::USUAL.into_iter().chain(low).collect();
        Self { walks, postures, abilities, controls, strides: strides.max(1), second: None }
    }

    /// What everybody does in a cell with so many controls.
    #[must_use]
    pub fn usual(controls: usize) -> Self {
        Self::new(&[], 1, controls)
    }

    /// The same while a second person does any of what `second` does without its controls.
    #[must_use]
    pub fn beside(self, second: Self) -> Self {
        Self { second: Some(Box::new(Self { controls: 0, ..second })), ..self }
    }

    /// What one of the people does; of nobody, where there is no second one.
    #[must_use]
    pub fn of(&self, who: Who) -> Option<&Self> {
        match who {
            Who::First => Some(self),
            Who::Second => self.second.as_deref(),
        }
    }

    /// Number of actions.
    #[must_use]
    pub fn count(&self) -> usize {
        (self.moves() << self.controls) * self.of_second()
    }

    /// Number of what the second person does; 1 if there is none.
    fn of_second(&self) -> usize {
        self.second.as_ref().map_or(1, |second| second.moves())
    }

    /// The indices of what either of the people does in the action with an index.
    #[must_use]
    pub fn apart(&self, index: usize) -> (usize, usize) {
        (index / self.of_second(), index % self.of_second())
    }

    /// Number of actions without a control.
    #[must_use]
    pub const fn moves(&self) -> usize {
        self.walks.len() * self.postures.len()
    }

    /// The action with an index that was counted up to [`Self::count`].
    ///
    /// # Panics
    /// For an index that the cell does not have: another action in its place would be looked at twice, and its own never.
    #[must_use]
    pub fn action(&self, index: usize) -> Action {
        let (own, seconds) = self.apart(index);
        let presses = Presses::from_index(own / self.moves());
        assert!(index < self.count() && presses.is_some(), "there is no action {index}");
        let (walk, posture) = (own % self.moves() / self.postures.len(), own % self.postures.len());
        let action = Action::new(self.walks[walk], self.postures[posture]).pressing(presses.unwrap_or(Presses::NONE));
        self.second.as_ref().map_or(action, |second| action.beside(second.action(seconds)))
    }

    /// Every action once, in the order of the index.
    pub fn all(&self) -> impl Iterator<Item = Action> + '_ {
        (0..self.count()).map(|index| self.action(index))
    }

    /// The index of an action, if it is one of them.
    #[must_use]
    pub fn index(&self, action: Action) -> Option<usize> {
        let walk = self.walks.iter().position(|walk| *walk == action.walk())?;
        let posture = self.postures.iter().position(|posture| *posture == action.posture())?;
        let index = (action.presses().index() * self.walks.len() + walk) * self.postures.len() + posture;
        let index = match &self.second {
            Some(second) if action.is_of_two() => {
                index * second.moves() + second.index(action.of(Who::Second).pressing(Presses::NONE))?
            }
            None if !action.is_of_two() => index,
            _ => return None,
        };
        (index < self.count()).then_some(index)
    }

    /// Ways to walk.
    #[must_use]
    pub fn walks(&self) -> &[Walk] {
        &self.walks
    }

    /// Postures.
    #[must_use]
    pub fn postures(&self) -> &[Posture] {
        &self.postures
    }

    /// Those in which the legs are bent too, from the highest to the lowest.
    #[must_use]
    pub fn low(&self) -> &[Posture] {
        &self.postures[Posture::USUAL.len()..]
    }

    /// What there is beyond what everybody does.
    #[must_use]
    pub fn abilities(&self) -> &[Ability] {
        &self.abilities
    }

    /// How fast who runs does so, m/s, if anybody does.
    #[must_use]
    pub fn run_m_s(&self) -> Option<f64> {
        let rounded = |speed: f64| (speed * 10.0).round() / 10.0;
        self.walks.contains(&Walk::Run).then(|| rounded(f64::from(self.strides) * WALKING_SPEED_M_S))
    }

    /// How many times farther than somebody who walks anybody of this repertoire gets.
    #[must_use]
    pub fn strides(&self) -> u8 {
        if self.walks.contains(&Walk::Run) { self.strides } else { 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_everybody_does_is_counted_as_in_the_paper() {
        let usual = Repertoire::usual(0);
        assert_eq!((usual.count(), usual.low(), usual.strides()), (36, &[][..], 1));
        for (index, action) in usual.all().enumerate() {
            assert_eq!(action, Action::new(Walk::USUAL[index / 6], Posture::USUAL[index % 6]));
        }
        // Controls go over and above the 36: what there is without them keeps its index.
        let pressed = Repertoire::usual(2);
        assert_eq!(pressed.count(), 144);
        assert!(pressed.all().zip(usual.all()).all(|(a, b)| a == b));
        let walk = Action::new(Walk::Left45, Posture::Forward);
        let pressing = walk.pressing(Presses::one(1));
        assert_eq!((pressed.index(walk), pressed.index(pressing)), (Some(13), Some(72 + 13)));
        assert_eq!(usual.index(pressing), None);
        assert_eq!(pressing.effort(), walk.effort() + 1);
    }

    /// Two people: each does all of its own with all of the other's, and standing is the first of both.
    #[test]
    fn two_people_do_everything_beside_each_other() {
        let crawls = Repertoire::new(&[Ability::Crawl], 1, 3);
        let both = Repertoire::usual(1).beside(crawls.clone());
        assert_eq!(both.count(), 2 * 36 * 42);
        for (index, action) in both.all().enumerate() {
            assert_eq!(both.index(action), Some(index));
            let (own, seconds) = both.apart(index);
            assert_eq!(action.of(Who::First), Repertoire::usual(1).action(own));
            assert_eq!(action.of(Who::Second).pressing(Presses::NONE), crawls.action(seconds));
        }
        assert_eq!(both.action(0), Action::REST.beside(Action::REST));
        assert_eq!((both.index(Action::REST), Repertoire::usual(0).index(both.action(0))), (None, None));
        assert_eq!(both.of(Who::Second).map(Repertoire::count), Some(42));
    }

    #[test]
    fn every_index_is_that_of_its_action() {
        for abilities in [&[][..], &[Ability::Crawl], &[Ability::Run, Ability::Kneel], &Ability::ALL] {
            for controls in [0, 1, Presses::MOST] {
                let repertoire = Repertoire::new(abilities, 2, controls);
                for (index, action) in repertoire.all().enumerate() {
                    assert_eq!(repertoire.index(action), Some(index));
                }
                assert_eq!(repertoire.action(0), Action::REST);
                assert!(repertoire.abilities().len() == abilities.len());
            }
        }
        let all = Repertoire::new(&Ability::ALL, 3, 0);
        assert_eq!((all.count(), all.low(), all.strides()), (8 * 9, &Posture::LOW[..], 3));
        assert_eq!(Repertoire::new(&[Ability::Crouch], 3, 0).strides(), 1);
        assert_eq!(Repertoire::usual(0).index(Action::new(Walk::Back, Posture::Upright)), None);
    }
}
