// The parts of the explorer that need no browser: moments of maps, files, the band, programs that are copied.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";
import * as asperity from "asperity";
import { CONSTANTS } from "../dist/header.js";
import { decoded, encoded } from "../explorer/seven_bits.js";
import { curveOf, findSpans, isPartial } from "../explorer/curves.js";
import { UNMEASURED, fieldOf, fieldsOfPair, measuredOf, rougher, shifted, start, textOf, uncalibrated } from "../explorer/fields.js";
import { read } from "../explorer/maps.js";
import { LANGUAGES, snippet } from "../explorer/snippets.js";
import { interfacesFor, measuredText, partsOf } from "../explorer/sources.js";
import { bandOf, decade, missing, rests, SHORT, spanText, strength, unmeasured, withUnit } from "../explorer/text.js";
import { LINK, root, scratch } from "./paths.mjs";
import { expected, npy, roughMap, run } from "./python.mjs";

const { Model, contact, momentsOfAreal, momentsOfMap } = asperity;
const near = (found, wanted, tolerance, what) => assert.ok(Math.abs(found / wanted - 1) < tolerance, `${what}: ${found}, not ${wanted}`);

const [ROWS, COLUMNS] = [60, 80];
const heights = roughMap(ROWS, COLUMNS, 2);
const bufferOf = (bytes) => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const file = (name, bytes) => {
  const path = resolve(scratch, name);
  writeFileSync(path, bytes);
  return path;
};

test("moments of a map and of areal parameters are those of the Python package", () => {
  const areal = { Sq: 5e-9, Sdq: 0.08 };
  const pointed = { Sq: 5e-9, Sdq: 0.08, Ssc: 4e6 };
  const wanted = expected({
    maps: [[file("map.npy", npy(heights, [ROWS, COLUMNS])), 1e-8, -9]],
    areal: [[areal, 1e-8], [pointed, 1e-8]],
  });

  const found = momentsOfMap(heights.map((z) => shifted(z, -9)), COLUMNS, 1e-8);
  for (const name of ["m0", "m2", "m4", "isotropy", "area"]) near(found[name], wanted.maps[0][name], 1e-9, name);

  [areal, pointed].forEach((given, i) => {
    const made = new Model({ ...contact("Si", "Si"), ...momentsOfAreal(given), nominal_area: 1e-8 }).params;
    for (const [name, value] of Object.entries(wanted.areal[i])) near(made[name], value, 1e-13, name);
  });
});

test("a text means to the page what it means to Python", () => {
  const texts = Object.entries(expected({ texts: [[]] }).texts[0]);
  assert.ok(texts.length >= 50);
  for (const [text, { load, curve }] of texts) {
    // As a curve of the page is made, without the points between.
    const model = new Model(text);
    asperity.estimate(text, load).forEach((found, i) => {
      near(model.frictionAtLoad(load[i]), curve[i], 1e-5, text);
      near(found.curve_coefficient, curve[i], 1e-9, text);
    });
    model.free();
  }
});

test("distances of rows and columns may differ, and a map may be transposed", () => {
  const one = momentsOfMap(heights, COLUMNS, 3, 5);
  const turned = Float64Array.from({ length: heights.length }, (_, at) => heights[(at % ROWS) * COLUMNS + Math.floor(at / ROWS)]);
  const other = momentsOfMap(turned, ROWS, 5, 3);
  for (const name of ["m0", "m2", "m4", "isotropy", "area"]) near(other[name], one[name], 1e-9, name);
});

test("maps that tell nothing are refused with what is wrong", () => {
  assert.throws(() => momentsOfMap([1, 2, 3, 4], 2, 1), /4 heights in rows of 2: must be at least 3 rows/);
  assert.throws(() => momentsOfMap(new Float64Array(100), 7, 1), /100 heights in rows of 7: the last row is not whole/);
  assert.throws(() => momentsOfMap(new Float64Array(100), 10, 1), /flat/);
  assert.throws(() => momentsOfMap(heights, COLUMNS, -1), /dx = -1: must be finite and > 0/);
  assert.throws(() => momentsOfMap(heights.map((z, i) => (i === 85 ? NaN : z)), COLUMNS, 1), /NaN in row 2, column 6/);
  assert.deepEqual(momentsOfAreal({ Sq: 2, Sdq: 0.1 }), { m0: 4, m2: (0.1 * 0.1) / 2 });
  assert.throws(() => momentsOfAreal({ Sq: -1, Sdq: 1 }), /Sq = -1: must be finite and > 0/);
});

test("files of all kinds give the same heights", () => {
  const rows = Array.from({ length: ROWS }, (_, i) => [...heights.subarray(i * COLUMNS, (i + 1) * COLUMNS)]);
  const turned = Float64Array.from({ length: heights.length }, (_, at) => heights[(at % ROWS) * COLUMNS + Math.floor(at / ROWS)]);
  const swapped = Buffer.from(heights.slice().buffer).swap64();
  const texts = {
    "commas.csv": rows.map((row) => row.join(",")).join("\n"),
    "semicolons.csv": `# heights\n${rows.map((row) => row.join(";").replaceAll(".", ",")).join("\r\n")}\r\n`,
    "blanks.txt": rows.map((row) => row.join("  ")).join("\n"),
    "tabs.tsv": rows.map((row) => row.join("\t")).join("\n"),
  };
  const files = {
    "c.npy": npy(heights, [ROWS, COLUMNS]),
    "fortran.npy": npy(turned, [ROWS, COLUMNS], { fortran: true }),
    "big.npy": npy({ buffer: bufferOf(swapped) }, [ROWS, COLUMNS], { descr: ">f8" }),
    ...Object.fromEntries(Object.entries(texts).map(([name, text]) => [name, Buffer.from(text)])),
  };
  for (const [name, bytes] of Object.entries(files)) {
    const found = read(name, bufferOf(bytes));
    assert.equal(found.columns, COLUMNS, name);
    assert.deepEqual(found.heights, heights, name);
  }
  const whole = Int16Array.from({ length: 12 }, (_, i) => i * i - 20);
  assert.deepEqual([...read("i.npy", bufferOf(npy(whole, [3, 4], { descr: "<i2" }))).heights], [...whole]);
});

test("files that are none are refused with the place", () => {
  const refused = (name, bytes, message) => assert.throws(() => read(name, bufferOf(Buffer.from(bytes))), message);
  refused("a.csv", "1,2,3\n1,x,3\n", /a.csv, line 2: "x" is no number/);
  refused("a.csv", "1,2,3\n\n1,2\n", /a.csv, line 3: has 2 numbers, the rows before it have 3/);
  refused("a.csv", "# nothing\n", /a.csv: has no numbers/);
  refused("a.npy", npy(new Float64Array(8), [2, 2, 2]), /shape \(2, 2, 2\): must be 2-D/);
  refused("a.npy", npy(new Float64Array(8), [4, 4]), /ends too early/);
  refused("a.npy", npy(new Float64Array(8), [1, 4], { descr: "<c16" }), /type 'c16' are not read/);
});

const of = (first, second, given) => ({ ...start(asperity), first, second, ...fieldsOfPair(asperity, first, second), ...UNMEASURED, nominal_area: "0.01", ...given });
const SILICON = of("Si", "Si", { roughness: "areal", contact_law: "maugis", Sq: "5", Sdq: "0.08" });
const SURFACES = {
  "README's": start(asperity),
  rougher: rougher(start(asperity)),
  areal: { ...SILICON, Ssk: "-0.2", Sku: "3.2", hardness: "11" },
  moments: of("mica", "Au", { roughness: "moments", m0: "25", m2: "0.0032", E2: "77" }),
  summits: of("steel", "steel", { roughness: "summits", contact_law: "elastic-plastic", height_std: "5", summit_radius: "1", summit_density: "10" }),
  file: { ...start(asperity), roughness: "file", file: 'pair = "Si/Si"\nnominal_area = 1e-8\nmeasured = [1e-3, 0.3]\n[roughness]\nSq = 5e-9\nSdq = 0.08\n' },
};

/** Builds and runs a program, and gives what it prints. */
const RUN = {
  C: (path, program) => execFileSync("cc", ["-std=c11", "-Wall", "-Wextra", "-Werror", ...INCLUDE, path, "-o", program, ...LINK]),
  "C++": (path, program) => execFileSync("c++", ["-std=c++17", "-Wall", "-Wextra", "-Werror", ...INCLUDE, path, "-o", program, ...LINK]),
  Fortran: (path, program) => {
    const module = resolve(scratch, "asperity.o");
    const into = ["-std=f2018", "-J", scratch];
    if (!fortranModule) execFileSync("gfortran", [...into, "-c", resolve(root, "fortran/asperity.f90"), "-o", module]);
    fortranModule = true;
    execFileSync("gfortran", [...into, "-Wall", "-Wextra", "-Werror", path, module, "-o", program, ...LINK]);
  },
};
const INCLUDE = ["-I", resolve(root, "include")];
let fortranModule = false;

const MEASURED = { ...SURFACES.areal, calibration_friction_coefficient: "0.18", calibration_load: "0.002", pressure_coefficient: "0.03" };
const model = (surface) => new Model(textOf(asperity, surface));

for (const [name, surface] of Object.entries({ ...SURFACES, calibrated: MEASURED })) {
  test(`copied programs compute what the page shows: ${name}`, () => {
    const load = 0.00217;
    const wanted = model(surface).frictionAtLoad(load);
    const folder = resolve(scratch, name);
    mkdirSync(folder, { recursive: true });
    for (const [language, { file }] of Object.entries(LANGUAGES)) {
      const path = resolve(folder, file);
      writeFileSync(path, snippet(asperity, language, surface, load));
      let printed;
      if (language === "surface.toml") printed = new Model(asperity.readText(readFileSync(path, "utf8"))).frictionAtLoad(load);
      else if (language === "Python") printed = run([path]);
      else {
        const program = resolve(folder, language.replace("++", "pp"));
        RUN[language](path, program);
        printed = execFileSync(program, { encoding: "utf8" });
      }
      near(Number(printed), wanted, language === "surface.toml" ? 1e-6 : 1e-9, language);
    }
  });
}

test("the text of a surface names what the table has, and gives what is changed", () => {
  near(model(MEASURED).frictionAtLoad(0.002), 0.18, 1e-6, "the page");
  assert.match(textOf(asperity, MEASURED), /^pair = "Si\/Si"\n[^]*^hardness = 1\.1e10$[^]*^measured = \[0\.002, 0\.18\]$/m);
  assert.equal(textOf(asperity, start(asperity)), 'pair = "steel/steel"\nnominal_area = 1e-4\nmeasured = [1000.0, 0.16]\n\n[roughness]\nprocess = "ground"\nRa = 8e-7\n');
  assert.match(textOf(asperity, SURFACES.moments), /^# mica on Au$[^]*^\[materials\]\nE1 = 5\.4e10\nnu1 = 0\.1\nE2 = 7\.7e10$/m);
  assert.match(textOf(asperity, rougher(start(asperity))), /^Ra = 0\.0*16|^Ra = 1\.6e-6\n\n\[measured_on\]\nprocess = "ground"\nRa = 8e-7$/m);
});

test("a surface says whether its strength was measured", () => {
  const silicon = SILICON;
  assert.ok(uncalibrated(silicon));
  assert.equal(strength(silicon), "not measured");
  assert.match(unmeasured(silicon), /^ Not calibrated: the strength of this interface is a default, .* Enter one measured friction coefficient and its load\.$/);
  const measured = { ...silicon, calibration_friction_coefficient: "0.3", calibration_load: "1e-3" };
  assert.deepEqual(measuredOf(measured), { load: 1e-3, mu: 0.3 });
  assert.equal(strength(measured), "from μ = 0.3 at 1.00 mN");
  assert.equal(strength({ ...measured, measured_on: "Ra = 8e-7" }), "from μ = 0.3 at 1.00 mN, other roughness");
  for (const given of [{ slip_stress_1: "0.01" }, { pressure_coefficient: "0.1" }]) assert.equal(strength({ ...silicon, ...given }), "as given");
  assert.ok(uncalibrated({ ...silicon, pressure_coefficient: "0" }));
  for (const one of [silicon, { ...silicon, calibration_load: "1" }, { ...measured, calibration_friction_coefficient: "x" }])
    assert.equal(measuredOf(one), undefined);
});

/** The curve of a surface of the page. */
const shown = (surface, loads = [1e-5, 0.1]) => curveOf(asperity, textOf(asperity, surface), loads);

test("the band is the library's estimate of the surface file, and its middle the curve of the model", () => {
  const silicon = SILICON;
  const measured = { ...silicon, calibration_friction_coefficient: "0.3", calibration_load: "1e-3", pressure_coefficient: "0.02" };
  for (const surface of [silicon, measured, { ...silicon, contact_law: "elastic-plastic" }, { ...silicon, slip_stress_1: "0.02" }]) {
    const { model, band, loads, mu, low, high } = shown(surface);
    loads.forEach((load, i) => near(mu[i], model.frictionAtLoad(load), 1e-6, `mu at ${load} N`));
    const [one] = asperity.estimate(textOf(asperity, surface), [loads[60]]);
    near(low[60], one.low, 1e-6, "the lower end");
    near(high[60], one.high, 1e-6, "the upper end");
    near(band(loads[60]).mu, mu[60], 1e-6, "at the load that is read");
  }
});

test("a strength that nobody measured is an order of magnitude, and the page says so", () => {
  const silicon = SILICON;
  const of = (surface) => {
    const band = shown(surface).band(1e-3);
    return { ...band, text: rests(surface), words: bandOf(surface, band) };
  };
  const bare = of(silicon);
  near(Math.sqrt(bare.high / bare.low), 10.7, 1e-2, "ten times higher and lower, and what is not told of the heights");
  assert.ok(bare.low < bare.mu && bare.mu < bare.high);
  assert.equal(bare.text, "strength not measured: an order of magnitude");
  assert.match(bare.words, /^an order of magnitude, 0\.\d+ to \d\.\d+$/);
  const given = of({ ...silicon, slip_stress_1: "0.02" });
  assert.ok(given.low < given.mu && given.mu < given.high);
  assert.equal(given.text, "strength as given, taken as known");
  assert.match(given.words, /^95 %, 0\.\d+ to \d\.\d+$/);
  const measured = of({ ...silicon, calibration_friction_coefficient: "0.3", calibration_load: "1e-3" });
  near(measured.high / measured.mu, Math.exp(1.959963984540054 * 0.05), 1e-2, "at the point");
  assert.equal(measured.text, "strength measured at 1.00 mN to 5 %");
  assert.match(measured.words, /^95 %, 0\.\d+ to \d\.\d+$/);
});

test("warnings hold in the part of the loads that the library says", () => {
  const range = [1e-5, 0.1];
  const curve = shown(SILICON, range);
  const { model, loads, warnings } = curve;
  findSpans(curve);
  const texts = Object.fromEntries(warnings.map((warning) => [warning.name, spanText(warning, range)]));
  assert.deepEqual(Object.keys(texts), ["FEW", "UNCALIBRATED"]);
  const few = warnings.find(({ name }) => name === "FEW");
  const [lightest, heaviest] = few.span;
  const holds = (load) => (model.stateAtLoad(load).warnings & CONSTANTS.WARNING_FEW) !== 0;
  assert.ok(lightest === 1e-5 && holds(0.9999 * heaviest) && !holds(1.0001 * heaviest));
  assert.equal(texts.FEW, `below ${withUnit(few.span[1], "N")}`);
  assert.equal(texts.UNCALIBRATED, "at all these loads");
  assert.deepEqual(warnings.filter((warning) => isPartial(warning, loads)), [few]);
  assert.equal(spanText({ span: [2e-5, 0.1] }, range), "above 20.0 µN");
  assert.equal(spanText({ span: [2e-5, 1e-4] }, range), "from 20.0 µN to 100 µN");
  for (const span of [[NaN, NaN], [2, 1]]) {
    assert.equal(spanText({ span }, range), "somewhere between these loads");
    assert.ok(!isPartial({ span }, loads));
  }
  assert.ok(!isPartial({}, loads));
});

test("a program of a surface that is refused prints the library's message", () => {
  const text = snippet(asperity, "C", { ...SILICON, adhesion_range: "-1" }, 1e-3);
  const path = file("refused.c", text);
  RUN.C(path, resolve(scratch, "refused"));
  assert.throws(
    () => execFileSync(resolve(scratch, "refused"), { stdio: "pipe", encoding: "utf8" }),
    ({ status, stderr }) => status === 1 && /adhesion_range = -1e-9: must be/.test(stderr),
  );
});

test("numbers are shown with the prefix and the digits of an engineer", () => {
  assert.equal(withUnit(0.00123, "N"), "1.23 mN");
  assert.equal(withUnit(0.0009999, "N"), "1.00 mN");
  assert.equal(withUnit(1e-6, "N"), "1.00 µN");
  assert.equal(withUnit(-2.5e9, "Pa"), "-2.50 GPa");
  assert.equal(withUnit(0, "N"), "0 N");
  assert.deepEqual([1e-7, 1e-3, 10, 1e4].map(decade), ["100 nN", "1 mN", "10 N", "10 kN"]);
  assert.equal(shifted(0.384, -9), 0.384e-9);
  assert.equal(shifted(63, -3), 0.063);
});

test("every warning has a short name", () => {
  const warnings = Object.keys(CONSTANTS).filter((name) => name.startsWith("WARNING_"));
  assert.deepEqual(Object.keys(SHORT).map((name) => `WARNING_${name}`).sort(), warnings.sort());
});

test("a message of the library points to its field", () => {
  const areal = SILICON;
  assert.equal(fieldOf("adhesion_range = -1e-9: must be finite and > 0", areal), "adhesion_range");
  assert.equal(fieldOf("rms_slope = 6: must be at most 5", areal), "Sdq");
  assert.equal(fieldOf("asperity_count: must be set", { ...areal, roughness: "summits" }), "summit_density");
  assert.equal(fieldOf("friction_force = 1 at load = 1: must be above 2", areal), "calibration_friction_coefficient");
  assert.equal(fieldOf("load = -1: is below", areal), "calibration_load");
  assert.equal(fieldOf("nothing of the sort", areal), undefined);
});

test("references keep their text and have their addresses", () => {
  const { INTERFACES, MATERIALS, PAIRS } = asperity;
  const all = [INTERFACES, MATERIALS, PAIRS].flatMap(Object.values);
  for (const { name, reference } of all) {
    const parts = partsOf(reference);
    assert.equal(parts.map(({ text }) => text).join(""), reference);
    const links = parts.filter(({ href }) => href);
    assert.equal(links.length, (reference.match(/\bdoi\b|\barXiv\b/gi) ?? []).length, `${name}: ${reference}`);
    for (const { href } of links) assert.match(href, /^https:\/\/(doi\.org\/10\.\d+\/|arxiv\.org\/abs\/)[\w.()/-]*\w$/);
  }
  assert.deepEqual(partsOf("A, doi 10.1063/1.2711147, abstract; arXiv 1207.1863: 2").map(({ href }) => href), [
    undefined, "https://doi.org/10.1063/1.2711147", undefined, "https://arxiv.org/abs/1207.1863", undefined,
  ]);
});

test("the interfaces of a pair stand first, in either order, with what was measured", () => {
  const all = Object.values(asperity.INTERFACES);
  for (const [first, second] of [["Al", "steel"], ["steel", "Al"]]) {
    const found = interfacesFor(asperity, { first, second });
    assert.equal(found[0].name, "Al/steel clean");
    assert.deepEqual(new Set(found), new Set(all));
  }
  assert.deepEqual(interfacesFor(asperity, { first: "Si", second: "mica" }), all);
  for (const one of all) assert.match(measuredText(one), /^(τ₀ [\d.]+ [kMG]?Pa(, κ [\d.]+)?|μ [\d.]+( from [\d.]+ N)?)$/, one.name);
});

const PAGE = readFileSync(new URL("../dist/explorer.html", import.meta.url), "utf8");

test("the explorer is one file below 500 kB that asks for nothing", () => {
  assert.ok(Buffer.byteLength(PAGE) < 500e3, `${Buffer.byteLength(PAGE)} bytes`);
  assert.doesNotMatch(PAGE, /<(script|link|img)[^>]+(src|href)="(?!data:)/);
});

/** A packed part of the page. */
const packed = (id) => gunzipSync(decoded(new RegExp(`id="${id}">([^<]*)<`).exec(PAGE)[1]));

test("the page's policy lets its own script and style run, and nothing connect", () => {
  const [, content] = /<meta http-equiv="Content-Security-Policy" content="([^"]*)">/.exec(PAGE);
  assert.ok(PAGE.indexOf(content) < PAGE.search(/<(script|style|link)/), "it stands before what it is for");
  const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
  const [, style] = /<style>([^]*?)<\/style>/.exec(PAGE);
  const [, script] = /<script>([^]*?)<\/script>/.exec(PAGE);
  assert.deepEqual(Object.fromEntries(content.split("; ").map((one) => [one.split(" ")[0], one.split(" ").slice(1).join(" ")])), {
    "default-src": "'none'",
    "script-src": `${hash(script)} ${hash(packed("program").toString())} 'wasm-unsafe-eval'`,
    "style-src": hash(style),
    "img-src": "data:",
    "base-uri": "'none'",
    "form-action": "'none'",
  });
});

test("the library in the page is the library", () => {
  const wasm = readFileSync(new URL("../dist/asperity.wasm", import.meta.url));
  assert.ok(wasm.equals(packed("library")));
  for (const length of [0, 1, 2, 3, 4, 5, 6, 7, 8, 1000])
    for (const step of [37, 0, 1]) {
      const bytes = Uint8Array.from({ length }, (_, i) => i * step);
      assert.deepEqual(decoded(encoded(bytes)), bytes, `${length} bytes`);
    }
});

test("what is not known of a material is left empty, asked for, and said", () => {
  const surface = of("PDMS", "mica", { roughness: "areal", contact_law: "maugis", Sq: "5", Sdq: "0.08" });
  for (const key of ["adhesion_range", "burgers_vector", "hardness", "work_of_adhesion"]) assert.equal(surface[key], "", key);
  surface.work_of_adhesion = "50";
  assert.throws(() => model(surface), (error) => fieldOf(error.message.replace(/^line 1: /, ""), surface) === "burgers_vector");
  const length = { adhesion_range: "10", burgers_vector: "10", Sq: "1000" };
  assert.ok(model({ ...surface, ...length }).frictionAtLoad(1e-3) > 0);
  assert.match(missing(asperity.material("PDMS"))[0], /^No Burgers vector of PDMS/);
  assert.match(missing(asperity.material("mica"))[0], /^No hardness of mica/);
  assert.deepEqual(missing(asperity.material("Si")), []);
});
