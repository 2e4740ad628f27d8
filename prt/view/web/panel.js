// The controls: built from a table, each bound to one entry of the state.
import { kWindows } from './light.js';

const kSkies = ['overcast, steep gradation', 'overcast, brighter towards the sun', 'overcast, moderate gradation',
  'overcast, moderate, brighter to the sun', 'overcast, uniform', 'partly cloudy, slight brightening', 'partly cloudy, brighter circumsolar',
  'partly cloudy, distinct corona', 'partly cloudy, obscured sun', 'partly cloudy, brighter circumsolar', 'white-blue, distinct corona',
  'clear, low turbidity', 'clear, polluted', 'cloudless turbid, broad corona', 'white-blue turbid, broad corona', 'traditional overcast'];

const kHints = {
  none: '', wipe: 'Drag the line in the picture.',
  difference: 'Bright: the two differ by as much as the first shines (root mean square); each color down, a tenth.',
};

const range = (key, label, min, max, step, unit = '', when = () => true) => ({ kind: 'range', key, label, min, max, step, unit, when });
const select = (key, label, options, when = () => true) => ({ kind: 'select', key, label, options, when });
const toggle = (key, label, when = () => true) => ({ kind: 'toggle', key, label, when });

function sectionsOf({ subjects, degree, given, hasDropped, canMatch }) {
  const names = subjects.map(({ name }, k) => [String(k), name]);
  const isSky = (s) => s.light === 'sky', isCap = (s) => s.light === 'cap';
  const hasSun = (s) => isCap(s) || (isSky(s) && s.sky !== 16);
  return [
    ['Light', [
      select('light', 'Source', [['given', given], ['sky', 'Sky'], ['cap', 'Disc'], ...(hasDropped() ? [['dropped', hasDropped()]] : [])]),
      { kind: 'file', key: 'file', label: 'Open a light…', accept: '.json,.hdr,.exr,.png,.jpg,.jpeg' },
      select('sky', 'Sky', kSkies.map((name, k) => [String(k + 1), `${k + 1}  ${name}`]), isSky),
      range('elevation', 'Elevation', 0, 90, 1, '°', hasSun),
      range('azimuth', 'Azimuth', -180, 180, 1, '°', hasSun),
      range('sun', 'Sun', 0, 10, 0.1, ' W/m²', (s) => isSky(s) && s.sky !== 16),
      range('halfAngle', 'Half-angle', 0.25, 90, 0.25, '°', isCap),
      range('irradiance', 'Irradiance', 0, 20, 0.1, ' W/m²', isCap),
      range('degree', 'Degree', 0, degree, 1),
      select('window', 'Window', kWindows.map((name) => [name, name])),
      range('strength', 'Strength', 0, 1, 0.01, '', (s) => s.window !== 'none' && s.window !== 'auto'),
      { kind: 'text', id: 'ringing' },
    ]],
    ...(subjects.some(({ moves }) => moves) ? [['Stage', [range('time', 'Time', 0, 1, 0.01), toggle('playing', 'Play')]]] : []),
    ['Picture', [
      range('stops', 'Exposure', -6, 6, 0.1, ' stops'),
      select('tone', 'Tone curve', [['neutral', 'Khronos PBR Neutral'], ['reinhard', 'Reinhard'], ['linear', 'Linear']]),
      select('background', 'Background', [['grey', 'Grey'], ['light', 'The light']]),
      toggle('balls', 'Show the light as a sphere'),
    ]],
    ...(subjects.length > 1 ? [['Compare', [
      select('a', 'First', names),
      select('compare', 'Show', [['none', 'First alone'], ['wipe', 'Side by side'], ['difference', 'Difference']]),
      select('b', 'Second', names, (s) => s.compare !== 'none'),
      { kind: 'text', id: 'comparison', of: (s) => (s.compare === 'difference' && !canMatch(s) ? 'These have different meshes: no difference by vertices.' : kHints[s.compare]) },
    ]]] : []),
    ...(subjects.some(({ isGlossy }) => isGlossy) ? [['Surface', [
      toggle('ownSurface', 'One lobe for all'),
      range('exponent', 'Exponent', 0, 200, 1, '', (s) => s.ownSurface),
      range('specular', 'Reflectance', 0, 1, 0.01, '', (s) => s.ownSurface),
    ]]] : []),
  ];
}

const make = (tag, attributes = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), attributes);
  element.append(...children);
  return element;
};

const formatted = (value, { step, unit }) => `${Number(value).toFixed(step >= 1 ? 0 : step >= 0.1 ? 1 : 2)}${unit}`;

/**
 * Builds the controls into `place`; change(key, value) is called with what the user sets, openFile(file) with a file. Returns
 * functions that build the controls and show a state.
 */
export function buildPanel(place, page, change, openFile) {
  const rows = [];
  const controlOf = (row, state) => {
    if (row.kind === 'text') return [make('p', { className: 'note', id: row.id })];
    const id = `control-${row.key}`;
    if (row.kind === 'file') {
      const input = make('input', { type: 'file', id, accept: row.accept });
      input.addEventListener('change', () => { if (input.files.length > 0) openFile(input.files[0]); });
      return [input, make('label', { htmlFor: id, textContent: row.label })];
    }
    if (row.kind === 'toggle') {
      const box = make('input', { type: 'checkbox', id });
      box.addEventListener('change', () => change(row.key, box.checked));
      return [box, make('label', { htmlFor: id, textContent: row.label })];
    }
    const label = make('label', { htmlFor: id, textContent: row.label });
    const control = row.kind === 'range'
      ? make('input', { type: 'range', id, min: row.min, max: row.max, step: row.step })
      : make('select', { id }, ...row.options.map(([value, text]) => make('option', { value, textContent: text })));
    control.addEventListener('input', () => change(row.key, typeof state[row.key] === 'number' ? Number(control.value) : control.value));
    return row.kind === 'range' ? [label, control, make('output', { htmlFor: id })] : [label, control];
  };
  return {
    build(state) {
      rows.length = 0;
      const open = new Map([...place.querySelectorAll('details')].map((section) => [section.dataset.title, section.open]));
      place.replaceChildren(...sectionsOf(page).map(([title, list]) => {
        const section = make('details', { open: open.get(title) ?? true }, make('summary', { textContent: title }));
        section.dataset.title = title;
        for (const row of list) {
          const line = make('div', { className: `row ${row.kind}` }, ...controlOf(row, state));
          rows.push({ ...row, line });
          section.append(line);
        }
        return section;
      }));
    },
    show(state) {
      for (const row of rows) {
        if (row.when) row.line.hidden = !row.when(state);
        const control = row.line.querySelector('input, select');
        if (row.kind === 'toggle') control.checked = state[row.key];
        if (row.kind === 'range' || row.kind === 'select') control.value = String(state[row.key]);
        if (row.kind === 'range') row.line.querySelector('output').textContent = formatted(state[row.key], row);
        if (row.of) row.line.firstChild.textContent = row.of(state);
      }
    },
  };
}

/** What the page tells of a vertex: a table of facts, and its coefficients as bars. name: of its file on a stage, else empty; node: of its model, or undefined. */
export function showVertex(place, { name, node, vertex, position, normal, radiance, numbers, shape, meaning }) {
  const three = (values) => [...values].map((value) => value.toPrecision(4)).join('  ');
  const facts = [...(name ? [['Object', name]] : []), ...(node?.name ? [['Node', node.name]] : []), ...(node?.material ? [['Material', node.material]] : []), ['Vertex', String(vertex)], ['Position', three(position)], ['Normal', three(normal)], ['Radiance', three(radiance)]];
  const channels = shape.channels === 3 ? ['red', 'green', 'blue'] : [''];
  const most = numbers.reduce((largest, value) => Math.max(largest, Math.abs(value)), 1e-30);
  const bars = channels.map((channel, c) => {
    const list = make('ol', { className: 'bars', start: 0, ariaLabel: `${meaning} ${channel}` });
    for (const [i, value] of [...numbers.subarray(c * shape.count, (c + 1) * shape.count)].entries()) {
      const l = Math.floor(Math.sqrt(i));
      const bar = make('li', { title: `l = ${l}, m = ${i - l * l - l}: ${value.toPrecision(5)}`, className: value < 0 ? 'negative' : '' });
      bar.style.setProperty('--size', Math.abs(value) / most);
      bar.classList.toggle('first', i === l * l && l > 0);
      list.append(bar);
    }
    return list;
  });
  place.replaceChildren(
    make('dl', {}, ...facts.flatMap(([name, value]) => [make('dt', { textContent: name }), make('dd', { textContent: value })])),
    make('p', { className: 'note', textContent: meaning }), ...bars);
}
