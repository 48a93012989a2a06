// What a user sets of a surface: the fields, their units on the page and in the library, and the parameters they become.

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
  pressure_coefficient: { label: "Pressure coefficient κ (empty: not known)", unit: "", power: 0 },
  calibration_friction_coefficient: { label: "Measured: μ", unit: "", power: 0, names: ["friction_force", "measured"] },
  calibration_load: { label: "… at a load of", unit: "N", power: 0, names: ["load"] },
  slip_stress_1: { label: "Strength τ/G* (empty: not known)", unit: "", power: 0, names: ["slip_stress_1", "slip_stress_2"] },
  process: { label: "Process", unit: "", choices: ["superfinished", "lapped", "honed", "ground", "turned", "bored", "milled"] },
  Ra: { label: "Ra", unit: "µm", power: -6, slider: [0.01, 20], names: ["Ra", "m0"] },
  Rq: { label: "Rq", unit: "µm", power: -6, slider: [0.01, 20], names: ["Rq", "m0"] },
  RSm: { label: "RSm, mean width of the elements", unit: "µm", power: -6, slider: [1, 1000], names: ["RSm", "m2", "rms_slope"] },
  Sq: { label: "Sq, rms height", unit: "nm", power: -9, slider: [0.1, 10000], names: ["Sq", "m0"] },
  Sdq: { label: "Sdq, rms slope", unit: "", power: 0, slider: [0.001, 1], names: ["Sdq", "m2", "rms_slope"] },
  Ssk: { label: "Ssk, skew of all heights", unit: "", power: 0 },
  Sku: { label: "Sku, kurtosis of all heights", unit: "", power: 0 },
  m0: { label: "m₀, variance of height", unit: "nm²", power: -18, slider: [0.01, 1e8] },
  m2: { label: "m₂, variance of slope", unit: "", power: 0, slider: [1e-6, 1] },
  height_std: { label: "σ, spread of the asperities' heights", unit: "nm", power: -9, slider: [0.1, 10000] },
  summit_radius: { label: "R, their radius", unit: "µm", power: -6, slider: [0.01, 1000] },
  summit_density: { label: "Asperities per area", unit: "1/µm²", power: 12, slider: [1e-5, 1000], names: ["asperity_count"] },
  nominal_area: { label: "Nominal area", unit: "mm²", power: -6, slider: [1e-6, 1e4] },
};

/** The ways to tell the roughness, and the fields of each. A file is a whole surface. */
export const ROUGHNESS = {
  process: { label: "process and Ra", fields: ["process", "Ra"] },
  profile: { label: "Rq and RSm of a profile", fields: ["Rq", "RSm"] },
  areal: { label: "Sq and Sdq of an area", fields: ["Sq", "Sdq", "Ssk", "Sku"] },
  moments: { label: "m₀ and m₂ (spectral moments)", fields: ["m0", "m2"] },
  summits: { label: "asperities: σ, R, density", fields: ["height_std", "summit_radius", "summit_density"] },
  file: { label: "surface file (drop one below)", fields: [] },
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
    const value = power === undefined ? undefined : parsed(surface[key]);
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
  const { calibration_load: load, calibration_friction_coefficient: mu } = surface.roughness === "file" ? ofFile(surface.file) : numbers(surface);
  return load > 0 && mu > 0 ? { load, mu } : undefined;
}

function ofFile(text) {
  const [, calibration_load, calibration_friction_coefficient] = /^measured\s*=[\s[]*([^\s,]+)\s*,\s*([^\s,\]]+)/m.exec(text) ?? [];
  return { calibration_load: Number(calibration_load), calibration_friction_coefficient: Number(calibration_friction_coefficient) };
}

/** Whether nothing of the surface tells how strong its interface is. */
export function uncalibrated(surface) {
  const { slip_stress_1, pressure_coefficient } = numbers(surface);
  return !measuredOf(surface) && (surface.roughness === "file" || (slip_stress_1 === undefined && !pressure_coefficient));
}

/** A surface to start from: that of README.md. */
export const start = (library) => ({
  first: "steel",
  second: "steel",
  ...fieldsOfPair(library, "steel", "steel"),
  pressure_coefficient: "",
  calibration_friction_coefficient: "0.16",
  calibration_load: "1000",
  specimens: "",
  contact_law: "",
  roughness: "process",
  process: "ground", Ra: "0.8",
  Rq: "1", RSm: "45",
  Sq: "1000", Sdq: "0.2", Ssk: "", Sku: "",
  m0: "1e6", m2: "0.02",
  height_std: "920", summit_radius: "40", summit_density: "0.001",
  file: "", file_name: "",
  measured_on: "",
  nominal_area: "100",
});

/** A rougher surface of the same interface: its strength was measured on this one. */
export function rougher(surface) {
  const height = { process: "Ra", profile: "Rq", areal: "Sq", moments: "m0", summits: "height_std" }[surface.roughness];
  const twice = String(Number(((height === "m0" ? 4 : 2) * parsed(surface[height])).toPrecision(3)));
  const measured = measuredOf(surface) && surface.roughness !== "summits" && !surface.measured_on;
  return { ...surface, [height]: twice, ...(measured ? { measured_on: roughnessOf(surface).join("\n") } : {}) };
}

/** The lines of a surface file on the roughness. */
function roughnessOf(surface) {
  const all = numbers(surface);
  const { fields } = ROUGHNESS[surface.roughness];
  return fields.flatMap((key) => (FIELDS[key].choices ? `${key} = "${surface[key]}"` : all[key] === undefined ? [] : `${key} = ${real(all[key])}`));
}

/** A number as all languages write one that is not whole: shortest, and with all its digits. */
export function real(value) {
  if (Number.isNaN(value)) return "nan";
  if (value !== 0 && (Math.abs(value) >= 1e5 || Math.abs(value) < 1e-3)) return value.toExponential().replace("e+", "e");
  return Number.isInteger(value) ? `${value}.0` : String(value);
}

/** The surface as the text of a surface file, in SI units: what differs from the table of materials, and the rest by name. */
export function textOf(library, surface) {
  if (surface.roughness === "file") return surface.file;
  const { first, second, contact_law, measured_on } = surface;
  const [all, known] = [numbers(surface), fieldsOfPair(library, first, second)];
  const [bodies, lengths] = [["E1", "nu1", "E2", "nu2"], ["hardness", "adhesion_range", "burgers_vector"]];
  const changed = (key) => surface[key] !== known[key];
  const own = bodies.some(changed);
  const lines = [own ? `# ${first} on ${second}` : `pair = "${first}/${second}"`];
  const say = (keys) => keys.forEach((key) => all[key] !== undefined && lines.push(`${key} = ${real(all[key])}`));
  say(["nominal_area", ...lengths.filter((key) => own || changed(key))]);
  if (contact_law) lines.push(`contact_law = "${contact_law}"`);
  if (contact_law === "elastic-plastic") lines.push("work_of_adhesion = 0.0");
  else if (own || changed("work_of_adhesion")) say(["work_of_adhesion"]);
  if (changed("slip_stress_1") && all.slip_stress_1 !== undefined) lines.push(`slip_stress_1 = ${real(all.slip_stress_1)}`, `slip_stress_2 = ${real(all.slip_stress_1)}`);
  say(["pressure_coefficient"]);
  const point = ["calibration_load", "calibration_friction_coefficient"];
  if (point.every((key) => all[key] !== undefined)) lines.push(`measured = [${point.map((key) => real(all[key])).join(", ")}]`);
  else say(point);
  if (surface.specimens) lines.push("specimens = 1");
  const rough = roughnessOf(surface);
  if (surface.roughness === "summits") lines.push(...rough);
  if (own) lines.push("", "[materials]"), say(bodies);
  if (surface.roughness !== "summits") lines.push("", "[roughness]", ...rough);
  if (measured_on) lines.push("", "[measured_on]", measured_on);
  return `${lines.join("\n")}\n`;
}

/** The field that a message of the library is about. */
export function fieldOf(message, surface) {
  const name = /^(?:\[\w+\] )?(\w+)/.exec(message)?.[1];
  const hidden = Object.values(ROUGHNESS).flatMap(({ fields }) => fields);
  const shown = [...ROUGHNESS[surface.roughness].fields, ...Object.keys(FIELDS).filter((key) => !hidden.includes(key))];
  return shown.find((key) => key === name) ?? shown.find((key) => FIELDS[key].names?.includes(name));
}
