// Answers of the native library, to hold those of WebAssembly against.
import { execFileSync } from "node:child_process";
import { mkdirSync } from "node:fs";
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../..", import.meta.url));
export const target = resolve(root, process.env.CARGO_TARGET_DIR ?? "target");
/** Where tests may write. */
export const scratch = resolve(target, "js-tests");
mkdirSync(scratch, { recursive: true });
const release = resolve(target, "release");
/** What links a program with the native library. */
export const LINK = ["-L", release, `-Wl,-rpath,${release}`, "-lasperity", "-lm"];

const compiler = process.env.CC ?? "cc";
let program;

function native(questions) {
  if (!program) {
    program = resolve(scratch, "native");
    const source = fileURLToPath(new URL("native.c", import.meta.url));
    const flags = ["-std=c11", "-Wall", "-Wextra", "-Werror", "-I", resolve(root, "include")];
    execFileSync(compiler, [...flags, source, "-o", program, ...LINK]);
  }
  return execFileSync(program, { input: questions.join("\n") + "\n", encoding: "utf8" }).trimEnd().split("\n");
}

/** 17 digits tell a double. */
const digits = (value) => (Number.isFinite(value) ? value.toPrecision(17) : value > 0 ? "inf" : value < 0 ? "-inf" : "nan");

/** The words of an answer, as bits. */
const words = (line) => line.trim().split(" ").map((word) => BigInt(`0x${word}`));

/** What the native library says of a surface at loads, and between the first and the last: bits, or its message. */
export function answers(params, loads) {
  const named = Object.entries(params).map(([name, value]) => `${name}=${digits(value)}`);
  const lines = native([
    `surface ${named.join(" ")}`,
    ...loads.map((load) => `load ${digits(load)}`),
    `check ${digits(loads[0])} ${digits(loads.at(-1))}`,
  ]);
  if (lines[0] !== "made") return { refused: lines[0].replace("refused: ", "") };
  const found = lines.slice(1).map((line) => (line.startsWith("refused: ") ? { refused: line.slice(9) } : words(line)));
  return { loads: found.slice(0, -1), warnings: found.at(-1)[0] };
}

/** Between which loads a warning of a surface holds, by bit: bits of two numbers, NaN where it holds at none, or the message. */
export function warningLoads(params, bits) {
  const named = Object.entries(params).map(([name, value]) => `${name}=${digits(value)}`);
  const [, ...lines] = native([`surface ${named.join(" ")}`, ...bits.map((bit) => `warning ${bit}`)]);
  return lines.map((line) => refusedOr(line, words));
}
/** What bits of warnings mean, a line for each. */
export const warningsText = (bits) => native([`text ${bits}`])[0].replaceAll("\t", "\n");

const refusedOr = (line, read) => (line.startsWith("refused: ") ? { refused: line.slice(9) } : read(line));

function entry(line) {
  const [name, reference, numbers] = line.split("\t");
  return { name, reference, numbers: words(numbers) };
}

/** The materials, pairs or interfaces of the native library: names, references, numbers as bits. @param {"materials" | "pairs" | "interfaces"} what */
export const entries = (what) => native([what]).map(entry);
/** One of them, or the message. @param {"material" | "pair" | "interface"} what */
export const entryOf = (what, name) => refusedOr(native([`${what} ${name}`])[0], entry);

/** The parameters that native.c prints, in its order. */
export const PRINTED = ["composite_modulus", "effective_shear_modulus", "tangential_modulus", "work_of_adhesion",
  "adhesion_range", "burgers_vector", "hardness", "slip_stress_1", "height_std", "summit_radius", "asperity_count",
  "nominal_area", "bandwidth", "skew", "kurtosis", "radius_amplitude", "radius_rate", "summit_mean_height", "rms_slope"];
const printed = (line) => refusedOr(line, (found) => Object.fromEntries(words(found).map((value, i) => [PRINTED[i], value])));
/** Parameters of a pair, and of McCool's summits, as bits by name. */
export const contactOf = (pair, ...values) => printed(native([`contact ${pair} ${values.map(digits).join(" ")}`])[0]);
export const mccoolOf = (...values) => printed(native([`mccool ${values.map(digits).join(" ")}`])[0]);

/** The bits of a number. */
export function bits(value) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  return view.getBigUint64(0);
}
