//! Worker threads that run one case at a time.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use super::row::CaseRow;
use ancf::solver::newton::Interrupt;

/// Interval of the calls of `receive` while no case ends.
const TICK: Duration = Duration::from_millis(200);
/// Stack size of a thread in bytes, as of a main thread.
const STACK: usize = 8 << 20;

/// Runs cases on `jobs` threads. Passes each row to `receive` when its case ends, and `None` from time to time.
///
/// Every worker has a thread pool of its own: a case does not wait for work of another case. The pool has one thread, which is
/// fastest for small models, and more only if there are fewer cases than threads. The interrupt flag stops the workers.
///
/// # Errors
/// The first error of `receive`. It stops the workers.
pub fn run_cases<E>(
    cases: &[usize],
    jobs: usize,
    interrupt: &Interrupt,
    work: impl Fn(usize) -> CaseRow + Sync,
    mut receive: impl FnMut(Option<(usize, CaseRow)>) -> Result<(), E>,
) -> Result<(), E> {
    let workers = jobs.min(cases.len());
    let threads = (jobs / workers.max(1)).max(1);
    let next = AtomicUsize::new(0);
    let (send, received) = mpsc::channel();
    thread::scope(|scope| {
        // Dropped at the end of the scope. After an error the workers stop with their current case.
        let received = received;
        for _ in 0..workers {
            let (send, next, work) = (send.clone(), &next, &work);
            scope.spawn(move || {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build();
                while let Some(&case) = cases.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let row = match &pool {
                        _ if interrupt.is_set() => break,
                        Ok(pool) => pool.install(|| work(case)),
                        Err(_) => work(case),
                    };
                    if send.send((case, row)).is_err() {
                        break;
                    }
                }
            });
        }
        drop(send);
        loop {
            match received.recv_timeout(TICK) {
                Ok(row) => receive(Some(row))?,
                Err(RecvTimeoutError::Timeout) => receive(None)?,
                Err(RecvTimeoutError::Disconnected) => return Ok(()),
            }
        }
    })
}
