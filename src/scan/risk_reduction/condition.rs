//! Where and when the person begins while a change is tried, and for how long: from the start that the hazard is about, from
//! the cell's other beginnings, from beside the start, for longer than the cell says, and from where other hazards of the scan
//! begin.

use toml::{Table, Value};

use crate::cell::Workcell;
use crate::record::begin::InitialConditionRecord;
use crate::record::hazard::Hazard;
use crate::scan::prepare::Prepared;

/// Where a sequence begins, and how many actions it may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TrialCondition {
    /// Which of the cell's beginnings, from 0.
    pub beginning: usize,
    /// How far off its start, m to the front and to the left, and how much the person is turned to the left, degrees.
    pub beside: [f64; 3],
    /// Actions more than the cell says.
    pub more: u32,
    /// Where and when instead, and for how many actions: where another hazard has a beginning of its own.
    pub elsewhere: Option<(InitialConditionRecord, u32)>,
}

/// Places beside a start, m to the front and to the left, and turns to the left, degrees: within 5 cm, and off the grid that
/// the walks from the start are on.
const AROUND: [[f64; 3]; 8] = [
    [0.0, 0.03, 0.0],
    [0.0, -0.03, 0.0],
    [0.0, 0.05, 0.0],
    [0.0, -0.05, 0.0],
    [0.031, 0.039, 7.0],
    [0.031, -0.039, -7.0],
    [-0.043, 0.023, -11.0],
    [-0.043, -0.023, 11.0],
];

impl TrialCondition {
    /// The beginning that a prepared cell is about.
    pub(crate) fn own(prepared: &Prepared) -> Self {
        Self { beginning: prepared.cell.beginning, beside: [0.0; 3], more: 0, elsewhere: None }
    }

    /// Where a hazard begins, of a scan whose hazards begin where each of them says; seen from where `own` does, which is about
    /// another of them. Nothing if one of the two begins where the scan did, and the other does not.
    pub(crate) fn of_hazard(self, own: Option<InitialConditionRecord>, hazard: &Hazard) -> Option<Self> {
        match (own, hazard.begins) {
            (own, begins) if own == begins => Some(self),
            (Some(_), Some(begins)) => {
                let longest = hazard.actions.len().max(hazard.shortest.actions.len());
                Some(Self { elsewhere: Some((begins, u32::try_from(longest).ok()?)), ..self })
            }
            _ => None,
        }
    }

    /// The cell's other beginnings, then places around the own start.
    pub(crate) fn others(prepared: &Prepared) -> (Vec<Self>, Vec<Self>) {
        let own = Self::own(prepared);
        let all = 0..prepared.cell.beginnings.len();
        let other = all.filter(|number| *number != own.beginning).map(|beginning| Self { beginning, ..own });
        (other.collect(), AROUND.map(|beside| Self { beside, ..own }).to_vec())
    }

    /// The same for so many actions more.
    pub(crate) fn longer(self, more: u32) -> Self {
        Self { more, ..self }
    }

    /// The cell file with the person there; nothing if the file is not as expected.
    fn text(&self, table: &Table, actions: u32) -> Option<String> {
        let mut table = table.clone();
        if let Some((begin, actions)) = self.elsewhere {
            begin_at(&mut table, begin, actions)?;
        }
        if self.beside != [0.0; 3] {
            let human = first_human(&mut table)?;
            let others = human.get("other_starts").and_then(Value::as_array).map_or(0, Vec::len);
            let start = match self.beginning % (1 + others) {
                0 => human.get_mut("start")?,
                other => human.get_mut("other_starts")?.as_array_mut()?.get_mut(other - 1)?,
            };
            let start = start.as_table_mut()?;
            let [ahead, left, turn] = self.beside;
            let heading = number(start.get("heading_deg")?)?;
            let (sin, cos) = libm::sincos(heading.to_radians());
            let xy = start.get_mut("xy_m")?.as_array_mut()?;
            for (value, off) in xy.iter_mut().zip([cos * ahead - sin * left, sin * ahead + cos * left]) {
                // To the nanometre: written as people would.
                *value = (((number(value)? + off) * 1e9).round() / 1e9).into();
            }
            start.insert("heading_deg".to_owned(), (heading + turn).into());
        }
        if self.more > 0 {
            let search = table.entry("search").or_insert_with(|| Value::Table(Table::new())).as_table_mut()?;
            search.insert("actions".to_owned(), i64::from((actions + self.more).min(MOST_ACTIONS)).into());
        }
        toml::to_string(&table).ok()
    }

    /// The cell with the person there.
    ///
    /// # Errors
    /// When it is none, or the person has no room there.
    pub(crate) fn of(&self, prepared: &Prepared, table: &Table) -> Result<Prepared, String> {
        let text = self.text(table, prepared.cell.search.actions).ok_or("the cell file cannot be changed so")?;
        let changed = prepared.changed(&text).map_err(|error| error.to_string())?;
        if changed.cell.beginning == self.beginning {
            return Ok(changed);
        }
        changed.beginning(self.beginning).map_err(|error| error.to_string())
    }
}

/// The cell file with each start of its start areas by itself: so a change of the cell leaves them what they are. Nothing if
/// the file is not as expected.
pub(super) fn with_each_start(mut table: Table, cell: &Workcell) -> Option<Table> {
    let human = first_human(&mut table)?;
    if human.remove("start_area").is_some() {
        let mut starts = cell.starts.iter().map(|start| {
            let xy_m = start.xy_m.map(Value::Float).to_vec();
            Value::Table(Table::from_iter([
                ("xy_m".to_owned(), Value::Array(xy_m)),
                ("heading_deg".to_owned(), start.heading_deg.into()),
            ]))
        });
        human.insert("start".to_owned(), starts.next()?);
        human.insert("other_starts".to_owned(), Value::Array(starts.collect()));
    }
    Some(table)
}

/// The table of the person, or of the first of two.
fn first_human(table: &mut Table) -> Option<&mut Table> {
    match table.get_mut("human")? {
        Value::Table(human) => Some(human),
        Value::Array(people) => people.first_mut()?.as_table_mut(),
        _ => None,
    }
}

/// Writes the only beginning into a cell file, and for how many actions. Nothing if the file is not as expected.
pub(super) fn begin_at(table: &mut Table, begin: InitialConditionRecord, actions: u32) -> Option<()> {
    let human = first_human(table)?;
    human.remove("start_area");
    human.remove("other_starts");
    let xy_m = Value::Array(begin.xy_m.map(Value::Float).to_vec());
    let start = Table::from_iter([("xy_m".to_owned(), xy_m), ("heading_deg".to_owned(), begin.heading_deg.into())]);
    human.insert("start".to_owned(), Value::Table(start));
    human.insert("begins_s".to_owned(), Value::Array(vec![begin.begins_s.into()]));
    let search = table.entry("search").or_insert_with(|| Value::Table(Table::new())).as_table_mut()?;
    search.insert("actions".to_owned(), i64::from(actions).into());
    Some(())
}

/// Most actions that a cell file may ask for.
pub(super) const MOST_ACTIONS: u32 = 64;

#[expect(clippy::cast_precision_loss, reason = "a person wrote it")]
fn number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_start_that_a_beginning_has_is_moved() {
        let table: Table = "[human]\nstart = { xy_m = [1, 2.5], heading_deg = 90 }\nother_starts = [{ xy_m = [3, 4], \
                            heading_deg = 0 }]\nbegins_s = [0, 1]"
            .parse()
            .expect("it is TOML");
        let at = |beginning| {
            let text = TrialCondition { beginning, beside: [0.25, -0.5, 7.0], more: 3, elsewhere: None }
                .text(&table, 8)
                .expect("it can be changed");
            text.parse::<Table>().expect("it is TOML")
        };
        let [first, second] = [at(2), at(3)];
        assert_eq!(first["human"]["start"]["xy_m"], Value::Array(vec![1.5.into(), 2.75.into()]));
        assert_eq!(first["human"]["start"]["heading_deg"].as_float(), Some(97.0));
        assert_eq!(first["human"]["other_starts"], table["human"]["other_starts"]);
        assert_eq!(second["human"]["start"], table["human"]["start"]);
        assert_eq!(second["human"]["other_starts"][0]["xy_m"], Value::Array(vec![3.25.into(), 3.5.into()]));
        assert_eq!(second["search"]["actions"].as_integer(), Some(11));
    }
}
