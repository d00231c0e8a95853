//! Replay of the corpus of the fuzz target `results`, and files with random damage.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use tempfile::TempDir;

use crate::common::anything;

/// Temporary folder, in memory if possible, because each case writes several files.
fn folder() -> TempDir {
    TempDir::new_in("/dev/shm").or_else(|_| TempDir::new()).unwrap()
}

fn assert_read(run: &Path, folder: &Path, bytes: &[u8], what: &str) {
    let done = catch_unwind(AssertUnwindSafe(|| anything::results(run, folder, bytes)));
    assert!(done.is_ok(), "{what} panics");
}

#[test]
fn the_corpus() {
    let [run, damaged] = [folder(), folder()];
    anything::stopped(run.path());
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/results");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(!files.is_empty());
    for file in files {
        assert_read(run.path(), damaged.path(), &fs::read(&file).unwrap(), &file.display().to_string());
    }
}

/// Each file of a run with one bit changed at random positions.
#[test]
fn damaged_files() {
    let [run, folder] = [folder(), folder()];
    anything::stopped(run.path());
    for (which, name) in
        ["results.parquet", "states.parquet", "checkpoint", "summary.json"].into_iter().enumerate()
    {
        let mut bytes = fs::read(run.path().join(name)).unwrap();
        if name == "checkpoint" {
            bytes.truncate(bytes.len() - 32);
        }
        bytes.insert(0, which as u8);
        let mut random = 0x2545_f491_4f6c_dd1d_u64;
        for _ in 0..400 {
            random = random.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(1);
            let place = 1 + (random >> 33) as usize % (bytes.len() - 1);
            let mut damaged = bytes.clone();
            damaged[place] ^= 1 << (random >> 29 & 7);
            if random >> 60 == 0 {
                damaged.truncate(place);
            }
            assert_read(run.path(), folder.path(), &damaged, &format!("{name} with byte {place} changed"));
        }
    }
}
