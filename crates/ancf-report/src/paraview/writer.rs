use std::borrow::Cow;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use ancf::solver::equations::State;

use super::array::{Array, Values};
use super::collection::Collection;
use super::frame_times::FrameTimes;
use super::grid::Grid;
use super::mesh::Mesh;
use super::obstacle::ObstacleSurfaces;
use super::point_data::PointData;
use super::provenance::provenance;
use super::rates::rates;
use crate::fields::SectionStress;
use crate::geometry::{Geometry, Placement};
use crate::run::{Recording, Snapshot};
use crate::scene::{SceneLayout, displaced, fits, frame_label};

/// Result of writing the files of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// Paths of the collections.
    pub files: Vec<PathBuf>,
    /// Number of frames in each collection.
    pub frames: usize,
    /// Number of omitted frames: frames of another model, and frames with positions that are not finite.
    pub left_out: usize,
}

/// Writes frames for ParaView one at a time. The frames of the recording itself are ignored.
pub struct Writer<'a> {
    recording: &'a Recording<'a>,
    layout: SceneLayout<'a>,
    geometry: Geometry<'a>,
    section_stress: Vec<Option<SectionStress>>,
    provenance: Vec<Array>,
    times: FrameTimes,
    sections: (Mesh, Collection),
    lines: (Mesh, Collection),
    obstacles: Option<(ObstacleSurfaces, Collection)>,
    /// Placement of the undeformed state; of mode shapes, that of the first state.
    reference: Option<Placement>,
    left_out: usize,
}

impl fmt::Debug for Writer<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { sections, left_out, .. } = self;
        f.debug_struct("Writer")
            .field("sections", sections)
            .field("left_out", left_out)
            .finish_non_exhaustive()
    }
}

impl<'a> Writer<'a> {
    /// Creates the folder if necessary. Existing collections are replaced.
    ///
    /// # Errors
    /// If the folder cannot be written. The error contains the path.
    pub fn new(recording: &'a Recording<'a>, folder: &Path) -> io::Result<Self> {
        let (assembly, scales) = (recording.simulation.assembly(), recording.scales());
        let layout = SceneLayout::new(recording, &recording.model.scaled(&scales));
        let (parts, _) = layout.resolution(usize::MAX);
        let geometry =
            Geometry::new(recording.model, assembly, scales, recording.surfaces, parts, layout.size);
        let initial = assembly.initial();
        let placed = geometry.place(&initial);
        let has_obstacles = !layout.obstacles.is_empty();
        let obstacles = has_obstacles.then(|| ObstacleSurfaces::new(&layout, &placed, &initial));
        let of = |name| Collection::new(folder, name);
        Ok(Self {
            section_stress: SectionStress::at_stations(recording.model, &geometry),
            provenance: provenance(recording),
            times: FrameTimes::new(recording),
            sections: (Mesh::surfaces(&geometry), of("sections")?),
            lines: (Mesh::lines(&geometry), of("lines")?),
            obstacles: obstacles
                .map(|obstacles| Ok::<_, io::Error>((obstacles, of("obstacles")?)))
                .transpose()?,
            reference: (!recording.is_modal()).then_some(placed),
            left_out: 0,
            recording,
            layout,
            geometry,
        })
    }

    /// Writes the next frame.
    ///
    /// # Errors
    /// If a file cannot be written. The error contains the path.
    pub fn push(&mut self, frame: &Snapshot) -> io::Result<()> {
        let time = self.times.time(frame.value);
        if !fits(self.recording.simulation.assembly(), &frame.state) || !time.is_finite() {
            self.left_out += 1;
            return Ok(());
        }
        // Frames of dynamics are identified by their times.
        let is_dynamic = self.recording.model.analysis.dynamics().is_some();
        let label = (!is_dynamic).then(|| frame_label(self.recording, frame));
        self.draw(time, label, &frame.state)
    }

    /// Writes the collections. Without frames, they contain the undeformed state.
    ///
    /// # Errors
    /// If a file cannot be written. The error contains the path.
    pub fn finish(mut self) -> io::Result<Written> {
        if self.sections.1.count() == 0 {
            let initial = self.recording.simulation.assembly().initial();
            self.draw(0.0, Some("undeformed".to_owned()), &initial)?;
        }
        let frames = self.sections.1.count();
        let obstacles = self.obstacles.iter().map(|(_, collection)| collection);
        let collections = [&self.sections.1, &self.lines.1].into_iter().chain(obstacles);
        let files = collections.map(Collection::finish).collect::<io::Result<_>>()?;
        Ok(Written { files, frames, left_out: self.left_out })
    }

    fn draw(&mut self, time: f64, label: Option<String>, s: &State) -> io::Result<()> {
        let reference = self.reference.take().unwrap_or_else(|| self.geometry.place(s));
        let shown = match self.recording.is_modal() {
            true => Cow::Owned(displaced(&self.geometry, s, self.layout.size)),
            false => Cow::Borrowed(s),
        };
        let placed = self.geometry.place(&shown);
        if placed.is_finite() {
            let field_data = self.field_data(time, label, s);
            self.write(time, &shown, [&placed, &reference], &field_data)?;
        } else {
            self.left_out += 1;
        }
        self.reference = Some(reference);
        Ok(())
    }

    fn field_data(&self, time: f64, label: Option<String>, s: &State) -> Vec<Array> {
        let mut arrays = self.provenance.clone();
        arrays.extend(label.map(|label| Array::new("label", 1, Values::Text(vec![label]))));
        arrays.push(Array::new("load_factor", 1, Values::F64(vec![s.load])));
        arrays.push(Array::new("TimeValue", 1, Values::F64(vec![time])));
        arrays
    }

    /// Writes a frame, given its placement and that of the reference.
    fn write(
        &mut self,
        time: f64,
        s: &State,
        placements: [&Placement; 2],
        field_data: &[Array],
    ) -> io::Result<()> {
        let moving = self.recording.model.analysis.dynamics().map(|_| rates(&self.geometry, s));
        let all = [(&self.sections.0, true), (&self.lines.0, false)];
        let [sections, lines] =
            all.map(|(mesh, single)| self.grid(mesh, single, s, placements, moving.as_ref()));
        self.sections.1.push(time, &sections, field_data)?;
        self.lines.1.push(time, &lines, field_data)?;
        if let Some((obstacles, collection)) = &mut self.obstacles {
            let still = self.layout.obstacles.iter().all(|obstacle| !obstacle.moves);
            if !still || collection.count() == 0 {
                let points = obstacles.positions(&self.layout, s);
                let grid =
                    Grid { points, cells: &obstacles.cells, owner: "obstacle", point_data: Vec::new() };
                collection.push(time, &grid, field_data)?;
            }
        }
        Ok(())
    }

    /// Grid of a mesh in a state with its point data.
    fn grid<'m>(
        &self,
        mesh: &'m Mesh,
        single: bool,
        s: &State,
        [placed, reference]: [&Placement; 2],
        moving: Option<&[Placement; 2]>,
    ) -> Grid<'m> {
        let (assembly, scales) = (self.recording.simulation.assembly(), self.recording.scales());
        let fields =
            PointData { geometry: &self.geometry, assembly, sections: &self.section_stress, scales, single };
        let points = mesh.positions(placed);
        let moved: Vec<_> = points.iter().zip(mesh.positions(reference)).map(|(x, from)| x - from).collect();
        let mut point_data = vec![fields.arc_length(mesh)];
        if self.recording.is_modal() {
            point_data.push(fields.vectors("shape", &moved));
        } else {
            point_data.push(fields.vectors("displacement", &moved));
            point_data.extend(fields.section_data(mesh, s));
        }
        for (name, rates) in ["velocity", "acceleration"].into_iter().zip(moving.into_iter().flatten()) {
            point_data.push(fields.vectors(name, &mesh.positions(rates)));
        }
        if !single {
            point_data.extend(fields.axes(mesh, placed));
        }
        Grid { points, cells: &mesh.cells, owner: "body", point_data }
    }
}
