//! Rows of variables of many types: planned once, then one C call for each type and row, with no allocation.

use super::error::Error;
use super::instance::Instance;
use super::library::Slave;
use super::raw::Raw;
use super::values::sealed::Access;
use super::variable::{Handle, Scalar};

/// Which variables stand in which column of a row, sorted by type. All values travel as `f64`: booleans as 0 and 1,
/// whole numbers exactly up to 2^53 and cut off at the ends of their type's range.
///
/// An element of an array brings the whole array with it, as FMI 3.0 has no other way. Writing keeps the start values
/// of the elements that the plan does not name.
pub struct Plan {
    groups: Vec<Box<dyn Group>>,
    discrete: bool,
}

/// The columns of one type.
trait Group: Send {
    fn read(&mut self, raw: &mut Raw, row: &mut [f64]) -> Result<(), Error>;
    fn write(&mut self, raw: &mut Raw, row: &[f64]) -> Result<(), Error>;
}

struct Typed<T> {
    references: Vec<u32>,
    /// All values of the variables, in the order of the references.
    values: Vec<T>,
    /// Place among the values, and column.
    places: Vec<(usize, usize)>,
}

impl<T: Access> Typed<T> {
    /// The group of this type, if there are such handles.
    fn group(slave: &Slave, handles: &[Handle]) -> Option<Box<dyn Group>> {
        let mut group = Self { references: Vec::new(), values: Vec::new(), places: Vec::new() };
        let mut first_of: std::collections::BTreeMap<u32, usize> = std::collections::BTreeMap::new();
        for (column, handle) in handles.iter().enumerate().filter(|(_, h)| h.scalar == T::SCALAR) {
            let first = *first_of.entry(handle.value_reference).or_insert_with(|| {
                let (first, start) = (group.values.len(), slave.array_start(handle.value_reference));
                group.references.push(handle.value_reference);
                if start.len() == handle.count {
                    group.values.extend(start.iter().map(|v| T::from_f64(*v)));
                } else {
                    let all = start.first().map_or_else(T::default, |v| T::from_f64(*v));
                    group.values.resize(first + handle.count, all);
                }
                first
            });
            group.places.push((first + handle.offset, column));
        }
        (!group.places.is_empty()).then(|| Box::new(group) as Box<dyn Group>)
    }
}

impl<T: Access> Group for Typed<T> {
    fn read(&mut self, raw: &mut Raw, row: &mut [f64]) -> Result<(), Error> {
        T::read(raw, &self.references, &mut self.values)?;
        self.places.iter().for_each(|&(place, column)| row[column] = self.values[place].to_f64());
        Ok(())
    }

    fn write(&mut self, raw: &mut Raw, row: &[f64]) -> Result<(), Error> {
        self.places.iter().for_each(|&(place, column)| self.values[place] = T::from_f64(row[column]));
        T::write(raw, &self.references, &self.values)
    }
}

impl Plan {
    /// A plan for rows whose columns are `handles`, of instances of `slave`. Strings, binaries and clocks are no
    /// numbers: their columns are passed over. A plan either reads or writes.
    #[must_use]
    pub fn new(slave: &Slave, handles: &[Handle]) -> Self {
        let groups = [
            Typed::<f64>::group(slave, handles),
            Typed::<f32>::group(slave, handles),
            Typed::<i8>::group(slave, handles),
            Typed::<u8>::group(slave, handles),
            Typed::<i16>::group(slave, handles),
            Typed::<u16>::group(slave, handles),
            Typed::<i32>::group(slave, handles),
            Typed::<u32>::group(slave, handles),
            Typed::<i64>::group(slave, handles),
            Typed::<u64>::group(slave, handles),
            Typed::<bool>::group(slave, handles),
        ];
        let float = |h: &Handle| matches!(h.scalar, Scalar::Float64 | Scalar::Float32);
        let discrete = handles.iter().any(|h| h.discrete || !float(h));
        Self { groups: groups.into_iter().flatten().collect(), discrete }
    }

    /// Reads a row.
    ///
    /// # Errors
    /// When the FMU refuses.
    ///
    /// # Panics
    /// When the row is shorter than the plan.
    pub fn read<S>(&mut self, instance: &mut Instance<S>, row: &mut [f64]) -> Result<(), Error> {
        self.groups.iter_mut().try_for_each(|group| group.read(&mut instance.raw, row))
    }

    /// Writes a row. Where Event Mode is used and the row has values that change at events only, they are written in
    /// Event Mode.
    ///
    /// # Errors
    /// When the FMU refuses, or its events do not come to rest.
    ///
    /// # Panics
    /// When the row is shorter than the plan.
    pub fn write<S>(&mut self, instance: &mut Instance<S>, row: &[f64]) -> Result<(), Error> {
        let raw = &mut instance.raw;
        let event = self.discrete && raw.events && raw.stepping;
        if event {
            raw.enter_event_mode()?;
        }
        self.groups.iter_mut().try_for_each(|group| group.write(raw, row))?;
        if event { raw.settle() } else { Ok(()) }
    }
}
