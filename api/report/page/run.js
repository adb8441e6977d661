'use strict';
// Draws the plots of `simulate --html`.
(() => {
  const {data, palette, theme, fixed, valueAxis, chartOf, drawn, start} = slackwaterPage;
  if (!data.vehicles.length) return;
  const choice = document.getElementById('vehicle');
  choice.replaceChildren(...data.vehicles.map((v, i) => new Option(v.name, i)));
  const vehicle = () => data.vehicles[Number(choice.value)];
  const pairs = (values) => data.t.map((t, i) => [t, values[i]]);
  const speed = (parts) => parts[0].map((east, i) => (east === null ? null : Math.hypot(east, parts[1][i])));

  const tracksOption = (t) => {
    const all = data.vehicles.flatMap((v) => v.x.map((x, i) => [x, v.y[i]])).filter((p) => p[0] !== null);
    const low = [0, 1].map((k) => Math.min(...all.map((p) => p[k])));
    const high = [0, 1].map((k) => Math.max(...all.map((p) => p[k])));
    // A metre is as long along both axes: the wider one says how wide. Charts here are about two and a half times as wide as high.
    const half = 0.55 * Math.max((high[0] - low[0]) / 2.5, high[1] - low[1], 1);
    const middle = [0, 1].map((k) => (low[k] + high[k]) / 2);
    return {
      animation: false,
      grid: {left: 70, right: 20, top: 40, bottom: 50},
      legend: {top: 0, textStyle: {color: t.ink}, data: data.vehicles.map((v) => v.name)},
      tooltip: {trigger: 'item', formatter: (x) => `${echarts.format.encodeHTML(x.seriesName)}<br>east ${fixed(x.value[0], 1)} m, north ${fixed(x.value[1], 1)} m`},
      xAxis: valueAxis(t, 'east (m)', {min: middle[0] - 2.5 * half, max: middle[0] + 2.5 * half, nameGap: 30, axisLabel: {color: t.quiet, formatter: (v) => v.toFixed(0)}}),
      yAxis: valueAxis(t, 'north (m)', {min: middle[1] - half, max: middle[1] + half, axisLabel: {color: t.quiet, formatter: (v) => v.toFixed(0)}}),
      series: [...data.vessels.map((v) => ({name: v.name, type: 'line', showSymbol: true, symbolSize: 3, data: v.x.map((x, i) => [x, v.y[i]]),
        itemStyle: {color: t.quiet}, lineStyle: {color: t.quiet, width: 0.8}})), ...data.vehicles.map((v, j) => ({name: v.name, type: 'line', showSymbol: true, symbol: 'emptyCircle',
        symbolSize: (_, p) => (p.dataIndex === 0 ? 12 : 0), data: v.x.map((x, i) => [x, v.y[i]]),
        itemStyle: {color: palette[j % palette.length]}, lineStyle: {color: palette[j % palette.length], width: 2}}))],
    };
  };

  /** Lines over time; those of the second axis carry `right`. */
  const overTime = (t, lines, left, right) => ({
    animation: false,
    grid: {left: 70, right: right ? 70 : 20, top: 40, bottom: 50},
    legend: {top: 0, textStyle: {color: t.ink}, data: lines.map((line) => line.name)},
    tooltip: {trigger: 'axis', formatter: (items) => [`${fixed(items[0].value[0], 1)} s`,
      ...items.map((x) => `${x.marker}${x.seriesName} <b>${fixed(x.value[1], 2)}</b>`)].join('<br>')},
    xAxis: valueAxis(t, 'time since the start (s)', {min: data.t[0], max: data.t[data.t.length - 1], nameGap: 30}),
    yAxis: [valueAxis(t, left, {scale: true}), ...(right ? [valueAxis(t, right, {scale: true, splitLine: {show: false}})] : [])],
    series: lines.map((line, j) => ({name: line.name, type: 'line', showSymbol: false, yAxisIndex: line.right ? 1 : 0, data: pairs(line.values),
      itemStyle: {color: palette[j % palette.length]}, lineStyle: {color: palette[j % palette.length], width: 1.6, type: line.right ? 'dashed' : 'solid'}})),
  });

  const plots = {
    height: (t) => overTime(t, [{name: 'height', values: vehicle().z}, {name: 'off the track', values: vehicle().across, right: true}], 'height (m)', 'off the track (m)'),
    attitude: (t) => overTime(t, [{name: 'roll', values: vehicle().roll}, {name: 'pitch', values: vehicle().pitch}, {name: 'heading', values: vehicle().yaw, right: true}],
      'roll, pitch (degrees)', 'heading (degrees)'),
    thrust: (t) => overTime(t, vehicle().thrust.map((values, k) => ({name: `thruster ${k + 1}`, values})), 'thrust (N)'),
    power: (t) => overTime(t, [{name: 'power', values: vehicle().power}, {name: 'state of charge', values: vehicle().charge, right: true},
      {name: 'voltage', values: vehicle().voltage, right: true}], 'power (W)', 'charge (%), voltage (V)'),
    felt: (t) => overTime(t, [{name: 'water', values: speed(vehicle().water)}, {name: 'wind', values: speed(vehicle().wind), right: true}], 'water (m/s)', 'wind (m/s)'),
  };

  const tracks = chartOf('tracks');
  drawn.push(() => tracks.setOption(tracksOption(theme()), true));
  for (const [id, option] of Object.entries(plots)) {
    const chart = chartOf(id);
    const draw = () => chart.setOption(option(theme()), true);
    drawn.push(draw);
    choice.addEventListener('change', draw);
  }
  start();
})();
