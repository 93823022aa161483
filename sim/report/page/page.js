'use strict';
// Everything on the page is made from the JSON in #data. `wrinkleReport` is what a test looks at.
const data = JSON.parse(document.getElementById('data').textContent);
const charts = {};
window.wrinkleReport = { charts };

const colours = ['#4269d0', '#efb118', '#ff725c', '#6cc5b0', '#3ca951', '#ff8ab7', '#a463f2', '#97bbf5', '#9c6b4e', '#9498a0'];
const element = id => document.getElementById(id);
const fixed = (x, digits) => x === null || x === undefined ? '' : Number(x).toLocaleString('en', { minimumFractionDigits: digits, maximumFractionDigits: digits });
const capital = name => name.replace(/^fig(\d)$/, 'Fig. $1');

// columns: [title, row => text, isText]
function table(into, rows, columns) {
  const t = document.createElement('table');
  const head = t.createTHead().insertRow();
  for (const [title, , isText] of columns) {
    const th = document.createElement('th');
    th.textContent = title;
    if (isText) th.className = 'text';
    head.append(th);
  }
  const body = t.createTBody();
  for (const row of rows) {
    const tr = body.insertRow();
    for (const [, value, isText] of columns) {
      const td = tr.insertCell();
      td.textContent = value(row);
      if (isText) td.className = 'text';
    }
  }
  element(into).replaceChildren(t);
}

function options(select, names) {
  select.replaceChildren(...names.map(name => new Option(name, name)));
}

function chart(id, config) {
  config.options = { responsive: true, maintainAspectRatio: false, animation: false, ...config.options };
  if (charts[id]) charts[id].destroy();
  charts[id] = new Chart(element(id + '-chart'), config);
}

const figures = data.figures ? ['fig1', 'fig2', 'fig3'].map(name => data.figures[name]) : [];

function drawClaim() {
  if (!figures.length) return;
  const given = element('claim-given').checked;
  const stages = [...new Set(figures.flatMap(f => f.stages.filter(s => given || !s.given).map(s => s.stage)))];
  const area = (figure, name) => figure.stages.filter(s => s.stage === name).reduce((sum, s) => sum + s.nand2, 0);
  chart('claim', {
    type: 'bar',
    data: {
      labels: ['Fig. 1, Phong', 'Fig. 2, Blinn', 'Fig. 3, multiplexer'],
      datasets: stages.map((name, i) => ({ label: name, data: figures.map(f => area(f, name)), backgroundColor: colours[i % colours.length] })),
    },
    options: {
      indexAxis: 'y',
      scales: { x: { stacked: true, title: { display: true, text: 'NAND2 equivalents' } }, y: { stacked: true } },
      plugins: { tooltip: { callbacks: { label: c => `${c.dataset.label}: ${fixed(c.raw, 0)} NAND2` } } },
    },
  });
  const total = f => f.nand2 - (given ? 0 : f.nand2_given);
  const share = f => 100 * (total(f) / total(figures[0]) - 1);
  element('claim-text').textContent =
    `Fig. 3 costs ${fixed(total(figures[2]) - total(figures[0]), 0)} NAND2 more than Fig. 1: ${fixed(share(figures[2]), 3)} %. ` +
    `Fig. 2 costs ${fixed(total(figures[1]) - total(figures[0]), 0)} more: ${fixed(share(figures[1]), 1)} %. ` +
    `All in ${figures[0].library} at the same widths of bounded vectors.`;
  table('claim-table', stages, [
    ['stage, NAND2', name => name],
    ...figures.map(f => [capital(f.name), name => fixed(area(f, name), 0)]),
  ]);
}

function drawTrade() {
  const datapath = element('trade-datapath').value, normalizer = element('trade-normalizer').value;
  const shown = data.configs.filter(c => c.area && c.error && (datapath === 'all' || c.datapath === datapath) &&
                                         (normalizer === 'all' || c.normalizer === normalizer));
  const kinds = [...new Set(data.configs.map(c => c.datapath))];
  chart('trade', {
    type: 'scatter',
    data: {
      datasets: kinds.map((kind, i) => ({
        label: kind, backgroundColor: colours[i % colours.length], pointRadius: 7, pointHoverRadius: 9,
        data: shown.filter(c => c.datapath === kind).map(c => ({ x: c.area.nand2, y: c.error.precision.psnr_db, name: c.name, path: c.area.critical_path_ns })),
      })),
    },
    options: {
      scales: { x: { title: { display: true, text: 'area, NAND2 equivalents' } }, y: { title: { display: true, text: 'precision, dB' } } },
      plugins: { tooltip: { callbacks: { label: c => `${c.raw.name}: ${fixed(c.raw.x, 0)} NAND2, ${fixed(c.raw.y, 1)} dB, ${fixed(c.raw.path, 1)} ns` } } },
    },
  });
  table('trade-table', shown, [
    ['configuration', c => c.name], ['datapath', c => c.datapath, true], ['normalizer', c => c.normalizer, true],
    ['scene', c => c.error.scene, true],
    ['NAND2', c => fixed(c.area.nand2, 0)], ['flip-flops', c => fixed(c.area.flip_flops, 0)],
    ['critical path ns', c => fixed(c.area.critical_path_ns, 2)],
    ['sum to flat %', c => c.area.deviation === undefined ? '' : fixed(100 * c.area.deviation, 2)],
    ['precision dB', c => fixed(c.error.precision.psnr_db, 2)], ['method dB', c => fixed(c.error.method.psnr_db, 2)],
    ['SSIM', c => fixed(c.error.precision.ssim, 5)],
  ]);
}

// Pictures: the left one up to the divide, the right one from there on; or their difference about mid grey.
const images = new Map();
function pixels(image) {
  const canvas = document.createElement('canvas');
  canvas.width = image.width;
  canvas.height = image.height;
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, image.width, image.height);
}

function drawPictures() {
  const a = images.get(element('picture-a').value), b = images.get(element('picture-b').value);
  if (!a || !b) return;
  const canvas = element('picture-canvas'), context = canvas.getContext('2d');
  const zoom = Number(element('picture-zoom').value), split = Number(element('picture-split').value) / 100;
  const alike = a.width === b.width && a.height === b.height;
  if (canvas.width !== a.width || canvas.height !== a.height) {
    canvas.width = a.width;
    canvas.height = a.height;
  }
  canvas.style.width = a.width * zoom + 'px';
  canvas.style.height = a.height * zoom + 'px';
  if (!alike) {
    element('picture-text').textContent = 'Pictures of different sizes: only the left one is shown.';
    context.drawImage(a, 0, 0);
    return;
  }
  const x = pixels(a), y = pixels(b);
  let squares = 0, largest = 0;
  const out = new ImageData(a.width, a.height);
  for (let i = 0; i < x.data.length; ++i) {
    const alpha = i % 4 === 3, d = x.data[i] - y.data[i];
    out.data[i] = alpha ? 255 : 128 + 8 * d;
    if (alpha) continue;
    squares += d * d;
    largest = Math.max(largest, Math.abs(d));
  }
  const mean = squares / (a.width * a.height * 3);
  element('picture-text').textContent = mean === 0 ? 'Equal, pixel by pixel.' :
    `Over the whole picture: PSNR ${fixed(10 * Math.log10(255 * 255 / mean), 2)} dB, largest difference ${largest} grey levels.`;
  if (element('picture-difference').checked) {
    context.putImageData(out, 0, 0);
    return;
  }
  const at = Math.round(split * a.width);
  context.drawImage(b, 0, 0);
  if (at > 0) context.drawImage(a, 0, 0, at, a.height, 0, 0, at, a.height);
  context.fillStyle = '#ff3b30';
  context.fillRect(at, 0, 1, a.height);
}

function startPictures() {
  const names = data.pictures.map(p => p.name);
  for (const [id, index] of [['picture-a', 0], ['picture-b', Math.min(1, names.length - 1)]]) {
    options(element(id), names);
    element(id).selectedIndex = index;
  }
  for (const picture of data.pictures) {
    const image = new Image();
    image.onload = () => {
      images.set(picture.name, image);
      drawPictures();
    };
    image.src = picture.png;
  }
  for (const id of ['picture-a', 'picture-b', 'picture-split', 'picture-zoom', 'picture-difference'])
    element(id).addEventListener('input', drawPictures);
  // Dragging on the picture moves the divide.
  const canvas = element('picture-canvas');
  canvas.addEventListener('pointermove', event => {
    if (event.buttons === 0) return;
    const box = canvas.getBoundingClientRect();
    element('picture-split').value = 100 * (event.clientX - box.left) / box.width;
    drawPictures();
  });
}

function drawBudget() {
  const run = data.configs.find(c => c.name === element('budget-run').value);
  if (!run) return;
  chart('budget', {
    type: 'bar',
    data: { labels: run.error.stages.map(s => s.stage), datasets: [{ label: 'grey levels, RMS', data: run.error.stages.map(s => s.grey.rms), backgroundColor: colours[0] }] },
    options: { plugins: { legend: { display: false } }, scales: { y: { title: { display: true, text: 'grey levels, RMS' } } } },
  });
  const pair = (s, key, digits) => `${fixed(s[key].rms, digits)} / ${fixed(s[key].max, digits)}`;
  table('budget-table', run.error.stages, [
    ['stage (RMS / maximum)', s => s.stage], ['ulp', s => pair(s, 'ulp', 3)], ['degrees', s => pair(s, 'degrees', 4)],
    ['length', s => pair(s, 'length', 5)], ['grey levels', s => pair(s, 'grey', 3)],
    ['alone dB', s => fixed(s.psnr_alone_db, 2)], ['all others dB', s => fixed(s.psnr_without_db, 2)],
  ]);
}

function drawSpeed() {
  if (!data.speed) return;
  const engines = data.speed.engines;
  chart('speed', {
    type: 'bar',
    data: { labels: engines.map(e => e.engine), datasets: [{ data: engines.map(e => e.pixels_per_cpu_s), backgroundColor: colours[4] }] },
    options: {
      indexAxis: 'y', plugins: { legend: { display: false } },
      scales: { x: { type: 'logarithmic', title: { display: true, text: 'pixels per CPU second' } } },
    },
  });
  table('speed-table', engines, [
    ['engine', e => e.engine], ['pixels per CPU second', e => fixed(e.pixels_per_cpu_s, 0)], ['faithful to', e => e.faithful_to, true],
  ]);
  table('chip-table', data.speed.chips, [
    ['configuration', c => c.config], ['clocks per pixel', c => fixed(c.clocks_per_pixel, 3)],
    ['clock period, ns', c => fixed(c.period_ns, 2)], ['million pixels per second', c => fixed(1e-6 * c.pixels_per_s, 1)],
  ]);
}

function start() {
  // A run without synthesis or timing has no such sections.
  element('claim').hidden = !figures.length;
  element('speed').hidden = !data.speed;
  drawClaim();
  element('claim-given').addEventListener('input', drawClaim);
  const all = key => ['all', ...new Set(data.configs.map(c => c[key]))];
  options(element('trade-datapath'), all('datapath'));
  options(element('trade-normalizer'), all('normalizer'));
  for (const id of ['trade-datapath', 'trade-normalizer']) element(id).addEventListener('input', drawTrade);
  drawTrade();
  startPictures();
  options(element('budget-run'), data.configs.filter(c => c.error && c.error.stages.length).map(c => c.name));
  if (data.configs.some(c => c.name === 'standard' && c.error)) element('budget-run').value = 'standard';
  element('budget-run').addEventListener('input', drawBudget);
  drawBudget();
  drawSpeed();
  table('provenance-table', Object.entries(data.provenance), [['', e => e[0]], ['', e => e[1], true]]);
}
start();
