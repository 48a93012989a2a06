//! The interfaces. Add one here and to no other place: every language reads this table, and `docs/materials.md` is tested
//! against it.

use super::Interface;
use crate::materials::names::c_string;

/// Rows of a name, the shear strength `tau` [Pa] at no pressure and its growth with pressure `kappa`, or a friction coefficient `mu`
/// and the load [N] at which it was measured, the conditions, and where the numbers are from: `read` there, or `quoted`. What has
/// no number with a source is left out.
macro_rules! interfaces {
    ($($name:literal: $(tau $tau:literal,)? $(kappa $kappa:literal,)? $(mu $mu:literal $(at $load:literal)?,)?
       conditions $conditions:literal, $source:ident $reference:literal;)*) => {
        &[$(Interface {
            name: c_string!($name),
            $(shear_strength: $tau,)?
            $(pressure_coefficient: $kappa,)?
            $(friction_coefficient: $mu, $(load: $load,)?)?
            conditions: c_string!($conditions),
            source: c_string!(stringify!($source)),
            reference: c_string!($reference),
            ..UNKNOWN_INTERFACE
        }),*]
    };
}

const UNKNOWN_INTERFACE: Interface = Interface {
    name: c"",
    shear_strength: 0.0,
    pressure_coefficient: 0.0,
    friction_coefficient: 0.0,
    load: 0.0,
    conditions: c"",
    source: c"",
    reference: c"",
};

/// All interfaces.
pub static INTERFACES: &[Interface] = interfaces! {
    "MoS2 film in dry air": tau 24.8e6, kappa 0.001,
        conditions "balls of bearing materials on sputtered films, dry air, Hertz' pressures of 0.2 to 1.5 GPa, 1 to 50 N",
        read "Singer et al., Appl. Phys. Lett. 57 (1990) 995, abstract: 24.8 +- 0.5 MPa and 0.001 +- 0.001, over 600 points";
    "MoS2 bilayer": tau 2.795e6,
        conditions "two layers, one sample, pushed into a hole by a tip; independent of the twist of the layers",
        read "Sun et al., Nature Commun. 13 (2022), doi 10.1038/s41467-022-31685-7, abstract and caption of figure 3";
    "KCl film on iron in vacuum": tau 65e6, kappa 0.14,
        conditions "films of KCl on metals, pin of tungsten carbide, ultrahigh vacuum",
        read "Garvey, Weinert and Tysoe, Tribol. Lett. 44 (2011) 67, abstract: 65 +- 5 MPa and 0.14 +- 0.02; Gao et al., Tribol. \
        Lett. 31 (2008) 99, abstract: 60 to 70 MPa and 0.14 +- 0.02 on ten metals";
    "KCl monolayer on iron in vacuum": mu 0.27,
        conditions "one layer of KCl on clean iron, pin of tungsten carbide, ultrahigh vacuum; load not given",
        read "An investigation of the tribological properties of thin KCl films on iron in ultrahigh vacuum, abstract";
    "iron/WC in vacuum": mu 2.0,
        conditions "clean iron, pin of tungsten carbide, ultrahigh vacuum; load not given",
        read "The frictional behavior of thin halide films on iron, Tribol. Trans. (2004), doi 10.1080/05698190490431894, \
        abstract: about 2";
    "DLC/sapphire": tau 12e6,
        conditions "nanocomposite DLC, sapphire tip of 300 um diameter, 0.2 to 2 GPa, 4 um/s",
        read "Microtribology of diamond-like carbon nanocomposite coatings, World Tribology Congress 2005, abstract: 12 +- 1 MPa";
    "DLC/diamond": tau 31e6,
        conditions "nanocomposite DLC, diamond tip of 20 um diameter, 0.2 to 2 GPa, 4 um/s",
        read "Microtribology of diamond-like carbon nanocomposite coatings, World Tribology Congress 2005, abstract: 31 +- 3 MPa";
    "DLC in dry nitrogen": mu 0.02,
        conditions "nanocomposite DLC (C:H:Si:O), less than 1 % humidity, Hertz' pressure of 0.3 GPa; falls as the pressure grows",
        read "Scharf et al., J. Appl. Phys. (2007), doi 10.1063/1.2711147, abstract: about 0.02";
    "DLC in air": mu 0.2,
        conditions "nanocomposite DLC (C:H:Si:O), air, Hertz' pressure of 0.3 GPa; humidity not given",
        read "Scharf et al., J. Appl. Phys. (2007), doi 10.1063/1.2711147, abstract: about 0.2";
    "diamond/WC in vacuum": tau 238e6,
        conditions "tip of tungsten carbide on hydrogen-terminated diamond (111), ultrahigh vacuum, one contact",
        quoted "Enachescu et al., Phys. Rev. Lett. 81 (1998) 1877: 238 MPa; the abstract says that friction is \
        proportional to the area, without a number";
    "mica/mica in air": tau 1e6,
        conditions "cleaved muscovite, ambient air, surface forces apparatus",
        read "Friction measured with a surface forces apparatus, Tribol. Trans. 32 (1989) 246, abstract: about 1 MPa";
    "mica/Au pillar": tau 264e6,
        conditions "gold pillar on mica, atomic force microscope, one contact; its size is not given",
        read "Li and Kim, Proc. R. Soc. A 464 (2008) 1319, abstract";
    "mica/Au rough tip": tau 40.5e6,
        conditions "gold tip with a roughness of nanometres on mica, atomic force microscope; stress on the apparent area",
        read "Li and Kim, Proc. R. Soc. A 464 (2008) 1319, abstract";
    "graphite layers": tau 140e6,
        conditions "layers of a single crystal; layers out of registry slide far more easily (Phys. Rev. Lett. 108 (2012) 205503, abstract)",
        read "Liu et al., Interlayer shear strength of single crystalline graphite, arXiv 1207.1863, abstract: 0.14 GPa; others found 0.2 \
        MPa to 7 GPa";
    "graphene bilayer": tau 40e3,
        conditions "two layers of graphene, blown to a bubble",
        read "Wang et al., Measuring interlayer shear stress in bilayer graphene, Phys. Rev. Lett. (2017), abstract";
    "graphene/SiO2": tau 1.64e6,
        conditions "one layer of graphene on silicon oxide, blown to a bubble",
        read "Wang et al., Measuring interlayer shear stress in bilayer graphene, Phys. Rev. Lett. (2017), abstract";
    "nanotubes/Au": tau 87e6,
        conditions "single-walled carbon nanotubes assembled on gold; annealing made it three times as strong",
        read "paper on nanotubes and cantilevers, J. Colloid Interface Sci. (2015), daneshyari.com article 606831, abstract";
    "ZnO/SiO2 in air": tau 1.05e6,
        conditions "nanowires on an amorphous film, ambient air, kinetic, no load but adhesion",
        read "The kinetic friction of ZnO nanowires on amorphous SiO2 and SiN substrates, abstract: 1.05 +- 0.28 MPa";
    "ZnO/Si3N4 in air": tau 2.08e6,
        conditions "nanowires on an amorphous film, ambient air, kinetic, no load but adhesion",
        read "The kinetic friction of ZnO nanowires on amorphous SiO2 and SiN substrates, abstract: 2.08 +- 0.33 MPa";
    "ZnO/graphite in air": tau 0.51e6,
        conditions "nanowires on a cleaved crystal, ambient air, kinetic, no load but adhesion",
        read "The kinetic frictional shear stress of ZnO nanowires on graphite and mica substrates, abstract; Hou et al., Friction \
        (2022), doi 10.1007/s40544-021-0577-2, abstract: 0.48 MPa on natural graphite";
    "ZnO/mica in air": tau 5.1e6,
        conditions "nanowires on a cleaved crystal, ambient air, kinetic, no load but adhesion",
        read "The kinetic frictional shear stress of ZnO nanowires on graphite and mica substrates, abstract";
    "Al2O3/Si in air": tau 2.0e6,
        conditions "nanowires on a wafer, ambient air, kinetic, no load but adhesion",
        read "Wang et al., Appl. Phys. Lett. (2015), doi 10.1063/1.4930576, abstract: 2.0 +- 0.2 MPa";
    "Al2O3/Si3N4 in air": tau 1.5e6,
        conditions "nanowires on a film, ambient air, kinetic, no load but adhesion",
        read "Wang et al., Appl. Phys. Lett. (2015), doi 10.1063/1.4930576, abstract: 1.5 +- 0.2 MPa";
    "polysilicon/polysilicon": mu 4.9,
        conditions "microstructures with coarse grains, static, loads of an electrode, not given",
        read "Lim et al., Polysilicon microstructures to characterize static friction, IEEE MEMS 1990, abstract: 4.9 +- 1.0";
    "Si3N4/polysilicon": mu 2.5,
        conditions "microstructures, static, loads of an electrode, not given",
        read "Lim et al., Polysilicon microstructures to characterize static friction, IEEE MEMS 1990, abstract: 2.5 +- 0.5";
    "polysilicon with FTS monolayer": mu 0.08,
        conditions "microstructures coated with a fluorinated trichlorosilane, dynamic; load not given",
        quoted "Srinivasan et al., 1998, as cited by others of Lubrication of polysilicon micromechanisms with self-assembled \
        monolayers, doi 10.2172/671989";
    "steel/steel dry": mu 0.57 at 12.0,
        conditions "ball of AISI 52100 on cold rolled high-strength steel, air, after some wear, 12 to 50 N",
        read "Measurement and analysis of the kinetic friction coefficient of AISI 52100 and ceramic balls on cold rolled \
        high-strength steel, abstract: 0.56 to 0.58";
    "steel/steel clean": mu 0.78,
        conditions "hard steel, clean and dry, static; load and roughness not given",
        read "table of friction coefficients kept at Lawrence Berkeley National Laboratory, www-eng.lbl.gov; sliding 0.42";
    "steel/steel oxidised": mu 0.27,
        conditions "thick film of oxide, dry, static; load and roughness not given",
        read "table of friction coefficients kept at Lawrence Berkeley National Laboratory, www-eng.lbl.gov; with a film of sulfide 0.39";
    "steel/steel with light grease": mu 0.65 at 128.0,
        conditions "balls of a four-ball test, 200 revolutions a minute, mean of 15 minutes, 128 to 461 N; 0.48 at 461 N",
        read "Marko, Lubricants 7 (2019) 14, table of results";
    "steel/steel with ZDDP": mu 0.115,
        conditions "boundary lubrication, oil with secondary zinc dialkyldithiophosphate, rolling and sliding; load not given",
        read "Zhang et al., Boundary friction of ZDDP tribofilms, Tribol. Lett. (2021), abstract: about 0.115; primary ones 0.09 to 0.14";
    "steel/steel with stearic acid": mu 0.055,
        conditions "mixed and boundary lubrication, stearic acid in polyalphaolefin on iron oxide, hot (50 to 150 C were tried); load not given",
        read "Loehle et al., Mixed lubrication with C18 fatty acids: effect of unsaturation, Tribol. Lett. (2014), abstract: about 0.055";
    "Al/Al clean": mu 1.05,
        conditions "clean and dry, static; load and roughness not given",
        read "table of friction coefficients kept at Lawrence Berkeley National Laboratory, www-eng.lbl.gov: 1.05 to 1.35; sliding 1.4";
    "Al/Al greased": mu 0.3,
        conditions "greasy, static; load and roughness not given",
        read "table of friction coefficients kept at Lawrence Berkeley National Laboratory, www-eng.lbl.gov";
    "Al/steel clean": mu 0.61,
        conditions "mild steel, clean and dry, static; load and roughness not given",
        read "table of friction coefficients kept at Lawrence Berkeley National Laboratory, www-eng.lbl.gov; sliding 0.47";
    "Cu/Cu oxidised": mu 0.76,
        conditions "thick film of oxide, dry, static; load and roughness not given",
        read "table of friction coefficients kept at Lawrence Berkeley National Laboratory, www-eng.lbl.gov; clean 1.21";
    "graphite/steel": mu 0.1,
        conditions "dry or greasy, static; load and roughness not given",
        read "coefficient of friction reference chart, schneider-company.com";
    "Ag film/diamond in vacuum": mu 0.007,
        conditions "film of silver 5 nm thick, diamond pin, ultrahigh vacuum, the least of many thicknesses; load not given",
        read "paper on a diamond pin on silver films in ultrahigh vacuum, World Tribology Congress 2005, WTC2005/42029/439, abstract";
    "PTFE/steel dry": mu 0.12,
        conditions "AISI 1045 steel, 24 C; a polymer, so that time and speed matter; load not given",
        read "study of torsional contacts of PTFE; authors, journal and year not known";
};
