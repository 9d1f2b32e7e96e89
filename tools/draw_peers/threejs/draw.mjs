// Draws a campus by three.js in a headless Chromium on llvmpipe: node draw.mjs FOLDER [CHROMIUM]
// FOLDER holds campus.glb and views.json of `campuswalk-bench draw`. Prints "frame LOOK VIEW MS" for each
// picture, and leaves the first view's as FOLDER/three.js-LOOK.png.
import { spawn } from 'node:child_process';
import { createReadStream, existsSync, mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const [folder, chromium = 'chromium'] = process.argv.slice(2);
const kPatience = 15 * 60 * 1000; // ms
const kTypes = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.json': 'application/json' };

// Of this folder, and /campus/… of the campus's.
function fileOf(url) {
    const path = normalize(decodeURIComponent(new URL(url, 'http://localhost').pathname));
    return path.startsWith('/campus/') ? join(folder, path.slice('/campus/'.length)) : join(here, path);
}

function sendFile(url, response) {
    const file = fileOf(url);
    try {
        const length = statSync(file).size;
        response.writeHead(200, { 'Content-Type': kTypes[extname(file)] ?? 'application/octet-stream', 'Content-Length': length });
        createReadStream(file).pipe(response);
    } catch {
        response.writeHead(404).end();
    }
}

async function body(request) {
    const pieces = [];
    for await (const piece of request) {
        pieces.push(piece);
    }
    return Buffer.concat(pieces);
}

const profile = mkdtempSync(join(tmpdir(), 'campuswalk-chromium-'));
let browser = null;
let isOver = false;

function end(code, complaint = '') {
    if (isOver) {
        return;
    }
    isOver = true;
    if (complaint !== '') {
        process.stderr.write(`three.js: ${complaint}\n`);
    }
    const leave = () => {
        try {
            rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 100 });
        } catch { // one of the browser's processes still writes there
            process.stderr.write(`three.js: ${profile} is left over\n`);
        }
        process.exit(code);
    };
    if (browser === null || browser.exitCode !== null || browser.pid === undefined) {
        leave();
    } else {
        browser.once('exit', leave);
        browser.kill();
    }
}

// What the page posts: /lines to be printed, /picture/NAME to be kept, /end, /failure with its reason.
const server = createServer(async (request, response) => {
    if (request.method === 'GET') {
        sendFile(request.url, response);
        return;
    }
    const posted = await body(request);
    response.end();
    if (request.url === '/lines') {
        process.stdout.write(posted);
    } else if (request.url.startsWith('/picture/')) {
        writeFileSync(join(folder, `three.js-${request.url.slice('/picture/'.length)}.png`), posted);
    } else if (request.url === '/end') {
        end(0);
    } else {
        end(1, posted.toString());
    }
});

// A page that can't load its modules says nothing at all.
if (!existsSync(join(here, 'node_modules', 'three'))) {
    end(1, `not installed: npm ci --ignore-scripts --prefix ${here}`);
}

server.listen(0, '127.0.0.1', () => {
    const { port } = server.address();
    const { width, height } = { width: 1400, height: 900 };
    browser = spawn(chromium, [
        '--headless', '--no-sandbox', '--disable-gpu-sandbox', '--use-angle=gl-egl', '--ignore-gpu-blocklist',
        '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
        '--disable-sync', '--disable-extensions', '--force-device-scale-factor=1', `--window-size=${width},${height}`,
        `--user-data-dir=${profile}`, `http://127.0.0.1:${port}/page.html`,
    ], { stdio: 'ignore' });
    browser.once('error', (error) => end(1, `${chromium}: ${error.message}`));
    browser.once('exit', () => end(1, 'the browser ended by itself'));
    setTimeout(() => end(1, 'no end after 15 minutes'), kPatience);
});
