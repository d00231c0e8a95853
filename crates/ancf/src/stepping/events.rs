use ancf_mechanics::functions::InputSignal;
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;

/// Times at which loads, drives or their rates jump, in solver units: points of tables, and switches of formulas. Steps end there.
#[derive(Debug)]
pub(super) struct Events {
    /// Times in ascending order.
    times: Vec<f64>,
    /// Time up to which the switches of formulas are known.
    known: f64,
    passed: PassedEvents,
    /// Tolerance within which two times are equal.
    tolerance: f64,
}

/// Events up to a time, which have passed.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct PassedEvents(f64);

impl PassedEvents {
    pub(super) fn is_valid(self) -> bool {
        self.0.is_finite()
    }
}

impl Events {
    /// Creates the events of an analysis.
    pub(super) fn new(assembly: &Assembly, [start, end]: [f64; 2], tolerance: f64) -> Self {
        let mut times = assembly.breaks().to_vec();
        times.dedup_by(|a, b| (*a - *b).abs() <= tolerance);
        Self { times, known: end, passed: PassedEvents(start + tolerance), tolerance }
    }

    /// Adds the switches of formulas up to a time.
    fn extend(&mut self, assembly: &Assembly, until: f64) {
        let known = self.known;
        self.times.extend(assembly.inputs.switches(until).filter(|t| *t > known));
        self.times.sort_unstable_by(f64::total_cmp);
        self.times.dedup_by(|a, b| (*a - *b).abs() <= self.tolerance);
        self.known = until;
    }

    /// Returns the next event after a time and up to another one: an own one, or the end of a transition of an input.
    pub(super) fn next(
        &mut self,
        assembly: &Assembly,
        inputs: &[InputSignal],
        [now, until]: [f64; 2],
    ) -> Option<f64> {
        if until > self.known {
            self.extend(assembly, until.max(2.0 * self.known));
        }
        let passed = self.passed.0.max(now);
        let own = self.times.get(self.times.partition_point(|t| *t <= passed)).copied();
        let ends = inputs.iter().map(|input| input.transition().times[1]).filter(|t| *t > passed);
        ends.chain(own).min_by(f64::total_cmp).filter(|t| *t <= until + self.tolerance)
    }

    /// Marks the events up to a time as passed.
    pub(super) fn pass(&mut self, t: f64) {
        self.passed = PassedEvents(t);
    }

    /// Continues at another time, at which and shortly after which events have passed.
    pub(super) fn move_to(&mut self, t: f64) {
        self.pass(t + self.tolerance);
    }

    pub(super) const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    pub(super) const fn passed(&self) -> PassedEvents {
        self.passed
    }

    pub(super) const fn restore(&mut self, passed: PassedEvents) {
        self.passed = passed;
    }
}
