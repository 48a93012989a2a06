// The explorer as one page that needs nothing beside it: style, script and library are inside.
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
  const style = readFileSync(resolve(folder, "style.css"), "utf8") + chartStyle();
  const parts = {
    STYLE: `<style>\n${style}</style>`,
    LIBRARY: `<script type="application/wasm" id="library">${encoded(gzipSync(wasm, { level: 9 }))}</script>`,
    SCRIPT: `<!-- Charts are drawn by uPlot:\n${licence()}-->\n<script>\n${bundle.outputFiles[0].text.replaceAll("</script", "<\\/script")}</script>`,
  };
  const text = readFileSync(resolve(folder, "page.html"), "utf8");
  return text.replace(/<!-- (STYLE|LIBRARY|SCRIPT) -->/g, (_, name) => parts[name]);
}

const licence = () => readFileSync(new URL("../node_modules/uplot/LICENSE", import.meta.url), "utf8");
const chartStyle = () => readFileSync(new URL("../node_modules/uplot/dist/uPlot.min.css", import.meta.url), "utf8");
