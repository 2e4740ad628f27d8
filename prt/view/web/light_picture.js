// Lat-long pictures of light: what every format has to give.
import { FileError } from './transfer_file.js';

const kMostPixels = 2 ** 27;

export function requirePictureSize(width, height) {
  if (width > 0 && height > 0 && width * height <= kMostPixels) return;
  throw new FileError(`the picture is ${width} x ${height} pixels; expected 1 to ${kMostPixels} pixels`);
}

/** {width, height, pixels: linear RGB, row by row from the top}, finite; negative numbers become 0, as prt has it. */
export function pictureOf(width, height, pixels) {
  for (let i = 0; i < pixels.length; ++i) {
    if (!Number.isFinite(pixels[i])) {
      const pixel = Math.floor(i / 3);
      const values = pixels.subarray(3 * pixel, 3 * pixel + 3).join(', ').replaceAll('NaN', 'nan').replaceAll('Infinity', 'inf');
      throw new FileError(`the pixel in column ${pixel % width}, row ${Math.floor(pixel / width)} is (${values}); expected finite values`);
    }
    if (pixels[i] < 0) pixels[i] = 0;
  }
  return { width, height, pixels };
}
