// The Python package of the source tree, with the native library, to hold the page's numbers against.
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { resolve } from "node:path";
import { root, target } from "./paths.mjs";

const python = process.env.JS_TEST_PYTHON ?? resolve(target, "validation-venv/bin/python");
const env = {
  ...process.env,
  PYTHONPATH: resolve(root, "python/src"),
  PYTHONDONTWRITEBYTECODE: "1",
  ASPERITY_LIBRARY: resolve(target, "release/libasperity.so"),
};

/** Runs Python with the package. */
export const run = (words, input = "") => execFileSync(python, words, { encoding: "utf8", env, input });

/** What test/expected.py answers. */
export const expected = (questions) =>
  JSON.parse(run([fileURLToPath(new URL("expected.py", import.meta.url))], JSON.stringify(questions)));

/** Heights of a rough surface, the same ones in every run: sums of waves and noise. */
export function roughMap(rows, columns, amplitude) {
  let seed = 1;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  const waves = Array.from({ length: 12 }, () => [random() * 1.2, random() * 1.2, random() * 7]);
  return Float64Array.from({ length: rows * columns }, (_, at) => {
    const [i, j] = [Math.floor(at / columns), at % columns];
    const sum = waves.reduce((z, [p, q, phase]) => z + Math.cos(p * i + q * j + phase), 0);
    return amplitude * (sum + 0.2 * (random() - 0.5) + 0.05 * i - 0.02 * j);
  });
}

/** Heights in NumPy's format, version 1. */
export function npy(heights, shape, { descr = "<f8", fortran = false } = {}) {
  const order = fortran ? "True" : "False";
  const said = `{'descr': '${descr}', 'fortran_order': ${order}, 'shape': (${shape.join(", ")}), }`;
  const header = said.padEnd(Math.ceil((said.length + 11) / 64) * 64 - 11, " ") + "\n";
  const start = Buffer.concat([Buffer.from([0x93]), Buffer.from("NUMPY"), Buffer.from([1, 0, 0, 0])]);
  start.writeUInt16LE(header.length, 8);
  return Buffer.concat([start, Buffer.from(header, "latin1"), Buffer.from(heights.buffer)]);
}
