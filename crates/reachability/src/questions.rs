//! What questions about a history are known by: all that their answers depend on, but for what is the same in the whole
//! search.

use std::hash::{Hash as _, Hasher as _};

use serde::Serialize;

use super::History;
use crate::sim::answers::{Answers, Digest, Key};

/// What the questions about these histories have in common; nothing in particular where that does not matter.
pub(super) fn about(histories: [&History; 2], answers: &Answers) -> Key {
    let mut digest = Digest::default();
    if answers.is_used() {
        histories.iter().for_each(|history| history.tell(&mut digest));
    }
    digest.key()
}

/// The question about an item at one stage of the search.
pub(super) fn key(about: &Key, stage: &str, item: &impl Serialize) -> Key {
    let mut digest = Digest::default();
    (about, stage).hash(&mut digest);
    digest.write(&postcard::to_stdvec(item).unwrap_or_default());
    digest.key()
}

impl History {
    /// Everything that answers about it depend on.
    fn tell(&self, digest: &mut Digest) {
        (&self.readings, &self.links, self.seen.len()).hash(digest);
        for field in &self.fields {
            digest.numbers(field.all());
        }
        for seen in &self.seen {
            (seen.step, seen.lasting).hash(digest);
            digest.numbers(&seen.within_m);
            digest.numbers(&[seen.depth_m]);
            digest.numbers(seen.frame.outputs());
            // As large and as fast as they are here.
            let radii: Vec<f64> = seen.frame.links.iter().map(|link| link.bounding_sphere().1).collect();
            digest.numbers(&radii);
            digest.numbers(&seen.frame.speed_bounds);
        }
    }
}
