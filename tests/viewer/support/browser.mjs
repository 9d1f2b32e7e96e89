// Debian's Chromium, drawing without a GPU; pages note all that they say and ask for.
import { chromium } from 'playwright-core';

const args = [
  '--headless=new',
  '--no-sandbox',
  '--disable-dev-shm-usage', // containers have little of it
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
const drawing = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const withoutWebGL = ['--disable-gpu', '--disable-software-rasterizer', '--disable-3d-apis'];
const patience = 15_000; // milliseconds for what a page is waited for

const launched = [];

export async function launch({ webgl = true } = {}) {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  const browser = await chromium.launch({ executablePath, args: [...args, ...(webgl ? drawing : withoutWebGL)] });
  launched.push(browser);
  return browser;
}

/** Also those of a test that failed: they would keep this process from ending. */
export async function closeAll() {
  for (const browser of launched.splice(0)) await browser.close();
}

/** Opens a report, and waits until it shows what its address says. */
export async function open(browser, report, { hash = '', width = 1280, height = 800, colorScheme = 'light' } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme });
  const page = await context.newPage();
  page.setDefaultTimeout(patience);
  page.complaints = [];
  page.on('console', (message) => page.complaints.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => page.complaints.push(`error: ${error.stack}`));
  page.on('dialog', (dialog) => (page.complaints.push(`dialog: ${dialog.message()}`), dialog.dismiss()));
  page.on('request', (request) => {
    const url = request.url();
    if (!url.startsWith('file:') && !url.startsWith('data:')) page.complaints.push(`request: ${url}`);
  });
  await page.goto(`file://${report}${hash}`);
  await ready(page);
  return page;
}

export function ready(page) {
  return page.evaluate(() => window.campuswalk.ready());
}

/** Goes to another address of the report. */
export async function go(page, hash) {
  await page.evaluate((to) => {
    if (location.hash === to || (to === '#' && location.hash === '')) return undefined;
    const changed = new Promise((resolve) => addEventListener('hashchange', resolve, { once: true }));
    location.hash = to;
    return changed.then(() => undefined);
  }, hash);
  await ready(page);
}

export function ask(page, question, ...values) {
  return page.evaluate(([name, list]) => window.campuswalk[name](...list), [question, values]);
}
