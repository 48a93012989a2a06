// The explorer as one page that needs nothing beside it: style, script and library are inside. Its content security policy has
// the browser run only them, and refuse every connection.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";
import { encoded } from "../explorer/base85.js";

/** The page, from the sources in a folder and the library. */
export async function page(folder, wasm) {
  const bundle = await build({
    entryPoints: [resolve(folder, "main.js")],
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    legalComments: "inline",
    loader: { ".css": "text" },
    write: false,
  });
  const style = `\n${readFileSync(resolve(folder, "style.css"), "utf8")}${chartStyle()}`;
  const script = `\n${bundle.outputFiles[0].text.replaceAll("</script", "<\\/script")}`;
  const parts = {
    POLICY: `<meta http-equiv="Content-Security-Policy" content="${policy(script, style)}">`,
    STYLE: `<style>${style}</style>`,
    LIBRARY: `<script type="application/wasm" id="library">${encoded(gzipSync(wasm, { level: 9 }))}</script>`,
    SCRIPT: `<!-- Charts are drawn by uPlot:\n${licence()}-->\n<script>${script}</script>`,
  };
  const text = readFileSync(resolve(folder, "page.html"), "utf8");
  return text.replace(/<!-- (POLICY|STYLE|LIBRARY|SCRIPT) -->/g, (_, name) => parts[name]);
}

/** What the browser lets the page do: run this script with WebAssembly, take this style, show its empty icon; nothing else. */
const policy = (script, style) =>
  `default-src 'none'; script-src '${hash(script)}' 'wasm-unsafe-eval'; style-src '${hash(style)}'; img-src data:; ` +
  "base-uri 'none'; form-action 'none'";

const hash = (text) => `sha256-${createHash("sha256").update(text).digest("base64")}`;
const licence = () => readFileSync(new URL("../node_modules/uplot/LICENSE", import.meta.url), "utf8");
const chartStyle = () => readFileSync(new URL("../node_modules/uplot/dist/uPlot.min.css", import.meta.url), "utf8");
