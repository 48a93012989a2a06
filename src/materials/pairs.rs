//! The pairs. Add one here and to no other place: every language reads this table, and `docs/materials.md` is tested
//! against it.

use super::{Pair, NO_RANGE};
use crate::materials::names::c_string;

/// Rows of two bodies, the work of adhesion w [J/m^2] in its range, the Hamaker constant A [J] that it is estimated
/// from, `slip_stress_1` where it is measured, and where the numbers are from. What has no source is left out.
macro_rules! pairs {
    ($($name:literal: w $work:literal $(in $range:expr)? $(, A $hamaker:literal)? $(, slip_stress_1 $stress:literal)?,
       from $reference:expr;)*) => {
        &[$(Pair {
            name: c_string!($name),
            work_of_adhesion: $work,
            $(work_of_adhesion_range: $range,)?
            $(hamaker: $hamaker,)?
            $(slip_stress_1: $stress,)?
            reference: c_string!($reference),
            ..UNKNOWN_PAIR
        }),*]
    };
}

const UNKNOWN_PAIR: Pair = Pair {
    name: c"",
    work_of_adhesion: 0.0,
    work_of_adhesion_range: NO_RANGE,
    hamaker: 0.0,
    slip_stress_1: 0.0,
    reference: c"",
};

/// All pairs.
#[allow(clippy::needless_update)] // in rows of which all is known
pub static PAIRS: &[Pair] = pairs! {
    "Si/Si": w 0.063 in [0.03, 0.144], A 6.5e-20,
        from "oxide skins, van der Waals: Israelachvili, Intermolecular and Surface Forces; measured to hold such \
        surfaces together: DelRio et al., Nature Mater. 4 (2005) 629; with water up to 0.144 J/m^2: DelRio et al., \
        IMECE 2006, MEMS, 21-26";
    "SiO2/SiO2": w 0.063 in [0.03, 0.5], A 6.5e-20,
        from "van der Waals: Israelachvili; microspheres in air at the lower end: Heim et al., Phys. Rev. Lett. 83 \
        (1999) 3328; in vacuum about ten times as much: Kimura et al., Astrophys. J. 812 (2015) 67";
    "Au/Au": w 0.3 in [0.1, 3.0], A 31e-20,
        from "van der Waals, 25 to 40e-20 J: Israelachvili; clean metal welds, 3 J/m^2: Tyson and Miller, Surf. Sci. \
        62 (1977) 267; adsorbed films in air lower it";
    "steel/steel": w 0.049 in [0.04, 0.2], A 5e-20,
        from "what adsorbs in air, as hydrocarbons, van der Waals: Israelachvili; the upper end is bare iron oxide, \
        21e-20 J";
    "DLC/DLC": w 0.06 in [0.05, 0.09],
        from "2 gamma, from contact angles on hydrogenated films: Piazza and Morell, Diamond Relat. Mater. 18 (2009) \
        43";
    "mica/Si3N4": w 0.124 in [0.02, 0.13], A 12.8e-20,
        from "van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125; a tip in humid air at the lower \
        end: Carpick, Ogletree and Salmeron, Appl. Phys. Lett. 70 (1997) 1548";
    "mica/Au": w 0.172 in [0.02, 0.18], A 17.6e-20, slip_stress_1 0.0108,
        from "van der Waals, the geometric mean of gold, 31e-20 J, and mica, 10e-20 J: Israelachvili; humid air at \
        the lower end, as for mica/Si3N4; slip stress of a gold pillar, 264 MPa: Li and Kim, Proc. R. Soc. A 464 \
        (2008) 1319";
    "Si/SiO2": w 0.0633 in [0.03, 0.5], A 6.5e-20,
        from "oxide skin on silica, van der Waals, as for SiO2/SiO2: Israelachvili, Intermolecular and Surface Forces";
    "Si/Si3N4": w 0.101, A 10.4e-20,
        from "oxide skin on a tip of amorphous nitride, van der Waals, the geometric mean of both bodies' constants, \
        6.5e-20 and 16.7e-20 J: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125";
    "SiO2/Si3N4": w 0.101, A 10.4e-20,
        from "amorphous nitride, van der Waals, the geometric mean of both bodies' constants, 6.5e-20 and 16.7e-20 J: \
        Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125";
    "Si3N4/Si3N4": w 0.163, A 16.7e-20,
        from "amorphous, van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125";
    "Al2O3/Al2O3": w 0.148 in [0.136, 0.148], A 15.2e-20,
        from "van der Waals, the lower end Israelachvili, Intermolecular and Surface Forces, 14e-20 J: Bergstrom, \
        Adv. Colloid Interface Sci. 70 (1997) 125";
    "SiO2/Al2O3": w 0.0968, A 9.94e-20,
        from "van der Waals, the geometric mean of both bodies' constants, 6.5e-20 and 15.2e-20 J: Bergstrom, Adv. \
        Colloid Interface Sci. 70 (1997) 125";
    "mica/mica": w 0.0961, A 9.86e-20,
        from "van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125";
    "mica/SiO2": w 0.0779, A 8e-20,
        from "van der Waals, the geometric mean of both bodies' constants, 9.86e-20 and 6.5e-20 J: Bergstrom, Adv. \
        Colloid Interface Sci. 70 (1997) 125";
    "Ag/Ag": w 0.317 in [0.244, 0.39], A 32.5e-20,
        from "van der Waals, 25 to 40e-20 J: Israelachvili, Intermolecular and Surface Forces; adsorbed films in air \
        lower it, clean metal welds";
    "Cu/Cu": w 0.317 in [0.244, 0.39], A 32.5e-20,
        from "van der Waals, 25 to 40e-20 J, bare metal: Israelachvili, Intermolecular and Surface Forces; the oxide \
        and what adsorbs in air lower it, clean metal welds";
    "Al/Al": w 0.148 in [0.049, 0.148], A 15.2e-20,
        from "skins of alumina, van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125; the lower end is \
        what adsorbs in air, as for steel/steel";
    "Ti/Ti": w 0.149 in [0.049, 0.149], A 15.3e-20,
        from "skins of rutile, van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125; the lower end is \
        what adsorbs in air, as for steel/steel";
    "stainless/stainless": w 0.0487 in [0.04, 0.2], A 5e-20,
        from "what adsorbs in air, as for steel/steel: Israelachvili, Intermolecular and Surface Forces";
    "steel/Cu": w 0.0487, A 5e-20,
        from "what adsorbs in air on both, as for steel/steel: Israelachvili, Intermolecular and Surface Forces";
    "steel/Al2O3": w 0.085 in [0.049, 0.148], A 8.72e-20,
        from "what adsorbs in air on steel, 5e-20 J (Israelachvili, Intermolecular and Surface Forces), and alumina, \
        15.2e-20 J (Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125), the geometric mean of both bodies' \
        constants";
    "steel/Si3N4": w 0.0891 in [0.049, 0.163], A 9.14e-20,
        from "what adsorbs in air on steel, 5e-20 J (Israelachvili, Intermolecular and Surface Forces), and nitride, \
        16.7e-20 J (Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125), the geometric mean of both bodies' \
        constants";
    "steel/DLC": w 0.054,
        from "the geometric mean of the works of steel/steel and DLC/DLC, as is usual for dispersion forces: \
        Israelachvili, Intermolecular and Surface Forces";
    "Si/DLC": w 0.0615,
        from "the geometric mean of the works of Si/Si and DLC/DLC, as is usual for dispersion forces: Israelachvili, \
        Intermolecular and Surface Forces";
    "PDMS/PDMS": w 0.045,
        from "2 gamma, measured by the pull of spheres: Chaudhury and Whitesides, Langmuir 7 (1991) 1013";
};
