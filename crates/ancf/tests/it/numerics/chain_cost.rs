//! Measurement: cost of linear algebra per node of a chain with 12 coordinates per node, clamped at one end.
//!
//! `CHAIN=1000 cargo test --release -p ancf --test it chain_cost -- --ignored --nocapture`
#![expect(clippy::print_stdout, reason = "the measurement is printed")]

use std::ops::Range;
use std::sync::LazyLock;
use std::time::Instant;

use ancf::solver::equations::{EquationsOfMotion, Local, LocalMatrix, State, System, Term, Weights};
use ancf::solver::factor::Factor;

const NODE: usize = 12;

/// Definite matrix of two nodes.
struct Link([usize; 2 * NODE]);

impl Term for Link {
    fn coordinates(&self) -> &[usize] {
        &self.0
    }
    fn residual(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn rounding(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn tangent(&self, _: &Local<'_>, _: Weights, k: &mut LocalMatrix<'_>) {
        for j in 0..2 * NODE {
            for i in j..2 * NODE {
                let value = if i == j { 30.0 } else { ((7 * i + 11 * j) % 13) as f64 / 13.0 - 0.5 };
                k.add(i, j, value);
            }
        }
    }
}

/// Constraint of one coordinate.
struct Support([usize; 1]);

impl Term for Support {
    fn coordinates(&self) -> &[usize] {
        &self.0
    }
    fn multipliers(&self) -> Range<usize> {
        self.0[0]..self.0[0] + 1
    }
    fn residual(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn rounding(&self, _: &Local<'_>, _: &mut [f64]) {}
    fn tangent(&self, _: &Local<'_>, _: Weights, k: &mut LocalMatrix<'_>) {
        k.add(1, 0, 1.0);
    }
}

/// CPU time of this thread in seconds; wall-clock time if `CLOCK` is set, for several threads.
fn seconds() -> f64 {
    static START: LazyLock<Option<Instant>> =
        LazyLock::new(|| std::env::var_os("CLOCK").map(|_| Instant::now()));
    if let Some(start) = *START {
        return start.elapsed().as_secs_f64();
    }
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    text.split(' ').next().and_then(|first| first.parse::<f64>().ok()).map_or(0.0, |ns| ns * 1e-9)
}

/// Prints the smallest time per node of three measurements.
fn measure(label: &str, nodes: usize, rounds: usize, mut work: impl FnMut()) {
    let mut best = f64::INFINITY;
    for _ in 0..3 {
        let start = seconds();
        (0..rounds).for_each(|_| work());
        best = best.min((seconds() - start) / (rounds * nodes) as f64);
    }
    println!("{label:>10}: {:8.3} us per node", best * 1e6);
}

#[test]
#[ignore = "a measurement"]
fn cost_per_node() {
    let nodes: usize = std::env::var("CHAIN").ok().and_then(|n| n.parse().ok()).unwrap_or(1000);
    let only = std::env::var("ONLY").ok();
    let is_on = |name: &str| only.as_deref().is_none_or(|only| only == name);
    let link = |n: usize| Box::new(Link(std::array::from_fn(|i| NODE * n + i))) as Box<dyn Term>;
    let support = |i| Box::new(Support([i])) as Box<dyn Term>;
    let terms = (0..nodes - 1).map(link).chain((0..NODE).map(support)).collect();
    let (start, clock) = (seconds(), Instant::now());
    let system = System::new(NODE * nodes, NODE, terms);
    println!(
        "    system: {:8.3} us per node ({:.2} s)",
        (seconds() - start) * 1e6 / nodes as f64,
        clock.elapsed().as_secs_f64()
    );
    let mut k = system.matrix();
    let start = seconds();
    let mut factor = Factor::new(k.pattern()).unwrap();
    println!("   symbolic: {:8.3} us per node", (seconds() - start) * 1e6 / nodes as f64);
    let zeros = |n| vec![0.0; n];
    let state = State {
        t: 0.0,
        q: zeros(NODE * nodes),
        v: zeros(NODE * nodes),
        a: zeros(NODE * nodes),
        lambda: zeros(NODE),
        load: 1.0,
    };
    let rounds = (2_000_000 / nodes).max(1);
    system.tangent(&state, Weights::STIFFNESS, &mut k);
    if is_on("tangent") {
        measure("tangent", nodes, rounds, || system.tangent(&state, Weights::STIFFNESS, &mut k));
    }
    factor.factorise(&k).unwrap();
    if is_on("factorise") {
        measure("factorise", nodes, rounds, || factor.factorise(&k).unwrap());
    }
    let mut x = vec![1.0; NODE * (nodes + 1)];
    if is_on("solve") {
        measure("solve", nodes, rounds, || {
            x.fill(1.0);
            factor.solve(&k, &mut x).unwrap();
        });
    }
    assert!(!factor.is_lu());
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = |key: &str| status.lines().find(|line| line.starts_with(key)).unwrap_or("").to_owned();
    println!("{} {}; matrix entries {} per node", line("VmHWM"), line("VmRSS"), k.values().len() / nodes);
}
