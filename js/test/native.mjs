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

/** The bits of a number. */
export function bits(value) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, value);
  return view.getBigUint64(0);
}
