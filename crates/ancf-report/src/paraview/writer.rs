use std::borrow::Cow;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use ancf::system::State;

use super::array::{Array, Values};
use super::clock::Clock;
use super::collection::Collection;
use super::fields::Fields;
use super::grid::Grid;
use super::mesh::Mesh;
use super::motion::rates;
use super::obstacle::Obstacles;
use super::tags::tags;
use crate::fibre::Fibre;
use crate::instants::{fits, label};
use crate::shape::displaced;
use crate::stage::Stage;
use crate::{Frame, Geometry, Placement, Recording};

/// What was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The collections, to be opened in ParaView.
    pub files: Vec<PathBuf>,
    /// Frames in each.
    pub frames: usize,
    /// Frames that were left out: of another model, or not all of their positions are numbers.
    pub left_out: usize,
}

/// Writes frames of a recording for ParaView, one at a time; the frames in the recording itself are not looked at.
pub struct Writer<'a> {
    recording: &'a Recording<'a>,
    stage: Stage<'a>,
    geometry: Geometry<'a>,
    fibres: Vec<Option<Fibre>>,
    tags: Vec<Array>,
    clock: Clock,
    sections: (Mesh, Collection),
    lines: (Mesh, Collection),
    obstacles: Option<(Obstacles, Collection)>,
    /// The undeformed state; of shapes, that about which they are: the first one.
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
    /// Makes the folder, if there is none; collections that are there are replaced.
    ///
    /// # Errors
    /// If it cannot be written; the error names the path.
    pub fn new(recording: &'a Recording<'a>, folder: &Path) -> io::Result<Self> {
        let (assembly, scales) = (recording.simulation.assembly(), recording.scales());
        let stage = Stage::new(recording, &recording.model.scaled(&scales));
        let (parts, _) = stage.resolution(usize::MAX);
        let geometry = Geometry::new(recording.model, assembly, scales, parts, stage.size);
        let initial = assembly.initial();
        let placed = geometry.place(&initial);
        let some = !stage.obstacles.is_empty();
        let obstacles = some.then(|| Obstacles::new(&stage, &placed, &initial));
        let of = |name| Collection::new(folder, name);
        Ok(Self {
            fibres: Fibre::all(recording.model, &geometry),
            tags: tags(recording),
            clock: Clock::new(recording),
            sections: (Mesh::sections(&geometry), of("sections")?),
            lines: (Mesh::lines(&geometry), of("lines")?),
            obstacles: obstacles
                .map(|obstacles| Ok::<_, io::Error>((obstacles, of("obstacles")?)))
                .transpose()?,
            reference: (!recording.is_modal()).then_some(placed),
            left_out: 0,
            recording,
            stage,
            geometry,
        })
    }

    /// Writes the next frame.
    ///
    /// # Errors
    /// If it cannot be written; the error names the path.
    pub fn push(&mut self, frame: &Frame) -> io::Result<()> {
        let time = self.clock.time(frame.value);
        if !fits(self.recording.simulation.assembly(), &frame.state) || !time.is_finite() {
            self.left_out += 1;
            return Ok(());
        }
        // Times speak for themselves.
        let moves = self.recording.model.analysis.dynamics().is_some();
        let label = (!moves).then(|| label(self.recording, frame));
        self.draw(time, label, &frame.state)
    }

    /// Writes the collections; without any frame, of the undeformed state.
    ///
    /// # Errors
    /// If they cannot be written; the error names the path.
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
            true => Cow::Owned(displaced(&self.geometry, s, self.stage.size)),
            false => Cow::Borrowed(s),
        };
        let placed = self.geometry.place(&shown);
        if placed.is_finite() {
            let tags = self.tagged(time, label, s);
            self.write(time, &shown, [&placed, &reference], &tags)?;
        } else {
            self.left_out += 1;
        }
        self.reference = Some(reference);
        Ok(())
    }

    fn tagged(&self, time: f64, label: Option<String>, s: &State) -> Vec<Array> {
        let mut tags = self.tags.clone();
        tags.extend(label.map(|label| Array::new("label", 1, Values::Text(vec![label]))));
        tags.push(Array::new("load_factor", 1, Values::F64(vec![s.load])));
        tags.push(Array::new("TimeValue", 1, Values::F64(vec![time])));
        tags
    }

    fn write(&mut self, time: f64, s: &State, places: [&Placement; 2], tags: &[Array]) -> io::Result<()> {
        let moving = self.recording.model.analysis.dynamics().map(|_| rates(&self.geometry, s));
        let all = [(&self.sections.0, true), (&self.lines.0, false)];
        let [sections, lines] = all.map(|(mesh, single)| self.grid(mesh, single, s, places, moving.as_ref()));
        self.sections.1.push(time, &sections, tags)?;
        self.lines.1.push(time, &lines, tags)?;
        if let Some((obstacles, collection)) = &mut self.obstacles {
            let still = self.stage.obstacles.iter().all(|obstacle| !obstacle.moves);
            if !still || collection.count() == 0 {
                let points = obstacles.spread(&self.stage, s);
                let grid =
                    Grid { points, cells: &obstacles.cells, owner: "obstacle", point_data: Vec::new() };
                collection.push(time, &grid, tags)?;
            }
        }
        Ok(())
    }

    /// A mesh in a state with its fields.
    fn grid<'m>(
        &self,
        mesh: &'m Mesh,
        single: bool,
        s: &State,
        [placed, reference]: [&Placement; 2],
        moving: Option<&[Placement; 2]>,
    ) -> Grid<'m> {
        let (assembly, scales) = (self.recording.simulation.assembly(), self.recording.scales());
        let fields = Fields { geometry: &self.geometry, assembly, fibres: &self.fibres, scales, single };
        let points = mesh.spread(placed);
        let moved: Vec<_> = points.iter().zip(mesh.spread(reference)).map(|(x, from)| x - from).collect();
        let mut point_data = vec![fields.arc_length(mesh)];
        if self.recording.is_modal() {
            point_data.push(fields.vectors("shape", &moved));
        } else {
            point_data.push(fields.vectors("displacement", &moved));
            point_data.extend(fields.inner(mesh, s));
        }
        for (name, rates) in ["velocity", "acceleration"].into_iter().zip(moving.into_iter().flatten()) {
            point_data.push(fields.vectors(name, &mesh.spread(rates)));
        }
        if !single {
            point_data.extend(fields.axes(mesh, placed));
        }
        Grid { points, cells: &mesh.cells, owner: "body", point_data }
    }
}
