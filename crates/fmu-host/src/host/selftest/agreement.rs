//! Compares two runs of an FMU that should be the same, to the last bit.

use fmu_self_test::{Agreement, Difference};

use crate::host::in_process::{NO_NUMBER, REFUSED};
use crate::host::plant::PlantError;
use crate::host::port::PortKind;
use crate::host::system::SystemSetup;

/// There is nothing to compare.
impl From<PlantError> for Agreement {
    fn from(error: PlantError) -> Self {
        Self::Failed { reason: error.message, printed: error.printed }
    }
}

/// The columns of a run.
pub(in crate::host) struct Columns {
    pub(super) names: Vec<String>,
    pub(super) kinds: Vec<PortKind>,
}

impl Columns {
    /// Of the outputs, then of what is watched.
    pub(in crate::host) fn of(setup: &SystemSetup) -> Self {
        let kinds = setup.outputs.iter().chain(&setup.watched).map(|p| p.port.kind).collect();
        Self { names: setup.column_names(), kinds }
    }

    /// Of what type a column is.
    pub(super) fn kind(&self, column: usize) -> PortKind {
        self.kinds.get(column).copied().unwrap_or(PortKind::Real)
    }

    /// In what two different values of this place in a run differ.
    fn difference(&self, place: usize, a: f64, b: f64) -> Difference {
        let kind = self.kinds.get(place % self.kinds.len().max(1));
        let either = |value: f64| a.to_bits() == value.to_bits() || b.to_bits() == value.to_bits();
        match kind {
            _ if either(REFUSED) => Difference::Unreadable,
            Some(PortKind::Boolean) => Difference::Truth,
            _ if either(NO_NUMBER) => Difference::NotFinite,
            _ if a == 0.0 && b == 0.0 => Difference::SignOfZero,
            _ => Difference::Number,
        }
    }
}

/// How a run compares with the reference.
pub(in crate::host) fn agreement(reference: &[f64], run: Result<Vec<f64>, PlantError>, columns: &Columns) -> Agreement {
    match run {
        Err(error) => Agreement::from(error),
        Ok(run) if run.len() != reference.len() => Agreement::from(PlantError::of("runs of different length")),
        Ok(run) => {
            let pairs = run.iter().zip(reference).enumerate();
            let different = pairs.filter(|(_, (a, b))| a.to_bits() != b.to_bits());
            let kind = |(place, (a, b)): (usize, (&f64, &f64))| columns.difference(place, *a, *b);
            let Some(first) = different.clone().next() else { return Agreement::Exact };
            let numbers = different.filter(|pair| kind(*pair) == Difference::Number);
            let largest = numbers.map(|(_, (a, b))| (a - b).abs() / b.abs().max(1.0)).fold(0.0, f64::max);
            let output = columns.names.get(first.0 % columns.names.len().max(1)).cloned();
            Agreement::Differs { largest, first: kind(first), output }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_bit_is_a_difference_and_is_named_with_its_kind() {
        let columns =
            Columns { names: ["a", "b"].map(str::to_owned).to_vec(), kinds: vec![PortKind::Real, PortKind::Boolean] };
        let reference = [1.0, 0.0, 3.0, 1.0];
        let told = |run: [f64; 4]| agreement(&reference, Ok(run.to_vec()), &columns).to_string();
        assert_eq!(told(reference), "exact");
        assert_eq!(told([1.0, 0.0, 3.0_f64.next_up(), 1.0]), "WRONG, differs by up to 1.48e-16, first in `a`");
        // Its bits differ, its value does not.
        let zeros = agreement(&[0.0, 1.0], Ok(vec![-0.0, 1.0]), &columns).to_string();
        assert_eq!(zeros, "WRONG, 0 in one run and -0 in the other, first in `a`");
        assert_eq!(told([1.0, 1.0, 3.0, 1.0]), "WRONG, true in one run and false in the other, first in `b`");
        let truth = told([1.0, 1.0, 3.3, 1.0]);
        let both = "WRONG, true in one run and false in the other, first in `b`; a number differs by up to 1.00e-1";
        assert_eq!(truth, both);
        let none = "WRONG, a number in one run and none (NaN or infinite) in the other, first in `a`";
        assert_eq!(told([1.0, 0.0, NO_NUMBER, 1.0]), none);
        assert_eq!(
            told([1.0, 0.0, REFUSED, 1.0]),
            "WRONG, could be read in one run and not in the other, first in `a`"
        );
    }
}
