// What the program writes: galleries, solids, and what it refuses.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import test, { after, before } from "node:test";
import { dataOf, folder, open, openBrowser, packages, poinsot, program, root, violations } from "./support.mjs";

const examples = join(root, "examples");

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

test("a gallery has a page for every file of the textbook and is searched by words and kinds", async () => {
  const gallery = join(folder, "gallery");
  poinsot("report", join(examples, "textbook"), "-o", gallery);
  const entries = dataOf(join(gallery, "index.html")).entries;
  const files = readdirSync(join(examples, "textbook")).filter((name) => name.endsWith(".yaml"));
  assert.equal(entries.length, files.length);
  for (const entry of entries) {
    const { document } = dataOf(join(gallery, decodeURIComponent(entry.page)));
    assert.ok(document.solutions.length > 0 || document.warnings.length > 0, entry.file);
    for (const solution of document.solutions) assert.ok(solution.scene, entry.file);
  }
  const { page, wrong, close } = await open(browser, join(gallery, "index.html"));
  const shown = () => page.evaluate(() => [...document.querySelectorAll(".card")].filter((one) => !one.hidden).length);
  assert.equal(await shown(), files.length);
  await page.fill("input[type=search]", "plate impulse");
  const found = await shown();
  assert.equal(
    found,
    entries.filter(({ title, file }) => /plate/i.test(title + file) && /impulse/i.test(title + file)).length,
  );
  assert.ok(found > 0 && found < files.length);
  await page.fill("input[type=search]", "");
  await page.click("button:text-is('blow')");
  assert.equal(await shown(), entries.filter((entry) => entry.kinds.includes("blow")).length);
  assert.deepEqual(await violations(page), []);
  await page.click("button:text-is('blow')");
  await page.click(".card a");
  await page.waitForSelector("footer");
  assert.ok(await page.evaluate(() => document.querySelectorAll(".answer").length > 0));
  await page.click("header nav a");
  await page.waitForSelector(".cards");
  assert.deepEqual(wrong, []);
  await close();
});

test("solids pass the validator of their format", async () => {
  const { validateBytes } = packages("gltf-validator");
  for (const name of [
    "textbook/18.005",
    "textbook/18.029",
    "textbook/18.050",
    "published/heavy-top",
    "published/slider-crank-3d",
  ]) {
    const path = join(folder, "solids.glb");
    poinsot("report", join(examples, `${name}.yaml`), "-o", path, "--force");
    const { issues } = await validateBytes(new Uint8Array(readFileSync(path)));
    assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], `${name}: ${JSON.stringify(issues.messages)}`);
  }
});

const refused = (words, message) => {
  const run = spawnSync(program, ["report", ...words], { encoding: "utf8" });
  assert.equal(run.status, 2, run.stderr);
  assert.match(run.stderr, message);
};

test("nothing is overwritten unless it is said", () => {
  const file = join(examples, "textbook/18.003.yaml");
  const page = join(folder, "kept.html");
  writeFileSync(page, "mine");
  refused([file, "-o", page], /is not overwritten: add --force/);
  assert.equal(readFileSync(page, "utf8"), "mine");
  const full = join(folder, "full");
  mkdirSync(full);
  writeFileSync(join(full, "letter.txt"), "mine");
  refused([examples, "-o", full], /is not empty/);
  refused([file, "-o", join(folder, "page.pdf")], /should end in \.html/);
  refused([examples, "-o", page], /should be a folder/);
  refused([join(folder, "nothing"), examples, "-o", join(folder, "new")], /does not exist/);
});

test("an interrupted gallery shows the pages made until then", async () => {
  const gallery = join(folder, "interrupted");
  const run = spawn(program, ["report", join(examples, "textbook"), "-o", gallery]);
  const pages = () => {
    try {
      return readdirSync(gallery).filter((name) => name.endsWith(".html")).length;
    } catch {
      return 0;
    }
  };
  const end = new Promise((done) => run.on("exit", done));
  while (pages() < 3 && run.exitCode === null) await new Promise((done) => setTimeout(done, 20));
  run.kill("SIGINT");
  assert.equal(await end, 130);
  const made = dataOf(join(gallery, "index.html")).entries.filter((entry) => entry.page !== "");
  assert.ok(made.length >= 3 && made.length < 170);
  for (const entry of made) assert.ok(statSync(join(gallery, entry.page)).size > 1000);
});

test("a file that is wrong has a card that says so", () => {
  const mixed = join(folder, "mixed");
  mkdirSync(mixed);
  writeFileSync(join(mixed, "wrong.yaml"), "title: Wrong\nask: {a: angular(momentum}\n");
  writeFileSync(join(mixed, "right.yaml"), readFileSync(join(examples, "textbook/18.003.yaml")));
  poinsot("report", mixed, "-o", join(folder, "mixed-gallery"));
  const [right, wrong] = dataOf(join(folder, "mixed-gallery/index.html")).entries;
  assert.equal(right.page, "right.html");
  assert.equal(wrong.page, "");
  assert.match(wrong.note, /wrong\.yaml:2/);
});
