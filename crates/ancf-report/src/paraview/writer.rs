use std::borrow::Cow;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ancf::solver::equations::State;
use nalgebra::Vector3;

use super::array::{Array, EncodedArray, Values, encoded};
use super::collection::Collection;
use super::frame_times::FrameTimes;
use super::grid::{EncodedCells, Grid};
use super::mesh::{Mesh, Point, positions};
use super::obstacle::ObstacleSurfaces;
use super::point_data::PointData;
use super::provenance::provenance;
use super::rates::rates;
use super::station_values::StationValues;
use crate::fields::SectionStress;
use crate::geometry::{Geometry, Placement};
use crate::run::{Recording, Snapshot};
use crate::scene::{DisplacedStates, SceneLayout, fits, frame_label};

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
    section_stress: Vec<Option<Arc<SectionStress>>>,
    provenance: Vec<EncodedArray>,
    times: FrameTimes,
    sections: MeshFiles,
    lines: Option<MeshFiles>,
    shells: Option<MeshFiles>,
    obstacles: Option<(ObstacleSurfaces, EncodedCells, Collection)>,
    /// Placement of the undeformed state; of mode shapes, that of the first state.
    reference: Option<Placement>,
    left_out: usize,
}

/// Points and cells of one kind, and their collection.
#[derive(Debug)]
struct MeshFiles {
    points: Vec<Point>,
    cells: EncodedCells,
    collection: Collection,
}

impl MeshFiles {
    fn new(Mesh { points, cells }: Mesh, collection: Collection) -> io::Result<Self> {
        Ok(Self { points, cells: cells.encoded("body")?, collection })
    }
}

/// Content of a collection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Content {
    Sections,
    Lines,
    Shells,
}

/// Maximum number of stations of flexible bodies, unless their elements have more nodes.
const MOST_STATIONS: usize = 10_000;

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
        let parts = layout.parts(MOST_STATIONS);
        let geometry =
            Geometry::new(recording.model, assembly, scales, recording.surfaces, parts, layout.size);
        let initial = assembly.initial();
        let placed = geometry.place(&initial);
        let of = |name| Collection::new(folder, name);
        let files = |mesh: Option<Mesh>, name| -> io::Result<Option<MeshFiles>> {
            mesh.map(|mesh| MeshFiles::new(mesh, of(name)?)).transpose()
        };
        let obstacles = if layout.obstacles.is_empty() {
            None
        } else {
            let mut surfaces = ObstacleSurfaces::new(&layout, &placed, &initial);
            let cells = std::mem::take(&mut surfaces.cells).encoded("obstacle")?;
            Some((surfaces, cells, of("obstacles")?))
        };
        Ok(Self {
            section_stress: SectionStress::at_stations(recording.model, &geometry),
            provenance: encoded(&provenance(recording))?,
            times: FrameTimes::new(recording),
            sections: MeshFiles::new(Mesh::surfaces(&geometry), of("sections")?)?,
            lines: files(Mesh::lines(&geometry), "lines")?,
            shells: files(Mesh::shells(&geometry), "shells")?,
            obstacles,
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
        if self.sections.collection.count() == 0 {
            let initial = self.recording.simulation.assembly().initial();
            self.draw(0.0, Some("undeformed".to_owned()), &initial)?;
        }
        let frames = self.sections.collection.count();
        let obstacles = self.obstacles.iter().map(|(_, _, collection)| collection);
        let surfaces =
            [Some(&self.sections), self.lines.as_ref(), self.shells.as_ref()].into_iter().flatten();
        let collections = surfaces.map(|files| &files.collection).chain(obstacles);
        let files = collections.map(Collection::finish).collect::<io::Result<_>>()?;
        Ok(Written { files, frames, left_out: self.left_out })
    }

    fn draw(&mut self, time: f64, label: Option<String>, s: &State) -> io::Result<()> {
        let reference = self.reference.take().unwrap_or_else(|| self.geometry.place(s));
        let displaced = || DisplacedStates::new(&self.geometry, s, self.layout.size);
        let (shown, imaginary) = match self.recording.is_modal().then(displaced) {
            Some(DisplacedStates { real, imaginary }) => (Cow::Owned(real), imaginary),
            None => (Cow::Borrowed(s), None),
        };
        let placed = self.geometry.place(&shown);
        // All frames have the same arrays: the imaginary part of a real shape is zero.
        let place = || imaginary.map_or_else(|| reference.clone(), |state| self.geometry.place(&state));
        let imaginary = self.recording.is_complex().then(place);
        if placed.is_finite() && imaginary.as_ref().is_none_or(Placement::is_finite) {
            let field_data = self.field_data(time, label, s)?;
            let placements =
                Placements { placed: &placed, reference: &reference, imaginary: imaginary.as_ref() };
            self.write(time, &shown, placements, &field_data)?;
        } else {
            self.left_out += 1;
        }
        self.reference = Some(reference);
        Ok(())
    }

    fn field_data(&self, time: f64, label: Option<String>, s: &State) -> io::Result<Vec<EncodedArray>> {
        let mut arrays: Vec<_> =
            label.into_iter().map(|label| Array::new("label", 1, Values::Text(vec![label]))).collect();
        arrays.push(Array::new("load_factor", 1, Values::F64(vec![s.load])));
        arrays.push(Array::new("TimeValue", 1, Values::F64(vec![time])));
        let mut all = self.provenance.clone();
        all.extend(encoded(&arrays)?);
        Ok(all)
    }

    /// Writes a frame, given its placements.
    fn write(
        &mut self,
        time: f64,
        s: &State,
        placements: Placements<'_>,
        field_data: &[EncodedArray],
    ) -> io::Result<()> {
        let dynamics = self.recording.model.analysis.dynamics();
        let moving = dynamics.map(|_| rates(&self.geometry, s, &placements.placed.directors));
        let (assembly, scales) = (self.recording.simulation.assembly(), self.recording.scales());
        let values = (!self.recording.is_modal())
            .then(|| StationValues::new(&self.geometry, &self.section_stress, assembly, scales, s));
        let of_frame = (placements, moving.as_ref(), values.as_ref());
        let all = [Content::Sections, Content::Lines, Content::Shells];
        let data = all.map(|content| Some(self.data(&self.files(content)?.points, content, of_frame)));
        for (content, data) in all.into_iter().zip(data) {
            let Some(((point_data, points), files)) = data.zip(self.files_mut(content)) else { continue };
            files.collection.push(time, Grid { points, cells: &files.cells, point_data }, field_data)?;
        }
        if let Some((obstacles, cells, collection)) = &mut self.obstacles {
            let still = self.layout.obstacles.iter().all(|obstacle| !obstacle.moves);
            if !still || collection.count() == 0 {
                let points = obstacles.positions(&self.layout, s);
                collection.push(time, Grid { points, cells, point_data: Vec::new() }, field_data)?;
            }
        }
        Ok(())
    }

    const fn files(&self, content: Content) -> Option<&MeshFiles> {
        match content {
            Content::Sections => Some(&self.sections),
            Content::Lines => self.lines.as_ref(),
            Content::Shells => self.shells.as_ref(),
        }
    }

    const fn files_mut(&mut self, content: Content) -> Option<&mut MeshFiles> {
        match content {
            Content::Sections => Some(&mut self.sections),
            Content::Lines => self.lines.as_mut(),
            Content::Shells => self.shells.as_mut(),
        }
    }

    /// Data at points in a state, and their positions.
    fn data(
        &self,
        of: &[Point],
        content: Content,
        (Placements { placed, reference, imaginary }, moving, values): FrameData<'_>,
    ) -> (Vec<Array>, Vec<Vector3<f64>>) {
        let fields = PointData { geometry: &self.geometry, points: of, single: content == Content::Sections };
        let points = positions(of, placed);
        let start = positions(of, reference);
        let from_start = |points: &[Vector3<f64>]| -> Vec<_> {
            points.iter().zip(&start).map(|(x, from)| x - from).collect()
        };
        let mut point_data = match content {
            Content::Sections | Content::Lines => vec![fields.arc_length()],
            Content::Shells => fields.shell_places(),
        };
        let name = if self.recording.is_modal() { "shape" } else { "displacement" };
        point_data.push(fields.vectors(name, &from_start(&points)));
        point_data.extend(
            imaginary.map(|placed| fields.vectors("shape_imaginary", &from_start(&positions(of, placed)))),
        );
        point_data.extend(values.into_iter().flat_map(|values| match content {
            Content::Sections | Content::Lines => fields.section_data(values),
            Content::Shells => fields.shell_data(values, placed),
        }));
        for (name, rates) in ["velocity", "acceleration"].into_iter().zip(moving.into_iter().flatten()) {
            point_data.push(fields.vectors(name, &positions(of, rates)));
        }
        match content {
            Content::Sections => {}
            Content::Lines => point_data.extend(fields.axes(placed, ["normal", "y_axis", "z_axis"])),
            Content::Shells => point_data.extend(fields.axes(placed, ["normal", "u_axis", "v_axis"])),
        }
        (point_data, points)
    }
}

/// Placements of a frame.
#[derive(Clone, Copy)]
struct Placements<'a> {
    placed: &'a Placement,
    reference: &'a Placement,
    /// Placement by the imaginary part of the shape; `None` except in damped modes.
    imaginary: Option<&'a Placement>,
}

/// Placements, rates of dynamics, and values at the stations without those of mode shapes.
type FrameData<'a> = (Placements<'a>, Option<&'a [Placement; 2]>, Option<&'a StationValues<'a>>);
