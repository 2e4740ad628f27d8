// Lat-long pictures of light: what every format has to give.
import { FileError } from './transfer_file.js';

const kMostPixels = 2 ** 27;

export function requirePictureSize(width, height) {
  if (width > 0 && height > 0 && width * height <= kMostPixels) return;
  throw new FileError(`the picture is ${width} x ${height} pixels; expected 1 to ${kMostPixels} pixels`);
}

/** {width, height, pixels, flaw}: linear RGB, row by row from the top, finite. Negative numbers become 0, as prt has it; the
 * flaw, a text, tells of them. */
export function pictureOf(width, height, pixels) {
  let negative = 0;
  for (let pixel = 0; pixel < width * height; ++pixel) {
    const values = pixels.subarray(3 * pixel, 3 * pixel + 3);
    if (!values.every(Number.isFinite)) {
      const words = values.join(', ').replaceAll('NaN', 'nan').replaceAll('Infinity', 'inf');
      throw new FileError(`the pixel in column ${pixel % width}, row ${Math.floor(pixel / width)} is (${words}); expected finite values`);
    }
    if (!values.some((value) => value < 0)) continue;
    ++negative;
    values.forEach((value, c) => { values[c] = Math.max(value, 0); });
  }
  return { width, height, pixels, flaw: negative > 0 ? `${negative} of ${width * height} pixels are negative in some channel (set to 0)` : '' };
}
