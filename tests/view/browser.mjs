// What the tests share: the tool `prt`, a browser, and pages in it whose errors fail the test.
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import zlib from 'node:zlib';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

export const kBin = path.resolve(process.env.SHFORGE_BIN_DIR ?? 'build/bin');
const kPrt = path.join(kBin, 'prt');
export const kChromium = process.env.SHFORGE_CHROMIUM ?? '/usr/bin/chromium';
export const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'shforge-view-'));
process.on('exit', () => fs.rmSync(folder, { recursive: true, force: true }));

export const inFolder = (name) => path.join(folder, name);

/** Runs prt in the folder of the tests; what it prints. */
export function prt(...words) {
  return execFileSync(kPrt, words.map(String), { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

/** The line with which prt refuses, without its own name; its exit code has to be 2. */
export function refusal(...words) {
  const run = spawnSync(kPrt, words.map(String), { cwd: folder, encoding: 'utf8' });
  if (run.status !== 2) throw new Error(`prt ${words.join(' ')}: exit code ${run.status}, ${run.stderr}`);
  return run.stderr.trim().replace(/^prt: /, '');
}

/** prt that runs on: line(pattern) waits for what it prints, end() interrupts it and tells its exit code. */
export function spawnPrt(...words) {
  const child = spawn(kPrt, words.map(String), { cwd: folder });
  let text = '';
  child.stderr.on('data', (data) => { text += data; });
  const ended = new Promise((done) => { child.on('exit', done); });
  return {
    async line(pattern) {
      for (let left = 6000; left > 0; --left) {
        if (pattern.test(text)) return pattern.exec(text)[0];
        if (child.exitCode !== null) break;
        await new Promise((done) => { setTimeout(done, 100); });
      }
      throw new Error(`prt ${words.join(' ')}: ${text}`);
    },
    end() {
      child.kill('SIGINT');
      return ended;
    },
  };
}

/** The status of an answer to a request that calls the server by this name, with more headers. */
export function statusOf(address, host, headers = {}) {
  return new Promise((done, fail) => {
    http.get(address, { headers: { host, ...headers } }, (answer) => { answer.resume(); done(answer.statusCode); }).on('error', fail);
  });
}

export function writeJson(name, json) {
  fs.writeFileSync(inFolder(name), JSON.stringify(json));
  return name;
}

/** A box on a ground, few vertices; `changes` go into its first mesh and its bake. */
export function scene(name, { mesh = {}, bake = {}, lights, camera } = {}) {
  return writeJson(name, {
    name: name.replace('.json', ''),
    meshes: [
      { primitive: 'box', albedo: [0.8, 0.5, 0.25], max_edge: 0.5, transform: { rotate: { degrees: 25 }, translate: [0, 0, 0.5] }, ...mesh },
      { primitive: 'torus', segments: 12, albedo: [0.2, 0.4, 0.7], transform: { scale: 0.9, translate: [1.1, -0.3, 0.3] }, ...mesh },
    ],
    ground: { height: 0, size: 4, albedo: [0.6, 0.6, 0.55], max_edge: 0.5 },
    ...(lights ? { lights } : {}),
    ...(camera ? { camera } : {}),
    bake: { degree: 4, directions: 512, ...bake },
  });
}

/** Radiance of the vertices in a PLY file of `prt relight`: (vertices, 3). */
export function radianceOfPly(name) {
  const bytes = fs.readFileSync(inFolder(name));
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const header = bytes.subarray(0, end).toString('latin1');
  const vertices = Number(/element vertex (\d+)/.exec(header)[1]);
  const properties = [...header.split('element face')[0].matchAll(/property (float|double) (\w+)/g)];
  const sizes = properties.map(([, type]) => (type === 'float' ? 4 : 8));
  const stride = sizes.reduce((sum, size) => sum + size, 0);
  const offsets = ['red', 'green', 'blue'].map((color) => {
    const at = properties.findIndex(([, , property]) => property === color);
    return sizes.slice(0, at).reduce((sum, size) => sum + size, 0);
  });
  return Float32Array.from({ length: 3 * vertices }, (_, i) => bytes.readFloatLE(end + Math.floor(i / 3) * stride + offsets[i % 3]));
}

export function largestDifference(a, b) {
  if (a.length !== b.length) throw new Error(`${a.length} numbers beside ${b.length}`);
  return a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0);
}

/** The largest difference over the larger of 1 and the largest number of b. */
export function relativeDifference(a, b) {
  return largestDifference(a, b) / b.reduce((most, value) => Math.max(most, Math.abs(value)), 1);
}

let browser;

export async function startBrowser() {
  browser = await chromium.launch({
    executablePath: kChromium,
    args: ['--no-sandbox', '--headless', '--disable-background-networking', '--disable-component-update', '--disable-extensions', '--disable-sync', '--no-first-run'],
  });
}

export const stopBrowser = () => browser?.close();

/**
 * Opens a page of the folder, calls use(page), closes it. Fails on errors of its console, on exceptions, and on any request
 * that leaves the page.
 */
export async function withPage(name, use, options) {
  return withUrl(pathToFileURL(inFolder(name)).href, use, { isOwn: (url) => /^(file|data|blob):/.test(url), ...options });
}

/** The same, as if a server had the folder, and `files` {name: path} besides. Nothing listens: the browser asks the test. */
export async function withServedPage(name, files, use, options) {
  const host = 'http://folder.test/';
  const serve = (route) => {
    const file = new URL(route.request().url()).pathname.slice(1);
    const found = files[file] ?? inFolder(file);
    return route.fulfill({ path: found instanceof URL ? fileURLToPath(found) : found });
  };
  return withUrl(host + name, use, { isOwn: (url) => url.startsWith(host) || /^(data|blob):/.test(url), serve, ...options });
}

/** The same of a page that a server has. */
export async function withAddress(address, use, options) {
  return withUrl(address, use, { isOwn: (url) => url.startsWith(address) || /^(data|blob):/.test(url), ...options });
}

// In pages: the bytes of a typed array as text. Arrays of numbers take seconds on their way out of a page.
function base64Of(numbers) {
  const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
  let text = '';
  for (let at = 0; at < bytes.length; at += 4096) text += String.fromCharCode(...bytes.subarray(at, at + 4096));
  return btoa(text);
}

async function withUrl(url, use, { isOwn, serve, hash = '', width = 800, height = 480, ...more } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, ...more });
  const page = await context.newPage();
  page.setDefaultTimeout(600_000);  // a slow machine draws slowly; ctest ends a test that hangs
  await page.addInitScript(`globalThis.base64Of = ${base64Of}`);
  const errors = [];
  page.on('console', (message) => { if (message.type() === 'error') errors.push(message.text()); });
  page.on('pageerror', (error) => errors.push(String(error.stack ?? error)));
  page.on('request', (request) => { if (!isOwn(request.url())) errors.push(`asks for ${request.url()}`); });
  if (serve) await page.route('**/*', serve);
  try {
    await page.goto(url + hash);
    await page.waitForFunction(() => document.documentElement.dataset.ready === 'true').catch((error) => errors.push(error.message));
    const result = errors.length > 0 ? undefined : await use(page);
    if (errors.length > 0) throw new Error(`the page reports: ${errors.join('; ')}`);
    return result;
  } finally {
    await context.close();
  }
}

/** Changes the state of the page and waits for its picture. */
export async function set(page, changes) {
  await page.evaluate((entries) => new Promise((done) => {
    viewer.set(entries);
    requestAnimationFrame(() => requestAnimationFrame(done));
  }), changes);
}

/** Radiance of the vertices of a file or a stage, from the GPU. */
export async function radianceOf(page, subject = 0) {
  const base64 = await page.evaluate((index) => {
    viewer.relight(viewer.subjects[index]);
    return base64Of(viewer.subjects[index].read());
  }, subject);
  return new Float32Array(new Uint8Array(Buffer.from(base64, 'base64')).buffer);
}

/** Writes the page with these bytes in place of its first file. */
export function pageWith(from, to, bytes) {
  const html = fs.readFileSync(inFolder(from), 'utf8');
  const [, text] = /<script type="application\/json" id="data">([^]*?)<\/script>/.exec(html);
  const data = JSON.parse(text);
  data.files[0].data = zlib.gzipSync(bytes).toString('base64');
  fs.writeFileSync(inFolder(to), html.replace(text, () => JSON.stringify(data).replaceAll('</', '<\\/')));
}

/** Drops a file on the page. */
export async function drop(page, name, content) {
  await page.evaluate(([file, base64]) => {
    const data = new DataTransfer();
    data.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], file));
    document.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
  }, [name, Buffer.from(content).toString('base64')]);
}

/**
 * Clicks into faces of a convex object, near each of their corners, and returns [{clicked, told}]: the numbers of the corner
 * and of the vertex that the page tells.
 */
export async function clicksAtCorners(page, place = 0) {
  const points = await page.evaluate((at) => {
    const { first: subject, state, canvas, aspect } = viewer;
    const { position, face } = subject.objects[at].transfer.sections;
    const before = subject.objects.slice(0, at).reduce((sum, { transfer }) => sum + transfer.vertices, 0);
    const m = subject.clipOf(at, state, aspect);
    const onCanvas = (p) => {
      const [x, y, , w] = [0, 1, 2, 3].map((row) => [...p, 1].reduce((sum, value, k) => sum + m[row + 4 * k] * value, 0));
      return [((x / w + 1) / 2) * canvas.clientWidth, ((1 - y / w) / 2) * canvas.clientHeight];
    };
    const areaOf = ([a, b, c]) => (b[0] - a[0]) * (a[1] - c[1]) - (b[1] - a[1]) * (a[0] - c[0]);  // of what turns its front to the eye
    const faces = Array.from({ length: face.length / 3 }, (_, f) => {
      const corners = [...face.subarray(3 * f, 3 * f + 3)];
      const points3 = corners.map((v) => [...position.subarray(3 * v, 3 * v + 3)]);
      return { corners, points: points3, area: areaOf(points3.map(onCanvas)) };
    }).sort((a, b) => b.area - a.area).slice(0, 8);
    return faces.flatMap(({ corners, points: p }) => corners.map((v, k) => (
      { clicked: before + v, at: onCanvas(p[k].map((x, i) => 0.7 * x + 0.15 * (p[(k + 1) % 3][i] + p[(k + 2) % 3][i]))) })));
  }, place);
  const clicks = [];
  for (const { clicked, at } of points) {
    await page.mouse.click(...at);
    clicks.push({ clicked, told: await page.evaluate(() => viewer.state.vertex) });
  }
  return clicks;
}

export const message = (page) => page.textContent('#message');
