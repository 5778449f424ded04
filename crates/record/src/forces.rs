//! Both forces of a hazard, with the robot's own speed and with the speed of approach: in words, and whether they are far apart.

use crate::hazard::Hazard;
use fmi_hazard_criteria::Criterion;

/// Forces that differ by more than this factor are both told.
const FAR_APART: f64 = 2.0;

/// The speed of the robot's point alone.
const OWN: &str = "the robot's own speed";

/// The other one.
const APPROACH: &str = "the speed of approach, the person's walking included";

/// The speed whose force decides.
#[must_use]
pub const fn speed_words(decides: Criterion) -> &'static str {
    match decides {
        Criterion::Absolute => OWN,
        Criterion::Approach => APPROACH,
    }
}

/// What a table with both says of them.
#[must_use]
pub fn both_forces_note(decides: Criterion) -> String {
    let which = match decides {
        Criterion::Absolute => "the first",
        Criterion::Approach => "the second",
    };
    format!(
        "Forces: with {OWN}, and with {APPROACH}; {which} decides. “differ”: by more than a factor of {FAR_APART:.0}."
    )
}

impl Hazard {
    /// How many times the limit the force with the robot's own speed is.
    #[must_use]
    fn own_ratio(&self) -> f64 {
        self.force_n / self.limit_n
    }

    /// Whether one of them is far above the other, where it is a force that counts.
    #[must_use]
    fn is_far_apart(&self) -> bool {
        let own = self.own_ratio();
        let [less, more] =
            if own < self.directed_ratio { [own, self.directed_ratio] } else { [self.directed_ratio, own] };
        self.class.beside_force().is_none() && more > FAR_APART * less
    }

    /// The one that does not decide, in half a sentence, where they are far apart.
    #[must_use]
    pub fn other_force(&self) -> Option<String> {
        if !self.is_far_apart() {
            return None;
        }
        let other = if self.is_by_approach() {
            format!("with {OWN} {:.2}x", self.own_ratio())
        } else {
            format!("with {APPROACH}, {:.2}x", self.directed_ratio)
        };
        let decides = if self.body_region.permits_no_contact() {
            "no contact is allowed there either way"
        } else {
            "criterion in the cell file says which decides"
        };
        Some(format!("{other} ({decides})"))
    }

    /// Both, with the robot's own speed first.
    #[must_use]
    pub fn both_forces(&self) -> [String; 2] {
        [
            (OWN, self.speed_m_s, self.force_n, self.own_ratio()),
            (APPROACH, self.approach_m_s, self.directed_force_n, self.directed_ratio),
        ]
        .map(|(speed, speed_m_s, force_n, ratio)| {
            format!("with {speed}, {speed_m_s:.2} m/s: {force_n:.0} N, {ratio:.2}x the limit")
        })
    }

    /// That they are far apart, and why, where they are.
    #[must_use]
    pub fn apart_words(&self) -> Option<String> {
        let why = if self.own_ratio() > self.directed_ratio {
            "Most of the robot's speed is not towards the person."
        } else {
            "Most of the speed is the person's own walking."
        };
        self.is_far_apart().then(|| format!("The two differ by more than a factor of {FAR_APART:.0}. {why}"))
    }
}

#[cfg(test)]
mod tests {
    use crate::fixtures::hazard;

    #[test]
    fn the_other_force_is_told_where_they_are_far_apart() {
        let mut hazard = hazard("H-1", 1.5);
        assert_eq!((hazard.other_force(), hazard.apart_words()), (None, None));
        (hazard.directed_force_n, hazard.directed_ratio) = (60.0, 0.6);
        let other = hazard.other_force().unwrap();
        assert!(other.starts_with("with the speed of approach, the person's walking included, 0.60x ("), "{other}");
        let apart = hazard.apart_words().unwrap();
        assert_eq!(
            apart,
            "The two differ by more than a factor of 2. Most of the robot's speed is not towards the person."
        );
        assert_eq!(hazard.both_forces()[0], "with the robot's own speed, 0.50 m/s: 150 N, 1.50x the limit");
    }
}
