'use strict';
// What the pages of this folder share: the data in #report-data, colours, axes, and when charts are drawn again.
const slackwaterPage = (() => {
  const data = JSON.parse(document.getElementById('report-data').textContent);
  const charts = [];
  const root = document.documentElement;
  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  const paletteNow = () => root.dataset.palette ?? (dark.matches ? 'dusk' : 'day');
  let printing = false;

  // Colours are the tokens of the style sheet. Only what tells methods and vehicles apart has more of them by day and
  // dusk, after Okabe and Ito; dashes and shapes tell them apart too.
  const token = (name) => getComputedStyle(root).getPropertyValue(`--${name}`).trim();
  const theme = () => {
    const t = Object.fromEntries(['ink', 'quiet', 'rule', 'paper', 'panel', 'bed', 'alarm', 'amber', 'good'].map((name) => [name, token(name)]));
    const many = paletteNow() === 'night' ? ['ink', 'water', 'wind', 'amber', 'good', 'wave', 'quiet'].map(token)
      : ['#e69f00', '#009e73', '#cc79a7', '#d55e00', '#8f7ae0', '#8a8a8a', '#b8a800'];
    const first = token('accent');
    return {...t, first, truth: t.ink, ramp: [token('ramp-low'), token('ramp-high')], of: (j) => (j % 8 === 0 ? first : many[j % 8 - 1])};
  };
  const dashOf = (j) => ['solid', [7, 3], [2, 2], [9, 3, 2, 3], [12, 4], [4, 4], [5, 2, 2, 2, 2, 2], [1, 3]][j % 8];
  const shapeOf = (j) => ['circle', 'rect', 'triangle', 'diamond', 'pin', 'arrow', 'path://M0,3h3v-3h4v3h3v4h-3v3h-4v-3h-3z', 'roundRect'][j % 8];
  const rgb = (colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
  const lightness = ([red, green, blue]) => 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  /** What can be read on the ramp at this share of it: ink or paper. */
  const onRamp = (t, share) => {
    const [low, high] = t.ramp.map(rgb);
    const ground = lightness(low.map((v, i) => v + (high[i] - v) * share));
    const apart = (colour) => Math.abs(lightness(rgb(colour)) - ground);
    return apart(t.ink) >= apart(t.paper) ? t.ink : t.paper;
  };
  /** What a vehicle does, as a bar: its colour, how high it is, and whether it is hollow. */
  const doingOf = (t, doing) => ({
    way: {fill: t.quiet, share: 0.35}, work: {fill: t.good, share: 1}, hold: {fill: t.paper, stroke: t.amber, share: 1}, home: {fill: t.alarm, share: 0.6},
  })[doing];
  const doingBar = (t, doing, x0, x1, y, height) => {
    const {fill, stroke, share} = doingOf(t, doing);
    const high = Math.max(1, height * share);
    return {type: 'rect', shape: {x: x0, y: y - high / 2, width: Math.max(1, x1 - x0), height: high}, style: {fill, stroke, lineWidth: stroke ? 2 : 0}};
  };

  const pad = (n) => String(n).padStart(2, '0');
  const months = ['Jan', 'Feb', 'Mar', 'Apr', 'May', 'Jun', 'Jul', 'Aug', 'Sep', 'Oct', 'Nov', 'Dec'];
  const days = ['Sun', 'Mon', 'Tue', 'Wed', 'Thu', 'Fri', 'Sat'];
  const clock = (ms) => { const t = new Date(ms); return `${pad(t.getUTCHours())}:${pad(t.getUTCMinutes())}`; };
  const date = (ms) => { const t = new Date(ms); return `${days[t.getUTCDay()]} ${t.getUTCDate()} ${months[t.getUTCMonth()]}`; };
  /** The time of the site's clocks in brackets, where the page knows them. */
  const local = (ms) => {
    if (data.local === undefined) return '';
    const change = data.local.changes.reduce((last, c) => (c[0] <= ms ? c : last), data.local.changes[0]);
    const there = ms + change[1] * 6e4;
    return ` (${date(there) === date(ms) ? '' : `${date(there)} `}${clock(there)} ${change[2]})`;
  };
  const stamp = (ms) => `${date(ms)} ${clock(ms)} UTC${local(ms)}`;
  const fixed = (v, digits) => (v === null || v === undefined ? 'no value' : v.toFixed(digits));
  const bearing = (east, north) => (Math.atan2(east, north) * 180 / Math.PI + 360) % 360;
  const bearingText = (east, north) => `${String(Math.round(bearing(east, north)) % 360).padStart(3, '0')}°`;

  const timeAxis = (t, times, extra) => {
    const hours = (times[times.length - 1] - times[0]) / 3.6e6;
    const slim = window.innerWidth < 600 && !printing;
    const step = (slim ? (hours > 30 ? 24 : 6) : (hours > 60 ? 6 : hours > 30 ? 3 : 2) * (printing ? 2 : 1)) * 3.6e6;
    return Object.assign({
      type: 'value', min: times[0], max: times[times.length - 1], interval: step,
      axisLabel: {color: t.quiet, hideOverlap: true,
        formatter: (ms) => (new Date(ms).getUTCHours() === 0 ? `{day|${date(ms)}}` : clock(ms)),
        rich: {day: {color: t.ink, fontWeight: 'bold'}}},
      axisLine: {lineStyle: {color: t.rule}, onZero: false}, splitLine: {show: false}, axisTick: {show: true},
    }, extra);
  };
  const valueAxis = (t, name, extra) => Object.assign({
    type: 'value', name, nameLocation: 'middle', nameGap: 46, nameTextStyle: {color: t.ink, fontSize: 13},
    axisLabel: {color: t.quiet}, splitLine: {lineStyle: {color: t.rule}}, axisLine: {show: false},
  }, extra);
  /** A line with a head; angle clockwise from north (up), centred on (x, y) in pixels. */
  const arrow = (x, y, length, bearingDeg, color, width) => {
    const a = bearingDeg * Math.PI / 180;
    const dx = Math.sin(a), dy = -Math.cos(a);
    const tip = [x + dx * length / 2, y + dy * length / 2];
    const head = Math.min(5, 2 + length / 4);
    const wing = (s) => [tip[0] - head * (dx + s * 0.6 * -dy), tip[1] - head * (dy + s * 0.6 * dx)];
    return {type: 'group', silent: true, children: [
      {type: 'line', shape: {x1: x - dx * length / 2, y1: y - dy * length / 2, x2: tip[0] - dx * head, y2: tip[1] - dy * head}, style: {stroke: color, lineWidth: width}},
      {type: 'polygon', shape: {points: [tip, wing(1), wing(-1)]}, style: {fill: color}}]};
  };

  const edges = (centres, low, high) => centres.map((c, i) => [
    i === 0 ? low : (centres[i - 1] + c) / 2, i === centres.length - 1 ? high : (c + centres[i + 1]) / 2]);

  const chartOf = (id) => {
    const element = document.getElementById(id);
    if (!element) return null;
    const chart = echarts.init(element, null, {renderer: 'svg'});
    charts.push(chart);
    return {
      getWidth: () => chart.getWidth(), getHeight: () => chart.getHeight(),
      /** Anew, its words in the page's colours. */
      draw: (option) => {
        const t = theme();
        const words = {backgroundColor: t.panel, borderColor: t.quiet, textStyle: {color: t.ink, fontSize: 13}};
        chart.setOption({...option, tooltip: {...option.tooltip, ...words}}, true);
      },
    };
  };

  const drawn = [];
  /** Day, dusk or night, by hand. */
  const choosePalette = (redraw) => {
    const buttons = ['Day', 'Dusk', 'Night'].map((name) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = name;
      button.addEventListener('click', () => { root.dataset.palette = name.toLowerCase(); show(); redraw(); });
      return button;
    });
    const show = () => buttons.forEach((button) => button.setAttribute('aria-pressed', String(button.textContent.toLowerCase() === paletteNow())));
    const group = document.createElement('div');
    group.className = 'choice looks';
    group.setAttribute('role', 'group');
    group.setAttribute('aria-label', 'Palette');
    group.append(...buttons);
    document.querySelector('.site').after(group);
    show();
    dark.addEventListener('change', show);
  };
  /** Draws everything and keeps it drawn through resizing, another palette and printing. */
  const start = () => {
    const redraw = () => drawn.forEach((draw) => draw());
    const resize = () => charts.forEach((chart) => chart.resize());
    choosePalette(redraw);
    redraw();
    window.addEventListener('resize', resize);
    dark.addEventListener('change', redraw);
    // What was folded away had no size to be drawn in.
    document.querySelectorAll('details').forEach((folded) => folded.addEventListener('toggle', resize));
    // Paper is white and cannot wait for an animation frame: sizes and colours are set and drawn at once. A4 less its
    // margins is 700 px wide at 96 dpi.
    let chosen;
    window.addEventListener('beforeprint', () => {
      printing = true;
      chosen = root.dataset.palette;
      root.dataset.palette = 'day';
      charts.forEach((chart) => {
        const element = chart.getDom();
        chart.resize(element.classList.contains('square') ? {width: 335, height: 335}
          : element.id === 'series' ? {width: 700} : {width: 700, height: 300});
      });
      redraw();
      charts.forEach((chart) => chart.getZr().flush());
    });
    window.addEventListener('afterprint', () => {
      printing = false;
      if (chosen === undefined) delete root.dataset.palette;
      else root.dataset.palette = chosen;
      charts.forEach((chart) => chart.resize({width: 'auto', height: 'auto'}));
      redraw();
    });
  };

  return {data, theme, dashOf, shapeOf, onRamp, doingBar, stamp, fixed, bearing, bearingText, timeAxis, valueAxis, arrow, edges, chartOf, drawn, start};
})();
