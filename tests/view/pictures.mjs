// Pictures as numbers: decoded by the browser, compared by the root mean square of sRGB values from 0 to 1.
import fs from 'node:fs';
import { set } from './browser.mjs';

/** The bytes of a PNG file as {width, height, rgb: values from 0 to 1}. */
export async function decoded(page, png) {
  const { width, height, rgba } = await page.evaluate(async (base64) => {
    const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob(), { colorSpaceConversion: 'none' });
    const canvas = new OffscreenCanvas(picture.width, picture.height);
    const context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, picture.width, picture.height);
    return { width: picture.width, height: picture.height, rgba: base64Of(data) };
  }, Buffer.from(png).toString('base64'));
  return { width, height, rgb: Float64Array.from(Buffer.from(rgba, 'base64').filter((_, i) => i % 4 < 3), (value) => value / 255) };
}

export function rootMeanSquare(a, b) {
  if (a.width !== b.width || a.height !== b.height) throw new Error(`${a.width} x ${a.height} beside ${b.width} x ${b.height}`);
  return Math.sqrt(a.rgb.reduce((sum, value, i) => sum + (value - b.rgb[i]) ** 2, 0) / a.rgb.length);
}

/** The picture of the canvas alone. */
export async function canvasPicture(page) {
  await set(page, { balls: false });
  await page.addStyleTag({ content: '#status, #balls, #message, #marker { display: none !important; }' });
  return decoded(page, await page.locator('#view').screenshot());
}

export const pictureOf = async (page, file) => decoded(page, fs.readFileSync(file));
