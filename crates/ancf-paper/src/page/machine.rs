//! Where times were measured.

use std::fs;

use maud::{Markup, html};
use serde::Serialize;

/// The machine and the program.
#[derive(Clone, Debug, Serialize)]
pub struct Machine {
    /// Name of the processor.
    pub processor: String,
    /// Cores that the program may use; timings use one.
    pub cores: usize,
    /// Operating system and architecture.
    pub system: String,
    /// Version of the program.
    pub version: &'static str,
    /// Whether it was compiled with optimisation; times mean little without.
    pub optimised: bool,
}

impl Machine {
    /// The machine that this runs on.
    pub fn this() -> Self {
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

    /// Program and machine as entries of a list of terms.
    pub fn entries(&self) -> Markup {
        html! {
            dt { "Program" } dd {
                "ancf " (self.version) @if !self.optimised { ", not optimised: times mean little" }
            }
            dt { "Machine" } dd { (self.processor) ", " (self.cores) " cores, " (self.system) }
        }
    }
}
