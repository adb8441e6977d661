'use strict';
// Draws the plots of `simulate --html`.
(() => {
  const {data, theme, dashOf, doingBar, fixed, stamp, valueAxis, chartOf, drawn, start} = slackwaterPage;
  if (!data.vehicles.length) return;
  const choice = document.getElementById('vehicle');
  choice.replaceChildren(...data.vehicles.map((v, i) => new Option(v.name, i)));
  const chosen = () => Number(choice.value);
  const vehicle = () => data.vehicles[chosen()];
  const at = (seconds) => data.epoch + 1000 * seconds;
  const pairs = (values) => data.t.map((t, i) => [at(t), values[i]]);
  const speed = (parts) => parts[0].map((east, i) => (east === null ? null : Math.hypot(east, parts[1][i])));
  const points = (line) => line.x.map((x, i) => [x, line.y[i]]).filter((p) => p[0] !== null && p[1] !== null);
  const tethers = data.plan.map((plan, j) => ({top: plan.tether, j})).filter((x) => x.top);

  const margins = {left: 70, right: 20, top: 44, bottom: 50};
  const begins = ['circle', 'rect', 'triangle', 'diamond'];
  /** Ranges about all that belongs to the run, a metre as long along both axes of this chart. */
  const mapRange = (chart) => {
    const all = [...data.vehicles.flatMap(points), ...data.plan.flatMap(points), ...tethers.map((x) => x.top),
      ...data.structures.flatMap((s) => [-1, 1].map((side) => [s.x + side * s.width / 2, s.y + side * s.length / 2]))];
    const low = [0, 1].map((k) => Math.min(...all.map((p) => p[k])));
    const high = [0, 1].map((k) => Math.max(...all.map((p) => p[k])));
    const wide = Math.max(50, chart.getWidth() - margins.left - margins.right);
    const tall = Math.max(50, chart.getHeight() - margins.top - margins.bottom);
    const metresPerPixel = 1.1 * Math.max((high[0] - low[0]) / wide, (high[1] - low[1]) / tall, 2 / tall);
    return [wide, tall].map((pixels, k) => [(low[k] + high[k] - pixels * metresPerPixel) / 2, (low[k] + high[k] + pixels * metresPerPixel) / 2]);
  };

  const structureSeries = (t) => ({name: 'structures', type: 'custom', z: 1, data: data.structures.map((s, i) => [s.x, s.y, i]), itemStyle: {color: t.quiet},
    renderItem: (_, api) => {
      const s = data.structures[api.value(2)];
      const [x, y] = api.coord([s.x, s.y]);
      const [width, height] = api.size([s.width, s.length]);
      const style = {fill: t.quiet, opacity: 0.45, stroke: t.ink, lineWidth: 1};
      return s.round ? {type: 'circle', shape: {cx: x, cy: y, r: Math.max(3, width / 2)}, style}
        : {type: 'rect', shape: {x: x - width / 2, y: y - height / 2, width, height}, style};
    }});

  const tracksOption = (t, chart) => {
    const [east, north] = mapRange(chart);
    const whole = {color: t.quiet, hideOverlap: true, showMinLabel: false, showMaxLabel: false, formatter: (v) => (+v.toFixed(1)).toString()};
    const bare = {axisLine: {show: false, onZero: false}, axisTick: {show: false}};
    const planned = data.plan.map((plan, j) => ({name: 'planned', type: 'line', z: 2, symbol: 'diamond', symbolSize: 6, data: points(plan),
      itemStyle: {color: t.of(j)}, lineStyle: {color: t.of(j), width: 1.2, type: 'dashed', opacity: 0.8}}));
    const tops = tethers.map(({top, j}) => ({name: 'tether top', type: 'scatter', z: 4, symbol: 'triangle', symbolSize: 12, data: [top], itemStyle: {color: t.of(j), borderColor: t.ink}}));
    return {
      animation: false,
      grid: margins,
      legend: {type: 'scroll', top: 0, textStyle: {color: t.ink}, data: [...data.vehicles.map((v) => v.name), ...(planned.length ? ['planned'] : []),
        ...(tops.length ? ['tether top'] : []), ...(data.structures.length ? ['structures'] : [])]},
      tooltip: {trigger: 'item', formatter: (x) => {
        const name = x.seriesName === 'structures' ? data.structures[x.dataIndex].name : x.seriesName;
        return `${echarts.format.encodeHTML(name)}<br>east ${fixed(x.value[0], 1)} m, north ${fixed(x.value[1], 1)} m`;
      }},
      xAxis: valueAxis(t, 'east (m)', {min: east[0], max: east[1], nameGap: 30, axisLabel: whole, ...bare}),
      yAxis: valueAxis(t, 'north (m)', {min: north[0], max: north[1], axisLabel: whole, ...bare}),
      series: [...(data.structures.length ? [structureSeries(t)] : []),
        ...data.vessels.map((v) => ({name: v.name, type: 'line', showSymbol: true, symbolSize: 3, data: points(v),
          itemStyle: {color: t.quiet}, lineStyle: {color: t.quiet, width: 0.8}})),
        ...planned, ...tops,
        ...data.vehicles.map((v, j) => ({name: v.name, type: 'line', z: 3, showSymbol: true, symbol: begins[j % begins.length],
          symbolSize: (_, p) => (p.dataIndex === 0 ? 12 : 0), data: points(v),
          itemStyle: {color: t.paper, borderColor: t.of(j), borderWidth: 2}, lineStyle: {color: t.of(j), width: 2}}))],
    };
  };

  /** Marks of what happened to the vehicle that is shown. */
  const marks = (t) => {
    const own = data.events.filter((e) => e.vehicle === chosen());
    return {silent: false, symbol: 'none', animation: false, lineStyle: {color: t.quiet, type: 'dotted', width: 1.4},
      label: {show: true, formatter: (x) => x.data.name, color: t.ink, fontSize: 11, rotate: 90, position: 'insideEndTop', distance: 4},
      data: own.map((e) => ({name: e.what, xAxis: at(e.t)}))};
  };

  const doingOf = (phase, doing) => (doing === 'holds' ? 'hold' : doing === 'comes home' ? 'home' : phase === 'work' && !doing ? 'work' : 'way');
  const clock = (ms) => new Date(ms).toISOString().slice(11, 16);
  /** What each vehicle did: a row each, its events above. */
  const timelineOption = (t) => {
    const rows = data.vehicles.map((v, i) => i).filter((i) => data.timeline[i].length);
    const bars = rows.flatMap((i, row) => data.timeline[i].map(([from, to, phase, doing]) => ({value: [at(from), at(to), row], doing: doingOf(phase, doing),
      text: `${data.vehicles[i].name}: ${doing || phase}, ${clock(at(from))} to ${clock(at(to))} UTC`})));
    const marks = data.events.filter((e) => rows.includes(e.vehicle)).map((e) => ({value: [at(e.t), rows.indexOf(e.vehicle)],
      text: `${data.vehicles[e.vehicle].name}: ${e.what}, ${clock(at(e.t))} UTC`}));
    const said = (x) => echarts.format.encodeHTML((x.seriesIndex === 0 ? bars : marks)[x.dataIndex].text);
    return {
      animation: false,
      useUTC: true,
      grid: {left: 110, right: 20, top: 14, bottom: 50},
      tooltip: {trigger: 'item', formatter: said},
      xAxis: {type: 'time', name: 'UTC', nameLocation: 'middle', nameGap: 30, nameTextStyle: {color: t.ink, fontSize: 13}, min: at(data.t[0]), max: at(data.t[data.t.length - 1]),
        axisLabel: {color: t.quiet, hideOverlap: true, formatter: {hour: '{HH}:{mm}', minute: '{HH}:{mm}', second: '{HH}:{mm}:{ss}'}}, axisLine: {lineStyle: {color: t.rule}}, splitLine: {show: false}},
      yAxis: {type: 'category', data: rows.map((i) => data.vehicles[i].name), inverse: true, axisLabel: {color: t.ink, width: 95, overflow: 'truncate'}, axisTick: {show: false}, axisLine: {show: false}},
      series: [{type: 'custom', data: bars, encode: {x: [0, 1], y: 2}, renderItem: (p, api) => {
        const [x0, y] = api.coord([api.value(0), api.value(2)]);
        const [x1] = api.coord([api.value(1), api.value(2)]);
        const height = Math.min(34, api.size([0, 1])[1] * 0.5);
        return doingBar(t, bars[p.dataIndex].doing, x0, x1, y, height);
      }}, {type: 'scatter', symbol: 'pin', symbolSize: 16, symbolOffset: [0, -14], data: marks, itemStyle: {color: t.ink, opacity: 0.7}}],
    };
  };

  /** A bound that belongs to the axis of a line. */
  const bounded = (t, bounds) => ({silent: true, symbol: 'none', lineStyle: {color: t.alarm, type: 'solid', width: 1.5},
    data: bounds.filter(([, bound]) => bound !== undefined).map(([name, bound]) => ({yAxis: bound, label: {color: t.alarm, formatter: `${name} ${+bound.toFixed(2)}`, position: 'insideEndTop'}}))});
  const limits = () => data.limits[chosen()];

  /** Lines over time; those of the second axis carry `right`, those with a bound `bound`. */
  const overTime = (t, lines, left, right) => ({
    animation: false,
    useUTC: true,
    grid: {left: 70, right: right ? 70 : 20, top: 44, bottom: 50},
    legend: {type: 'scroll', top: 0, textStyle: {color: t.ink}, data: lines.map((line) => line.name)},
    tooltip: {trigger: 'axis', formatter: (items) => [`${stamp(items[0].value[0]).replace(' UTC', '')}:${String(new Date(items[0].value[0]).getUTCSeconds()).padStart(2, '0')} UTC`,
      ...items.map((x) => `${x.marker}${x.seriesName} <b>${fixed(x.value[1], 2)}</b>`)].join('<br>')},
    xAxis: {type: 'time', name: 'UTC', nameLocation: 'middle', nameGap: 30, nameTextStyle: {color: t.ink, fontSize: 13}, min: at(data.t[0]), max: at(data.t[data.t.length - 1]),
      axisLabel: {color: t.quiet, hideOverlap: true, formatter: {year: '{d} {MMM}', month: '{d} {MMM}', day: '{d} {MMM}', hour: '{HH}:{mm}', minute: '{HH}:{mm}', second: '{HH}:{mm}:{ss}', millisecond: '{HH}:{mm}:{ss}'}},
      axisLine: {lineStyle: {color: t.rule}, onZero: false}, splitLine: {show: false}},
    yAxis: [valueAxis(t, left, {scale: true}), ...(right ? [valueAxis(t, right, {scale: true, splitLine: {show: false}})] : [])],
    series: lines.map((line, j) => ({name: line.name, type: 'line', showSymbol: false, yAxisIndex: line.right ? 1 : 0, data: pairs(line.values),
      itemStyle: {color: t.of(j)}, lineStyle: {color: t.of(j), width: 1.6, type: line.right ? 'dashed' : line.dash || 'solid'}, ...(line.bound ? {markLine: bounded(t, [line.bound])} : j === 0 ? {markLine: marks(t)} : {})})),
  });
  /** An axis that shows its bound too. */
  const upTo = (option, axis, bound) => {
    if (bound !== undefined) Object.assign(option.yAxis[axis], {scale: false, min: 0, max: (x) => +Math.max(x.max, 1.1 * bound).toPrecision(3)});
    return option;
  };

  const plots = {
    height: (t) => overTime(t, [{name: 'height', values: vehicle().z}, {name: 'off the track', values: vehicle().across, right: true}], 'height (m)', 'off the track (m)'),
    attitude: (t) => overTime(t, [{name: 'roll', values: vehicle().roll}, {name: 'pitch', values: vehicle().pitch}, {name: 'heading', values: vehicle().yaw, right: true}],
      'roll, pitch (degrees)', 'heading (degrees)'),
    thrust: (t) => overTime(t, vehicle().thrust.map((values, k) => ({name: `thruster ${k + 1}`, values, dash: dashOf(k)})), 'thrust (N)'),
    power: (t) => overTime(t, [{name: 'power', values: vehicle().power}, {name: 'state of charge', values: vehicle().charge, right: true},
      {name: 'voltage', values: vehicle().voltage, right: true}], 'power (W)', 'charge (%), voltage (V)'),
    felt: (t) => upTo(upTo(overTime(t, [{name: 'water', values: speed(vehicle().water), bound: limits().current && ['current at most', limits().current]},
      {name: 'wind', values: speed(vehicle().wind), right: true, bound: limits().wind && ['wind at most', limits().wind]}], 'water (m/s)', 'wind (m/s)'), 0, limits().current), 1, limits().wind),
    charge: (t) => {
      const option = overTime(t, [{name: 'state of charge', values: vehicle().charge, bound: limits().reserve && ['reserve', limits().reserve]}], 'charge (%)');
      return Object.assign(option, {yAxis: [Object.assign(option.yAxis[0], {scale: false, min: 0, max: 100})]});
    },
  };

  /** Series by surface and instrument share a colour, a dash tells what was asked for. */
  const asked = (t, j, value, unit) => ({silent: true, symbol: 'none', lineStyle: {color: t.of(j), type: 'dashed', width: 1.4},
    label: {color: t.ink, formatter: `asked ${+value.toFixed(1)} ${unit}`, position: j % 2 ? 'insideStartTop' : 'insideEndTop'}, data: [{yAxis: value}]});
  const dashes = ['solid', 'dashed', 'dotted', [8, 3, 2, 3]];
  const symbols = ['circle', 'rect', 'triangle', 'diamond'];
  const look = (t, j) => ({symbol: symbols[j % symbols.length], symbolSize: 6, itemStyle: {color: t.of(j)}, lineStyle: {color: t.of(j), width: 2, type: dashes[j % dashes.length]}});
  const quality = (t) => ({animation: false, grid: {left: 70, right: 20, top: 44, bottom: 50}, legend: {type: 'scroll', top: 0, textStyle: {color: t.ink}, data: data.coverage.map((c) => c.name)}});
  /** A band is drawn as its lower edge, unseen, and what lies above it. */
  const detailOption = (t) => Object.assign(quality(t), {
    tooltip: {trigger: 'item', formatter: (x) => `${echarts.format.encodeHTML(x.seriesName)}<br>at ${fixed(x.value[0], 2)} m: <b>${fixed(x.value[1], 2)} mm</b>`
      + (x.value[2] === undefined ? '' : ` (P10 ${fixed(x.value[2], 2)}, P90 ${fixed(x.value[3], 2)})`)},
    xAxis: valueAxis(t, 'distance (m)', {scale: true, nameGap: 30}),
    yAxis: valueAxis(t, 'detail (mm)', {type: 'log', min: (x) => 10 ** Math.floor(Math.log10(Math.min(x.min, ...data.coverage.map((c) => c.asked_mm || x.min))) + 1e-9),
      max: (x) => 10 ** Math.ceil(Math.log10(Math.max(x.max, ...data.coverage.map((c) => c.asked_mm || x.max))) - 1e-9)}),
    series: data.coverage.flatMap((c, j) => [
      {name: c.name, type: 'line', z: 3, data: c.range.map(([m, low, mid, high]) => [m, mid, low, high]), ...look(t, j), markLine: asked(t, j, c.asked_mm, 'mm')},
      {name: `${c.name} P10 to P90`, type: 'custom', z: 1, silent: true, data: c.range.length > 1 ? [[c.range[0][0], c.range[0][1]]] : [], renderItem: (_, api) => ({type: 'polygon',
        shape: {points: [...c.range.map((r) => api.coord([r[0], r[1]])), ...c.range.slice().reverse().map((r) => api.coord([r[0], r[3]]))]}, style: {fill: t.of(j), opacity: 0.2}})},
    ]),
  });
  const coveredOption = (t) => Object.assign(overTime(t, [], 'covered (%)'), quality(t), {
    tooltip: {trigger: 'axis', formatter: (items) => [stamp(items[0].value[0]), ...items.map((x) => `${x.marker}${echarts.format.encodeHTML(x.seriesName)} <b>${fixed(x.value[1], 1)} %</b>`)].join('<br>')},
    yAxis: valueAxis(t, 'covered (%)', {min: 0, max: 100}),
    series: data.coverage.map((c, j) => ({name: c.name, type: 'line', ...look(t, j), showSymbol: false, markLine: asked(t, j, c.done_at, '%'),
      data: [[at(data.t[0]), 0], ...c.time.map(([s, share]) => [at(s), share]), ...(c.time.length ? [[at(data.t[data.t.length - 1]), c.time[c.time.length - 1][1]]] : [])]})),
  });
  for (const [id, option] of [['detail-range', detailOption], ['covered-time', coveredOption]]) {
    const chart = chartOf(id);
    if (chart) drawn.push(() => chart.draw(option(theme())));
  }

  const missions = chartOf('missions');
  if (missions) drawn.push(() => missions.draw(timelineOption(theme())));
  const tracks = chartOf('tracks');
  const drawTracks = () => tracks.draw(tracksOption(theme(), tracks));
  drawn.push(drawTracks);
  for (const [id, option] of Object.entries(plots)) {
    const chart = chartOf(id);
    const draw = () => chart.draw(option(theme()));
    drawn.push(draw);
    choice.addEventListener('change', draw);
  }
  start();
  // After the chart has its new size: another shape shows another range.
  window.addEventListener('resize', drawTracks);
})();
