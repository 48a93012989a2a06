//! What is said of a name that no material, pair or interface has.

use super::{halves, Bodies, Material, INTERFACES, MATERIALS, PAIRS};
use crate::materials::names::{expected, text, Expected, Instead, Unknown};
use std::fmt::{Display, Formatter};

const MATERIALS_LISTED: &str = "docs/materials.md lists them";

/// Bodies that people expect, and why they are not in the table.
const EXPECTED_MATERIALS: &Expected = &[
    (
        "rubber|elastomer|NBR|EPDM|SBR|FKM|silicone|polyurethane|latex",
        "rubber is viscoelastic, and outside the domain of the model: docs/when-to-use.md",
    ),
    (
        "PTFE|teflon|nylon|polyamide|PA6|PA66|POM|acetal|PEEK|PE|HDPE|UHMWPE|PP|PVC|ABS|PC|PMMA|epoxy|polymer|plastic|polyimide",
        "a polymer is viscoelastic, and outside the domain of the model: docs/when-to-use.md",
    ),
    (
        "mild steel|carbon steel|tool steel|low-carbon steel|S235|S355|1045|AISI 1045|C45|42CrMo4|4140",
        "steel has the stiffness of every steel and the hardness of AISI 52100: take it, and give the hardness of yours",
    ),
    ("316|316L|AISI 316|AISI 316L|1.4404|1.4571", "the nearest is stainless, which is AISI 304"),
    ("sapphire|ruby", "the nearest is Al2O3, sintered: give E1, nu1, E2 and nu2 of the crystal instead if you have them"),
    ("quartz", "the nearest is SiO2, fused silica: give E1, nu1, E2 and nu2 of the crystal instead if you have them"),
    ("7075|Al-7075|2024|Al-2024|aluminium alloy|aluminum alloy", "the nearest are Al, pure, and Al-6061"),
    (
        "brass|bronze|cast iron|cast_iron|iron, cast|zinc|Zn|tin|Sn|invar|inconel|graphite|graphene|HOPG|MoS2|zirconia|ZrO2|TiN",
        "it is not in the table, where each number has a source: give E1, nu1, E2 and nu2, hardness and burgers_vector",
    ),
];

/// What is said of the name of a material that is none.
pub fn no_material(name: &[u8]) -> Unknown<'_> {
    Unknown { name, thing: "material", instead: instead(name) }
}

/// What is said of the name of an interface that is none.
pub fn no_interface(name: &[u8]) -> Unknown<'_> {
    let names = INTERFACES.iter().map(|interface| text(interface.name));
    Unknown { name, thing: "interface", instead: Instead::of(name, names, MATERIALS_LISTED) }
}

/// What is said of the name of a pair that is none, or of which no work of adhesion is known.
pub struct NoPair<'a>(pub &'a [u8]);

impl Display for NoPair<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let name = self.0.escape_ascii();
        let Some((first, second)) = halves(self.0) else {
            let instead = match instead(self.0) {
                Instead::Says(says) if says != MATERIALS_LISTED => Instead::Says(says),
                Instead::Nearest(_) => Instead::Says("a pair has two names, as Si/Si"),
                _ => Instead::of(self.0, PAIRS.iter().map(|pair| text(pair.name)), MATERIALS_LISTED),
            };
            return Unknown { name: self.0, thing: "pair", instead }.fmt(f);
        };
        if Bodies::find(self.0).is_some() {
            return write!(f, "work_of_adhesion: none is known for {name}: give that of your surfaces, 0 for none");
        }
        write!(f, "{name}: no pair has this name")?;
        let bodies = if first == second { &[first][..] } else { &[first, second] };
        let unknown = bodies.iter().filter(|body| Material::find(body).is_none());
        match [first, second].map(instead) {
            [Instead::Nearest(one), Instead::Nearest(other)] => {
                write!(f, "; the nearest is {one}/{other}; no material is called ")?;
                for (i, body) in unknown.enumerate() {
                    write!(f, "{}{}", if i == 0 { "" } else { " or " }, body.escape_ascii())?;
                }
                Ok(())
            }
            _ => {
                for body in unknown {
                    write!(f, "; {}", no_material(body))?;
                }
                Ok(())
            }
        }
    }
}

/// What to give instead of a name.
fn instead(name: &[u8]) -> Instead<'static> {
    if let Some(material) = Material::find(name) {
        return Instead::Nearest(text(material.name));
    }
    if Bodies::find(name).is_some() {
        return Instead::Says("it is a pair: give each body by its own name");
    }
    match expected(EXPECTED_MATERIALS, name) {
        Some(says) => Instead::Says(says),
        None => Instead::of(name, MATERIALS.iter().map(|material| text(material.name)), MATERIALS_LISTED),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_that_people_expect_have_an_answer_of_their_own() {
        let rows = [
            ("rubber", "no material", "; rubber is viscoelastic, and outside the domain of the model"),
            ("PTFE", "no material", "; a polymer is viscoelastic, and outside the domain of the model"),
            ("Brass", "no material", "; it is not in the table, where each number has a source: give E1"),
            ("cast iron", "no material", "; it is not in the table"),
            ("Gold", "no material", "; the nearest is Au"),
            ("sapphire", "no material", "; the nearest is Al2O3, sintered: give E1"),
            ("Si/Si", "no material", "; it is a pair: give each body by its own name"),
            ("unobtainium", "no material", "; docs/materials.md lists them"),
            ("PTFE/steel", "no pair", "; PTFE: no material has this name; a polymer is viscoelastic"),
            ("steel/rubber", "no pair", "; rubber: no material has this name; rubber is visco"),
            ("rubber", "no pair", "; rubber is viscoelastic"),
            ("Si", "no pair", "; a pair has two names, as Si/Si"),
            ("unobtainium", "no pair", "; docs/materials.md lists them"),
            ("stel/stel", "no pair", "; the nearest is steel/steel; no material is called stel"),
            ("mild steel/SIC", "no pair", "; mild steel: no material has this name; steel has the"),
            ("stel/gold", "no pair", "; the nearest is steel/Au; no material is called stel"),
        ];
        for (name, what, says) in rows {
            let said = match what {
                "no pair" => NoPair(name.as_bytes()).to_string(),
                _ => no_material(name.as_bytes()).to_string(),
            };
            let begins = format!("{name}: {what} has this name{says}");
            assert!(said.starts_with(&begins) && !said.contains("stel or stel"), "{said}");
        }
        for word in EXPECTED_MATERIALS.iter().flat_map(|(words, _)| words.split('|')) {
            assert!(Material::find(word).is_none(), "{word}");
        }
    }
}
