// The explorer as one page that needs nothing beside it: style, script and library are inside. Its content security policy has
// the browser run only them, and refuse every connection.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { gzipSync } from "node:zlib";
import { build, transformSync } from "esbuild";
import { encoded } from "../explorer/seven_bits.js";

/** The page, from the sources in a folder and the library. */
export async function page(folder, wasm) {
  const [program, script] = await Promise.all([bundled(folder, "main.js"), bundled(folder, "loader.js")]);
  const style = transformSync(`${readFileSync(resolve(folder, "style.css"), "utf8")}${chartStyle()}`, { loader: "css", minify: true }).code;
  const packed = (kind, id, bytes) => `<script type="application/${kind}" id="${id}">${encoded(gzipSync(bytes, { level: 9 }))}</script>`;
  const parts = {
    POLICY: `<meta http-equiv="Content-Security-Policy" content="${policy([script, program], style)}">`,
    STYLE: `<style>${style}</style>`,
    LIBRARY: packed("wasm", "library", wasm),
    PROGRAM: packed("gzip", "program", program),
    SCRIPT: `<!-- Charts are drawn by uPlot:\n${licence()}-->\n<script>${script}</script>`,
  };
  const text = readFileSync(resolve(folder, "page.html"), "utf8");
  return text.replace(/<!-- (POLICY|STYLE|LIBRARY|PROGRAM|SCRIPT) -->/g, (_, name) => parts[name]);
}

async function bundled(folder, name) {
  const { outputFiles } = await build({ entryPoints: [resolve(folder, name)], bundle: true, minify: true, format: "iife", target: "es2022", write: false });
  return `\n${outputFiles[0].text.replaceAll("</script", "<\\/script")}`;
}

/** What the browser lets the page do: run these scripts with WebAssembly, take this style, show its empty icon; nothing else. */
const policy = (scripts, style) =>
  `default-src 'none'; script-src ${scripts.map((one) => `'${hash(one)}'`).join(" ")} 'wasm-unsafe-eval'; style-src '${hash(style)}'; img-src data:; ` +
  "base-uri 'none'; form-action 'none'";

const hash = (text) => `sha256-${createHash("sha256").update(text).digest("base64")}`;
const licence = () => readFileSync(new URL("../node_modules/uplot/LICENSE", import.meta.url), "utf8");
const chartStyle = () => readFileSync(new URL("../node_modules/uplot/dist/uPlot.min.css", import.meta.url), "utf8");
