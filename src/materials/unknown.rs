//! What is said of a name that no material, pair or interface has.

use super::{halves, Bodies, Material, INTERFACES, MATERIALS, PAIRS};
use crate::nearest::{nearest, text, Unknown};
use std::fmt::{Display, Formatter};

/// Of the name of a material that is none.
pub fn no_material(name: &[u8]) -> Unknown<'_> {
    Unknown { name, thing: "material", nearest: nearest_material(name) }
}

/// Of the name of an interface that is none.
pub fn no_interface(name: &[u8]) -> Unknown<'_> {
    let names = INTERFACES.iter().map(|interface| text(interface.name));
    Unknown { name, thing: "interface", nearest: nearest(name, names) }
}

/// Of the name of a pair that is none, or of which no work of adhesion is known.
pub struct NoPair<'a>(pub &'a [u8]);

impl Display for NoPair<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let name = self.0.escape_ascii();
        match halves(self.0) {
            Some(_) if Bodies::find(self.0).is_some() => {
                write!(f, "work_of_adhesion: none is known for {name}: give that of your surfaces, 0 for none")
            }
            Some((first, second)) => {
                let [one, other] = [first, second].map(nearest_material);
                let unknown = [first, second].map(|body| if Material::find(body).is_some() { b"" } else { body });
                let or = if unknown.contains(&&b""[..]) { "" } else { " or " };
                let [first, second] = unknown.map(<[u8]>::escape_ascii);
                write!(f, "{name}: no pair has this name; the nearest is {one}/{other}; no material is called {first}{or}{second}")
            }
            None => {
                let names = PAIRS.iter().map(|pair| text(pair.name));
                Unknown { name: self.0, thing: "pair", nearest: nearest(self.0, names) }.fmt(f)
            }
        }
    }
}

fn nearest_material(name: &[u8]) -> &'static str {
    let meant = Material::meant(name).map(|material| text(material.name));
    meant.unwrap_or_else(|| nearest(name, MATERIALS.iter().map(|material| text(material.name))))
}
