// A file as a light: coefficients as `prt project` prints them, or a lat-long picture.
import { readExr } from './exr_file.js';
import { lightOf, lightOfPicture } from './light.js';
import { readRadiance } from './radiance_file.js';
import { FileError } from './transfer_file.js';

function jsonOf(text) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new FileError(`not JSON: ${error.message}`);
  }
}

// `prt view --serve` reads every format of picture.
async function projectedByServer(file, degree) {
  const answer = await fetch(`project?degree=${degree}`, { method: 'POST', body: file }).catch(() => null);
  if (!answer) throw new FileError('the server of this page does not answer: start `prt view --serve` again');
  if (answer.status === 400) throw new FileError(await answer.text());
  if (!answer.ok) throw new FileError(`the server of this page refuses it with status ${answer.status}: expected at most 1 GiB`);
  return lightOf(await answer.json());
}

function lightOfRead(page, picture) {
  return Object.assign(lightOfPicture(page, picture), { flaw: picture.flaw });
}

async function anyLightOf(page, file, isServed) {
  if (/\.json$/i.test(file.name)) return lightOf(jsonOf(await file.text()));
  if (/\.hdr$/i.test(file.name)) return lightOfRead(page, readRadiance(new Uint8Array(await file.arrayBuffer())));
  if (!/\.(exr|png|jpe?g)$/i.test(file.name)) throw new FileError('expected a light: the JSON of `prt project`, or a lat-long picture');
  if (isServed) return projectedByServer(file, page.degree);
  if (/\.exr$/i.test(file.name)) return lightOfRead(page, await readExr(new Uint8Array(await file.arrayBuffer())));
  throw new FileError(`of pictures this page reads .hdr and .exr: drop the JSON of \`prt project ${file.name} --degree ${page.degree}\`, or open the page with \`prt view --serve\``);
}

/** File -> light, of a picture in the degree of the page, and with its flaw. Throws FileError. */
export async function lightOfFile(page, file, isServed) {
  const light = await anyLightOf(page, file, isServed);
  if (!light.values.every((value) => Number.isFinite(Math.fround(value)))) throw new FileError('the lights exceed single precision; expected weaker ones, below 1e37');
  return light;
}
