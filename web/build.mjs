// node build.mjs FOLDER: makes page.js, page.css and bundle.cpp, which carries both inside the program.
import { createHash } from "node:crypto";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2];
if (folder === undefined) {
  console.error("build.mjs: expected the folder for what is made");
  process.exit(2);
}

// Browsers of the last ten years take woff2. Formulas of the program have no script, blackletter or sans-serif letters.
const katexFonts = {
  name: "katex-fonts",
  setup({ onLoad }) {
    onLoad({ filter: /katex(\.min)?\.css$/ }, async ({ path }) => {
      const style = await readFile(path, "utf8");
      const contents = style
        .replace(/@font-face\{[^}]*KaTeX_(Caligraphic|Fraktur|SansSerif|Script)[^}]*\}/g, "")
        .replace(/,\s*url\([^)]*\.(woff|ttf)\) format\("(woff|truetype)"\)/g, "");
      if (/\.(woff|ttf)\)/.test(contents)) throw new Error("KaTeX's style names fonts in a form that is new");
      return { contents, loader: "css" };
    });
  },
};

async function licenses() {
  const texts = [];
  for (const name of ["three", "katex", "uplot"]) {
    const text = await readFile(join(here, "node_modules", name, "LICENSE"), "utf8");
    texts.push(`${name}\n\n${text.trim()}`);
  }
  return `/*\n${texts.join("\n\n").replaceAll("*/", "* /")}\n*/\n`;
}

// Any bytes as string literals of C++, a line each, of a length that every compiler takes.
function literals(text) {
  const bytes = Buffer.from(text, "utf8");
  const lines = [];
  for (let begin = 0; begin < bytes.length; begin += 16000) {
    let line = "";
    for (const byte of bytes.subarray(begin, begin + 16000)) {
      const plain = byte >= 32 && byte < 127 && byte !== 34 && byte !== 92 && byte !== 63;
      line += plain ? String.fromCharCode(byte) : `\\${byte.toString(8).padStart(3, "0")}`;
    }
    lines.push(`"${line}"`);
  }
  return lines.join("\n");
}

const made = await build({
  entryPoints: [join(here, "src/main.ts")],
  bundle: true,
  minify: true,
  write: false,
  outdir: folder,
  format: "iife",
  target: ["es2021"],
  loader: { ".woff2": "dataurl" },
  plugins: [katexFonts],
  legalComments: "none",
  logLevel: "warning",
});
const output = (ending) => made.outputFiles.find((file) => file.path.endsWith(ending)).text;
const script = (await licenses()) + output(".js");
const style = output(".css");
if (/<!--|<\/script/i.test(script) || /<\/style/i.test(style)) throw new Error("the bundle would end its element");

const hash = createHash("sha256").update(script, "utf8").digest("base64");
await mkdir(folder, { recursive: true });
await writeFile(join(folder, "page.js"), script);
await writeFile(join(folder, "page.css"), style);
await writeFile(
  join(folder, "bundle.cpp"),
  `// Made by web/build.mjs.
#include "pictures/page/bundle.h"

namespace poinsot::pictures {

const std::string_view page_script{
${literals(script)},
${Buffer.byteLength(script)}};
const std::string_view page_style{
${literals(style)},
${Buffer.byteLength(style)}};
const std::string_view page_script_hash = "sha256-${hash}";

}  // namespace poinsot::pictures
`,
);
console.error(`page.js ${script.length} bytes, page.css ${style.length} bytes`);
