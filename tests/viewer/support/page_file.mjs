// A report as a file: its chunks, and copies of it that are changed or damaged.
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync, gzipSync } from 'node:zlib';

const chunk = (name) => new RegExp(`(<script[^>]*data-chunk="${name}"[^>]*>)([^<]*)(</script>)`);

export function readChunk(report, name) {
  return gunzipSync(Buffer.from(chunk(name).exec(readFileSync(report, 'utf8'))[2], 'base64'));
}

export function readIndex(report) {
  return JSON.parse(readChunk(report, 'index'));
}

export function detailsOf(report, row) {
  return JSON.parse(readChunk(report, row.chunk).toString().split('\n')[row.line]);
}

/** Writes a copy whose index is what `change` makes of it. */
export function withIndex(report, copy, change) {
  const index = readIndex(report);
  const packed = gzipSync(JSON.stringify(change(index) ?? index)).toString('base64');
  return rewritten(report, copy, (page) => page.replace(chunk('index'), (_, head, __, tail) => head + packed + tail));
}

export function rewritten(report, copy, change) {
  writeFileSync(copy, change(readFileSync(report, 'utf8')));
  return copy;
}

/** Puts another viewer into it, from a folder with viewer.js and viewer.css: to try one without building the program. */
export function withViewer(report, folder) {
  const [script, style] = ['viewer.js', 'viewer.css'].map((file) => readFileSync(join(folder, file), 'utf8'));
  const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
  return rewritten(report, report, (page) => {
    const from = page.lastIndexOf('<script>') + '<script>'.length;
    return (page.slice(0, from) + script + page.slice(page.lastIndexOf('</script>')))
      .replace(/<style>[^]*?<\/style>/, () => `<style>${style}</style>`)
      .replace(/script-src '[^']*'/, () => `script-src ${hash(script)}`)
      .replace(/style-src '[^']*'/, () => `style-src ${hash(style)}`);
  });
}
