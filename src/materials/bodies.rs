//! The bodies. Add one here and to no other place: every language reads this table, and `docs/materials.md` is tested
//! against it.

use super::{Material, NO_RANGE};
use crate::materials::names::c_string;

/// Rows of a name, what the body is called in words, Young's modulus E [Pa] in its range, Poisson's ratio nu, hardness H
/// [Pa] in its range, Burgers vector b [m], of a metal its family, and where the numbers are from. What has no source is left out.
macro_rules! bodies {
    ($($name:literal $(or $word:literal)*: E $young:literal $(in $young_range:expr)?, nu $poisson:literal
       $(, H $hardness:literal $(in $hardness_range:expr)? $(, of $state:literal)?)? $(, b $burgers:literal)? $(, family $family:literal)?, from $reference:expr;)*) => {
        &[$(Material {
            name: c_string!($name),
            words: &[$($word),*],
            young: $young,
            $(young_range: $young_range,)?
            poisson: $poisson,
            $(hardness: $hardness, $(hardness_range: $hardness_range,)? $(state: $state,)?)?
            $(burgers_vector: $burgers,)?
            $(family: $family,)?
            reference: c_string!($reference),
            ..UNKNOWN_MATERIAL
        }),*]
    };
}

const UNKNOWN_MATERIAL: Material = Material {
    name: c"",
    words: &[],
    young: 0.0,
    young_range: NO_RANGE,
    poisson: 0.0,
    hardness: 0.0,
    hardness_range: NO_RANGE,
    state: "",
    burgers_vector: 0.0,
    family: "",
    reference: c"",
};

/// The sources of most metals, with the kind of their hardness and the lattice of their Burgers vector.
macro_rules! metal {
    ($hardness:literal, $lattice:literal) => {
        concat!(
            "E and Poisson's ratio: Kaye and Laby, Tables of Physical and Chemical Constants, section 2.2.2, rounded; ",
            $hardness,
            ": Samsonov, Handbook of the Physicochemical Properties of the Elements (1968); ",
            $lattice,
            ": Ashcroft and Mermin, Solid State Physics"
        )
    };
}

/// All materials.
#[allow(clippy::needless_update)] // in rows of which all is known
pub static MATERIALS: &[Material] = bodies! {
    "Si" or "silicon" or "polysilicon" or "poly-Si": E 160e9 in [152e9, 170e9], nu 0.22, H 12e9 in [10e9, 13e9], of "polysilicon", b 0.384e-9,
        from "polysilicon films: Sharpe et al., IMECE 2000, MEMS, 255-259, and J. Microelectromech. Syst. 6 (1997) \
        193; hardness limited by a change of phase: Domnich et al., Rev. Adv. Mater. Sci. 17 (2008) 33; <110>/2 with \
        a = 0.5431 nm: Hirth and Lothe, Theory of Dislocations";
    "SiO2" or "silica" or "fused silica" or "silicon dioxide" or "silicon oxide": E 72e9 in [70e9, 74e9], nu 0.17, H 9e9 in [8e9, 10e9], b 0.31e-9,
        from "fused silica: Oliver and Pharr, J. Mater. Res. 7 (1992) 1564; a glass: Si to Si across an oxygen atom, \
        twice 0.162 nm at about 144 degrees: Mozzi and Warren, J. Appl. Crystallogr. 2 (1969) 164";
    "Au" or "gold": E 78e9 in [77e9, 80e9], nu 0.44, H 1.3e9 in [0.2e9, 2e9], of "a film", b 0.288e-9, family "Au",
        from "bulk, with the lower hardness: Kaye and Laby, Tables of Physical and Chemical Constants; film on glass: \
        Zhou et al., Mater. Sci. Forum 561-565 (2007) 2005; <110>/2 with a = 0.4078 nm";
    "steel" or "bearing steel" or "chrome steel" or "AISI 52100" or "52100" or "100Cr6": E 205e9 in [190e9, 210e9], nu 0.3, H 7.5e9 in [2e9, 9e9], of "AISI 52100 hardened to 60-64 HRC", b 0.248e-9, family "steel",
        from "AISI 52100, hardened to 60-64 HRC, the lower end annealed: ASTM A295 and makers' data sheets; <111>/2 \
        of iron with a = 0.2866 nm";
    "DLC" or "diamond-like carbon" or "a-C:H" or "ta-C": E 260e9 in [100e9, 630e9], nu 0.25, H 27e9 in [10e9, 80e9], of "a-C:H", b 0.25e-9,
        from "a-C:H, the upper end ta-C: Nature Commun. 12 (2021), doi 10.1038/s41467-021-24766-6, table 1; the range \
        from soft to ta-C: Robertson, Mater. Sci. Eng. R 37 (2002) 129; Poisson's ratio is assumed; a glass: second \
        neighbours";
    "mica" or "muscovite": E 54e9 in [50e9, 60e9], nu 0.1, b 0.52e-9,
        from "muscovite, normal to its layers, from the stiffnesses of Vaughan and Guggenheim, J. Geophys. Res. 91 \
        (1986) 4657: C33 - 2 C13^2/(C11 + C12) and C13/(C11 + C12), with means over the plane; repeat of the surface \
        lattice; its layers shear more easily than an isotropic body of this E, C44 = 16.5 and C55 = 19.5 GPa in the same work \
        in place of 24.5: a strength that is a share of G* comes out up to 1.4 times too high, one in Pa does not";
    "Si3N4" or "silicon nitride" or "SiN": E 222e9 in [150e9, 310e9], nu 0.28, H 21e9 in [15e9, 30e9], b 0.29e-9,
        from "LPCVD film: Vlassak and Nix, J. Mater. Res. 7 (1992) 3242; the range is that used for cantilever tips \
        and of dense nitride; a glass: second neighbours";
    "Al" or "aluminium" or "aluminum": E 70e9, nu 0.35, H 0.167e9 in [0.16e9, 0.35e9], of "pure metal", b 0.286e-9, family "Al",
        from metal!("Vickers hardness", "<110>/2 with a = 0.405 nm");
    "Cu" or "copper": E 130e9, nu 0.34, H 0.369e9 in [0.343e9, 0.369e9], of "pure metal", b 0.255e-9, family "Cu",
        from metal!("Vickers hardness", "<110>/2 with a = 0.361 nm");
    "Ag" or "silver": E 83e9, nu 0.37, H 0.251e9 in [0.245e9, 0.251e9], of "pure metal", b 0.289e-9, family "Ag",
        from metal!("Vickers hardness", "<110>/2 with a = 0.409 nm");
    "Ni" or "nickel": E 200e9, nu 0.31, H 0.638e9 in [0.638e9, 1.6e9], of "pure metal", b 0.249e-9, family "Ni",
        from metal!("Vickers hardness, the upper end Brinell's, worked", "<110>/2 with a = 0.352 nm");
    "Pt" or "platinum": E 168e9, nu 0.38, H 0.549e9 in [0.392e9, 0.549e9], of "pure metal", b 0.277e-9, family "Pt",
        from metal!("Vickers hardness, the lower end Brinell's", "<110>/2 with a = 0.392 nm");
    "W" or "tungsten": E 411e9, nu 0.28, H 3.43e9 in [2.57e9, 3.43e9], of "pure metal", b 0.274e-9, family "W",
        from metal!("Vickers hardness, the lower end Brinell's", "<111>/2 with a = 0.316 nm");
    "Mo" or "molybdenum": E 329e9, nu 0.31, H 1.53e9 in [1.4e9, 2.74e9], of "pure metal", b 0.273e-9, family "Mo",
        from "E and Poisson's ratio: WebElements, elasticities of the elements; Vickers hardness: Samsonov, Handbook \
        of the Physicochemical Properties of the Elements (1968); <111>/2 with a = 0.315 nm: Ashcroft and Mermin, \
        Solid State Physics";
    "Cr" or "chromium" or "chrome": E 279e9, nu 0.21, H 1.06e9 in [0.687e9, 6.5e9], of "pure metal", b 0.249e-9, family "Cr",
        from metal!(
            "Vickers hardness, the range Brinell's, from annealed to electroplated", "<111>/2 with a = 0.288 nm"
        );
    "Ti" or "titanium": E 116e9, nu 0.32, H 0.97e9 in [0.83e9, 3.42e9], of "pure metal", b 0.295e-9, family "Ti",
        from metal!("Vickers hardness", "<11-20>/3, a = 0.295 nm");
    "Fe" or "iron": E 211e9, nu 0.29, H 0.608e9 in [0.2e9, 1.18e9], of "pure metal", b 0.249e-9, family "steel",
        from metal!("Vickers hardness, the range Brinell's", "<111>/2 with a = 0.287 nm");
    "Ta" or "tantalum": E 186e9, nu 0.34, H 0.873e9 in [0.873e9, 1.2e9], of "pure metal", b 0.287e-9, family "Ta",
        from metal!("Vickers hardness", "<111>/2 with a = 0.331 nm");
    "Mg" or "magnesium": E 45e9, nu 0.29, H 0.26e9, of "pure metal", b 0.321e-9, family "Mg",
        from metal!("Brinell hardness", "<11-20>/3, a = 0.321 nm");
    "Pb" or "lead": E 16e9, nu 0.44, H 38e6, of "pure metal", b 0.35e-9, family "Pb",
        from metal!("Brinell hardness", "<110>/2 with a = 0.495 nm");
    "Al-6061" or "6061" or "Al6061" or "AA6061" or "6061-T6": E 68.9e9 in [68.9e9, 70e9], nu 0.33, H 1.05e9, of "6061-T6", b 0.286e-9, family "Al",
        from "6061-T6, Vickers 107 converted from Brinell 95: Aluminum Association, in ASM and MatWeb's data sheet of \
        6061-T6; the upper E and the Burgers vector are those of aluminium";
    "Ti-6Al-4V" or "Ti6Al4V" or "Ti64": E 113.8e9 in [108e9, 122e9], nu 0.342, H 3.4e9 in [3.3e9, 3.9e9], of "annealed", b 0.295e-9, family "Ti",
        from "annealed, Vickers 349 converted from Rockwell C: ASM and MatWeb's data sheet MTP641; the range from \
        annealed rod to printed parts: Materials 14 (2021) 658, table 4; the Burgers vector is that of titanium";
    "stainless" or "stainless steel" or "AISI 304" or "304" or "1.4301": E 196e9 in [193e9, 200e9], nu 0.29, H 1.27e9, of "AISI 304 annealed", b 0.258e-9, family "steel",
        from "AISI 304, annealed, Vickers 129 converted from Rockwell B: ASM and MatWeb's data sheet of 304; Burgers \
        vector: Frost and Ashby, Deformation-Mechanism Maps (1982), chapter 8";
    "Al2O3" or "alumina" or "aluminium oxide" or "aluminum oxide": E 416e9 in [386e9, 446e9], nu 0.231, H 15e9, of "sintered", b 0.476e-9,
        from "sintered, 99.5 % pure, the range its uncertainty: Munro, J. Am. Ceram. Soc. 80 (1997) 1919, and NIST \
        Standard Reference Database 150; <11-20>/3, a = 0.476 nm";
    "SiC" or "silicon carbide": E 415e9, nu 0.16, H 32e9, of "sintered", b 0.308e-9,
        from "sintered alpha-SiC: Munro, J. Phys. Chem. Ref. Data 26 (1997) 1195, and NIST Standard Reference \
        Database 150; <11-20>/3 of 6H, a = 0.308 nm";
    "diamond": E 1143e9 in [1050e9, 1143e9], nu 0.0691, H 80e9 in [56e9, 102e9], b 0.252e-9,
        from "polycrystal, the lower E along <100>: Klein and Cardinale, Diamond Relat. Mater. 2 (1993) 918; Knoop \
        hardness on (001) by direction: MatWeb; <110>/2 with a = 0.357 nm";
    "WC" or "tungsten carbide": E 534e9 in [530e9, 700e9], nu 0.22, b 0.291e-9,
        from "E and Poisson's ratio: Kaye and Laby, section 2.2.2; the range: Cardarelli, Materials Handbook (2018), and CRC \
        Handbook of Chemistry and Physics, as matmake.com has it; the upper end is quoted for carbide \
        without a binder; hardness is left out, since that of cemented carbide depends on the binder; <11-20>/3, \
        a = 0.2906 nm";
    "GaAs" or "gallium arsenide": E 116.5e9, nu 0.242, b 0.4e-9,
        from "Voigt, Reuss and Hill's mean of C11 = 119, C12 = 53.4, C44 = 59.6 GPa: Goldberg and Schmidt, Handbook \
        Series on Semiconductor Parameters 2 (1999); <110>/2 with a = 0.5653 nm";
    "glass" or "crown glass" or "BK7" or "N-BK7" or "soda-lime glass" or "float glass": E 71.3e9 in [70e9, 82e9], nu 0.22, H 5.98e9 in [5.59e9, 5.98e9], of "N-BK7", b 0.31e-9,
        from "crown glass: Kaye and Laby, section 2.2.2; the upper E and the hardness, Knoop 610: Schott's N-BK7, a \
        borosilicate crown glass, as pmoptics.com has it; the lower ends, Knoop 570: soda-lime float glass, MakeItFrom; the distance of like atoms is that of SiO2";
    "PDMS" or "Sylgard 184" or "Sylgard": E 2e6 in [1.32e6, 2.97e6], nu 0.5,
        from "Sylgard 184, by the temperature of curing: Johnston et al., J. Micromech. Microeng. 24 (2014) 035017; \
        taken as incompressible; an elastomer has no Burgers vector, and its viscoelasticity is outside the law";
};
