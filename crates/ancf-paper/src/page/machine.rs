//! Machine on which times were measured.

use std::fs;

use maud::{Markup, html};
use serde::Serialize;

/// Machine and version of the program.
#[derive(Clone, Debug, Serialize)]
pub struct MachineInfo {
    /// Name of the processor.
    pub processor: String,
    /// Available cores. Timings use one.
    pub cores: usize,
    /// Operating system and architecture.
    pub system: String,
    /// Version of the program.
    pub version: &'static str,
    /// True if the program was compiled with optimisation. Otherwise times are not meaningful.
    pub optimised: bool,
}

impl MachineInfo {
    /// Returns the properties of this machine.
    pub fn current() -> Self {
        let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let name = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
        Self {
            processor: name.map_or("unknown processor", |(_, name)| name).to_owned(),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            version: env!("CARGO_PKG_VERSION"),
            optimised: !cfg!(debug_assertions),
        }
    }

    /// Returns program and machine as entries of a description list.
    pub fn entries(&self) -> Markup {
        html! {
            dt { "Program" } dd {
                "ancf " (self.version) @if !self.optimised { ", not optimised: times are not meaningful" }
            }
            dt { "Machine" } dd { (self.processor) ", " (self.cores) " cores, " (self.system) }
        }
    }
}
