//! Threads that run cases, one case each at a time.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use ancf::analysis::Interrupt;
use anyhow::Result;

use super::row::Row;

/// How often the receiver is called if no case ends.
const TICK: Duration = Duration::from_millis(200);
/// Bytes of stack of a thread, as the main thread of a program has.
const STACK: usize = 8 << 20;

/// Runs cases on so many threads and hands on each row as it comes; `None` now and then, if none comes.
///
/// A case has a pool of its own, so that it does not wait for work of another. It has one thread, which makes small models
/// fastest; more only if there are fewer cases than threads. Ctrl-C ends it.
///
/// # Errors
/// Those of `receive`, which end it too.
pub fn run(
    cases: &[usize],
    jobs: usize,
    interrupt: &Interrupt,
    work: impl Fn(usize) -> Row + Sync,
    mut receive: impl FnMut(Option<(usize, Row)>) -> Result<()>,
) -> Result<()> {
    let workers = jobs.min(cases.len());
    let threads = (jobs / workers.max(1)).max(1);
    let next = AtomicUsize::new(0);
    let (send, received) = mpsc::channel();
    thread::scope(|scope| {
        // Dropped with the scope, so that an error here ends the workers after the case they are at.
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
