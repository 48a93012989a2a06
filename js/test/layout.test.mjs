// The structs lie in WebAssembly's memory where js/src/header.js says: a C compiler for that target says the same.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { test } from "node:test";
import { LAYOUTS } from "../dist/header.js";
import { root, scratch } from "./paths.mjs";

/** Compiles assertions of the layouts for wasm32; throws with the compiler's words if one fails. */
function compile(layouts) {
  const lines = ["#include <asperity.h>"];
  for (const [struct, { size, fields }] of Object.entries(layouts)) {
    lines.push(`_Static_assert(sizeof(${struct}) == ${size}, "${struct}");`);
    for (const { name, offset } of fields)
      lines.push(`_Static_assert(offsetof(${struct}, ${name}) == ${offset}, "${struct}.${name}");`);
  }
  const source = resolve(scratch, "layout.c");
  writeFileSync(source, lines.join("\n") + "\n");
  const words = ["--target=wasm32-unknown-unknown", "-ffreestanding", "-fsyntax-only", "-std=c11", "-I", resolve(root, "include")];
  execFileSync("clang", [...words, source], { stdio: "pipe", encoding: "utf8" });
}

test("a C compiler for WebAssembly lays the structs out so", () => {
  compile(LAYOUTS);
  const { size, fields } = LAYOUTS.asperity_params;
  const moved = fields.map((field) => ({ ...field, offset: field.offset + 8 }));
  assert.throws(() => compile({ asperity_params: { size, fields: moved } }), /asperity_params/);
});
