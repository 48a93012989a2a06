// The structs lie in WebAssembly's memory where the package looks for them: a C compiler for that target says the same.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { test } from "node:test";
import { parse, read } from "../tools/header.mjs";
import { CONSTANTS, LAYOUTS } from "../dist/header.js";
import { root, scratch } from "./native.mjs";

/** Compiles assertions of the layouts for wasm32; throws with the compiler's words if one fails. */
function compile(layouts) {
  const lines = ["#include <asperity.h>"];
  for (const [struct, { size, fields }] of Object.entries(layouts)) {
    lines.push(`_Static_assert(sizeof(${struct}) == ${size}, "${struct}");`);
    for (const { name, offset, type } of fields) {
      lines.push(`_Static_assert(offsetof(${struct}, ${name}) == ${offset}, "${struct}.${name}");`);
      // An array of the type decays to a pointer to it.
      if (type !== "pointer")
        lines.push(`_Static_assert(_Generic(((${struct} *)0)->${name}, ${type}: 1, ${type} *: 1, default: 0), "${struct}.${name}");`);
    }
  }
  const source = resolve(scratch, "layout.c");
  writeFileSync(source, lines.join("\n") + "\n");
  const words = ["--target=wasm32-unknown-unknown", "-ffreestanding", "-fsyntax-only", "-std=c11", "-I", resolve(root, "include")];
  execFileSync("clang", [...words, source], { stdio: "pipe", encoding: "utf8" });
}

test("the package is built with the layouts of this header", () => {
  const { constants, structs } = parse(read());
  assert.deepEqual(CONSTANTS, constants);
  assert.deepEqual(Object.keys(LAYOUTS), Object.keys(structs));
  for (const struct of ["params", "state", "summary", "table", "sensitivities"])
    assert.ok(LAYOUTS[`asperity_${struct}`].fields.length > 10, struct);
  assert.ok(CONSTANTS.ABI_VERSION >= 1 && CONSTANTS.WARNING_FEW === 16);
});

test("a C compiler for WebAssembly lays the structs out so", () => compile(LAYOUTS));

test("a field that moves is found", () => {
  const { structs } = parse(read().replace("double burgers_vector;", ""));
  assert.throws(() => compile(structs), /asperity_params/);
});
