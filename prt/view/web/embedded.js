// The bytes of the page's files: in itself, or from its server.
import { FileError } from './transfer_file.js';

/** A file of the page's data -> Uint8Array. Throws FileError. */
export async function bytesOf({ name, data, url }) {
  if (url) {
    const answer = await fetch(url).catch(() => ({ ok: false }));
    if (!answer.ok) throw new FileError(`${name}: the server of this page does not answer: start \`prt view --serve\` again`);
    return new Uint8Array(await answer.arrayBuffer());
  }
  const text = atob(data);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  try {
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new FileError(`${name}: the page is damaged where it holds this file; write it again with \`prt view\``);
  }
}
