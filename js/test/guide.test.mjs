// The package as it is packed and installed, and the guide that is written for it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { root, scratch } from "./paths.mjs";

const js = fileURLToPath(new URL("..", import.meta.url));
const folder = resolve(scratch, "user");
const npm = (words, cwd) => execFileSync("npm", [...words, "--loglevel=error"], { cwd, encoding: "utf8" });

/** What a module of this text prints where the package is installed. */
function printed(text) {
  writeFileSync(resolve(folder, "user.mjs"), text);
  return execFileSync(process.execPath, ["user.mjs"], { cwd: folder, encoding: "utf8" });
}

before(() => {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const [{ filename }] = JSON.parse(npm(["pack", "--json", "--pack-destination", folder], js));
  writeFileSync(resolve(folder, "package.json"), '{ "private": true }');
  npm(["install", "--offline", "--no-audit", "--no-fund", resolve(folder, filename)], folder);
});

test("every block of docs/javascript.md prints what the page says", () => {
  const page = readFileSync(resolve(root, "docs/javascript.md"), "utf8").replaceAll("\r\n", "\n");
  const blocks = [...page.matchAll(/^```js\n([\s\S]*?)^```\n\n```text\n([\s\S]*?)^```$/gm)];
  assert.equal(blocks.length, page.split("```js\n").length - 1, "each has its output");
  assert.ok(blocks.length >= 3);
  const mark = "-- end of block --\n";
  const program = blocks.map(([, text]) => `${text}console.log("${mark.trim()}");\n`).join("");
  const found = printed(program).split(mark).slice(0, -1);
  if ("ASPERITY_WRITE_PAGES" in process.env) {
    const written = blocks.reduce((text, [block, , output], i) => text.replace(block, () => block.replace(`\`\`\`text\n${output}`, () => `\`\`\`text\n${found[i]}`)), page);
    writeFileSync(resolve(root, "docs/javascript.md"), written);
  } else assert.deepEqual(found, blocks.map(([, , output]) => output));
});

test("js/README.md runs", () => {
  const lines = readFileSync(resolve(js, "README.md"), "utf8").split("\n").filter((line) => line.startsWith("    "));
  assert.match(printed(lines.map((line) => line.slice(4)).join("\n")), /^0\.5424\d+\n$/);
});

test("the archive has what is needed and nothing else", () => {
  const [{ files }] = JSON.parse(npm(["pack", "--json", "--dry-run"], js));
  const names = files.map(({ path }) => path);
  for (const name of ["package.json", "README.md", "dist/asperity.wasm", "dist/index.js", "dist/types/index.d.ts", "dist/explorer.html"])
    assert.ok(names.includes(name), name);
  assert.ok(names.every((name) => /^(dist\/.*\.(js|d\.ts|wasm|html)|package\.json|README\.md)$/.test(name)), names.join(" "));
});

test("a program of the guide is one file in the formats that await nothing", () => {
  const page = readFileSync(resolve(root, "docs/javascript.md"), "utf8").replaceAll("\r\n", "\n");
  const [, text, command, says] = page.match(/^```js first\.js\n([\s\S]*?)^```\n[\s\S]*?^    npx (esbuild first\.js .*)\n[\s\S]*?^```text\n([\s\S]*?)^```$/m);
  writeFileSync(resolve(folder, "first.js"), text);
  const esbuild = resolve(js, "node_modules/.bin/esbuild");
  assert.ok(command.includes("--format=iife"));
  for (const format of ["iife", "cjs", "esm"]) {
    const words = command.replace("--format=iife", `--format=${format}`).replace("bundle.js", `${format}.${format === "esm" ? "m" : "c"}js`).split(" ").slice(1);
    execFileSync(esbuild, [...words, "--log-level=error"], { cwd: folder });
    assert.equal(execFileSync(process.execPath, [`${format}.${format === "esm" ? "m" : "c"}js`], { cwd: folder, encoding: "utf8" }), says, format);
  }
});
