//! Solution of verification problems on several threads.

use std::panic;
use std::sync::Mutex;
use std::time::Instant;

use ancf_verification::{Findings, Problem};

use super::verdict::ProblemVerdict;

/// Number of problems that are solved simultaneously.
const THREADS: usize = 2;

/// Solves problems. Passes each verdict to `observer` when it is known, and returns all of them in the order of the problems.
pub fn solve_problems(
    problems: &[Problem],
    observer: impl Fn(&ProblemVerdict) + Sync,
) -> Vec<ProblemVerdict> {
    let queue = Mutex::new(problems.iter().enumerate());
    let next = || queue.lock().ok()?.next();
    let worker = || {
        let mut done = Vec::new();
        while let Some((index, problem)) = next() {
            let verdict = solve(*problem);
            observer(&verdict);
            done.push((index, verdict));
        }
        done
    };
    let mut done = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..THREADS).map(|_| scope.spawn(worker)).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap_or_default()).collect::<Vec<_>>()
    });
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, verdict)| verdict).collect()
}

/// Solves a problem. Errors and panics become its verdict.
fn solve(problem: Problem) -> ProblemVerdict {
    let clock = Instant::now();
    let findings: Result<Findings, String> = match panic::catch_unwind(problem.run) {
        Ok(run) => run.map_err(|error| error.to_string()),
        Err(_) => Err("internal error of the program".to_owned()),
    };
    ProblemVerdict { problem, findings, seconds: clock.elapsed().as_secs_f64() }
}
