//! Execution of a study: design, missing cases on worker threads, table.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use ancf::solver::newton::Interrupt;

use crate::cases::{BaseModel, CaseDesign, CaseRow, run_cases};
use crate::part::StudyPart;
use crate::source::StudySource;
use crate::table::StudyError;
use crate::table::{StudyResults, read_rows};

/// Settings of one execution of a study.
#[derive(Clone, Debug)]
pub struct StudySettings {
    /// Folder of the table.
    pub folder: PathBuf,
    /// Part of the cases to run; all cases if it is `None`.
    pub part: Option<StudyPart>,
    /// True to run cases again that failed or were invalid.
    pub retry: bool,
}

/// Study that is ready to run its missing cases.
#[derive(Debug)]
pub struct StudyRun {
    base: BaseModel,
    results: StudyResults,
}

impl StudyRun {
    /// Creates the folder and the design, and takes over the rows of earlier runs in the folder.
    ///
    /// # Errors
    /// If there are too many cases, if the folder cannot be created, or if a table in it cannot be read.
    pub fn prepare(source: StudySource, settings: &StudySettings) -> Result<Self, StudyError> {
        let StudySource { study, text, base } = source;
        let design = CaseDesign::new(&study).ok_or(StudyError::TooManyCases)?;
        let cases = settings.part.unwrap_or(StudyPart::ALL).cases(design.cases());
        let folder = &settings.folder;
        fs::create_dir_all(folder).map_err(|source| StudyError::File {
            action: "create",
            path: folder.clone(),
            source,
        })?;
        let file = settings.part.map_or_else(|| "cases.parquet".into(), StudyPart::file_name);
        let objectives = study.objectives;
        let keys: BTreeMap<usize, String> =
            cases.iter().map(|&case| (case, design.key(&base, &objectives, case))).collect();
        let earlier = read_rows(folder, &objectives)?;
        let mut results = StudyResults::new(design, objectives, text, folder.join(file), keys);
        results.take_over(&earlier, settings.retry);
        Ok(Self { base, results })
    }

    /// Runs the missing cases on `jobs` threads and writes the table, also while cases run.
    ///
    /// Calls `observer` after each case.
    ///
    /// # Errors
    /// If the table cannot be written.
    pub fn execute(
        &mut self,
        jobs: usize,
        interrupt: &Interrupt,
        mut observer: impl FnMut(&StudyResults),
    ) -> Result<(), StudyError> {
        let Self { base, results } = self;
        let (missing, design, objectives) =
            (results.missing(), results.design().clone(), results.objectives().clone());
        let work = |case| CaseRow::run(case, &design, base, &objectives, interrupt);
        run_cases(&missing, jobs, interrupt, work, |row| {
            if let Some((case, row)) = row {
                results.add(case, row);
                observer(results);
            }
            results.write_if_due()
        })?;
        results.write()
    }

    /// Returns the results.
    pub const fn results(&self) -> &StudyResults {
        &self.results
    }
}
