// A surface as a program in C, C++, Fortran or Python, or as a TOML file: the same parameters that the page computes with.
import { numbers, paramsOf } from "./fields.js";

/** The languages, with the name of the file that the text is for. */
export const LANGUAGES = {
  C: { file: "friction.c", text: c },
  "C++": { file: "friction.cpp", text: cpp },
  Fortran: { file: "friction.f90", text: fortran },
  Python: { file: "friction.py", text: python },
  TOML: { file: "surface.toml", text: toml },
};

/** The surface as text; the programs print the friction coefficient at a load. */
export function snippet(language, surface, load) {
  const params = paramsOf(surface);
  const given = Object.entries(params).filter(([, value]) => value !== undefined);
  return LANGUAGES[language].text(Object.fromEntries(given), surface, load);
}

const UNITS = {
  work_of_adhesion: "J/m^2", adhesion_range: "m", burgers_vector: "m", height_std: "m", summit_radius: "m", hardness: "Pa",
  nominal_area: "m^2",
};
const BODIES = ["E1", "nu1", "E2", "nu2"];
const MEASURED = ["calibration_load", "calibration_friction_coefficient"];
const MOMENTS = ["m0", "m2", "nominal_area"];

/** The parameters that are set one by one: not by the setters of two bodies, of moments and of a measured point. */
function single(params) {
  const set = [...BODIES, ...("m0" in params ? MOMENTS : []), ...MEASURED];
  return Object.entries(params).filter(([name]) => !set.includes(name));
}

const isMeasured = (params) => MEASURED.every((name) => name in params);

const list = (params, names, form) => names.map((name) => form(params[name])).join(", ");

/** A constant of the library, or a number. */
const constantOr = (form) => (value) => (value === "elastic-plastic" ? "ASPERITY_CONTACT_ELASTIC_PLASTIC" : form(value));

/** A number as all of these languages write one that is not whole: shortest, and with all its digits. */
function real(value) {
  if (value !== 0 && (Math.abs(value) >= 1e5 || Math.abs(value) < 1e-3)) return value.toExponential().replace("e+", "e");
  return Number.isInteger(value) ? `${value}.0` : String(value);
}

function c(params, surface, load) {
  const lines = [`asperity_params_set_materials(&params, ${list(params, BODIES, real)}); /* E [Pa], nu */`];
  for (const [name, value] of single(params))
    lines.push(`params.${name} = ${constantOr(real)(value)};${UNITS[name] ? ` /* [${UNITS[name]}] */` : ""}`);
  if ("m0" in params)
    lines.push(
      "/* variances of height [m^2] and slope along profiles, of curvature (0: not known), nominal area [m^2] */",
      `asperity_params_set_spectral_moments(&params, ${list({ ...params, m4: 0 }, ["m0", "m2", "m4", "nominal_area"], real)});`,
    );
  if ("kurtosis" in params) lines.push("params.height_distribution = ASPERITY_HEIGHTS_JOHNSON;");
  const calibrate = isMeasured(params)
    ? `asperity_params_calibrate(&params, ${list(params, MEASURED, real)}) != ASPERITY_OK || /* measured: load [N], friction coefficient */\n        `
    : "";
  return `/* ${surface.first} on ${surface.second}. cc friction.c $(pkg-config --cflags --libs asperity) */
#include <asperity.h>
#include <stdio.h>

int main(void) {
    asperity_params params;
    asperity_model *model;
    asperity_params_init(&params, sizeof params);
    ${lines.join("\n    ")}
    if (${calibrate}asperity_create(&params, &model) != ASPERITY_OK) {
        char message[512];
        asperity_last_error(message, sizeof message);
        fprintf(stderr, "%s\\n", message);
        return 1;
    }
    printf("%.10g\\n", asperity_friction_at_load(model, ${real(load)})); /* load [N] */
    asperity_free(model);
}
`;
}

function cpp(params, surface, load) {
  const pairs = Object.entries(params).map(([name, value]) => `{"${name}", ${constantOr(real)(value)}},`);
  return `// ${surface.first} on ${surface.second}, in SI units. c++ -std=c++17 friction.cpp $(pkg-config --cflags --libs asperity)
#include <asperity.hpp>

#include <cstdio>
#include <exception>

int main() try {
    asperity::Params params;
    params.set({
        ${pairs.join("\n        ")}
    });
    const asperity::Model model(params);
    std::printf("%.10g\\n", model.friction_at_load(${real(load)})); // load [N]
} catch (const std::exception &error) {
    std::fprintf(stderr, "%s\\n", error.what());
    return 1;
}
`;
}

function fortran(params, surface, load) {
  const kind = (value) => `${real(value)}_c_double`;
  const lines = [`call asperity_check(asperity_params_set_materials(params, ${list(params, BODIES, kind)}))  ! E [Pa], nu`];
  for (const [name, value] of single(params))
    lines.push(`params%${name} = ${constantOr(kind)(value)}${UNITS[name] ? `  ! [${UNITS[name]}]` : ""}`);
  if ("m0" in params)
    lines.push(
      "call asperity_check(asperity_params_set_spectral_moments(params, &",
      `                    ${list({ ...params, m4: 0 }, ["m0", "m2", "m4", "nominal_area"], kind)}))  ! m0 [m^2], m2, m4: not known, area [m^2]`,
    );
  if ("kurtosis" in params) lines.push("params%height_distribution = ASPERITY_HEIGHTS_JOHNSON");
  if (isMeasured(params))
    lines.push("! Measured: load [N], friction coefficient", `call asperity_check(asperity_params_calibrate(params, ${list(params, MEASURED, kind)}))`);
  return `! ${surface.first} on ${surface.second}. To be compiled with asperity.f90 and linked with -lasperity
program friction
  use, intrinsic :: iso_c_binding, only: c_double
  use asperity
  implicit none
  type(asperity_params) :: params
  type(friction_model) :: law

  call asperity_check(asperity_params_init(params))
  ${lines.join("\n  ")}
  call law%create(params)
  write (*, '(es17.9)') law%friction_at_load(${kind(load)})  ! load [N]
  call law%free()
end program friction
`;
}

/** The roughness as the user gave it: areal parameters stay areal parameters. */
function roughness(params, surface) {
  if (surface.roughness !== "areal") return "m0" in params ? { m0: params.m0, m2: params.m2 } : {};
  const { Sq, Sdq } = numbers(surface);
  return { Sq, Sdq };
}

function others(params, more = []) {
  return Object.entries(params).filter(([name]) => !["m0", "m2", ...more].includes(name));
}

function python(params, surface, load) {
  const rough = roughness(params, surface);
  const ways = { areal: "Params.from_iso25178", moments: "Params.from_spectral_moments", summits: "Params.si" };
  const rest = others(params, MEASURED);
  const { calibration_load: at, calibration_friction_coefficient: mu } = params;
  const calibrate = isMeasured(params) ? `params = params.calibrated(load=${real(at)}, friction_coefficient=${real(mu)})  # measured: load in N\n` : "";
  const lines = [...Object.entries(rough), ...rest].map(([name, value]) => {
    const text = typeof value === "string" ? `"${value}"` : real(value);
    return `    ${name}=${text},${UNITS[name] ? `  # ${UNITS[name]}` : ""}`;
  });
  return `# ${surface.first} on ${surface.second}, in SI units
from asperity import Model, Params

params = ${ways[surface.roughness]}(
${lines.join("\n")}
)
${calibrate}model = Model(params)
print(f"{model.friction_at_load(${real(load)}):.10g}")  # load in N
`;
}

function toml(params, surface) {
  const lines = [`# ${surface.first} on ${surface.second}, in SI units: a surface file of asperity`];
  if (!params.contact_law) lines.push('contact_law = "maugis"');
  for (const [name, value] of others(params, BODIES)) lines.push(`${name} = ${typeof value === "string" ? `"${value}"` : real(value)}`);
  lines.push("", "[materials]", ...BODIES.map((name) => `${name} = ${real(params[name])}`));
  const rough = Object.entries(roughness(params, surface));
  if (rough.length) lines.push("", "[roughness]", ...rough.map(([name, value]) => `${name} = ${real(value)}`));
  return lines.join("\n") + "\n";
}
