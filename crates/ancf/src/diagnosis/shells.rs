use crate::errors::short;
use crate::model::{Body, FieldShell as _, Model, ShearShell, Shell};

/// Thickness of an isotropic shell, relative to the longer side, above which the neglected transverse shear changes the deflection
/// of a supported plate by more than about 1 %.
const THICK: f64 = 0.05;

/// Ratio of the moduli of bending and of shear, E/(1 − ν²)/G, to which [`THICK`] refers: that of ν = 0.3.
const RATIO: f64 = 2.0 / 0.7;

/// Distance of the centre of mass from the middle surface that is a warning, relative to the thickness.
const OFF_CENTRE: f64 = 0.01;

/// Describes shells that are too thick for the theory of Kirchhoff and Love, one sentence each.
///
/// A hinged square plate of a tenth of its side deflects by 5 % more with transverse shear than without (Navier's solutions of both
/// theories), and a clamped one by a multiple of this.
pub(crate) fn thickness_warnings(model: &Model) -> Vec<String> {
    let shells =
        model.bodies.iter().filter_map(|body| if let Body::Shell(shell) = body { Some(shell) } else { None });
    let warning = |shell: &Shell| {
        let [_, u, v, _] = shell.geometry().map([0.5, 0.5]);
        let ratio = shell.thickness_range().largest / u.norm().max(v.norm());
        let moduli = moduli_ratio(model, shell);
        (ratio * (moduli / RATIO).sqrt() > THICK).then(|| {
            let by = if moduli > 2.0 * RATIO {
                format!(" and the ratio of its moduli of bending and shear {}", short(moduli))
            } else {
                String::new()
            };
            format!(
                "shell `{}`: its {}thickness is {} of its longer side{by}; transverse shear, which thin shells neglect, is not negligible",
                shell.name,
                if shell.has_varying_thickness() { "largest " } else { "" },
                short(ratio)
            )
        })
    };
    let mut warnings: Vec<String> = shells.clone().filter_map(warning).collect();
    warnings.extend(shells.filter_map(|shell| mass_warning(model, shell)));
    warnings
}

/// Ratio of the larger modulus of bending, 12 D/h³, to the smallest shear modulus of the layers. The transverse shear moduli of
/// fibre-reinforced materials, which models do not contain, are of the size of G_LT or smaller.
fn moduli_ratio(model: &Model, shell: &Shell) -> f64 {
    let layup = shell.layup();
    let bending = model.laminate(layup).section().bending;
    let shear = shell.layers().into_iter().map(|(material, ..)| model.materials[material].ply().shear);
    let modulus = 12.0 * bending[(0, 0)].max(bending[(1, 1)]) / layup.thickness.powi(3);
    modulus / shear.fold(f64::INFINITY, f64::min)
}

/// Describes a laminate whose centre of mass is off the middle surface, in which the mass is assumed.
fn mass_warning(model: &Model, shell: &Shell) -> Option<String> {
    let layup = shell.layup();
    let part = model.laminate(layup).centre_of_mass() / layup.thickness;
    (part.abs() > OFF_CENTRE).then(|| {
        format!(
            "shell `{}`: the centre of mass of its layers is {} of the thickness off the middle surface, where the mass is assumed",
            shell.name,
            short(part)
        )
    })
}

/// Describes meshes of shear-deformable shells with a crack: nodes of the boundary that are much nearer to each other than the
/// shortest edge, as those of unmerged nodes of two faces. One sentence each.
pub(crate) fn gap_warnings(model: &Model) -> Vec<String> {
    let warning = |shell: &ShearShell| {
        let (topology, points) = (shell.topology(), shell.points());
        let [a, b] = topology.gap(&points)?;
        Some(format!(
            "shell `{}`: {} and {} are {} of the shortest edge apart, on the boundary: the mesh has a crack there; merge the nodes if \
             the surface is connected",
            shell.name,
            shell.describe_node(a),
            shell.describe_node(b),
            short((points[a] - points[b]).norm() / topology.shortest_edge(&points))
        ))
    };
    let shells = model.bodies.iter().filter_map(|body| match body {
        Body::ShearShell(shell) => Some(shell),
        _ => None,
    });
    shells.filter_map(warning).collect()
}
