'use strict';
// Draws the report's plots with ECharts. Arrays over time x depth have depth fastest.
(() => {
  const {data, theme, dashOf, onRamp, stamp, fixed, bearing, bearingText, timeAxis, valueAxis, arrow, edges, chartOf, drawn, start} = slackwaterPage;

  const issuedLine = (t, times, position = 'insideEndTop', halo = {}) => (data.issued === undefined || data.issued < times[0] || data.issued > times[times.length - 1]
    ? undefined
    : {silent: true, symbol: 'none', lineStyle: {color: t.ink, type: 'dashed', width: 1.5, ...halo},
      label: {formatter: 'issued', color: t.ink, textBorderColor: t.paper, textBorderWidth: 3, position}, data: [{xAxis: data.issued}]});

  const narrow = () => window.innerWidth < 600;

  const speedOption = (t, index) => {
    const {time, depths, below} = data.speed;
    const at = depths[index];
    const points = (values) => time.map((ms, i) => [ms, values[i]]);
    const known = (values) => points(values).filter((x) => x[1] !== null);
    const high = known(at.high), low = known(at.low);
    const every = Math.max(1, Math.round(time.length / (narrow() ? 14 : 30)));
    const arrows = time.map((ms, i) => [ms, 0, at.towards[i]]).filter((x, i) => x[2] !== null && i % every === Math.floor(every / 2));
    const top = Math.max(below * 1.2, ...high.map((x) => x[1]));
    return {
      animation: false,
      grid: {left: narrow() ? 52 : 70, right: narrow() ? 10 : 20, top: 34, bottom: 36},
      tooltip: {trigger: 'axis', axisPointer: {type: 'line'}, formatter: (items) => {
        const i = items[0].dataIndex;
        if (at.likely[i] === null) return `${stamp(time[i])}<br>no value`;
        return `${stamp(time[i])}<br><b>${fixed(at.likely[i], 2)} m/s</b> (${fixed(at.low[i], 2)} to ${fixed(at.high[i], 2)})<br>flowing to ${String(Math.round(at.towards[i]) % 360).padStart(3, '0')}°`;
      }},
      xAxis: timeAxis(t, time),
      yAxis: valueAxis(t, 'speed (m/s)', {min: 0, max: Math.ceil(top * 10) / 10, nameGap: narrow() ? 34 : 46}),
      series: [
        {type: 'custom', silent: true, clip: true, z: 1, data: [[time[0], 0]], tooltip: {show: false},
          renderItem: (_, api) => ({type: 'polygon', silent: true, shape: {points: high.concat(low.slice().reverse()).map((x) => api.coord(x))}, style: {fill: t.first, opacity: 0.25}})},
        {type: 'line', name: 'likely', data: points(at.likely), showSymbol: false, z: 3, lineStyle: {color: t.first, width: 2.4}, itemStyle: {color: t.first},
          markLine: issuedLine(t, time, 'insideEndBottom'),
          markArea: {silent: true, itemStyle: {color: t.good, opacity: 0.18}, data: at.slack.map(([from, to]) => [{xAxis: from}, {xAxis: to}])}},
        {type: 'line', silent: true, data: [[time[0], below], [time[time.length - 1], below]], showSymbol: false, tooltip: {show: false}, z: 2, lineStyle: {color: t.quiet, type: 'dashed', width: 1.2}},
        {type: 'custom', silent: true, clip: false, z: 5, tooltip: {show: false}, encode: {x: 0, y: 1}, data: arrows,
          renderItem: (params, api) => arrow(api.coord([api.value(0), 0])[0], params.coordSys.y - 14, 17, api.value(2), t.quiet, 1.5)},
      ],
    };
  };

  /** The slack table of the depth that is chosen; its cells come from the program as they stand. */
  const showSlack = (index) => {
    const at = data.speed.depths[index];
    const box = document.getElementById('slack');
    box.querySelector('h2').textContent = at.title;
    box.querySelector('tbody').replaceChildren(...at.rows.map((row) => {
      const line = document.createElement('tr');
      line.replaceChildren(...row.map((text) => { const cell = document.createElement('td'); cell.textContent = text; return cell; }));
      return line;
    }));
  };

  const profileOption = (t) => {
    const p = data.profile;
    const n = p.depth.length;
    const deepest = Math.max(p.bed, p.depth[n - 1]);
    const timeEdges = edges(p.time, p.time[0], p.time[p.time.length - 1]);
    const depthEdges = edges(p.depth, 0, deepest);
    const cells = [];
    let top = 0;
    p.time.forEach((ms, i) => p.depth.forEach((d, k) => {
      const u = p.current.east[i * n + k], v = p.current.north[i * n + k];
      if (u === null || v === null) return;
      const speed = Math.hypot(u, v);
      top = Math.max(top, speed);
      cells.push([ms, d, speed, u, v, i, k]);
    }));
    const nice = Math.max(0.1, Math.ceil(top * 10) / 10);
    const everyTime = Math.max(1, Math.round(p.time.length / (narrow() ? 12 : 26)));
    const wanted = Math.min(n, 8);
    const rows = new Set(Array.from({length: wanted}, (_, j) => {
      const target = (j + 0.5) / wanted * deepest;
      return p.depth.reduce((best, d, k) => (Math.abs(d - target) < Math.abs(p.depth[best] - target) ? k : best), 0);
    }));
    return {
      animation: false,
      grid: {left: narrow() ? 52 : 70, right: narrow() ? 10 : 110, top: narrow() ? 52 : 18, bottom: 36},
      tooltip: {trigger: 'item', formatter: (item) => {
        const [ms, d, speed, u, v, i, k] = item.value;
        const sigma = p.sigma.length ? ` ± ${fixed(p.sigma[i * n + k], 2)} per component` : '';
        return `${stamp(ms)}<br>${d} m below mean sea level<br><b>${speed.toFixed(2)} m/s to ${bearingText(u, v)}</b><br>east ${u.toFixed(2)}, north ${v.toFixed(2)} m/s${sigma}`;
      }},
      xAxis: timeAxis(t, p.time),
      yAxis: valueAxis(t, 'depth (m)', {inverse: true, min: 0, max: deepest * 1.06, splitLine: {show: false}, axisLabel: {color: t.quiet, showMaxLabel: false}}),
      visualMap: {type: 'continuous', min: 0, max: nice, dimension: 2, seriesIndex: 0, calculable: false, itemWidth: 16,
        ...(narrow() ? {orient: 'horizontal', left: 'center', top: 4, itemHeight: 150} : {right: 8, top: 'middle', itemHeight: 240}),
        text: [`${nice.toFixed(1)} m/s`, '0 m/s'], textStyle: {color: t.ink}, inRange: {color: t.ramp}},
      series: [
        {type: 'custom', data: cells, dimensions: ['time', 'depth', 'speed', 'u', 'v', 'i', 'k'], encode: {x: 0, y: 1}, clip: true, progressive: 0,
          renderItem: (_, api) => {
            const i = api.value(5), k = api.value(6);
            const a = api.coord([timeEdges[i][0], depthEdges[k][0]]);
            const b = api.coord([timeEdges[i][1], depthEdges[k][1]]);
            return {type: 'rect', shape: {x: a[0], y: a[1], width: b[0] - a[0] + 0.6, height: b[1] - a[1] + 0.6}, style: {fill: api.visual('color')}};
          },
          markLine: issuedLine(t, p.time, 'insideStartTop', {shadowColor: t.paper, shadowBlur: 3})},
        {type: 'custom', silent: true, tooltip: {show: false}, dimensions: ['time', 'depth', 'speed', 'u', 'v', 'i', 'k'], encode: {x: 0, y: 1}, progressive: 0,
          data: cells.filter((c) => rows.has(c[6]) && c[5] % everyTime === Math.floor(everyTime / 2)),
          renderItem: (_, api) => {
            const [x, y] = api.coord([api.value(0), api.value(1)]);
            const speed = api.value(2);
            return arrow(x, y, 6 + 20 * speed / nice, bearing(api.value(3), api.value(4)), onRamp(t, speed / nice), 1.5);
          }},
        {type: 'line', silent: true, data: [], markArea: {silent: true, itemStyle: {color: t.bed},
          label: {show: true, position: 'inside', color: t.ink, fontSize: 11}, data: [[{yAxis: deepest, name: `bed, ${p.bed} m`}, {yAxis: deepest * 1.06}]]}},
      ],
    };
  };

  const hodographOption = (t, relative, index) => {
    const p = data.profile;
    const n = p.depth.length;
    const line = (vectors, mean) => p.depth.map((d, k) => {
      const u = vectors.east[index * n + k], v = vectors.north[index * n + k];
      if (u === null || v === null) return null;
      return relative ? [u - mean.east[index], v - mean.north[index], d] : [u, v, d];
    }).filter((x) => x !== null);
    const forecast = line(p.current, p.mean);
    const truth = p.truth ? line(p.truth, p.truthMean) : [];
    const all = forecast.concat(truth, [[0, 0]]);
    const span = (j) => [Math.min(...all.map((x) => x[j])), Math.max(...all.map((x) => x[j]))];
    const [e, f] = [span(0), span(1)];
    // Both axes have one scale: directions on the page are directions on the chart.
    const steps = [0.02, 0.05, 0.1, 0.2, 0.25, 0.5, 1];
    const wide = 1.16 * Math.max(e[1] - e[0], f[1] - f[0], 0.05);
    const step = steps.find((s) => wide / s <= 6) || 2;
    const half = Math.ceil(wide / 2 / step) * step;
    const centre = (s) => Math.round((s[0] + s[1]) / 2 / step) * step;
    const around = (s) => ({min: +(centre(s) - half).toFixed(3), max: +(centre(s) + half).toFixed(3), interval: step});
    const every = Math.max(1, Math.round(forecast.length / 6));
    const axis = (name, s) => valueAxis(t, name, {...around(s), nameGap: 38, axisLabel: {color: t.quiet, formatter: (x) => (+x.toFixed(2)).toString()},
      axisLine: {show: true, onZero: true, lineStyle: {color: t.quiet}}, axisTick: {show: false}});
    return {
      animation: false,
      title: {text: relative ? 'Minus the mean over depth' : 'Whole current', left: 'center', textStyle: {color: t.ink, fontSize: 14}},
      grid: {left: 72, right: 42, top: 62, bottom: 52},  // as wide as high in a square chart
      legend: truth.length ? {top: 28, left: 'center', data: ['forecast', 'truth'], textStyle: {color: t.ink}, itemWidth: 22} : undefined,
      tooltip: {trigger: 'item', formatter: (item) => (item.value.length < 3 ? '' :
        `${item.seriesName}, ${item.value[2]} m<br>east ${item.value[0].toFixed(3)}, north ${item.value[1].toFixed(3)} m/s<br>${Math.hypot(item.value[0], item.value[1]).toFixed(3)} m/s to ${bearingText(item.value[0], item.value[1])}`)},
      xAxis: axis('east (m/s)', e),
      yAxis: {...axis('north (m/s)', f), nameGap: 44},
      visualMap: {show: false, dimension: 2, seriesIndex: 0, min: 0, max: Math.max(p.bed, 1), inRange: {color: t.ramp}},
      series: [
        {name: 'forecast', type: 'scatter', data: forecast, symbolSize: 10, z: 4, itemStyle: {borderColor: t.ink, borderWidth: 1, color: t.first},
          label: {show: true, position: 'right', color: t.ink, fontSize: 11, textBorderColor: t.paper, textBorderWidth: 3, formatter: (item) => (item.dataIndex % every === 0 || item.dataIndex === forecast.length - 1 ? `${item.value[2]} m` : '')},
          labelLayout: {hideOverlap: true}},
        {name: 'forecast line', type: 'line', data: forecast.map((x) => [x[0], x[1]]), showSymbol: false, lineStyle: {color: t.first, width: 2}, silent: true, z: 3},
        ...(truth.length ? [{name: 'truth', type: 'line', data: truth, symbol: 'circle', symbolSize: 6, itemStyle: {color: t.paper, borderColor: t.truth, borderWidth: 1.2}, lineStyle: {color: t.truth, type: 'dashed', width: 1.5}, z: 2}] : []),
        ...(relative || !forecast.length ? [] : [{type: 'line', silent: true, showSymbol: false, data: [[0, 0], [forecast[0][0], forecast[0][1]]], lineStyle: {color: t.quiet, width: 1.2}, z: 1}]),
      ],
    };
  };

  const skillOption = (t) => {
    const leads = [...new Set(data.skill.map((r) => r.lead))];
    const methods = [...new Set(data.skill.map((r) => r.method))];
    const row = (method, lead) => data.skill.find((r) => r.method === method && r.lead === lead);
    return {
      animation: false,
      grid: {left: 70, right: 20, top: 56, bottom: 44},
      legend: {type: 'scroll', top: 0, left: 60, right: 10, textStyle: {color: t.ink}},
      tooltip: {trigger: 'item'},
      aria: {enabled: true, label: {enabled: false}, decal: {show: true}},
      xAxis: {type: 'category', data: leads, name: 'lead', nameLocation: 'middle', nameGap: 28, nameTextStyle: {color: t.ink}, axisLabel: {color: t.ink}, axisLine: {lineStyle: {color: t.rule}}, axisTick: {show: false}},
      yAxis: valueAxis(t, 'vector RMSE (m/s), lower is better', {min: 0}),
      series: methods.map((method, j) => ({
        name: method, type: 'bar', itemStyle: {color: t.of(j)}, barMaxWidth: 44, barGap: '12%',
        data: leads.map((lead) => { const r = row(method, lead); return r ? r.rmse : null; }),
        tooltip: {formatter: (x) => {
          const r = row(method, leads[x.dataIndex]);
          const interval = r.low === undefined ? '' : `<br>95 % interval ${fixed(r.low, 3)} to ${fixed(r.high, 3)} m/s`;
          return `${echarts.format.encodeHTML(method)}, ${echarts.format.encodeHTML(r.lead)}<br><b>${r.rmse.toFixed(3)} m/s</b>${interval}`;
        }},
      })).concat([{
        type: 'custom', silent: true, tooltip: {show: false}, z: 10,
        data: data.skill.filter((r) => r.rmse !== null)
          .map((r) => [leads.indexOf(r.lead), r.low ?? r.rmse, r.high ?? r.rmse, methods.indexOf(r.method), r.rmse]),
        encode: {x: 0, y: [1, 2]},
        renderItem: (_, api) => {
          const layout = api.barLayout({count: methods.length, barMaxWidth: 44, barGap: '12%'})[api.value(3)];
          const low = api.coord([api.value(0), api.value(1)]), high = api.coord([api.value(0), api.value(2)]);
          const x = low[0] + layout.offsetCenter;
          const bar = (x1, y1, x2, y2) => ({type: 'line', shape: {x1, y1, x2, y2}, style: {stroke: t.ink, lineWidth: 1.5}});
          const whisker = api.value(2) > api.value(1) ? [bar(x, low[1], x, high[1]), bar(x - 4, low[1], x + 4, low[1]), bar(x - 4, high[1], x + 4, high[1])] : [];
          const text = {type: 'text', x, y: high[1] - 4, style: {text: api.value(4).toFixed(3), fill: t.ink, font: '11px sans-serif', align: 'center', verticalAlign: 'bottom'}};
          return {type: 'group', children: layout.width >= 30 ? [...whisker, text] : whisker};
        },
      }]),
    };
  };

  const panelHeight = 170, panelGap = 78;
  const seriesOption = (t) => {
    const {time, panels} = data.series;
    const option = {
      animation: false, title: [], grid: [], xAxis: [], yAxis: [], series: [],
      tooltip: {trigger: 'axis', axisPointer: {type: 'line'}, formatter: (items) => {
        const i = items[0].dataIndex;
        const lines = panels.map((panel) => panel.lines.map((line) => {
          const band = line.low.length && line.low[i] !== null ? ` (${fixed(line.low[i], 2)} to ${fixed(line.high[i], 2)})` : '';
          return `${echarts.format.encodeHTML(panel.title)}, ${echarts.format.encodeHTML(line.name)}: <b>${fixed(line.values[i], 2)}</b>${band}`;
        }).join('<br>'));
        return `${stamp(time[i])}<br>${lines.join('<br>')}`;
      }},
      axisPointer: {link: [{xAxisIndex: 'all'}]},
    };
    panels.forEach((panel, j) => {
      const top = 50 + j * (panelHeight + panelGap);
      option.title.push({text: panel.title, left: 66, top: top - 46, textStyle: {color: t.ink, fontSize: 14}});
      option.grid.push({left: narrow() ? 52 : 70, right: narrow() ? 10 : 20, top, height: panelHeight});
      option.xAxis.push(timeAxis(t, time, {gridIndex: j}));
      // From 0 up, but for what goes below it: the level of the sea.
      const lowest = Math.min(0, ...panel.lines.flatMap((line) => [...line.values, ...line.low]).filter((v) => v !== null));
      option.yAxis.push(valueAxis(t, panel.axis, {gridIndex: j, min: Math.floor(lowest), nameGap: narrow() ? 34 : 46}));
      const on = {xAxisIndex: j, yAxisIndex: j};
      panel.lines.forEach((line, l) => {
        const color = line.truth ? t.truth : t.of(l);
        if (line.low.length) {
          const at = (edge) => time.map((ms, i) => [ms, edge[i]]).filter((x) => x[1] !== null);
          const high = at(line.high), low = at(line.low);
          option.series.push({type: 'custom', ...on, silent: true, clip: true, z: 1, data: [[time[0], 0]], tooltip: {show: false},
            renderItem: (_, api) => ({type: 'polygon', silent: true, shape: {points: high.concat(low.slice().reverse()).map((x) => api.coord(x))}, style: {fill: color, opacity: 0.22}})});
          // Invisible points hold the axis open for the band.
          option.series.push({type: 'line', ...on, silent: true, data: high, showSymbol: false, lineStyle: {opacity: 0}, tooltip: {show: false}});
        }
        option.series.push({type: 'line', ...on, name: line.name, data: time.map((ms, i) => [ms, line.values[i]]), showSymbol: false, z: line.truth ? 4 : 3,
          lineStyle: {color, width: line.truth ? 1.6 : 2.4, type: line.truth ? 'dashed' : dashOf(l)}, itemStyle: {color},
          endLabel: {show: false}, markLine: l === 0 ? issuedLine(t, time) : undefined});
      });
      if (panel.towards.length) {
        const every = Math.max(1, Math.round(time.length / (narrow() ? 14 : 30)));
        // The second number only says where the arrow stands; the third is its bearing.
        option.series.push({type: 'custom', ...on, silent: true, clip: false, z: 5, tooltip: {show: false}, encode: {x: 0, y: 1},
          data: time.map((ms, i) => [ms, 0, panel.towards[i]]).filter((x, i) => x[2] !== null && i % every === 0),
          renderItem: (params, api) => arrow(api.coord([api.value(0), 0])[0], params.coordSys.y - 12, 17, api.value(2), t.quiet, 1.5)});
      }
    });
    return option;
  };

  if (data.series) document.getElementById('series').style.height = `${data.series.panels.length * (panelHeight + panelGap) + 10}px`;
  if (data.speed) {
    const chart = chartOf('speed');
    const choice = document.getElementById('speed-depth');
    choice.value = String(data.speed.first);
    drawn.push(() => chart.draw(speedOption(theme(), Number(choice.value))));
    choice.addEventListener('change', () => {
      chart.draw(speedOption(theme(), Number(choice.value)));
      showSlack(Number(choice.value));
    });
  }
  if (data.profile) {
    const chart = chartOf('profile');
    drawn.push(() => chart.draw(profileOption(theme())));
    const slider = document.getElementById('hodograph-time');
    const label = document.getElementById('hodograph-label');
    slider.max = data.profile.time.length - 1;
    slider.value = data.profile.first;
    const whole = chartOf('hodograph'), spiral = chartOf('spiral');
    const draw = () => {
      const index = Number(slider.value);
      label.textContent = stamp(data.profile.time[index]);
      whole.draw(hodographOption(theme(), false, index));
      spiral.draw(hodographOption(theme(), true, index));
    };
    slider.addEventListener('input', draw);
    drawn.push(draw);
  }
  if (data.skill) { const chart = chartOf('skill'); drawn.push(() => chart.draw(skillOption(theme()))); }
  if (data.series) { const chart = chartOf('series'); drawn.push(() => chart.draw(seriesOption(theme()))); }

  start();
})();
