// Runs the tests of the viewer in a browser, or says in one line what they lack. SHFORGE_BIN_DIR: where prt is.
import { existsSync, readFileSync } from 'node:fs';
import { after, before } from 'node:test';

const lacks = (what) => {
  console.log(`skipped: ${what}; \`./bootstrap test\` installs it`);
  process.exit(0);
};

if (!existsSync(process.env.SHFORGE_CHROMIUM ?? '/usr/bin/chromium')) lacks('no chromium');
const { devDependencies } = JSON.parse(readFileSync(new URL('package.json', import.meta.url)));
for (const name of Object.keys(devDependencies)) {
  if (!existsSync(new URL(`node_modules/${name}`, import.meta.url))) lacks(`no tests/view/node_modules/${name}`);
}

const { startBrowser, stopBrowser } = await import('./browser.mjs');
before(startBrowser);
after(stopBrowser);
for (const file of process.argv.slice(2).length > 0 ? process.argv.slice(2) : ['relight', 'stage', 'light', 'pixel', 'surface', 'medium', 'page', 'module', 'look']) {
  await import(`./${file}_test.mjs`);
}
