//! Shapes of bodies and positions of joints, as the report draws them.

use std::sync::Arc;

use ancf::model::{Body, Section};
use ancf::solver::equations::State;
use ancf::units::Dimension;
use ancf::{Model, Simulation};
use ancf_report::geometry::{self, ARM, Geometry, Link, Outline, Symbols};
use ancf_report::shape_factor;
use ancf_surface::Triangles;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;

use crate::input::detached;
use crate::input::{DataReader, deserialize_part, valid_model};
use crate::run::States;

/// Stations per element from which the factor of a shape is computed.
const PARTS: u32 = 4;

/// Edges and principal axes of a box.
type EdgesAndAxes<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

/// Points of outlines, points of bores, edges.
type OutlineArrays<'py, A> = (Bound<'py, A>, Option<Bound<'py, A>>, Bound<'py, PyArray2<i64>>);

/// Points and corners of triangles.
type SurfaceArrays<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<i64>>);

/// Names, kinds, positions of symbols or ends of links.
type Placed<'py, A> = (Vec<String>, Vec<&'static str>, Bound<'py, A>);

/// Returns the outline of a section: outer points and points of the bore `[point, 2]`, and edges `[edge, 2]`.
#[pyfunction]
pub(crate) fn outline<'py>(
    section: &Bound<'py, PyAny>,
    sides: usize,
) -> PyResult<OutlineArrays<'py, PyArray2<f64>>> {
    let py = section.py();
    let outline = geometry::outline(&deserialize_part::<Section>("Section", section)?, sides);
    let points = |points: &[[f64; 4]]| flat(py, points).reshape([points.len(), 2]);
    let inner = outline.inner.as_deref().map(points).transpose()?;
    Ok((points(&outline.outer)?, inner, edges(py, &outline)?))
}

/// Returns edges and principal axes of the box with the inertia of a rigid body.
#[pyfunction]
pub(crate) fn inertia_box<'py>(body: &Bound<'py, PyAny>, max_edge: f64) -> PyResult<EdgesAndAxes<'py>> {
    let py = body.py();
    let Body::Rigid(rigid) = deserialize_part::<Body>("Body", body)? else {
        return Err(PyValueError::new_err("body: found another kind, expected a rigid body"));
    };
    let inertia = geometry::inertia_box(&rigid, max_edge);
    let axes = PyArray1::from_slice(py, inertia.axes.as_flattened()).reshape([3, 3])?;
    Ok((PyArray1::from_slice(py, &inertia.edges), axes))
}

/// Geometry of a model and its states.
#[pyclass(frozen, module = "ancf._ancf")]
#[derive(Debug)]
pub(crate) struct ModelGeometry {
    model: Model,
    simulation: Arc<Simulation>,
    states: Py<States>,
    symbols: Symbols,
    /// Springs, rods and bushings.
    links: Vec<Link>,
}

#[pymethods]
impl ModelGeometry {
    /// Reads the model of states.
    #[new]
    fn new(states: &Bound<'_, States>) -> PyResult<Self> {
        let py = states.py();
        let own = states.get();
        let data = DataReader::default().model(own.model.bind(py))?;
        let model = valid_model(py, &data)?;
        let simulation = Arc::clone(&own.simulation);
        let symbols = geometry::symbols(&model, &simulation);
        let mut links = geometry::model_links(&model, &simulation);
        links.retain(|link| link.kind != ARM);
        Ok(Self { model, simulation, states: states.clone().unbind(), symbols, links })
    }

    /// Returns the outlines of a beam or cable at fractions of its length: points `[fraction, point, 2]` and edges.
    fn outlines<'py>(
        &self,
        py: Python<'py>,
        body: &str,
        fractions: Vec<f64>,
        sides: usize,
    ) -> PyResult<OutlineArrays<'py, PyArray3<f64>>> {
        let body = self.body(body)?;
        let at = |fraction: &f64| geometry::outline_at(&self.model, body, *fraction, sides);
        let outlines: Option<Vec<Outline>> = fractions.iter().map(at).collect();
        let Some(outlines) = outlines.filter(|outlines| !outlines.is_empty()) else {
            return Err(PyValueError::new_err(format!("{}: the body has no section", body.name())));
        };
        let first = &outlines[0];
        let shape = [outlines.len(), first.outer.len(), 2];
        let outer: Vec<[f64; 4]> =
            outlines.iter().flat_map(|outline| outline.outer.iter().copied()).collect();
        let inner: Vec<[f64; 4]> =
            outlines.iter().flat_map(|outline| outline.inner.iter().flatten().copied()).collect();
        let inner = (!inner.is_empty()).then(|| flat(py, &inner).reshape(shape)).transpose()?;
        Ok((flat(py, &outer).reshape(shape)?, inner, edges(py, first)?))
    }

    /// Returns the surface of a rigid body in its own axes: points `[point, 3]` and the corners of triangles `[triangle, 3]`.
    /// Points at creases occur once for each side. `None` if it is drawn by its inertia.
    fn surface<'py>(&self, py: Python<'py>, body: &str) -> PyResult<Option<SurfaceArrays<'py>>> {
        let Some(surface) = self.surface_of(body).map(Triangles::shaded) else { return Ok(None) };
        let corners: Vec<i64> = surface.corners.iter().flatten().map(|&corner| i64::from(corner)).collect();
        let points = PyArray1::from_slice(py, surface.points.as_flattened());
        Ok(Some((
            points.reshape([surface.points.len(), 3])?,
            PyArray1::from_vec(py, corners).reshape([surface.corners.len(), 3])?,
        )))
    }

    /// Returns the arms of a rigid body in its own axes, `[arm, 3]`.
    fn arms<'py>(&self, py: Python<'py>, body: &str) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let offsets: Vec<[f64; 3]> =
            geometry::arms(&self.model, body).into_iter().map(|arm| arm.offset).collect();
        PyArray1::from_slice(py, offsets.as_flattened()).reshape([offsets.len(), 3])
    }

    /// Returns the factor of the shape of a mode in figures, as in reports: bodies do not cross.
    fn shape_factor(&self, py: Python<'_>, frame: usize, size: f64) -> PyResult<f64> {
        let state = self.states.get().state(frame, true)?;
        detached(py, || {
            let (assembly, scales) = (self.simulation.assembly(), self.simulation.scales());
            let geometry =
                Geometry::new(&self.model, assembly, scales, &self.states.get().surfaces, PARTS, size);
            Ok(shape_factor(&geometry, &state, size) / self.shape_unit())
        })
    }

    /// Returns names, kinds and positions `[symbol, 3]` of joints, probes and loads in a frame.
    ///
    /// Deflections are multiplied by `scale`.
    fn symbols<'py>(
        &self,
        py: Python<'py>,
        frame: usize,
        scale: f64,
        modal: bool,
    ) -> PyResult<Placed<'py, PyArray2<f64>>> {
        let state = self.deflected(frame, scale, modal)?;
        let all = &self.symbols.all;
        let positions: Vec<[f64; 3]> = all.iter().map(|symbol| symbol.position(&state)).collect();
        let positions = PyArray1::from_slice(py, positions.as_flattened()).reshape([all.len(), 3])?;
        let (names, kinds) = all.iter().map(|symbol| (symbol.name.clone(), symbol.kind.word())).unzip();
        Ok((names, kinds, positions))
    }

    /// Returns names, kinds and ends `[link, end, 3]` of springs, rods and bushings in a frame.
    fn links<'py>(
        &self,
        py: Python<'py>,
        frame: usize,
        scale: f64,
        modal: bool,
    ) -> PyResult<Placed<'py, PyArray3<f64>>> {
        let state = self.deflected(frame, scale, modal)?;
        let ends: Vec<f64> =
            self.links.iter().flat_map(|link| link.ends(&state)).flat_map(<[f64; 3]>::from).collect();
        let ends = PyArray1::from_vec(py, ends).reshape([self.links.len(), 2, 3])?;
        let (names, kinds) = self.links.iter().map(|link| (link.name.clone(), link.kind)).unzip();
        Ok((names, kinds, ends))
    }
}

impl ModelGeometry {
    fn deflected(&self, frame: usize, scale: f64, modal: bool) -> PyResult<State> {
        let state = self.states.get().state(frame, modal)?;
        let scale = if modal { scale * self.shape_unit() } else { scale };
        Ok(deflected(&state, &self.simulation.assembly().rest(), scale, modal))
    }

    /// Ratio of a shape in the user's units, which are those of a velocity, to its coordinates in the user's unit of length.
    fn shape_unit(&self) -> f64 {
        let scales = self.simulation.scales();
        scales.unit(Dimension::VELOCITY) / scales.unit(Dimension::LENGTH)
    }

    fn surface_of(&self, name: &str) -> Option<&Triangles> {
        let number = self.model.bodies.iter().position(|body| body.name() == name)?;
        self.states.get().surfaces.get(number).map(Arc::as_ref)
    }

    fn body(&self, name: &str) -> PyResult<&Body> {
        let body = self.model.bodies.iter().find(|body| body.name() == name);
        body.ok_or_else(|| PyKeyError::new_err(format!("no body {name:?}")))
    }
}

/// Returns a state with scaled deflections from the reference configuration, or displaced by a scaled mode shape.
///
/// Positions are linear in the coordinates, so that they scale like them. The velocities of a mode are its shape.
fn deflected(state: &State, rest: &State, scale: f64, modal: bool) -> State {
    let (from, along): (&[f64], Vec<f64>) = if modal {
        (&state.q, state.v.clone())
    } else {
        (&rest.q, state.q.iter().zip(&rest.q).map(|(q, rest)| q - rest).collect())
    };
    let q = from.iter().zip(along).map(|(q, change)| q + scale * change).collect();
    State { q, ..state.clone() }
}

/// Converts y and z of the points of outlines to an array.
fn flat<'py>(py: Python<'py>, points: &[[f64; 4]]) -> Bound<'py, PyArray1<f64>> {
    let numbers: Vec<f64> = points.iter().flat_map(|[y, z, ..]| [*y, *z]).collect();
    PyArray1::from_vec(py, numbers)
}

/// Converts the edges of an outline to an array.
fn edges<'py>(py: Python<'py>, outline: &Outline) -> PyResult<Bound<'py, PyArray2<i64>>> {
    let edges: Vec<i64> = outline.edges().iter().flatten().map(|&point| point as i64).collect();
    let count = edges.len() / 2;
    PyArray1::from_vec(py, edges).reshape([count, 2])
}
