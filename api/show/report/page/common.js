'use strict';
// What the pages of this folder share: the data in #report-data, colours, axes, and when charts are drawn again.
const slackwaterPage = (() => {
  const data = JSON.parse(document.getElementById('report-data').textContent);
  const charts = [];
  const viridis = ['#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b', '#fde725'];
  // After Okabe and Ito, told apart by colour-blind readers; the forecast takes the first.
  const palette = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#d55e00', '#8f7ae0', '#8a8a8a', '#b8a800'];
  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  let printing = false;

  const theme = () => {
    const night = dark.matches && !printing;
    return night
      ? {ink: '#e4eaf0', quiet: '#9fb0c0', rule: '#33404d', paper: '#12181f', first: '#56b4e9', truth: '#ffffff', slack: '#2f7d5b'}
      : {ink: '#16202b', quiet: '#566575', rule: '#d5dce3', paper: '#ffffff', first: '#0072b2', truth: '#000000', slack: '#9fd8b8'};
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
    return chart;
  };

  const drawn = [];
  /** Draws everything and keeps it drawn through resizing, a change of colour scheme and printing. */
  const start = () => {
    const redraw = () => drawn.forEach((draw) => draw());
    const resize = () => charts.forEach((chart) => chart.resize());
    redraw();
    window.addEventListener('resize', resize);
    dark.addEventListener('change', redraw);
    // What was folded away had no size to be drawn in.
    document.querySelectorAll('details').forEach((folded) => folded.addEventListener('toggle', resize));
    // Paper cannot wait for an animation frame: sizes and colours are set and drawn at once. A4 less its margins is
    // 700 px wide at 96 dpi.
    window.addEventListener('beforeprint', () => {
      printing = true;
      charts.forEach((chart) => {
        const element = chart.getDom();
        chart.resize(element.classList.contains('square') ? {width: 335, height: 335}
          : element.id === 'series' ? {width: 700} : {width: 700, height: 300});
      });
      redraw();
      charts.forEach((chart) => chart.getZr().flush());
    });
    window.addEventListener('afterprint', () => { printing = false; charts.forEach((chart) => chart.resize({width: 'auto', height: 'auto'})); redraw(); });
  };

  return {data, viridis, palette, theme, stamp, fixed, bearing, bearingText, timeAxis, valueAxis, arrow, edges, chartOf, drawn, start};
})();
