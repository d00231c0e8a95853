use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use smallvec::SmallVec;

use super::reference_point::ReferencePoint;
use crate::functions::Function;
use crate::shells::laminates::{ShellSection, strain_components, strain_tensor, to_orthonormal};

/// Stress-free change of shape of a shell: a membrane strain ε⁰, a curvature κ⁰, or the strains of a membrane force.
///
/// Components are (11, 22, 2·12), those of forces (11, 22, 12), in the orthonormal frame of the surface whose first direction is the
/// projection of the axis. The change is multiplied by the load factor and a function of time. The energy of the shell is that of the
/// strains less the prescribed ones.
#[derive(Clone, Debug)]
pub struct SurfacePrestrain {
    /// Elongations and shear ε⁰ of the free shell.
    pub strain: Vector3<f64>,
    /// Change of curvature κ⁰, positive for a longer side in the direction of the normal.
    pub curvature: Vector3<f64>,
    /// Membrane forces in the reference shape, force per length.
    pub tension: Vector3<f64>,
    /// Axis whose projection on the surface is the first direction; `None` for that of stresses.
    pub axis: Option<Vector3<f64>>,
    /// Elements on which it acts; `None` for all.
    pub elements: Option<Vec<usize>>,
    /// Function of time.
    pub function: Function,
}

/// Stiffness of a shell at a point, with the axes of the section and of stresses.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfaceLaw {
    pub(crate) section: ShellSection,
    /// Axis of the section; `None` for r_ξ.
    pub(crate) axis: Option<Vector3<f64>>,
    /// Axis of stresses; `None` for r_ξ.
    pub(crate) stress_axis: Option<Vector3<f64>>,
}

/// Membrane strains and curvatures in covariant components (ξξ, ηη, 2 ξη).
pub(crate) type Covariant = [Vector3<f64>; 2];

/// Field of strains: covariant components for the law and the reference surface at a point.
pub(crate) type StrainField<'a> = &'a dyn Fn(&SurfaceLaw, &ReferencePoint) -> Covariant;

/// Factors of sources with their rates.
pub(crate) type Factors = SmallVec<[[f64; 2]; 4]>;

/// Returns the factors of sources with their rates.
pub(super) fn factors(sources: &[SurfacePrestrain], t: f64, load: f64) -> Factors {
    sources.iter().map(|source| source.factor(t, load)).collect()
}

/// Visits the parts of the strains of several sources: the numbers of the sources whose factors multiply the part, and its field.
pub(super) fn each_part(
    sources: &[&SurfacePrestrain],
    mut visit: impl FnMut([Option<usize>; 2], StrainField<'_>),
) {
    for (k, source) in sources.iter().enumerate() {
        visit([Some(k), None], &|law, point| source.linear(law, point));
        for other in 0..=k {
            let second = (other < k).then(|| sources[other]);
            visit([Some(k), Some(other)], &|law, point| source.quadratic(second, law, point));
        }
    }
}

impl SurfacePrestrain {
    /// Returns true if it acts on an element.
    pub(crate) fn covers(&self, element: usize) -> bool {
        self.elements.as_ref().is_none_or(|elements| elements.contains(&element))
    }

    /// Returns the factor of the change of shape and its rate.
    fn factor(&self, t: f64, load: f64) -> [f64; 2] {
        let function = self.function.at(t);
        [load * function.value, load * function.rate]
    }

    fn to_orthonormal(
        &self,
        law: &SurfaceLaw,
        ReferencePoint { tangents: [t, s], .. }: &ReferencePoint,
    ) -> Matrix3<f64> {
        to_orthonormal([t, s], &self.axis.or(law.stress_axis).unwrap_or(*t))
    }

    /// Returns the strains at a point that are linear in the factor.
    ///
    /// Elongations ε⁰ of a surface with the curvature b change its covariant curvature to (1 + ε⁰) b, since they do not rotate its
    /// normals: the free surface has κ⁰ = ½ (ε⁰ b + b ε⁰).
    fn linear(&self, law: &SurfaceLaw, point: &ReferencePoint) -> Covariant {
        let to_local = self.to_orthonormal(law, point);
        // A singular reference surface is reported elsewhere: its strains are NaN.
        let from_local = to_local.try_inverse().unwrap_or_else(|| Matrix3::repeat(f64::NAN));
        let [strain, reference] = [self.strain, to_local * point.curvature].map(|x| strain_tensor(&x));
        let curvature =
            self.curvature + strain_components(&((strain * reference + reference * strain) * 0.5));
        let mut strains = [from_local * self.strain, from_local * curvature];
        if self.tension != Vector3::zeros() {
            let tangents = point.tangents.each_ref();
            let [strain, curvature] = slack(law, tangents, &(to_local.transpose() * self.tension));
            strains = [strains[0] + strain, strains[1] + curvature];
        }
        strains
    }

    /// Returns Green's strain ½ (ε⁰_a ε⁰_b + ε⁰_b ε⁰_a) of the elongations of two sources, half of it for equal sources.
    fn quadratic(&self, other: Option<&Self>, law: &SurfaceLaw, point: &ReferencePoint) -> Covariant {
        let own = self.to_orthonormal(law, point);
        let mut strain = strain_tensor(&self.strain);
        strain = match other {
            None => strain * strain * 0.5,
            Some(other) => {
                let turned = own
                    * other
                        .to_orthonormal(law, point)
                        .try_inverse()
                        .unwrap_or_else(|| Matrix3::repeat(f64::NAN));
                let second = strain_tensor(&(turned * other.strain));
                (strain * second + second * strain) * 0.5
            }
        };
        let from_local = own.try_inverse().unwrap_or_else(|| Matrix3::repeat(f64::NAN));
        [from_local * strain_components(&strain), Vector3::zeros()]
    }
}

/// Returns the strains whose stress is a membrane force −n without moments, n in contravariant components.
fn slack(law: &SurfaceLaw, tangents: [&Vector3<f64>; 2], n: &Vector3<f64>) -> Covariant {
    let [a, b, d] = law.section.covariant(tangents, law.axis);
    // Strains and curvatures times the thickness have equal magnitudes.
    let height = law.section.surfaces[0].height - law.section.surfaces[2].height;
    let mut stiffness = SMatrix::<f64, 6, 6>::zeros();
    stiffness.fixed_view_mut::<3, 3>(0, 0).copy_from(&a);
    stiffness.fixed_view_mut::<3, 3>(0, 3).copy_from(&(b / height));
    stiffness.fixed_view_mut::<3, 3>(3, 0).copy_from(&(b / height));
    stiffness.fixed_view_mut::<3, 3>(3, 3).copy_from(&(d / (height * height)));
    let force = SVector::<f64, 6>::from_fn(|i, _| if i < 3 { -n[i] } else { 0.0 });
    let strains = stiffness.lu().solve(&force).unwrap_or_else(|| SVector::repeat(f64::NAN));
    [strains.fixed_rows::<3>(0).into(), strains.fixed_rows::<3>(3) / height]
}
