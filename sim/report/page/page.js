'use strict';
// Everything on the page is made from the JSON in #data. `wrinkleReport` is what a test looks at.
const data = JSON.parse(document.getElementById('data').textContent);
const texts = JSON.parse(document.getElementById('texts').textContent);
const charts = {};
window.wrinkleReport = { charts };

const colours = ['#4269d0', '#efb118', '#6cc5b0', '#3ca951', '#a463f2', '#97bbf5', '#9c6b4e', '#ff8ab7', '#9498a0', '#2f4b7c'];
const accent = '#e8452c';  // the multiplexer, and the divide
const element = id => document.getElementById(id);
const fixed = (x, digits) => x === null || x === undefined ? '' : Number(x).toLocaleString('en', { minimumFractionDigits: digits, maximumFractionDigits: digits });
const decibels = x => x === null || x === undefined ? '' : x >= 200 ? 'equal' : fixed(x, 2);
const capital = name => name.replace(/^fig(\d)/, 'Fig. $1');
const sum = (list, value) => list.reduce((total, item) => total + value(item), 0);
Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
Chart.defaults.color = '#5d6675';
Chart.defaults.borderColor = '#e8ecf2';

function create(tag, text, className) {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  if (className) made.className = className;
  return made;
}

// columns: [title, row => text, isText]; rowClass: row => class or ''
function table(into, rows, columns, rowClass) {
  const t = create('table'), head = t.createTHead().insertRow(), body = t.createTBody();
  for (const [title, , isText] of columns) head.append(create('th', title, isText ? 'text' : ''));
  for (const row of rows) {
    const tr = body.insertRow();
    if (rowClass) tr.className = rowClass(row);
    for (const [, value, isText] of columns) tr.append(create('td', value(row), isText ? 'text' : ''));
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

// Each run with what is known of its configuration; the scene is one more choice to filter by.
const runs = data.runs.map(run => {
  const config = data.configs.find(c => c.name === run.config);
  return { ...run, choices: { ...config.choices, scene: run.scene }, area: config.area };
});
window.wrinkleReport.runs = runs;
const isNarrow = window.innerWidth < 600;
const figures = data.figures ? ['fig1', 'fig2', 'fig3'].map(name => data.figures[name]) : [];
const standard = runs.find(r => r.config === 'standard' && r.scene === 'patch_fig6') || runs.find(r => r.config === 'standard');
const pairs = data.paper ? data.paper.pairs : [];
const pairName = p => `${capital(p.a)} against ${capital(p.b)}`;

function drawTiles() {
  const tiles = [];
  if (figures.length) {
    const over = f => `+${fixed(100 * (f.nand2 / figures[0].nand2 - 1), f === figures[2] ? 3 : 1)} %`;
    tiles.push([over(figures[2]), 'gates of Fig. 3 over Fig. 1, the paper’s own'], [over(figures[1]), 'gates of Fig. 2 over Fig. 1, Blinn’s']);
  }
  if (pairs.length) tiles.push([`${fixed(pairs[0].psnr_db, 1)} dB`, `${pairName(pairs[0])}, SSIM ${fixed(pairs[0].ssim, 4)}`]);
  if (standard) tiles.push([`${fixed(standard.error.precision.psnr_db, 1)} dB`, 'what the widths of “standard” keep']);
  const chip = data.speed && data.speed.chips.find(c => c.config === 'standard' && c.scene === 'patch_fig6');
  if (chip) tiles.push([fixed(chip.clocks_per_pixel, 3), 'clocks a pixel of “standard” on the patch']);
  element('tiles').replaceChildren(...tiles.map(([number, text]) => {
    const tile = create('div', undefined, 'tile');
    tile.append(create('b', number), create('span', text));
    return tile;
  }));
}

function drawClaim() {
  if (!figures.length) return;
  const given = element('claim-given').checked;
  const parts = figure => figure.stages.filter(s => given || !s.given);
  const stages = [...new Set(figures.flatMap(f => parts(f).map(s => s.stage)))];
  const area = (figure, name) => sum(parts(figure).filter(s => s.stage === name), s => s.nand2);
  const total = figure => sum(parts(figure), s => s.nand2);
  const isMultiplexer = name => name === 'perturb';
  const title = name => isMultiplexer(name) ? 'perturb (Fig. 3: the multiplexer)' : name;
  chart('claim', {
    type: 'bar',
    data: {
      labels: ['Fig. 1, Phong', 'Fig. 2, Blinn', 'Fig. 3, multiplexer'],
      datasets: stages.map((name, i) => ({ label: title(name), data: figures.map(f => area(f, name)), backgroundColor: isMultiplexer(name) ? accent : colours[i % colours.length] })),
    },
    options: {
      indexAxis: 'y',
      scales: { x: { stacked: true, title: { display: true, text: 'NAND2 equivalents' } }, y: { stacked: true, grid: { display: false } } },
      plugins: {
        legend: { position: 'bottom', labels: { boxWidth: 12 } },
        tooltip: { callbacks: { label: c => `${c.dataset.label}: ${fixed(c.raw, 0)} NAND2, ${fixed(100 * c.raw / total(figures[c.dataIndex]), 3)} %` } },
      },
    },
  });
  const share = f => 100 * (total(f) / total(figures[0]) - 1), more = f => total(f) - total(figures[0]);
  const multiplexer = area(figures[2], 'perturb');
  element('claim-text').textContent =
    `Fig. 3 costs ${fixed(more(figures[2]), 0)} NAND2 more than Fig. 1, ${fixed(share(figures[2]), 3)} %: ` +
    `its multiplexer has ${fixed(multiplexer, 0)}, ${fixed(100 * multiplexer / total(figures[2]), 3)} % of the whole. ` +
    `Fig. 2 costs ${fixed(more(figures[1]), 0)} more, ${fixed(share(figures[1]), 1)} %. ` +
    `All in ${figures[0].library} at the same widths of bounded vectors.`;
  const rows = [...stages.map(name => ({ title: title(name), name, values: figures.map(f => area(f, name)) })),
                { title: 'sum', values: figures.map(total) }];
  table('claim-table', rows, [
    ['stage, NAND2', row => row.title],
    ...figures.map((f, i) => [capital(f.name), row => fixed(row.values[i], 0)]),
    ['Fig. 2 – Fig. 1', row => fixed(row.values[1] - row.values[0], 0)],
    ['Fig. 3 – Fig. 1', row => fixed(row.values[2] - row.values[0], 0)],
    ['share of Fig. 3 %', row => fixed(100 * row.values[2] / total(figures[2]), 3)],
  ], row => row.title === 'sum' ? 'sum' : isMultiplexer(row.name) ? 'marked' : '');
}

// The names of the points, where there is room for them.
const pointNames = {
  id: 'pointNames',
  afterDatasetsDraw(chart) {
    const context = chart.ctx, placed = [];
    context.save();
    context.font = `12px ${Chart.defaults.font.family}`;
    context.fillStyle = '#3b4453';
    const points = chart.data.datasets.flatMap((set, i) => chart.isDatasetVisible(i) ? chart.getDatasetMeta(i).data.map((p, k) => [p, set.data[k].name]) : []);
    for (const [p] of points) placed.push([p.x - 7, p.y - 7, p.x + 7, p.y + 7]);
    for (const [p, name] of points) {
      const w = context.measureText(name).width;
      const free = [[p.x + 10, p.y + 4], [p.x - w - 10, p.y + 4], [p.x - w / 2, p.y - 11], [p.x - w / 2, p.y + 20], [p.x - w / 2, p.y - 25], [p.x - w / 2, p.y + 34]]
        .map(([x, y]) => [x, y - 11, x + w, y + 2])
        .find(([x0, y0, x1, y1]) => x0 > chart.chartArea.left && x1 < chart.chartArea.right && y0 > chart.chartArea.top && y1 < chart.chartArea.bottom &&
                                    placed.every(o => x1 < o[0] || x0 > o[2] || y1 < o[1] || y0 > o[3]));
      if (!free) continue;
      placed.push(free);
      context.fillText(name, free[0], free[3] - 2);
    }
    context.restore();
  },
};

// One filter for every choice in which the runs differ; these two are always there.
const mainFilters = ['datapath', 'normalizer_n'];
function startTrade() {
  const keys = [...new Set(runs.flatMap(r => Object.keys(r.choices)))];
  const values = key => [...new Set(runs.map(r => r.choices[key]))];
  const more = create('details');
  more.append(create('summary', 'more filters'));
  for (const key of keys) {
    if (!mainFilters.includes(key) && values(key).length < 2) continue;
    const label = create('label', key.replaceAll('_', ' ') + ' '), select = create('select');
    select.id = 'trade-' + key;
    select.dataset.key = key;
    options(select, ['all', ...values(key)]);
    select.addEventListener('input', drawTrade);
    label.append(select);
    (mainFilters.includes(key) ? element('trade-filters') : more).append(label);
  }
  if (more.children.length > 1) element('trade-filters').append(more);
}

function drawTrade() {
  const filters = [...element('trade-filters').querySelectorAll('select')].filter(s => s.value !== 'all');
  const shown = runs.filter(c => filters.every(s => c.choices[s.dataset.key] === s.value));
  const points = shown.filter(c => c.area);
  const kinds = [...new Set(runs.map(c => c.choices.datapath))];
  const withArea = runs.some(c => c.area);
  element('trade-chart').parentElement.hidden = !withArea;
  element('trade-note').textContent = withArea ? '' : 'Without synthesis there is no area to plot: the precision of each configuration is in the table.';
  chart('trade', {
    type: 'scatter',
    plugins: [pointNames],
    data: {
      datasets: kinds.map((kind, i) => ({
        label: kind, backgroundColor: colours[i % colours.length], pointRadius: 7, pointHoverRadius: 9,
        data: points.filter(c => c.choices.datapath === kind).map(c => ({ x: c.area.nand2, y: c.error.precision.psnr_db, name: c.name, config: c })),
      })),
    },
    options: {
      layout: { padding: { right: 8 } },
      scales: { x: { grace: '6%', title: { display: true, text: 'area, NAND2 equivalents' } }, y: { grace: '8%', title: { display: true, text: 'precision, dB' } } },
      plugins: {
        legend: { position: 'bottom', labels: { boxWidth: 12 } },
        tooltip: { callbacks: { label: ({ raw }) => [
          `${raw.name}: ${fixed(raw.x, 0)} NAND2, ${fixed(raw.y, 1)} dB, ${fixed(raw.config.area.critical_path_ns, 1)} ns`,
          `normalizers ${['n', 'l', 'h'].map(v => raw.config.choices['normalizer_' + v]).join(', ')}; scene ${raw.config.scene}`,
        ] } },
      },
    },
  });
  table('trade-table', shown, [
    ['configuration', c => c.config], ['datapath', c => c.choices.datapath, true], ['normalizer of N', c => c.choices.normalizer_n, true],
    ['scene', c => c.scene, true],
    ...(withArea ? [
      ['NAND2', c => fixed(c.area && c.area.nand2, 0)], ['flip-flops', c => fixed(c.area && c.area.flip_flops, 0)],
      ['critical path ns', c => fixed(c.area && c.area.critical_path_ns, 2)],
      ['clocks equal to the Verilog', c => fixed(c.area?.checked?.clocks, 0)]] : []),
    ['precision dB', c => decibels(c.error.precision.psnr_db)], ['method dB', c => decibels(c.error.method.psnr_db)],
    ['SSIM', c => fixed(c.error.precision.ssim, 5)],
  ]);
  element('trade-left-out').textContent = data.left_out.map(l => `Left out: ${l.name}: ${l.why}`).join('\n');
}

const methodNames = {
  'fig1': 'Fig. 1', 'fig2': 'Fig. 2', 'fig2_held': 'Fig. 2, Pv x N and N x Pu held', 'fig3_eq3-6': 'Fig. 3, Eq. 3-6', 'fig3_eq8-11': 'Fig. 3, Eq. 8-11',
};
const filteringNames = { level0: 'level 0 alone, bilinear', configured: 'as configured' };

function drawTessellation() {
  const rows = data.paper.tessellation.filter(r => filteringNames[r.filtering] === element('tessellation-filtering').value);
  const divisions = [...new Set(rows.map(r => r.divisions))], methods = [...new Set(rows.map(r => r.method))];
  const of = (method, n) => rows.find(r => r.method === method && r.divisions === n);
  chart('tessellation', {
    type: 'line',
    data: {
      labels: divisions.map(n => `${n} x ${n}`),
      datasets: methods.map((m, i) => ({ label: methodNames[m] || m, data: divisions.map(n => of(m, n).psnr_method_db), borderColor: colours[i], backgroundColor: colours[i], pointRadius: 5, tension: 0 })),
    },
    options: {
      scales: { x: { title: { display: true, text: 'squares of the patch, two triangles each' } }, y: { title: { display: true, text: 'against Eq. 1-2, dB' } } },
      plugins: { legend: { position: isNarrow ? 'bottom' : 'right', labels: { boxWidth: 12 } }, tooltip: { callbacks: { label: c => `${c.dataset.label}: ${fixed(c.raw, 2)} dB` } } },
    },
  });
  table('tessellation-table', methods, [
    ['method error, dB', m => methodNames[m] || m], ...divisions.map(n => [`${n} x ${n}`, m => decibels(of(m, n).psnr_method_db)]),
  ]);
}

function drawPaper() {
  if (!data.paper) return;
  const { figures, warp, highlight, held, engine } = data.paper;
  const counted = figures.filter(f => f.mismatches !== undefined);
  element('paper-text').textContent =
    `Fig. 5 is Blinn’s bump mapping, Fig. 6 the multiplexer with normals by Eq. 3-6, Fig. 7 the same by Eq. 8-11; ` +
    `all three drawn by ${engine === 'rtl' ? 'the RTL' : 'the golden model'}. ` +
    (counted.length ? `${fixed(sum(counted, f => f.pixels), 0)} pixels, ${fixed(sum(counted, f => f.mismatches), 0)} that differ from the golden model.` : '');
  const title = p => ({ held_4x4: 'Fig. 2 at 4 x 4, held against interpolated', rotated: 'Rotated frame against Phong', rotated_highlight: 'the same, highlight alone' })[p.a] || pairName(p);
  table('pairs-table', [...pairs, held.pair, highlight.pair, highlight.highlight_pair], [
    ['pictures', title], ['PSNR dB', p => decibels(p.psnr_db)], ['largest difference', p => fixed(p.max, 4)],
    ['p99.9', p => fixed(p.p999, 4)], ['SSIM', p => fixed(p.ssim, 5)], ['pixels', p => fixed(p.pixels, 0)],
  ]);
  options(element('tessellation-filtering'), [...new Set(data.paper.tessellation.map(r => filteringNames[r.filtering]))]);
  element('tessellation-filtering').value = filteringNames.level0;
  element('tessellation-filtering').addEventListener('input', drawTessellation);
  drawTessellation();
  element('paper-others').textContent =
    `Eq. 8-11 take the stretched patch for a square: their normals lean from those of Eq. 3-6 by ${fixed(warp.mean_degrees_bumped, 2)} degrees ` +
    `in the mean where there are bumps, ${fixed(warp.max_degrees, 2)} at most; without rounding the pictures are ${fixed(warp.psnr_exact_db, 2)} dB apart. ` +
    `The rotated frame agrees with Phong shading to ${highlight.exact.map(e => fixed(e.psnr_db, 1)).join(', ')} dB at ` +
    `${highlight.exact.map(e => e.divisions + ' x ' + e.divisions).join(', ')}.`;
}

function drawBudget() {
  const run = runs.find(r => r.name === element('budget-run').value);
  if (!run) return;
  chart('budget', {
    type: 'bar',
    data: { labels: run.error.stages.map(s => s.stage), datasets: [{ label: 'grey levels, RMS', data: run.error.stages.map(s => s.grey.rms), backgroundColor: colours[0], maxBarThickness: 70 }] },
    options: { plugins: { legend: { display: false } }, scales: { x: { grid: { display: false } }, y: { title: { display: true, text: 'grey levels, RMS' } } } },
  });
  const pair = (s, key, digits) => `${fixed(s[key].rms, digits)} / ${fixed(s[key].max, digits)}`;
  table('budget-table', run.error.stages, [
    ['stage (RMS / maximum)', s => s.stage], ['ulp', s => pair(s, 'ulp', 3)], ['degrees', s => pair(s, 'degrees', 4)],
    ['length', s => pair(s, 'length', 5)], ['grey levels', s => pair(s, 'grey', 3)],
    ['alone dB', s => decibels(s.psnr_alone_db)], ['all others dB', s => decibels(s.psnr_without_db)],
  ]);
}

function drawSpeed() {
  if (!data.speed) return;
  const run = data.speed.runs.find(r => r.name === element('speed-run').value);
  const engines = run ? run.engines : [];
  chart('speed', {
    type: 'bar',
    data: { labels: engines.map(e => e.engine), datasets: [{ label: 'pixels per CPU second', data: engines.map(e => e.pixels_per_cpu_s), backgroundColor: colours[3], maxBarThickness: 34 }] },
    options: {
      indexAxis: 'y', plugins: { legend: { display: false } },
      scales: { x: { type: 'logarithmic', ticks: { callback: v => /^10*$/.test(String(v)) ? fixed(v, 0) : '' }, title: { display: true, text: 'pixels per CPU second' } }, y: { grid: { display: false } } },
    },
  });
  table('speed-table', engines, [
    ['engine', e => e.engine], ['pixels per CPU second', e => fixed(e.pixels_per_cpu_s, 0)], ['faithful to', e => e.faithful_to, true],
  ]);
  element('chip').hidden = !data.speed.chips.length;
  table('chip-table', data.speed.chips, [
    ['configuration', c => c.config], ['scene', c => c.scene, true], ['clocks per pixel', c => fixed(c.clocks_per_pixel, 3)],
    ['clock period, ns', c => fixed(c.period_ns, 2)], ['million pixels per second', c => c.pixels_per_s ? fixed(1e-6 * c.pixels_per_s, 1) : ''],
  ]);
}

function startDownloads() {
  for (const [id, type, text] of [['save-csv', 'text/csv', texts.csv], ['save-markdown', 'text/markdown', texts.markdown], ['save-json', 'application/json', JSON.stringify(data, null, 1)]])
    element(id).href = URL.createObjectURL(new Blob([text], { type }));
}

function hideSection(id, hidden) {
  element(id).hidden = hidden;
  document.querySelector(`nav a[href="#${id}"]`).hidden = hidden;
}

function start() {
  // A run without synthesis, pictures of the paper or timing has no such sections.
  hideSection('claim', !figures.length);
  hideSection('paper', !data.paper);
  hideSection('speed', !data.speed);
  drawTiles();
  drawClaim();
  element('claim-given').addEventListener('input', drawClaim);
  startTrade();
  drawTrade();
  startPictures();
  drawPaper();
  options(element('budget-run'), runs.map(r => r.name));
  if (standard) element('budget-run').value = standard.name;
  element('budget-run').addEventListener('input', drawBudget);
  drawBudget();
  if (data.speed) options(element('speed-run'), data.speed.runs.map(r => r.name));
  element('speed-run').addEventListener('input', drawSpeed);
  drawSpeed();
  table('provenance-table', Object.entries(data.provenance), [['', e => e[0]], ['', e => e[1], true]]);
  startDownloads();
}
start();
