//! The pairs. Add one here and to no other place: every language reads this table, and `docs/materials.md` is tested against it.

use super::{Pair, NONE};

/// All pairs.
pub static PAIRS: [Pair; 26] = [
    Pair {
        name: c"Si/Si",
        work_of_adhesion: 0.063,
        work_of_adhesion_range: [0.03, 0.144],
        hamaker: 6.5e-20,
        slip_stress_1: 0.0,
        reference:
            c"oxide skins, van der Waals: Israelachvili, Intermolecular and Surface Forces; measured to hold such \
            surfaces together: DelRio et al., Nature Mater. 4 (2005) 629; with water up to 0.144 J/m^2: DelRio et \
            al., IMECE 2006, MEMS, 21-26",
    },
    Pair {
        name: c"SiO2/SiO2",
        work_of_adhesion: 0.063,
        work_of_adhesion_range: [0.03, 0.5],
        hamaker: 6.5e-20,
        slip_stress_1: 0.0,
        reference:
            c"van der Waals: Israelachvili; microspheres in air at the lower end: Heim et al., Phys. Rev. Lett. 83 \
            (1999) 3328; in vacuum some ten times as much: Kimura et al., Astrophys. J. 812 (2015) 67",
    },
    Pair {
        name: c"Au/Au",
        work_of_adhesion: 0.3,
        work_of_adhesion_range: [0.1, 3.0],
        hamaker: 31e-20,
        slip_stress_1: 0.0,
        reference:
            c"van der Waals, 25 to 40e-20 J: Israelachvili; clean metal welds, 3 J/m^2: Tyson and Miller, Surf. Sci. \
            62 (1977) 267; adsorbed films in air lower it",
    },
    Pair {
        name: c"steel/steel",
        work_of_adhesion: 0.049,
        work_of_adhesion_range: [0.04, 0.2],
        hamaker: 5e-20,
        slip_stress_1: 0.0,
        reference:
            c"what adsorbs in air, as hydrocarbons, van der Waals: Israelachvili; the upper end is bare iron oxide, \
            21e-20 J",
    },
    Pair {
        name: c"DLC/DLC",
        work_of_adhesion: 0.06,
        work_of_adhesion_range: [0.05, 0.09],
        hamaker: 0.0,
        slip_stress_1: 0.0,
        reference:
            c"2 gamma, from contact angles on hydrogenated films: Piazza and Morell, Diamond Relat. Mater. 18 (2009) \
            43",
    },
    Pair {
        name: c"mica/Si3N4",
        work_of_adhesion: 0.124,
        work_of_adhesion_range: [0.02, 0.13],
        hamaker: 12.8e-20,
        slip_stress_1: 0.0,
        reference:
            c"van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125; a tip in humid air at the lower \
            end: Carpick, Ogletree and Salmeron, Appl. Phys. Lett. 70 (1997) 1548",
    },
    Pair {
        name: c"mica/Au",
        work_of_adhesion: 0.172,
        work_of_adhesion_range: [0.02, 0.18],
        hamaker: 17.6e-20,
        slip_stress_1: 0.0108,
        reference:
            c"van der Waals, the geometric mean of gold, 31e-20 J, and mica, 10e-20 J: Israelachvili; humid air at \
            the lower end, as for mica/Si3N4; slip stress of a gold pillar, 264 MPa: Li and Kim, Proc. R. Soc. A \
            464 (2008) 1319",
    },
    Pair {
        name: c"Si/SiO2",
        work_of_adhesion: 0.0633,
        work_of_adhesion_range: [0.03, 0.5],
        hamaker: 6.5e-20,
        slip_stress_1: 0.0,
        reference: c"oxide skin on silica, van der Waals, as for SiO2/SiO2: Israelachvili, Intermolecular and Surface \
            Forces",
    },
    Pair {
        name: c"Si/Si3N4",
        work_of_adhesion: 0.101,
        work_of_adhesion_range: NONE,
        hamaker: 10.4e-20,
        slip_stress_1: 0.0,
        reference:
            c"oxide skin on a tip of amorphous nitride, van der Waals, the geometric mean of both bodies' constants, \
            6.5e-20 and 16.7e-20 J: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125",
    },
    Pair {
        name: c"SiO2/Si3N4",
        work_of_adhesion: 0.101,
        work_of_adhesion_range: NONE,
        hamaker: 10.4e-20,
        slip_stress_1: 0.0,
        reference:
            c"amorphous nitride, van der Waals, the geometric mean of both bodies' constants, 6.5e-20 and 16.7e-20 \
            J: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125",
    },
    Pair {
        name: c"Si3N4/Si3N4",
        work_of_adhesion: 0.163,
        work_of_adhesion_range: NONE,
        hamaker: 16.7e-20,
        slip_stress_1: 0.0,
        reference: c"amorphous, van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125",
    },
    Pair {
        name: c"Al2O3/Al2O3",
        work_of_adhesion: 0.148,
        work_of_adhesion_range: [0.136, 0.148],
        hamaker: 15.2e-20,
        slip_stress_1: 0.0,
        reference:
            c"van der Waals, the lower end Israelachvili, Intermolecular and Surface Forces, 14e-20 J: Bergstrom, \
            Adv. Colloid Interface Sci. 70 (1997) 125",
    },
    Pair {
        name: c"SiO2/Al2O3",
        work_of_adhesion: 0.0968,
        work_of_adhesion_range: NONE,
        hamaker: 9.94e-20,
        slip_stress_1: 0.0,
        reference:
            c"van der Waals, the geometric mean of both bodies' constants, 6.5e-20 and 15.2e-20 J: Bergstrom, Adv. \
            Colloid Interface Sci. 70 (1997) 125",
    },
    Pair {
        name: c"mica/mica",
        work_of_adhesion: 0.0961,
        work_of_adhesion_range: NONE,
        hamaker: 9.86e-20,
        slip_stress_1: 0.0,
        reference: c"van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125",
    },
    Pair {
        name: c"mica/SiO2",
        work_of_adhesion: 0.0779,
        work_of_adhesion_range: NONE,
        hamaker: 8e-20,
        slip_stress_1: 0.0,
        reference:
            c"van der Waals, the geometric mean of both bodies' constants, 9.86e-20 and 6.5e-20 J: Bergstrom, Adv. \
            Colloid Interface Sci. 70 (1997) 125",
    },
    Pair {
        name: c"Ag/Ag",
        work_of_adhesion: 0.317,
        work_of_adhesion_range: [0.244, 0.39],
        hamaker: 32.5e-20,
        slip_stress_1: 0.0,
        reference:
            c"van der Waals, 25 to 40e-20 J: Israelachvili, Intermolecular and Surface Forces; adsorbed films in air \
            lower it, clean metal welds",
    },
    Pair {
        name: c"Cu/Cu",
        work_of_adhesion: 0.317,
        work_of_adhesion_range: [0.244, 0.39],
        hamaker: 32.5e-20,
        slip_stress_1: 0.0,
        reference:
            c"van der Waals, 25 to 40e-20 J, bare metal: Israelachvili, Intermolecular and Surface Forces; the oxide \
            and what adsorbs in air lower it, clean metal welds",
    },
    Pair {
        name: c"Al/Al",
        work_of_adhesion: 0.148,
        work_of_adhesion_range: [0.049, 0.148],
        hamaker: 15.2e-20,
        slip_stress_1: 0.0,
        reference:
            c"skins of alumina, van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125; the lower end \
            is what adsorbs in air, as for steel/steel",
    },
    Pair {
        name: c"Ti/Ti",
        work_of_adhesion: 0.149,
        work_of_adhesion_range: [0.049, 0.149],
        hamaker: 15.3e-20,
        slip_stress_1: 0.0,
        reference:
            c"skins of rutile, van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125; the lower end is \
            what adsorbs in air, as for steel/steel",
    },
    Pair {
        name: c"stainless/stainless",
        work_of_adhesion: 0.0487,
        work_of_adhesion_range: [0.04, 0.2],
        hamaker: 5e-20,
        slip_stress_1: 0.0,
        reference: c"what adsorbs in air, as for steel/steel: Israelachvili, Intermolecular and Surface Forces",
    },
    Pair {
        name: c"steel/Cu",
        work_of_adhesion: 0.0487,
        work_of_adhesion_range: NONE,
        hamaker: 5e-20,
        slip_stress_1: 0.0,
        reference: c"what adsorbs in air on both, as for steel/steel: Israelachvili, Intermolecular and Surface Forces",
    },
    Pair {
        name: c"steel/Al2O3",
        work_of_adhesion: 0.085,
        work_of_adhesion_range: [0.049, 0.148],
        hamaker: 8.72e-20,
        slip_stress_1: 0.0,
        reference:
            c"what adsorbs in air on steel, 5e-20 J (Israelachvili, Intermolecular and Surface Forces), and alumina, \
            15.2e-20 J (Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125), the geometric mean of both bodies' \
            constants",
    },
    Pair {
        name: c"steel/Si3N4",
        work_of_adhesion: 0.0891,
        work_of_adhesion_range: [0.049, 0.163],
        hamaker: 9.14e-20,
        slip_stress_1: 0.0,
        reference:
            c"what adsorbs in air on steel, 5e-20 J (Israelachvili, Intermolecular and Surface Forces), and nitride, \
            16.7e-20 J (Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125), the geometric mean of both bodies' \
            constants",
    },
    Pair {
        name: c"steel/DLC",
        work_of_adhesion: 0.054,
        work_of_adhesion_range: NONE,
        hamaker: 0.0,
        slip_stress_1: 0.0,
        reference: c"the geometric mean of the works of steel/steel and DLC/DLC, as is usual for dispersion forces: \
            Israelachvili, Intermolecular and Surface Forces",
    },
    Pair {
        name: c"Si/DLC",
        work_of_adhesion: 0.0615,
        work_of_adhesion_range: NONE,
        hamaker: 0.0,
        slip_stress_1: 0.0,
        reference: c"the geometric mean of the works of Si/Si and DLC/DLC, as is usual for dispersion forces: \
            Israelachvili, Intermolecular and Surface Forces",
    },
    Pair {
        name: c"PDMS/PDMS",
        work_of_adhesion: 0.045,
        work_of_adhesion_range: NONE,
        hamaker: 0.0,
        slip_stress_1: 0.0,
        reference: c"2 gamma, measured by the pull of spheres: Chaudhury and Whitesides, Langmuir 7 (1991) 1013",
    },
];
