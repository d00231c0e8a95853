//! Bytes as a file in the folder of a run: read, and the run is resumed.
#![no_main]

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

#[path = "../../crates/ancf-results/tests/it/common/anything.rs"]
mod anything;

/// Folder of a run and folder of the input. They are in memory if possible, because each input writes several files.
static FOLDERS: LazyLock<(PathBuf, PathBuf)> = LazyLock::new(|| {
    let memory = Path::new("/dev/shm");
    let own = if memory.is_dir() { memory.to_owned() } else { std::env::temp_dir() };
    let own = own.join(format!("ancf-fuzz-{}", std::process::id()));
    let folders = ["run", "input"].map(|name| own.join(name));
    folders.iter().for_each(|folder| std::fs::create_dir_all(folder).expect("a folder"));
    anything::stopped(&folders[0]);
    folders.into()
});

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let (run, folder) = &*FOLDERS;
    anything::results(run, folder, bytes);
});
