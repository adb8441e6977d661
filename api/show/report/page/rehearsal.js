'use strict';
// Draws the plots of `rehearse --html`.
(() => {
  const {data, theme, dashOf, doingBar, fixed, valueAxis, chartOf, drawn, start: begin} = slackwaterPage;
  if (!data.starts.length) return;
  const startChoice = document.getElementById('start');
  const vehicleChoice = document.getElementById('vehicle');
  startChoice.replaceChildren(...data.starts.map((s, i) => new Option(s.label, i)));
  startChoice.value = data.best;
  vehicleChoice.replaceChildren(...data.starts[0].vehicles.map((v, i) => new Option(v.name, i)));
  const chosen = () => data.starts[Number(startChoice.value)];
  const vehicle = () => chosen().vehicles[Number(vehicleChoice.value)];
  const minutes = (sample) => sample * data.every_s / 60;
  const doingOf = ([, , phase, doing]) => (doing === 1 ? 'hold' : doing === 3 ? 'home' : phase === 2 && doing === 0 ? 'work' : 'way');
  const words = ['transit', 'launch', 'work', 'recovery', 'return'];
  const doings = ['', 'holding', 'going back to its work', 'called home'];

  const timelineOption = (t) => {
    const flights = [...vehicle().flights].sort((a, b) => a.done - b.done || a.member - b.member);
    const rows = flights.map((f) => `${f.member}${f.done ? '' : ` ${f.stopped_by}`}`);
    const bars = flights.flatMap((f, row) => f.stretches.map((s) => ({value: [minutes(s[0]), minutes(s[1]), row], doing: doingOf(s),
      text: `future ${f.member}: ${s[3] === 0 ? words[s[2]] : doings[s[3]]}, ${fixed(minutes(s[0]), 0)} to ${fixed(minutes(s[1]), 0)} min`})));
    return {
      animation: false,
      grid: {left: 170, right: 20, top: 10, bottom: 46},
      tooltip: {trigger: 'item', formatter: (x) => echarts.format.encodeHTML(bars[x.dataIndex].text)},
      xAxis: valueAxis(t, 'minutes since the start', {min: 0, max: minutes(Math.max(...flights.flatMap((f) => f.stretches.map((s) => s[1])))), nameGap: 30}),
      yAxis: {type: 'category', data: rows, inverse: true, axisLabel: {color: t.quiet, width: 155, overflow: 'truncate', fontSize: 11}, axisTick: {show: false}, axisLine: {show: false}},
      series: [{type: 'custom', data: bars, renderItem: (p, api) => {
        const [x0, y] = api.coord([api.value(0), api.value(2)]);
        const [x1] = api.coord([api.value(1), api.value(2)]);
        const height = Math.min(40, Math.max(2, api.size([0, 1])[1] * 0.72));
        return doingBar(t, bars[p.dataIndex].doing, x0, x1, y, height);
      }, encode: {x: [0, 1], y: 2}}],
    };
  };

  const margins = {left: 70, right: 20, top: 34, bottom: 50};
  const planOption = (t, chart) => {
    const points = (track) => track.x.map((x, i) => [x, track.y[i]]);
    const lines = chosen().vehicles.flatMap((v, j) => v.tracks.map((track) => ({name: v.name, done: track.done, j, points: points(track)})));
    const tethers = chosen().vehicles.map((v, j) => ({j, top: v.tether, ways: lines.filter((l) => l.j === j)})).filter((x) => x.top);
    const farthest = ({top, ways}) => ways.flatMap((l) => l.points).filter((p) => p[0] !== null)
      .reduce((far, p) => (Math.hypot(p[0] - top[0], p[1] - top[1]) > Math.hypot(far[0] - top[0], far[1] - top[1]) ? p : far), top);
    const near = [...lines.flatMap((l) => l.points), ...tethers.map((x) => x.top)];
    const low = [0, 1].map((k) => Math.min(...near.map((p) => p[k])));
    const high = [0, 1].map((k) => Math.max(...near.map((p) => p[k])));
    const sides = [chart.getWidth() - margins.left - margins.right, chart.getHeight() - margins.top - margins.bottom].map((s) => Math.max(50, s));
    const scale = 1.15 * Math.max((high[0] - low[0] + 12) / sides[0], (high[1] - low[1] + 12) / sides[1]);
    const range = (k) => ({min: (low[k] + high[k] - sides[k] * scale) / 2, max: (low[k] + high[k] + sides[k] * scale) / 2});
    const label = {color: t.quiet, showMinLabel: false, showMaxLabel: false, hideOverlap: true, formatter: (v) => String(+v.toFixed(1))};
    return {
      animation: false,
      grid: margins,
      legend: {type: 'scroll', top: 0, textStyle: {color: t.ink}, data: chosen().vehicles.map((v) => v.name)},
      tooltip: {trigger: 'item', formatter: (x) => `${echarts.format.encodeHTML(x.seriesName)}<br>east ${fixed(x.value[0], 1)} m, north ${fixed(x.value[1], 1)} m`},
      xAxis: valueAxis(t, 'east (m)', {...range(0), nameGap: 30, axisLabel: label}),
      yAxis: valueAxis(t, 'north (m)', {...range(1), axisLabel: label}),
      series: [
        {name: 'foundations', type: 'custom', z: 1, data: data.structures.map((s, i) => [s.x, s.y, i]), renderItem: (_, api) => {
          const s = data.structures[api.value(2)];
          const [cx, cy] = api.coord([s.x, s.y]);
          return {type: 'circle', shape: {cx, cy, r: Math.max(3, api.size([s.width, s.width])[0] / 2)}, style: {fill: t.quiet, opacity: 0.45, stroke: t.ink}};
        }},
        ...data.vessels.map((v) => ({name: v.name, type: 'line', symbolSize: 3, data: points(v), itemStyle: {color: t.quiet}, lineStyle: {color: t.quiet, width: 0.8}})),
        ...tethers.map((x) => ({name: 'tether', type: 'line', symbol: (_, p) => (p.dataIndex === 0 ? 'triangle' : 'none'), symbolSize: 12, data: [x.top, farthest(x)],
          itemStyle: {color: t.of(x.j), borderColor: t.ink}, lineStyle: {color: t.of(x.j), width: 1, type: 'dashed'}})),
        ...lines.map((l) => ({name: l.name, type: 'line', symbol: 'none', data: l.points,
          itemStyle: {color: t.of(l.j)}, lineStyle: {color: t.of(l.j), width: 1.3, opacity: 0.6, type: l.done ? 'solid' : 'dotted'}})),
      ],
    };
  };

  /** A band from P10 to P90 with its middle. */
  const band = (name, colour, bands) => {
    const at = (values) => values.map((v, i) => [minutes(i), v]);
    return [
      {name: `${name} P10`, type: 'line', symbol: 'none', stack: name, lineStyle: {opacity: 0}, data: at(bands.p10), silent: true, tooltip: {show: false}},
      {name: `${name} P90`, type: 'line', symbol: 'none', stack: name, lineStyle: {opacity: 0}, areaStyle: {color: colour, opacity: 0.25}, silent: true,
        data: at(bands.p90.map((v, i) => (v === null ? null : v - bands.p10[i])))},
      {name, type: 'line', symbol: 'none', lineStyle: {color: colour, width: 2}, itemStyle: {color: colour}, data: at(bands.p50)},
    ];
  };
  const felt = (name, unit, key) => (t) => {
    const bound = vehicle().bounds[key];
    const lines = band(name, t.first, vehicle()[key]);
    if (bound !== undefined)
      lines[2].markLine = {silent: true, symbol: 'none', lineStyle: {color: t.alarm, type: 'solid', width: 1.5}, label: {color: t.alarm, formatter: `limit ${bound}`, position: 'insideEndTop'}, data: [{yAxis: bound}]};
    return {
      animation: false,
      grid: {left: 70, right: 20, top: 20, bottom: 46},
      tooltip: {trigger: 'axis', formatter: (xs) => xs.filter((x) => x.seriesName === name).map((x) => `${fixed(x.value[0], 0)} min: ${fixed(x.value[1], 2)} ${unit}`).join('')},
      xAxis: valueAxis(t, 'minutes since the start', {min: 0, nameGap: 30}),
      yAxis: valueAxis(t, `${name} (${unit})`, {min: 0, max: bound === undefined ? null : (x) => +Math.max(x.max, 1.1 * bound).toPrecision(3)}),
      series: lines,
    };
  };
  const reserveOption = (t) => ({
    animation: false,
    grid: {left: 70, right: 20, top: 34, bottom: 46},
    legend: {top: 0, textStyle: {color: t.ink}, data: ['charge left', 'charge needed']},
    tooltip: {trigger: 'axis', formatter: (xs) => xs.filter((x) => !/P\d0$/.test(x.seriesName)).map((x) => `${x.seriesName} ${fixed(x.value[1], 0)} %`).join('<br>')},
    xAxis: valueAxis(t, 'minutes since the start', {min: 0, nameGap: 30}),
    yAxis: valueAxis(t, 'charge (%)', {min: 0, max: 100}),
    series: [...band('charge left', t.first, vehicle().charge), ...band('charge needed', t.alarm, vehicle().needed)],
  });

  const coveredOption = (t) => {
    const {in: flow, points} = vehicle().covered || {in: 'current', points: []};
    const begun = points.filter((p) => p[0] !== null);
    const around = (values, step) => (values.length ? {min: Math.max(0, Math.floor(Math.min(...values) / step - 1) * step), max: Math.ceil(Math.max(...values) / step + 1) * step} : {min: 0, max: 1});
    const speeds = around(begun.map((p) => p[0]), flow === 'wind' ? 1 : 0.05), shares = around(points.map((p) => p[1]), 5);
    const never = points.filter((p) => p[0] === null).map((p) => [speeds.min, p[1], p[2]]);
    const text = (x) => `future ${x.value[2]}: ${fixed(x.value[1], 1)} % covered${x.seriesName === 'begun' ? ` in ${fixed(x.value[0], 2)} m/s` : ', its work never began'}`;
    const dots = {symbolSize: 10, itemStyle: {color: t.first, opacity: 0.75, borderColor: t.ink, borderWidth: 0.6}};
    return {
      animation: false,
      grid: {left: 70, right: 20, top: 20, bottom: 46},
      title: {show: points.length === 0, text: `${vehicle().name} inspects nothing`, left: 'center', top: 'middle', textStyle: {color: t.quiet, fontSize: 14, fontWeight: 'normal'}},
      tooltip: {trigger: 'item', formatter: text},
      xAxis: valueAxis(t, `mean ${flow} felt at work (m/s)`, {nameGap: 30, ...speeds}),
      yAxis: valueAxis(t, 'covered (%)', {min: shares.min, max: points.length ? Math.min(100, shares.max) : 100}),
      series: [{name: 'begun', type: 'scatter', data: begun, ...dots}, {name: 'never begun', type: 'scatter', symbol: 'triangle', data: never, ...dots}],
    };
  };

  const plots = {timeline: timelineOption, plan: planOption, reserve: reserveOption, covered: coveredOption, current: felt('current', 'm/s', 'current'), wind: felt('wind', 'm/s', 'wind'), waves: felt('wave height', 'm', 'waves')};
  Object.entries(plots).forEach(([id, option]) => {
    const chart = chartOf(id);
    if (!chart) return;
    drawn.push(() => chart.draw(option(theme(), chart)));
  });
  const verdict = document.getElementById('start-verdict');
  drawn.push(() => { verdict.textContent = chosen().verdict; });
  [startChoice, vehicleChoice].forEach((choice) => choice.addEventListener('change', () => drawn.forEach((draw) => draw())));
  begin();
})();
