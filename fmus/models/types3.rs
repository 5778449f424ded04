//! `types3`: the values of all types that FMI 3.0 knows, around the joint of the faulty model without any fault.
//!
//! The joint is an ordinary [`Component`], which also keeps the mode and the time; here is only what it cannot hold.

use crate::bytes::{Reader, Writer};
use crate::component::{Answer, Component, Mode, error};
use crate::interface::faulty;
use crate::interface::types3::{LEVELS, SIZE, TYPES, token, vr};
use crate::interface::variables::{Value, Variant};
use std::ffi::CString;

/// A Rust number type that a variable can have.
pub trait Number: Copy {
    /// The number as a value.
    fn wrap(self) -> Datum;

    /// The number in a value of just this type.
    fn unwrap(datum: &Datum) -> Option<Self>;
}

/// Makes the type of values from the list of number types, since all of these are handled alike.
macro_rules! datum {
    ($($variant:ident $number:ty),*) => {
        /// A value of any type. Enumerations are `Int64`, as in the C interface.
        #[derive(Debug, Clone, PartialEq)]
        #[allow(missing_docs, reason = "named like the types of the standard")]
        pub enum Datum { $($variant($number),)* Boolean(bool), String(CString), Binary(Vec<u8>), Clock(bool) }

        $(impl Number for $number {
            fn wrap(self) -> Datum {
                Datum::$variant(self)
            }

            fn unwrap(datum: &Datum) -> Option<Self> {
                if let Datum::$variant(number) = datum { Some(*number) } else { None }
            }
        })*

        impl Datum {
            /// The start value of a type; None only if the table is wrong.
            fn start(kind: &str, text: &str) -> Option<Self> {
                match kind {
                    $(stringify!($variant) => text.parse().ok().map(Datum::$variant),)*
                    "Boolean" => text.parse().ok().map(Datum::Boolean),
                    "String" => CString::new(text).ok().map(Datum::String),
                    "Binary" => (0..text.len() / 2)
                        .map(|byte| u8::from_str_radix(text.get(2 * byte..2 * byte + 2)?, 16).ok())
                        .collect::<Option<_>>()
                        .map(Datum::Binary),
                    "Enumeration" => text.parse().ok().map(Datum::Int64),
                    "Clock" => Some(Datum::Clock(false)),
                    _ => None,
                }
            }

            fn write(&self, out: &mut Writer) {
                match self {
                    $(Datum::$variant(number) => out.0.extend_from_slice(&number.to_le_bytes()),)*
                    Datum::Boolean(x) | Datum::Clock(x) => out.bool(*x),
                    Datum::String(text) => out.bytes(text.as_bytes()),
                    Datum::Binary(bytes) => out.bytes(bytes),
                }
            }

            /// Reads a value of the type that is there now.
            fn read(&mut self, input: &mut Reader) -> Option<()> {
                match self {
                    $(Datum::$variant(number) => *number = <$number>::from_le_bytes(input.take()?),)*
                    Datum::Boolean(x) | Datum::Clock(x) => *x = input.bool()?,
                    Datum::String(text) => *text = CString::new(input.bytes()?).ok()?,
                    Datum::Binary(bytes) => *bytes = input.bytes()?.to_vec(),
                }
                Some(())
            }
        }
    };
}
datum!(
    Float32 f32, Float64 f64, Int8 i8, UInt8 u8, Int16 i16, UInt16 u16, Int32 i32, UInt32 u32, Int64 i64, UInt64 u64
);

impl From<Value> for Datum {
    fn from(value: Value) -> Self {
        match value {
            Value::Real(x) => Datum::Float64(x),
            Value::Integer(n) => Datum::Int32(n),
            Value::Boolean(x) => Datum::Boolean(x),
        }
    }
}

impl Datum {
    /// The value as an ordinary model knows it.
    pub fn value(&self) -> Option<Value> {
        match *self {
            Datum::Float64(x) => Some(Value::Real(x)),
            Datum::Int32(n) => Some(Value::Integer(n)),
            Datum::Boolean(x) => Some(Value::Boolean(x)),
            _ => None,
        }
    }
}

/// The inputs, the parameters and the size: all else follows from these and the joint.
#[derive(Debug, Clone, PartialEq)]
pub struct Types3 {
    inputs: Vec<Datum>,
    parameters: Vec<Datum>,
    n: u64,
}

/// What receives the values of a variable one by one.
pub type Sink<'a> = &'a mut dyn FnMut(&Datum) -> Answer;

impl Types3 {
    /// The start values.
    pub fn new() -> Self {
        let start: Vec<_> = TYPES.iter().filter_map(|(kind, text)| Datum::start(kind, text)).collect();
        Self { inputs: start.clone(), parameters: start, n: SIZE.0 }
    }

    /// The joint that goes with it.
    pub fn joint() -> Answer<Component> {
        Component::new(&faulty::interface(Variant::Faithful).guid())
    }

    /// Gives the values of a variable to `sink`.
    pub fn get(&self, joint: &mut Component, reference: usize, sink: Sink) -> Answer {
        if reference == vr::N {
            return sink(&Datum::UInt64(self.n));
        }
        joint.expect_readable()?;
        let mut of_joint = |place: usize| joint.get(u32::try_from(place).unwrap_or(u32::MAX)).map(Datum::from);
        match reference {
            vr::TIME => sink(&of_joint(0)?),
            vr::STOP => sink(&of_joint(faulty::vr::STOP)?),
            vr::Q => sink(&of_joint(faulty::vr::Q)?),
            vr::QD => sink(&of_joint(faulty::vr::QD)?),
            vr::FIXED_ARRAY => {
                sink(&of_joint(faulty::vr::Q)?)?;
                sink(&of_joint(faulty::vr::QD)?)?;
                sink(&self.inputs[1])
            }
            vr::SIZED_ARRAY => {
                let Datum::Float64(q) = of_joint(faulty::vr::Q)? else { return error("the joint has no angle") };
                #[expect(clippy::cast_precision_loss, reason = "at most 64")]
                (1..=self.n).try_for_each(|k| sink(&Datum::Float64(k as f64 * q)))
            }
            _ => match place_of(reference)? {
                (kind, 0 | 1) => sink(&self.inputs[kind]),
                (kind, _) => sink(&self.parameters[kind]),
            },
        }
    }

    /// Sets a variable that is not an array.
    pub fn set(&mut self, joint: &mut Component, reference: usize, datum: Datum) -> Answer {
        if reference == vr::N {
            return match datum {
                _ if joint.mode() != Mode::Configuring => error("n can be set in configuration mode only"),
                Datum::UInt64(n) if (1..=SIZE.1).contains(&n) => {
                    self.n = n;
                    Ok(())
                }
                _ => error(format!("n cannot be set to {datum:?}: it is a UInt64 from 1 to {}", SIZE.1)),
            };
        }
        joint.expect_settable()?;
        if reference == vr::STOP {
            return match datum.value() {
                Some(value) => joint.set(u32::try_from(faulty::vr::STOP).unwrap_or(u32::MAX), value),
                None => error("stop is a Boolean"),
            };
        }
        let computed = || error(format!("value reference {reference} is computed by the model and cannot be set"));
        if [vr::TIME, vr::Q, vr::QD, vr::FIXED_ARRAY, vr::SIZED_ARRAY].contains(&reference) {
            return computed();
        }
        let (kind, role) = place_of(reference)?;
        let slot = match role {
            0 => &mut self.inputs[kind],
            2 => &mut self.parameters[kind],
            _ => return computed(),
        };
        if std::mem::discriminant(slot) != std::mem::discriminant(&datum) {
            return error(format!("value reference {reference} has another type: it is {}", TYPES[kind].0));
        }
        if TYPES[kind].0 == "Enumeration"
            && !matches!(datum, Datum::Int64(n) if usize::try_from(n).is_ok_and(|n| (1..=LEVELS.len()).contains(&n)))
        {
            return error(format!("{datum:?} is not a value of the enumeration"));
        }
        if role == 2 && !joint.takes_parameters() && *slot != datum {
            return error(format!(
                "value reference {reference} is a fixed parameter and cannot change after initialisation"
            ));
        }
        *slot = datum;
        Ok(())
    }

    /// Clocks tick for one event only.
    pub fn stop_clocks(&mut self) {
        for slot in &mut self.inputs {
            if let Datum::Clock(ticks) = slot {
                *ticks = false;
            }
        }
    }

    /// All fields and the joint's state, as bytes.
    pub fn serialize(&self, joint: &[u8]) -> Vec<u8> {
        let mut out = Writer::default();
        out.0.extend_from_slice(token().as_bytes());
        out.u64(self.n);
        for slot in self.inputs.iter().chain(&self.parameters) {
            slot.write(&mut out);
        }
        out.0.extend_from_slice(joint);
        out.0
    }

    /// The fields in these bytes, and the bytes of the joint's state.
    pub fn deserialize(bytes: &[u8]) -> Answer<(Self, &[u8])> {
        let Some(rest) = bytes.strip_prefix(token().as_bytes()) else {
            return error("the bytes are not a state of this model");
        };
        let mut input = Reader(rest);
        let mut read = Self::new();
        let mut fill = || {
            read.n = input.u64().filter(|n| (1..=SIZE.1).contains(n))?;
            read.inputs.iter_mut().chain(&mut read.parameters).try_for_each(|slot| slot.read(&mut input))
        };
        match fill() {
            Some(()) => Ok((read, input.0)),
            None => error("the bytes are a damaged state of this model"),
        }
    }
}

/// The places of a variable's type and role.
fn place_of(reference: usize) -> Answer<(usize, usize)> {
    let all = || (0..TYPES.len()).flat_map(|kind| (0..4).map(move |role| (kind, role)));
    match all().find(|&(kind, role)| vr::of(kind, role) == reference) {
        Some((kind, role)) if (TYPES[kind].0, role) != ("Clock", 2) => Ok((kind, role)),
        _ => error(format!("this model has no value reference {reference}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_gives_each_type_its_start_value() {
        let start = Types3::new().inputs;
        assert_eq!(start.len(), TYPES.len());
        assert_eq!(start[0], Datum::Float32(0.5));
        assert_eq!(start[8], Datum::Int64(-64));
        assert_eq!(start[11], Datum::String(c"start".to_owned()));
        assert_eq!(start[12], Datum::Binary(vec![0, 255, 16]));
    }

    #[test]
    fn bytes_carry_all_fields_and_damaged_ones_are_refused() {
        let mut model = Types3::new();
        model.n = 7;
        model.inputs[11] = Datum::String(c"other".to_owned());
        model.parameters[12] = Datum::Binary(vec![1; 300]);
        let bytes = model.serialize(b"joint");
        assert_eq!(Types3::deserialize(&bytes).unwrap(), (model, &b"joint"[..]));
        assert!(Types3::deserialize(&bytes[..100]).is_err(), "cut short");
        let mut huge = bytes.clone();
        huge[38..46].fill(0xff);
        assert!(Types3::deserialize(&huge).is_err(), "a size out of bounds");
        assert!(Types3::deserialize(b"other").is_err());
    }
}
