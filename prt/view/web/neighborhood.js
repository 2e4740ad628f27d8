// The space around an object of a stage, which darkens the other objects; as prt/runtime/neighborhood.hpp has it where one
// object has a volume.
import { numbersOf } from './transfer_file.js';
import { applied, gaussLegendre, remembering } from './vectors.js';

const numbersIn = (degree) => (degree + 1) ** 2;

// {direction, weight}: exact for polynomials of this degree.
const kSphereRules = remembering((degree) => gaussLegendre(Math.floor(degree / 2) + 1).flatMap(([z, weight]) => (
  Array.from({ length: degree + 1 }, (_, k) => {
    const azimuth = (2 * Math.PI * k) / (degree + 1), sine = Math.sqrt(1 - z * z);
    return { direction: [sine * Math.cos(azimuth), sine * Math.sin(azimuth), z], weight: (2 * Math.PI * weight) / (degree + 1) };
  }))));

export class Volume {
  /** transfer: of kind N. */
  constructor(transfer, kernels) {
    const { shape: { degree, resultDegree, columns }, grid } = transfer;
    Object.assign(this, { degree, resultDegree, columns, grid });
    this.rule = kSphereRules(2 * (degree + resultDegree));
    this.basis = this.basisAt(kernels[`basis_l${degree + resultDegree}`], degree + resultDegree, (direction) => direction);
    this.rows = new Float32Array(grid.points * columns);
    for (let p = 0; p < grid.points; ++p) this.rows.set(numbersOf(transfer, p), p * columns);
  }

  // (nodes, bands^2) of the rule.
  basisAt(kernel, degree, turn) {
    const size = numbersIn(degree);
    const table = new Float64Array(this.rule.length * size);
    this.rule.forEach(({ direction }, k) => kernel(...turn(direction), table.subarray(k * size, (k + 1) * size)));
    return table;
  }

  /** The basis of a receiver at the nodes of the rule; toReceiver: a rotation from the axes of the volume to its axes. */
  basisOf(kernel, degree, toReceiver) {
    return { degree, table: this.basisAt(kernel, degree, (direction) => applied(toReceiver, direction)) };
  }

  /** What a point in its axes sees of the sphere: {share, nodes: at the nodes, times their weights}; null outside of its box. */
  seenFrom(point) {
    const { grid: { box: [low, high], counts }, columns } = this;
    if (!point.every((x, k) => low[k] <= x && x <= high[k])) return null;
    const place = point.map((x, k) => ((x - low[k]) / (high[k] - low[k])) * (counts[k] - 1));
    const first = place.map((x, k) => Math.min(Math.floor(x), counts[k] - 2));
    const row = new Float64Array(columns);
    for (let corner = 0; corner < 8; ++corner) {
      const at = first.map((x, k) => x + ((corner >> k) & 1));
      const part = at.reduce((product, x, k) => product * (1 - Math.abs(place[k] - x)), 1);
      const from = columns * (at[0] + counts[0] * (at[1] + counts[1] * at[2]));
      for (let i = 0; i < columns; ++i) row[i] += part * this.rows[from + i];
    }
    const nodes = this.rule.map(({ weight }, k) => {
      let value = 0;
      for (let i = 0; i < columns; ++i) value += row[i] * this.basis[k * columns + i];
      return weight * value;
    });
    return { share: row[0] / Math.sqrt(4 * Math.PI), nodes };
  }

  /**
   * A function of one channel behind what a point sees, for `basis` of basisOf: light, or a row of transfer (isRow), which
   * meets the light as the light behind it meets the row. Bands above `highest` are zero.
   */
  behind({ share, nodes }, { degree, table }, highest, values, isRow) {
    const [from, to] = isRow ? [this.resultDegree, this.degree] : [this.degree, this.resultDegree];
    const size = numbersIn(degree), [read, written] = [from, to].map((most) => numbersIn(Math.min(most, highest, degree)));
    const out = new Float64Array(values.length);
    for (let i = numbersIn(this.degree); i < numbersIn(Math.min(highest, degree)); ++i) out[i] = share * values[i];
    nodes.forEach((seen, k) => {
      let value = 0;
      for (let i = 0; i < read; ++i) value += values[i] * table[k * size + i];
      value *= seen;
      for (let i = 0; i < written; ++i) out[i] += value * table[k * size + i];
    });
    return out;
  }
}
