//! Page of a study that may be running.

use std::io;
use std::path::PathBuf;

use ancf_report::SceneSource;
use ancf_study::StudyRecord;

use super::page::study_page;

/// Element that reloads the page every ten seconds.
const RELOAD: &str = "<meta http-equiv=\"refresh\" content=\"10\">";

/// Study in a folder that may be growing.
pub struct LiveStudy(PathBuf);

impl LiveStudy {
    /// Creates the source of the study in a folder.
    pub const fn of(folder: PathBuf) -> Self {
        Self(folder)
    }
}

impl SceneSource for LiveStudy {
    fn page(&self) -> io::Result<String> {
        let study = StudyRecord::read(&self.0).map_err(|error| io::Error::other(format!("{error:#}")))?;
        let page = study_page(&self.0, &study.unwrap_or_default());
        Ok(page.replacen("<head>", &format!("<head>{RELOAD}"), 1))
    }

    fn version(&self) -> u64 {
        0
    }

    fn scene(&self) -> io::Result<Vec<u8>> {
        Err(io::Error::other("a study has no scene"))
    }
}
