//! What an FMU gets from its own start to a hazard, as CSV that other tools simulate with (FMPy: `--input-file`), and what it answers.

use fmi_hazard_record::hazard::Hazard;

/// Inputs and outputs of the only FMU over a sequence.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// Communication step, s.
    pub step_s: f64,
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// Names of the outputs.
    pub outputs: Vec<String>,
    /// Inputs at the start of each step, one row a step.
    pub given: Vec<Vec<f64>>,
    /// Outputs after each step, one row a step.
    pub answered: Vec<Vec<f64>>,
    /// The steps before the person begins: what was given at the start of each, what was answered after it.
    pub before: Vec<(Vec<f64>, Vec<f64>)>,
}

impl Trace {
    /// The inputs: a row for each step at the time at which it begins, and the last one again at the end.
    ///
    /// # Errors
    /// Never: it is written to memory.
    pub fn input_table(&self) -> Result<String, ::csv::Error> {
        let ends = self.given.last().cloned();
        let before = self.before.iter().map(|(given, _)| given);
        self.table(&self.inputs, before.chain(&self.given).cloned().chain(ends), 0)
    }

    /// The outputs: a row for each step at the time at which it ends.
    ///
    /// # Errors
    /// Never: it is written to memory.
    pub fn output_table(&self) -> Result<String, ::csv::Error> {
        let before = self.before.iter().map(|(_, answered)| answered);
        self.table(&self.outputs, before.chain(&self.answered).cloned(), 1)
    }

    fn table(
        &self,
        names: &[String],
        rows: impl Iterator<Item = Vec<f64>>,
        first: u32,
    ) -> Result<String, ::csv::Error> {
        let mut to = ::csv::Writer::from_writer(Vec::new());
        to.write_record(std::iter::once("time").chain(names.iter().map(String::as_str)))?;
        for (step, row) in (first..).zip(rows) {
            // A product, as the master forms it, not a sum.
            let time = f64::from(step) * self.step_s;
            to.write_record(std::iter::once(time).chain(row).map(|value| value.to_string()))?;
        }
        Ok(String::from_utf8_lossy(&to.into_inner().map_err(|e| e.into_error())?).into_owned())
    }
}

/// Name of the file with the inputs.
#[must_use]
pub fn input_file(hazard: &Hazard) -> String {
    format!("{}.inputs.csv", hazard.id)
}

/// Name of the file with the outputs.
#[must_use]
pub fn output_file(hazard: &Hazard) -> String {
    format!("{}.outputs.csv", hazard.id)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three steps of half a second, one of them before the person begins.
    #[test]
    fn inputs_are_told_when_a_step_begins_and_outputs_when_it_ends() {
        let trace = Trace {
            step_s: 0.5,
            inputs: vec!["given".to_owned()],
            outputs: vec!["answered".to_owned()],
            given: vec![vec![2.0], vec![3.0]],
            answered: vec![vec![20.0], vec![30.0]],
            before: vec![(vec![1.0], vec![10.0])],
        };
        assert_eq!(trace.input_table().unwrap(), "time,given\n0,1\n0.5,2\n1,3\n1.5,3\n");
        assert_eq!(trace.output_table().unwrap(), "time,answered\n0.5,10\n1,20\n1.5,30\n");
    }
}
