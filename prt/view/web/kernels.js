// The generated GLSL functions as JavaScript: straight lines of arithmetic, which need no more than other words for their
// types. Numbers are double here; the constants have the digits of single precision.

function functionOf(text) {
  const code = text.replace(/\/\/.*|^#.*$|^precision .*$/gm, '');
  const [, name, parameters, body] = /\b(\w+)\(([^)]*)\)\s*\{([^]*)\}/.exec(code);
  const names = parameters.split(',').map((parameter) => /(\w+)(\[\d+\])?$/.exec(parameter.trim())[1]);
  const script = body.replace(/\bconst float\b/g, 'const').replace(/\bfloat (\w+)\[(\d+)\]/g, 'const $1 = new Float64Array($2)')
    .replace(/\bfloat\b/g, 'let').replace(/\bsqrt\(/g, 'Math.sqrt(');
  return [name, new Function(...names, script)];
}

/** {name: GLSL} -> {name: function of the same parameters, which writes its `out` arrays}. */
export function kernelsOf(texts) { return Object.fromEntries(Object.values(texts).map(functionOf)); }
