// Every function that js/src/header.js declares, called as C declares it: with plausible arguments, and with each of them
// invalid. No call stops the instance, and the model is afterwards what it was before.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { CONSTANTS, FUNCTIONS, LAYOUTS } from "../dist/header.js";

const bytes = readFileSync(new URL("../dist/asperity.wasm", import.meta.url));
const { exports } = await WebAssembly.instantiate(await WebAssembly.compile(bytes), {});
const PAGE = 65536;
const OUTPUT = 8192;

/** Numbers by the names of arguments; those that are not listed are 1e-3. */
const NUMBERS = { E1: 160e9, E2: 160e9, nu1: 0.22, nu2: 0.22, alpha: 0.01, beta: 1000, gamma: 0.001, b_over_h: 1, poisson: 0.3,
  m0: 25e-18, m2: 0.0032, m4: 0, nominal_area: 1e-8, friction_coefficient: 0.2, lightest: 1e-4, heaviest: 1e-2, gap: 1e-8,
  displacement: 1e-9, increment: 1e-9, cosine: 1, sine: 0, force: 1 };
const SURFACE = 'pair = "Si/Si"\nnominal_area = 1e-8\n[roughness]\nSq = 5e-9\nSdq = 0.08\n';
const TEXTS = { surface: SURFACE, text: SURFACE, path: "no such file" };

/** A place in memory of its own, zeros until it is written. */
function place(size) {
  const at = exports.memory.grow(Math.ceil(size / PAGE)) * PAGE;
  return { at, view: () => new DataView(exports.memory.buffer, at, size) };
}
const string = (text) => {
  const { at } = place(text.length + 1);
  new Uint8Array(exports.memory.buffer).set(new TextEncoder().encode(text), at);
  return at;
};
const texts = {};
/** A text that stays. Memory may grow here, which makes views of it useless: take them afterwards. */
const textAt = (text) => (texts[text] ??= string(text));

const params = place(LAYOUTS.asperity_params.size).at;
const box = place(8);
/** The parameters of silicon. */
function filled() {
  assert.equal(exports.asperity_params_init(params, LAYOUTS.asperity_params.size), 0);
  assert.equal(exports.asperity_params_set_text(params, textAt(SURFACE), SURFACE.length), 0);
  return params;
}
/** A model of it. */
function made() {
  filled();
  assert.equal(exports.asperity_create(params, box.at), 0);
  return box.view().getUint32(0, true);
}

const USUAL = exports.asperity_friction_at_load(made(), 1e-3);

/** A plausible argument; pointers have a place of their own for each argument. */
const places = {};
function plausible(name, declared, i, model) {
  const [, type, argument] = /^(.*) (\w+)$/.exec(declared);
  if (type === "double") return NUMBERS[argument] ?? 1e-3;
  if (type === "uint64_t") return 16n;
  if (type === "int32_t" || type === "asperity_status") return 0;
  if (type === "size_t") {
    if (argument === "struct_size") return LAYOUTS.asperity_params.size;
    if (argument === "index") return 0;
    if (argument === "length") return FUNCTIONS[name].some((one) => /char \* (surface|text)$/.test(one)) ? SURFACE.length : OUTPUT;
    return argument === "buffer_length" ? OUTPUT : 1;
  }
  if (/asperity_model \*$/.test(type)) return model;
  if (type.endsWith("asperity_params *")) return filled();
  if (type === "const char *") return textAt(TEXTS[argument] ?? (name.endsWith("set_pair") ? "Si/Si" : "height_std"));
  const { at, view } = (places[i] ??= place(OUTPUT));
  const parameter = textAt("height_std");
  new Uint8Array(exports.memory.buffer, at, OUTPUT).fill(0);
  const struct = type.replace("const ", "").replace(" *", "");
  if (LAYOUTS[struct]) view().setBigUint64(0, BigInt(LAYOUTS[struct].size), true);
  else if (type === "const double *") for (let one = 0; one < 3; one++) view().setFloat64(8 * one, NUMBERS[argument] ?? 1e-3, true);
  else if (type.includes("asperity_model *const")) view().setUint32(0, model, true);
  else if (type.includes("char *const")) view().setUint32(0, parameter, true);
  return at;
}

/** What stands for a broken caller: NULL, NaN, infinity, numbers that are too large. Sizes of memory must be true. */
function invalid(declared) {
  if (declared.includes("*")) return [0];
  if (declared.startsWith("double")) return [NaN, Infinity, -Infinity, 1e308];
  if (declared.startsWith("uint64_t")) return [2n ** 64n - 1n];
  if (declared.startsWith("size_t")) return /index/.test(declared) ? [2 ** 32 - 1] : [0];
  return [-1, 2 ** 31 - 1];
}

/** Holds an answer to its type. */
function assertAnswer(name, found) {
  const [result] = FUNCTIONS[name];
  const statuses = [CONSTANTS.OK, CONSTANTS.NULL_POINTER, CONSTANTS.INVALID_PARAMETER, CONSTANTS.INVALID_LOAD, CONSTANTS.SEPARATED,
    CONSTANTS.OUT_OF_RANGE, CONSTANTS.NOT_CONVERGED];
  if (result === "asperity_status") assert.ok(statuses.includes(found), `${name}: ${found}`);
  else if (result === "void") assert.equal(found, undefined, name);
  else if (result.includes("*")) assert.ok(found >>> 0 < exports.memory.buffer.byteLength, name);
  else assert.equal(typeof found, "number", name);
}

test("every function is exported as it is declared, and nothing else", () => {
  const exported = Object.keys(exports).filter((name) => name.startsWith("asperity_"));
  assert.deepEqual(exported.sort(), Object.keys(FUNCTIONS).sort());
  for (const [name, [, ...declared]] of Object.entries(FUNCTIONS)) assert.equal(exports[name].length, declared.length, name);
});

for (const [name, [result, ...declared]] of Object.entries(FUNCTIONS))
  test(`${name} answers plausible arguments, and refuses each that is not`, () => {
    const model = made();
    const usual = () => declared.map((one, i) => plausible(name, one, i, model));
    const freed = name === "asperity_free";
    if (!freed) {
      const found = exports[name](...usual());
      assertAnswer(name, found);
      // There are no files, and unloading with adhesion is not modelled.
      const refused = { asperity_params_read: CONSTANTS.INVALID_PARAMETER, asperity_unloaded: CONSTANTS.OUT_OF_RANGE };
      if (result === "asperity_status") assert.equal(found, refused[name] ?? CONSTANTS.OK);
      if (result === "double") assert.ok(Number.isFinite(found), `${found}`);
      if (result === "size_t" || result.includes("*")) assert.ok(found > 0);
    }
    declared.forEach((one, i) => {
      for (const wrong of invalid(one)) assertAnswer(name, exports[name](...usual().map((value, at) => (at === i ? wrong : value))));
    });
    assert.equal(exports.asperity_friction_at_load(model, 1e-3), USUAL);
    exports.asperity_free(model);
  });
