// What the tests of pages share: the program, the sources of the page's script, a browser.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
export const packages = createRequire(join(root, "web/package.json"));
export const program = process.env.POINSOT ?? join(root, "build/poinsot");
// Milliseconds that a page may take where nothing is timed: the machine may be busy with other tests.
export const patience = 180_000;
export const folder = mkdtempSync(join(tmpdir(), "poinsot-web-"));
process.on("exit", () => {
  rmSync(folder, { recursive: true, force: true });
});

// A module of web/src, as JavaScript.
export async function source(name) {
  const { build } = packages("esbuild");
  const made = await build({
    entryPoints: [join(root, "web/src", name)],
    bundle: true,
    write: false,
    format: "esm",
    platform: "neutral",
    mainFields: ["module", "main"],
    nodePaths: [join(root, "web/node_modules")],
    logLevel: "error",
  });
  return import(`data:text/javascript;base64,${Buffer.from(made.outputFiles[0].contents).toString("base64")}`);
}

// Runs the program. Exit code 1 says that letters have no value, which is no failure here.
export function poinsot(...words) {
  const run = spawnSync(program, words, {
    encoding: "utf8",
    maxBuffer: 1 << 28,
  });
  assert.ok(run.status === 0 || run.status === 1, `poinsot ${words.join(" ")}: ${run.stderr}`);
  return run.stdout;
}

// What the page's script reads.
export function dataOf(path) {
  const html = readFileSync(path, "utf8");
  return JSON.parse(/<script type="application\/json" id="[a-z-]+">(.*?)<\/script>/s.exec(html)[1]);
}

function chromiumPath() {
  const named = process.env.POINSOT_CHROMIUM;
  if (named) return named;
  for (const name of ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"]) {
    if (existsSync(name)) return name;
  }
  throw new Error("these tests need the package chromium, or its path in POINSOT_CHROMIUM");
}

export async function openBrowser() {
  const { chromium } = packages("playwright-core");
  return chromium.launch({
    executablePath: chromiumPath(),
    // Without a graphics card; no sandbox, for tests may run as root.
    args: ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"],
  });
}

// A page that is open, and all that it should not have done.
export async function open(browser, path, options = {}) {
  const { width = 1200, scheme = "light" } = options;
  const context = await browser.newContext({
    viewport: { width, height: 800 },
    colorScheme: scheme,
  });
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  const wrong = [];
  page.on("console", (message) => wrong.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => wrong.push(`error: ${error.message}`));
  page.on("dialog", (dialog) => {
    wrong.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) wrong.push(`request: ${request.url()}`);
  });
  await page.goto(`file://${path}`);
  await page.waitForFunction(() => document.querySelector("footer, .cards") !== null);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return { page, wrong, close: () => context.close() };
}

export async function violations(page) {
  await page.evaluate(readFileSync(packages.resolve("axe-core/axe.min.js"), "utf8"));
  return page.evaluate(async () => {
    const found = await window.axe.run(document, {
      resultTypes: ["violations"],
      preload: false,
    });
    return found.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`);
  });
}

export const version = () => execFileSync(program, ["--version"], { encoding: "utf8" });
