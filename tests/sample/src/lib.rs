//! Which part of many random cases a run of the tests looks at: all of them would take longer than anybody waits. Unit tests and
//! integration tests of all crates use it alike.
//!
//! The cases themselves are always the same, drawn from fixed seeds. `FMI_HAZARD_SAMPLE` is a number, which `tools/test` takes from the
//! commit and prints, so that another commit looks at other cases and a run can be repeated; or `all`, as in `tools/test --all`. Without
//! it the number is 0.

pub mod meshes;

/// The number of this run, or none where all cases are looked at.
fn sample() -> Option<usize> {
    match std::env::var("FMI_HAZARD_SAMPLE") {
        Ok(all) if all == "all" => None,
        Ok(number) => Some(number.parse().expect("FMI_HAZARD_SAMPLE is a number or `all`")),
        Err(_) => Some(0),
    }
}

/// Whether all cases are looked at.
#[must_use]
pub fn is_whole() -> bool {
    sample().is_none()
}

/// Whether this case is looked at, when one of `parts` is. It does not go by the sample alone, as turns do: so each test that takes turns
/// of 2, 3, 4, 6 or 12 looks at all of its cases within sixty samples, as long as they are in 5 parts at most.
#[must_use]
pub fn takes(case: usize, parts: usize) -> bool {
    sample().is_none_or(|sample| case % parts == (sample + sample / 12) % parts)
}

/// Those of the cases that are looked at: one of `parts`, beginning anywhere.
pub fn some<T>(cases: impl IntoIterator<Item = T>, parts: usize) -> impl Iterator<Item = T> {
    cases.into_iter().enumerate().filter(move |(case, _)| takes(*case, parts)).map(|(_, one)| one)
}

/// How many cases there are at least of `cases`, when one of `parts` is looked at: what a test asks for that counts what it met.
#[must_use]
pub fn least(cases: usize, parts: usize) -> usize {
    if is_whole() { cases } else { cases / parts }
}

/// Whether it is the turn of this one of `parts` tests: they take long, and what one of them shows others show as well, of another kind.
#[must_use]
pub fn is_turn(test: usize, parts: usize) -> bool {
    sample().is_none_or(|sample| test % parts == sample % parts)
}
