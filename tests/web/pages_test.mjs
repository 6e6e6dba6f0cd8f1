// Pages in a browser.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import test, { after, before } from "node:test";
import { dataOf, folder, open, openBrowser, patience, poinsot, root, violations } from "./support.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

// A page of a file of the examples, or of a text.
function pageOf(name, ...settings) {
  const path = join(folder, `${name.replaceAll("/", "-")}.html`);
  poinsot("report", join(root, "examples", `${name}.yaml`), "-o", path, "--force", ...settings);
  return path;
}
function pageOfText(name, text) {
  const file = join(folder, `${name}.yaml`);
  writeFileSync(file, text);
  const path = join(folder, `${name}.html`);
  poinsot("report", file, "-o", path, "--force");
  return path;
}

// One of each kind: an instant in letters, one in numbers, a blow of a body of parts, steady motion, claims, a motion,
// unknowns.
const samples = ["textbook/18.003", "textbook/18.025", "textbook/18.029", "textbook/18.100", "published/heavy-top"];

for (const name of samples) {
  test(`${name} opens without a word, fits a phone and can be read aloud`, async () => {
    const path = pageOf(name);
    for (const options of [{ scheme: "light" }, { width: 360, scheme: "dark" }]) {
      const { page, wrong, close } = await open(browser, path, options);
      const wide = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      assert.ok(wide <= 0, `it is ${wide} pixels too wide at ${options.width ?? 1200}`);
      await page.evaluate(() => {
        for (const one of document.querySelectorAll("details")) one.open = true;
      });
      // What could not be typeset stands as code.
      assert.deepEqual(
        await page.evaluate(() => [...document.querySelectorAll(".math > code")].map((one) => one.textContent)),
        [],
      );
      assert.deepEqual(await violations(page), []);
      assert.deepEqual(wrong, []);
      await close();
    }
  });
}

test("the view in space shows something, and keys turn it", async () => {
  const { page, wrong, close } = await open(browser, pageOf("textbook/18.005"));
  const picture = () => page.evaluate(() => document.querySelector("canvas").toDataURL());
  const colours = () =>
    page.evaluate(() => {
      const canvas = document.querySelector("canvas");
      const copy = document.createElement("canvas");
      copy.width = canvas.width;
      copy.height = canvas.height;
      const context = copy.getContext("2d");
      context.drawImage(canvas, 0, 0);
      return new Set(new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer)).size;
    });
  assert.ok((await colours()) > 20, "the picture has few colours");
  const before = await picture();
  await page.focus("canvas");
  await page.keyboard.press("ArrowLeft");
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  assert.notEqual(await picture(), before);
  assert.deepEqual(wrong, []);
  await close();
});

// What a notebook of VS Code lets its outputs do, which a frame in it inherits: no fonts but those of others' servers.
const notebookPolicy = [
  "default-src 'none'",
  "script-src 'self' https: 'unsafe-inline' 'unsafe-eval'",
  "style-src 'self' 'unsafe-inline'",
  "img-src 'self' https: http: data:",
  "font-src 'self' https:",
  "connect-src https:",
  "child-src https: data:",
].join("; ");

test("in the frame of a notebook that forbids fonts it shows its view, and formulas as MathML", async () => {
  const inner = readFileSync(pageOf("textbook/18.005"), "utf8").replaceAll("&", "&amp;").replaceAll('"', "&quot;");
  const path = join(folder, "notebook.html");
  // The frame is that of poinsot.Page in Python.
  writeFileSync(
    path,
    `<!doctype html><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${notebookPolicy}">
<iframe srcdoc="${inner}" sandbox="allow-scripts allow-downloads" style="width:100%;height:720px;border:0"></iframe>
<footer></footer>`,
  );
  const { page, wrong, close } = await open(browser, path);
  const frame = page.frames()[1];
  await frame.waitForFunction(() => document.querySelector("footer") !== null);
  await frame.waitForFunction(() => document.documentElement.classList.contains("without-fonts"));
  const shown = await frame.evaluate(() => {
    const width = (one) => one.getBoundingClientRect().width;
    const formulas = [...document.querySelectorAll(".katex")].filter((one) => width(one) > 0);
    return {
      formulas: formulas.length,
      typeset: formulas.filter((one) => width(one.querySelector(".katex-html")) > 0).length,
      tiny: formulas.filter((one) => width(one.querySelector("math")) < 2).length,
      canvas: width(document.querySelector("canvas")),
    };
  });
  assert.ok(shown.formulas > 3 && shown.canvas > 100, JSON.stringify(shown));
  assert.deepEqual([shown.typeset, shown.tiny], [0, 0]);
  // The browser says which fonts it refused, and nothing else went wrong.
  assert.ok(wrong.length > 0);
  assert.deepEqual(
    wrong.filter((one) => !one.includes("font-src") && one !== "request: about:srcdoc"),
    [],
  );
  await close();
});

const swing = `title: Compound pendulum
given: {m: 2 kg, L: 0.8 m}
points: {O: [0, 0, 0], A: [L, 0, 0]}
bodies: {bar: {rod: [O, A], mass: m}}
joints: {pin: {revolute: y, at: O, to: bar}}
gravity: -z
instants: {start: rest}
ask: {w: angular_velocity(bar) @ 0.7 s}
`;

// Sets the slider as a reader does.
const slide = (page, time) =>
  page.evaluate((value) => {
    const slider = document.querySelector("input[type=range]");
    slider.value = String(value);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    return Number(slider.value);
  }, time);

// A page of which the document has a motion, made up here: what a page shows does not depend on where it comes from.
function pageWithMotion(name, frames = 41) {
  const path = pageOfText(name, swing);
  const data = dataOf(path);
  const { scene } = data.document.solutions[0];
  const times = Array.from({ length: frames }, (_, i) => 1 + (2 * i) / (frames - 1));
  const bodies = scene.bodies.map((_, k) => ({
    position: times.flatMap((t) => [0.1 * t, 0.05 * k * t, Math.sin(t)]),
    orientation: times.flatMap((t) => [Math.cos(2 * t), 0.6 * Math.sin(2 * t), 0, 0.8 * Math.sin(2 * t)]),
  }));
  const plots = [
    {
      name: "w",
      words: "angular velocity",
      unit: "rad/s",
      labels: ["x", "y", "z"],
      values: [1, 2, 3].map((k) => times.map((t) => Math.cos(k * t))),
    },
    {
      name: "T",
      words: "kinetic energy",
      unit: "J",
      labels: ["T"],
      values: [times.map((t) => t * t)],
    },
  ];
  scene.motion = {
    times,
    bodies,
    plots,
    arrows: [
      {
        quantity: "velocity",
        name: scene.bodies[0].name,
        at: { body: 0, at: [0, 0, 0] },
        symbol: "\\mathbf{v}",
        text: "v",
        unit: "m/s",
        factor: 1,
        vectors: times.flatMap((t) => [0.1, 0.05, Math.cos(t)]),
      },
    ],
    events: [{ time: 1.5, words: "it touches" }],
    complete: true,
  };
  const html = readFileSync(path, "utf8");
  const json = JSON.stringify(data).replaceAll("<", "\\u003c");
  writeFileSync(
    path,
    html.replace(/(id="poinsot-page">).*?(<\/script>)/s, (_, before, behind) => before + json + behind),
  );
  return path;
}

test("the slider moves bodies to the poses of the document, and plots show its numbers", async () => {
  const path = pageWithMotion("swing");
  const scene = dataOf(path).document.solutions[0].scene;
  const { times, bodies, plots } = scene.motion;
  const { page, wrong, close } = await open(browser, path);
  let compared = 0;
  for (const index of [0, 1, Math.floor(times.length / 3), times.length - 1]) {
    await slide(page, times[index]);
    const shown = await page.evaluate(() => window.poinsotStages[0].poses());
    bodies.forEach((body, k) => {
      const [w, x, y, z] = body.orientation.slice(4 * index, 4 * index + 4);
      const cosine = shown[k].turn.reduce((sum, part, i) => sum + part * [x, y, z, w][i], 0);
      assert.ok(Math.abs(Math.abs(cosine) - 1) < 1e-6, `the turn of ${shown[k].name} at ${times[index]} s`);
      body.position.slice(3 * index, 3 * index + 3).forEach((part, i) => {
        assert.ok(Math.abs(shown[k].position[i] - part) < 1e-6, `the place of ${shown[k].name}`);
      });
      compared += 1;
    });
    const legends = await page.evaluate(() =>
      [...document.querySelectorAll(".plot output")].map((one) => Number(one.textContent)),
    );
    const values = plots.flatMap((plot) => plot.values.map((line) => line[index]));
    assert.equal(legends.length, values.length);
    values.forEach((value, i) => {
      assert.ok(
        Math.abs(legends[i] - value) <= 1e-5 * Math.abs(value) + 1e-12,
        `plot ${i}: ${legends[i]} for ${value}`,
      );
    });
  }
  assert.ok(compared >= 4);
  assert.deepEqual(wrong, []);
  await close();
});

test("the keyboard alone reaches everything that can be used", async () => {
  const { page, close } = await open(browser, pageWithMotion("keys"));
  const wanted = await page.evaluate(() => {
    const all = [...document.querySelectorAll("*")];
    return [...document.querySelectorAll("a[href], button, input, select, summary, canvas, [tabindex='0']")]
      .filter((one) => one.checkVisibility() && !one.disabled && one.tabIndex >= 0)
      .map((one) => all.indexOf(one));
  });
  const reached = new Set();
  for (let i = 0; i < wanted.length + 5; ++i) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => [...document.querySelectorAll("*")].indexOf(document.activeElement)));
  }
  assert.ok(wanted.length > 10);
  assert.deepEqual(
    wanted.filter((one) => !reached.has(one)),
    [],
  );
  await page.focus("input[type=range]");
  const before = await page.evaluate(() => document.querySelector("input[type=range]").value);
  await page.keyboard.press("ArrowRight");
  assert.notEqual(await page.evaluate(() => document.querySelector("input[type=range]").value), before);
  await close();
});

test("hostile text stays text", async () => {
  const hostile = "</script><script>window.hacked = 1</script><img src=x onerror=window.hacked=2>";
  const path = pageOfText(
    "hostile",
    `# ${hostile}\n${swing.replace("Compound pendulum", `"${hostile} $\\\\href{javascript:alert(1)}{x}$"`)}`,
  );
  const { page, wrong, close } = await open(browser, path);
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  assert.equal(await page.evaluate(() => document.images.length), 0);
  assert.ok((await page.textContent("h1")).includes(hostile));
  assert.ok((await page.evaluate(() => document.querySelector("pre.file").textContent)).includes(hostile));
  assert.deepEqual(wrong, []);
  await close();
});

test("a frame with fifty bodies takes less than 8 ms of the script's time", async () => {
  const count = 50;
  const bodies = Array.from(
    { length: count },
    (_, i) => `  b${i}: {sphere: {center: [${i % 10}, ${Math.floor(i / 10)}, 0], radius: 0.2}, mass: 1 kg}`,
  );
  const text = `title: Fifty balls\nbodies:\n${bodies.join("\n")}\ngravity: -z\ninstants: {start: rest}\nask: {p: center(b0) @ 1 s}\n`;
  const path = pageOfText(
    "fifty",
    text
      .replaceAll(", 0.2}", ", 0.2 m}")
      .replace(/center: \[(\d+), (\d+), 0\], radius: 0.2/g, "center: [$1 m, $2 m, 0], radius: 0.2 m"),
  );
  const { page, wrong, close } = await open(browser, path);
  assert.equal(await page.evaluate(() => window.poinsotStages[0].poses().length), count);
  const took = await page.evaluate(async () => {
    const stage = window.poinsotStages[0];
    const times = [];
    for (let i = 0; i < 40; ++i) {
      stage.setTime(i / 40);
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      times.push(stage.scriptTime);
    }
    return times.sort((a, b) => a - b)[20];
  });
  assert.ok(took > 0 && took < 8, `${took} ms`);
  assert.deepEqual(wrong, []);
  await close();
});

test("arrows go with the motion, and can be switched off", async () => {
  const path = pageWithMotion("arrows");
  const { times, arrows } = dataOf(path).document.solutions[0].scene.motion;
  const { page, wrong, close } = await open(browser, path);
  const shown = () => page.evaluate(() => window.poinsotStages[0].movingArrows()[0]);
  assert.equal((await shown()).visible, false);
  for (const index of [3, 20]) {
    await slide(page, times[index]);
    const vector = arrows[0].vectors.slice(3 * index, 3 * index + 3);
    const length = Math.hypot(...vector);
    const arrow = await shown();
    assert.ok(arrow.visible);
    arrow.direction.forEach((part, i) => {
      assert.ok(Math.abs(part - vector[i] / length) < 1e-6);
    });
  }
  await page.getByLabel("velocities", { exact: true }).uncheck();
  assert.equal((await shown()).visible, false);
  // An event is a button that goes there.
  await page.getByRole("button", { name: "1.5 s: it touches" }).click();
  assert.equal(await page.evaluate(() => Number(document.querySelector("input[type=range]").value)), 1.5);
  assert.deepEqual(wrong, []);
  await close();
});

test("a belt lies on its wheels between its sides, also while they turn", async () => {
  const text = `title: A belt
points: {A: [0, 0, 0], B: [0.6 m, 0, 0]}
bodies: {big: {disk: {center: A, normal: z, radius: 0.2 m}, mass: 3 kg}, small: {disk: {center: B, normal: z, radius: 0.1 m}, mass: 1 kg}}
joints: {a: {revolute: z, at: A, to: big, couple: 1 N*m}, b: {revolute: z, at: B, to: small}}
belts: {belt: {over: [big, small], tension: 100 N}}
gravity: none
instants: {now: rest}
ask: {T: tension(belt from big to small), w: angular_velocity(big).z @ 2 s}
`;
  const { page, wrong, close } = await open(browser, pageOfText("belt", text));
  const lean = 2 * Math.asin(0.1 / 0.6);
  const angles = { 0.2: Math.PI + lean, 0.1: Math.PI - lean };
  for (const time of [null, 0.7, 2]) {
    const wraps = await page.evaluate((at) => {
      window.poinsotStages[0].setTime(at);
      return window.poinsotStages[0].wrapped();
    }, time);
    assert.equal(wraps.length, 2);
    for (const { radius, angle } of wraps) {
      const own = radius > 0.15 ? 0.2 : 0.1;
      assert.ok(Math.abs(radius - own) < 1e-3, `${radius} m`);
      assert.ok(Math.abs(angle - angles[own]) < 2e-3, `${angle} at ${radius} m`);
    }
  }
  assert.deepEqual(wrong, []);
  await close();
});

test("a page with ten thousand frames takes less than a second to be there", async () => {
  const path = pageWithMotion("frames", 10_000);
  const context = await browser.newContext();
  context.setDefaultTimeout(patience);
  const page = await context.newPage();
  // The time in which the page's thread works: what else the machine does is not counted.
  const session = await context.newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  await page.goto(`file://${path}`);
  await page.waitForFunction(() => window.poinsotStages?.[0]?.movingArrows().length === 1);
  const { metrics } = await session.send("Performance.getMetrics");
  const { value } = metrics.find((one) => one.name === "TaskDuration");
  assert.ok(value > 0.01 && value < 1, `${value} s`);
  await context.close();
});

test("several solutions stand behind tabs that the keyboard moves between", async () => {
  const path = pageOf("textbook/18.110");
  const { page, wrong, close } = await open(browser, path);
  const tabs = page.getByRole("tab");
  assert.equal(await tabs.count(), 2);
  const panels = () =>
    page.evaluate(() => [...document.querySelectorAll("[role=tabpanel]")].map((one) => one.checkVisibility()));
  assert.deepEqual(await panels(), [true, false]);
  await tabs.first().focus();
  await page.keyboard.press("ArrowRight");
  assert.deepEqual(await panels(), [false, true]);
  assert.equal(await tabs.nth(1).getAttribute("aria-selected"), "true");
  await page.keyboard.press("Home");
  assert.deepEqual(await panels(), [true, false]);
  assert.deepEqual(await violations(page), []);
  assert.deepEqual(wrong, []);
  await close();
});

test("each situation has its figure and its view", async () => {
  const { page, wrong, close } = await open(browser, pageOf("textbook/18.013"));
  const situations = page.locator("details.situation");
  assert.equal(await situations.count(), 3);
  assert.equal(await page.locator("canvas").count(), 1);
  for (const i of [1, 2]) await situations.nth(i).locator("summary").click();
  await page.waitForFunction(() => document.querySelectorAll("canvas").length === 3);
  assert.equal(await page.locator("details.situation figure svg").count(), 3);
  assert.deepEqual(await violations(page), []);
  assert.deepEqual(wrong, []);
  await close();
});

test("drawings are dark in the dark, and tell their values where the mouse rests", async () => {
  const path = pageOf("textbook/18.066");
  const lightness = async (scheme) => {
    const { page, wrong, close } = await open(browser, path, { scheme });
    const figure = page.locator("figure svg").first();
    const shot = (await figure.screenshot({ type: "png" })).toString("base64");
    const mean = await page.evaluate(async (png) => {
      const image = new Image();
      image.src = `data:image/png;base64,${png}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      canvas.width = image.width;
      canvas.height = image.height;
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      return data.reduce((sum, part, i) => sum + (i % 4 === 3 ? 0 : part), 0) / (0.75 * data.length);
    }, shot);
    const hints = await page.evaluate(() =>
      [...document.querySelectorAll("figure svg text > title")].map((one) => one.textContent),
    );
    assert.deepEqual(wrong, []);
    await close();
    return { mean, hints };
  };
  const light = await lightness("light");
  const dark = await lightness("dark");
  assert.ok(light.mean > 200, `${light.mean} in the light`);
  assert.ok(dark.mean < 60, `${dark.mean} in the dark`);
  assert.ok(
    light.hints.some((hint) => /^C_x = /.test(hint)),
    light.hints.join("; "),
  );
});
