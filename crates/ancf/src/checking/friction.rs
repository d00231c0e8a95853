//! Rejects friction in equilibria, whose friction forces depend on the motion that led to them.

use crate::errors::{Finding, finding, number};
use crate::model::{About, Analysis, IndexedModel, joints_of};

/// Checks that contacts and joints have friction in analyses with a motion only.
pub(crate) fn friction(model: &IndexedModel<'_>) -> Vec<Finding> {
    let analysis = match &model.analysis {
        Analysis::Statics(_) => "statics",
        Analysis::Path(_) => "an equilibrium path",
        Analysis::Modes(modes) if modes.about == About::Equilibrium => "modes about an equilibrium",
        _ => return Vec::new(),
    };
    let rule = |path: String, amount: f64| {
        (amount != 0.0).then(|| {
            let found = format!("{} in {analysis}, which has no motion", number(amount));
            let error = finding(path, found, "0, or an analysis of kind \"dynamics\"");
            error
                .hint("the equilibrium with friction depends on the motion that leads to it: dynamics with damping and slow loads")
                .rests_on(["analysis".into()])
        })
    };
    let contacts = model.contacts.iter().enumerate();
    let of_contacts =
        contacts.filter_map(|(i, contact)| rule(format!("contacts[{i}].friction"), contact.friction));
    let of_joints = joints_of(model).flat_map(|(path, joint)| {
        let actions = [joint.kind().angle_actions(), joint.kind().displacement_actions()];
        let amounts = actions.into_iter().filter_map(|actions| actions.friction);
        amounts.filter_map(|[amount, _]| rule(format!("{path}.friction"), amount)).collect::<Vec<_>>()
    });
    of_contacts.chain(of_joints).collect()
}
