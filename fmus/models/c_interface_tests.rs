//! The C interface from the importer's side: null pointers, wrong GUID, state handles.
#![expect(unsafe_code, reason = "calls the C interface")]

use crate::fmi2::*;
use crate::interface::variables::{Interface, Variant};
use crate::interface::{faulty, safety_fence, workcell};
use std::ffi::{CString, c_int};
use std::ptr::{null, null_mut};

const OK: Status = 0;
const ERROR: Status = 3;

fn fence() -> Interface {
    workcell::interface(&safety_fence::SPEC, Variant::Faithful).0
}

fn silent() -> CallbackFunctions {
    CallbackFunctions {
        logger: None,
        allocate_memory: null(),
        free_memory: null(),
        step_finished: null(),
        environment: null_mut(),
    }
}

fn instantiate(guid: &str) -> *mut Slave {
    let guid = CString::new(guid).unwrap();
    // SAFETY: all pointers are valid for the call.
    unsafe { fmi2Instantiate(c"test".as_ptr(), 1, guid.as_ptr(), null(), &silent(), 0, 0) }
}

fn stepping(guid: &str) -> *mut Slave {
    let slave = instantiate(guid);
    assert!(!slave.is_null());
    // SAFETY: the component was just made.
    unsafe {
        assert_eq!(fmi2SetupExperiment(slave, 0, 0.0, 0.0, 0, 0.0), OK);
        assert_eq!(fmi2EnterInitializationMode(slave), OK);
        assert_eq!(fmi2ExitInitializationMode(slave), OK);
    }
    slave
}

fn real(slave: *mut Slave, place: usize) -> f64 {
    let (reference, mut value) = (u32::try_from(place).unwrap(), f64::NAN);
    // SAFETY: the component lives; one reference, one value.
    assert_eq!(unsafe { fmi2GetReal(slave, &reference, 1, &mut value) }, OK);
    value
}

#[test]
fn nonsense_instead_of_a_component_is_refused() {
    assert!(instantiate("{00000000-0000-0000-0000-000000000000}").is_null());
    let guid = CString::new(fence().guid()).unwrap();
    // SAFETY: null is what is tested; all other pointers are valid.
    unsafe {
        assert!(fmi2Instantiate(null(), 1, guid.as_ptr(), null(), &silent(), 0, 0).is_null());
        assert!(fmi2Instantiate(c"a".as_ptr(), 1, null(), null(), &silent(), 0, 0).is_null());
        assert!(fmi2Instantiate(c"a".as_ptr(), 1, guid.as_ptr(), null(), null(), 0, 0).is_null());
        assert!(fmi2Instantiate(c"a".as_ptr(), 0, guid.as_ptr(), null(), &silent(), 0, 0).is_null(), "model exchange");
        assert_eq!(fmi2DoStep(null_mut(), 0.0, 0.02, 0), ERROR);
        fmi2FreeInstance(null_mut());
    }
}

#[test]
fn null_arrays_and_wrong_types_are_refused() {
    let slave = stepping(&fence().guid());
    let (q, leg) = (
        u32::try_from(fence().place("robot.q[1]").unwrap()).unwrap(),
        u32::try_from(fence().place("ctrl.leg").unwrap()).unwrap(),
    );
    let (mut value, mut number): (f64, c_int) = (0.0, 0);
    // SAFETY: null is what is tested; all other pointers are valid.
    unsafe {
        assert_eq!(fmi2GetReal(slave, null(), 1, &mut value), ERROR);
        assert_eq!(fmi2GetReal(slave, &q, 1, null_mut()), ERROR);
        assert_eq!(fmi2GetReal(slave, null(), 0, null_mut()), OK);
        assert_eq!(fmi2GetReal(slave, &leg, 1, &mut value), ERROR);
        assert_eq!(fmi2GetInteger(slave, &leg, 1, &mut number), OK);
        assert_eq!(fmi2GetReal(slave, &999, 1, &mut value), ERROR);
        assert_eq!(fmi2GetFMUstate(slave, null_mut()), ERROR);
        assert_eq!(fmi2SetFMUstate(slave, null()), ERROR);
        assert_eq!(fmi2FreeFMUstate(slave, null_mut()), OK);
        fmi2FreeInstance(slave);
    }
}

#[test]
fn a_handle_is_reused_and_two_states_stay_apart() {
    let slave = stepping(&fence().guid());
    let (mut first, mut second) = (null_mut(), null_mut());
    // SAFETY: handles come from this component and are freed once.
    unsafe {
        fmi2DoStep(slave, 0.0, 0.3, 0);
        let early = real(slave, fence().place("robot.q[1]").unwrap());
        assert_eq!(fmi2GetFMUstate(slave, &mut first), OK);
        fmi2DoStep(slave, 0.3, 0.1, 0);
        let late = real(slave, fence().place("robot.q[1]").unwrap());
        assert_eq!(fmi2GetFMUstate(slave, &mut second), OK);
        assert_ne!((early, first), (late, second));
        assert_eq!(fmi2SetFMUstate(slave, first), OK);
        assert_eq!((real(slave, 0), real(slave, fence().place("robot.q[1]").unwrap())), (0.3, early));
        let handle = second;
        assert_eq!(fmi2GetFMUstate(slave, &mut second), OK);
        assert_eq!(second, handle, "no new memory for a handle that exists");
        assert_eq!(fmi2SetFMUstate(slave, second), OK);
        assert_eq!(real(slave, fence().place("robot.q[1]").unwrap()), early);
        for state in [&mut first, &mut second] {
            assert_eq!(fmi2FreeFMUstate(slave, state), OK);
            assert!(state.is_null());
        }
        fmi2FreeInstance(slave);
    }
}

#[test]
fn bytes_that_do_not_fit_are_refused() {
    let slave = stepping(&fence().guid());
    let (mut state, mut size) = (null_mut(), 0);
    // SAFETY: handles come from this component; the buffer has the stated size.
    unsafe {
        assert_eq!(fmi2GetFMUstate(slave, &mut state), OK);
        assert_eq!(fmi2SerializedFMUstateSize(slave, state, &mut size), OK);
        let mut bytes = vec![0_u8; size];
        assert_eq!(fmi2SerializeFMUstate(slave, state, bytes.as_mut_ptr(), size - 1), ERROR);
        assert_eq!(fmi2SerializeFMUstate(slave, state, bytes.as_mut_ptr(), size), OK);
        assert_eq!(fmi2DeSerializeFMUstate(slave, bytes.as_ptr(), size - 1, &mut state), ERROR);
        assert_eq!(fmi2DeSerializeFMUstate(slave, bytes.as_ptr(), size, &mut state), OK);
        assert_eq!(fmi2FreeFMUstate(slave, &mut state), OK);
        fmi2FreeInstance(slave);
    }
}

#[test]
fn a_refused_step_tells_how_far_it_came() {
    let slave = instantiate(&faulty::interface(Variant::Faithful).guid());
    let references = [faulty::vr::FAULT_KIND, faulty::vr::FAULT_STEP].map(|place| u32::try_from(place).unwrap());
    let mut time = f64::NAN;
    // SAFETY: all pointers are valid.
    unsafe {
        assert_eq!(fmi2SetInteger(slave, references.as_ptr(), 2, [3, 2].as_ptr()), OK);
        fmi2SetupExperiment(slave, 0, 0.0, 0.0, 0, 0.0);
        fmi2EnterInitializationMode(slave);
        fmi2ExitInitializationMode(slave);
        assert_eq!(fmi2DoStep(slave, 0.0, 0.02, 0), OK);
        assert_eq!(fmi2DoStep(slave, 0.02, 0.02, 0), OK);
        assert_eq!(fmi2DoStep(slave, 0.04, 0.02, 0), 2);
        assert_eq!(fmi2GetRealStatus(slave, 2, &mut time), OK);
        fmi2FreeInstance(slave);
    }
    assert_eq!(time, 0.04);
}
