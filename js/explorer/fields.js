// What a user sets of a surface: the fields, their units on the page and in the library, and the parameters they become.
import { momentsOfAreal } from "../dist/instantiate.js";

/**
 * Fields of a surface. `power` is that of ten by which a number on the page becomes one in SI units; `slider` the range of
 * its slider, on a logarithmic scale. `names` are those by which the library's messages call it.
 */
export const FIELDS = {
  E1: { label: "E, first body", unit: "GPa", power: 9, names: ["E1", "composite_modulus", "effective_shear_modulus"] },
  nu1: { label: "ν, first body", unit: "", power: 0, names: ["nu1"] },
  E2: { label: "E, second body", unit: "GPa", power: 9, names: ["E2"] },
  nu2: { label: "ν, second body", unit: "", power: 0, names: ["nu2"] },
  work_of_adhesion: { label: "Work of adhesion w", unit: "mJ/m²", power: -3, slider: [1, 1000] },
  adhesion_range: { label: "Range of adhesion h", unit: "nm", power: -9 },
  burgers_vector: { label: "Burgers vector b", unit: "nm", power: -9 },
  hardness: { label: "Hardness H (empty: not known)", unit: "GPa", power: 9 },
  pressure_coefficient: { label: "Pressure coefficient κ (empty: 0)", unit: "", power: 0 },
  calibration_friction_coefficient: { label: "Measured: μ", unit: "", power: 0, names: ["friction_force"] },
  calibration_load: { label: "… at a load of", unit: "N", power: 0, names: ["load"] },
  slip_stress_1: { label: "Strength of small contacts τ₁/G* (empty: 1/43)", unit: "", power: 0 },
  Sq: { label: "Sq, rms height", unit: "nm", power: -9, slider: [0.1, 1000], names: ["Sq", "m0"] },
  Sdq: { label: "Sdq, rms slope", unit: "", power: 0, slider: [0.001, 1], names: ["Sdq", "m2", "rms_slope"] },
  m0: { label: "m₀, variance of height", unit: "nm²", power: -18, slider: [0.01, 1e6] },
  m2: { label: "m₂, variance of slope", unit: "", power: 0, slider: [1e-6, 1] },
  height_std: { label: "σ, spread of summit heights", unit: "nm", power: -9, slider: [0.1, 1000] },
  summit_radius: { label: "R, summit radius", unit: "µm", power: -6, slider: [0.01, 100] },
  summit_density: { label: "Summits per area", unit: "1/µm²", power: 12, slider: [0.01, 1000], names: ["asperity_count"] },
  skew: { label: "Skew of summit heights", unit: "", power: 0 },
  kurtosis: { label: "Kurtosis", unit: "", power: 0 },
  nominal_area: { label: "Nominal area", unit: "mm²", power: -6, slider: [1e-6, 1e4] },
};

/** The ways to tell the roughness, and the fields of each. */
export const ROUGHNESS = {
  areal: { label: "Sq, Sdq (areal parameters)", fields: ["Sq", "Sdq"] },
  moments: { label: "m₀, m₂ (spectral moments)", fields: ["m0", "m2"] },
  summits: { label: "σ, R, density (summits)", fields: ["height_std", "summit_radius", "summit_density"] },
};

/** A number times a power of ten, without the rounding of a product. */
export function shifted(value, power) {
  if (!Number.isFinite(value)) return value;
  const [mantissa, exponent] = value.toExponential().split("e");
  return Number(`${mantissa}e${Number(exponent) + power}`);
}

/** What stands in a field as a number: undefined if it is empty, NaN if it is none. */
export function parsed(text) {
  const plain = text.trim().replace(",", ".").replace("−", "-");
  return plain === "" ? undefined : Number(plain);
}

/** The numbers of a surface in SI units, by field. */
export function numbers(surface) {
  const found = {};
  for (const [key, { power }] of Object.entries(FIELDS)) {
    const value = parsed(surface[key]);
    if (value !== undefined) found[key] = shifted(value, power);
  }
  return found;
}

/** What the library tells of two materials: numbers for the fields of a pair, as text in the page's units. */
export function fieldsOfPair(library, first, second) {
  const given = library.knownOf(first, second);
  const keys = ["E1", "nu1", "E2", "nu2", "work_of_adhesion", "adhesion_range", "burgers_vector", "hardness", "slip_stress_1"];
  return Object.fromEntries(
    keys.map((key) => [key, given[key] === undefined ? "" : String(shifted(given[key], -FIELDS[key].power))]),
  );
}

/** Without a measured point. */
export const UNMEASURED = { calibration_friction_coefficient: "", calibration_load: "" };

/** The measured point of a surface, undefined if there is none. */
export function measuredOf(surface) {
  const { calibration_load: load, calibration_friction_coefficient: mu } = numbers(surface);
  return load > 0 && mu > 0 ? { load, mu } : undefined;
}

/** Whether nothing of the surface tells how strong its interface is. */
export function uncalibrated(surface) {
  const { slip_stress_1, pressure_coefficient } = numbers(surface);
  return !measuredOf(surface) && slip_stress_1 === undefined && !pressure_coefficient;
}

/** A surface to start from. */
export const start = (library) => ({
  first: "Si",
  second: "Si",
  ...fieldsOfPair(library, "Si", "Si"),
  pressure_coefficient: "",
  ...UNMEASURED,
  contact_law: "maugis",
  roughness: "areal",
  Sq: "5", Sdq: "0.08",
  m0: "25", m2: "0.0032",
  height_std: "5", summit_radius: "1", summit_density: "10",
  skew: "", kurtosis: "",
  nominal_area: "0.01",
});

/** The parameters that the library is given, in SI units. */
export function paramsOf(surface) {
  const all = numbers(surface);
  const params = {};
  for (const key of ["E1", "nu1", "E2", "nu2", "adhesion_range", "burgers_vector", "hardness", "slip_stress_1", "nominal_area",
    "pressure_coefficient", "calibration_load", "calibration_friction_coefficient"])
    params[key] = all[key];
  params.work_of_adhesion = surface.contact_law === "elastic-plastic" ? 0 : all.work_of_adhesion;
  if (surface.contact_law === "elastic-plastic") params.contact_law = surface.contact_law;
  if (surface.roughness === "areal")
    Object.assign(params, momentsOfAreal({ Sq: NaN, Sdq: NaN, ...only(all, ["Sq", "Sdq"]) }));
  else if (surface.roughness === "moments") Object.assign(params, only(all, ["m0", "m2"]));
  else {
    Object.assign(params, only(all, ["height_std", "summit_radius"]));
    // Of no area or density there is no number of summits, which the library then asks for.
    const count = all.summit_density * all.nominal_area;
    if (!Number.isNaN(count)) params.asperity_count = count;
  }
  if (all.skew !== undefined || all.kurtosis !== undefined) {
    params.skew = all.skew ?? 0;
    params.kurtosis = all.kurtosis ?? 3;
  }
  return params;
}

const only = (from, keys) => Object.fromEntries(keys.filter((key) => from[key] !== undefined).map((key) => [key, from[key]]));

/** The field that a message of the library is about. */
export function fieldOf(message, surface) {
  const name = /^(\w+)/.exec(message)?.[1];
  const hidden = Object.values(ROUGHNESS).flatMap(({ fields }) => fields);
  const shown = [...ROUGHNESS[surface.roughness].fields, ...Object.keys(FIELDS).filter((key) => !hidden.includes(key))];
  return shown.find((key) => key === name) ?? shown.find((key) => FIELDS[key].names?.includes(name));
}
