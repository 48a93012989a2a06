// Builds the package: the library as WebAssembly, the modules, their types, and the explorer as one page.
//
// usage: node tools/build.mjs     needs cargo with the target wasm32-unknown-unknown, python3, and `npm ci` in this folder
// CARGO_TARGET_DIR is honoured.
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, rmSync, writeFileSync, readFileSync } from "node:fs";
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";
import * as header from "./header.mjs";
import { page } from "./page.mjs";

const js = fileURLToPath(new URL("..", import.meta.url));
const root = resolve(js, "..");
const target = resolve(root, process.env.CARGO_TARGET_DIR ?? "target");
const TRIPLE = "wasm32-unknown-unknown";

function run(command, ...words) {
  try {
    return execFileSync(command, words, { cwd: root, encoding: "utf8", stdio: ["ignore", "pipe", "inherit"], env });
  } catch (error) {
    if (error.code === "ENOENT") fail(`${command} is missing; run tests/setup.sh web`);
    if (error.stdout) process.stderr.write(error.stdout);
    fail(`${command} ${words.join(" ")} failed`);
  }
}

function fail(message) {
  console.error(`js/tools/build.mjs: ${message}`);
  process.exit(1);
}

// Without the names of functions, of which WebAssembly has no use.
const env = { ...process.env, CARGO_TARGET_DIR: target, CARGO_PROFILE_RELEASE_STRIP: "symbols" };

run("cargo", "build", "--release", "--locked", "--quiet", "--lib", "--target", TRIPLE);
writeFileSync(resolve(js, "src/header.js"), header.module(header.read()));
writeFileSync(resolve(js, "src/materials_table.js"), run("python3", resolve(js, "tools/materials.py")));

rmSync(resolve(js, "dist"), { recursive: true, force: true });
mkdirSync(resolve(js, "dist"));
cpSync(resolve(js, "src"), resolve(js, "dist"), { recursive: true });
cpSync(resolve(target, TRIPLE, "release/asperity.wasm"), resolve(js, "dist/asperity.wasm"));
run(process.execPath, resolve(js, "node_modules/typescript/bin/tsc"), "-p", js);

const explorer = await page(resolve(js, "explorer"), readFileSync(resolve(js, "dist/asperity.wasm")));
writeFileSync(resolve(js, "dist/explorer.html"), explorer);
for (const [name, bytes] of [["asperity.wasm", readFileSync(resolve(js, "dist/asperity.wasm"))], ["explorer.html", explorer]])
  console.log(`js/dist/${name}: ${(Buffer.byteLength(bytes) / 1000).toFixed(0)} kB`);
