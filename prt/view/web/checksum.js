// XXH3-64 with seed 0 [Yann Collet, "xxHash specification", 0.8], the checksum of transfer files. The inner loop over long
// input works on 32-bit halves; the rest, which runs once, on BigInt.

const kSecret = Uint8Array.from(
  ('b8fe6c3923a44bbe7c01812cf721ad1cded46de9839097db7240a4a4b7b3671fcb79e64eccc0e578825ad07dccff7221b8084674f743248ee03590e6813a264c' +
   '3c2852bb91c300cb88d0658b1b532ea371644897a20df94e3819ef46a9deacd8a8fa763fe39c343ff9dcbbc7c70b4f1d8a51e04bcdb45931c89f7ec9d9787364' +
   'eac5ac8334d3ebc3c581a0fffa1363eb170ddd51b7f0da49d316552629d4689e2b16be587d47a1fc8ff8b8d17ad031ce45cb3a8f95160428afd7fbcabb4b407e')
    .match(/../g), (byte) => parseInt(byte, 16));

const kPrime32 = [0x9E3779B1n, 0x85EBCA77n, 0xC2B2AE3Dn];
const kPrime64 = [0x9E3779B185EBCA87n, 0xC2B2AE3D27D4EB4Fn, 0x165667B19E3779F9n, 0x85EBCA77C2B2AE63n, 0x27D4EB2F165667C5n];
const kMix = [0x165667919E3779F9n, 0x9FB21C651E98DF25n];
const kStripe = 64;
const kStripesOfBlock = (192 - kStripe) / 8;

const u64 = (value) => BigInt.asUintN(64, value);
const rotl = (value, by) => u64((value << by) | (value >> (64n - by)));
const folded = (a, b) => { const product = a * b; return u64(product) ^ (product >> 64n); };

function swapped(value, bytes) {
  let out = 0n;
  for (let k = 0; k < bytes; ++k, value >>= 8n) out = (out << 8n) | (value & 255n);
  return out;
}

function avalanche(hash) {
  hash = u64((hash ^ (hash >> 37n)) * kMix[0]);
  return hash ^ (hash >> 32n);
}

function avalancheOfShort(hash) {
  hash = u64((hash ^ (hash >> 33n)) * kPrime64[1]);
  hash = u64((hash ^ (hash >> 29n)) * kPrime64[2]);
  return hash ^ (hash >> 32n);
}

const viewOf = (bytes) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
const kSecretView = viewOf(kSecret);
const secret64 = (at) => kSecretView.getBigUint64(at, true);

function mixed(data, at, key) {
  return folded(data.getBigUint64(at, true) ^ secret64(key), data.getBigUint64(at + 8, true) ^ secret64(key + 8));
}

function ofShort(bytes, data) {
  const n = bytes.length;
  const length = BigInt(n);
  if (n > 8) {
    const low = data.getBigUint64(0, true) ^ secret64(24) ^ secret64(32);
    const high = data.getBigUint64(n - 8, true) ^ secret64(40) ^ secret64(48);
    return avalanche(u64(length + swapped(low, 8) + high + folded(low, high)));
  }
  if (n >= 4) {
    const first = BigInt(data.getUint32(0, true));
    const last = BigInt(data.getUint32(n - 4, true));
    let hash = (last + (first << 32n)) ^ secret64(8) ^ secret64(16);
    hash = u64((hash ^ rotl(hash, 49n) ^ rotl(hash, 24n)) * kMix[1]);
    hash = u64((hash ^ ((hash >> 35n) + length)) * kMix[1]);
    return hash ^ (hash >> 28n);
  }
  if (n === 0) return avalancheOfShort(secret64(56) ^ secret64(64));
  const combined = ((bytes[0] << 16) | (bytes[n >> 1] << 24) | bytes[n - 1] | (n << 8)) >>> 0;
  const flip = (kSecretView.getUint32(0, true) ^ kSecretView.getUint32(4, true)) >>> 0;
  return avalancheOfShort(BigInt((combined ^ flip) >>> 0));
}

function ofMiddle(data, n) {
  let sum = BigInt(n) * kPrime64[0];
  if (n <= 128) {
    for (let k = (n - 1) >> 5; k >= 0; --k) sum += mixed(data, 16 * k, 32 * k) + mixed(data, n - 16 * (k + 1), 32 * k + 16);
    return avalanche(u64(sum));
  }
  for (let k = 0; k < 8; ++k) sum += mixed(data, 16 * k, 16 * k);
  sum = avalanche(u64(sum));
  for (let k = 8; k < n >> 4; ++k) sum += mixed(data, 16 * k, 16 * (k - 8) + 3);
  return avalanche(u64(sum + mixed(data, n - 16, 136 - 17)));
}

// Eight sums of 64 bits as halves: low[i] and high[i].
class Sums {
  constructor() {
    const first = [kPrime32[2], kPrime64[0], kPrime64[1], kPrime64[2], kPrime64[3], kPrime32[1], kPrime64[4], kPrime32[0]];
    this.low = Uint32Array.from(first, (value) => Number(value & 0xFFFFFFFFn));
    this.high = Uint32Array.from(first, (value) => Number(value >> 32n));
  }

  get(i) { return (BigInt(this.high[i]) << 32n) | BigInt(this.low[i]); }

  add(i, low, high) {
    const sum = this.low[i] + low;
    this.low[i] = sum;
    this.high[i] += high + (sum > 0xFFFFFFFF ? 1 : 0);
  }

  addStripe(data, at, key) {
    for (let i = 0; i < 8; ++i) {
      const low = data.getUint32(at + 8 * i, true);
      const high = data.getUint32(at + 8 * i + 4, true);
      const a = low ^ kSecretView.getUint32(key + 8 * i, true);
      const b = high ^ kSecretView.getUint32(key + 8 * i + 4, true);
      this.add(i ^ 1, low, high);
      // The product of a and b, from halves of 16 bits.
      const a0 = a & 0xFFFF, a1 = a >>> 16, b0 = b & 0xFFFF, b1 = b >>> 16;
      const middle = a1 * b0 + ((a0 * b0) >>> 16);
      const carried = (middle & 0xFFFF) + a0 * b1;
      this.add(i, Math.imul(a, b) >>> 0, a1 * b1 + Math.floor(middle / 65536) + Math.floor(carried / 65536));
    }
  }

  scramble() {
    for (let i = 0; i < 8; ++i) {
      let sum = this.get(i);
      sum = u64((sum ^ (sum >> 47n) ^ secret64(192 - kStripe + 8 * i)) * kPrime32[0]);
      this.low[i] = Number(sum & 0xFFFFFFFFn);
      this.high[i] = Number(sum >> 32n);
    }
  }
}

function ofLong(data, n) {
  const sums = new Sums();
  for (let stripe = 0; stripe < Math.floor((n - 1) / kStripe); ++stripe) {
    sums.addStripe(data, stripe * kStripe, 8 * (stripe % kStripesOfBlock));
    if (stripe % kStripesOfBlock === kStripesOfBlock - 1) sums.scramble();
  }
  sums.addStripe(data, n - kStripe, 192 - kStripe - 7);
  let hash = BigInt(n) * kPrime64[0];
  for (let i = 0; i < 4; ++i) {
    hash += folded(sums.get(2 * i) ^ secret64(11 + 16 * i), sums.get(2 * i + 1) ^ secret64(19 + 16 * i));
  }
  return avalanche(u64(hash));
}

/** XXH3-64 of a Uint8Array, as a BigInt. */
export function checksum(bytes) {
  const data = viewOf(bytes);
  if (bytes.length <= 16) return ofShort(bytes, data);
  return bytes.length <= 240 ? ofMiddle(data, bytes.length) : ofLong(data, bytes.length);
}
