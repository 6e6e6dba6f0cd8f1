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
  // One in ten of its pages, on a phone: all of them take minutes.
  let opened = 0;
  for (const entry of entries.filter((_, i) => i % 10 === 3)) {
    const one = await open(browser, join(gallery, decodeURIComponent(entry.page)), { width: 360 });
    const told = await one.page.evaluate(() => {
      for (const details of document.querySelectorAll("details")) details.open = true;
      const { scrollWidth, clientWidth } = document.documentElement;
      return {
        tooWide: Math.max(0, scrollWidth - clientWidth),
        // What could not be typeset stands as code.
        code: [...document.querySelectorAll(".math > code")].map((math) => math.textContent),
      };
    });
    assert.deepEqual({ ...told, wrong: one.wrong }, { tooWide: 0, code: [], wrong: [] }, entry.file);
    await one.close();
    opened += 1;
  }
  assert.ok(opened >= 15);
});

test("solids pass the validator of their format", async () => {
  const { validateBytes } = packages("gltf-validator");
  for (const name of [
    "textbook/18.005",
    "textbook/18.029",
    "textbook/18.050",
    "published/heavy-top",
    "published/slider-crank-3d",
    // Cords over wheels, belts, springs, dampers, couples, motions of all of these.
    "textbook/18.023",
    "textbook/18.C3",
    "mechanisms/belt-with-an-idler",
    "mechanisms/geared-hoist",
    "mechanisms/swinging-atwood",
    "mechanisms/vibration-absorber",
    "mechanisms/rope-that-slips-on-a-heavy-wheel",
  ]) {
    const path = join(folder, "solids.glb");
    poinsot("report", join(examples, `${name}.yaml`), "-o", path, "--force");
    const { issues } = await validateBytes(new Uint8Array(readFileSync(path)));
    assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], `${name}: ${JSON.stringify(issues.messages)}`);
  }
});

// three.js reads the form by itself.
async function loader() {
  const { build } = packages("esbuild");
  const made = await build({
    stdin: {
      contents:
        'export { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js"; export { AnimationMixer, Vector3, Quaternion } from "three";',
      resolveDir: join(root, "web"),
    },
    bundle: true,
    write: false,
    format: "esm",
    platform: "neutral",
    mainFields: ["module", "main"],
    logLevel: "error",
  });
  return import(`data:text/javascript;base64,${Buffer.from(made.outputFiles[0].contents).toString("base64")}`);
}

test("another program finds the bodies where the motion has them", async () => {
  const { GLTFLoader, AnimationMixer, Vector3, Quaternion } = await loader();
  const file = join(examples, "textbook/18.C6.yaml");
  const path = join(folder, "moving.glb");
  poinsot("report", file, "-o", path, "--force");
  const { scene } = JSON.parse(poinsot("solve", "--json", "--scene", file)).solutions[0];
  const bytes = readFileSync(path);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const read = await new GLTFLoader().parseAsync(buffer, "");
  assert.equal(read.animations.length, 1);
  const mixer = new AnimationMixer(read.scene);
  mixer.clipAction(read.animations[0]).play();
  const { times, bodies } = scene.motion;
  let compared = 0;
  for (const index of [0, 7, Math.floor(times.length / 2), times.length - 2]) {
    mixer.setTime(times[index] - times[0]);
    read.scene.updateMatrixWorld(true);
    const root = read.scene.getObjectByName(scene.bodies[0].name).parent;
    scene.bodies.forEach((body, k) => {
      const node = read.scene.getObjectByName(body.name);
      assert.ok(node, body.name);
      assert.equal(node.parent, root);
      const place = new Vector3(...bodies[k].position.slice(3 * index, 3 * index + 3));
      const [w, x, y, z] = bodies[k].orientation.slice(4 * index, 4 * index + 4);
      assert.ok(node.position.distanceTo(place) < 1e-5 * Math.max(scene.length, 1e-9), `${body.name} ${index}`);
      assert.ok(node.quaternion.angleTo(new Quaternion(x, y, z, w)) < 1e-3, `${body.name} ${index}`);
      compared += 1;
    });
  }
  assert.ok(compared >= 4);
});

test("another program finds cords between the places that they hold, all the while", async () => {
  const { GLTFLoader, AnimationMixer, Vector3 } = await loader();
  const file = join(examples, "mechanisms/swinging-atwood.yaml");
  const path = join(folder, "cords.glb");
  poinsot("report", file, "-o", path, "--force");
  const { scene } = JSON.parse(poinsot("solve", "--json", "--scene", file)).solutions[0];
  const bytes = readFileSync(path);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const read = await new GLTFLoader().parseAsync(buffer, "");
  const mixer = new AnimationMixer(read.scene);
  mixer.clipAction(read.animations[0]).play();
  const { times, links: led } = scene.motion;
  const root = read.scene.getObjectByName(scene.bodies[0].name).parent;
  // Bodies stand first, then what runs between them.
  const nodes = scene.links.map((link, i) => root.children[scene.bodies.length + i]);
  let compared = 0;
  for (const index of [0, 5, Math.floor(times.length / 2), times.length - 2]) {
    mixer.setTime(times[index] - times[0]);
    read.scene.updateMatrixWorld(true);
    const inScene = (node, point) => root.worldToLocal(node.localToWorld(point));
    const whereIs = ({ body, at }) => {
      const place = new Vector3(...at);
      return body < 0 ? place : inScene(root.children[body], place);
    };
    scene.links.forEach((link, i) => {
      const own = led?.find((one) => one.link === i);
      const from = own ? new Vector3().fromArray(own.from, 3 * index) : whereIs(link.from);
      const to = own ? new Vector3().fromArray(own.to, 3 * index) : whereIs(link.to);
      const near = 1e-4 * scene.length;
      assert.ok(inScene(nodes[i], new Vector3(0, 0, 0)).distanceTo(from) < near, `${link.name} ${index}`);
      assert.ok(inScene(nodes[i], new Vector3(0, 0, 1)).distanceTo(to) < near, `${link.name} ${index}`);
      compared += 1;
    });
  }
  assert.ok(compared >= 8);
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
