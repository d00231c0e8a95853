//! Integration tests of the program `ancf`: commands, files, messages, exit codes.
#![cfg(test)]

mod checks;
mod damage;
mod estimates;
mod fmu;
mod folder;
#[cfg(target_os = "linux")]
mod full_disk;
mod gradients;
mod numerics;
mod output;
#[cfg(feature = "figures")]
mod paper;
#[cfg(unix)]
mod resume;
mod run_folder;
mod runs;
mod sequences;
mod starts;
mod study;
#[cfg(feature = "figures")]
mod verify;
