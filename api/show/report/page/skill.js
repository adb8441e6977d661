'use strict';
// Draws the plots of `verify --html`. Arrays over time x depth have depth fastest.
(() => {
  const {data, theme, dashOf, shapeOf, stamp, fixed, bearingText, timeAxis, valueAxis, edges, chartOf, drawn, start} = slackwaterPage;
  if (!data.policies.length) return;
  const policyChoice = document.getElementById('policy');
  const trackChoice = document.getElementById('track');
  const fill = (select, labels, chosen) => {
    select.replaceChildren(...labels.map((label, i) => new Option(label, i, i === chosen, i === chosen)));
  };
  const policy = () => data.policies[Number(policyChoice.value)];
  const track = () => policy().tracks[Number(trackChoice.value)];

  const leadOption = (t) => {
    const lines = policy().lines;
    const first = lines[0];
    const last = Math.max(...lines.flatMap((line) => line.lead));
    const band = first ? first.lead.map((h, i) => [h, first.low[i], first.high[i]]).filter((x) => x[1] !== null) : [];
    return {
      animation: false,
      grid: {left: 70, right: 20, top: 56, bottom: 50},
      legend: {type: 'scroll', top: 0, left: 60, right: 10, textStyle: {color: t.ink}, data: lines.map((line) => line.method)},
      tooltip: {trigger: 'axis', formatter: (items) => {
        const rows = items.filter((x) => x.seriesName !== 'interval').sort((a, b) => a.value[1] - b.value[1])
          .map((x) => `${x.marker}${echarts.format.encodeHTML(x.seriesName)} <b>${fixed(x.value[1], 3)} m/s</b>`);
        return `lead ${items[0].value[0]} h<br>${rows.join('<br>')}`;
      }},
      xAxis: valueAxis(t, 'lead (hours after the end of day D)', {min: 0, max: last, interval: last > 36 ? 6 : 3, nameGap: 30}),
      yAxis: valueAxis(t, 'vector RMSE (m/s), lower is better', {min: 0}),
      series: [
        ...(band.length > 1 ? [{name: 'interval', type: 'custom', silent: true, z: 1, data: [[band[0][0], band[0][1]]], tooltip: {show: false},
          renderItem: (_, api) => ({type: 'polygon', silent: true, style: {fill: t.first, opacity: 0.2},
            shape: {points: band.map((x) => [x[0], x[2]]).concat(band.map((x) => [x[0], x[1]]).reverse()).map((x) => api.coord(x))}})}] : []),
        ...lines.map((line, j) => ({name: line.method, type: 'line', data: line.lead.map((h, i) => [h, line.rmse[i]]),
          symbol: shapeOf(j), symbolSize: line.lead.length > 30 ? 0 : 7, z: j === 0 ? 5 : 3, itemStyle: {color: t.of(j)},
          lineStyle: {color: t.of(j), width: j === 0 ? 3 : 1.6, type: dashOf(j)}})),
      ],
    };
  };

  const percent = (t, name, extra) => valueAxis(t, name, {min: 0, max: 100, interval: 25, nameGap: 34, axisLine: {show: true, lineStyle: {color: t.quiet}}, ...extra});
  const reliabilityOption = (t) => {
    const p = policy();
    return {
      animation: false,
      title: {text: p.probability.length ? 'Reliability diagram' : 'No spread to judge', left: 'center', textStyle: {color: t.ink, fontSize: 14}},
      grid: {left: 72, right: 42, top: 52, bottom: 62},
      tooltip: {trigger: 'item', formatter: (x) => (x.seriesName === 'honest' ? '' : `${x.value[0].toFixed(0)} % quantile: truth below it in ${x.value[1].toFixed(1)} %`)},
      xAxis: percent(t, 'forecast quantile (%)'),
      yAxis: percent(t, 'truth below it (%)', {nameGap: 44}),
      series: [
        {name: 'honest', type: 'line', silent: true, showSymbol: false, data: [[0, 0], [100, 100]], lineStyle: {color: t.quiet, type: 'dashed', width: 1.2}},
        {name: 'forecast', type: 'line', data: p.probability.map((x, i) => [100 * x, 100 * p.below[i]]), symbol: 'circle', symbolSize: 9,
          itemStyle: {color: t.first}, lineStyle: {color: t.first, width: 2}},
      ],
    };
  };
  const pitOption = (t) => {
    const pit = policy().pit;
    const width = 100 / Math.max(1, pit.length);
    return {
      animation: false,
      title: {text: 'Where the truth fell', left: 'center', textStyle: {color: t.ink, fontSize: 14}},
      grid: {left: 72, right: 42, top: 52, bottom: 62},
      tooltip: {trigger: 'item', formatter: (x) => `${x.name} % of the distribution: ${x.value.toFixed(1)} % of truths`},
      xAxis: {type: 'category', data: pit.map((_, i) => `${(i * width).toFixed(0)}–${((i + 1) * width).toFixed(0)}`), name: 'part of the forecast distribution (%)', nameLocation: 'middle', nameGap: 34,
        nameTextStyle: {color: t.ink, fontSize: 13}, axisLabel: {color: t.quiet, fontSize: 10}, axisLine: {lineStyle: {color: t.rule}}, axisTick: {show: false}},
      yAxis: valueAxis(t, 'share of truths (%)', {min: 0, nameGap: 44}),
      series: [{type: 'bar', barWidth: '92%', itemStyle: {color: t.first}, data: pit.map((x) => 100 * x),
        markLine: {silent: true, symbol: 'none', label: {formatter: 'ideal', color: t.ink, position: 'insideEndTop'}, lineStyle: {color: t.ink, type: 'dashed'}, data: [{yAxis: width}]}}],
    };
  };

  const hodographOption = (t, j) => {
    const p = track();
    const n = p.drawn.length;
    const begin = p.time.length ? p.time[0] - 3.6e6 : 0;
    const path = (vectors) => p.time.map((ms, i) => [vectors.east[i * n + j], vectors.north[i * n + j], ms]).filter((x) => x[0] !== null && x[1] !== null);
    const forecast = path(p.forecast), truth = path(p.truth);
    // Both axes have one scale, and all depths the same: directions on the page are directions on the chart.
    const all = p.forecast.east.concat(p.forecast.north, p.truth.east, p.truth.north).filter((x) => x !== null);
    const reach = Math.max(0.05, ...all.map(Math.abs));
    const step = [0.02, 0.05, 0.1, 0.2, 0.25, 0.5, 1].find((s) => 2 * reach / s <= 8) || 2;
    const half = Math.ceil(1.05 * reach / step) * step;
    const axis = (name) => valueAxis(t, name, {min: -half, max: half, interval: step, nameGap: 36, axisLabel: {color: t.quiet, hideOverlap: true, formatter: (x) => (+x.toFixed(2)).toString()},
      axisLine: {show: true, onZero: true, lineStyle: {color: t.quiet}}, axisTick: {show: false}});
    const hours = (ms) => Math.round((ms - begin) / 3.6e6);
    const labelled = (x, i) => i > 0 && hours(x[2]) % 6 === 0;
    const series = (name, points, color, dashed) => ({name, type: 'line', data: points, symbol: 'circle', symbolSize: (value, item) => (item.dataIndex === 0 ? 9 : labelled(value, item.dataIndex) ? 5 : 0), showAllSymbol: true,
      itemStyle: {color: dashed ? t.paper : color, borderColor: color, borderWidth: 1.5}, lineStyle: {color, width: dashed ? 1.5 : 2, type: dashed ? 'dashed' : 'solid'},
      label: {show: !dashed, color: t.ink, fontSize: 10, position: 'right', formatter: (item) => (labelled(item.value, item.dataIndex) ? `${hours(item.value[2])} h` : '')}, labelLayout: {hideOverlap: true}});
    return {
      animation: false,
      title: {text: `${p.drawn[j]} m below mean sea level`, left: 'center', textStyle: {color: t.ink, fontSize: 14}},
      legend: {top: 34, left: 'center', data: ['forecast', 'truth'], textStyle: {color: t.ink}, itemWidth: 26},
      grid: {left: 62, right: 32, top: 66, bottom: 48},
      tooltip: {trigger: 'item', formatter: (item) => `${item.seriesName}, valid ${stamp(item.value[2])}<br>east ${item.value[0].toFixed(3)}, north ${item.value[1].toFixed(3)} m/s<br><b>${Math.hypot(item.value[0], item.value[1]).toFixed(3)} m/s to ${bearingText(item.value[0], item.value[1])}</b>`},
      xAxis: axis('east (m/s)'), yAxis: {...axis('north (m/s)'), nameGap: 42},
      series: [series('truth', truth, t.truth, true), series('forecast', forecast, t.first, false)],
    };
  };

  /** Cells of time (or lead) x depth coloured by their error. */
  const misfitOption = (t, x, across, depth, bed, misfit, xAxis, name) => {
    const n = depth.length;
    const deepest = Math.max(bed, n ? depth[n - 1] : 1);
    const down = edges(depth, 0, deepest);
    const cells = [];
    x.forEach((at, i) => depth.forEach((d, k) => { if (misfit[i * n + k] !== null) cells.push([at, d, misfit[i * n + k], i, k]); }));
    const top = Math.max(0.02, Math.ceil(Math.max(0, ...cells.map((c) => c[2])) * 50) / 50);
    return {
      animation: false,
      grid: {left: 70, right: 110, top: 18, bottom: 50},
      tooltip: {trigger: 'item', formatter: (item) => `${name(item.value[0])}<br>${item.value[1]} m below mean sea level<br><b>${item.value[2].toFixed(3)} m/s</b> off`},
      xAxis,
      yAxis: valueAxis(t, bed > 0 ? `depth (m), bed at ${+bed.toFixed(1)}` : 'depth (m)', {inverse: true, min: 0, max: deepest, splitLine: {show: false}, axisLabel: {color: t.quiet, showMaxLabel: false}}),
      visualMap: {type: 'continuous', min: 0, max: top, dimension: 2, calculable: false, right: 8, top: 'middle', itemHeight: 240, itemWidth: 16,
        text: [`${top.toFixed(2)} m/s`, '0 m/s'], textStyle: {color: t.ink}, inRange: {color: t.ramp}},
      series: [{type: 'custom', data: cells, dimensions: ['x', 'depth', 'misfit', 'i', 'k'], encode: {x: 0, y: 1}, clip: true, progressive: 0,
        renderItem: (_, api) => {
          const i = api.value(3), k = api.value(4);
          const a = api.coord([across[i][0], down[k][0]]), b = api.coord([across[i][1], down[k][1]]);
          return {type: 'rect', shape: {x: a[0], y: a[1], width: b[0] - a[0] + 0.6, height: b[1] - a[1] + 0.6}, style: {fill: api.visual('color')}};
        }}],
    };
  };

  const stepOf = (x) => (x.length > 1 ? x[1] - x[0] : 1);
  /** Valid times are the middles of their cells; the axis runs over whole hours. */
  const timeMisfitOption = (t, p) => {
    const half = stepOf(p.time) / 2, hour = 3.6e6;
    const across = edges(p.time, p.time[0] - half, p.time[p.time.length - 1] + half);
    const whole = [Math.floor(across[0][0] / hour) * hour, Math.ceil(across[across.length - 1][1] / hour) * hour];
    return misfitOption(t, p.time, across, p.depth, p.bed, p.misfit, timeAxis(t, whole), (ms) => `valid ${stamp(ms)}`);
  };
  /** An hour of lead stands for the hour that it ends. */
  const leadMisfitOption = (t, p) => {
    const step = stepOf(p.lead);
    const axis = valueAxis(t, 'lead (hours after the end of day D)', {min: 0, max: Math.max(1, ...p.lead), interval: 6, nameGap: 30, splitLine: {show: false}});
    return misfitOption(t, p.lead, p.lead.map((h) => [Math.max(0, h - step), h]), p.depth, p.bed, p.misfit, axis, (h) => `lead ${h} h`);
  };

  const show = (id, shown) => { document.getElementById(id).style.display = shown ? '' : 'none'; };
  const byLead = chartOf('skill-by-lead'), reliability = chartOf('reliability'), pit = chartOf('pit');
  const hodographs = [0, 1, 2, 3].map((j) => chartOf(`hodograph-${j}`));
  const misfit = chartOf('misfit'), pooled = chartOf('pooled-misfit');
  const drawTrack = () => {
    const t = theme(), p = track();
    hodographs.forEach((chart, j) => {
      const shown = p !== undefined && j < p.drawn.length;
      show(`hodograph-${j}`, shown);
      if (shown) chart.draw(hodographOption(t, j));
    });
    show('misfit-section', p !== undefined);
    if (p) misfit.draw(timeMisfitOption(t, p));
  };
  const drawPolicy = () => {
    const t = theme(), p = policy();
    byLead.draw(leadOption(t));
    reliability.draw(reliabilityOption(t));
    pit.draw(pitOption(t));
    pooled.draw(leadMisfitOption(t, p.pooled));
  };
  const fillTracks = () => fill(trackChoice, policy().tracks.map((x) => x.label), policy().tracks.length - 1);

  fill(policyChoice, data.policies.map((p) => p.wind), 0);
  fillTracks();
  policyChoice.addEventListener('change', () => { fillTracks(); drawPolicy(); drawTrack(); });
  trackChoice.addEventListener('change', drawTrack);
  drawn.push(drawPolicy, drawTrack);
  start();
})();
