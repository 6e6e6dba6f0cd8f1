// Figures in a browser.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import test, { after, before } from "node:test";
import { folder, openBrowser, poinsot, root } from "./support.mjs";

let browser;
before(async () => {
  browser = await openBrowser();
});
after(() => browser.close());

// Of each kind: models in a plane and in space, with values and with letters, forces, a blow, cones, a motion.
const figures = [
  ["textbook/18.003", "model"],
  ["textbook/18.025", "model", "--values"],
  ["textbook/18.029", "impulse"],
  ["textbook/18.120", "cones"],
  ["textbook/18.098", "free-body"],
  ["published/heavy-top", "motion"],
  ["mechanisms/quick-return", "model"],
  ["mechanisms/ladder-between-rough-walls", "free-body", "--values"],
];

function figureOf(name, kind, ...more) {
  const path = join(folder, `${name.replaceAll("/", "-")}-${kind}.svg`);
  poinsot("figure", join(root, "examples", `${name}.yaml`), "--of", kind, ...more, "-o", path, "--force");
  return readFileSync(path, "utf8");
}

// Draws one at its size and another at three times that size, and tells how far the ink of squares of eight by eight
// dots of the first lies from that of the same places of the other, as a part of all ink. Within a square, edges and
// letters are put on dots in one way or another.
async function compare(page, one, another) {
  return page.evaluate(
    async (texts) => {
      const images = [];
      for (const text of texts) {
        const image = new Image();
        image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
        await image.decode();
        images.push(image);
      }
      const { naturalWidth: width, naturalHeight: height } = images[0];
      const dots = (image, times) => {
        const canvas = document.createElement("canvas");
        canvas.width = times * width;
        canvas.height = times * height;
        const context = canvas.getContext("2d");
        context.fillStyle = "white";
        context.fillRect(0, 0, canvas.width, canvas.height);
        context.drawImage(image, 0, 0, canvas.width, canvas.height);
        return context.getImageData(0, 0, canvas.width, canvas.height).data;
      };
      const small = dots(images[0], 1);
      const large = dots(images[1], 3);
      const square = 8;
      const across = Math.ceil(width / square);
      const inks = [small, large].map((data, which) => {
        const times = which === 0 ? 1 : 3;
        const sums = new Float64Array(across * Math.ceil(height / square));
        for (let y = 0; y < times * height; ++y) {
          const row = across * Math.floor(y / times / square);
          for (let x = 0; x < times * width; ++x) {
            const dark = 255 - data[4 * (y * times * width + x) + 1];
            sums[row + Math.floor(x / times / square)] += dark / times ** 2;
          }
        }
        return sums;
      });
      const total = inks[0].reduce((sum, ink) => sum + ink, 0);
      return inks[0].reduce((sum, ink, k) => sum + Math.abs(ink - inks[1][k]), 0) / total;
    },
    [one, another],
  );
}

test("figures are well-formed and show the same at one and three times their size", async () => {
  const page = await browser.newPage();
  for (const figure of figures) {
    const svg = figureOf(...figure);
    const fault = await page.evaluate(
      (text) => new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror")?.textContent,
      svg,
    );
    assert.equal(fault, undefined, `${figure}: ${fault}`);
    const apart = await compare(page, svg, svg);
    assert.ok(apart < 0.1, `${figure}: ${apart} of its ink lies elsewhere`);
  }
  // Lines that keep their width would be seen.
  const plain = figureOf(...figures[0]);
  const thin = plain.replaceAll(/<(path|line)/g, '<$1 vector-effect="non-scaling-stroke"');
  const apart = await compare(page, plain, thin);
  assert.ok(apart > 0.12, `${apart}`);
  await page.close();
});
