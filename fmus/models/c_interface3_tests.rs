//! The C interface of FMI 3.0 from the importer's side: a whole life, refusals, each fault, and all types.
#![expect(unsafe_code, reason = "calls the C interface")]

use crate::fmi2;
use crate::fmi3::*;
use crate::interface::variables::{Interface, Variant};
use crate::interface::{faulty, safety_fence, types3, workcell};
use std::ffi::{CStr, CString, c_char, c_void};
use std::ptr::{null, null_mut};
use std::sync::Mutex;

fn fence() -> Interface {
    workcell::interface(&safety_fence::SPEC, Variant::Faithful).0
}

/// Places in the table of the safety fence.
mod place {
    pub const PHASE0: usize = 4;
    pub const GUARD_CLOSED: usize = 5;
    pub const RESET: usize = 6;
    pub const Q: usize = 7;
    pub const QD: usize = 13;
    pub const TCP_SPEED: usize = 19;
    pub const LEG: usize = 21;
}

#[test]
fn the_places_used_here_are_those_of_the_table() {
    for (place, name) in [
        (place::PHASE0, "ctrl.phase0"),
        (place::GUARD_CLOSED, "plc.guard_closed"),
        (place::RESET, "plc.reset"),
        (place::Q, "robot.q[1]"),
        (place::QD, "robot.qd[1]"),
        (place::TCP_SPEED, "robot.tcp_speed"),
        (place::LEG, "ctrl.leg"),
    ] {
        assert_eq!(fence().place(name), Some(place));
    }
}

const OK: Status = 0;
const DISCARD: Status = 2;
const ERROR: Status = 3;
const FATAL: Status = 4;

fn reference(place: usize) -> u32 {
    u32::try_from(place).unwrap()
}

/// Collects the lines of the log in the `Mutex` that the environment points to.
unsafe extern "C" fn note(environment: *mut c_void, status: Status, category: *const c_char, message: *const c_char) {
    // SAFETY: the test gives its own `Mutex` as the environment; both strings end with zero.
    let (lines, category, message) =
        unsafe { (&*environment.cast::<Mutex<Vec<String>>>(), CStr::from_ptr(category), CStr::from_ptr(message)) };
    lines.lock().unwrap().push(format!("{status} {} {}", category.to_str().unwrap(), message.to_str().unwrap()));
}

fn instantiate(token: &str, events: bool, early: bool) -> *mut Instance {
    let token = CString::new(token).unwrap();
    let name = c"test".as_ptr();
    // SAFETY: all pointers are valid for the call.
    unsafe {
        fmi3InstantiateCoSimulation(
            name,
            token.as_ptr(),
            null(),
            false,
            false,
            events,
            early,
            null(),
            0,
            null_mut(),
            None,
            None,
        )
    }
}

fn start(instance: *mut Instance) {
    // SAFETY: the instance was just made.
    unsafe {
        assert_eq!(fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0), OK);
        assert_eq!(fmi3ExitInitializationMode(instance), OK);
    }
}

/// The faulty model with a fault in its third step, in step mode.
fn faulty_with(kind: i32, events: bool, early: bool) -> *mut Instance {
    let instance = instantiate(&faulty::interface(Variant::Faithful).guid(), events, early);
    let references = [faulty::vr::FAULT_KIND, faulty::vr::FAULT_STEP].map(reference);
    // SAFETY: two references, two values.
    assert_eq!(unsafe { fmi3SetInt32(instance, references.as_ptr(), 2, [kind, 2].as_ptr(), 2) }, OK);
    start(instance);
    if events {
        update(instance);
        // SAFETY: the instance lives.
        assert_eq!(unsafe { fmi3EnterStepMode(instance) }, OK);
    }
    instance
}

fn update(instance: *mut Instance) {
    let (mut answers, mut time) = ([true; 5], f64::NAN);
    let [a, b, c, d, e] = &mut answers;
    // SAFETY: all pointers are valid.
    assert_eq!(unsafe { fmi3UpdateDiscreteStates(instance, a, b, c, d, e, &mut time) }, OK);
    assert_eq!(answers, [false; 5]);
}

/// What a step answers: status, event handling needed, terminate, early return, last successful time.
fn step(instance: *mut Instance, time: f64, size: f64) -> (Status, bool, bool, bool, f64) {
    let (mut event, mut terminate, mut early, mut last) = (true, true, true, f64::NAN);
    // SAFETY: all pointers are valid.
    let status = unsafe { fmi3DoStep(instance, time, size, true, &mut event, &mut terminate, &mut early, &mut last) };
    (status, event, terminate, early, last)
}

fn floats<const N: usize>(instance: *mut Instance, place: usize) -> [f64; N] {
    let mut values = [f64::NAN; N];
    // SAFETY: one reference, N places.
    assert_eq!(unsafe { fmi3GetFloat64(instance, &reference(place), 1, values.as_mut_ptr(), N) }, OK);
    values
}

fn float(instance: *mut Instance, place: usize) -> f64 {
    floats::<1>(instance, place)[0]
}

#[test]
fn nonsense_instead_of_an_instance_is_refused_and_logged() {
    let lines = Mutex::new(Vec::<String>::new());
    let environment = (&raw const lines).cast_mut().cast::<c_void>();
    let token = CString::new(fence().guid()).unwrap();
    let (token, name, none) = (token.as_ptr(), c"a".as_ptr(), null());
    // SAFETY: null is what is tested; all other pointers are valid.
    unsafe {
        let make = |name, token, events| {
            fmi3InstantiateCoSimulation(
                name,
                token,
                none,
                false,
                false,
                events,
                false,
                null(),
                0,
                environment,
                Some(note),
                None,
            )
        };
        assert!(make(null(), token, false).is_null());
        assert!(make(name, null(), false).is_null());
        assert!(make(name, c"{other}".as_ptr(), false).is_null());
        assert!(make(name, token, true).is_null(), "the cell has no event mode");
        assert!(fmi3InstantiateModelExchange(name, token, none, false, false, environment, Some(note)).is_null());
        assert!(
            fmi3InstantiateScheduledExecution(
                name,
                token,
                none,
                false,
                false,
                environment,
                Some(note),
                null(),
                null(),
                null(),
            )
            .is_null()
        );
        let instance = make(name, token, false);
        assert!(!instance.is_null());
        assert_eq!(fmi3SetTime(instance, 0.0), ERROR);
        fmi3FreeInstance(instance);
        fmi3FreeInstance(null_mut());
        assert_eq!(fmi3Reset(null_mut()), ERROR);
        assert_eq!(CStr::from_ptr(fmi3GetVersion()), c"3.0");
    }
    let lines = lines.into_inner().unwrap();
    assert_eq!(lines.len(), 7, "{lines:#?}");
    assert!(lines[2].contains("no model in this binary has the guid {other}"));
    assert_eq!(lines[6], "3 logStatusError fmi3SetTime: this FMU is for co-simulation only");
}

#[test]
fn a_whole_life_gives_the_bits_of_fmi_2() {
    use place::{GUARD_CLOSED, LEG, PHASE0, Q, QD, RESET, TCP_SPEED};
    let guid = CString::new(fence().guid()).unwrap();
    let functions = fmi2::CallbackFunctions {
        logger: None,
        allocate_memory: null(),
        free_memory: null(),
        step_finished: null(),
        environment: null_mut(),
    };
    let new = instantiate(&fence().guid(), false, false);
    let reals = [Q, Q + 1, Q + 2, QD, TCP_SPEED].map(reference);
    let inputs = [GUARD_CLOSED, RESET].map(reference);
    let (leg, phase) = (reference(LEG), reference(PHASE0));
    // SAFETY: all pointers are valid; the lengths are those of the arrays.
    unsafe {
        let old = fmi2::fmi2Instantiate(c"old".as_ptr(), 1, guid.as_ptr(), null(), &functions, 0, 0);
        assert_eq!(fmi2::fmi2SetReal(old, &phase, 1, &0.3), OK);
        assert_eq!(fmi3SetFloat64(new, &phase, 1, &0.3, 1), OK);
        fmi2::fmi2SetupExperiment(old, 0, 0.0, 1.5, 0, 0.0);
        fmi2::fmi2EnterInitializationMode(old);
        fmi2::fmi2ExitInitializationMode(old);
        assert_eq!(fmi3EnterInitializationMode(new, false, 0.0, 1.5, false, 0.0), OK);
        assert_eq!(fmi3ExitInitializationMode(new), OK);
        let mut time = 1.5;
        for k in 0..200_u8 {
            let values = [!(60..90).contains(&k), k == 150];
            assert_eq!(fmi2::fmi2SetBoolean(old, inputs.as_ptr(), 2, values.map(i32::from).as_ptr()), OK);
            assert_eq!(fmi3SetBoolean(new, inputs.as_ptr(), 2, values.as_ptr(), 2), OK);
            assert_eq!(fmi2::fmi2DoStep(old, time, 0.02, 0), OK);
            assert_eq!(step(new, time, 0.02), (OK, false, false, false, time + 0.02));
            time += 0.02;
            let (mut a, mut b, mut n, mut m) = ([0.0; 5], [1.0; 5], 0, 1);
            assert_eq!(fmi2::fmi2GetReal(old, reals.as_ptr(), 5, a.as_mut_ptr()), OK);
            assert_eq!(fmi3GetFloat64(new, reals.as_ptr(), 5, b.as_mut_ptr(), 5), OK);
            assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits));
            assert_eq!(fmi2::fmi2GetInteger(old, &leg, 1, &mut n), OK);
            assert_eq!(fmi3GetInt32(new, &leg, 1, &mut m, 1), OK);
            assert_eq!(n, m);
        }
        // The bytes of a state are those of FMI 2.0, too.
        let (mut state2, mut state3, mut size2, mut size3) = (null_mut(), null_mut(), 0, 0);
        assert_eq!(fmi2::fmi2GetFMUstate(old, &mut state2), OK);
        assert_eq!(fmi3GetFMUState(new, &mut state3), OK);
        fmi2::fmi2SerializedFMUstateSize(old, state2, &mut size2);
        assert_eq!(fmi3SerializedFMUStateSize(new, state3, &mut size3), OK);
        assert_eq!(size2, size3);
        let (mut bytes2, mut bytes3) = (vec![0; size2], vec![1; size3]);
        fmi2::fmi2SerializeFMUstate(old, state2, bytes2.as_mut_ptr(), size2);
        assert_eq!(fmi3SerializeFMUState(new, state3, bytes3.as_mut_ptr(), size3), OK);
        assert_eq!(bytes2, bytes3);
        fmi2::fmi2FreeFMUstate(old, &mut state2);
        fmi2::fmi2FreeInstance(old);

        let q = float(new, Q);
        let handle = state3;
        assert_eq!(step(new, time, 0.1).0, OK);
        assert_ne!(float(new, Q), q);
        assert_eq!(fmi3SetFMUState(new, state3), OK);
        assert_eq!(float(new, Q), q);
        assert_eq!(fmi3GetFMUState(new, &mut state3), OK);
        assert_eq!(state3, handle, "no new memory for a handle that exists");
        assert_eq!(fmi3FreeFMUState(new, &mut state3), OK);
        assert!(state3.is_null());
        assert_eq!(fmi3Terminate(new), OK);
        assert_eq!(step(new, time, 0.1).0, ERROR);
        assert_eq!(fmi3Reset(new), OK);
        start(new);
        assert_eq!(float(new, 0), 0.0);
        fmi3FreeInstance(new);
    }
}

#[test]
fn null_pointers_wrong_types_and_wrong_counts_are_refused() {
    let instance = instantiate(&fence().guid(), false, false);
    start(instance);
    let (q, leg, closed) = (reference(place::Q), reference(place::LEG), reference(place::GUARD_CLOSED));
    let (mut value, mut number, mut flag, mut last) = (0.0, 0, false, 0.0);
    let flag: *mut bool = &mut flag;
    // SAFETY: null is what is tested; all other pointers are valid.
    unsafe {
        assert_eq!(fmi3GetFloat64(instance, null(), 1, &mut value, 1), ERROR);
        assert_eq!(fmi3GetFloat64(instance, &q, 1, null_mut(), 1), ERROR);
        assert_eq!(fmi3GetFloat64(instance, null(), 0, null_mut(), 0), OK);
        assert_eq!(fmi3GetFloat64(instance, &q, 1, &mut value, 0), ERROR);
        assert_eq!(fmi3GetFloat64(instance, &q, 1, [0.0; 2].as_mut_ptr(), 2), ERROR);
        assert_eq!(fmi3GetFloat64(instance, &leg, 1, &mut value, 1), ERROR);
        assert_eq!(fmi3GetInt32(instance, &leg, 1, &mut number, 1), OK);
        assert_eq!(fmi3GetInt64(instance, &leg, 1, &mut 0, 1), ERROR);
        assert_eq!(fmi3GetFloat64(instance, &999, 1, &mut value, 1), ERROR);
        assert_eq!(fmi3SetFloat64(instance, &closed, 1, &1.0, 1), ERROR);
        assert_eq!(fmi3SetUInt8(instance, &closed, 1, &1, 1), ERROR);
        assert_eq!(fmi3SetBoolean(instance, &closed, 1, null(), 1), ERROR);
        assert_eq!(fmi3SetBoolean(instance, &closed, 1, [true; 2].as_ptr(), 2), ERROR);
        assert_eq!(fmi3SetString(instance, &closed, 1, &null(), 1), ERROR);
        assert_eq!(fmi3GetFMUState(instance, null_mut()), ERROR);
        assert_eq!(fmi3SetFMUState(instance, null()), ERROR);
        assert_eq!(fmi3FreeFMUState(instance, null_mut()), OK);
        assert_eq!(fmi3DeserializeFMUState(instance, null(), 10, &mut null_mut()), ERROR);
        assert_eq!(fmi3DoStep(instance, 0.0, 0.02, true, null_mut(), flag, flag, &mut last), ERROR);
        assert_eq!(fmi3DoStep(instance, 0.0, 0.02, true, flag, flag, flag, null_mut()), ERROR);
        assert_eq!(fmi3EnterEventMode(instance), ERROR);
        assert_eq!(fmi3EnterConfigurationMode(instance), ERROR);
        assert_eq!(fmi3GetNumberOfContinuousStates(instance, &mut 0), ERROR);
        assert_eq!(step(instance, 0.0, 0.02).0, OK, "nothing of this has done any harm");
        fmi3FreeInstance(instance);
    }
}

#[test]
fn each_fault_shows_in_its_step() {
    for (kind, events, early, expected) in [
        (0, true, true, (OK, false, false, false, 0.06)),
        (2, false, false, (ERROR, false, false, false, 0.04)),
        (3, true, true, (DISCARD, false, false, false, 0.04)),
        (4, false, false, (FATAL, false, false, false, 0.04)),
        (10, false, true, (OK, false, false, true, 0.05)),
        (10, false, false, (OK, false, false, false, 0.06)),
        (11, false, false, (OK, false, true, false, 0.06)),
        (12, true, false, (OK, true, false, false, 0.06)),
        (12, false, false, (OK, false, false, false, 0.06)),
        (13, false, true, (OK, false, false, false, 0.05)),
    ] {
        let instance = faulty_with(kind, events, early);
        assert_eq!(step(instance, 0.0, 0.02).0, OK);
        assert_eq!(step(instance, 0.02, 0.02), (OK, false, false, false, 0.04));
        assert_eq!(step(instance, 0.04, 0.02), expected, "fault {kind}");
        // SAFETY: the instance lives until here.
        unsafe { fmi3FreeInstance(instance) };
    }
}

#[test]
fn a_discarded_step_leaves_everything_as_it_was() {
    let instance = faulty_with(3, false, false);
    step(instance, 0.0, 0.02);
    step(instance, 0.02, 0.02);
    let before = (float(instance, 0), float(instance, faulty::vr::Q));
    assert_eq!(step(instance, 0.04, 0.02).0, DISCARD);
    assert_eq!((float(instance, 0), float(instance, faulty::vr::Q)), before);
    // SAFETY: the instance lives.
    unsafe {
        assert_eq!(fmi3Terminate(instance), OK);
        fmi3FreeInstance(instance);
    }
}

#[test]
fn an_event_is_worth_the_same_in_both_ways() {
    let (with, without) = (faulty_with(12, true, false), faulty_with(12, false, false));
    for k in 0..20_u8 {
        let time = f64::from(k) * 0.02;
        let event = step(with, time, 0.02).1;
        assert!(!step(without, time, 0.02).1);
        assert_eq!(event, k == 2);
        assert_eq!(float(with, faulty::vr::Q), float(without, faulty::vr::Q));
        if event {
            // SAFETY: the instance lives.
            assert_eq!(unsafe { fmi3EnterEventMode(with) }, OK);
            assert_eq!(step(with, 0.06, 0.02).0, ERROR, "not in event mode");
            update(with);
            // SAFETY: the instance lives.
            assert_eq!(unsafe { fmi3EnterStepMode(with) }, OK);
        }
    }
    assert!(float(with, faulty::vr::QD) > 0.8, "the drive has sped up");
    // SAFETY: both instances live.
    unsafe {
        fmi3FreeInstance(with);
        fmi3FreeInstance(without);
    }
}

#[test]
fn fmi_2_tells_of_an_end_by_discard() {
    let guid = CString::new(faulty::interface(Variant::Faithful).guid()).unwrap();
    let references = [faulty::vr::FAULT_KIND, faulty::vr::FAULT_STEP].map(reference);
    let functions = fmi2::CallbackFunctions {
        logger: None,
        allocate_memory: null(),
        free_memory: null(),
        step_finished: null(),
        environment: null_mut(),
    };
    let (mut terminated, mut time) = (-1, f64::NAN);
    // SAFETY: all pointers are valid.
    unsafe {
        let slave = fmi2::fmi2Instantiate(c"a".as_ptr(), 1, guid.as_ptr(), null(), &functions, 0, 0);
        assert_eq!(fmi2::fmi2SetInteger(slave, references.as_ptr(), 2, [11, 1].as_ptr()), OK);
        fmi2::fmi2SetupExperiment(slave, 0, 0.0, 0.0, 0, 0.0);
        fmi2::fmi2EnterInitializationMode(slave);
        fmi2::fmi2ExitInitializationMode(slave);
        assert_eq!(fmi2::fmi2DoStep(slave, 0.0, 0.02, 0), OK);
        assert_eq!(fmi2::fmi2GetBooleanStatus(slave, 3, &mut terminated), OK);
        assert_eq!(terminated, 0);
        assert_eq!(fmi2::fmi2DoStep(slave, 0.02, 0.02, 0), DISCARD);
        assert_eq!(fmi2::fmi2GetBooleanStatus(slave, 3, &mut terminated), OK);
        assert_eq!(fmi2::fmi2GetRealStatus(slave, 2, &mut time), OK);
        assert_eq!(fmi2::fmi2Terminate(slave), OK);
        fmi2::fmi2FreeInstance(slave);
    }
    assert_eq!((terminated, time), (1, 0.04));
}

/// Sets input and parameter of a number type, and expects the output and the local variable to follow.
macro_rules! round_trip {
    ($instance:ident $kind:literal $get:ident $set:ident $value:expr) => {{
        let vr = [0, 1, 2, 3].map(|role| reference(types3::vr::of($kind, role)));
        let (given, mut read) = ([$value; 2], [$value; 4]);
        // SAFETY: the lengths are those of the arrays.
        unsafe {
            assert_eq!($get($instance, vr.as_ptr(), 4, read.as_mut_ptr(), 4), OK);
            assert!(read.iter().all(|value| *value == read[0] && *value != $value), "the start value");
            assert_eq!($set($instance, [vr[0], vr[2]].as_ptr(), 2, given.as_ptr(), 2), OK);
            assert_eq!($get($instance, vr.as_ptr(), 4, read.as_mut_ptr(), 4), OK);
            assert_eq!(read, [$value; 4], "{}", stringify!($get));
            assert_eq!($set($instance, &vr[1], 1, given.as_ptr(), 1), ERROR, "an output");
            assert_eq!($set($instance, &vr[3], 1, given.as_ptr(), 1), ERROR, "a local variable");
            assert_eq!($set($instance, &0, 1, given.as_ptr(), 1), ERROR, "time");
        }
    }};
}

fn types3_initializing() -> *mut Instance {
    let instance = instantiate(types3::token(), true, false);
    // SAFETY: the instance was just made.
    assert_eq!(unsafe { fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0) }, OK);
    instance
}

#[test]
fn all_types_make_the_round_trip() {
    let instance = types3_initializing();
    round_trip!(instance 0 fmi3GetFloat32 fmi3SetFloat32 1.5);
    round_trip!(instance 1 fmi3GetFloat64 fmi3SetFloat64 0.1);
    round_trip!(instance 2 fmi3GetInt8 fmi3SetInt8 i8::MIN);
    round_trip!(instance 3 fmi3GetUInt8 fmi3SetUInt8 u8::MAX);
    round_trip!(instance 4 fmi3GetInt16 fmi3SetInt16 i16::MIN);
    round_trip!(instance 5 fmi3GetUInt16 fmi3SetUInt16 u16::MAX);
    round_trip!(instance 6 fmi3GetInt32 fmi3SetInt32 i32::MIN);
    round_trip!(instance 7 fmi3GetUInt32 fmi3SetUInt32 u32::MAX);
    round_trip!(instance 8 fmi3GetInt64 fmi3SetInt64 i64::MIN);
    round_trip!(instance 9 fmi3GetUInt64 fmi3SetUInt64 u64::MAX);
    round_trip!(instance 10 fmi3GetBoolean fmi3SetBoolean false);
    round_trip!(instance 13 fmi3GetInt64 fmi3SetInt64 3);
    let level = reference(types3::vr::of(13, 0));
    // SAFETY: one reference, one value.
    unsafe {
        assert_eq!(fmi3SetInt64(instance, &level, 1, &4, 1), ERROR, "not a level");
        assert_eq!(fmi3GetFloat32(instance, &reference(types3::vr::of(1, 0)), 1, &mut 0.0, 1), ERROR, "Float64");
        assert_eq!(fmi3GetInt64(instance, &reference(types3::vr::SIZED_ARRAY + 1), 1, &mut 0, 1), ERROR, "unknown");
        fmi3FreeInstance(instance);
    }
}

#[test]
fn strings_binaries_and_clocks_make_the_round_trip() {
    let instance = types3_initializing();
    let string = [0, 1, 2, 3].map(|role| reference(types3::vr::of(11, role)));
    let binary = [0, 1, 2, 3].map(|role| reference(types3::vr::of(12, role)));
    let clock = [0, 1].map(|role| reference(types3::vr::of(14, role)));
    let (mut texts, mut sizes, mut bytes, mut ticks) = ([null(); 4], [9; 4], [null(); 4], [false; 2]);
    // SAFETY: the lengths are those of the arrays; texts and bytes are read before the next call.
    unsafe {
        let words = [c"gr\xc3\xbc\xc3\x9fe", c""].map(CStr::as_ptr);
        assert_eq!(fmi3SetString(instance, [string[0], string[2]].as_ptr(), 2, words.as_ptr(), 2), OK);
        assert_eq!(fmi3GetString(instance, string.as_ptr(), 4, texts.as_mut_ptr(), 4), OK);
        assert_eq!(texts.map(|text| CStr::from_ptr(text).to_str().unwrap()), ["grüße", "grüße", "", ""]);
        assert_eq!(fmi3SetString(instance, string.as_ptr(), 1, &null(), 1), ERROR);

        assert_eq!(fmi3GetBinary(instance, binary.as_ptr(), 1, sizes.as_mut_ptr(), bytes.as_mut_ptr(), 1), OK);
        assert_eq!(std::slice::from_raw_parts(bytes[0], sizes[0]), [0, 255, 16]);
        let (lengths, given) = ([5, 0], [b"\0\x01\xff\0z".as_ptr(), null()]);
        let settable = [binary[0], binary[2]];
        assert_eq!(fmi3SetBinary(instance, settable.as_ptr(), 2, lengths.as_ptr(), given.as_ptr(), 2), OK);
        assert_eq!(fmi3GetBinary(instance, binary.as_ptr(), 4, sizes.as_mut_ptr(), bytes.as_mut_ptr(), 4), OK);
        assert_eq!(sizes, [5, 5, 0, 0]);
        assert_eq!(std::slice::from_raw_parts(bytes[1], 5), b"\0\x01\xff\0z");
        assert_eq!(fmi3SetBinary(instance, settable.as_ptr(), 2, null(), given.as_ptr(), 2), ERROR);
        assert_eq!(fmi3GetBinary(instance, string.as_ptr(), 1, sizes.as_mut_ptr(), bytes.as_mut_ptr(), 1), ERROR);

        assert_eq!(fmi3ExitInitializationMode(instance), OK);
        assert_eq!(fmi3SetClock(instance, clock.as_ptr(), 1, &true), OK);
        assert_eq!(fmi3GetClock(instance, clock.as_ptr(), 2, ticks.as_mut_ptr()), OK);
        assert_eq!(ticks, [true; 2]);
        update(instance);
        assert_eq!(fmi3GetClock(instance, clock.as_ptr(), 2, ticks.as_mut_ptr()), OK);
        assert_eq!(ticks, [false; 2], "a clock ticks once");
        assert_eq!(fmi3GetBoolean(instance, clock.as_ptr(), 1, ticks.as_mut_ptr(), 1), ERROR);
        assert_eq!(fmi3GetClock(instance, &reference(types3::vr::of(14, 2)), 1, ticks.as_mut_ptr()), ERROR);
        assert_eq!(fmi3SetString(instance, &string[2], 1, words.as_ptr(), 1), ERROR, "a fixed parameter by now");
        assert_eq!(fmi3SetString(instance, &string[2], 1, &words[1], 1), OK, "the same text changes nothing");
        fmi3FreeInstance(instance);
    }
}

#[test]
fn arrays_follow_the_joint_and_the_structural_parameter() {
    let instance = instantiate(types3::token(), false, false);
    let honest = faulty_with(0, false, false);
    let n = reference(types3::vr::N);
    // SAFETY: one reference, one value.
    unsafe {
        assert_eq!(fmi3SetUInt64(instance, &n, 1, &2, 1), ERROR, "only in configuration mode");
        assert_eq!(fmi3EnterConfigurationMode(instance), OK);
        assert_eq!(fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0), ERROR);
        assert_eq!(fmi3SetUInt64(instance, &n, 1, &65, 1), ERROR, "too many");
        assert_eq!(fmi3SetUInt64(instance, &n, 1, &2, 1), OK);
        assert_eq!(fmi3ExitConfigurationMode(instance), OK);
    }
    start(instance);
    for k in 0..10_u8 {
        let (time, stop) = (f64::from(k) * 0.05, k > 4);
        for (unit, place) in [(instance, types3::vr::STOP), (honest, faulty::vr::STOP)] {
            // SAFETY: one reference, one value.
            assert_eq!(unsafe { fmi3SetBoolean(unit, &reference(place), 1, &stop, 1) }, OK);
            assert_eq!(step(unit, time, 0.05).0, OK);
        }
        let [q, qd] = [faulty::vr::Q, faulty::vr::QD].map(|place| float(honest, place));
        assert_eq!([types3::vr::Q, types3::vr::QD].map(|place| float(instance, place)), [q, qd]);
        assert_eq!(floats(instance, types3::vr::FIXED_ARRAY), [q, qd, -0.25]);
        assert_eq!(floats(instance, types3::vr::SIZED_ARRAY), [q, 2.0 * q]);
    }
    // One call may read scalars and arrays together.
    let vr = [types3::vr::Q, types3::vr::FIXED_ARRAY, types3::vr::SIZED_ARRAY].map(reference);
    let mut values = [0.0; 7];
    // SAFETY: the lengths are those of the arrays.
    unsafe {
        assert_eq!(fmi3GetFloat64(instance, vr.as_ptr(), 3, values.as_mut_ptr(), 6), OK);
        assert_eq!(values[3], -0.25);
        assert_eq!(values[5], 2.0 * values[0]);
        assert_eq!(fmi3GetFloat64(instance, vr.as_ptr(), 3, values.as_mut_ptr(), 7), ERROR);
        assert_eq!(fmi3GetFloat64(instance, vr.as_ptr(), 3, values.as_mut_ptr(), 5), ERROR);
        assert_eq!(fmi3SetFloat64(instance, &vr[1], 1, values.as_ptr(), 3), ERROR);
        fmi3FreeInstance(instance);
        fmi3FreeInstance(honest);
    }
}

#[test]
fn states_of_all_types_carry_everything_to_another_instance() {
    let (one, other) = (types3_initializing(), instantiate(types3::token(), true, false));
    let (string, number) = (reference(types3::vr::of(11, 2)), reference(types3::vr::of(0, 0)));
    let (mut state, mut read, mut size, mut text, mut value) = (null_mut(), null_mut(), 0, null(), 0.0);
    // SAFETY: handles come from the instance they are used with; lengths are right.
    unsafe {
        assert_eq!(fmi3SetString(one, &string, 1, &c"kept".as_ptr(), 1), OK);
        assert_eq!(fmi3ExitInitializationMode(one), OK);
        update(one);
        assert_eq!(fmi3EnterStepMode(one), OK);
        assert_eq!(fmi3SetFloat32(one, &number, 1, &0.75, 1), OK);
        assert_eq!(step(one, 0.0, 0.2).0, OK);
        assert_eq!(fmi3GetFMUState(one, &mut state), OK);
        assert_eq!(fmi3SerializedFMUStateSize(one, state, &mut size), OK);
        let mut bytes = vec![0; size];
        assert_eq!(fmi3SerializeFMUState(one, state, bytes.as_mut_ptr(), size - 1), ERROR);
        assert_eq!(fmi3SerializeFMUState(one, state, bytes.as_mut_ptr(), size), OK);
        assert_eq!(fmi3DeserializeFMUState(other, bytes.as_ptr(), size - 1, &mut read), ERROR);
        assert_eq!(fmi3DeserializeFMUState(other, bytes.as_ptr(), size, &mut read), OK);
        assert_eq!(fmi3SetFMUState(other, read), OK);
        assert_eq!(fmi3GetString(other, &string, 1, &mut text, 1), OK);
        assert_eq!(CStr::from_ptr(text), c"kept");
        assert_eq!(fmi3GetFloat32(other, &number, 1, &mut value, 1), OK);
        assert_eq!(value, 0.75);
        assert_eq!(float(other, 0), 0.2);
        assert_eq!(step(one, 0.2, 0.2), step(other, 0.2, 0.2));
        assert_eq!(floats::<4>(one, types3::vr::SIZED_ARRAY), floats(other, types3::vr::SIZED_ARRAY));

        let cell = instantiate(&fence().guid(), false, false);
        assert_eq!(fmi3SetFMUState(cell, read), ERROR, "of another model");
        assert_eq!(fmi3DeserializeFMUState(cell, bytes.as_ptr(), size, &mut null_mut()), ERROR);
        fmi3FreeInstance(cell);
        assert_eq!(fmi3Reset(one), OK);
        start(one);
        assert_eq!(fmi3GetString(one, &string, 1, &mut text, 1), OK);
        assert_eq!(CStr::from_ptr(text), c"start");
        assert_eq!(fmi3FreeFMUState(one, &mut state), OK);
        assert_eq!(fmi3FreeFMUState(other, &mut read), OK);
        fmi3FreeInstance(one);
        fmi3FreeInstance(other);
    }
}
