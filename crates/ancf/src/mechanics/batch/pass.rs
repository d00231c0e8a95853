use pulp::{Arch, Simd, WithSimd};

use super::lane::Pass;

/// What is done in each pass over a batch.
pub(super) trait Job {
    fn run<S: Simd>(&mut self, pass: Pass<S>);
}

struct Passes<'a, J> {
    job: &'a mut J,
    count: usize,
}

impl<J: Job> WithSimd for Passes<'_, J> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        for pass in Pass::all(simd, self.count) {
            self.job.run(pass);
        }
    }
}

/// Does a job for so many terms by the best instructions that this machine has.
pub(super) fn run<J: Job>(count: usize, mut job: J) {
    Arch::new().dispatch(Passes { job: &mut job, count });
}
