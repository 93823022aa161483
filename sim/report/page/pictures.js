'use strict';
// The section "Pictures": two pictures behind a divide, their difference, and the values of the pixel under the pointer.
// It is read before page.js, which has the helpers and calls startPictures().

// Pictures: the left one up to the divide, the right one from there on; or their difference about mid grey.
const images = new Map();
const read = new Map();
function pixels(image) {
  if (!read.has(image)) read.set(image, readPixels(image));
  return read.get(image);
}
function readPixels(image) {
  const canvas = create('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, image.width, image.height);
}

// The difference picture, and what it says in numbers: over the pixels where either picture differs from the
// background, which is the colour that both have in their first corner.
function difference(a, b, gain) {
  const out = new ImageData(a.width, a.height);
  let squares = 0, largest = 0, count = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    let drawn = false;
    for (let c = 0; c < 3; ++c) {
      const d = a.data[i + c] - b.data[i + c];
      out.data[i + c] = 128 + gain * d;
      squares += d * d;
      largest = Math.max(largest, Math.abs(d));
      drawn = drawn || a.data[i + c] !== a.data[c] || b.data[i + c] !== b.data[c];
    }
    out.data[i + 3] = 255;
    count += drawn;
  }
  return { out, largest, psnr: 10 * Math.log10(255 * 255 * 3 * count / squares) };
}

function nameTag(context, text, x, align, size) {
  context.font = `${size}px ${Chart.defaults.font.family}`;
  const width = context.measureText(text).width + size;
  const left = align === 'left' ? x : x - width;
  context.fillStyle = 'rgba(20, 24, 30, .72)';
  context.fillRect(left, size / 2, width, 1.6 * size);
  context.fillStyle = '#fff';
  context.fillText(text, left + size / 2, 1.65 * size);
}

function drawPictures() {
  const names = [element('picture-a').value, element('picture-b').value];
  const [a, b] = names.map(name => images.get(name));
  if (!a || !b) return;
  const canvas = element('picture-canvas'), context = canvas.getContext('2d');
  const zoom = Number(element('picture-zoom').value), split = Number(element('picture-split').value) / 100;
  canvas.width = a.width;
  canvas.height = a.height;
  canvas.style.width = a.width * zoom + 'px';
  canvas.style.maxWidth = zoom > 1 ? 'none' : '100%';
  if (a.width !== b.width || a.height !== b.height) {
    element('picture-text').textContent = 'Pictures of different sizes: only the left one is shown.';
    context.drawImage(a, 0, 0);
    return;
  }
  const { out, largest, psnr } = difference(pixels(a), pixels(b), Number(element('picture-gain').value));
  element('picture-text').textContent = largest === 0 ? 'Equal, pixel by pixel.' :
    `Over what is drawn: PSNR ${fixed(psnr, 2)} dB, largest difference ${largest} of 255. Drag on the picture to move the divide.`;
  if (element('picture-difference').checked) {
    context.putImageData(out, 0, 0);
    return;
  }
  const at = Math.round(split * a.width), tag = Math.max(6, Math.round(13 / zoom));
  context.drawImage(b, 0, 0);
  if (at > 0) context.drawImage(a, 0, 0, at, a.height, 0, 0, at, a.height);
  nameTag(context, names[0], 4, 'left', tag);
  nameTag(context, names[1], a.width - 4, 'right', tag);
  context.fillStyle = accent;
  context.fillRect(at - 1 / zoom, 0, Math.max(1, 2 / zoom), a.height);
}

function startPictures() {
  const names = data.pictures.map(p => p.name);
  const engine = data.paper ? data.paper.engine : 'golden';
  for (const [id, wish, index] of [['picture-a', `Fig. 5, ${engine}`, 0], ['picture-b', `Fig. 6, ${engine}`, Math.min(1, names.length - 1)]]) {
    options(element(id), names);
    element(id).selectedIndex = names.includes(wish) ? names.indexOf(wish) : index;
  }
  for (const picture of data.pictures) {
    const image = new Image();
    image.onload = () => {
      images.set(picture.name, image);
      if ([element('picture-a').value, element('picture-b').value].includes(picture.name)) drawPictures();
    };
    image.src = picture.png;
  }
  for (const id of ['picture-a', 'picture-b', 'picture-split', 'picture-zoom', 'picture-difference', 'picture-gain'])
    element(id).addEventListener('input', drawPictures);
  // Dragging on the picture moves the divide.
  const canvas = element('picture-canvas');
  canvas.addEventListener('pointermove', event => {
    const box = canvas.getBoundingClientRect();
    const along = (offset, size, count) => Math.min(count - 1, Math.max(0, Math.floor(count * offset / size)));
    drawColumns(along(event.clientX - box.left, box.width, canvas.width), along(event.clientY - box.top, box.height, canvas.height));
    if (event.buttons === 0) return;
    element('picture-split').value = 100 * (event.clientX - box.left) / box.width;
    drawPictures();
  });
}

// The values of a picture's pixels, decoded when they are first asked for; see sim/report/columns.h for the codes.
const columns = new Map();
async function decode(uri) {
  const image = new Image();
  image.src = uri;
  await image.decode();
  return readPixels(image).data;
}
function columnsOf(name) {
  if (!columns.has(name)) {
    const { columns: stored = [] } = data.pictures.find(p => p.name === name);
    columns.set(name, Promise.all(stored.map(async c => ({ values: c.values, high: await decode(c.high), low: await decode(c.low) }))));
  }
  return columns.get(name);
}

// {value: number} at a pixel; a value is missing where nothing is drawn.
function valuesAt(decoded, index) {
  const { offset, step } = data.column_format, found = {};
  for (const { values, high, low } of decoded) {
    values.forEach((value, k) => {
      const code = 256 * high[4 * index + k] + low[4 * index + k];
      if (code > 0) found[value] = offset + step * code;
    });
  }
  return found;
}

let latest = 0;
async function drawColumns(x, y) {
  const turn = ++latest;
  const names = [element('picture-a').value, element('picture-b').value];
  const shown = names.map(name => images.get(name)).filter(image => image && x < image.width && y < image.height);
  const decoded = await Promise.all(names.map(columnsOf));
  if (turn !== latest || shown.length < 2) return;  // the pointer has moved on
  const [a, b] = decoded.map((d, i) => valuesAt(d, y * shown[i].width + x));
  const colour = ['red', 'green', 'blue'].map((name, k) => [name, ...shown.map(image => pixels(image).data[4 * (y * image.width + x) + k])]);
  const rows = [...colour.map(([name, left, right]) => ({ name, left, right, digits: 0 })),
                ...[...new Set([...Object.keys(a), ...Object.keys(b)])].map(name => ({ name, left: a[name], right: b[name], digits: 4 }))];
  element('picture-pixel').textContent = `x ${x}, y ${y}`;
  table('picture-columns', rows, [
    ['value', r => r.name], [names[0], r => fixed(r.left, r.digits)], [names[1], r => fixed(r.right, r.digits)],
    ['difference', r => r.left === undefined || r.right === undefined ? '' : fixed(r.left - r.right, r.digits)],
  ]);
}
