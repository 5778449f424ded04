//! Values of variables, by value reference and exact type, over FMI 2.0 and FMI 3.0.
#![expect(unsafe_code, reason = "calls the C functions of a loaded FMU")]
#![expect(private_interfaces, reason = "the sealed trait cannot be reached from outside")]

use std::ffi::{CStr, c_char};
use std::ptr;

use super::abi2;
use super::error::Error;
use super::instance::Instance;
use super::library::Table;
use super::raw::Raw;
use super::variable::{Scalar, Variable};

/// A Rust type whose values travel to and from an FMU: `f64`, `f32`, the integers, `bool`. In FMI 2.0 only `f64`
/// (Real), `i32` (Integer and Enumeration) and `bool`.
pub trait Number: Access {}
impl<T: Access> Number for T {}

pub(super) mod sealed {
    use super::{Error, Raw, Scalar};

    /// How values of a type are read, written and turned into `f64`.
    pub trait Access: Copy + Default + Send + 'static {
        /// The type in the C interface.
        const SCALAR: Scalar;
        /// The nearest value: whole numbers are cut off at the ends of their range.
        fn from_f64(value: f64) -> Self;
        /// The value; whole numbers beyond 2^53 lose their last digits.
        fn to_f64(self) -> f64;
        /// All values of the variables with these references.
        #[doc(hidden)]
        fn read(raw: &mut Raw, references: &[u32], values: &mut [Self]) -> Result<(), Error>;
        /// All values of the variables with these references.
        #[doc(hidden)]
        fn write(raw: &mut Raw, references: &[u32], values: &[Self]) -> Result<(), Error>;
    }
}
use sealed::Access;

macro_rules! numbers {
    ($($type:ty, $scalar:ident, $get:ident, $set:ident, $third_get:literal, $third_set:literal
       $(, $get2:ident, $set2:ident, $second_get:literal, $second_set:literal)?;)*) => {$(
        impl Access for $type {
            const SCALAR: Scalar = Scalar::$scalar;

            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "documented: cut off")]
            fn from_f64(value: f64) -> Self {
                value as Self
            }

            #[allow(clippy::cast_precision_loss, clippy::cast_lossless, reason = "documented; one text for all types")]
            fn to_f64(self) -> f64 {
                self as f64
            }

            fn read(raw: &mut Raw, references: &[u32], values: &mut [Self]) -> Result<(), Error> {
                raw.callable()?;
                let (refs, n, to, count) = (references.as_ptr(), references.len(), values.as_mut_ptr(), values.len());
                match raw.slave.table() {
                    Table::V3(f) => {
                        let function = f.$get.ok_or(Error::MissingFunction($third_get))?;
                        // SAFETY: both arrays have the lengths that are passed, and the instance is alive.
                        let status = unsafe { function(raw.component, refs, n, to, count) };
                        raw.check($third_get, status)
                    }
                    $(Table::V2(f) => {
                        let function = f.$get2.ok_or(Error::MissingFunction($second_get))?;
                        assert_eq!(n, count, "FMI 2.0 has one value for each reference");
                        // SAFETY: both arrays have the length that is passed, and the instance is alive.
                        let status = unsafe { function(raw.component, refs, n, to) };
                        raw.check($second_get, status)
                    })?
                    #[allow(unreachable_patterns, reason = "the types that FMI 2.0 has are above")]
                    Table::V2(_) => Err(Error::NoSuchType(Self::SCALAR)),
                }
            }

            fn write(raw: &mut Raw, references: &[u32], values: &[Self]) -> Result<(), Error> {
                raw.callable()?;
                let (refs, n, from, count) = (references.as_ptr(), references.len(), values.as_ptr(), values.len());
                match raw.slave.table() {
                    Table::V3(f) => {
                        let function = f.$set.ok_or(Error::MissingFunction($third_set))?;
                        // SAFETY: both arrays have the lengths that are passed, and the instance is alive.
                        let status = unsafe { function(raw.component, refs, n, from, count) };
                        raw.check($third_set, status)
                    }
                    $(Table::V2(f) => {
                        let function = f.$set2.ok_or(Error::MissingFunction($second_set))?;
                        assert_eq!(n, count, "FMI 2.0 has one value for each reference");
                        // SAFETY: both arrays have the length that is passed, and the instance is alive.
                        let status = unsafe { function(raw.component, refs, n, from) };
                        raw.check($second_set, status)
                    })?
                    #[allow(unreachable_patterns, reason = "the types that FMI 2.0 has are above")]
                    Table::V2(_) => Err(Error::NoSuchType(Self::SCALAR)),
                }
            }
        }
    )*};
}

numbers! {
    f64, Float64, get_float64, set_float64, "fmi3GetFloat64", "fmi3SetFloat64",
        get_real, set_real, "fmi2GetReal", "fmi2SetReal";
    f32, Float32, get_float32, set_float32, "fmi3GetFloat32", "fmi3SetFloat32";
    i8, Int8, get_int8, set_int8, "fmi3GetInt8", "fmi3SetInt8";
    u8, UInt8, get_uint8, set_uint8, "fmi3GetUInt8", "fmi3SetUInt8";
    i16, Int16, get_int16, set_int16, "fmi3GetInt16", "fmi3SetInt16";
    u16, UInt16, get_uint16, set_uint16, "fmi3GetUInt16", "fmi3SetUInt16";
    i32, Int32, get_int32, set_int32, "fmi3GetInt32", "fmi3SetInt32",
        get_integer, set_integer, "fmi2GetInteger", "fmi2SetInteger";
    u32, UInt32, get_uint32, set_uint32, "fmi3GetUInt32", "fmi3SetUInt32";
    i64, Int64, get_int64, set_int64, "fmi3GetInt64", "fmi3SetInt64";
    u64, UInt64, get_uint64, set_uint64, "fmi3GetUInt64", "fmi3SetUInt64";
}

impl Access for bool {
    const SCALAR: Scalar = Scalar::Boolean;

    fn from_f64(value: f64) -> Self {
        value != 0.0
    }

    fn to_f64(self) -> f64 {
        f64::from(u8::from(self))
    }

    // FMI 2.0's booleans are integers, FMI 3.0's are bytes that should be 0 or 1: neither is read into a Rust `bool`.
    fn read(raw: &mut Raw, references: &[u32], values: &mut [Self]) -> Result<(), Error> {
        raw.callable()?;
        let n = references.len();
        match raw.slave.table() {
            Table::V2(f) => {
                assert_eq!(n, values.len(), "FMI 2.0 has one value for each reference");
                let function = f.get_boolean.ok_or(Error::MissingFunction("fmi2GetBoolean"))?;
                raw.integers.clear();
                raw.integers.resize(n, abi2::FALSE);
                // SAFETY: both arrays have the length that is passed, and the instance is alive.
                let status = unsafe { function(raw.component, references.as_ptr(), n, raw.integers.as_mut_ptr()) };
                raw.check("fmi2GetBoolean", status)?;
                values.iter_mut().zip(&raw.integers).for_each(|(v, n)| *v = *n != abi2::FALSE);
            }
            Table::V3(f) => {
                let function = f.get_boolean.ok_or(Error::MissingFunction("fmi3GetBoolean"))?;
                raw.bytes.clear();
                raw.bytes.resize(values.len(), 0);
                let (bytes, count) = (raw.bytes.as_mut_ptr(), values.len());
                // SAFETY: both arrays have the lengths that are passed, and the instance is alive.
                let status = unsafe { function(raw.component, references.as_ptr(), n, bytes, count) };
                raw.check("fmi3GetBoolean", status)?;
                values.iter_mut().zip(&raw.bytes).for_each(|(v, n)| *v = *n != 0);
            }
        }
        Ok(())
    }

    fn write(raw: &mut Raw, references: &[u32], values: &[Self]) -> Result<(), Error> {
        raw.callable()?;
        let n = references.len();
        match raw.slave.table() {
            Table::V2(f) => {
                assert_eq!(n, values.len(), "FMI 2.0 has one value for each reference");
                let function = f.set_boolean.ok_or(Error::MissingFunction("fmi2SetBoolean"))?;
                raw.integers.clear();
                raw.integers.extend(values.iter().map(|v| if *v { abi2::TRUE } else { abi2::FALSE }));
                // SAFETY: both arrays have the length that is passed, and the instance is alive.
                let status = unsafe { function(raw.component, references.as_ptr(), n, raw.integers.as_ptr()) };
                raw.check("fmi2SetBoolean", status)
            }
            Table::V3(f) => {
                let function = f.set_boolean.ok_or(Error::MissingFunction("fmi3SetBoolean"))?;
                raw.bytes.clear();
                raw.bytes.extend(values.iter().map(|v| u8::from(*v)));
                let (bytes, count) = (raw.bytes.as_ptr(), values.len());
                // SAFETY: both arrays have the lengths that are passed, and the instance is alive.
                let status = unsafe { function(raw.component, references.as_ptr(), n, bytes, count) };
                raw.check("fmi3SetBoolean", status)
            }
        }
    }
}

/// All values of one variable.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Of a floating point type.
    Real(Vec<f64>),
    /// Of an integer type or an enumeration.
    Integer(Vec<i128>),
    /// Booleans.
    Boolean(Vec<bool>),
    /// Texts.
    String(Vec<String>),
    /// Bytes.
    Binary(Vec<Vec<u8>>),
    /// Whether the clock ticks.
    Clock(bool),
}

macro_rules! scalars {
    ($get:ident, $set:ident, $type:ty, $names:literal) => {
        #[doc = concat!("`", $names, "`: values of the scalar variables with these references, in their order.")]
        ///
        /// # Errors
        /// When the FMU refuses.
        pub fn $get(&mut self, references: &[u32], values: &mut [$type]) -> Result<(), Error> {
            assert_eq!(references.len(), values.len(), "one value for each reference");
            self.get(references, values)
        }

        #[doc = concat!("The counterpart of [`Instance::", stringify!($get), "`].")]
        ///
        /// # Errors
        /// When the FMU refuses.
        pub fn $set(&mut self, references: &[u32], values: &[$type]) -> Result<(), Error> {
            assert_eq!(references.len(), values.len(), "one value for each reference");
            self.set(references, values)
        }
    };
}

impl<S> Instance<S> {
    scalars!(get_real, set_real, f64, "fmi2GetReal` or `fmi3GetFloat64");
    scalars!(get_integer, set_integer, i32, "fmi2GetInteger` or `fmi3GetInt32");
    scalars!(get_boolean, set_boolean, bool, "fmi2GetBoolean` or `fmi3GetBoolean");

    /// Values of variables that are exactly of type `T`: all values of each, arrays row by row.
    ///
    /// # Errors
    /// When the FMU refuses, or FMI 2.0 has no such type.
    pub fn get<T: Number>(&mut self, references: &[u32], values: &mut [T]) -> Result<(), Error> {
        T::read(&mut self.raw, references, values)
    }

    /// Sets the same.
    ///
    /// # Errors
    /// As [`Instance::get`].
    pub fn set<T: Number>(&mut self, references: &[u32], values: &[T]) -> Result<(), Error> {
        T::write(&mut self.raw, references, values)
    }

    /// The `count` texts of one variable. What is not UTF-8 is replaced.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn get_string(&mut self, reference: u32, count: usize) -> Result<Vec<String>, Error> {
        let raw = &mut self.raw;
        raw.callable()?;
        let mut texts: Vec<*const c_char> = vec![ptr::null(); count];
        let (name, status) = match raw.slave.table() {
            Table::V2(f) => {
                assert_eq!(count, 1, "FMI 2.0 has one value for each reference");
                let function = f.get_string.ok_or(Error::MissingFunction("fmi2GetString"))?;
                // SAFETY: one reference and room for one pointer, and the instance is alive.
                ("fmi2GetString", unsafe { function(raw.component, &raw const reference, 1, texts.as_mut_ptr()) })
            }
            Table::V3(f) => {
                let function = f.get_string.ok_or(Error::MissingFunction("fmi3GetString"))?;
                let (texts, reference) = (texts.as_mut_ptr(), &raw const reference);
                // SAFETY: one reference and room for `count` pointers, and the instance is alive.
                ("fmi3GetString", unsafe { function(raw.component, reference, 1, texts, count) })
            }
        };
        raw.check(name, status)?;
        let copy = |text: &*const c_char| {
            if text.is_null() {
                return String::new();
            }
            // SAFETY: not NULL, NUL-terminated by the standard, and alive until the next call on the instance.
            unsafe { CStr::from_ptr(*text) }.to_string_lossy().into_owned()
        };
        Ok(texts.iter().map(copy).collect())
    }

    /// `fmi3GetBinary`: the `count` values of one variable.
    ///
    /// # Errors
    /// When the FMU refuses, or is one of FMI 2.0.
    pub fn get_binary(&mut self, reference: u32, count: usize) -> Result<Vec<Vec<u8>>, Error> {
        const NAME: &str = "fmi3GetBinary";
        let raw = &mut self.raw;
        raw.callable()?;
        let Table::V3(f) = raw.slave.table() else { return Err(Error::NoSuchType(Scalar::Binary)) };
        let function = f.get_binary.ok_or(Error::MissingFunction(NAME))?;
        let (mut sizes, mut values) = (vec![0_usize; count], vec![ptr::null::<u8>(); count]);
        let (sizes_at, values_at) = (sizes.as_mut_ptr(), values.as_mut_ptr());
        // SAFETY: one reference, room for `count` sizes and pointers, and the instance is alive.
        let status = unsafe { function(raw.component, &raw const reference, 1, sizes_at, values_at, count) };
        raw.check(NAME, status)?;
        let copy = |(value, size): (&*const u8, &usize)| {
            if value.is_null() || *size == 0 {
                return Vec::new();
            }
            // SAFETY: not NULL, of this size by the standard, and alive until the next call on the instance.
            unsafe { std::slice::from_raw_parts(*value, *size) }.to_vec()
        };
        Ok(values.iter().zip(&sizes).map(copy).collect())
    }

    /// `fmi3GetClock`: whether a clock ticks. Between steps none does; some FMUs refuse to answer there.
    ///
    /// # Errors
    /// When the FMU refuses, or is one of FMI 2.0.
    pub fn get_clock(&mut self, reference: u32) -> Result<bool, Error> {
        const NAME: &str = "fmi3GetClock";
        let raw = &mut self.raw;
        raw.callable()?;
        let Table::V3(f) = raw.slave.table() else { return Err(Error::NoSuchType(Scalar::Clock)) };
        let function = f.get_clock.ok_or(Error::MissingFunction(NAME))?;
        let mut ticks = 0;
        // SAFETY: one reference and room for one value, and the instance is alive.
        let status = unsafe { function(raw.component, &raw const reference, 1, &raw mut ticks) };
        raw.check(NAME, status)?;
        Ok(ticks != 0)
    }

    /// All `count` values of a variable ([`ModelDescription::count`](super::ModelDescription::count)), whatever its
    /// type.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub fn values(&mut self, variable: &Variable, count: usize) -> Result<Values, Error> {
        let reference = variable.value_reference;
        let wide = |values: Vec<f32>| Values::Real(values.into_iter().map(f64::from).collect());
        Ok(match variable.scalar {
            Scalar::Float64 => Values::Real(self.all(reference, count)?),
            Scalar::Float32 => wide(self.all(reference, count)?),
            Scalar::Int8 => self.whole::<i8>(reference, count)?,
            Scalar::UInt8 => self.whole::<u8>(reference, count)?,
            Scalar::Int16 => self.whole::<i16>(reference, count)?,
            Scalar::UInt16 => self.whole::<u16>(reference, count)?,
            Scalar::Int32 => self.whole::<i32>(reference, count)?,
            Scalar::UInt32 => self.whole::<u32>(reference, count)?,
            Scalar::Int64 => self.whole::<i64>(reference, count)?,
            Scalar::UInt64 => self.whole::<u64>(reference, count)?,
            Scalar::Boolean => Values::Boolean(self.all(reference, count)?),
            Scalar::String => Values::String(self.get_string(reference, count)?),
            Scalar::Binary => Values::Binary(self.get_binary(reference, count)?),
            Scalar::Clock => Values::Clock(self.get_clock(reference)?),
        })
    }

    fn all<T: Number>(&mut self, reference: u32, count: usize) -> Result<Vec<T>, Error> {
        let mut values = vec![T::default(); count];
        self.get(&[reference], &mut values)?;
        Ok(values)
    }

    fn whole<T: Number + Into<i128>>(&mut self, reference: u32, count: usize) -> Result<Values, Error> {
        Ok(Values::Integer(self.all::<T>(reference, count)?.into_iter().map(Into::into).collect()))
    }
}
