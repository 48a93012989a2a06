// The explorer by the rules of accessibility that a program can check: axe-core, in Chromium.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const PAGE = pathToFileURL(fileURLToPath(new URL("../dist/explorer.html", import.meta.url))).href;
const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
let browser;

before(async () => {
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
});
after(() => browser?.close());

/** What is wrong with the page as it stands: the rule, and where it is broken. */
async function violations(page) {
  const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  assert.ok(found.passes.length > 15, "the rules were applied");
  return found.violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html, failureSummary }) => `${html} ${failureSummary}`).join("\n")}`);
}

for (const [screen, viewport] of Object.entries({ "a screen": { width: 1280, height: 900 }, "a phone": { width: 360, height: 740 } }))
  test(`no rule of accessibility is broken on ${screen}`, async () => {
    // What appears by an animation has its colours at once.
    const page = await browser.newPage({ viewport, reducedMotion: "reduce" });
    await page.goto(PAGE);
    await page.waitForSelector("#values td");
    await page.evaluate(AXE);
    assert.deepEqual(await violations(page), []);
    // With all that can be opened, two surfaces, and a message.
    await page.evaluate(() => document.querySelectorAll("details").forEach((one) => (one.open = true)));
    await page.locator("#add").click();
    await page.locator("#first").selectOption("steel");
    await page.locator("#nu1").fill("0.7");
    await page.waitForFunction(() => !document.getElementById("error").hidden);
    assert.deepEqual(await violations(page), []);
    // It can fail.
    await page.evaluate(() => document.getElementById("read").previousElementSibling.remove());
    assert.match((await violations(page)).join(), /label/);
    await page.close();
  });
