//! Errors are a status and a message, and never end the program of the caller.

#![expect(unsafe_code, reason = "calls of the C interface")]

use std::ffi::{CStr, CString, c_char};
use std::ptr::{null, null_mut};

use ancf_c::{
    Simulation, Status, ancf_advance, ancf_close, ancf_count_coordinates, ancf_find_column, ancf_find_input,
    ancf_get_state, ancf_last_error, ancf_open, ancf_parse, ancf_read, ancf_read_row, ancf_restore,
    ancf_save, ancf_set_input, ancf_set_state, ancf_step, ancf_time,
};

const MODEL: &str = r#"
    bodies = [{ kind = "mass", name = "cart", center = [0, 0, 0], mass = 2 }]
    inputs = [{ name = "thrust" }]
    probes = [{ name = "cart", on = { body = "cart", at = "center" } }]

    [[loads]]
    kind = "force"
    on = { body = "cart", at = "center" }
    force = [1, 0, 0]
    time = { kind = "input", name = "thrust" }

    [analysis]
    kind = "dynamics"
    duration = 1
    step = 0.01
    scheme = "average_acceleration"
"#;

/// Message of the last error.
fn message() -> String {
    // SAFETY: the text ends with a null character.
    unsafe { CStr::from_ptr(ancf_last_error()) }.to_string_lossy().into_owned()
}

fn parsed(text: &str) -> (Status, *mut Simulation) {
    let (text, mut simulation) = (CString::new(text).expect("a text"), null_mut());
    // SAFETY: valid pointers.
    let status = unsafe { ancf_parse(text.as_ptr(), &raw mut simulation) };
    (status, simulation)
}

/// Simulation that is closed at the end.
struct Open(*mut Simulation);

impl Open {
    fn new(text: &str) -> Self {
        let (status, simulation) = parsed(text);
        assert_eq!(status, Status::Ok, "{}", message());
        Self(simulation)
    }
}

impl Drop for Open {
    fn drop(&mut self) {
        // SAFETY: closed once.
        unsafe { ancf_close(self.0) };
    }
}

#[test]
fn models_that_are_not_valid_have_no_simulation() {
    let mut simulation = null_mut();
    // SAFETY: valid pointers, or null.
    unsafe {
        assert_eq!(ancf_open(c"no/such/model.toml".as_ptr(), &raw mut simulation), Status::Model);
        assert!(simulation.is_null());
        assert_eq!(message(), "no/such/model.toml: no such file");
        assert_eq!(ancf_open(null(), &raw mut simulation), Status::Argument);
        assert_eq!(message(), "`path` is a null pointer");
        assert_eq!(ancf_open(c"\xff".as_ptr().cast::<c_char>(), &raw mut simulation), Status::Argument);
        assert_eq!(message(), "`path` is not a text in UTF-8");
        assert_eq!(ancf_parse(c"".as_ptr(), null_mut()), Status::Argument);
    }
    let (status, simulation) = parsed("gravity = [0, -9.81]\nbodies = 3\n");
    assert_eq!((status, simulation), (Status::Model, null_mut()));
    let lines = message();
    assert!(lines.contains("model:1:11: gravity: found an array of 2"), "{lines}");
    assert!(lines.contains("model:2:10: bodies: found"), "all errors are reported:\n{lines}");
    let (status, _) = parsed(&MODEL.replace(
        "kind = \"dynamics\"\n    duration = 1\n    step = 0.01\n    scheme = \"average_acceleration\"",
        "kind = \"statics\"",
    ));
    assert_eq!(status, Status::Model);
    let (status, _) = parsed(&format!("initial = {{ from = \"other\" }}\n{MODEL}"));
    assert_ne!(status, Status::Ok, "a state of a results folder is not read");
    assert!(message().contains("other"), "{}", message());
}

#[test]
fn null_pointers_names_and_indices_are_checked() {
    let (own, mut index, mut value) = (Open::new(MODEL), 0_usize, 0.0);
    // SAFETY: valid pointers, or null.
    unsafe {
        assert_eq!(ancf_find_input(own.0, c"thrusst".as_ptr(), &raw mut index), Status::Argument);
        assert!(message().contains("perhaps \"thrust\""), "{}", message());
        assert_eq!(ancf_find_column(own.0, c"cart.u".as_ptr(), &raw mut index), Status::Argument);
        assert!(message().contains("column: found \"cart.u\""), "{}", message());
        assert_eq!(ancf_find_column(own.0, null(), &raw mut index), Status::Argument);
        assert_eq!(ancf_find_column(own.0, c"cart.x".as_ptr(), null_mut()), Status::Argument);
        assert_eq!(message(), "`column` is a null pointer");
        assert_eq!(ancf_time(null_mut(), &raw mut value), Status::Argument);
        assert_eq!(message(), "`simulation` is a null pointer");
        assert_eq!(ancf_read(own.0, 10_000, &raw mut value), Status::Argument);
        assert!(message().starts_with("column: found index 10000, expected one below"), "{}", message());
        assert_eq!(ancf_set_input(own.0, 1, 0.0, 0.0), Status::Argument);
        assert_eq!(ancf_set_input(own.0, 0, f64::NAN, 0.0), Status::Argument);
        assert_eq!(ancf_read_row(own.0, &raw mut value, 1), Status::Argument);
        assert_eq!(ancf_get_state(own.0, &raw mut value, &raw mut value, 1), Status::Argument);
        assert_eq!(message(), "count: found 1, expected 3");
        assert_eq!(ancf_restore(own.0, null(), 8), Status::Argument);
        assert_eq!(ancf_restore(own.0, [0_u8; 8].as_ptr(), 8), Status::Snapshot);
        assert_eq!(ancf_step(own.0, -1.0, null_mut()), Status::Argument);
        assert_eq!(ancf_advance(own.0, f64::INFINITY, null_mut()), Status::Argument);
        ancf_close(null_mut());
    }
}

/// The force that acts from t = 0.5 on is too large for one step.
#[test]
fn a_failed_step_keeps_the_last_state() {
    let text = r#"
        materials.rubber = { density = 1000, young = 1e6 }
        sections.rod = { kind = "circle", diameter = 0.02 }

        [[bodies]]
        kind = "beam"
        name = "rod"
        from = [0, 0, 0]
        to = [1, 0, 0]
        elements = 2
        section = "rod"
        material = "rubber"
        formulation = "linked"

        [[joints]]
        kind = "clamp"
        name = "root"
        a = { body = "rod", at = "start" }

        [[loads]]
        kind = "force"
        on = { body = "rod", at = "end" }
        force = [0, 1e6, 0]
        time = { kind = "step", at = 0.5 }

        [analysis]
        kind = "dynamics"
        duration = 1
        step = 0.1
        max_halvings = 0
        scheme = { spectral_radius = 0.8 }
    "#;
    let (own, mut time) = (Open::new(text), 0.0);
    // SAFETY: valid pointers.
    unsafe {
        assert_eq!(ancf_advance(own.0, 1.0, null_mut()), Status::Failed, "{}", message());
        assert!(message().starts_with("failed at t = 0.6"), "{}", message());
        assert_eq!(ancf_time(own.0, &raw mut time), Status::Ok);
        assert_eq!(time, 0.5);
        assert_eq!(ancf_step(own.0, 1e-6, null_mut()), Status::Ok, "a smaller step continues: {}", message());
    }
}

#[test]
fn snapshots_and_states_continue_identically() {
    let (own, mut size, mut n) = (Open::new(MODEL), 0_usize, 0_usize);
    let [mut first, mut second] = [0.0; 2];
    // SAFETY: valid pointers and sizes.
    unsafe {
        let mut column = 0;
        assert_eq!(ancf_find_column(own.0, c"cart.x".as_ptr(), &raw mut column), Status::Ok);
        assert_eq!(ancf_set_input(own.0, 0, 4.0, 0.0), Status::Ok);
        assert_eq!(ancf_advance(own.0, 0.5, null_mut()), Status::Ok);
        assert_eq!(ancf_save(own.0, null_mut(), 0, &raw mut size), Status::Buffer);
        let mut bytes = vec![0_u8; size];
        assert_eq!(ancf_save(own.0, bytes.as_mut_ptr(), size - 1, &raw mut size), Status::Buffer);
        assert_eq!(ancf_save(own.0, bytes.as_mut_ptr(), bytes.len(), &raw mut size), Status::Ok);
        assert_eq!(ancf_count_coordinates(own.0, &raw mut n), Status::Ok);
        let [mut q, mut v] = [vec![0.0; n], vec![0.0; n]];
        assert_eq!(ancf_get_state(own.0, q.as_mut_ptr(), v.as_mut_ptr(), n), Status::Ok);
        assert_eq!(ancf_advance(own.0, 1.0, null_mut()), Status::Ok);
        assert_eq!(ancf_read(own.0, column, &raw mut first), Status::Ok);
        assert!((first - 1.0).abs() < 1e-12, "x = F t²/(2 m): {first}");
        assert_eq!(ancf_restore(own.0, bytes.as_ptr(), size), Status::Ok);
        assert_eq!(ancf_advance(own.0, 1.0, null_mut()), Status::Ok);
        assert_eq!(ancf_read(own.0, column, &raw mut second), Status::Ok);
        assert_eq!(first.to_bits(), second.to_bits());
        let set = ancf_set_state(own.0, 0.5, q.as_ptr(), v.as_ptr(), n, null_mut(), null_mut());
        assert_eq!(set, Status::Ok, "{}", message());
        assert_eq!(ancf_advance(own.0, 1.0, null_mut()), Status::Ok);
        assert_eq!(ancf_read(own.0, column, &raw mut second), Status::Ok);
        assert!((first - second).abs() < 1e-12);
        bytes[size / 2] ^= 1;
        assert_eq!(ancf_restore(own.0, bytes.as_ptr(), size), Status::Snapshot);
        assert_eq!(message(), "the snapshot is damaged");
    }
}
