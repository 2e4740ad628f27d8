// Pointers, wheel, keys and dropped files, as calls of what the user wants: orbit, turn, zoom, move, pick, key, drop.

const kDegreesPerPixel = 0.4;
const kClick = 4;  // pixels that a click may move

/** Listens on the canvas; `on` has the functions above. */
export function listen(canvas, on) {
  const pointers = new Map();
  let moved = 0, apart = 0;

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    moved = pointers.size > 1 ? kClick + 1 : 0;
    apart = 0;
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]];
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    moved += Math.hypot(dx, dy);
    if (pointers.size === 2) {
      const [a, b] = [...pointers.values()];
      const now = Math.hypot(a[0] - b[0], a[1] - b[1]);
      if (apart > 0 && now > 0) on.zoom(apart / now);
      apart = now;
      on.turn((dx * kDegreesPerPixel) / 2, (dy * kDegreesPerPixel) / 2);
    } else if (event.shiftKey) {
      on.turn(dx * kDegreesPerPixel, dy * kDegreesPerPixel);
    } else if (event.buttons & 2 || event.buttons & 4) {
      on.move(dx, dy);
    } else if (moved > kClick) {
      on.orbit(dx * kDegreesPerPixel, dy * kDegreesPerPixel);
    }
  });
  for (const type of ['pointerup', 'pointercancel']) {
    canvas.addEventListener(type, (event) => {
      if (!pointers.delete(event.pointerId)) return;
      apart = 0;
      if (type === 'pointerup' && event.button === 0 && moved <= kClick && !event.shiftKey) on.pick(event.offsetX, event.offsetY);
    });
  }
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    on.zoom(Math.exp(Math.max(-0.3, Math.min(0.3, event.deltaY * 0.001))));
  }, { passive: false });
  document.addEventListener('keydown', (event) => {
    const isControl = ['INPUT', 'SELECT', 'SUMMARY', 'BUTTON'].includes(document.activeElement?.tagName);
    if (event.ctrlKey || event.metaKey || event.altKey || (isControl && (event.key.startsWith('Arrow') || event.key === ' '))) return;
    const arrows = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, -5], ArrowDown: [0, 5] }[event.key];
    if (arrows) {
      event.preventDefault();
      return event.shiftKey ? on.turn(...arrows) : on.orbit(...arrows);
    }
    if (event.key === '+' || event.key === '=') return on.zoom(1 / 1.1);
    if (event.key === '-') return on.zoom(1.1);
    return on.key(event.key.toLowerCase());
  });
  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    if (event.dataTransfer.files.length > 0) on.drop(event.dataTransfer.files[0]);
  });
}
