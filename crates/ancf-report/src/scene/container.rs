//! Binary format of a scene, which the viewer reads.
//!
//! Little-endian. `"ANCF"`, u32 version = 1, u32 length of the header in bytes, u32 zero; then the header, JSON in UTF-8, padded
//! with spaces to a multiple of 8; then the blob. An array in the header is
//! `{"type": "f32"|"f64"|"i16"|"u16"|"u32", "at": byte in the blob (a multiple of 8), "count": numbers}`.
//!
//! All numbers are in the user's units. F is the number of frames, P the number of stations in the order of the bodies.
//!
//! | key | content |
//! |---|---|
//! | `program`, `title`, `text`, `sha256` | program, heading, text of the model file and its checksum |
//! | `analysis` | `"dynamics"`, `"statics"`, `"path"`, `"modes"`, `"buckling"` |
//! | `units` | `{length, time, force}`, or null if the model does not name its units |
//! | `outcome` | `{kind: "finished"\|"stopped"\|"failed"\|"running", message}` |
//! | `live` | true if the page follows a run in progress |
//! | `summary`, `messages` | pairs of texts; texts |
//! | `bounds`, `size` | box around all frames; diagonal of the reference state, for symbols and arrows |
//! | `up` | `[x, y, z]`: global axis closest to the direction against gravity, or y |
//! | `frames` | `{count: F, values: f64, labels: null or texts, imaginary: null or indices}`; values are positions on the abscissa; `imaginary`: see below |
//! | `stations` | P |
//! | `bodies` | see below |
//! | `centres` | f32 `[F][P][3]` |
//! | `directors` | i16 `[F][P][9]`: three unit vectors times 32767: normal or first axis, y, z of the section |
//! | `reference` | `{centres: f32 [P][3], directors: i16 [P][9]}`: undeformed state; of mode shapes, the state about which they are computed |
//! | `fields` | `{name, symbol, unit, diverging, range: [min, max], values: u16 [F][P]}`; (value − min)/(max − min) · 65534, and 65535 where the field is not defined |
//! | `markers` | symbols: `{name, kind: "joint"\|"probe"\|"load", detail, at: f32 [F][3], reference: [x, y, z]}` |
//! | `reactions` | `{name, marker, force: f32 [F][3], moment: f32 [F][3]}`: force and moment of a joint on its end `a` |
//! | `supports` | joints along edges of shells: `{marker, stations: [..]}`; stations along the edge |
//! | `loads` | loads on edges and surfaces of shells: `{kind, moment: true or false, stations: [..], vectors: f32 [F][stations][3]}`; force or moment per length or area at some stations |
//! | `links` | `{name, kind, ends: f32 [F][2][3], reference: [[x, y, z], [x, y, z]]}`; spring, damper, rope, rod, bushing, or arm (from the centre of a rigid body to a joint) |
//! | `obstacles` | `{name, kind: "plane"\|"sphere"\|"cylinder", radius, length, inside, pose: f32 [1 or F][12]}`: point, three directors; the first director is the normal or the axis |
//! | `charts` | `{title, group, log, columns: [{name, label, unit, values: f32, errors: f32}]}`; `errors`, estimated ones, may be absent |
//! | `abscissa` | `{name, unit, values: f64}`, ascending: time, load factor, arc length of the path, number of the mode or row |
//!
//! A body is `{name, kind: "beam"|"cable"|"shell"|"rigid"|"point", first, count, outline: [[y, z, ny, nz], ..], inner, scale, grid, nodes, box, surface}`.
//! Its stations are `first .. first + count`. Outlines are those of [`Outline`](crate::geometry::Outline); `inner` is the outline
//! of a bore or null. `scale` (f32 `[count][2]` or null) multiplies y and z of both outlines at each station. `grid` is null or the
//! grid of a shell, `{patches, counts: [n, m], parts, half}`: `patches` grids of n × m stations along u first, `parts` cells per element in each direction, half
//! of the thickness. `nodes` are the
//! stations at nodes of the mesh, counted from the first station of all. `box` has half of the edges along the three directors
//! of a rigid body, or three times the radius of a point mass. `surface` is null or
//! `{points: f32 [n][3], normals: i16 [n][3], corners: u32 [m][3]}`: triangles of a rigid body, in components along its
//! directors from its centre.
//!
//! In modal and buckling analyses, each shape is a frame with a maximum displacement of a tenth of the size, or less if bodies
//! would cross each other. The shape of a damped mode is complex and moves by Re cos ωt − Im sin ωt. The frames have its real part.
//! Frames with imaginary parts follow in all arrays with F frames, except `values` and `labels`. `imaginary` has the index of this
//! frame for each frame, or null if the shape is real.

use serde_json::{Value, json};

const MAGIC: &[u8; 4] = b"ANCF";
const VERSION: u32 = 1;
/// Bytes before the header.
const START: usize = 16;
/// Alignment of arrays in bytes.
const ALIGNED: usize = 8;

/// Arrays of a container under construction.
#[derive(Debug, Default)]
pub struct Blob {
    bytes: Vec<u8>,
}

impl Blob {
    /// Adds an array in single precision and returns its entry in the header.
    pub fn f32(&mut self, numbers: impl IntoIterator<Item = f64>) -> Value {
        self.array("f32", 4, numbers.into_iter().flat_map(|x| (x as f32).to_le_bytes()))
    }

    /// Adds an array in double precision and returns its entry in the header.
    pub fn f64(&mut self, numbers: impl IntoIterator<Item = f64>) -> Value {
        self.array("f64", 8, numbers.into_iter().flat_map(f64::to_le_bytes))
    }

    /// Adds an array of numbers from −1 to 1, times 32767, and returns its entry in the header.
    pub fn i16(&mut self, numbers: impl IntoIterator<Item = f64>) -> Value {
        let integer = |x: f64| (x.clamp(-1.0, 1.0) * f64::from(i16::MAX)).round() as i16;
        self.array("i16", 2, numbers.into_iter().flat_map(|x| integer(x).to_le_bytes()))
    }

    /// Adds an array of numbers in a range, divided into 65534 steps, and returns its entry in the header.
    ///
    /// Numbers that are not finite become 65535.
    pub fn u16(&mut self, numbers: impl IntoIterator<Item = f64>, [least, most]: [f64; 2]) -> Value {
        let range = if most > least { most - least } else { 1.0 };
        let integer = |x: f64| {
            if x.is_finite() {
                (((x - least) / range).clamp(0.0, 1.0) * 65534.0).round() as u16
            } else {
                u16::MAX
            }
        };
        self.array("u16", 2, numbers.into_iter().flat_map(|x| integer(x).to_le_bytes()))
    }

    /// Adds an array of indices and returns its entry in the header.
    pub fn u32(&mut self, numbers: impl IntoIterator<Item = u32>) -> Value {
        self.array("u32", 4, numbers.into_iter().flat_map(u32::to_le_bytes))
    }

    fn array(&mut self, of: &str, width: usize, bytes: impl Iterator<Item = u8>) -> Value {
        self.bytes.resize(self.bytes.len().next_multiple_of(ALIGNED), 0);
        let at = self.bytes.len();
        self.bytes.extend(bytes);
        json!({ "type": of, "at": at, "count": (self.bytes.len() - at) / width })
    }

    /// Returns the container with a header.
    pub fn packed(self, header: &Value) -> Vec<u8> {
        let mut text = header.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(ALIGNED), b' ');
        let mut packed = Vec::with_capacity(START + text.len() + self.bytes.len());
        packed.extend(MAGIC);
        for number in [VERSION, text.len() as u32, 0] {
            packed.extend(number.to_le_bytes());
        }
        packed.extend(text);
        packed.extend(self.bytes);
        packed
    }
}

/// Reads the header of a container; `None` if the bytes are not a container.
pub fn header(container: &[u8]) -> Option<Value> {
    let word = |at: usize| Some(u32::from_le_bytes(container.get(at..at + 4)?.try_into().ok()?));
    if container.get(..4)? != MAGIC || word(4)? != VERSION {
        return None;
    }
    serde_json::from_slice(container.get(START..START.checked_add(word(8)? as usize)?)?).ok()
}
