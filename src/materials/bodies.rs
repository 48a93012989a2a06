//! The bodies. Add one here and to no other place: every language reads this table, and `docs/materials.md` is tested against it.

use super::{Material, NONE};

/// All materials.
pub static MATERIALS: [Material; 30] = [
    Material {
        name: c"Si",
        young: 160e9,
        young_range: [152e9, 170e9],
        poisson: 0.22,
        hardness: 12e9,
        hardness_range: [10e9, 13e9],
        burgers_vector: 0.384e-9,
        reference:
            c"polysilicon films: Sharpe et al., IMECE 2000, MEMS, 255-259, and J. Microelectromech. Syst. 6 (1997) \
            193; hardness limited by a change of phase: Domnich et al., Rev. Adv. Mater. Sci. 17 (2008) 33; \
            <110>/2 with a = 0.5431 nm: Hirth and Lothe, Theory of Dislocations",
    },
    Material {
        name: c"SiO2",
        young: 72e9,
        young_range: [70e9, 74e9],
        poisson: 0.17,
        hardness: 9e9,
        hardness_range: [8e9, 10e9],
        burgers_vector: 0.31e-9,
        reference:
            c"fused silica: Oliver and Pharr, J. Mater. Res. 7 (1992) 1564; a glass: Si to Si across an oxygen atom, \
            twice 0.162 nm at some 144 degrees: Mozzi and Warren, J. Appl. Crystallogr. 2 (1969) 164",
    },
    Material {
        name: c"Au",
        young: 78e9,
        young_range: [77e9, 80e9],
        poisson: 0.44,
        hardness: 1.3e9,
        hardness_range: [0.2e9, 2e9],
        burgers_vector: 0.288e-9,
        reference: c"bulk, with the lower hardness: Kaye and Laby, Tables of Physical and Chemical Constants; film on \
            glass: Zhou et al., Mater. Sci. Forum 561-565 (2007) 2005; <110>/2 with a = 0.4078 nm",
    },
    Material {
        name: c"steel",
        young: 205e9,
        young_range: [190e9, 210e9],
        poisson: 0.3,
        hardness: 7.5e9,
        hardness_range: [2e9, 9e9],
        burgers_vector: 0.248e-9,
        reference:
            c"AISI 52100, hardened to 60-64 HRC, the lower end annealed: ASTM A295 and makers' data sheets; <111>/2 \
            of iron with a = 0.2866 nm",
    },
    Material {
        name: c"DLC",
        young: 260e9,
        young_range: [100e9, 630e9],
        poisson: 0.25,
        hardness: 27e9,
        hardness_range: [10e9, 80e9],
        burgers_vector: 0.25e-9,
        reference:
            c"a-C:H, the upper end ta-C: Nature Commun. 12 (2021), doi 10.1038/s41467-021-24766-6, table 1; the \
            range from soft to ta-C: Robertson, Mater. Sci. Eng. R 37 (2002) 129; Poisson's ratio is assumed; a \
            glass: second neighbours",
    },
    Material {
        name: c"mica",
        young: 54e9,
        young_range: [50e9, 60e9],
        poisson: 0.1,
        hardness: 0.0,
        hardness_range: NONE,
        burgers_vector: 0.52e-9,
        reference:
            c"muscovite, normal to its layers, from the stiffnesses of Vaughan and Guggenheim, J. Geophys. Res. 91 \
            (1986) 4657: C33 - 2 C13^2/(C11 + C12) and C13/(C11 + C12), with means over the plane; repeat of the \
            surface lattice",
    },
    Material {
        name: c"Si3N4",
        young: 222e9,
        young_range: [150e9, 310e9],
        poisson: 0.28,
        hardness: 21e9,
        hardness_range: [15e9, 30e9],
        burgers_vector: 0.29e-9,
        reference:
            c"LPCVD film: Vlassak and Nix, J. Mater. Res. 7 (1992) 3242; the range is that used for cantilever tips \
            and of dense nitride; a glass: second neighbours",
    },
    Material {
        name: c"Al",
        young: 70e9,
        young_range: NONE,
        poisson: 0.35,
        hardness: 0.167e9,
        hardness_range: [0.16e9, 0.35e9],
        burgers_vector: 0.286e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness: Samsonov, Handbook of the Physicochemical Properties of the Elements \
            (1968); <110>/2 with a = 0.405 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Cu",
        young: 130e9,
        young_range: NONE,
        poisson: 0.34,
        hardness: 0.369e9,
        hardness_range: [0.343e9, 0.369e9],
        burgers_vector: 0.255e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness: Samsonov, Handbook of the Physicochemical Properties of the Elements \
            (1968); <110>/2 with a = 0.361 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Ag",
        young: 83e9,
        young_range: NONE,
        poisson: 0.37,
        hardness: 0.251e9,
        hardness_range: [0.245e9, 0.251e9],
        burgers_vector: 0.289e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness: Samsonov, Handbook of the Physicochemical Properties of the Elements \
            (1968); <110>/2 with a = 0.409 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Ni",
        young: 200e9,
        young_range: NONE,
        poisson: 0.31,
        hardness: 0.638e9,
        hardness_range: [0.638e9, 1.6e9],
        burgers_vector: 0.249e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness, the upper end Brinell's, worked: Samsonov, Handbook of the Physicochemical \
            Properties of the Elements (1968); <110>/2 with a = 0.352 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Pt",
        young: 168e9,
        young_range: NONE,
        poisson: 0.38,
        hardness: 0.549e9,
        hardness_range: [0.392e9, 0.549e9],
        burgers_vector: 0.277e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness, the lower end Brinell's: Samsonov, Handbook of the Physicochemical \
            Properties of the Elements (1968); <110>/2 with a = 0.392 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"W",
        young: 411e9,
        young_range: NONE,
        poisson: 0.28,
        hardness: 3.43e9,
        hardness_range: [2.57e9, 3.43e9],
        burgers_vector: 0.274e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness, the lower end Brinell's: Samsonov, Handbook of the Physicochemical \
            Properties of the Elements (1968); <111>/2 with a = 0.316 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Mo",
        young: 329e9,
        young_range: NONE,
        poisson: 0.31,
        hardness: 1.53e9,
        hardness_range: [1.4e9, 2.74e9],
        burgers_vector: 0.273e-9,
        reference:
            c"E and Poisson's ratio: WebElements, elasticities of the elements; Vickers hardness: Samsonov, Handbook \
            of the Physicochemical Properties of the Elements (1968); <111>/2 with a = 0.315 nm: Ashcroft and \
            Mermin, Solid State Physics",
    },
    Material {
        name: c"Cr",
        young: 279e9,
        young_range: NONE,
        poisson: 0.21,
        hardness: 1.06e9,
        hardness_range: [0.687e9, 6.5e9],
        burgers_vector: 0.249e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness, the range Brinell's, from annealed to electroplated: Samsonov, Handbook of \
            the Physicochemical Properties of the Elements (1968); <111>/2 with a = 0.288 nm: Ashcroft and Mermin, \
            Solid State Physics",
    },
    Material {
        name: c"Ti",
        young: 116e9,
        young_range: NONE,
        poisson: 0.32,
        hardness: 0.97e9,
        hardness_range: [0.83e9, 3.42e9],
        burgers_vector: 0.295e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness: Samsonov, Handbook of the Physicochemical Properties of the Elements \
            (1968); <11-20>/3, a = 0.295 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Fe",
        young: 211e9,
        young_range: NONE,
        poisson: 0.29,
        hardness: 0.608e9,
        hardness_range: [0.2e9, 1.18e9],
        burgers_vector: 0.249e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness, the range Brinell's: Samsonov, Handbook of the Physicochemical Properties \
            of the Elements (1968); <111>/2 with a = 0.287 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Ta",
        young: 186e9,
        young_range: NONE,
        poisson: 0.34,
        hardness: 0.873e9,
        hardness_range: [0.873e9, 1.2e9],
        burgers_vector: 0.287e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Vickers hardness: Samsonov, Handbook of the Physicochemical Properties of the Elements \
            (1968); <111>/2 with a = 0.331 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Mg",
        young: 45e9,
        young_range: NONE,
        poisson: 0.29,
        hardness: 0.26e9,
        hardness_range: NONE,
        burgers_vector: 0.321e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Brinell hardness: Samsonov, Handbook of the Physicochemical Properties of the Elements \
            (1968); <11-20>/3, a = 0.321 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Pb",
        young: 16e9,
        young_range: NONE,
        poisson: 0.44,
        hardness: 38e6,
        hardness_range: NONE,
        burgers_vector: 0.35e-9,
        reference: c"E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, \
            rounded; Brinell hardness: Samsonov, Handbook of the Physicochemical Properties of the Elements \
            (1968); <110>/2 with a = 0.495 nm: Ashcroft and Mermin, Solid State Physics",
    },
    Material {
        name: c"Al-6061",
        young: 68.9e9,
        young_range: [68.9e9, 70e9],
        poisson: 0.33,
        hardness: 1.05e9,
        hardness_range: NONE,
        burgers_vector: 0.286e-9,
        reference:
            c"6061-T6, Vickers 107 converted from Brinell 95: Aluminum Association, in ASM and MatWeb's data sheet \
            of 6061-T6; the upper E and the Burgers vector are those of aluminium",
    },
    Material {
        name: c"Ti-6Al-4V",
        young: 113.8e9,
        young_range: [108e9, 122e9],
        poisson: 0.342,
        hardness: 3.4e9,
        hardness_range: [3.3e9, 3.9e9],
        burgers_vector: 0.295e-9,
        reference:
            c"annealed, Vickers 349 converted from Rockwell C: ASM and MatWeb's data sheet MTP641; the range from \
            annealed rod to printed parts: Materials 14 (2021) 658, table 4; the Burgers vector is that of \
            titanium",
    },
    Material {
        name: c"stainless",
        young: 196e9,
        young_range: [193e9, 200e9],
        poisson: 0.29,
        hardness: 1.27e9,
        hardness_range: NONE,
        burgers_vector: 0.258e-9,
        reference:
            c"AISI 304, annealed, Vickers 129 converted from Rockwell B: ASM and MatWeb's data sheet of 304; Burgers \
            vector: Frost and Ashby, Deformation-Mechanism Maps (1982), chapter 8",
    },
    Material {
        name: c"Al2O3",
        young: 416e9,
        young_range: [386e9, 446e9],
        poisson: 0.231,
        hardness: 15e9,
        hardness_range: NONE,
        burgers_vector: 0.476e-9,
        reference:
            c"sintered, 99.5 % pure, the range its uncertainty: Munro, J. Am. Ceram. Soc. 80 (1997) 1919, and NIST \
            Standard Reference Database 150; <11-20>/3, a = 0.476 nm",
    },
    Material {
        name: c"SiC",
        young: 415e9,
        young_range: NONE,
        poisson: 0.16,
        hardness: 32e9,
        hardness_range: NONE,
        burgers_vector: 0.308e-9,
        reference: c"sintered alpha-SiC: Munro, J. Phys. Chem. Ref. Data 26 (1997) 1195, and NIST Standard Reference \
            Database 150; <11-20>/3 of 6H, a = 0.308 nm",
    },
    Material {
        name: c"diamond",
        young: 1143e9,
        young_range: [1050e9, 1143e9],
        poisson: 0.0691,
        hardness: 80e9,
        hardness_range: [56e9, 102e9],
        burgers_vector: 0.252e-9,
        reference:
            c"polycrystal, the lower E along <100>: Klein and Cardinale, Diamond Relat. Mater. 2 (1993) 918; Knoop \
            hardness on (001) by direction: MatWeb; <110>/2 with a = 0.357 nm",
    },
    Material {
        name: c"WC",
        young: 534e9,
        young_range: NONE,
        poisson: 0.22,
        hardness: 0.0,
        hardness_range: NONE,
        burgers_vector: 0.291e-9,
        reference:
            c"E and Poisson's ratio: Kaye and Laby, section 2.2.2; hardness is left out, since that of cemented \
            carbide depends on the binder; <11-20>/3, a = 0.2906 nm",
    },
    Material {
        name: c"GaAs",
        young: 116.5e9,
        young_range: NONE,
        poisson: 0.242,
        hardness: 0.0,
        hardness_range: NONE,
        burgers_vector: 0.4e-9,
        reference:
            c"Voigt, Reuss and Hill's mean of C11 = 119, C12 = 53.4, C44 = 59.6 GPa: Goldberg and Schmidt, Handbook \
            Series on Semiconductor Parameters 2 (1999); <110>/2 with a = 0.5653 nm",
    },
    Material {
        name: c"glass",
        young: 71.3e9,
        young_range: NONE,
        poisson: 0.22,
        hardness: 0.0,
        hardness_range: NONE,
        burgers_vector: 0.31e-9,
        reference: c"crown glass: Kaye and Laby, section 2.2.2; the distance of like atoms is that of SiO2",
    },
    Material {
        name: c"PDMS",
        young: 2e6,
        young_range: [1.32e6, 2.97e6],
        poisson: 0.5,
        hardness: 0.0,
        hardness_range: NONE,
        burgers_vector: 0.0,
        reference:
            c"Sylgard 184, by the temperature of curing: Johnston et al., J. Micromech. Microeng. 24 (2014) 035017; \
            taken as incompressible; an elastomer has no Burgers vector, and its viscoelasticity is outside the \
            law",
    },
];
