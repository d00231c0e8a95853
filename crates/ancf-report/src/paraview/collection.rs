use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::array::EncodedArray;
use super::grid::{Grid, with_path, write_document};

/// Numbered files of one kind, and their times.
#[derive(Debug)]
pub(super) struct Collection {
    folder: PathBuf,
    name: &'static str,
    times: Vec<f64>,
}

impl Collection {
    /// Creates the folder and removes the list of an earlier collection, whose files are about to change.
    pub fn new(folder: &Path, name: &'static str) -> io::Result<Self> {
        let own = folder.join(name);
        fs::create_dir_all(&own).map_err(|error| with_path("create the folder", &own, &error))?;
        let collection = Self { folder: folder.to_owned(), name, times: Vec::new() };
        let index = collection.index();
        match fs::remove_file(&index) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                Err(with_path("replace", &index, &error))
            }
            _ => Ok(collection),
        }
    }

    fn index(&self) -> PathBuf {
        self.folder.join(self.name).with_extension("pvd")
    }

    fn file(&self, number: usize) -> String {
        format!("{}/{number:05}.vtu", self.name)
    }

    /// Number of files.
    pub fn count(&self) -> usize {
        self.times.len()
    }

    /// Writes the next file.
    pub fn push(&mut self, time: f64, grid: Grid<'_>, tags: &[EncodedArray]) -> io::Result<()> {
        grid.write(&self.folder.join(self.file(self.times.len())), tags)?;
        self.times.push(time);
        Ok(())
    }

    /// Removes remaining files of a longer earlier collection and writes the list of files with their times.
    pub fn finish(&self) -> io::Result<PathBuf> {
        let left = |number: &usize| {
            let file = self.folder.join(self.file(*number));
            fs::remove_file(file).is_ok()
        };
        (self.times.len()..).take_while(left).for_each(drop);
        let index = self.index();
        write_document(&index, "Collection", |writer| {
            writer.create_element("Collection").write_inner_content(|writer| {
                for (number, time) in self.times.iter().enumerate() {
                    let (time, file) = (time.to_string(), self.file(number));
                    let parts = [("timestep", time.as_str()), ("part", "0"), ("file", &file)];
                    writer.create_element("DataSet").with_attributes(parts).write_empty()?;
                }
                Ok(())
            })?;
            Ok(())
        })?;
        Ok(index)
    }
}
