use ancf_mechanics::functions::InputSignal;
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;

/// Times at which loads, drives or their rates jump, in solver units. Steps end there.
#[derive(Debug)]
pub(super) struct Events {
    /// Times in ascending order.
    times: Vec<f64>,
    /// Time up to which the switches of formulas are known; `None` if steps do not end at switches.
    known: Option<f64>,
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
    /// Creates the events of an analysis. With error control, steps end at the switches of formulas too.
    pub(super) fn new(
        assembly: &Assembly,
        [start, end]: [f64; 2],
        is_adaptive: bool,
        tolerance: f64,
    ) -> Self {
        let mut events = Self {
            times: assembly.breaks().to_vec(),
            known: None,
            passed: PassedEvents(start + tolerance),
            tolerance,
        };
        if is_adaptive {
            events.extend(assembly, end);
        }
        events
    }

    /// Adds the switches of formulas up to a time.
    fn extend(&mut self, assembly: &Assembly, until: f64) {
        let known = self.known.unwrap_or(0.0);
        self.times.extend(assembly.inputs.switches(until).filter(|t| *t > known));
        self.times.sort_unstable_by(f64::total_cmp);
        self.times.dedup_by(|a, b| (*a - *b).abs() <= self.tolerance);
        self.known = Some(until);
    }

    /// Returns the next event after a time and up to another one: an own one, or the end of a transition of an input.
    pub(super) fn next(
        &mut self,
        assembly: &Assembly,
        inputs: &[InputSignal],
        [now, until]: [f64; 2],
    ) -> Option<f64> {
        if let Some(known) = self.known.filter(|known| until > *known) {
            self.extend(assembly, until.max(2.0 * known));
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
