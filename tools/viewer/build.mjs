// Bundles the viewer: node build.mjs [--outdir DIR] writes viewer.js and viewer.css there.
import { build } from 'esbuild';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

const here = dirname(fileURLToPath(import.meta.url));
const { values } = parseArgs({ options: { outdir: { type: 'string', default: join(here, 'dist') } } });
const outdir = resolve(values.outdir);
const largest = 900_000; // bytes: it is in every report

mkdirSync(outdir, { recursive: true });
await build({
  absWorkingDir: here,
  entryPoints: { viewer: 'src/main.ts' },
  outdir,
  bundle: true,
  minify: true,
  charset: 'utf8',
  legalComments: 'inline',
  format: 'iife',
  target: ['chrome110', 'firefox115', 'safari16.4'],
  logLevel: 'warning',
});

const script = join(outdir, 'viewer.js');
// Inside a page's <script>, these would end it or begin a comment.
const text = readFileSync(script, 'utf8')
  .replaceAll('<!--', '<\\!--')
  .replaceAll(/<\/script/gi, '<\\/script');
writeFileSync(script, text);
const bytes = Buffer.byteLength(text) + readFileSync(join(outdir, 'viewer.css')).length;
if (bytes > largest) {
  console.error(`build.mjs: the viewer has ${bytes} bytes, more than ${largest}`);
  process.exit(1);
}
console.log(`viewer.js and viewer.css: ${bytes} bytes`);
